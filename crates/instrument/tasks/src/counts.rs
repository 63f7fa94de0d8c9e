//! Counts of answers by class.

use predicament_predicates::Class;

/// The number of answers of each class.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct ClassCounts([u64; Class::ALL.len()]);

impl ClassCounts {
    /// The count of one class.
    #[must_use]
    pub const fn get(&self, class: Class) -> u64 {
        self.0[class as usize]
    }

    /// Adds `n` to the count of a class.
    pub const fn add(&mut self, class: Class, n: u64) {
        self.0[class as usize] += n;
    }

    /// Moves up to `n` from one class to another.
    pub fn reclassify(&mut self, from: Class, to: Class, n: u64) {
        let n = n.min(self.get(from));
        self.0[from as usize] -= n;
        self.add(to, n);
    }

    /// Adds all counts of another.
    pub fn merge(&mut self, other: &ClassCounts) {
        for (mine, theirs) in self.0.iter_mut().zip(other.0) {
            *mine += theirs;
        }
    }

    /// The sum over all classes that are findings.
    #[must_use]
    pub fn findings(&self) -> u64 {
        Class::ALL.iter().filter(|class| !class.is_legal()).map(|&class| self.get(class)).sum()
    }
}
