//! Where the vertices of an overlay are, as they are defined. What is true about pieces and results is said by the
//! [checks](crate::checks): by crossing sums of the judge, and in rationals.

use predicament_judge::rational;
use predicament_predicates::{Construction, Scene};
use rug::Rational;

pub use predicament_slice::truth::constructed;

/// A point of space.
pub type Point = [Rational; 3];

/// The points of a scene.
#[must_use]
pub fn given(scene: &Scene) -> Vec<Point> {
    scene.vertices().map(|v| scene.point3(v).map(rational)).collect()
}

/// The points of a scene, then the constructed ones.
///
/// # Errors
/// The place of the first construction that is no point.
pub fn points(scene: &Scene, constructions: &[Construction]) -> Result<Vec<Point>, usize> {
    let mut all = given(scene);
    all.extend(constructed(scene, constructions)?);
    Ok(all)
}
