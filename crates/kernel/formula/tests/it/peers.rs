//! Filter constants beside those that two generators derive for the same formulas.
//!
//! FPG (Meyer and Pion 2008) and the converter of Attene (2020) bound a value and its error together, if coordinates
//! are at most 1 in magnitude: a difference of two coordinates is at most 1 and is off by u; a sum adds bounds and
//! errors, and half a unit in the last place of the bound; a product multiplies bounds, multiplies each error with the
//! other bound, and adds half a unit as well. The filter compares the estimate with the error times powers of the
//! largest differences. Our static bound is for the same largest magnitude.

// The constants are printed for docs/FORMULAS.md.
#![allow(clippy::print_stdout)]

use predicament_formula::{CATALOGUE, Entry, Op};

use crate::common::{HAND_MADE, formula};

const U: f64 = f64::EPSILON / 2.0;

/// Half a unit in the last place of a bound.
fn half_unit(bound: f64) -> f64 {
    let power = f64::from_bits(bound.to_bits() >> 52 << 52);
    power * U
}

/// The error of a program by the rule of the two generators, in units of u.
fn by_rule(text: &str, dimension: usize) -> f64 {
    let formula = formula(text, dimension);
    let ops = formula.program().ops();
    let is_coordinate = |at: usize| matches!(ops[at], Op::Coordinate { .. });
    let mut values: Vec<[f64; 2]> = Vec::new();
    for &op in ops {
        values.push(match op {
            Op::Coordinate { .. } => [1.0, 0.0],
            Op::Constant(number) => [number.abs(), 0.0],
            Op::Neg(a) => values[a],
            Op::Sub(a, b) if is_coordinate(a) && is_coordinate(b) => [1.0, U],
            Op::Add(a, b) | Op::Sub(a, b) => {
                let bound = values[a][0] + values[b][0];
                [bound, values[a][1] + values[b][1] + half_unit(bound)]
            }
            Op::Mul(a, b) => {
                let ([x, e], [y, f]) = (values[a], values[b]);
                [x * y, e * f + e * y + f * x + half_unit(x * y)]
            }
        });
    }
    values.last().map_or(0.0, |[_, error]| error / U)
}

/// Our static bound for differences and weights up to 1, in units of u.
fn ours(text: &str, dimension: usize) -> f64 {
    let formula = formula(text, dimension);
    let ones = vec![1.0; formula.coordinates()];
    formula.filter().static_bound(formula.program(), &ones, &ones) / U
}

/// The power test as CGAL writes it: weights are added to the lift one after the other.
const POWER: &str =
    "det([a - d, sq(a - d) - a.w + d.w], [b - d, sq(b - d) - b.w + d.w], [c - d, sq(c - d) - c.w + d.w])";

#[test]
fn constants_stand_beside_those_of_two_generators() {
    let shipped: &Entry = CATALOGUE.iter().find(|entry| entry.name == "side_of_power_circle").unwrap();
    let [orient2d, orient3d, incircle, _] = HAND_MADE;
    let all = [
        (orient2d, [6.0, 8.0]),
        (orient3d, [42.0, 44.0]),
        (incircle, [120.0, 124.0]),
        (("side_of_power_circle", shipped.text, 2), [198.0, 174.0]),
        (("side_of_power_circle of CGAL", POWER, 2), [288.0, 236.0]),
    ];
    for ((name, text, dimension), constants) in all {
        let found = [ours(text, dimension), by_rule(text, dimension)];
        println!("{name}: ours {:.2} u, by the rule {:.2} u", found[0], found[1]);
        let is_near = found.iter().zip(constants).all(|(constant, known)| (constant - known).abs() < 0.1);
        assert!(is_near, "{name}: {found:?} for {constants:?}");
    }
    // As published: FPG's determinant of two rows, and Attene's orient2d and incircle.
    for (published, by_rule) in [
        (8.887_205_737_259_28e-16, by_rule(orient2d.1, 2)),
        (8.881_784_197_001_252e-16, by_rule(orient2d.1, 2)),
        (1.376_676_550_535_194e-14, by_rule(incircle.1, 2)),
    ] {
        let ratio = published / (by_rule * U);
        assert!((0.999..1.001).contains(&ratio), "{published}: {ratio}");
    }
}
