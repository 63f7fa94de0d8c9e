//! What happens to a query that the scene's filter leaves open.

use predicament_arithmetic::{Plan, Regime};
use predicament_predicates::Sign;

use crate::{expansion, filter, form, form::Determinant, rational, stage};

/// The turn a, b, c, where the scene is in this regime and its filter has failed.
pub(crate) fn orient2d(points: [[f64; 2]; 3], scene: Regime) -> (Sign, usize) {
    let [a, b, c] = points;
    climb(
        (&points, scene, form::ORIENT2D),
        |bound| filter::orient2d(a, b, c, bound),
        || expansion::orient2d(a, b, c),
        || rational::orient2d(a, b, c),
    )
}

/// The side of d on the plane of a, b, c, as above.
pub(crate) fn orient3d(points: [[f64; 3]; 4], scene: Regime) -> (Sign, usize) {
    let [a, b, c, d] = points;
    climb(
        (&points, scene, form::ORIENT3D),
        |bound| filter::orient3d(a, b, c, d, bound),
        || expansion::orient3d(a, b, c, d),
        || rational::orient3d(a, b, c, d),
    )
}

/// d in the circle of a, b, c, as above.
pub(crate) fn incircle(points: [[f64; 2]; 4], scene: Regime) -> (Sign, usize) {
    let [a, b, c, d] = points;
    climb(
        (&points, scene, form::INCIRCLE),
        |bound| filter::incircle(a, b, c, d, bound),
        || expansion::incircle(a, b, c, d),
        || rational::incircle(a, b, c, d),
    )
}

/// e in the sphere of a, b, c, d, as above.
pub(crate) fn insphere(points: [[f64; 3]; 5], scene: Regime) -> (Sign, usize) {
    let [a, b, c, d, e] = points;
    climb(
        (&points, scene, form::INSPHERE),
        |bound| filter::insphere(a, b, c, d, e, bound),
        || expansion::insphere(a, b, c, d, e),
        || rational::insphere(a, b, c, d, e),
    )
}

fn climb<const D: usize>(
    (points, scene, determinant): (&[[f64; D]], Regime, Determinant),
    filter: impl Fn(f64) -> Option<Sign>,
    expansion: impl Fn() -> Sign,
    rational: impl Fn() -> rational::Value,
) -> (Sign, usize) {
    let mut regime = scene;
    if scene == Regime::Unproved {
        // The scene is wide; these few points alone may not be.
        regime = Plan::of(points.as_flattened()).regime(determinant.form);
        if let Some(sign) = filter(determinant.bound_in(regime)) {
            return (sign, stage::FILTER);
        }
    }
    match regime {
        Regime::Unproved => (rational().sign(), stage::RATIONAL),
        Regime::Exact | Regime::Safe => (expansion(), stage::EXPANSION),
    }
}
