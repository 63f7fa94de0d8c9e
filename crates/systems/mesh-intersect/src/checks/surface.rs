//! Checks that triangles form the surface of a body, in rationals.

use predicament_judge::rational;
use predicament_slice::checks::{Expected, Flaw, Part, Piece, Slices};
use rug::Rational;

/// The flaws of a surface, at most one entry for each law: it is closed, each triangle has an area, and of `crossed`
/// triangles none passes through another one.
pub(super) fn flaws(points: Vec<[Rational; 3]>, triangles: &[[u32; 3]], crossed: usize) -> Vec<Flaw> {
    // Each triangle is its own face.
    let pieces = (0..triangles.len()).map(Piece::Face).collect();
    let part = Part { triangles: triangles.to_vec(), pieces, open: Vec::new() };
    let faces = triangles.iter().map(|triangle| triangle.to_vec()).collect();
    let slices = Slices { points, faces, planes: Vec::new(), parts: vec![part] };
    slices.flaws_of_surface(Expected {
        is_closed: false,
        has_areas: true,
        may_stand: false,
        triangles_crossed: crossed,
    })
}

/// The first flaw of a surface of doubles, in words: all pairs of triangles are compared, in rationals. `None` if there
/// is none.
///
/// # Panics
/// If a triangle has a vertex that does not exist, or a coordinate is not finite.
#[must_use]
pub fn flaw_of(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> Option<String> {
    let points = points.iter().map(|point| point.map(rational)).collect();
    let first = flaws(points, triangles, usize::MAX).into_iter().next()?;
    Some(format!("{}: {} times, first: {}", first.check.law(), first.count, first.what))
}
