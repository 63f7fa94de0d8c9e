//! The checks of registered pairs that are reported.

use predicament_predicates::Dimension;

use predicament_tasks::{Check, Class};

macro_rules! with {
    ($($topology:expr),*) => {
        &[
            Check::new(Class::MissedZero, "contact", "a degenerate pair that meets is registered"),
            Check::new(Class::Overreach, "contact", "a degenerate pair that is registered meets"),
            Check::new(Class::SignFlip, "contact", "a pair of full dimension is registered if and only if it crosses"),
            Check::new(Class::Overreach, "ended early", "a pair ends only if a pair of its faces meets"),
            Check::new(Class::MissedZero, "not ended", "a pair ends if a pair of its faces meets"),
            Check::new(
                Class::Inconsistent,
                "never degenerate",
                "if ties are broken, degenerate pairs are not registered",
            ),
            Check::new(
                Class::SignFlip,
                "perturbed contact",
                "if ties are broken, the registered pairs are the pairs that cross in the perturbed scene",
            ),
            Check::new(Class::Inconsistent, "argument order", "another order of a pair's vertices gives the same answer"),
            Check::new(Class::Overreach, "band", "with a band, degenerate pairs beyond T₊ are not registered"),
            Check::new(Class::MissedZero, "band", "with a band, each degenerate pair up to T₋ is registered"),
            Check::new(
                Class::SignFlip,
                "band",
                "with a band, a pair of full dimension is registered if and only if it crosses",
            ),
            Check::new(
                Class::MissedZero,
                "unguarded",
                "the guarded quantities of a registered pair (its divisors) exceed their bounds",
            ),
            Check::new(Class::Inconsistent, "weights", "weights are between 0 and 1"),
            Check::new(Class::Nan, "weights", "weights are numbers"),
            Check::new(Class::Inconsistent, "unasked", "a pair with a registered sub-pair is not registered"),
            Check::new(Class::Overreach, "unasked", "the boxes of a registered pair are near each other"),
            Check::new(
                Class::Overreach,
                "reading",
                "a registered pair passes all tests of its algorithm at the published tolerances",
            ),
            Check::new(
                Class::MissedZero,
                "reading",
                "a pair that passes all tests of its algorithm at the published tolerances is registered",
            ),
            $($topology),*
        ]
    };
}

const IN_PLANE: &[Check] =
    with![Check::topology("crossing parity", "merged closed curves cross an even number of times")];

const IN_SPACE: &[Check] = with![
    Check::topology("loose ends", "the intersection curves of closed surfaces have no ends"),
    Check::topology("signed piercings", "a closed curve pierces a closed surface as often inwards as outwards")
];

pub(super) fn checks(dimension: Dimension) -> &'static [Check] {
    match dimension {
        Dimension::Two => IN_PLANE,
        Dimension::Three => IN_SPACE,
    }
}
