//! Where constructed vertices are, as they are defined. What is true about parts is said by the [checks](crate::checks).

use predicament_judge::Points;
use predicament_predicates::{Construction, Scene};
use rug::Rational;

/// Where these constructed vertices are.
///
/// # Errors
/// The place of the first one that is no point.
pub fn constructed(scene: &Scene, constructions: &[Construction]) -> Result<Vec<[Rational; 3]>, usize> {
    let mut points = Points::of(scene);
    let vertices = points.construct(constructions).map_err(|why| why.index().unwrap_or(0))?;
    let exactly = |(at, v)| {
        let point = points.point(v).map(std::borrow::Cow::into_owned).ok_or(at)?;
        <[Rational; 3]>::try_from(point).map_err(|_| at)
    };
    vertices.into_iter().enumerate().map(exactly).collect()
}
