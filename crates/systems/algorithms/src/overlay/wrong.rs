//! The faults of a run, as values: the algorithm is compiled once.

use super::planted::Planted;

/// What a run does wrong: nothing, where no fault is planted.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Wrong {
    pub boxes_are_open: bool,
    pub forgets_touches: bool,
    pub leaves_unsorted: bool,
    pub counts_once: bool,
    pub nests_outside: bool,
    pub drops_holes: bool,
}

impl Wrong {
    pub fn of<F: Planted>() -> Wrong {
        Wrong {
            boxes_are_open: F::BOXES_ARE_OPEN,
            forgets_touches: F::FORGETS_TOUCHES,
            leaves_unsorted: F::LEAVES_UNSORTED,
            counts_once: F::COUNTS_ONCE,
            nests_outside: F::NESTS_OUTSIDE,
            drops_holes: F::DROPS_HOLES,
        }
    }
}
