//! Intersection points of lines and planes in floating point: doubles near the point, with a proved error bound.
//!
//! The formulas are those of `points`: a vertex of the definition, and from there an offset, P = p +
//! (n/w)·u. For points that are close together this is far more precise than coordinates relative to the origin.
//!
//! # What is proved
//! Vertices that define the point are given by doubles within s·u of the true coordinates, u = 2^-53, s their *slack*:
//! zero for input vertices. A difference of two is computed as d = fl(x − y), so |d − D| ≤ u·M with M = |d| + s_x +
//! s_y. Sums and products of differences are polynomials: written out as a sum of products, each product of k
//! differences goes through k roundings by those of the differences and some more, n in all. Then |f − F| ≤ ((1 + u)^n
//! − 1)·P, where the *permanent* P is the sum of the products of the M. n is counted by rules: a difference is one
//! rounding (`DIFFERENCE`), a product has those of both factors and one (`product`), a sum those of the worse term
//! and one (`sum`). They are compile-time expressions below, along the formulas.
//!
//! Permanents are bounded by norms. Let m be the largest M of a difference of points, over the axes, and for two
//! differences a and b in space C the largest |a_j·b_k| + |a_k·b_j| with M in place of magnitudes: that bounds the
//! permanent of a component of a × b.
//!
//! | kind | permanent of w | error of w, in u: E | permanent of n | error of n, in u |
//! |---|---|---|---|---|
//! | `Ssi` | C(u, v) | 4·C(u, v) | C(s, v) | 4·C(s, v) |
//! | `Lpi` | 3·C·m_u | 8·3·C·m_u | 3·C·m_s | 8·3·C·m_s |
//! | `Tpi` | 6·Π, Π = C_L·C_M·C_N | 17·6·Π | 6·Π·(m_q + m_r) | 20·6·Π·(m_q + m_r) |
//!
//! (`Tpi`: a component of M × N has 2·C_M·C_N; w = L·(M × N), three times that and C_L; M·(q − p) has 3·C_M·m_q, and
//! its product with a component of N × L is one of two in n.)
//!
//! **There is a point** if u·E ≤ 2^-10·|w|: then w is not zero, and |W| ≥ (1 − 2^-10)·|w|. Otherwise exact numbers
//! decide.
//!
//! **The slack.** With g = fl(n/w) and E_n for n, |g − N/W| ≤ u·|g| + u·(|g|·E + E_n)/|w| times a factor that is hardly
//! more than one. `Tpi` adds g to p. The others add fl(g·u), which takes twice |g|·m_u more, for u and for the product.
//! Adding to p is off by u·|x|, and p itself by u·s. So
//!
//! s_x = |x| + s + 3·|g|·m_u + m_u·(|g|·E + E_n)/|w|, for `Tpi` |x| + s + |g| + (|g|·E + E_n)/|w|.
//!
//! [`ROOM`] multiplies this: it covers 1/(1 − 2^-10), terms of second order in u, and the roundings of norms, E and s
//! itself, fewer than a hundred. One slack is kept for all axes.
//!
//! A point αa + (1 − α)c, `Ratio`, is c + α(a − c) for all a and c: there is no w, and E and E_n are zero. The quotient
//! of α is rounded once, like g.
//!
//! **Overflow and underflow.** The code requires every m to be at most 2^60, and the product of Cs and ms in the
//! permanent of w at least 2^-350; otherwise exact numbers decide. So no overflow goes unnoticed: the largest
//! intermediate of w and n is below 2^430. A division by w may overflow, and then s is not finite, which is checked. A
//! product that underflows is wrong by 2^-1075, times other factors: components of normals are below 2^121, their
//! products' below 2^243. That is less than 2^-820 for w, while u·E is more than 2^-402, and less than 2^-760 for n. As
//! |w| ≥ 2^10·u·E ≥ 2^-392, it moves n/w by 2^-368 at most (`Ssi` and `Lpi`: by 2^-619, times u); `FLOOR`·u = 2^-333
//! is more than that and the later losses of products and quotients. A C may lose 2^-1074, which is negligible beside
//! one of 2^-600, and the other factors leave it more. Differences underflow exactly.

use predicament_arithmetic::{Number, bound::UNIT_ROUNDOFF, power_of_two};
use predicament_predicates::Share;

use super::filter::FLOOR;

/// Doubles near a point, with a slack.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near<const D: usize> {
    /// The approximate coordinates.
    pub point: [f64; D],
    /// The slack: each coordinate is within `slack`·2^-53 of the true one.
    pub slack: f64,
}

/// The roundings of a difference of two coordinates.
const DIFFERENCE: u32 = 1;
/// The roundings of a product.
const fn product(a: u32, b: u32) -> u32 {
    a + b + 1
}
/// The roundings of a sum of two terms with equally many.
const fn sum(a: u32) -> u32 {
    a + 1
}
/// The roundings of ad − bc.
const fn cross(a: u32, b: u32) -> u32 {
    sum(product(a, b))
}
/// The roundings of a dot product in space, whose first product goes through two sums.
const fn dot(a: u32, b: u32) -> u32 {
    sum(sum(product(a, b)))
}

/// The roundings of a normal of a plane.
const NORMAL: u32 = cross(DIFFERENCE, DIFFERENCE);
/// The errors of w and n of two lines: roundings times terms of one size.
pub const SEGMENTS: f64 = cross(DIFFERENCE, DIFFERENCE) as f64;
/// The errors of w and n of a line and a plane.
pub const LINE_PLANE: f64 = 3.0 * dot(NORMAL, DIFFERENCE) as f64;
/// The errors of w of three planes.
pub const PLANES_WEIGHT: f64 = 6.0 * dot(NORMAL, cross(NORMAL, NORMAL)) as f64;
/// The errors of n of three planes.
pub const PLANES_POINT: f64 = 6.0 * sum(product(dot(NORMAL, DIFFERENCE), cross(NORMAL, NORMAL))) as f64;

/// The factor for all smaller errors; see the module.
pub const ROOM: f64 = 1.0 + 1.0 / 64.0;
/// The largest ratio u·E/|w| for which w is certainly not zero: 2^-10.
const CERTAIN: f64 = 1.0 / 1024.0;
/// The largest allowed difference: 2^60.
const LARGEST: f64 = power_of_two(60);
/// The least allowed product in a permanent of w: 2^-350.
const LEAST: f64 = power_of_two(-350);

/// A difference of points.
#[derive(Clone, Copy)]
struct Way<const D: usize> {
    by: [f64; D],
    /// The largest M over the axes.
    norm: f64,
    /// The slack of the ends, part of every M.
    slack: f64,
}

impl<const D: usize> Way<D> {
    #[inline(always)]
    fn new(from: &Near<D>, to: &Near<D>) -> Way<D> {
        let by: [f64; D] = core::array::from_fn(|i| to.point[i] - from.point[i]);
        let slack = from.slack + to.slack;
        Way { by, norm: largest(by) + slack, slack }
    }

    /// Returns true if M is in the range of the proof; false for NaN.
    #[inline(always)]
    fn is_short(&self) -> bool {
        self.norm <= LARGEST
    }

    /// The largest growth of |a_i·b_j| + |a_j·b_i| if M replaces the magnitudes.
    ///
    /// (|a| + s)(|b| + t) − |a||b| = s·|b| + t·(|a| + s), twice.
    #[inline(always)]
    fn slack_beside(&self, other: &Way<D>) -> f64 {
        2.0 * (self.slack * other.norm + other.slack * self.norm)
    }

    /// A component of the cross product, and its permanent without slack.
    #[inline(always)]
    fn minor(&self, other: &Way<D>, i: usize, j: usize) -> [f64; 2] {
        let [[a, b], [c, d]] = [self, other].map(|way| [way.by[i], way.by[j]]);
        [minor([a, b], [c, d]), (a * d).abs() + (b * c).abs()]
    }
}

/// The normal of a plane.
struct Normal {
    by: [f64; 3],
    /// The norm C.
    norm: f64,
    /// True if both edges are in the range of the proof.
    is_short: bool,
}

impl Normal {
    #[inline(always)]
    fn new([r, s, t]: &[Near<3>; 3]) -> Normal {
        let (a, b) = (Way::new(r, s), Way::new(r, t));
        let [[x, in_x], [y, in_y], [z, in_z]] = [a.minor(&b, 1, 2), a.minor(&b, 2, 0), a.minor(&b, 0, 1)];
        let norm = largest([in_x, in_y, in_z]) + a.slack_beside(&b);
        Normal { by: [x, y, z], norm, is_short: a.is_short() & b.is_short() }
    }
}

/// The point of two lines; `None` if its existence is not certain, or out of range.
#[inline(always)]
pub(super) fn segments([[a, b], [c, d]]: &[[Near<2>; 2]; 2]) -> Option<Near<2>> {
    let [u, v, s] = [Way::new(a, b), Way::new(c, d), Way::new(a, c)];
    let [[w, of_w], [n, of_n]] = [u.minor(&v, 0, 1), s.minor(&v, 0, 1)];
    let [of_w, of_n] = [of_w + u.slack_beside(&v), of_n + s.slack_beside(&v)];
    let errors = SEGMENTS * of_w;
    if !(is_certain(w, errors) & (of_w >= LEAST) & u.is_short() & v.is_short() & s.is_short()) {
        return None;
    }
    moved(a, n / w, &u, |g| (g * errors + SEGMENTS * of_n) / w.abs())
}

/// The point of a line and a plane; `None` if its existence is not certain, or out of range.
#[inline(always)]
pub(super) fn line_plane([p, q]: &[Near<3>; 2], plane: &[Near<3>; 3]) -> Option<Near<3>> {
    let (u, s, normal) = (Way::new(p, q), Way::new(p, &plane[0]), Normal::new(plane));
    let (w, n) = (inner(normal.by, u.by), inner(normal.by, s.by));
    let of_w = normal.norm * u.norm;
    let errors = LINE_PLANE * of_w;
    if !(is_certain(w, errors) & (of_w >= LEAST) & u.is_short() & s.is_short() & normal.is_short) {
        return None;
    }
    moved(p, n / w, &u, |g| (g * errors + LINE_PLANE * (normal.norm * s.norm)) / w.abs())
}

/// The point of three planes; `None` if its existence is not certain, or out of range.
#[inline(always)]
pub(super) fn planes(planes: &[[Near<3>; 3]; 3]) -> Option<Near<3>> {
    let [[p, ..], [q, ..], [r, ..]] = planes;
    let [l, m, n] = [Normal::new(&planes[0]), Normal::new(&planes[1]), Normal::new(&planes[2])];
    let [lm, mn, nl] = [outer(l.by, m.by), outer(m.by, n.by), outer(n.by, l.by)];
    let w = inner(l.by, mn);
    let all = l.norm * m.norm * n.norm;
    let errors = PLANES_WEIGHT * all;
    let [to_second, to_third] = [Way::new(p, q), Way::new(p, r)];
    let is_short = l.is_short & m.is_short & n.is_short & to_second.is_short() & to_third.is_short();
    if !(is_certain(w, errors) & (all >= LEAST) & is_short) {
        return None;
    }
    let [second, third] = [inner(m.by, to_second.by), inner(n.by, to_third.by)];
    let way: [f64; 3] = core::array::from_fn(|i| mixed([second, third], [nl[i], lm[i]]) / w);
    let point: [f64; 3] = core::array::from_fn(|i| p.point[i] + way[i]);
    let (g, ways) = (largest(way), to_second.norm + to_third.norm);
    let quotient = g + (g * errors + PLANES_POINT * all * ways) / w.abs();
    near(point, p.slack + quotient)
}

/// The point αa + (1 − α)c; `None` if it is out of range.
#[inline(always)]
pub(super) fn shared<const D: usize>([a, c]: &[Near<D>; 2], share: Share) -> Option<Near<D>> {
    let u = Way::new(c, a);
    if !u.is_short() {
        return None;
    }
    moved(c, share.nearest(), &u, |_| 0.0)
}

/// The point p + g·u, where g is off by u·g and u times `quotient` of its magnitude.
#[inline(always)]
fn moved<const D: usize>(p: &Near<D>, g: f64, u: &Way<D>, quotient: impl Fn(f64) -> f64) -> Option<Near<D>> {
    let point = core::array::from_fn(|i| p.point[i] + g * u.by[i]);
    let g = g.abs();
    near(point, p.slack + u.norm * (3.0 * g + quotient(g)))
}

/// The point with its total slack, if the slack is finite.
#[inline(always)]
fn near<const D: usize>(point: [f64; D], errors: f64) -> Option<Near<D>> {
    let slack = ROOM * (largest(point) + errors) + FLOOR;
    // (Not for NaN.)
    (slack < f64::INFINITY).then_some(Near { point, slack })
}

#[inline(always)]
fn is_certain(w: f64, errors: f64) -> bool {
    UNIT_ROUNDOFF * errors <= CERTAIN * w.abs()
}

/// The largest magnitude.
///
/// (Infinities are the largest; NaN may be ignored, and occurs only if a slack is infinite or NaN too.)
#[inline(always)]
fn largest<const D: usize>(values: [f64; D]) -> f64 {
    values.into_iter().fold(0.0, |most, x| if x.abs() > most { x.abs() } else { most })
}

/// The minor ad − bc.
#[inline(always)]
#[must_use]
pub fn minor<T: Number>([a, b]: [T; 2], [c, d]: [T; 2]) -> T {
    a * d - b * c
}

/// The dot product.
#[inline(always)]
#[must_use]
pub fn inner<T: Number>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The cross product.
#[inline(always)]
#[must_use]
pub fn outer<T: Number>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> [T; 3] {
    [minor([ay, az], [by, bz]), minor([az, ax], [bz, bx]), minor([ax, ay], [bx, by])]
}

/// A component of n for three planes.
#[inline(always)]
#[must_use]
pub fn mixed<T: Number>([second, third]: [T; 2], [nl, lm]: [T; 2]) -> T {
    second * nl + third * lm
}

#[cfg(test)]
mod tests {
    use core::ops::{Add, Mul, Sub};

    use rug::{Rational, ops::Pow};

    use super::*;

    /// A number that stores the largest number of roundings of a term, and its permanent.
    #[derive(Clone, Copy, PartialEq, Debug)]
    struct Counted {
        roundings: u32,
        permanent: f64,
    }

    impl Add for Counted {
        type Output = Counted;
        fn add(self, other: Counted) -> Counted {
            let roundings = self.roundings.max(other.roundings) + 1;
            Counted { roundings, permanent: self.permanent + other.permanent }
        }
    }

    impl Sub for Counted {
        type Output = Counted;
        #[allow(clippy::suspicious_arithmetic_impl)] // the same number of roundings, and magnitudes
        fn sub(self, other: Counted) -> Counted {
            self + other
        }
    }

    impl Mul for Counted {
        type Output = Counted;
        fn mul(self, other: Counted) -> Counted {
            let roundings = self.roundings + other.roundings + 1;
            Counted { roundings, permanent: self.permanent * other.permanent }
        }
    }

    impl Number for Counted {
        const ONE: Counted = Counted { roundings: 0, permanent: 1.0 };
        fn abs(self) -> Counted {
            self
        }
    }

    /// The formulas themselves are counted, with every M = 1: the constants are exactly the counts.
    #[test]
    fn constants_are_the_roundings_of_the_formulas() {
        let one = Counted { roundings: 1, permanent: 1.0 };
        let (flat, solid) = ([one; 2], [one; 3]);
        let errors = |counted: Counted, bound: f64| f64::from(counted.roundings) * counted.permanent / bound;
        let weight = minor(flat, flat);
        // C = 2.
        assert_eq!(errors(weight, 2.0), SEGMENTS);
        let normal = outer(solid, solid);
        assert_eq!(normal, [weight; 3]);
        assert_eq!(errors(inner(normal, solid), 2.0), LINE_PLANE);
        let along = outer(normal, normal);
        assert_eq!(errors(inner(normal, along), 8.0), PLANES_WEIGHT);
        let way = inner(normal, solid);
        // m_q + m_r = 2.
        assert_eq!(errors(mixed([way; 2], [along[0]; 2]), 8.0 * 2.0), PLANES_POINT);
    }

    /// The factor covers the smaller errors.
    ///
    /// They are 1/(1 − 2^-10), three factors of 1 + u that are not counted (|U| and |N/W| instead of |u| and |g|), the
    /// excess of 20 roundings over 20u, and 100 roundings of the bound itself, two of its factors being norms of norms.
    #[test]
    fn there_is_room_for_what_is_smaller() {
        let u = Rational::from(1) >> 53;
        let [up, down] = [Rational::from(1 + &u), Rational::from(1 - &u)];
        let certain = 1 - Rational::from_f64(CERTAIN).expect("finite");
        let powers = (Rational::from((&up).pow(20)) - 1) / (u * 20_u32);
        let needed = powers * Rational::from((&up).pow(3)) / certain / Rational::from((&down).pow(100));
        assert!(Rational::from_f64(ROOM).expect("finite") > needed);
    }

    /// The slacks of the ends count in every norm.
    #[test]
    fn a_slack_reaches_every_norm() {
        let at = |x: f64, y: f64, slack: f64| Near { point: [x, y], slack };
        let lines = |slack: f64| [[at(0.0, 0.0, slack), at(4.0, 4.0, 0.0)], [at(0.0, 4.0, 0.0), at(4.0, 0.0, slack)]];
        let [none, some, most] = [0.0, 1e3, 1e14].map(|slack| segments(&lines(slack)).map(|near| near.slack));
        // |x| = 2, m = 4, g = 1/2, C = 32, w = −32.
        let exact = 2.0 + 4.0 * (1.5 + (0.5 * 4.0 * 32.0 + 4.0 * 16.0) / 32.0);
        assert!((none.expect("certain") - ROOM * exact).abs() < 1e-9, "{none:?}");
        // 1000 for a, and of C 2(1000·4 + 1000·4 + …) in w and n.
        assert!(some.expect("certain") > 1000.0 + 4.0 * 4.0 * (0.5 * 16000.0 + 16000.0) / 32.0);
        assert_eq!(most, None, "not even that there is a point");
    }
}
