//! The positions of an overlay's vertices by their definitions, and the contacts of two solids. The
//! [checks](crate::checks) say what must hold for pieces and results: by crossing sums of the judge, and in rationals.

pub mod contacts;
mod faces;

use predicament_judge::rational;
use predicament_predicates::{Construction, Scene};
use rug::Rational;

pub use predicament_slice::truth::constructed;

/// A point in space.
pub type Point = [Rational; 3];

/// The points of a scene.
#[must_use]
pub fn given(scene: &Scene) -> Vec<Point> {
    scene.vertices().map(|v| scene.point3(v).map(rational)).collect()
}

/// The points of a scene, then the constructed ones.
///
/// # Errors
/// The index of the first construction that is not a point.
pub fn points(scene: &Scene, constructions: &[Construction]) -> Result<Vec<Point>, usize> {
    let mut all = given(scene);
    all.extend(constructed(scene, constructions)?);
    Ok(all)
}
