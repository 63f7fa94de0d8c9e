//! Tests that the right rule applies, and that whole formulas keep the promise of their bounds.

use predicament_error_calculus::rules::{Error, largest_epsilon};
use predicament_error_calculus::{Adversary, Field, Perturbed, Quantity, Ring, Root};
use proptest::prelude::*;
use rug::Rational;

fn error(a: i32, b: i32) -> Error {
    Error { a: a.into(), b: b.into() }
}

fn coordinates() -> [Quantity; 4] {
    ["x", "y", "z", "w"].map(Quantity::coordinate)
}

fn c(q: &Quantity) -> Rational {
    q.magnitude().expect("valid").c.clone()
}

#[test]
fn constants_and_coordinates_are_exact() {
    let [x, ..] = coordinates();
    assert_eq!((x.is_valid(), x.is_relative(), x.is_nonnegative(), x.error()), (true, true, false, Some(&error(0, 0))));
    assert_eq!((c(&x), x.magnitude().unwrap().p()), ((1, 2).into(), 1.into()));
    let [minus, plus] = [-3, 3].map(Quantity::constant);
    assert_eq!((minus.is_nonnegative(), plus.is_nonnegative()), (false, true));
    assert_eq!((c(&minus), minus.magnitude().unwrap().p()), (3.into(), 0.into()));
    assert_eq!(x.expression(), "x");
}

#[test]
fn the_more_restricted_rule_is_used() {
    let [x, y, z, w] = coordinates();
    // E, and D for what is not exact
    let u = x - y;
    assert_eq!((u.error(), u.is_relative(), c(&u)), (Some(&error(1, 0)), true, 1.into()));
    let v = u.clone() - (z.clone() - w.clone());
    assert_eq!((v.error(), v.is_relative(), c(&v)), (Some(&error(2, 2)), false, 2.into()));
    let half = u.clone() - z.clone();
    assert_eq!((half.is_relative(), c(&half)), (false, (3, 2).into()));
    assert_eq!(half.error().unwrap().a, Rational::from((5, 3)), "1 + (1·1 + ½·0)/(3/2)");
    // C for squares, B for products that may be negative
    let square = u.clone() * u.clone();
    assert!(square.is_nonnegative() && square.is_relative());
    assert_eq!(square.error(), Some(&error(3, 4)));
    let squares = square.clone() + square.clone();
    assert_eq!((squares.error(), squares.is_relative()), (Some(&error(4, 8)), true));
    let product = u.clone() * (z - w);
    assert!(!product.is_nonnegative() && product.is_relative());
    let products = product.clone() + square.clone();
    assert_eq!((products.is_relative(), products.is_nonnegative()), (false, false));
    // n without r is not enough for C
    let inexact = products.clone().abs();
    assert!(inexact.is_nonnegative() && !inexact.is_relative());
    for sum in [inexact.clone() + square.clone(), square.clone() + inexact.clone()] {
        assert!(sum.is_nonnegative() && !sum.is_relative());
    }
    // A and I
    assert_eq!(((-square.clone()).is_nonnegative(), (-square.clone()).error()), (false, square.error()));
    assert_eq!((product.clone().abs().is_nonnegative(), product.clone().abs().error()), (true, product.error()));
    // H
    let root = squares.clone().sqrt();
    assert_eq!((root.magnitude().unwrap().p(), root.error().unwrap().a.clone()), (1.into(), 3.into()));
    assert!(c(&root).square() >= 2 && c(&root) < Rational::from((14_143, 10_000)));
    // G
    let reciprocal = Quantity::one() / root.clone();
    assert_eq!((c(&reciprocal), reciprocal.magnitude().unwrap().p()), (1.into(), Rational::from(-1)));
    assert_eq!(reciprocal.error().unwrap().a, 4);
    assert_eq!(root.expression(), "√(((x - y) * (x - y)) + ((x - y) * (x - y)))");
}

#[test]
fn what_no_rule_fits_is_invalid_and_stays_so() {
    let [x, y, z, w] = coordinates();
    let u = x.clone() - y;
    let square = u.clone().square();
    let inexact = (u.clone() * (z - w) + square.clone()).abs();
    for invalid in [
        u.clone() + square.clone(),                       // L + L²
        u.clone() - square.clone(),                       // L − L²
        u.clone().sqrt(),                                 // may be negative
        inexact.clone().sqrt(),                           // not relative
        u.clone() / inexact.clone(),                      // not relative
        square.clone().sqrt().sqrt().abs().sqrt().sqrt(), // L^⅛
    ] {
        assert!(!invalid.is_valid(), "{}", invalid.expression());
        assert_eq!((invalid.absolute(), invalid.relative(), invalid.error()), (None, None, None));
        let none = invalid.clone();
        for more in [
            none.clone() + x.clone(),
            x.clone() - none.clone(),
            none.clone() * none.clone(),
            none.clone().abs(),
            -none.clone(),
            none.clone() / square.clone(),
            none.sqrt(),
        ] {
            assert!(!more.is_valid(), "{}", more.expression());
        }
    }
    assert!(inexact.absolute().is_some() && inexact.relative().is_none());
    let quarter = square.sqrt().sqrt().sqrt();
    assert_eq!(quarter.magnitude().unwrap().p(), Rational::from((1, 4)));
}

#[test]
fn bounds_are_rounded_up() {
    let [x, y, z, w] = coordinates();
    let u = x - y;
    assert_eq!(u.relative().unwrap().rounded_up(), 1);
    assert_eq!(u.clone().square().relative().unwrap().rounded_up(), 4, "3ε + 4ε² is more than 3ε");
    let d = (u.clone() * (z.clone() - w.clone()) - (z - w) * u).absolute().unwrap();
    assert_eq!((d.first.clone(), d.rounded_up()), (8.into(), 9.into()));
    assert_eq!(d.at(&largest_epsilon()), d.first * largest_epsilon() + d.second * largest_epsilon().square());
}

#[test]
fn a_lower_bound_makes_an_error_relative() {
    let one_minus = Quantity::one() - Quantity::constant(7) * Quantity::epsilon().sqrt();
    assert!(!one_minus.is_relative());
    let bound = one_minus.absolute().unwrap();
    // √ε and 7√ε contribute an error of 2 times 7√ε, which is at most 7 ε^½ at the largest ε; the rounding error is 1.
    let (half, root) = (Rational::from((1, 2)), largest_epsilon().to_f64().sqrt());
    let relative = one_minus.clone().at_least(&half).relative().unwrap();
    assert!((relative.first.to_f64() - (1.0 + 2.0 * 2.0 * 7.0 * root)).abs() < 1e-9, "{relative:?}");
    assert!(relative.first < bound.first * 2, "twice its own rounding is too much");
    // a product has no inherited error
    let product = one_minus.clone() * one_minus;
    let bound = product.absolute().unwrap();
    assert_eq!(product.at_least(&half).relative().unwrap().first, bound.first * 2);
}

#[test]
fn a_product_with_a_power_of_two_rounds_nothing() {
    let [x, y, ..] = coordinates();
    let u = x - y;
    let [quarter, minus_two, three] = [(1, 4), (-2, 1), (3, 1)].map(|c| Quantity::constant(Rational::from(c)));
    for power in [quarter.clone(), minus_two.clone(), Quantity::one(), Quantity::epsilon()] {
        assert_eq!((power.clone() * u.clone()).error(), u.error());
        assert_eq!((u.clone() * power.clone()).error(), u.error());
        assert_eq!((power * three.clone()).error(), Some(&error(0, 0)));
    }
    assert_eq!(c(&(minus_two.clone() * u.clone())), 2);
    let product = quarter * minus_two * Quantity::epsilon();
    assert_eq!((product * u.clone()).error(), u.error(), "a product of such is one");
    for other in [three, Quantity::length(), Quantity::epsilon().sqrt()] {
        assert!((other * u.clone()).error().unwrap().a >= 2);
    }
}

/// One step of a formula on the values so far, counted from the last.
#[derive(Clone, Copy, Debug)]
enum Step {
    Add(usize, usize),
    Sub(usize, usize),
    Mul(usize, usize),
    Square(usize),
    Neg(usize),
    Abs(usize),
    Sqrt(usize),
    /// x · (1/√(x² + y²)): the paper's use of division.
    Unit(usize, usize),
}

fn steps() -> impl Strategy<Value = Step> {
    let at = 0..6_usize;
    let two = (at.clone(), at.clone());
    prop_oneof![
        3 => two.clone().prop_map(|(i, j)| Step::Add(i, j)),
        4 => two.clone().prop_map(|(i, j)| Step::Sub(i, j)),
        3 => two.clone().prop_map(|(i, j)| Step::Mul(i, j)),
        2 => at.clone().prop_map(Step::Square),
        1 => at.clone().prop_map(Step::Neg),
        1 => at.clone().prop_map(Step::Abs),
        1 => at.prop_map(Step::Sqrt),
        1 => two.prop_map(|(i, j)| Step::Unit(i, j)),
    ]
}

fn apply<N: Root>(step: Step, values: &[N]) -> N {
    let value = |at: usize| values[values.len() - 1 - at % values.len()].clone();
    match step {
        Step::Add(i, j) => value(i) + value(j),
        Step::Sub(i, j) => value(i) - value(j),
        Step::Mul(i, j) => value(i) * value(j),
        Step::Square(i) => value(i).square(),
        Step::Neg(i) => -value(i),
        Step::Abs(i) => value(i).abs(),
        Step::Sqrt(i) => value(i).sqrt(),
        Step::Unit(i, j) => {
            let m = (value(i).square() + value(j).square()).sqrt();
            value(i) * (N::one() / m)
        }
    }
}

/// Returns true if the step neither divides by zero nor takes the root of a value that is negative beyond roundoff.
fn is_defined(step: Step, values: &[Perturbed]) -> bool {
    let value = |at: usize| &values[values.len() - 1 - at % values.len()];
    match step {
        Step::Sqrt(i) => value(i).exact >= 0 && value(i).computed >= 0,
        Step::Unit(i, j) => {
            (value(i).exact != 0 || value(j).exact != 0) && (value(i).computed != 0 || value(j).computed != 0)
        }
        _ => true,
    }
}

/// Random errors: ε, −ε, 0 or anything between.
fn adversary(seed: u64, epsilon: Rational) -> Adversary {
    let mut state = seed;
    Adversary::new(move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let k = [-4, -4, -4, 4, 4, 4, 0, 1][(state >> 61) as usize];
        Rational::from(&epsilon * k) / 4
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(4000)))]

    /// Coordinates up to ½ (L = 1), any formula, any errors up to ε.
    #[test]
    fn no_formula_errs_by_more_than_its_bound(
        coordinates in prop::array::uniform4(-64..=64_i32),
        steps in prop::collection::vec(steps(), 1..9),
        seed: u64,
        halvings in prop_oneof![Just(0_u32), 0_u32..40],
    ) {
        let epsilon = largest_epsilon() >> halvings;
        let adversary = adversary(seed, epsilon.clone());
        let mut values: Vec<Perturbed> = coordinates.iter().map(|&k| adversary.input((k, 128))).collect();
        let mut quantities: Vec<Quantity> = ["x", "y", "z", "w"].map(Quantity::coordinate).to_vec();
        // far beyond the error of the root of an exact value
        let tiny = Rational::from(1) >> 150_u32;
        for step in steps {
            // the c of rule G holds only for vectors of c ≥ 1
            if let Step::Unit(i, _) = step
                && c(&quantities[quantities.len() - 1 - i % quantities.len()]) < 1
            {
                continue;
            }
            let quantity = apply(step, &quantities);
            if !quantity.is_valid() || !is_defined(step, &values) {
                continue;
            }
            let value = apply(step, &values);
            let off = Rational::from(&value.computed - &value.exact).abs();
            let size = value.exact.clone().abs();
            let limit = c(&quantity);
            prop_assert!(size <= Rational::from(&limit + &tiny), "{} is {size}", quantity.expression());
            prop_assert!(!quantity.is_nonnegative() || value.exact >= 0, "{}", quantity.expression());
            let bound = match quantity.relative() {
                Some(bound) => bound.at(&epsilon) * size,
                None => quantity.absolute().expect("valid").at(&epsilon),
            };
            prop_assert!(off <= bound + &tiny, "{}: {quantity:?}", quantity.expression());
            quantities.push(quantity);
            values.push(value);
        }
    }
}
