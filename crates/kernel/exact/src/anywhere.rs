//! The filter for any finite doubles: no scene, no plan, one comparison.
//!
//! [`Estimate::certain`] answers if |d| ≥ B·p, provided that nothing underflows or overflows. Here a slack that covers
//! underflow is added to B·p. The comparison is strict, so that an infinity on both sides is not certain: **d has the
//! sign of D if |d| > fl(fl(B·p) + s)**, with
//!
//! | | s |
//! |---|---|
//! | orient2d | σ |
//! | orient3d | σ·(Z + 1), Z the sum of the last coordinates' magnitudes |
//! | incircle | σ·(L + 1), L the sum of the lifts |
//! | insphere | σ·(L·(Z + 1) + 1) |
//!
//! and σ = 2⁻⁹⁶⁰. Entries are differences to the last point.
//!
//! **Underflow.** Sums and differences of doubles are exact where they are subnormal. A product is off by η ≤ 2⁻¹⁰⁷⁵
//! instead of a relative u. Later only factors of its term multiply η. So the two products of orient2d are off by
//! 2⁻¹⁰⁷⁴ together. A minor is off by 2⁻¹⁰⁷⁴, which orient3d multiplies with a last coordinate, and its three products
//! are off by η each: together no more than 2⁻¹⁰⁷³·(Z + 1). A lift is off by 2η or 3η, which is multiplied with a
//! minor. The minors of incircle are |xy′| + |x′y| ≤ (l + l′)/2, all three together at most L: 2⁻¹⁰⁷²·(L + 1) in all.
//! The minors of insphere, of three columns, take each last coordinate at most three times, with a minor that is at
//! most L: 3·Z·L in all, and a minor is off by Z·2⁻¹⁰⁷⁴ + 3η; 2⁻¹⁰⁷⁰·(L·(Z + 1) + 1) in all. The permanent falls short
//! by no more. So d and p together are off by at most t = 2⁻¹⁰⁶⁹·s/σ, that is s·2⁻¹⁰⁹.
//!
//! **The slack suffices.** The magnitude must exceed B′·p + t, with B′ the requirement for B without the excess that
//! [`bound`] gives it, of at least u² (of orient3d and incircle: 2⁻⁴⁰·u). Let b = fl(B·p); s is right to a relative 6u,
//! and no s is subnormal. If s ≥ 4u·b, then fl(b + s) ≥ (b + s)(1 − u) ≥ b + s/2 > b + 2t, and if b is subnormal, it is
//! off by η < t besides. Otherwise fl(b + s) ≥ b, since rounding is monotone and b is a double; then t = s·2⁻¹⁰⁹ <
//! 2⁻¹⁰⁷·u·b, far less than the excess.
//!
//! **Overflow.** The permanent is a sum of the magnitudes of all products. If a product or a difference is infinite or
//! NaN, then p is, and so is the bound: no d is larger. If p is finite, every partial sum of d is finite, as it is no
//! larger than that of p.
//!
//! **orient2d** has p = |l + r| of its two products l and r, which equals the permanent only if they have one sign. If
//! they do not, d = l − r is a difference of numbers with two signs: it has the sign of both l and −r, whatever has
//! been rounded, has underflowed or is infinite, unless both are zero. Differences of coordinates have the right sign
//! as well, and so has d if it is not zero. (Then p may be finite and d infinite.) If l and r have one sign, the proof
//! above holds; an infinite product makes p infinite, and infinity times zero makes it NaN.
//!
//! A determinant of zero is never certain: its sign comes from the rungs above.

use predicament_arithmetic::{Number, Sign, bound, power_of_two};

use crate::estimate::{self, Estimate};

/// The number σ.
pub const SLACK: f64 = power_of_two(-960);

/// A determinant, and the magnitude beyond which its sign is certain.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bounded<T = f64> {
    /// The determinant in doubles.
    pub determinant: T,
    /// The sign is certain if the magnitude exceeds this bound; NaN or infinite if the bound is unknown.
    pub bound: T,
}

impl<T: Number> Bounded<T> {
    #[inline(always)]
    fn new(estimate: Estimate<T>, constant: T, slack: T) -> Bounded<T> {
        Bounded { determinant: estimate.determinant, bound: constant * estimate.permanent + slack }
    }
}

impl Bounded {
    /// The sign, if it is certain.
    #[inline(always)]
    #[must_use]
    pub fn certain(self) -> Option<Sign> {
        // By the sign bit (a certain determinant is not zero): signs are as good as random, and a branch on them
        // mispredicts every other time.
        const SIGNS: [Sign; 2] = [Sign::Positive, Sign::Negative];
        let sign = SIGNS[usize::from(self.determinant.is_sign_negative())];
        (self.determinant.abs() > self.bound).then_some(sign)
    }
}

/// The turn a, b, c.
#[inline(always)]
#[must_use]
pub fn orient2d(points: [[f64; 2]; 3]) -> Bounded {
    orient2d_by(points, bound::ORIENT2D, SLACK)
}

/// The side of d on the plane of a, b, c.
#[inline(always)]
#[must_use]
pub fn orient3d(points: [[f64; 3]; 4]) -> Bounded {
    orient3d_by(points, bound::ORIENT3D, SLACK)
}

/// The position of d relative to the circle of a, b, c.
#[inline(always)]
#[must_use]
pub fn incircle(points: [[f64; 2]; 4]) -> Bounded {
    incircle_by(points, bound::INCIRCLE, SLACK)
}

/// The position of e relative to the sphere of a, b, c, d.
#[inline(always)]
#[must_use]
pub fn insphere(points: [[f64; 3]; 5]) -> Bounded {
    insphere_by(points, bound::INSPHERE, SLACK)
}

/// The result of [`orient2d`] in any numbers, with B and σ as arguments.
#[inline(always)]
#[must_use]
pub fn orient2d_by<T: Number>([a, b, c]: [[T; 2]; 3], constant: T, slack: T) -> Bounded<T> {
    Bounded::new(estimate::orient2d(a, b, c), constant, slack)
}

/// The result of [`orient3d`] in any numbers, with B and σ as arguments.
#[inline(always)]
#[must_use]
pub fn orient3d_by<T: Number>([a, b, c, d]: [[T; 3]; 4], constant: T, slack: T) -> Bounded<T> {
    let (estimate, heights) = estimate::orient3d_sized(a, b, c, d);
    Bounded::new(estimate, constant, slack * (heights + T::ONE))
}

/// The result of [`incircle`] in any numbers, with B and σ as arguments.
#[inline(always)]
#[must_use]
pub fn incircle_by<T: Number>([a, b, c, d]: [[T; 2]; 4], constant: T, slack: T) -> Bounded<T> {
    let (estimate, lifts) = estimate::incircle_sized(a, b, c, d);
    Bounded::new(estimate, constant, slack * (lifts + T::ONE))
}

/// The result of [`insphere`] in any numbers, with B and σ as arguments.
#[inline(always)]
#[must_use]
pub fn insphere_by<T: Number>([a, b, c, d, e]: [[T; 3]; 5], constant: T, slack: T) -> Bounded<T> {
    let (estimate, [heights, lifts]) = estimate::insphere_sized(a, b, c, d, e);
    Bounded::new(estimate, constant, slack * (lifts * (heights + T::ONE) + T::ONE))
}
