//! The checks of registered pairs that are reported.

use predicament_predicates::Dimension;

use predicament_tasks::{Check, Class};

macro_rules! with {
    ($($topology:expr),*) => {
        &[
            Check::new(Class::MissedZero, "contact", "a degenerate pair that meets is registered"),
            Check::new(Class::Overreach, "contact", "a degenerate pair that is registered meets"),
            Check::new(Class::SignFlip, "contact", "a pair of full dimension is registered if it crosses, and else not"),
            Check::new(Class::Overreach, "ended early", "a pair is not ended by faces that do not meet"),
            Check::new(Class::MissedZero, "not ended", "a pair is ended by faces that meet"),
            Check::new(Class::Inconsistent, "never degenerate", "where ties are broken no degenerate pair is registered"),
            Check::new(
                Class::SignFlip,
                "perturbed contact",
                "where ties are broken those pairs are registered that cross in the perturbed scene",
            ),
            Check::new(Class::Inconsistent, "argument order", "another order of a pair's vertices gives the same answer"),
            Check::new(Class::Overreach, "band", "with a band, no degenerate pair beyond T₊ is registered"),
            Check::new(Class::MissedZero, "band", "with a band, each degenerate pair up to T₋ is registered"),
            Check::new(Class::SignFlip, "band", "with a band, pairs of full dimension are registered if they cross, and else not"),
            Check::new(Class::MissedZero, "unguarded", "what a registered pair divides by is beyond its bound"),
            Check::new(Class::Inconsistent, "weights", "weights are between 0 and 1"),
            Check::new(Class::Nan, "weights", "weights are numbers"),
            Check::new(Class::Inconsistent, "unasked", "no pair is registered of which a sub-pair is"),
            Check::new(Class::Overreach, "unasked", "no pair is registered that is never near"),
            Check::new(Class::Overreach, "reading", "what is registered passes all tests of its algorithm at the published tolerances"),
            Check::new(Class::MissedZero, "reading", "what passes all tests of its algorithm at the published tolerances is registered"),
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
