//! Two predicates of the kind that programs have: one on integers, and a filter on doubles.

/// Twice the signed area of a triangle on the grid of `i32`, exactly.
pub fn orient2d(a: [i32; 2], b: [i32; 2], c: [i32; 2]) -> i128 {
    let [a, b, c] = [a, b, c].map(|p| p.map(i128::from));
    (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
}

/// The turn of three points, or `None` if rounding or a product beyond the range of doubles could have turned it.
///
/// The first stage of Shewchuk's predicate, with a range in which products neither overflow nor underflow.
pub fn filtered_orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<f64> {
    const BOUND: f64 = (3.0 + 16.0 * (f64::EPSILON / 2.0)) * (f64::EPSILON / 2.0);
    let left = (a[0] - c[0]) * (b[1] - c[1]);
    let right = (a[1] - c[1]) * (b[0] - c[0]);
    let magnitude = left.abs() + right.abs();
    let determinant = left - right;
    ((1e-280..1e300).contains(&magnitude) && determinant.abs() > BOUND * magnitude).then_some(determinant)
}
