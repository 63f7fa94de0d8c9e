//! A difference that is rounded up: for lengths that have to bound others.

use crate::exact_tail;

/// |a − b|, rounded up; infinite where no double is large enough.
///
/// What was rounded off a difference is a double, and Knuth's two-sum finds
/// it; it is lost only if the difference itself overflows.
#[must_use]
pub fn difference_up(a: f64, b: f64) -> f64 {
    let difference = (a - b).abs();
    // (Where the difference overflows, the tail is no number.)
    if exact_tail(a.max(b), a.min(b), difference) > 0.0 { difference.next_up() } else { difference }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_differences_stay_and_others_go_up() {
        assert_eq!(difference_up(3.0, -1.0), 4.0);
        assert_eq!(difference_up(-1.0, 3.0), 4.0);
        assert_eq!(difference_up(1.0, -2.0_f64.powi(-53)), 1.0_f64.next_up());
        assert_eq!(difference_up(1.0, 2.0_f64.powi(-60)), 1.0);
        assert_eq!(difference_up(f64::MAX, -f64::MAX), f64::INFINITY);
        assert_eq!(difference_up(f64::MAX, -1.0), f64::INFINITY);
        assert_eq!(difference_up(5e-324, -5e-324), 1e-323);
    }
}
