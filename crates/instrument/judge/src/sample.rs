//! Samples: the part of a task that is judged when all of it would take too long.
//!
//! The judge's algorithms visit everything. For large inputs that is too slow, so every n-th item is judged. The rule
//! depends on sizes only: the same scene has the same sample on every machine, and a report can say how much was
//! judged.

/// Every n-th of a number of items, starting at the first.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Sample {
    of: usize,
    step: usize,
}

impl Sample {
    /// The sample of all items.
    #[must_use]
    pub const fn all(of: usize) -> Sample {
        Sample { of, step: 1 }
    }

    /// The sample of as many items as the budget allows at `cost` each, evenly spaced: at least one if there are any.
    #[must_use]
    pub fn within(budget: u64, of: usize, cost: u64) -> Sample {
        let afforded = usize::try_from(budget / cost.max(1)).unwrap_or(usize::MAX).max(1);
        Sample { of, step: of.div_ceil(afforded).max(1) }
    }

    /// The indices of the sampled items, ascending.
    pub fn places(self) -> impl ExactSizeIterator<Item = usize> + Clone {
        (0..self.of).step_by(self.step)
    }

    /// The number of sampled items.
    #[must_use]
    pub fn len(self) -> usize {
        self.of.div_ceil(self.step)
    }

    /// True if the sample is empty, because there are no items.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.of == 0
    }

    /// The number of items that the sample is taken from.
    #[must_use]
    pub fn of(self) -> usize {
        self.of
    }

    /// The distance between sampled items: 1 if all are judged.
    #[must_use]
    pub fn step(self) -> usize {
        self.step
    }

    /// True if every item is judged.
    #[must_use]
    pub fn is_all(self) -> bool {
        self.step == 1
    }

    /// True if the item at this index is judged.
    #[must_use]
    pub fn has(self, place: usize) -> bool {
        place < self.of && place.is_multiple_of(self.step)
    }
}

impl std::fmt::Display for Sample {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.is_all() {
            write!(f, "all {}", self.of)
        } else {
            write!(f, "{} of {}, every {}th", self.len(), self.of, self.step)
        }
    }
}
