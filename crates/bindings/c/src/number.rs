//! Signs of points that are not in a scene, for each type of number of C.

use predicament_exact::raw::{self, NotFinite};
use predicament_predicates::Sign;

use crate::failure::predicament_result::{self, PREDICAMENT_NOT_FINITE};

/// A number that is a double without rounding.
pub(crate) trait Number: Copy {
    /// The same number as a double; NaN and infinities stay.
    fn double(self) -> f64;
}

impl Number for f64 {
    #[inline(always)]
    fn double(self) -> f64 {
        self
    }
}

impl Number for f32 {
    #[inline(always)]
    fn double(self) -> f64 {
        f64::from(self)
    }
}

impl Number for i32 {
    #[inline(always)]
    fn double(self) -> f64 {
        f64::from(self)
    }
}

impl From<NotFinite> for predicament_result {
    #[inline]
    fn from(_: NotFinite) -> predicament_result {
        PREDICAMENT_NOT_FINITE
    }
}

/// The order of two numbers.
#[inline(always)]
pub(crate) fn compare<T: Number>([[a], [b]]: [[T; 1]; 2]) -> Result<Sign, predicament_result> {
    let (a, b) = (a.double(), b.double());
    if !(a.is_finite() & b.is_finite()) {
        return Err(PREDICAMENT_NOT_FINITE);
    }
    const SIGNS: [Sign; 3] = [Sign::Negative, Sign::Zero, Sign::Positive];
    Ok(SIGNS[usize::from(a >= b) + usize::from(a > b)])
}

/// The sign of [`raw::orient2d`].
#[inline(always)]
pub(crate) fn orient2d<T: Number>(points: [[T; 2]; 3]) -> Result<Sign, predicament_result> {
    Ok(raw::try_orient2d(points.map(|point| point.map(T::double)))?)
}

/// The sign of [`raw::orient3d`].
#[inline(always)]
pub(crate) fn orient3d<T: Number>(points: [[T; 3]; 4]) -> Result<Sign, predicament_result> {
    Ok(raw::try_orient3d(points.map(|point| point.map(T::double)))?)
}

/// The sign of [`raw::incircle`].
#[inline(always)]
pub(crate) fn incircle<T: Number>(points: [[T; 2]; 4]) -> Result<Sign, predicament_result> {
    Ok(raw::try_incircle(points.map(|point| point.map(T::double)))?)
}

/// The sign of [`raw::insphere`].
#[inline(always)]
pub(crate) fn insphere<T: Number>(points: [[T; 3]; 5]) -> Result<Sign, predicament_result> {
    Ok(raw::try_insphere(points.map(|point| point.map(T::double)))?)
}

/// Predicates on integers of 64 bits, which are not doubles in general.
pub(crate) mod long {
    use predicament_exact::i64 as exact;
    use predicament_predicates::Sign;

    use crate::failure::predicament_result;

    /// The order of two integers.
    #[inline(always)]
    pub fn compare([[a], [b]]: [[i64; 1]; 2]) -> Result<Sign, predicament_result> {
        Ok(a.cmp(&b).into())
    }

    /// The sign of [`exact::orient2d`].
    #[inline(always)]
    pub fn orient2d([a, b, c]: [[i64; 2]; 3]) -> Result<Sign, predicament_result> {
        Ok(exact::orient2d(a, b, c))
    }

    /// The sign of [`exact::orient3d`].
    #[inline(always)]
    pub fn orient3d([a, b, c, d]: [[i64; 3]; 4]) -> Result<Sign, predicament_result> {
        Ok(exact::orient3d(a, b, c, d))
    }

    /// The sign of [`exact::incircle`].
    #[inline(always)]
    pub fn incircle([a, b, c, d]: [[i64; 2]; 4]) -> Result<Sign, predicament_result> {
        Ok(exact::incircle(a, b, c, d))
    }

    /// The sign of [`exact::insphere`].
    #[inline(always)]
    pub fn insphere([a, b, c, d, e]: [[i64; 3]; 5]) -> Result<Sign, predicament_result> {
        Ok(exact::insphere(a, b, c, d, e))
    }
}
