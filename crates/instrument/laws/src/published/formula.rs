//! The band that a backend of tolerances may claim for a formula, computed here from the formula and the scene.
//!
//! A session's claim is not read: a backend that claims a wide band would be right about everything within it. The
//! rules are those of `docs/FORMULAS.md`, in code of this crate's own.
//!
//! * If the formula uses differences of coordinates only, the error calculus (Wang et al., section 2) bounds the error
//!   by c ε L^p. Errors are carried at one ε, the largest that the rules allow, so each is one rational.
//! * Otherwise the roundings k of the terms bound it by ((1 + u)^k − 1)·M, where M is the magnitude for the scene's
//!   extents, and a slack covers underflow.
//!
//! Both are about the formula's program, since another order of operations has another error.

use predicament_error_calculus::rules::{is_power_of_two, largest_epsilon};
use predicament_predicates::formula::{Op, Program};
use predicament_predicates::{Axis, Band, Derived, Scene};
use rug::Rational;
use rug::ops::Pow;

use super::extent;

/// The part by which a claimed upper limit of a magnitude's band may exceed three times the magnitude: the slack of
/// constants that doubles hold.
const LARGER: (u32, u32) = (1, 32);

/// The band of a formula for a scene, if a backend computes with ε = 2^−`halvings`.
pub(super) fn band(scene: &Scene, derived: Derived, halvings: u32) -> Band {
    let formula = derived.formula();
    let axes = &[Axis::X, Axis::Y, Axis::Z][..scene.dimension().count()];
    if let Some(factor) = units(derived) {
        let length = exact(extent(scene, axes));
        let unit = length.pow(formula.polynomial().degree()) >> halvings;
        let [lower, width, upper] = [1_u32, 2, 3].map(|step| Rational::from(&unit * &factor) * step).map(near);
        return Band { lower, width, upper };
    }
    let spread = |numbers: &[f64]| {
        let low = numbers.iter().copied().fold(f64::INFINITY, f64::min);
        let high = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        [exact(high) - exact(low), exact(low).abs().max(exact(high).abs())]
    };
    let along = |&axis: &Axis| scene.vertices().map(|v| scene.coordinate(axis, v)).collect::<Vec<f64>>();
    let mut sizes: Vec<[Rational; 2]> = axes.iter().map(|axis| spread(&along(axis))).collect();
    sizes.extend(formula.is_weighted().then(|| spread(scene.weights())));
    let (error, underflow) = magnitude_error(formula.program(), &sizes);
    let unit = error << 52 >> halvings;
    let width = Rational::from(&unit * 2_u32);
    let upper = (Rational::from(&unit * 3_u32) + underflow) * (Rational::from(LARGER) + 1_u32);
    Band { lower: near(unit), width: near(width), upper: near(upper) }
}

/// The units ε L^p in T₋, c + 1 for an error of at most c ε L^p; `None` if the calculus has no rule for the formula.
///
/// The number p is the degree of the formula.
#[must_use]
pub fn units(derived: Derived) -> Option<Rational> {
    let formula = derived.formula();
    let program = formula.program();
    if formula.is_weighted() || !formula.polynomial().is_homogeneous() || !has_differences_only(program) {
        return None;
    }
    let value = calculus(program)?;
    let bound = value.error * value.size / largest_epsilon();
    Some(bound.ceil() + 1_u32)
}

/// True if coordinates occur in differences of two coordinates of one axis only.
fn has_differences_only(program: &Program) -> bool {
    let ops = program.ops();
    let axis = |at: usize| if let Op::Coordinate { axis, .. } = ops[at] { Some(axis) } else { None };
    let is_alone = |op: &Op| match *op {
        Op::Sub(a, b) if axis(a).is_some() && axis(a) == axis(b) => false,
        op => op.operands().into_iter().flatten().any(|at| axis(at).is_some()),
    };
    axis(ops.len() - 1).is_none() && !ops.iter().any(is_alone)
}

/// A value of the error calculus: |x| ≤ c L^p, and its error at the largest ε.
#[derive(Clone)]
struct Value {
    size: Rational,
    power: u32,
    /// The error, relative to c L^p, or to |x| if `is_relative`.
    error: Rational,
    is_relative: bool,
    is_nonnegative: bool,
    is_power_of_two: bool,
}

/// The error of a value, after one more rounding.
fn rounded(error: Rational) -> Rational {
    (error + 1_u32) * (largest_epsilon() + 1_u32) - 1_u32
}

/// The last value of a program; `None` if it adds values of different degrees.
fn calculus(program: &Program) -> Option<Value> {
    let mut values: Vec<Value> = Vec::new();
    for &op in program.ops() {
        let leaf = |size: Rational, power: u32| Value {
            is_nonnegative: power == 0 && size >= 0,
            is_power_of_two: power == 0 && is_power_of_two(&size),
            size: size.abs(),
            power,
            error: Rational::new(),
            is_relative: true,
        };
        let value = match op {
            // Rules K and J.
            Op::Coordinate { .. } => leaf(Rational::from((1, 2)), 1),
            Op::Constant(number) => leaf(exact(number), 0),
            // Rule A.
            Op::Neg(a) => Value { is_nonnegative: false, ..values[a].clone() },
            Op::Add(a, b) | Op::Sub(a, b) => sum(&values[a], &values[b], matches!(op, Op::Sub(..)))?,
            // Rule F.
            Op::Mul(a, b) => {
                let [x, y] = [&values[a], &values[b]];
                let both = Rational::from(&x.error + 1_u32) * Rational::from(&y.error + 1_u32) - 1_u32;
                let is_exact = x.is_power_of_two || y.is_power_of_two;
                Value {
                    size: Rational::from(&x.size * &y.size),
                    power: x.power + y.power,
                    error: if is_exact { both } else { rounded(both) },
                    is_relative: x.is_relative && y.is_relative,
                    is_nonnegative: a == b || x.is_nonnegative && y.is_nonnegative,
                    is_power_of_two: x.is_power_of_two && y.is_power_of_two,
                }
            }
        };
        values.push(value);
    }
    values.pop()
}

/// A sum or difference by rules B to E.
fn sum(x: &Value, y: &Value, minus: bool) -> Option<Value> {
    if x.power != y.power {
        return None;
    }
    let size = Rational::from(&x.size + &y.size);
    let is_nonnegative = !minus && x.is_nonnegative && y.is_nonnegative;
    let is_exact = minus && x.error == 0 && y.error == 0;
    let is_relative = is_exact || is_nonnegative && x.is_relative && y.is_relative;
    let inherited = if is_relative || size == 0 {
        Rational::from((&x.error).max(&y.error))
    } else {
        (Rational::from(&x.error * &x.size) + Rational::from(&y.error * &y.size)) / &size
    };
    let error = rounded(inherited);
    Some(Value { size, power: x.power, error, is_relative, is_nonnegative, is_power_of_two: false })
}

/// The error of a program's value for the extent and the largest magnitude along each axis, and a bound of underflow.
fn magnitude_error(program: &Program, sizes: &[[Rational; 2]]) -> (Rational, Rational) {
    let ops = program.ops();
    let mut found: Vec<(Rational, u32, u32)> = Vec::new();
    let mut factors = Rational::from(1);
    for (at, &op) in ops.iter().enumerate() {
        // The rounding of the last operation changes no sign.
        let rounding = u32::from(at + 1 < ops.len());
        let axis = |at: usize| if let Op::Coordinate { axis, .. } = ops[at] { Some(axis) } else { None };
        let value = match op {
            Op::Coordinate { axis, .. } => (sizes[axis][1].clone(), 0, 1),
            Op::Constant(number) => (exact(number).abs(), 0, 0),
            Op::Neg(a) => found[a].clone(),
            Op::Add(a, b) | Op::Sub(a, b) => {
                let [(x, k, p), (y, l, q)] = [&found[a], &found[b]];
                let is_extent = matches!(op, Op::Sub(..)) && axis(a).is_some() && axis(a) == axis(b);
                let size = match axis(a) {
                    Some(axis) if is_extent => sizes[axis][0].clone(),
                    _ => Rational::from(x + y),
                };
                (size, k.max(l) + rounding, *p.max(q))
            }
            Op::Mul(a, b) => {
                let [(x, k, p), (y, l, q)] = [&found[a], &found[b]];
                factors += Rational::from(x + y);
                let is_exact =
                    [a, b].iter().any(|&at| matches!(ops[at], Op::Constant(c) if is_power_of_two(&exact(c))));
                (Rational::from(x * y), k + l + if is_exact { 0 } else { rounding }, p + q)
            }
        };
        found.push(value);
    }
    let Some((magnitude, roundings, degree)) = found.pop() else { return (Rational::new(), Rational::new()) };
    let unit = (Rational::from(1) >> 53_u32) + 1_u32;
    let error = magnitude * (unit.pow(roundings) - 1_u32);
    // Far more than the products that underflow, and far less than an error that is not subnormal.
    let underflow = (factors.pow(degree) + 1_u32) >> 950_u32;
    (error, underflow)
}

fn exact(x: f64) -> Rational {
    Rational::from_f64(x).unwrap_or_default()
}

fn near(x: Rational) -> f64 {
    x.to_f64()
}
