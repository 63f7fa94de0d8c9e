//! Delta debugging of anything that has a size: each smaller candidate that shows the finding replaces the best one.
//!
//! A candidate that is not smaller is never looked at, so a descent ends, whatever is tried.

use super::End;

/// The candidates that were looked at, and how many may be.
#[derive(Clone, Copy, Debug)]
pub struct Evaluations {
    /// Candidates that were looked at.
    pub made: u64,
    /// Candidates that may be looked at.
    pub most: u64,
}

impl Evaluations {
    /// Counts a candidate that is looked at.
    ///
    /// # Errors
    /// [`End::Evaluations`] if no more may be looked at.
    pub fn count(&mut self) -> Result<(), End> {
        if self.made >= self.most {
            return Err(End::Evaluations);
        }
        self.made += 1;
        Ok(())
    }
}

/// Says whether a candidate shows the finding. It counts the candidate before it looks.
pub type Shows<'s, S> = dyn FnMut(&S, &mut Evaluations) -> Result<bool, End> + 's;

/// A search for the smallest candidate that shows a finding.
pub struct Descent<'s, S, K> {
    /// The smallest candidate so far that shows the finding.
    pub best: S,
    /// The size of the best candidate.
    pub size: K,
    /// How many candidates replaced the best one.
    pub taken: u64,
    /// The candidates that were looked at.
    pub evaluations: Evaluations,
    size_of: fn(&S) -> K,
    shows: &'s mut Shows<'s, S>,
}

impl<'s, S, K: Ord> Descent<'s, S, K> {
    /// A search that starts from a candidate that shows the finding.
    pub fn new(start: S, size_of: fn(&S) -> K, evaluations: Evaluations, shows: &'s mut Shows<'s, S>) -> Self {
        Descent { size: size_of(&start), best: start, taken: 0, evaluations, size_of, shows }
    }

    /// Whether a candidate is smaller and shows the finding. Then it replaces the best one.
    ///
    /// # Errors
    /// Why the search ends.
    pub fn try_one(&mut self, candidate: S) -> Result<bool, End> {
        let size = (self.size_of)(&candidate);
        if size >= self.size || !(self.shows)(&candidate, &mut self.evaluations)? {
            return Ok(false);
        }
        (self.best, self.size) = (candidate, size);
        self.taken += 1;
        Ok(true)
    }

    /// Whether one of these candidates replaces the best one; those after it are not tried.
    ///
    /// # Errors
    /// Why the search ends.
    pub fn try_each(&mut self, candidates: impl IntoIterator<Item = S>) -> Result<bool, End> {
        for candidate in candidates {
            if self.try_one(candidate)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Leaves out of `n` pieces as many as it can: by halves first, then by smaller and smaller chunks, from the last piece to the
    /// first, until no single one can go.
    ///
    /// `without` is the best candidate with only the pieces that are marked.
    ///
    /// # Errors
    /// Why the search ends.
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
                    // What went may have taken others with it.
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
