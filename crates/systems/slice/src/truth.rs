//! The positions of constructed vertices by their definitions. The [checks](crate::checks) say what must hold for
//! parts.

use predicament_judge::Points;
use predicament_predicates::{Construction, Scene};
use rug::Rational;

/// The positions of constructed vertices.
///
/// # Errors
/// The index of the first construction that is not a point.
pub fn constructed(scene: &Scene, constructions: &[Construction]) -> Result<Vec<[Rational; 3]>, usize> {
    let mut points = Points::of(scene);
    let vertices = points.construct(constructions).map_err(|why| why.index().unwrap_or(0))?;
    let exactly = |(at, v)| {
        let point = points.point(v).map(std::borrow::Cow::into_owned).ok_or(at)?;
        <[Rational; 3]>::try_from(point).map_err(|_| at)
    };
    vertices.into_iter().enumerate().map(exactly).collect()
}
