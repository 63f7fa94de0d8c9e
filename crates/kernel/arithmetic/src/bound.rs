//! The constants of semi-static filters, and the bounds of static filters.
//!
//! # Proof
//! Let u = 2^-53 be the unit roundoff: without overflow and underflow, fl(x ∘ y) = (x ∘ y)(1 + δ) with |δ| ≤ u for +, −
//! and ×. Let D be a sum of products of differences of doubles, and P its *permanent*: the same sum with the magnitude
//! of every term. Both are evaluated in floating point, to d and p. Assume that
//! * d = fl(x + y) is the last operation, and no term of D goes through more than n roundings on its way into x or y;
//! * no term of P goes through more than m roundings on its way into p.
//!
//! Then |(x + y) − D| ≤ ((1 + u)^n − 1)·P, and p ≥ (1 − u)^m·P since nothing cancels in P. Rounding is monotone, so d
//! has the sign of x + y, and |d| ≤ (1 + u)|x + y|. Hence **d has the sign of D if |d| ≥ fl(B·p)** with p > 0 and
//!
//! B > ((1 + u)^n − 1) · (1 − u)^−m · (1 + u)/(1 − u) = n·u·(1 + ((n − 1)/2 + m + 2)·u + …).
//!
//! The last rounding costs nothing, so Shewchuk's constants begin with 3, 7 and 10 although terms see 4, 8 and 11
//! roundings. [`semi_static`] takes n·u·(1 + (n + m + 3)·u): the excess of at least 2n·u² covers the higher powers of u
//! and the rounding of B itself, which costs n·u² at most. A test compares it with the true requirement, in rationals.
//!
//! If p = 0 and nothing underflows, every term is exactly zero; then d = 0 = D, and the comparison |d| ≥ fl(B·p) holds
//! as well.
//!
//! # Counting
//! A difference of coordinates is one rounding, a product adds its factors' roundings and one, a sum takes the larger
//! count and adds one. So the counts for the formulas as `predicament-exact` evaluates them are (terms of D before the
//! last sum, terms of P):
//!
//! | predicate | D | n | P | m |
//! |---|---|---|---|---|
//! | orient2d | 2 differences, × | 3 | +1 sum | 4 |
//! | orient3d | 3 differences, ×, −, ×, first of 2 sums | 7 | both sums | 8 |
//! | incircle | lift 2+1+1, minor 2+1+1, ×, first of 2 sums | 10 | both sums | 11 |
//! | insphere | lift 2+1+2, minor 3+1+1+1+2, ×, first of 2 sums | 15 | both sums | 16 |
//!
//! # Smaller constants near ties
//! A filter's error matters only where it can change a sign: where |D| is at most the error itself, a few u·P. There
//! two kinds of error cannot occur in full, which `docs/FILTERS.md` proves:
//! * **Only half of P goes through the first of two sums.** In (t₁ + t₂) + t₃ the sum t₁ + t₂ is rounded by u·|t₁ +
//!   t₂|. If the whole nearly vanishes, that is |t₃|, so it is P/2 at most. This makes 6½ of orient3d's 7.
//! * **The differences of incircle move it by 3u·P, not 4u·P.** A term takes its lift's difference twice. But if the
//!   determinant vanishes, the terms that dominate it share differences, whose errors then cancel in part. This makes 9
//!   of incircle's 10, and 8½ with the point above.
//!
//! The results are [`near_tie`]'s constants. Neither point helps orient2d and insphere, and none of the four constants
//! can improve much: a search finds inputs that round as badly as the constants say, up to two percent (up to six for
//! near ties of insphere; see the tests of `predicament-exact`).

mod fixed_scene;
#[cfg(test)]
mod requirement;

pub use fixed_scene::{static_incircle, static_insphere, static_orient2d, static_orient3d};

/// The unit roundoff 2^-53: the largest relative error of one rounding to nearest.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// A constant B for which |d| ≥ fl(B·p) proves the sign of d, with `n` roundings in d and `m` in p.
///
/// `n` counts the determinant's roundings before its last sum, `m` those of the permanent. In units of 1, to be
/// multiplied with the permanent. Valid for n and m up to 100.
#[must_use]
pub const fn semi_static(n: u8, m: u8) -> f64 {
    let count = n as f64;
    let second = (n as f64) * (n as f64 + m as f64 + 3.0);
    count * UNIT_ROUNDOFF + second * UNIT_ROUNDOFF * UNIT_ROUNDOFF
}

/// A constant B for which |d| ≥ fl(B·p) proves the sign of d, if near ties err by at most `halves`·u/2·P.
///
/// This error is to first order in u. A factor of 1 + 2^-40, thousands of u, covers the terms of second order; a test
/// compares the requirements of the four predicates, in rationals.
#[must_use]
pub const fn near_tie(halves: u8) -> f64 {
    const SECOND_ORDER: f64 = 8192.0 * UNIT_ROUNDOFF;
    halves as f64 / 2.0 * UNIT_ROUNDOFF * (1.0 + SECOND_ORDER)
}

/// The constant for (a − c) × (b − c): slightly more than 3u.
pub const ORIENT2D: f64 = semi_static(3, 4);
/// The constant for det(a − d, b − d, c − d), expanded along one column: 6½u.
pub const ORIENT3D: f64 = near_tie(13);
/// The constant for the lifted 3 × 3 determinant, expanded along the lift: 8½u.
pub const INCIRCLE: f64 = near_tie(17);
/// The constant for the lifted 4 × 4 determinant, expanded along the lift: 15u.
pub const INSPHERE: f64 = semi_static(15, 16);

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::{requirement::REQUIREMENTS, *};
    use crate::rational;

    const CONSTANTS: [f64; 4] = [ORIENT2D, ORIENT3D, INCIRCLE, INSPHERE];

    fn a_hair_more(x: Rational) -> Rational {
        x * Rational::from((1_000_000_000_001_u64, 1_000_000_000_000_u64))
    }

    #[test]
    fn constants_meet_the_requirement_and_waste_nothing() {
        for n in 1..=100 {
            for m in 1..=100 {
                let constant = rational(semi_static(n, m)).unwrap();
                let required = requirement::counted(n.into(), m.into());
                assert!(constant > required, "n = {n}, m = {m}");
                assert!(constant < a_hair_more(required));
            }
        }
    }

    #[test]
    fn the_four_constants_meet_theirs_and_one_per_mille_less_does_not() {
        for (constant, requirement) in CONSTANTS.into_iter().zip(REQUIREMENTS) {
            let required = requirement.semi_static();
            assert!(rational(constant).unwrap() > required);
            assert!(rational(constant).unwrap() < a_hair_more(required.clone()));
            assert!(rational(constant * 0.999).unwrap() < required);
        }
    }
}
