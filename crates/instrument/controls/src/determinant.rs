//! Plain f64 determinants, with the subtracted point as a parameter.
//!
//! All five predicates are determinants of homogeneous coordinates; subtracting one row from the others makes them
//! smaller. In real numbers the choice of row does not matter; in floating point it decides which inputs give wrong
//! signs (Kettner, Mehlhorn, Pion, Schirra and Yap 2008, section 3). Without a subtraction, the determinant of the
//! homogeneous matrix is computed as in a linear algebra library, which is the most common way to write it.

/// The point that is first subtracted from the others.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub enum Pivot {
    /// The last argument, as Shewchuk does.
    #[default]
    Last,
    /// The first argument, as Kettner et al. do.
    First,
    /// No point: `determinant()` of the homogeneous matrix, by the crate nalgebra.
    Homogeneous,
}

/// The determinant of a predicate about `N` points of `D` coordinates; each computation of determinants is a type.
pub(crate) trait Determinant<const D: usize, const N: usize> {
    /// The determinant of these points, in the order of the arguments.
    fn determinant(&self, points: [[f64; D]; N]) -> f64;
}

/// The difference of two coordinates. It is zero for equal ones only, since differences underflow gradually.
impl Determinant<1, 2> for Pivot {
    #[inline(always)]
    fn determinant(&self, [[a], [b]]: [[f64; 1]; 2]) -> f64 {
        a - b
    }
}

/// The turn a, b, c. For [`Pivot::First`], with p, q, r for a, b, c: (q.x − p.x)(r.y − p.y) − (q.y − p.y)(r.x − p.x).
impl Determinant<2, 3> for Pivot {
    #[inline(always)]
    fn determinant(&self, [a, b, c]: [[f64; 2]; 3]) -> f64 {
        match self {
            Pivot::Last => cross(minus(a, c), minus(b, c)),
            Pivot::First => cross(minus(b, a), minus(c, a)),
            Pivot::Homogeneous => homogeneous::turn([a, b, c]),
        }
    }
}

/// The side of d relative to the plane of a, b, c.
impl Determinant<3, 4> for Pivot {
    #[inline(always)]
    fn determinant(&self, [a, b, c, d]: [[f64; 3]; 4]) -> f64 {
        match self {
            Pivot::Last => triple(minus(a, d), minus(b, d), minus(c, d)),
            // Moving the first of four rows to the end is an odd permutation.
            Pivot::First => -triple(minus(b, a), minus(c, a), minus(d, a)),
            Pivot::Homogeneous => homogeneous::side([a, b, c, d]),
        }
    }
}

/// The position of d relative to the circle of a, b, c.
impl Determinant<2, 4> for Pivot {
    #[inline(always)]
    fn determinant(&self, [a, b, c, d]: [[f64; 2]; 4]) -> f64 {
        let lifted = |p, q| {
            let [x, y] = minus(p, q);
            [x, y, x * x + y * y]
        };
        match self {
            Pivot::Last => triple(lifted(a, d), lifted(b, d), lifted(c, d)),
            Pivot::First => -triple(lifted(b, a), lifted(c, a), lifted(d, a)),
            Pivot::Homogeneous => homogeneous::circle([a, b, c, d]),
        }
    }
}

/// The position of e relative to the sphere of a, b, c, d.
impl Determinant<3, 5> for Pivot {
    #[inline(always)]
    fn determinant(&self, [a, b, c, d, e]: [[f64; 3]; 5]) -> f64 {
        match self {
            Pivot::Last => lifted_quadruple(minus(a, e), minus(b, e), minus(c, e), minus(d, e)),
            // For five rows it is an even permutation.
            Pivot::First => lifted_quadruple(minus(b, a), minus(c, a), minus(d, a), minus(e, a)),
            Pivot::Homogeneous => homogeneous::sphere([a, b, c, d, e]),
        }
    }
}

/// Determinants of homogeneous matrices. They are out of line: inlined, they would prevent the inlining of the other
/// determinants, and points that go through memory cost several times the determinant.
mod homogeneous {
    use nalgebra::{Matrix3, Matrix4, Matrix5};

    #[inline(never)]
    pub(super) fn turn(points: [[f64; 2]; 3]) -> f64 {
        Matrix3::from_fn(|row, column| points[row].get(column).copied().unwrap_or(1.0)).determinant()
    }

    #[inline(never)]
    pub(super) fn side(points: [[f64; 3]; 4]) -> f64 {
        Matrix4::from_fn(|row, column| points[row].get(column).copied().unwrap_or(1.0)).determinant()
    }

    #[inline(never)]
    pub(super) fn circle(points: [[f64; 2]; 4]) -> f64 {
        let rows = points.map(|[x, y]| [x, y, x * x + y * y, 1.0]);
        Matrix4::from_fn(|row, column| rows[row][column]).determinant()
    }

    #[inline(never)]
    pub(super) fn sphere(points: [[f64; 3]; 5]) -> f64 {
        let rows = points.map(|[x, y, z]| [x, y, z, x * x + y * y + z * z, 1.0]);
        Matrix5::from_fn(|row, column| rows[row][column]).determinant()
    }
}

#[inline(always)]
fn minus<const D: usize>(p: [f64; D], q: [f64; D]) -> [f64; D] {
    let mut difference = p;
    for (d, q) in difference.iter_mut().zip(q) {
        *d -= q;
    }
    difference
}

#[inline(always)]
fn cross(p: [f64; 2], q: [f64; 2]) -> f64 {
    p[0] * q[1] - p[1] * q[0]
}

#[inline(always)]
fn triple([px, py, pz]: [f64; 3], [qx, qy, qz]: [f64; 3], [rx, ry, rz]: [f64; 3]) -> f64 {
    pz * (qx * ry - rx * qy) + qz * (rx * py - px * ry) + rz * (px * qy - qx * py)
}

/// The 4 × 4 determinant of p, q, r, s with their squared lengths as a last column.
#[inline(always)]
fn lifted_quadruple(p: [f64; 3], q: [f64; 3], r: [f64; 3], s: [f64; 3]) -> f64 {
    let lift = |[x, y, z]: [f64; 3]| x * x + y * y + z * z;
    (lift(s) * triple(p, q, r) - lift(r) * triple(p, q, s)) + (lift(q) * triple(p, r, s) - lift(p) * triple(q, r, s))
}
