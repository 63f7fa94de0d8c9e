//! Counts of the queries that each stage settled, at no cost if they are off.
//!
//! A session is generic over a [`Tally`]. [`Off`] is a zero-sized type whose calls compile to nothing; a `&Counts`
//! counts. Each thread counts in its own row, with plain loads and stores, so counting costs about as much as an
//! increment. Only threads after the [`ROWS`]th share a row and pay for atomic operations.

use alloc::{boxed::Box, vec::Vec};
use core::sync::atomic::{AtomicU64, Ordering::Relaxed};

use crate::PredicateKind;

/// The maximum number of stages of a backend.
pub const MAX_STAGES: usize = 64;
/// The number of threads that count without sharing a row.
pub const ROWS: usize = 64;
const KINDS: usize = PredicateKind::COUNT;

/// A listener that counts which stage settled each query.
pub trait Tally: Send + Sync {
    /// True if counts are kept: stages are counted only when a tally listens.
    const LISTENS: bool = true;

    /// Counts one query of this kind, settled by the stage with this index in
    /// [`Backend::stages`](crate::Backend::stages).
    #[inline(always)]
    fn settled(&self, kind: PredicateKind, stage: usize) {
        self.settled_many(kind, stage, 1);
    }

    /// The counts behind the tally, if it counts, for backends behind pointers, which are not generic.
    fn counts<'c>(self) -> Option<&'c Counts>
    where
        Self: Sized + 'c;

    /// Counts `count` queries of this kind, settled by this stage.
    fn settled_many(&self, kind: PredicateKind, stage: usize, count: u64);
}

/// A tally that counts nothing, at no cost.
#[derive(Clone, Copy, Default, Debug)]
pub struct Off;

impl Tally for Off {
    const LISTENS: bool = false;

    fn counts<'c>(self) -> Option<&'c Counts>
    where
        Self: 'c,
    {
        None
    }

    #[inline(always)]
    fn settled_many(&self, _: PredicateKind, _: usize, _: u64) {}
}

#[repr(align(128))]
struct Row([[AtomicU64; MAX_STAGES]; KINDS]);

/// Counts per predicate and stage, summed over threads when read.
pub struct Counts {
    rows: Box<[Row; ROWS]>,
}

impl Counts {
    /// New counts, all zero.
    #[must_use]
    pub fn new() -> Counts {
        let row = |_| Row([const { [const { AtomicU64::new(0) }; MAX_STAGES] }; KINDS]);
        let rows: Vec<Row> = (0..ROWS).map(row).collect();
        Counts { rows: rows.try_into().unwrap_or_else(|_| unreachable!("so many rows")) }
    }

    /// The number of queries of this kind that the stage settled.
    ///
    /// It is exact once the threads that counted have been joined.
    #[must_use]
    pub fn get(&self, kind: PredicateKind, stage: usize) -> u64 {
        self.rows.iter().map(|row| row.0[kind.index()][stage].load(Relaxed)).sum()
    }
}

impl Default for Counts {
    fn default() -> Counts {
        Counts::new()
    }
}

impl core::fmt::Debug for Counts {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut map = f.debug_map();
        for kind in PredicateKind::ALL {
            for stage in 0..MAX_STAGES {
                let count = self.get(kind, stage);
                if count > 0 {
                    map.entry(&(kind.name(), stage), &count);
                }
            }
        }
        map.finish()
    }
}

/// The rows of threads.
#[cfg(feature = "std")]
mod row {
    use core::cell::Cell;
    use core::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    thread_local!(static ME: Cell<usize> = const { Cell::new(usize::MAX) });

    /// The index of the thread's row, if the thread has counted before.
    #[inline(always)]
    pub(super) fn known() -> usize {
        ME.get()
    }

    /// The index of the thread's own row; threads beyond the limit share the last row.
    pub(super) fn first_count() -> usize {
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        if ME.get() == usize::MAX {
            ME.set(NEXT.fetch_add(1, Relaxed).min(super::ROWS - 1));
        }
        ME.get()
    }
}

/// The row of all threads, where threads cannot be told apart.
#[cfg(not(feature = "std"))]
mod row {
    #[inline(always)]
    pub(super) fn known() -> usize {
        super::ROWS - 1
    }

    pub(super) fn first_count() -> usize {
        super::ROWS - 1
    }
}

impl Tally for &Counts {
    fn counts<'c>(self) -> Option<&'c Counts>
    where
        Self: 'c,
    {
        Some(self)
    }

    #[inline(always)]
    fn settled_many(&self, kind: PredicateKind, stage: usize, count: u64) {
        let me = row::known();
        if me < ROWS - 1 {
            let cell = &self.rows[me].0[kind.index()][stage];
            cell.store(cell.load(Relaxed) + count, Relaxed);
        } else {
            self.settled_elsewhere(kind, stage, count);
        }
    }
}

impl Counts {
    #[cold]
    #[inline(never)]
    fn settled_elsewhere(&self, kind: PredicateKind, stage: usize, count: u64) {
        // (The last row is shared.)
        self.rows[row::first_count()].0[kind.index()][stage].fetch_add(count, Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_from_more_threads_than_rows_add_up() {
        let counts = Counts::new();
        std::thread::scope(|scope| {
            for _ in 0..(2 * ROWS) {
                scope.spawn(|| {
                    let tally = &counts;
                    for _ in 0..1000 {
                        tally.settled(PredicateKind::Incircle, 3);
                    }
                });
            }
        });
        assert_eq!(counts.get(PredicateKind::Incircle, 3), 2 * ROWS as u64 * 1000);
        assert_eq!(counts.get(PredicateKind::Incircle, 2), 0);
    }
}
