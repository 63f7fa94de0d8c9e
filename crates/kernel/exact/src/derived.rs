//! The ladder of predicates from formulas: the derived filter, integers of 128 bits, dyadic numbers.

use predicament_predicates::{Declined, Derived, PredicateKind, Scene, Sign, Vertex};

use crate::stage::{DYADIC, INTEGER, SEMI_STATIC};

/// The sign, and the stage that settled it.
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
