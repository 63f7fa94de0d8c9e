//! The filters of CGAL and of Attene's predicates, for comparison: a determinant, the largest differences, a published
//! constant.
//!
//! FPG (Meyer and Pion 2008) derives, for each predicate, a constant that is multiplied with the largest difference
//! along each axis, and the range of these differences in which nothing underflows or overflows. Constants and ranges
//! are those of CGAL's static filters.

use predicament_predicates::Sign;

fn largest<const N: usize>(differences: [f64; N]) -> f64 {
    differences.into_iter().fold(0.0, |largest, x| if x.abs() > largest { x.abs() } else { largest })
}

/// The sign if the determinant is beyond the bound, else `None`.
///
/// `None` as well if the extents (sorted) are outside of the range.
#[inline(always)]
fn certain(determinant: f64, least: f64, most: f64, range: [f64; 2], bound: f64) -> Option<Sign> {
    if least < range[0] || most > range[1] {
        return None;
    }
    if determinant > bound {
        Some(Sign::Positive)
    } else if determinant < -bound {
        Some(Sign::Negative)
    } else {
        None
    }
}

#[inline(always)]
pub fn orient2d([a, b, c]: [[f64; 2]; 3]) -> Option<Sign> {
    let [px, py, qx, qy] = [a[0] - c[0], a[1] - c[1], b[0] - c[0], b[1] - c[1]];
    let [x, y] = [largest([px, qx]), largest([py, qy])];
    let (least, most) = if x < y { (x, y) } else { (y, x) };
    certain(px * qy - py * qx, least, most, [1e-146, 1e153], 8.887_205_737_259_28e-16 * x * y)
}

#[inline(always)]
fn determinant3(p: [f64; 3], q: [f64; 3], r: [f64; 3]) -> f64 {
    let [m01, m02, m12] = [p[0] * q[1] - q[0] * p[1], p[0] * r[1] - r[0] * p[1], q[0] * r[1] - r[0] * q[1]];
    m01 * r[2] - m02 * q[2] + m12 * p[2]
}

#[inline(always)]
fn minus<const D: usize>(p: [f64; D], q: [f64; D]) -> [f64; D] {
    std::array::from_fn(|axis| p[axis] - q[axis])
}

#[inline(always)]
pub fn orient3d([a, b, c, d]: [[f64; 3]; 4]) -> Option<Sign> {
    let [p, q, r] = [minus(a, d), minus(b, d), minus(c, d)];
    let [x, y, z] = [0, 1, 2].map(|axis| largest([p[axis], q[axis], r[axis]]));
    let (least, most) = (x.min(y).min(z), x.max(y).max(z));
    certain(determinant3(p, q, r), least, most, [1e-97, 1e102], 5.110_712_782_997_33e-15 * x * y * z)
}

#[inline(always)]
pub fn incircle([a, b, c, d]: [[f64; 2]; 4]) -> Option<Sign> {
    let [p, q, r] = [minus(a, d), minus(b, d), minus(c, d)];
    let lifted = [p, q, r].map(|[x, y]| [x, y, x * x + y * y]);
    let [x, y] = [0, 1].map(|axis| largest([p[axis], q[axis], r[axis]]));
    let (least, most) = if x < y { (x, y) } else { (y, x) };
    let bound = 8.887_856_576_200_137e-15 * x * y * (most * most);
    certain(determinant3(lifted[0], lifted[1], lifted[2]), least, most, [1e-73, 1e76], bound)
}

#[inline(always)]
pub fn insphere([a, b, c, d, e]: [[f64; 3]; 5]) -> Option<Sign> {
    let [p, q, r, s] = [minus(a, e), minus(b, e), minus(c, e), minus(d, e)];
    let lift = |[x, y, z]: [f64; 3]| x * x + y * y + z * z;
    let minor = |p: [f64; 3], q: [f64; 3]| p[0] * q[1] - q[0] * p[1];
    let [pq, qr, rs, sp, pr, qs] = [minor(p, q), minor(q, r), minor(r, s), minor(s, p), minor(p, r), minor(q, s)];
    let pqr = p[2] * qr - q[2] * pr + r[2] * pq;
    let qrs = q[2] * rs - r[2] * qs + s[2] * qr;
    let rsp = r[2] * sp + s[2] * pr + p[2] * rs;
    let spq = s[2] * pq + p[2] * qs + q[2] * sp;
    let determinant = (lift(s) * pqr - lift(r) * spq) + (lift(q) * rsp - lift(p) * qrs);
    let [x, y, z] = [0, 1, 2].map(|axis| largest([p[axis], q[axis], r[axis], s[axis]]));
    let (least, most) = (x.min(y).min(z), x.max(y).max(z));
    certain(determinant, least, most, [1e-58, 1e61], 1.246_613_653_102_729_8e-13 * x * y * z * (most * most))
}
