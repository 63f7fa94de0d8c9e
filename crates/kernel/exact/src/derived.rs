//! The ladder of predicates from formulas: the static filter of the scene, the filter of the query, integers of 128
//! bits, dyadic numbers.

use predicament_arithmetic::difference_up;
use predicament_predicates::{Declined, Derived, PredicateKind, Scene, Sign, Vertex};

use crate::first;
use crate::once::Once;
use crate::stage::{DYADIC, INTEGER, SEMI_STATIC, STATIC};

/// The number of formulas of a scene whose static bounds are kept; others go on to the filter of the query.
const KEPT: usize = 8;

/// The static bounds of formulas in one scene.
#[derive(Debug, Default)]
pub(crate) struct Bounds([Once<(Derived, f64)>; KEPT]);

impl Bounds {
    /// The magnitude from which on an estimate has the right sign; infinite if the static filter is of no use.
    ///
    /// The first query of a formula computes it.
    #[inline]
    fn of(&self, scene: &Scene, derived: Derived) -> f64 {
        for kept in &self.0 {
            let (owner, bound) = kept.get_or_init(|| (derived, useful_bound(scene, derived)));
            if core::ptr::eq(owner.formula(), derived.formula()) {
                return *bound;
            }
        }
        f64::INFINITY
    }

    /// The sign, and the stage that settled it; panics as [`decide`] does.
    pub(crate) fn decide(&self, scene: &Scene, derived: Derived, vertices: &[Vertex]) -> (Sign, usize) {
        let formula = derived.formula();
        assert_eq!(vertices.len(), formula.arity(), "{} has its number of vertices", formula.name());
        let bound = self.of(scene, derived);
        if bound < f64::INFINITY {
            let value = derived.with_points(scene, vertices, |points| formula.value(points));
            if value.abs() > bound {
                return (Sign::of(value), STATIC);
            }
        }
        decide(scene, derived, vertices)
    }
}

/// The static bound of a formula in a scene: no query about its input vertices has a larger error.
///
/// Infinite or NaN if there is none.
#[must_use]
pub fn static_bound(scene: &Scene, derived: Derived) -> f64 {
    let (formula, count) = (derived.formula(), scene.dimension().count());
    let column = |axis: usize| scene.coordinates().iter().skip(axis).step_by(count).copied();
    let weights = scene.weights().iter().copied();
    let mut ranges: Vec<[f64; 2]> = (0..count).map(|axis| range(column(axis))).collect();
    if formula.is_weighted() {
        ranges.push(range(weights));
    }
    let extents: Vec<f64> =
        ranges.iter().map(|&[low, high]| if high < low { 0.0 } else { difference_up(high, low) }).collect();
    let largest: Vec<f64> = ranges.iter().map(|&[low, high]| (-low).max(high).max(0.0)).collect();
    formula.filter().static_bound(formula.program(), &extents, &largest)
}

/// The least and the largest of some numbers.
fn range(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// The static bound; infinite if it decides few of the queries in a sample.
fn useful_bound(scene: &Scene, derived: Derived) -> f64 {
    let bound = static_bound(scene, derived);
    let value = |vertices: &[Vertex]| derived.with_points(scene, vertices, |points| derived.formula().value(points));
    let is_decided = |vertices: &[Vertex]| value(vertices).abs() > bound;
    if first::is_mostly(scene.len(), derived.formula().arity(), is_decided) { bound } else { f64::INFINITY }
}

/// The sign without the static filter of a scene, and the stage that settled it.
///
/// # Panics
/// If a vertex is constructed or out of range, or the number of vertices is not the formula's.
#[must_use]
pub fn decide(scene: &Scene, derived: Derived, vertices: &[Vertex]) -> (Sign, usize) {
    let formula = derived.formula();
    assert_eq!(vertices.len(), formula.arity(), "{} has its number of vertices", formula.name());
    derived.with_points(scene, vertices, |points| match formula.certain(points) {
        Some(sign) => (sign.into(), SEMI_STATIC),
        None => {
            let (sign, is_short) = formula.unfiltered(points);
            (sign.into(), if is_short { INTEGER } else { DYADIC })
        }
    })
}

/// Checks that a session answers a predicate from a formula on this scene.
///
/// # Errors
/// [`Declined`] if the scene has another dimension, no weights, or constructed vertices.
pub fn supports(scene: &Scene, kind: PredicateKind) -> Result<(), Declined> {
    if matches!(kind, PredicateKind::Derived(_)) && !scene.constructions().is_empty() {
        return Err(Declined::predicate(kind, "formulas are about input vertices, not about constructed ones"));
    }
    scene.has_dimension_for(kind)
}
