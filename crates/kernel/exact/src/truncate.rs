//! Conversion of doubles with integer values to integers.
//!
//! A cast must also handle values out of range, so it takes several times as long as the conversion instruction.

#![allow(unsafe_code)]

/// The integer value of a double that is an integer less than 2^63 in magnitude.
///
/// For other doubles the result has no meaning.
#[inline(always)]
pub(crate) fn to_integer(x: f64) -> i64 {
    #[cfg(target_arch = "x86_64")]
    {
        use core::arch::x86_64::{_mm_cvttsd_si64, _mm_set_sd};
        // SAFETY: all processors of this target have SSE2; the operation is defined for all doubles.
        unsafe { _mm_cvttsd_si64(_mm_set_sd(x)) }
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        #[allow(clippy::cast_possible_truncation)] // an integer in range
        let integer = x as i64;
        integer
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_are_what_they_are() {
        for x in [0, 1, -1, 9_007_199_254_740_993, -(1 << 62), (1 << 62) + (1 << 20), i64::MIN] {
            #[allow(clippy::cast_precision_loss)] // rounded, but an integer
            let double = x as f64;
            assert_eq!(i128::from(to_integer(double)), predicament_arithmetic::units(double, 0));
        }
        assert_eq!(to_integer(-0.0), 0);
    }
}
