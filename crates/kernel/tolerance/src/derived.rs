//! Bands of predicates from formulas, derived as those of [`circles`](crate::circles).
//!
//! The program of the formula is evaluated on the quantities of the error calculus: coordinates at most L apart. That
//! gives a bound E = c ε L^p of the value's error. The constraints of the paper, min(T₊ − T, T − T₋) > E + R\[T\] T and
//! T₋ ≥ E, are then met by T₋ = (c + 1) ε L^p, T = 2 T₋ and T₊ = 3 T₋, with c rounded up to a whole number. The
//! calculus is about differences of coordinates. For a formula with other operands, with weights or with terms of
//! different degrees E is the static bound of the formula's filter, in the units of the value.

use predicament_error_calculus::Quantity;
use predicament_predicates::formula::{Op, Program};
use predicament_predicates::{Axis, Band, Declined, Derived, PredicateKind, Scene};
use rug::Integer;

use crate::Float;
use crate::band::{Unit, is_sound};
use crate::extent::largest_extent;

/// The bound c ε L^p of the error of a formula's value: c, rounded up, and p.
///
/// `None` if the calculus has no rule for the formula.
#[must_use]
pub fn error_bound(derived: Derived) -> Option<(Integer, u32)> {
    let formula = derived.formula();
    if formula.is_weighted() || !formula.polynomial().is_homogeneous() || !is_about_differences(formula.program()) {
        return None;
    }
    let name = |point: usize, axis: usize| format!("{}{axis}", formula.points()[point]);
    let coordinate = |point, axis| Quantity::coordinate(&name(point, axis));
    let constant = |number: f64| Quantity::constant(rug::Rational::from_f64(number).unwrap_or_default());
    let arithmetic = |op, [a, b]: [&Quantity; 2]| {
        Some(match op {
            Op::Add(..) => a.clone() + b.clone(),
            Op::Sub(..) => a.clone() - b.clone(),
            Op::Mul(..) => a.clone() * b.clone(),
            _ => -a.clone(),
        })
    };
    let value = formula.program().evaluate(coordinate, constant, arithmetic)?;
    if !value.is_valid() {
        return None;
    }
    Some((value.absolute()?.rounded_up(), formula.polynomial().degree()))
}

/// Returns true if coordinates occur in differences of two coordinates of one axis only.
///
/// The calculus shifts the scene, so that coordinates are at most L/2. Other operands do not follow the shift.
fn is_about_differences(program: &Program) -> bool {
    let ops = program.ops();
    let axis = |at: usize| match ops[at] {
        Op::Coordinate { axis, .. } => Some(axis),
        _ => None,
    };
    ops.iter().all(|&op| match op {
        Op::Sub(a, b) => axis(a) == axis(b),
        op => op.operands().into_iter().flatten().all(|at| axis(at).is_none()),
    })
}

/// The band of a formula for a scene; zero if all points coincide.
///
/// Where the calculus has no rule, E is the static bound of the formula's filter for the scene's extents.
///
/// # Errors
/// [`Declined`] if the scene has another dimension, no weights or weights that the format rounds, or if the band leaves
/// the range of normal numbers. Also if the scene is shifted and the calculus has no rule: such a formula may depend on
/// the place.
pub(crate) fn prepared<F: Float>(scene: &Scene, derived: Derived, is_shifted: bool) -> Result<Band, Declined> {
    let kind = PredicateKind::Derived(derived);
    scene.has_dimension_for(kind)?;
    // A rounded weight would err by its own magnitude, and the band is about differences of weights.
    if derived.formula().is_weighted() && scene.weights().iter().any(|&weight| F::nearest(weight).wide() != weight) {
        return Err(Declined::predicate(kind, format!("a weight is not a number of {}", F::NAME)));
    }
    let axes = &[Axis::X, Axis::Y, Axis::Z][..scene.dimension().count()];
    let length = largest_extent(scene, axes);
    let (band, largest) = match error_bound(derived) {
        Some((factor, power)) => by_calculus::<F>(F::above(length), factor.to_f64() + 1.0, power),
        None if is_shifted => {
            let reason = "the scene is shifted, and the formula is not about differences of coordinates";
            return Err(Declined::predicate(kind, reason));
        }
        None => by_filter::<F>(scene, derived, axes),
    };
    let is_point = length == 0.0 && scene.weights().iter().all(|weight| *weight == scene.weights()[0]);
    if is_point || (is_sound::<F>(band) && largest.is_finite()) {
        return Ok(band);
    }
    let name = F::NAME;
    let reason = format!("with L = {length:e} the tolerance or a product leaves the range of normal numbers of {name}");
    Err(Declined::predicate(kind, reason))
}

/// The band of a number of units ε L^p, and a bound of every intermediate.
fn by_calculus<F: Float>(length: F, step: f64, power: u32) -> (Band, f64) {
    let unit = |length: F| (0..power).fold(F::EPSILON, |unit, _| unit * length);
    let wide = (0..power).fold(F::EPSILON.wide(), |unit, _| unit * length.wide());
    let band = Unit { here: unit(length), wide }.band([step, 2.0 * step, 3.0 * step]);
    let largest = (0..power).fold(F::nearest(step), |largest, _| largest * length);
    (band, largest.wide())
}

/// The band from the static bound of the filter, and a bound of every intermediate.
///
/// The filter counts roundings by u = 2⁻⁵³; another format multiplies the bound by the ratio of its own unit.
fn by_filter<F: Float>(scene: &Scene, derived: Derived, axes: &[Axis]) -> (Band, f64) {
    let formula = derived.formula();
    let weights = [scene.weights()];
    let weights = &weights[..usize::from(formula.is_weighted())];
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, x| most.max(x.abs()));
    let spread = |values: &[f64]| {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if values.is_empty() { 0.0 } else { predicament_arithmetic::difference_up(high, low) }
    };
    let extents: Vec<f64> = axes
        .iter()
        .map(|&axis| largest_extent(scene, &[axis]))
        .chain(weights.iter().map(|weights| spread(weights)))
        .collect();
    let largests: Vec<f64> = axes
        .iter()
        .map(|&axis| largest(&mut scene.vertices().map(|v| scene.coordinate(axis, v))))
        .chain(weights.iter().map(|weights| largest(&mut weights.iter().copied())))
        .collect();
    let bound = formula.filter().static_bound(formula.program(), &extents, &largests);
    // More than the roundings of the product and of T.
    let step = bound * (F::EPSILON.wide() / f64::EPSILON) * (1.0 + 1.0 / 64.0);
    let width = F::above(2.0 * step).wide();
    (Band { lower: step, width, upper: (width + step).next_up() }, bound / f64::EPSILON)
}

/// The value of a formula in numbers of a format, rounded after each operation.
pub(crate) fn value<F: Float>(derived: Derived, points: &[&[f64]]) -> f64 {
    let coordinate = |point: usize, axis: usize| F::nearest(points[point][axis]);
    let arithmetic = |op, [a, b]: [&F; 2]| {
        Some(match op {
            Op::Add(..) => *a + *b,
            Op::Sub(..) => *a - *b,
            Op::Mul(..) => *a * *b,
            _ => F::ZERO - *a,
        })
    };
    derived.formula().program().evaluate(coordinate, F::nearest, arithmetic).map_or(f64::NAN, F::wide)
}
