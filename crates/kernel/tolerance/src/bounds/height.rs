//! Section 5.4.4: the comparison of d̂² with γ²m², which is not a constant.
//!
//! Known are E\[m²\] ≤ 129ε L⁴, E\[d̂\] ≤ 47ε L³, R\[γ²\] < 10ε, and m² > λ₋ from the test before. All links of the
//! displayed chain are here, at any ε. The chain uses m² > λ₊ (m > 4(τ₋² − γ₊²)), which that test does not give; with
//! m² > λ₋ it ends earlier. The claim itself needs no chain:
//!
//! * d̂² ≤ γ²m² as computed gives (|d̂| − 47ε)²(1 − ε) ≤ γ²(1 + 10ε)(m² + 129ε)(1 + ε), and the goal is |d̂| ≤ γ₊m;
//! * otherwise (|d̂| + 47ε)²(1 + ε) > γ²(1 − 10ε)(m² − 129ε)(1 − ε), and the goal is |d̂| > γ₋m.
//!
//! Both differences grow with m, as γ₊ exceeds γ times the first root's factor and γ times the second's exceeds γ₋, so
//! the least m² decides. The section says the same of δ, whose three numbers are γ's, and of ν, which is larger.

use predicament_error_calculus::Enclosure;
use rug::Rational;

use super::coefficient::{FIGURE_5, named};
use super::constraint::{At, Constraint, Origin, Sides};

const E_M_SQUARED: u32 = 129;
const E_D_HAT: u32 = 47;
const R_GAMMA_SQUARED: i32 = 10;

fn number(n: impl Into<Rational>) -> Enclosure {
    Enclosure::exact(n.into())
}

/// The number 1 + kε.
fn one_plus(at: &At, k: i32) -> Enclosure {
    number(1) + at.times(k)
}

/// The inequality g(2γ²m²/35) < 0 for m² ≥ c εL⁴.
///
/// It is (2/35 − 6ε/5) G² > 94√(6/5) ε^¼ (1 + ε) G + 47² √ε (1 + ε), with G = γm over ε^¾. It then holds for every
/// larger G, as the left side minus the right is a parabola that opens upward and is negative at zero.
fn chain(at: &At, c: &Rational) -> [Enclosure; 2] {
    let g = number(named(&FIGURE_5, "γ").width.rational()) * number(c.clone()).sqrt();
    let slope = number((2, 35)) - at.times((6, 5));
    let linear = number(2 * E_D_HAT) * number((6, 5)).sqrt() * at.fourth.clone() * one_plus(at, 1);
    let constant = number(E_D_HAT).power(2) * at.fourth.power(2) * one_plus(at, 1);
    [slope * g.clone() * g.clone(), linear * g + constant]
}

/// The links of the chain, the last line, and the direct check.
pub(super) fn constraints() -> Vec<Constraint> {
    let [gamma, lambda] = ["γ", "λ"].map(|symbol| named(&FIGURE_5, symbol));
    let c = |coefficient: super::coefficient::Coefficient| coefficient.rational();
    let [minus, middle, plus] = [gamma.lower, gamma.width, gamma.upper].map(c);
    let (least, assumed) = (c(lambda.lower), c(lambda.upper));
    let share = Rational::from((E_M_SQUARED, 1)) / &least;
    let step = |text: &str, sides: Sides| Constraint::greater("5.4.4", Origin::Argument, text, sides);
    // 351/4, the value of γm over ε^¾ that m² > λ₊ gives
    let assumed_height = Rational::from((351, 4));
    let squares = [&minus, &middle, &plus].map(|x| number(Rational::from(x.square_ref())));
    let [minus_squared, middle_squared, plus_squared] = squares;
    let (for_upper, for_lower) = (middle_squared.clone(), middle_squared);
    let (known, direct_least) = (least.clone(), least);
    let direct = move |least: &Rational, at: &At, sign: i32| {
        // γ√((1 ± 10ε)(1 ± ε)/(1 ∓ ε) (λ₋ ± 129)) and 47ε^¼, over ε^¾
        let factor = one_plus(at, sign * R_GAMMA_SQUARED) * one_plus(at, sign) * one_plus(at, -sign).reciprocal();
        let m_squared = number(least + Rational::from(sign) * E_M_SQUARED);
        let height = number(middle.clone()) * (factor * m_squared).sqrt();
        [height, number(E_D_HAT) * at.fourth.clone(), number(least.clone()).sqrt()]
    };
    let (least_above, least_below) = (direct_least.clone(), direct_least);
    let direct_below = direct.clone();
    vec![
        step(
            "1/7 > (1 + 12ε) R[m²] + 12ε, R[m²] < 129/910",
            Box::new(move |at| [number((1, 7)), one_plus(at, 12) * number(share.clone()) + at.times(12)]),
        ),
        step(
            "−5 ≥ (351/4)(6ε/5 − 2/35) + 94√(6/5) ε^¼ (1 + ε), displayed",
            Box::new(move |at| {
                let root = number(2 * E_D_HAT) * number((6, 5)).sqrt() * at.fourth.clone() * one_plus(at, 1);
                let slope = number((2, 35)) - at.times((6, 5));
                [number(assumed_height.clone()) * slope, number(5) + root]
            }),
        ),
        step(
            "−400 ≥ −1755/4 + 47²√ε (1 + ε), displayed",
            Box::new(|at| {
                [number((1755, 4)), number(400) + number(E_D_HAT).power(2) * at.fourth.power(2) * one_plus(at, 1)]
            }),
        ),
        step("g(2γ²m²/35) < 0 where m² > λ₊, displayed", Box::new(move |at| chain(at, &assumed))),
        Constraint::greater("5.4.4", Origin::Ours, "g(2γ²m²/35) < 0 where m² > λ₋, which is known", move |at| {
            chain(at, &known)
        }),
        step(
            "g′ < −0.9",
            Box::new(|at| [number((1, 10)), at.times(1) + number((188, 351)) * at.fourth.clone() * one_plus(at, 1)]),
        ),
        step("γ₊² > (6/5) γ²", Box::new(move |_| [plus_squared.clone(), number((6, 5)) * for_upper.clone()])),
        step("(4/5) γ² > γ₋²", Box::new(move |_| [number((4, 5)) * for_lower.clone(), minus_squared.clone()])),
        Constraint::greater("5.4.4", Origin::Ours, "direct: what passes has d̂² ≤ γ₊²m²", move |at| {
            let [height, error, m] = direct(&least_above, at, 1);
            [number(plus.clone()) * m, height + error]
        }),
        Constraint::greater("5.4.4", Origin::Ours, "direct: what does not pass has d̂² > γ₋²m²", move |at| {
            let [height, error, m] = direct_below(&least_below, at, -1);
            [height - error, number(minus.clone()) * m]
        }),
    ]
}
