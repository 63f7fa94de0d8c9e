//! The smallest files on which a command still fails: delta debugging of polygons, point sets and meshes.
//!
//! The command alone judges a candidate (Zeller and Hildebrandt, Simplifying and isolating failure-inducing input,
//! 2002; Regehr et al., Test-case reduction for C compiler bugs, 2012). So a candidate need not be a valid mesh or
//! polygon; only files without items are not tried. Candidates are tried in batches, in parallel. The first success in
//! their order is taken, so the result does not depend on the number of threads.

mod cuts;
mod numbers;
mod read;
mod sketch;
mod write;

use std::collections::HashMap;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use sha2::{Digest as _, Sha256};

use cuts::{Count, Without};
pub use sketch::{Counts, Sketch, counts};

/// The digest of all files of a candidate.
pub type Digest = [u8; 32];

/// The maximum number of coordinates that are shortened one at a time.
pub const MOST_SINGLE: usize = 300;

/// The removals, in their order.
const CUTS: [(Count, Without); 7] = [
    (cuts::parts, cuts::without_parts),
    (cuts::items, cuts::without_items),
    (cuts::loops, cuts::without_loops),
    (cuts::points, cuts::without_points),
    (cuts::mergeable, cuts::MERGED[0]),
    (cuts::mergeable, cuts::MERGED[1]),
    (cuts::mergeable, cuts::MERGED[2]),
];

/// The reason why shrinking files ends early.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Halt {
    /// It was interrupted.
    Interrupted,
    /// The command can't be run, or a result can't be saved.
    Error(String),
}

/// A command that fails on files, and the record of its runs.
pub trait Command: Sync {
    /// Runs the command on files; returns true if it fails, and `None` if the run was ended because it became moot.
    ///
    /// # Errors
    /// [`Halt`] if the command can't be run, or the search is interrupted.
    fn fails(&self, files: &[Vec<u8>], is_moot: &(dyn Fn() -> bool + Sync)) -> Result<Option<bool>, Halt>;

    /// Records the result of a run.
    ///
    /// # Errors
    /// [`Halt`] if the record can't be written.
    fn record(&self, digest: &Digest, fails: bool) -> Result<(), Halt>;

    /// Saves smaller files on which the command fails.
    ///
    /// # Errors
    /// [`Halt`] if the files can't be written.
    fn kept(&self, files: &[Vec<u8>], sizes: Counts) -> Result<(), Halt>;
}

/// The digest of files in their order.
#[must_use]
pub fn digest(files: &[Vec<u8>]) -> Digest {
    let mut hasher = Sha256::new();
    for file in files {
        hasher.update(file.len().to_le_bytes());
        hasher.update(file);
    }
    hasher.finalize().into()
}

/// A search for the smallest files on which a command fails.
pub struct Search<'c> {
    /// The smallest files so far.
    pub best: Vec<Sketch>,
    sizes: Counts,
    command: &'c dyn Command,
    /// The results of all runs. Candidates among them are not run again, so a search that was ended can be repeated.
    known: HashMap<Digest, bool>,
}

impl<'c> Search<'c> {
    /// Starts a search from files on which the command fails, with the results of an earlier search.
    #[must_use]
    pub fn new(best: Vec<Sketch>, command: &'c dyn Command, known: HashMap<Digest, bool>) -> Search<'c> {
        Search { sizes: counts(&best), best, command, known }
    }

    /// Repeats all removals and simplifications until nothing changes: components, items, loops, points, neighbours,
    /// coordinates.
    ///
    /// # Errors
    /// [`Halt`] if the search ends early; `best` has the smallest files so far.
    pub fn run(&mut self) -> Result<(), Halt> {
        loop {
            let before = self.sizes;
            self.leave_out()?;
            self.shorten()?;
            if self.sizes == before {
                return Ok(());
            }
        }
    }

    /// Removes as many pieces as it can, by halves, then by smaller and smaller chunks, until no single piece can be
    /// removed. All kinds of pieces are tried at one size of chunks before the next: no face of a closed mesh can be
    /// removed, so its points have to become few before single faces are tried.
    fn leave_out(&mut self) -> Result<(), Halt> {
        let mut parts = 2;
        loop {
            let (mut is_finest, mut has_changed) = (true, false);
            for (count, without) in CUTS {
                let chunk = count(&self.best).div_ceil(parts);
                is_finest &= chunk <= 1;
                has_changed |= chunk > 0 && self.sweep(count, without, chunk)?;
            }
            if is_finest && !has_changed {
                return Ok(());
            }
            parts *= if is_finest { 1 } else { 2 };
        }
    }

    /// Tries to remove each chunk of pieces, from the last to the first; true if it has removed one.
    fn sweep(&mut self, count: Count, without: Without, chunk: usize) -> Result<bool, Halt> {
        let mut end = count(&self.best);
        let mut has_changed = false;
        while end > 0 {
            let best = self.best.clone();
            let range = |at: usize| -> Option<Range<usize>> {
                let end = end.checked_sub(at * chunk).filter(|&end| end > 0)?;
                Some(end.saturating_sub(chunk)..end)
            };
            let candidates = (0..).map_while(range).map(|range| without(&best, &range));
            let Some(taken) = self.first(candidates)? else { break };
            has_changed = true;
            let start = range(taken).map_or(0, |range| range.start);
            end = start.min(count(&self.best));
        }
        Ok(has_changed)
    }

    /// Makes coordinates shorter: all at once, by column, then each.
    fn shorten(&mut self) -> Result<(), Halt> {
        sketch::compact(&mut self.best);
        let columns = numbers::columns(&self.best);
        for column in std::iter::once(None).chain((0..columns).map(Some)) {
            let best = self.best.clone();
            self.first(numbers::shorter(&best, column))?;
        }
        let places = numbers::places(&self.best);
        if places.len() * columns > MOST_SINGLE {
            return Ok(());
        }
        for place in places {
            for column in 0..columns {
                let best = self.best.clone();
                self.first(numbers::one_shorter(&best, place, column).into_iter())?;
            }
        }
        Ok(())
    }

    /// True if there were too many coordinates to shorten each.
    #[must_use]
    pub fn has_long_coordinates(&self) -> bool {
        numbers::places(&self.best).len() * numbers::columns(&self.best) > MOST_SINGLE
    }

    /// Takes the first smaller candidate on which the command fails, and returns its number.
    fn first(&mut self, candidates: impl Iterator<Item = Vec<Sketch>>) -> Result<Option<usize>, Halt> {
        let size = |sizes: Counts| (sizes.pieces, sizes.digits);
        let before = size(self.sizes);
        let is_whole = |files: &[Sketch]| files.iter().all(|file| !file.items.is_empty());
        let mut candidates =
            candidates.enumerate().filter(|(_, files)| is_whole(files) && size(counts(files)) < before);
        loop {
            let batch: Vec<(usize, Vec<Sketch>)> = candidates.by_ref().take(rayon::current_num_threads()).collect();
            if batch.is_empty() {
                return Ok(None);
            }
            let success = AtomicUsize::new(usize::MAX);
            let one = |(number, files): &(usize, Vec<Sketch>)| {
                let written: Vec<Vec<u8>> = files.iter().map(Sketch::written).collect();
                let digest = digest(&written);
                let known = self.known.get(&digest).copied();
                let fails = match known {
                    Some(fails) => Ok(Some(fails)),
                    None => self.command.fails(&written, &|| success.load(Ordering::Relaxed) < *number),
                };
                if fails == Ok(Some(true)) {
                    success.fetch_min(*number, Ordering::Relaxed);
                }
                (digest, known.is_none(), fails, written)
            };
            let results: Vec<_> = batch.par_iter().with_max_len(1).map(one).collect();
            for (digest, is_new, fails, _) in &results {
                if let (true, Ok(Some(fails))) = (is_new, fails) {
                    self.command.record(digest, *fails)?;
                    self.known.insert(*digest, *fails);
                }
            }
            for ((number, files), (_, _, fails, written)) in batch.into_iter().zip(results) {
                if fails? == Some(true) {
                    self.sizes = counts(&files);
                    self.best = files;
                    if self.best.iter().any(|file| file.points.len() > 2 * self.sizes.points) {
                        sketch::compact(&mut self.best);
                    }
                    self.command.kept(&written, self.sizes)?;
                    return Ok(Some(number));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
