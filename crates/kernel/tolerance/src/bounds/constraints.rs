//! The constraints on the tolerances, for L = 1, and the ε from which they hold.

use predicament_error_calculus::Enclosure;
use rug::Rational;

use super::coefficient::{Defined, FIGURE_1, FIGURE_5, Tolerance, defined, named};
pub use super::constraint::{At, Constraint, Decision, Origin, Sides};
use super::decimal::Decimal;
use super::height;
use crate::circles::{LIFTED, Lifted};

/// All constraints of sections 4 and 5 in the paper's form, and ours.
#[must_use]
pub fn constraints() -> Vec<Constraint> {
    let mut all = plane();
    all.extend(space());
    all.extend(circles());
    all
}

fn room(section: &'static str, tolerance: &'static Tolerance, k: u32) -> Constraint {
    let t = tolerance.symbol;
    let power = ["", "L", "L²", "L³", "L⁴"][tolerance.length as usize];
    let text = format!("min({t}₊ − {t}, {t} − {t}₋) > {k}ε{power}");
    Constraint::greater(section, Origin::Paper, text, move |at| [at.room(tolerance), at.times(k)])
}

fn error_below(section: &'static str, tolerance: &'static Tolerance, of: &str, k: u32) -> Constraint {
    let power = ["", "L", "L²", "L³", "L⁴"][tolerance.length as usize];
    let text = format!("{}₋ > E[{of}] ≥ {k}ε{power}", tolerance.symbol);
    Constraint::greater(section, Origin::Paper, text, move |at| [at.lower(tolerance), at.times(k)])
}

fn definition(section: &'static str, symbol: &'static str) -> Constraint {
    let all = defined();
    let defined = all.iter().find(|row: &&Defined| row.section == section && row.symbol == symbol);
    let defined = defined.expect("a definition of the section");
    Constraint::same(section, format!("{symbol}₊ = {}", defined.formula), defined.is_exact() && defined.is_as_printed())
}

/// The constraints on σ, τ and σ̂ of 4.2 and 4.3, or 5.2 and 5.3.
fn lengths(
    figure: &'static [Tolerance],
    [vertices, edges]: [&'static str; 2],
    [m, a_bar, a_hat]: [u32; 3],
) -> Vec<Constraint> {
    let [sigma, tau, sigma_hat] = ["σ", "τ", "σ̂"].map(|symbol| named(figure, symbol));
    let greater = |section, text: &str, sides: Sides| Constraint::greater(section, Origin::Paper, text, sides);
    let weight = |name: &str, k: u32| {
        let text = format!("√(σ₋² − τ₊²) > E[{name}] = {k}εL");
        let sides = move |at: &At| [(at.lower(sigma).power(2) - at.upper(tau).power(2)).sqrt(), at.times(k)];
        greater(edges, &text, Box::new(sides))
    };
    vec![
        greater(
            vertices,
            "min(σ₊ − σ, σ − σ₋) > 8εσ",
            Box::new(move |at| [at.room(sigma), at.times(8) * at.width(sigma)]),
        ),
        error_below(edges, sigma_hat, "m", m),
        weight("ā", a_bar),
        weight("â", a_hat),
        greater(
            edges,
            "τ₊ < (√3/2) σ₋",
            Box::new(move |at| {
                let half_root3 = Enclosure::exact((3, 4).into()).sqrt();
                [half_root3 * at.lower(sigma), at.upper(tau)]
            }),
        ),
        Constraint::same(edges, "σ₋ = σ̂₊", sigma.lower.rational() == sigma_hat.upper.rational()),
    ]
}

fn plane() -> Vec<Constraint> {
    let [tau, sigma_hat, kappa] = ["τ", "σ̂", "κ"].map(|symbol| named(&FIGURE_1, symbol));
    let mut all = lengths(&FIGURE_1, ["4.2", "4.3"], [5, 26, 19]);
    all.extend([room("4.3", sigma_hat, 8), room("4.3", tau, 20)]);
    for (section, area) in [("4.4", "a_P"), ("4.5", "a_A")] {
        all.extend([definition(section, "κ"), error_below(section, kappa, area, 9), room(section, kappa, 10)]);
    }
    all
}

fn space() -> Vec<Constraint> {
    let figure = |symbol| named(&FIGURE_5, symbol);
    let (tau, sigma_hat) = (figure("τ"), figure("σ̂"));
    let mut all = lengths(&FIGURE_5, ["5.2", "5.3"], [7, 42, 31]);
    all.push(room("5.3", sigma_hat, 9));
    all.push(Constraint::greater("5.3", Origin::Paper, "min(τ₊ − τ, τ − τ₋) > 131εL²/τ", move |at| {
        [at.room(tau), at.times(131) * at.width(tau).reciprocal()]
    }));
    let squares = move |at: &At| at.times(261) + at.times(9) * at.width(tau).power(2);
    all.push(Constraint::greater("5.3", Origin::Ours, "τ² − τ₋² > 261εL² + 9ετ²", move |at| {
        [at.width(tau).power(2) - at.lower(tau).power(2), squares(at)]
    }));
    all.push(Constraint::greater("5.3", Origin::Ours, "τ₊² − τ² > 261εL² + 9ετ²", move |at| {
        [at.upper(tau).power(2) - at.width(tau).power(2), squares(at)]
    }));
    all.extend([definition("5.4", "λ"), definition("5.4", "φ")]);
    all.extend([room("5.4", figure("λ"), 130), room("5.4", figure("φ"), 130), room("5.4", figure("φ"), 282)]);
    all.extend(height::constraints());
    all.extend([definition("5.5", "ν"), definition("5.5", "ζ"), room("5.5", figure("ν"), 130)]);
    all.extend([("â", 446), ("b̂", 130), ("ĉ", 130)].map(|(weight, k)| {
        let room = room("5.5", figure("ζ"), k);
        Constraint { text: format!("{} (for {weight})", room.text), ..room }
    }));
    all.extend([definition("5.6", "μ"), definition("5.6", "ξ")]);
    all.extend([error_below("5.6", figure("μ"), "v_A", 47), error_below("5.6", figure("ξ"), "v_P", 47)]);
    all.extend([room("5.6", figure("μ"), 48), room("5.6", figure("ξ"), 48)]);
    all.extend([definition("5.7", "ρ"), error_below("5.7", figure("ρ"), "v_A", 47), room("5.7", figure("ρ"), 48)]);
    all
}

/// The constraints on the bands of circles and spheres, over ε L^p.
fn circles() -> Vec<Constraint> {
    let of = |&Lifted { name, band, degree, error, rounding }: &Lifted| {
        let power = if degree == 4 { "⁴" } else { "⁵" };
        let [lower, width, upper] = band.map(|c| Rational::from_f64(c).expect("finite"));
        let room = Rational::from(&upper - &width).min(Rational::from(&width - &lower));
        let text = format!("{name}: min(T₊ − T, T − T₋) > {error}εL{power} + {rounding}εT");
        [
            Constraint::greater("ours", Origin::Ours, text, move |at| {
                [at.times(room.clone()), at.times(error) + at.times(rounding) * at.times(width.clone())]
            }),
            Constraint::greater("ours", Origin::Ours, format!("{name}: T₋ > E = {error}εL{power}"), move |at| {
                [at.times(lower.clone()), at.times(error)]
            }),
        ]
    };
    LIFTED.iter().flat_map(of).collect()
}

/// The values of ε at which the paper's claims are decided.
///
/// They are the unit roundoff and machine epsilon of f64 and f32, and the largest ε that the paper admits.
#[must_use]
pub fn epsilons() -> [(&'static str, Rational); 5] {
    let power = |e: u32| Rational::from(1) >> e;
    [
        ("2^-53", power(53)),
        ("2^-52", power(52)),
        ("2^-24", power(24)),
        ("2^-23", power(23)),
        ("10^-5", Rational::from((1, 100_000))),
    ]
}

/// The largest ε of three decimal digits at which a constraint holds, with its successor.
///
/// All larger values that were tried up to 10⁻⁵ fail. Bisection finds the limit, so it is between the two values only
/// if the constraint fails from one ε on. `None` if the constraint holds at 10⁻⁵ or at no value down to 10⁻²⁰.
#[must_use]
pub fn validity_limit(constraint: &Constraint) -> Option<[Decimal; 2]> {
    // 1.00e-20 is 0 and 1.00e-5 is 900 · 15
    let at = |k: u32| Decimal::new(100 + k % 900, 20 - k / 900);
    let holds = |k: u32| constraint.decide(&At::new(at(k).value())) == Decision::Holds;
    let (mut low, mut high) = (0, 900 * 15);
    if holds(high) || !holds(low) {
        return None;
    }
    while high - low > 1 {
        let middle = low.midpoint(high);
        if holds(middle) { low = middle } else { high = middle }
    }
    Some([at(low), at(high)])
}
