//! Floating point on approximations, with a bound on the error of both.
//!
//! # What is proved
//! A constructed vertex is given by doubles, each within e·u of the true coordinate; u = 2^-53, and e is the
//! coordinate's *slack*, 2^-280 or more. For doubles computed in floating point the slack is proved in `approximate`.
//! For rounded exact coordinates, which are within κu relative to themselves or within 2^-400, κ = 65/64, it is κ|x| +
//! 2^-280, and for coordinates of input vertices 2^-280. The difference of two is computed as d = fl(x − y), with |d −
//! D| ≤ u|d| + u·e_x + u·e_y = u·M for **M = |d| + e_x + e_y**, and |d| ≤ M. (Subtraction underflows exactly.)
//! [`bound`](predicament_arithmetic::bound) assumes the same of a difference: one rounding, relative to M. So its proof
//! holds with the permanent P of M in place of |d|, and n as counted there: 3 for orient2d, 7 for orient3d. In p each M
//! has four roundings, so m is 2·4 + 2 and 3·4 + 5.
//!
//! **Underflow.** Each M is at least 2^-279, so a product that underflows, and is wrong by 2^-1075 then, is wrong by
//! less than 2^-230·P for the whole determinant. The constants exceed the requirement by more than that, which a test
//! checks. P and B·P never underflow.
//!
//! **Overflow.** Rounding is monotone, so no intermediate of d exceeds that of p at the same place. If p is finite,
//! nothing overflowed; if not, |d| > B·p is false. It is false as well for a NaN, and for d = 0: the filter never
//! answers a tie. No plan of the scene is needed.

use predicament_arithmetic::{Number, bound::semi_static, power_of_two};
use predicament_predicates::Sign;

/// The constant for a difference of coordinates.
pub const COMPARE: f64 = semi_static(1, 4);
/// The constant for (a − c) × (b − c).
pub const ORIENT2D: f64 = semi_static(3, 10);
/// The constant for det(a − d, b − d, c − d), expanded along one column.
pub const ORIENT3D: f64 = semi_static(7, 17);

/// The minimum slack of every coordinate, so that no permanent underflows: 2^-280.
pub const FLOOR: f64 = power_of_two(-280);

/// A number and a bound of its error, in units of u.
#[derive(Clone, Copy, Debug)]
pub struct Approximate<T = f64> {
    value: T,
    slack: T,
}

impl<T: Number> Approximate<T> {
    /// A coordinate that is within `slack`·u of the true one; the slack is 2^-280 at least.
    #[inline(always)]
    #[must_use]
    pub fn near(value: T, slack: T) -> Approximate<T> {
        Approximate { value, slack }
    }

    #[inline(always)]
    fn minus(self, other: Approximate<T>) -> Approximate<T> {
        let value = self.value - other.value;
        Approximate { value, slack: value.abs() + (self.slack + other.slack) }
    }

    /// The minor ad − bc.
    #[inline(always)]
    fn cross([a, b]: [Approximate<T>; 2], [c, d]: [Approximate<T>; 2]) -> Approximate<T> {
        let value = a.value * d.value - b.value * c.value;
        Approximate { value, slack: a.slack * d.slack + b.slack * c.slack }
    }

    /// The value, and the permanent that its error is relative to.
    #[inline(always)]
    #[must_use]
    pub fn parts(self) -> [T; 2] {
        [self.value, self.slack]
    }
}

impl Approximate {
    /// A coordinate that is within `errors`·u of the true one, relative to itself.
    ///
    /// `errors` is zero for input vertices, 65/64 for constructed ones.
    #[inline(always)]
    #[must_use]
    pub fn within(value: f64, errors: f64) -> Approximate {
        Approximate { value, slack: errors * value.abs() + FLOOR }
    }

    #[inline(always)]
    fn certain(self, bound: f64) -> Option<Sign> {
        (self.value.abs() > bound * self.slack).then(|| Sign::of(self.value))
    }
}

/// The sign of a − b; `None` if the errors may have changed it.
#[inline(always)]
#[must_use]
pub fn compare(a: Approximate, b: Approximate, bound: f64) -> Option<Sign> {
    difference(a, b).certain(bound)
}

/// The turn a, b, c; `None` if the errors may have changed it.
#[inline(always)]
#[must_use]
pub fn orient2d(a: [Approximate; 2], b: [Approximate; 2], c: [Approximate; 2], bound: f64) -> Option<Sign> {
    turn(a, b, c).certain(bound)
}

/// The side of d on the plane of a, b, c; `None` if the errors may have changed it.
#[inline(always)]
#[must_use]
pub fn orient3d(
    a: [Approximate; 3],
    b: [Approximate; 3],
    c: [Approximate; 3],
    d: [Approximate; 3],
    bound: f64,
) -> Option<Sign> {
    volume(a, b, c, d).certain(bound)
}

/// The difference a − b, with its permanent.
#[inline(always)]
#[must_use]
pub fn difference<T: Number>(a: Approximate<T>, b: Approximate<T>) -> Approximate<T> {
    a.minus(b)
}

/// The determinant of the turn a, b, c, with its permanent.
#[inline(always)]
#[must_use]
pub fn turn<T: Number>(a: [Approximate<T>; 2], b: [Approximate<T>; 2], c: [Approximate<T>; 2]) -> Approximate<T> {
    let [ac, bc] = [minus2(a, c), minus2(b, c)];
    Approximate::cross(ac, bc)
}

/// The determinant of a, b, c and d, with its permanent.
#[inline(always)]
#[must_use]
pub fn volume<T: Number>(
    a: [Approximate<T>; 3],
    b: [Approximate<T>; 3],
    c: [Approximate<T>; 3],
    d: [Approximate<T>; 3],
) -> Approximate<T> {
    let [a, b, c] = [minus3(a, d), minus3(b, d), minus3(c, d)];
    let [bc, ca, ab] = [cross3(b, c), cross3(c, a), cross3(a, b)];
    let value = a[2].value * bc.value + b[2].value * ca.value + c[2].value * ab.value;
    let slack = a[2].slack * bc.slack + b[2].slack * ca.slack + c[2].slack * ab.slack;
    Approximate { value, slack }
}

#[inline(always)]
fn minus2<T: Number>(p: [Approximate<T>; 2], q: [Approximate<T>; 2]) -> [Approximate<T>; 2] {
    [p[0].minus(q[0]), p[1].minus(q[1])]
}

#[inline(always)]
fn minus3<T: Number>(p: [Approximate<T>; 3], q: [Approximate<T>; 3]) -> [Approximate<T>; 3] {
    [p[0].minus(q[0]), p[1].minus(q[1]), p[2].minus(q[2])]
}

#[inline(always)]
fn cross3<T: Number>(p: [Approximate<T>; 3], q: [Approximate<T>; 3]) -> Approximate<T> {
    Approximate::cross([p[0], p[1]], [q[0], q[1]])
}

#[cfg(test)]
mod tests {
    use rug::{Rational, ops::Pow};

    use super::*;

    /// The requirement of `predicament_arithmetic::bound`, plus a margin for losses by underflow.
    #[test]
    fn constants_meet_the_requirement_and_half_of_them_do_not() {
        let u = Rational::from(1) >> 53;
        let [up, down] = [Rational::from(1 + &u), Rational::from(1 - &u)];
        for (n, m, constant) in [(1_u32, 4_u32, COMPARE), (3, 10, ORIENT2D), (7, 17, ORIENT3D)] {
            let needed = (Rational::from((&up).pow(n)) - 1 + (Rational::from(1) >> 230)) * &up
                / Rational::from((&down).pow(m + 1));
            let constant = Rational::from_f64(constant).expect("finite");
            assert!(constant > needed && constant.clone() / 2 < needed);
        }
    }
}
