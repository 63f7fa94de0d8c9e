//! Delta debugging of anything that has a size: each smaller candidate that shows the finding replaces the best one.
//!
//! Only smaller candidates are evaluated, so a descent ends, whatever is tried.

use super::End;

/// The number of candidates evaluated, and its limit.
#[derive(Clone, Copy, Debug)]
pub struct Evaluations {
    /// The number of candidates evaluated.
    pub made: u64,
    /// The maximum number of candidates.
    pub most: u64,
}

impl Evaluations {
    /// Counts one evaluation of a candidate.
    ///
    /// # Errors
    /// [`End::Evaluations`] if the maximum is reached.
    pub fn count(&mut self) -> Result<(), End> {
        if self.made >= self.most {
            return Err(End::Evaluations);
        }
        self.made += 1;
        Ok(())
    }
}

/// A function that returns true if a candidate shows the finding. It counts the candidate before the evaluation.
pub type Shows<'s, S> = dyn FnMut(&S, &mut Evaluations) -> Result<bool, End> + 's;

/// A search for the smallest candidate that shows a finding.
pub struct Descent<'s, S, K> {
    /// The smallest candidate so far that shows the finding.
    pub best: S,
    /// The size of the best candidate.
    pub size: K,
    /// The number of candidates that replaced the best one.
    pub taken: u64,
    /// The count of evaluated candidates.
    pub evaluations: Evaluations,
    size_of: fn(&S) -> K,
    shows: &'s mut Shows<'s, S>,
}

impl<'s, S, K: Ord> Descent<'s, S, K> {
    /// Starts a search from a candidate that shows the finding.
    pub fn new(start: S, size_of: fn(&S) -> K, evaluations: Evaluations, shows: &'s mut Shows<'s, S>) -> Self {
        Descent { size: size_of(&start), best: start, taken: 0, evaluations, size_of, shows }
    }

    /// Tries a candidate: if it is smaller and shows the finding, it replaces the best one, and the result is true.
    ///
    /// # Errors
    /// The reason why the search ends.
    pub fn try_one(&mut self, candidate: S) -> Result<bool, End> {
        let size = (self.size_of)(&candidate);
        if size >= self.size || !(self.shows)(&candidate, &mut self.evaluations)? {
            return Ok(false);
        }
        (self.best, self.size) = (candidate, size);
        self.taken += 1;
        Ok(true)
    }

    /// Tries candidates until one replaces the best one; then the result is true.
    ///
    /// # Errors
    /// The reason why the search ends.
    pub fn try_each(&mut self, candidates: impl IntoIterator<Item = S>) -> Result<bool, End> {
        for candidate in candidates {
            if self.try_one(candidate)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Removes as many of `n` pieces as it can: by halves first, then by smaller and smaller chunks, from the last
    /// piece to the first, until no single piece can be removed.
    ///
    /// `without` returns the best candidate with only the marked pieces.
    ///
    /// # Errors
    /// The reason why the search ends.
    pub fn leave_out(
        &mut self,
        mut n: usize,
        without: &dyn Fn(&S, &[bool]) -> S,
        count: &dyn Fn(&S) -> usize,
    ) -> Result<(), End> {
        let mut chunk = n;
        while chunk > 0 && n > 0 {
            let mut end = n;
            let mut changed = false;
            while end > 0 {
                let start = end.saturating_sub(chunk);
                let keep: Vec<bool> = (0..n).map(|at| !(start..end).contains(&at)).collect();
                if self.try_one(without(&self.best, &keep))? {
                    changed = true;
                    // The removal may have taken other pieces with it.
                    n = count(&self.best);
                    end = start.min(n);
                } else {
                    end = start;
                }
            }
            if !(changed && chunk == 1) {
                chunk = if chunk > n { n } else { chunk / 2 };
            }
        }
        Ok(())
    }
}
