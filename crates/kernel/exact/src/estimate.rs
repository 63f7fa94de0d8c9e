//! Determinants in plain floating point, each with its permanent.
//!
//! The permanent is the same sum with the magnitude of every term. It measures how much a determinant can cancel, and
//! how far rounding can move it.
//!
//! [`Estimate::certain`] is the semi-static filter. With the constant of [`bound`](predicament_arithmetic::bound) it is
//! a proof, *provided that nothing underflows or overflows*: callers hold a
//! [`Plan`](predicament_arithmetic::Plan). With a bound of zero the sign of the determinant is the answer, which is
//! right if all intermediates are exact. The bound is an argument so that a test can run a filter with a wrong one.
//!
//! The formulas are written over any [`Number`]: a proof reads them on symbols, and a test tries all inputs of tiny
//! formats.

use predicament_arithmetic::{Number, Sign};

/// A determinant and its permanent, computed in plain floating point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Estimate<T = f64> {
    /// The determinant.
    pub determinant: T,
    /// The permanent; [`orient2d`] defines it differently.
    pub permanent: T,
}

impl Estimate {
    /// The sign of the determinant if its magnitude is at least `bound` times the permanent.
    ///
    /// `None` otherwise, and if the bound is NaN.
    #[inline(always)]
    #[must_use]
    pub fn certain(self, bound: f64) -> Option<Sign> {
        self.above(bound * self.permanent)
    }

    /// The sign of the determinant if its magnitude is at least `bound`.
    ///
    /// `None` otherwise, and if the bound is NaN.
    #[inline(always)]
    #[must_use]
    pub fn above(self, bound: f64) -> Option<Sign> {
        // A table lookup by the bits: signs are as good as random, and a branch on them mispredicts every other time.
        const SIGNS: [Sign; 4] = [Sign::Positive, Sign::Negative, Sign::Zero, Sign::Zero];
        let is_zero = self.determinant.to_bits() << 1 == 0;
        let sign = SIGNS[usize::from(self.determinant.is_sign_negative()) + 2 * usize::from(is_zero)];
        (self.determinant.abs() >= bound).then_some(sign)
    }
}

/// The estimate of (a − c) × (b − c) = l − r, with |l + r| in place of the permanent |l| + |r|.
///
/// The two differ if l and r have opposite signs, but then no rounding can change the sign of l − r (Ozaki, Bünger,
/// Ogita, Oishi and Rump 2016).
#[inline(always)]
#[must_use]
pub fn orient2d<T: Number>(a: [T; 2], b: [T; 2], c: [T; 2]) -> Estimate<T> {
    let [acx, acy] = minus2(a, c);
    let [bcx, bcy] = minus2(b, c);
    let left = acx * bcy;
    let right = acy * bcx;
    Estimate { determinant: left - right, permanent: (left + right).abs() }
}

/// The estimate of det(a − d, b − d, c − d).
#[inline(always)]
#[must_use]
pub fn orient3d<T: Number>(a: [T; 3], b: [T; 3], c: [T; 3], d: [T; 3]) -> Estimate<T> {
    orient3d_sized(a, b, c, d).0
}

/// The result of [`orient3d`], and the sum of the magnitudes of the last coordinates' differences.
#[inline(always)]
pub(crate) fn orient3d_sized<T: Number>(a: [T; 3], b: [T; 3], c: [T; 3], d: [T; 3]) -> (Estimate<T>, T) {
    let [adx, ady, adz] = minus3(a, d);
    let [bdx, bdy, bdz] = minus3(b, d);
    let [cdx, cdy, cdz] = minus3(c, d);
    let bc = Minor::new(bdx, bdy, cdx, cdy);
    let ca = Minor::new(cdx, cdy, adx, ady);
    let ab = Minor::new(adx, ady, bdx, bdy);
    let determinant = adz * bc.value + bdz * ca.value + cdz * ab.value;
    let [adz, bdz, cdz] = [adz.abs(), bdz.abs(), cdz.abs()];
    let permanent = adz * bc.permanent + bdz * ca.permanent + cdz * ab.permanent;
    (Estimate { determinant, permanent }, adz + bdz + cdz)
}

/// The estimate of the 3 × 3 determinant of a − d, b − d, c − d, each with its squared length.
#[inline(always)]
#[must_use]
pub fn incircle<T: Number>(a: [T; 2], b: [T; 2], c: [T; 2], d: [T; 2]) -> Estimate<T> {
    incircle_sized(a, b, c, d).0
}

/// The result of [`incircle`], and the sum of the squared lengths of the differences.
#[inline(always)]
pub(crate) fn incircle_sized<T: Number>(a: [T; 2], b: [T; 2], c: [T; 2], d: [T; 2]) -> (Estimate<T>, T) {
    let [adx, ady] = minus2(a, d);
    let [bdx, bdy] = minus2(b, d);
    let [cdx, cdy] = minus2(c, d);
    let bc = Minor::new(bdx, bdy, cdx, cdy);
    let ca = Minor::new(cdx, cdy, adx, ady);
    let ab = Minor::new(adx, ady, bdx, bdy);
    let a_lift = adx * adx + ady * ady;
    let b_lift = bdx * bdx + bdy * bdy;
    let c_lift = cdx * cdx + cdy * cdy;
    let estimate = Estimate {
        determinant: a_lift * bc.value + b_lift * ca.value + c_lift * ab.value,
        permanent: a_lift * bc.permanent + b_lift * ca.permanent + c_lift * ab.permanent,
    };
    (estimate, a_lift + b_lift + c_lift)
}

/// The estimate of the 4 × 4 determinant of a − e, b − e, c − e, d − e, each with its squared length.
#[inline(always)]
#[must_use]
pub fn insphere<T: Number>(a: [T; 3], b: [T; 3], c: [T; 3], d: [T; 3], e: [T; 3]) -> Estimate<T> {
    insphere_sized(a, b, c, d, e).0
}

/// The result of [`insphere`], the sum of the magnitudes of the last coordinates' differences, and the sum of the
/// squared lengths of the differences.
#[inline(always)]
pub(crate) fn insphere_sized<T: Number>(
    a: [T; 3],
    b: [T; 3],
    c: [T; 3],
    d: [T; 3],
    e: [T; 3],
) -> (Estimate<T>, [T; 2]) {
    let a = minus3(a, e);
    let b = minus3(b, e);
    let c = minus3(c, e);
    let d = minus3(d, e);
    let [ab, bc, cd] = [Minor::xy(a, b), Minor::xy(b, c), Minor::xy(c, d)];
    let [da, ac, bd] = [Minor::xy(d, a), Minor::xy(a, c), Minor::xy(b, d)];
    let [az, bz, cz, dz] = [a[2], b[2], c[2], d[2]];
    let [al, bl, cl, dl] = [lift3(a), lift3(b), lift3(c), lift3(d)];

    let abc = az * bc.value - bz * ac.value + cz * ab.value;
    let bcd = bz * cd.value - cz * bd.value + dz * bc.value;
    let cda = cz * da.value + dz * ac.value + az * cd.value;
    let dab = dz * ab.value + az * bd.value + bz * da.value;
    let determinant = (dl * abc - cl * dab) + (bl * cda - al * bcd);

    let [az, bz, cz, dz] = [az.abs(), bz.abs(), cz.abs(), dz.abs()];
    let abc = az * bc.permanent + bz * ac.permanent + cz * ab.permanent;
    let bcd = bz * cd.permanent + cz * bd.permanent + dz * bc.permanent;
    let cda = cz * da.permanent + dz * ac.permanent + az * cd.permanent;
    let dab = dz * ab.permanent + az * bd.permanent + bz * da.permanent;
    let permanent = (dl * abc + cl * dab) + (bl * cda + al * bcd);
    (Estimate { determinant, permanent }, [(az + bz) + (cz + dz), (al + bl) + (cl + dl)])
}

/// A 2 × 2 determinant, and its permanent.
#[derive(Clone, Copy)]
struct Minor<T> {
    value: T,
    permanent: T,
}

impl<T: Number> Minor<T> {
    #[inline(always)]
    fn new(px: T, py: T, qx: T, qy: T) -> Minor<T> {
        let left = px * qy;
        let right = qx * py;
        Minor { value: left - right, permanent: left.abs() + right.abs() }
    }

    #[inline(always)]
    fn xy(p: [T; 3], q: [T; 3]) -> Minor<T> {
        Minor::new(p[0], p[1], q[0], q[1])
    }
}

#[inline(always)]
fn minus2<T: Number>(p: [T; 2], q: [T; 2]) -> [T; 2] {
    [p[0] - q[0], p[1] - q[1]]
}

#[inline(always)]
fn minus3<T: Number>(p: [T; 3], q: [T; 3]) -> [T; 3] {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

#[inline(always)]
fn lift3<T: Number>([x, y, z]: [T; 3]) -> T {
    x * x + y * y + z * z
}
