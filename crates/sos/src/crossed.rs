//! The sign of a component of a cross product of two differences of points.

use predicament_predicates::{Scene, Sign, Vertex};
use rug::Rational;

/// The sign of ((q − p) × (v − u)) along an axis of a scene in space, exactly.
///
/// By a filter, with u = 2^-53: a difference, a product and the last difference are each rounded by a relative u at most, so that the
/// error is below 4·(1 + u)^3·u times the sum of both products' magnitudes. Where that sum is so small that a product may have underflowed, or
/// overflows, rationals decide.
#[inline]
pub(crate) fn along(scene: &Scene, axis: usize, [p, q]: [Vertex; 2], [u, v]: [Vertex; 2]) -> Sign {
    let [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
    let points = scene.coordinates().as_chunks::<3>().0;
    let [p, q, u, v] = [points[p.index()], points[q.index()], points[u.index()], points[v.index()]];
    let [first, second] = [[q[i] - p[i], v[j] - u[j]], [q[j] - p[j], v[i] - u[i]]];
    // A difference of doubles is zero only if it is zero, and so are factors of a product.
    match [is_zero(first), is_zero(second)] {
        [true, true] => return Sign::Zero,
        [true, false] => return -sign_of(second),
        [false, true] => return sign_of(first),
        [false, false] => {}
    }
    let [left, right] = [first, second].map(|[a, b]| a * b);
    let (difference, size) = (left - right, left.abs() + right.abs());
    // 8·u is twice what is needed; 2^-900 is far above what a product that underflows is wrong by, over u.
    if size > 2f64.powi(-900) && difference.abs() > size * (4.0 * f64::EPSILON) {
        return if difference > 0.0 { Sign::Positive } else { Sign::Negative };
    }
    exactly([[q[i], p[i]], [v[j], u[j]]], [[q[j], p[j]], [v[i], u[i]]])
}

/// The sign of a product of two differences, less another one.
#[cold]
#[inline(never)]
fn exactly(first: [[f64; 2]; 2], second: [[f64; 2]; 2]) -> Sign {
    let product = |differences: [[f64; 2]; 2]| {
        let [a, b] = differences.map(|pair| {
            let [a, b] = pair.map(|x| Rational::from_f64(x).expect("coordinates are finite"));
            a - b
        });
        a * b
    };
    product(first).cmp(&product(second)).into()
}

fn is_zero([a, b]: [f64; 2]) -> bool {
    a == 0.0 || b == 0.0
}

fn sign_of([a, b]: [f64; 2]) -> Sign {
    if (a > 0.0) == (b > 0.0) { Sign::Positive } else { Sign::Negative }
}
