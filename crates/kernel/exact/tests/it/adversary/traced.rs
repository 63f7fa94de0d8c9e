//! Floating point that tracks its error.
//!
//! Every number carries its error, to first order: the errors of its operands, and its own rounding error. The latter
//! is exact (error-free transformations of Knuth and Dekker), so that a search knows the direction of each rounding.

use std::ops::{Add, Mul, Neg, Sub};

/// A double, its error and its magnitude.
#[derive(Clone, Copy)]
pub struct Traced {
    /// The floating-point value.
    pub value: f64,
    /// The value minus the truth, to first order in u.
    pub error: f64,
    /// The value with the magnitude of every term: a share of the permanent.
    pub magnitude: f64,
}

impl Traced {
    /// A difference of coordinates.
    fn difference(p: f64, q: f64) -> Traced {
        let exact = |value: f64| Traced { value, error: 0.0, magnitude: value.abs() };
        let difference = exact(p) - exact(q);
        Traced { magnitude: difference.value.abs(), ..difference }
    }
}

impl Add for Traced {
    type Output = Traced;

    fn add(self, other: Traced) -> Traced {
        let value = self.value + other.value;
        let virtual_other = value - self.value;
        let tail = (self.value - (value - virtual_other)) + (other.value - virtual_other);
        Traced { value, error: self.error + other.error - tail, magnitude: self.magnitude + other.magnitude }
    }
}

impl Neg for Traced {
    type Output = Traced;

    fn neg(self) -> Traced {
        Traced { value: -self.value, error: -self.error, ..self }
    }
}

impl Sub for Traced {
    type Output = Traced;

    fn sub(self, other: Traced) -> Traced {
        self + -other
    }
}

impl Mul for Traced {
    type Output = Traced;

    fn mul(self, other: Traced) -> Traced {
        let value = self.value * other.value;
        let [high, low] = halves(self.value);
        let [other_high, other_low] = halves(other.value);
        let tail = low * other_low - (((value - high * other_high) - low * other_high) - high * other_low);
        Traced {
            value,
            error: self.error * other.value + other.error * self.value - tail,
            magnitude: self.magnitude * other.magnitude,
        }
    }
}

/// The upper and the lower half of a significand.
fn halves(x: f64) -> [f64; 2] {
    let shifted = 134_217_729.0 * x;
    let high = shifted - (shifted - x);
    [high, x - high]
}

/// A determinant as `predicament_exact::estimate` evaluates it, up to its last sum x + y.
pub type Formula<const D: usize, const N: usize> = fn(&[[f64; D]; N]) -> [Traced; 2];

/// The summands of (a − c) × (b − c).
pub fn orient2d([a, b, c]: &[[f64; 2]; 3]) -> [Traced; 2] {
    let [a, b] = [minus(a, c), minus(b, c)];
    [a[0] * b[1], -(a[1] * b[0])]
}

/// The summands of det(a − d, b − d, c − d).
pub fn orient3d([a, b, c, d]: &[[f64; 3]; 4]) -> [Traced; 2] {
    let [a, b, c] = [a, b, c].map(|p| minus(p, d));
    [a[2] * minor(b, c) + b[2] * minor(c, a), c[2] * minor(a, b)]
}

/// The side of c on the line from a to b: (c − a) times the normal of b − a.
pub fn line([c, b, a]: &[[f64; 2]; 3]) -> [Traced; 2] {
    let [c, b] = [c, b].map(|p| minus(p, a));
    [b[1] * c[0], -(b[0] * c[1])]
}

/// The side of d on the plane of a, b, c: (d − a) times the normal of b − a and c − a.
pub fn plane([d, b, c, a]: &[[f64; 3]; 4]) -> [Traced; 2] {
    let [d, b, c] = [d, b, c].map(|p| minus(p, a));
    let normal = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| b[i] * c[j] - b[j] * c[i]);
    [normal[0] * d[0] + normal[1] * d[1], normal[2] * d[2]]
}

/// The summands of the 3 × 3 determinant of a − d, b − d, c − d, each with its squared length.
pub fn incircle([a, b, c, d]: &[[f64; 2]; 4]) -> [Traced; 2] {
    let [a, b, c] = [a, b, c].map(|p| minus(p, d));
    [lift(a) * minor(b, c) + lift(b) * minor(c, a), lift(c) * minor(a, b)]
}

/// The summands of the 4 × 4 determinant of a − e, b − e, c − e, d − e, each with its squared length.
pub fn insphere([a, b, c, d, e]: &[[f64; 3]; 5]) -> [Traced; 2] {
    let [a, b, c, d] = [a, b, c, d].map(|p| minus(p, e));
    let [ab, bc, cd] = [minor(a, b), minor(b, c), minor(c, d)];
    let [da, ac, bd] = [minor(d, a), minor(a, c), minor(b, d)];
    let abc = a[2] * bc - b[2] * ac + c[2] * ab;
    let bcd = b[2] * cd - c[2] * bd + d[2] * bc;
    let cda = c[2] * da + d[2] * ac + a[2] * cd;
    let dab = d[2] * ab + a[2] * bd + b[2] * da;
    [lift(d) * abc - lift(c) * dab, lift(b) * cda - lift(a) * bcd]
}

fn minus<const D: usize>(p: &[f64; D], q: &[f64; D]) -> [Traced; D] {
    std::array::from_fn(|i| Traced::difference(p[i], q[i]))
}

fn minor<const D: usize>(p: [Traced; D], q: [Traced; D]) -> Traced {
    p[0] * q[1] - q[0] * p[1]
}

fn lift<const D: usize>(p: [Traced; D]) -> Traced {
    p.into_iter().map(|x| x * x).reduce(Add::add).expect("coordinates")
}
