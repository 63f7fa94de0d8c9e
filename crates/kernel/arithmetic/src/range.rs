//! The exponents that a list of doubles spans.

use crate::Parts;

/// Where the bits of some non-zero doubles lie.
///
/// Every value x of the list is an integer multiple of 2^`lowest`, and
/// |x| < 2^`highest`. Both are tight: some value has a bit set at `lowest`, and
/// some |x| ≥ 2^(`highest` − 1). So `lowest` < `highest`, and for finite values
/// both lie within −1074 ..= 1024.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct ExponentRange {
    /// The exponent of the lowest bit that is set in any value.
    pub lowest: i32,
    /// The least e with |x| < 2^e for every value x.
    pub highest: i32,
}

impl ExponentRange {
    /// The range of all values that are not zero; none if there is none.
    ///
    /// Meant for finite values. Infinities and NaN count as if they were some
    /// number of 2^1024 or more, for which no [`Plan`](crate::Plan) proves
    /// anything.
    #[must_use]
    pub fn of<'a>(values: impl IntoIterator<Item = &'a f64>) -> Option<ExponentRange> {
        values.into_iter().filter_map(|&x| ExponentRange::of_one(x)).reduce(ExponentRange::and)
    }

    /// The range that covers both.
    #[must_use]
    pub fn and(self, other: ExponentRange) -> ExponentRange {
        ExponentRange { lowest: self.lowest.min(other.lowest), highest: self.highest.max(other.highest) }
    }

    #[inline]
    fn of_one(x: f64) -> Option<ExponentRange> {
        let parts = Parts::of_any(x);
        Some(ExponentRange { lowest: parts.lowest()?, highest: parts.highest()? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(values: &[f64]) -> (i32, i32) {
        let range = ExponentRange::of(values).unwrap();
        (range.lowest, range.highest)
    }

    #[test]
    fn known_values() {
        assert_eq!(ExponentRange::of(&[]), None);
        assert_eq!(ExponentRange::of(&[0.0, -0.0]), None);
        assert_eq!(range(&[1.0]), (0, 1));
        assert_eq!(range(&[0.0, -6.0]), (1, 3));
        assert_eq!(range(&[0.1]), (-55, -3));
        assert_eq!(range(&[5e-324]), (-1074, -1073));
        assert_eq!(range(&[f64::MIN_POSITIVE]), (-1022, -1021));
        assert_eq!(range(&[f64::MIN_POSITIVE.next_down()]), (-1074, -1022));
        assert_eq!(range(&[f64::MAX]), (971, 1024));
        assert_eq!(range(&[f64::MAX, 5e-324]), (-1074, 1024));
        assert_eq!(range(&[1.0, f64::INFINITY]).1, 1025);
        assert_eq!(range(&[f64::NAN]).1, 1025);
    }
}
