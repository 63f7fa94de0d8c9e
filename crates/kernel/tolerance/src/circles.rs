//! Bands for `incircle` and `insphere`, derived as the paper derives κ and ξ.
//!
//! The paper has no tolerance for these two predicates, so the bands are ours.
//!
//! Both determinants are translated to the last point, and evaluated in the order of [`incircle`] and [`insphere`]. For
//! that order the error calculus gives E\[incircle\] ≤ 129 ε L⁴ and E\[insphere\] ≤ 1129 ε L⁵. The constraints, in the
//! paper's form, are
//!
//! min(T₊ − T, T − T₋) > E + R\[T\] T, and T₋ ≥ E.
//!
//! The first constraint registers everything up to T₋ and nothing beyond T₊. The second is more than enough for a sign
//! outside of the band to be right. As for the paper's κ, T is in the middle and the steps are equal.
//!
//! # Underflow
//! A product that underflows errs by up to half the smallest subnormal, times at most 2 L² (6 L³) further on. If T₋ is
//! a normal number, that is less than 2⁻⁵⁰ of the ε L⁴ (ε L⁵) by which T₋ and the steps exceed E, in either precision.

use predicament_error_calculus::Ring;
use predicament_error_calculus::vector::{minus, norm_squared, perp};
use predicament_predicates::{Axis, Band, Declined, Dimension, PredicateKind, Scene};

use crate::Float;
use crate::band::{Unit, is_sound};
use crate::extent::largest_extent;

/// The values T₋, T and T₊ of `incircle` over ε L⁴.
pub const INCIRCLE: [f64; 3] = [130.0, 260.0, 390.0];

/// The values T₋, T and T₊ of `insphere` over ε L⁵.
pub const INSPHERE: [f64; 3] = [1130.0, 2260.0, 3390.0];

/// A band of ours, with the figures that it is derived from.
pub(crate) struct Lifted {
    /// The predicate's name.
    pub name: &'static str,
    /// The values T₋, T and T₊ over ε L^`degree`.
    pub band: [f64; 3],
    /// The degree of the determinant.
    pub degree: u32,
    /// The bound of the error E over ε L^`degree`.
    pub error: u32,
    /// The bound of the relative rounding error R\[T\] of T, over ε.
    pub rounding: u32,
}

/// The bands of ours, in the plane and in space.
pub(crate) const LIFTED: [Lifted; 2] = [
    Lifted { name: "incircle", band: INCIRCLE, degree: 4, error: 129, rounding: 5 },
    Lifted { name: "insphere", band: INSPHERE, degree: 5, error: 1129, rounding: 6 },
];

/// The band of `incircle`, for points at most L apart along each axis.
#[must_use]
pub fn incircle_band<F: Float>(length: F) -> Band {
    Unit { here: quartic(length, F::EPSILON), wide: quartic(length.wide(), F::EPSILON.wide()) }.band(INCIRCLE)
}

/// The band of `insphere`, for points at most L apart along each axis.
#[must_use]
pub fn insphere_band<F: Float>(length: F) -> Band {
    let wide = length.wide();
    Unit { here: quartic(length, F::EPSILON) * length, wide: quartic(wide, F::EPSILON.wide()) * wide }.band(INSPHERE)
}

/// The product ε L⁴.
fn quartic<F: Float>(length: F, epsilon: F) -> F {
    let square = length * length;
    epsilon * (square * square)
}

/// The determinant of d in the circle of a, b and c.
///
/// It is the sum of each squared distance from d times the area of the other two, (‖a‖² b×c + ‖b‖² c×a) + ‖c‖² a×b.
#[inline(always)]
pub fn incircle<N: Ring>([a, b, c, d]: &[[N; 2]; 4]) -> N {
    let [a, b, c] = [minus(a, d), minus(b, d), minus(c, d)];
    let term = |p, q, r| norm_squared(p) * perp(q, r);
    term(&a, &b, &c) + term(&b, &c, &a) + term(&c, &a, &b)
}

/// The determinant of e in the sphere of a, b, c and d.
///
/// In pairs, (‖d‖² \[abc\] − ‖c‖² \[dab\]) + (‖b‖² \[cda\] − ‖a‖² \[bcd\]). A volume \[pqr\] is (p_z q×r − q_z p×r) +
/// r_z p×q, with × of x and y.
#[inline(always)]
pub fn insphere<N: Ring>([a, b, c, d, e]: &[[N; 3]; 5]) -> N {
    let [a, b, c, d] = [minus(a, e), minus(b, e), minus(c, e), minus(d, e)];
    let term = |p, [q, r, s]: [&[N; 3]; 3]| norm_squared(p) * lifted_volume(q, r, s);
    (term(&d, [&a, &b, &c]) - term(&c, [&d, &a, &b])) + (term(&b, [&c, &d, &a]) - term(&a, [&b, &c, &d]))
}

/// The determinants of circles as named quantities, for the table of bounds.
pub(crate) fn in_plane<N: Ring>(four: &[[N; 2]; 4]) -> [(&'static str, N); 1] {
    [(LIFTED[0].name, incircle(four))]
}

/// The determinants of spheres as named quantities, for the table of bounds.
pub(crate) fn in_space<N: Ring>(five: &[[N; 3]; 5]) -> [(&'static str, N); 1] {
    [(LIFTED[1].name, insphere(five))]
}

/// The determinant of rows p, q and r, by their last column.
#[inline(always)]
fn lifted_volume<N: Ring>(p: &[N; 3], q: &[N; 3], r: &[N; 3]) -> N {
    let flat = |[x, y, _]: &[N; 3]| [x.clone(), y.clone()];
    let term = |[_, _, z]: &[N; 3], q, r| z.clone() * perp(&flat(q), &flat(r));
    (term(p, q, r) - term(q, p, r)) + term(r, p, q)
}

/// The band of `incircle` for a 2D scene and of `insphere` for a 3D one; zero if all points coincide.
///
/// # Errors
/// [`Declined`] if the band or a product leaves the range of normal doubles.
pub(crate) fn prepared<F: Float>(scene: &Scene) -> Result<Band, Declined> {
    let axes: &[Axis] = match scene.dimension() {
        Dimension::Two => &[Axis::X, Axis::Y],
        Dimension::Three => &[Axis::X, Axis::Y, Axis::Z],
    };
    let length = F::above(largest_extent(scene, axes));
    let square = length * length;
    // 12 L⁴ and 72 L⁵ bound the determinants
    let (kind, band, largest, formula) = match scene.dimension() {
        Dimension::Two => {
            (PredicateKind::Incircle, incircle_band(length), square * square * F::nearest(16.0), "260 ε L⁴")
        }
        Dimension::Three => {
            let largest = square * square * length * F::nearest(128.0);
            (PredicateKind::Insphere, insphere_band(length), largest, "2260 ε L⁵")
        }
    };
    if length == F::ZERO || (is_sound::<F>(band) && largest.wide().is_finite()) {
        return Ok(band);
    }
    let (length, name) = (length.wide(), F::NAME);
    let reason = format!(
        "with L = {length:e} the tolerance {formula} or the determinant leaves the range of normal numbers of {name}"
    );
    Err(Declined::predicate(kind, reason))
}
