//! The determinants: as polynomials (degree, growth, filter constant, bits), and in integers of a fixed size.
//!
//! # As polynomials
//! If all differences are less than M, the sum of the magnitudes of all terms is at most 2M² for
//! orient2d, 6M³ for orient3d, 3·2·2 M⁴ = 12M⁴ for incircle and 4·6·3 M⁵ = 72M⁵ for insphere: `growth` is the next
//! logarithm to base two. The bits for integers are counted below.
//!
//! # In integers
//! The arguments are differences of coordinates in units of the scene's lowest bit. `D` is the number of limbs of a
//! difference; a product of k of them takes k·D. Sums wrap, which is harmless if the determinant itself fits: for
//! differences less than M = 2^b in magnitude,
//!
//! | predicate | largest determinant | limbs | b up to, for D = 1 | for D = 2 |
//! |---|---|---|---|---|
//! | orient2d | 2M² | 2D | 63 | 127 |
//! | orient3d | 4M³ | 3D | 63 | 127 |
//! | incircle | 8M⁴ | 4D | 63 | 127 |
//! | insphere | 48M⁵ | 5D | 62 | 126 |
//!
//! since 2b + 1 ≤ 127, 3b + 2 ≤ 191 and 4b + 3 ≤ 255 at b = 63, and 5b + log₂48 ≤ 319 at b = 62; the same for D = 2.
//! (4M³ is the maximum of a 3 × 3 determinant with entries up to M, 16M⁴ of a 4 × 4 one: Hadamard. Lifts scale one
//! column, by 2M or 3M.) Intermediate factors must fit as well: lifts are less than 2M² or 3M² and get 2D limbs, minors
//! less than 2M² and 4M³ and get 2D and 3D.
//!
//! All predicates stop one bit earlier, at 62 and 126, so that one number serves all.
//!
//! # Fewer limbs after a filter
//! If a filter has run and could not decide, the determinant is at most about twice the filter's bound, some 2^-48 of
//! its possible maximum. So it is known up to multiples of a power of two, and the code computes it modulo that power.
//! The upper limbs are omitted; see [`Determinant::limbs_left_open`].

use predicament_arithmetic::Sign;
use predicament_arithmetic::{Fixed, Form, Parts, bound};

/// The data of a determinant for a plan, and the constant of its filter.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Determinant {
    /// The degree, growth and bits.
    pub form: Form,
    /// The constant of the semi-static filter, to be multiplied with the permanent.
    pub bound: f64,
}

impl Determinant {
    /// The limbs that hold any determinant of differences of this many bits.
    #[must_use]
    pub const fn limbs(&self, bits: i32) -> usize {
        limbs(self.form.degree * bits + self.form.growth)
    }

    /// The limbs that hold any determinant which a filter has left open.
    ///
    /// The filter has found |d| < B·p, and d errs by no more than a determinant must to have the wrong sign. So |D| <
    /// 2.01·B·2^growth·M^degree, where the hundredth covers the terms of second order in u. This holds for both
    /// filters: B·p, for M larger than the differences of the query, and the static bound, for M larger than those of
    /// the scene.
    #[inline(always)] // most of it is known at compile time
    #[must_use]
    pub const fn limbs_left_open(&self, bits: i32) -> usize {
        let share = 2.01 * self.bound;
        let exponent = Parts::of(share).expect("a bound is finite").highest().expect("and positive");
        limbs(self.form.degree * bits + self.form.growth + exponent)
    }
}

/// The limbs of integers less than 2^`bits`, with their signs.
#[inline(always)]
const fn limbs(bits: i32) -> usize {
    if bits < 0 { 1 } else { (bits.cast_unsigned() + 1).div_ceil(64) as usize }
}

const fn determinant(degree: i32, growth: i32, bound: f64) -> Determinant {
    Determinant { form: Form { degree, growth, integer_bits: BITS }, bound }
}

/// The turn of three points.
pub const ORIENT2D: Determinant = determinant(2, 1, bound::ORIENT2D);
/// The side of a point on a plane.
pub const ORIENT3D: Determinant = determinant(3, 3, bound::ORIENT3D);
/// The position of a point relative to a circle.
pub const INCIRCLE: Determinant = determinant(4, 4, bound::INCIRCLE);
/// The position of a point relative to a sphere.
pub const INSPHERE: Determinant = determinant(5, 7, bound::INSPHERE);

/// The largest b for differences of one and of two limbs.
pub const BITS: [i32; 2] = [62, 126];

// D is the number of limbs of a difference, D2 and so on those of products; the last is that of the determinant. A
// smaller number of limbs gives the right value modulo its range.

/// The sign of p × q.
#[inline(always)]
pub fn orient2d<const D: usize, const D2: usize>([p, q]: [[Fixed<D>; 2]; 2]) -> Sign {
    sign(cross::<D, D2>(p, q))
}

/// The sign of det(p, q, r).
#[inline(always)]
pub fn orient3d<const D: usize, const D2: usize, const D3: usize>(rows: [[Fixed<D>; 3]; 3]) -> Sign {
    let [p, q, r] = rows;
    sign(triple::<D, D2, D3>([[p[0], p[1]], [q[0], q[1]], [r[0], r[1]]], [p[2], q[2], r[2]]))
}

/// The sign of det(p, q, r), each with its squared length.
#[inline(always)]
pub fn incircle<const D: usize, const D2: usize, const D4: usize>(rows: [[Fixed<D>; 2]; 3]) -> Sign {
    let [p, q, r] = rows;
    sign(lifted::<D, D2, D4>(q, r, p).plus(lifted::<D, D2, D4>(r, p, q)).plus(lifted::<D, D2, D4>(p, q, r)))
}

/// The sign of det(p, q, r, s), each with its squared length.
#[inline(always)]
pub fn insphere<const D: usize, const D2: usize, const D3: usize, const D5: usize>(rows: [[Fixed<D>; 3]; 4]) -> Sign {
    let [[px, py, pz], [qx, qy, qz], [rx, ry, rz], [sx, sy, sz]] = rows;
    let [p, q, r, s] = [[px, py], [qx, qy], [rx, ry], [sx, sy]];
    let [pq, qr, rs] = [cross::<D, D2>(p, q), cross(q, r), cross(r, s)];
    let [sp, pr, qs] = [cross::<D, D2>(s, p), cross(p, r), cross(q, s)];
    let [a, b, c]: [Fixed<D3>; 3] = [qr.times(pz), pr.times(qz), pq.times(rz)];
    let pqr = a.minus(b).plus(c);
    let [a, b, c]: [Fixed<D3>; 3] = [rs.times(qz), qs.times(rz), qr.times(sz)];
    let qrs = a.minus(b).plus(c);
    let [a, b, c]: [Fixed<D3>; 3] = [sp.times(rz), pr.times(sz), rs.times(pz)];
    let rsp = a.plus(b).plus(c);
    let [a, b, c]: [Fixed<D3>; 3] = [pq.times(sz), qs.times(pz), sp.times(qz)];
    let spq = a.plus(b).plus(c);
    let [p, q, r, s] = rows;
    let [pl, ql, rl, sl]: [Fixed<D2>; 4] = [lift3(p), lift3(q), lift3(r), lift3(s)];
    let [a, b, c, d]: [Fixed<D5>; 4] = [pqr.times(sl), spq.times(rl), rsp.times(ql), qrs.times(pl)];
    sign(a.minus(b).plus(c.minus(d)))
}

#[inline(always)]
fn sign<const L: usize>(x: Fixed<L>) -> Sign {
    // A table: signs are as good as random, and a branch on them mispredicts every other time.
    const SIGNS: [Sign; 4] = [Sign::Zero, Sign::Positive, Sign::Negative, Sign::Negative];
    SIGNS[2 * usize::from(x.is_negative()) + usize::from(!x.is_zero())]
}

#[inline(always)]
fn cross<const D: usize, const D2: usize>([px, py]: [Fixed<D>; 2], [qx, qy]: [Fixed<D>; 2]) -> Fixed<D2> {
    let left: Fixed<D2> = px.times(qy);
    left.minus(py.times(qx))
}

/// The 3 × 3 determinant of flat rows and their heights.
#[inline(always)]
fn triple<const D: usize, const D2: usize, const D3: usize>(
    [p, q, r]: [[Fixed<D>; 2]; 3],
    [pz, qz, rz]: [Fixed<D>; 3],
) -> Fixed<D3> {
    let [qr, rp, pq]: [Fixed<D2>; 3] = [cross(q, r), cross(r, p), cross(p, q)];
    let [a, b, c]: [Fixed<D3>; 3] = [qr.times(pz), rp.times(qz), pq.times(rz)];
    a.plus(b).plus(c)
}

/// The minor of two rows, times the squared length of the third.
///
/// A function and not a closure: the compiler need not inline closures, and a call through memory costs a third.
#[inline(always)]
fn lifted<const D: usize, const D2: usize, const D4: usize>(
    a: [Fixed<D>; 2],
    b: [Fixed<D>; 2],
    c: [Fixed<D>; 2],
) -> Fixed<D4> {
    cross::<D, D2>(a, b).times(lift2::<D, D2>(c))
}

#[inline(always)]
fn lift2<const D: usize, const D2: usize>([x, y]: [Fixed<D>; 2]) -> Fixed<D2> {
    let square: Fixed<D2> = x.times(x);
    square.plus(y.times(y))
}

#[inline(always)]
fn lift3<const D: usize, const D2: usize>([x, y, z]: [Fixed<D>; 3]) -> Fixed<D2> {
    lift2::<D, D2>([x, y]).plus(z.times(z))
}
