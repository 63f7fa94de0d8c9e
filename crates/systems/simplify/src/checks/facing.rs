//! The truth about a face that a step moves.
//!
//! Normals are computed as they are defined, in integers over one denominator, and not by the formula that the
//! algorithm asks. A test compares both.

use predicament_judge::rational;
use predicament_predicates::{Scene, Vertex};
use rug::Integer;

/// A face before and after one of its corners moves.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Facing {
    /// Its normals make an acute angle.
    Same,
    /// It has no area before and after.
    Flat,
    /// It loses its area, gets an area, or its normals make a right angle.
    Undecided,
    /// Its normals make an obtuse angle.
    Turned,
}

impl Facing {
    /// True if the step may be done.
    #[must_use]
    pub const fn is_kept(self) -> bool {
        matches!(self, Facing::Same | Facing::Flat)
    }

    /// The value in words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Facing::Same => "faces the same way",
            Facing::Flat => "has no area before and after",
            Facing::Undecided => "loses or gets an area, or turns by a right angle",
            Facing::Turned => "turns over",
        }
    }
}

/// Decides about the face `b c u` that becomes `b c v`, by its normals.
///
/// # Panics
/// If the scene lacks one of the vertices.
#[must_use]
pub fn facing(scene: &Scene, [u, v, b, c]: [Vertex; 4]) -> Facing {
    let [u, v, b, c] = integers([u, v, b, c].map(|v| scene.point3(v)));
    let along = minus(&b, &c);
    let [before, after] = [u, v].map(|apex| cross(&minus(&apex, &c), &along));
    let product = before.iter().zip(&after).fold(Integer::new(), |sum, (x, y)| sum + Integer::from(x * y));
    let is_flat = |normal: &[Integer; 3]| normal.iter().all(Integer::is_zero);
    match product.cmp0() {
        std::cmp::Ordering::Greater => Facing::Same,
        std::cmp::Ordering::Less => Facing::Turned,
        std::cmp::Ordering::Equal if is_flat(&before) && is_flat(&after) => Facing::Flat,
        std::cmp::Ordering::Equal => Facing::Undecided,
    }
}

/// The coordinates of points, times one power of two that makes all of them whole.
fn integers(points: [[f64; 3]; 4]) -> [[Integer; 3]; 4] {
    // The denominator of a double is a power of two.
    let parts = points.map(|point| point.map(|x| rational(x).into_numer_denom()));
    let bits = parts.iter().flatten().map(|(_, denominator)| denominator.significant_bits()).max().unwrap_or(1);
    parts.map(|point| point.map(|(numerator, denominator)| numerator << (bits - denominator.significant_bits())))
}

fn minus(a: &[Integer; 3], b: &[Integer; 3]) -> [Integer; 3] {
    [0, 1, 2].map(|axis| Integer::from(&a[axis] - &b[axis]))
}

fn cross(a: &[Integer; 3], b: &[Integer; 3]) -> [Integer; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| Integer::from(&a[i] * &b[j]) - Integer::from(&a[j] * &b[i]))
}
