//! A filter on approximations whose bound is linear in their slacks.
//!
//! The bound of [`filter`] is a product of magnitudes that each include a slack. Slacks of some thousand
//! u therefore cost it a factor of some thousand for each row of the determinant. This filter keeps the magnitude of a
//! difference and the bound of its error apart. It costs about twice as much, and runs where the other filter fails.
//!
//! # Proof
//! The computed difference d = fl(x − y) is within u·m of the true difference D, m = |d| + e_x + e_y, as [`filter`]
//! proves. Let v be |d|. A product d₁d₂ is within u·m of D₁D₂ for m = v₁m₂ + m₁(v₂ + u·m₂), because (v₁ + u·m₁)(v₂ +
//! u·m₂) = v₁v₂ + u·m. For a sum or a difference, m₁ + m₂ suffices. Hence the determinant of the d, in real numbers, is
//! within u·m of the true one.
//!
//! The floating-point value is fl(x + y), and x + y comes after k roundings of terms whose magnitudes add up to v: k is
//! 1 for a turn, and 4 for a volume. Rounding is monotone, so the value has the sign of x + y. Therefore **the sign is
//! certain if the value exceeds u·(k·v + m)**. The constant `ROOM` covers the following.
//!
//! **Roundings of the bound,** the last rounding of the value, and second powers of u: fewer than 100 of them, relative
//! to the bound, which is a sum of positive terms. `ROOM` covers 2^13.
//!
//! **Underflow.** Every m of a difference is at least v and at least 2^-279. A product that underflows is wrong by
//! 2^-1075, times other factors of its term, each at most an m. The bound has u³·m₁m₂m₃ for the same term, at least
//! 2^-159 times the factors that multiply the error, and 2^-279 for each of the others, of which there are three at
//! most: an error is less than 2^-79 of the bound. The value is compared in units of u, so the product with u does not
//! underflow.
//!
//! **Overflow.** Rounding is monotone, so no intermediate of the value exceeds the one of v at the same place. If the
//! bound is infinite or NaN, the filter does not answer. If the value overflows in units of u alone, it exceeds every
//! finite bound. Tests try this on all turns of a few numbers of tiny formats (`tests/it/toy/linear.rs`).
//!
//! If the slacks are zero, the bound is the one of [`filter`]: k and the factors of the product make 3 and 7.
//!
//! `cargo xtask prove` proves [`ROOM`] by Gappa, from [`turn`] and [`volume`]. It compares the m of a determinant with
//! the formula above as polynomials, and the terms that underflow loses with those of the bound.

use predicament_arithmetic::{Number, bound::UNIT_ROUNDOFF};
use predicament_predicates::Sign;

use super::filter::{self, Approximate};

/// The factor for roundings of the bound: 1 + 2^-40.
pub const ROOM: f64 = 1.0 + 8192.0 * UNIT_ROUNDOFF;
/// The roundings of a turn of differences before its last sum.
pub const TURN: f64 = 1.0;
/// The roundings of a volume of differences before its last sum.
pub const VOLUME: f64 = 4.0;

/// A value, the magnitude of its terms, and the bound of what the differences contribute to its error.
#[derive(Clone, Copy, Debug)]
pub struct Bounded<T = f64> {
    /// The determinant of the differences.
    pub value: T,
    /// The sum of its terms' magnitudes.
    pub size: T,
    /// The bound of the error, in units of u.
    pub error: T,
}

/// The turn a, b, c; `None` if the errors may have changed it.
#[inline(always)]
#[must_use]
pub fn orient2d(a: [Approximate; 2], b: [Approximate; 2], c: [Approximate; 2]) -> Option<Sign> {
    turn([a, b, c], UNIT_ROUNDOFF).certain(TURN)
}

/// The side of d on the plane of a, b, c; `None` if the errors may have changed it.
#[inline(always)]
#[must_use]
pub fn orient3d(a: [Approximate; 3], b: [Approximate; 3], c: [Approximate; 3], d: [Approximate; 3]) -> Option<Sign> {
    volume([a, b, c, d], UNIT_ROUNDOFF).certain(VOLUME)
}

/// The determinant of the turn a, b, c in any numbers, with u as an argument.
#[inline(always)]
#[must_use]
pub fn turn<T: Number>([a, b, c]: [[Approximate<T>; 2]; 3], u: T) -> Bounded<T> {
    minor(minus(a, c), minus(b, c), u)
}

/// The determinant of a, b, c and d in any numbers, with u as an argument.
#[inline(always)]
#[must_use]
pub fn volume<T: Number>([a, b, c, d]: [[Approximate<T>; 3]; 4], u: T) -> Bounded<T> {
    let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = [minus(a, d), minus(b, d), minus(c, d)];
    let [bc, ca, ab] = [minor([bx, by], [cx, cy], u), minor([cx, cy], [ax, ay], u), minor([ax, ay], [bx, by], u)];
    az.times(bc, u).plus(bz.times(ca, u)).plus(cz.times(ab, u))
}

#[inline(always)]
fn minus<T: Number, const D: usize>(p: [Approximate<T>; D], q: [Approximate<T>; D]) -> [Bounded<T>; D] {
    core::array::from_fn(|i| {
        let [value, error] = filter::difference(p[i], q[i]).parts();
        Bounded { value, size: value.abs(), error }
    })
}

/// The minor ad − bc.
#[inline(always)]
fn minor<T: Number>([a, b]: [Bounded<T>; 2], [c, d]: [Bounded<T>; 2], u: T) -> Bounded<T> {
    let (ad, bc) = (a.times(d, u), b.times(c, u));
    Bounded { value: ad.value - bc.value, size: ad.size + bc.size, error: ad.error + bc.error }
}

impl<T: Number> Bounded<T> {
    #[inline(always)]
    fn times(self, other: Bounded<T>, u: T) -> Bounded<T> {
        Bounded {
            value: self.value * other.value,
            size: self.size * other.size,
            error: self.size * other.error + self.error * (other.size + u * other.error),
        }
    }

    #[inline(always)]
    fn plus(self, other: Bounded<T>) -> Bounded<T> {
        Bounded { value: self.value + other.value, size: self.size + other.size, error: self.error + other.error }
    }

    /// The magnitude in units of u beyond which the sign is certain.
    #[inline(always)]
    #[must_use]
    pub fn bound(self, room: T, roundings: T) -> T {
        room * (roundings * self.size + self.error)
    }
}

impl<T: Number + PartialOrd> Bounded<T> {
    /// True if the value has the sign of the true determinant; `units` is 1/u.
    ///
    /// A product with `units` that overflows is beyond every finite bound, and truly so.
    #[inline(always)]
    #[must_use]
    pub fn is_certain(self, room: T, roundings: T, units: T) -> bool {
        self.value.abs() * units > self.bound(room, roundings)
    }
}

impl Bounded {
    #[inline(always)]
    fn certain(self, roundings: f64) -> Option<Sign> {
        self.is_certain(ROOM, roundings, 1.0 / UNIT_ROUNDOFF).then(|| Sign::of(self.value))
    }
}
