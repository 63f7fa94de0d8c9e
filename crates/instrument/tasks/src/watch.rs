//! Interrupts, deadlines and progress of long work.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering::Relaxed};
use std::time::{Duration, Instant};

/// The reason why work stopped early.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stop {
    /// The user interrupted.
    Interrupted,
    /// The deadline passed.
    Timeout,
}

/// A flag, a deadline and a progress hook, checked between chunks of work from any thread.
pub struct Watch<'a> {
    cancel: &'a AtomicBool,
    deadline: Option<Instant>,
    progress: &'a (dyn Fn(u64) + Sync),
    /// The nanoseconds of [`Watch::shared`].
    shared: AtomicU64,
}

impl<'a> Watch<'a> {
    /// Watches a flag and a time limit that starts now; `progress` gets the amount of work done.
    #[must_use]
    pub fn new(cancel: &'a AtomicBool, limit: Option<Duration>, progress: &'a (dyn Fn(u64) + Sync)) -> Watch<'a> {
        let deadline = limit.map(|limit| Instant::now() + limit);
        Watch { cancel, deadline, progress, shared: AtomicU64::new(0) }
    }

    /// The same flag and progress hook with a restarted time limit.
    #[must_use]
    pub fn restarted(&self, limit: Option<Duration>) -> Watch<'a> {
        Watch::new(self.cancel, limit, self.progress)
    }

    /// Whether the work has a time limit.
    #[must_use]
    pub fn is_limited(&self) -> bool {
        self.deadline.is_some()
    }

    /// The wall time of verdicts that this work found for all backends: see [`Case::once`](crate::Case::once).
    #[must_use]
    pub fn shared(&self) -> Duration {
        Duration::from_nanos(self.shared.load(Relaxed))
    }

    /// Runs work for all backends, and adds its time to [`Watch::shared`].
    pub(crate) fn for_all<V>(&self, work: impl FnOnce() -> V) -> V {
        let (before, clock) = (self.shared(), Instant::now());
        let done = work();
        // Not a sum: what `work` itself does for all backends is in its own time.
        let time = (before + clock.elapsed()).as_nanos();
        self.shared.store(u64::try_from(time).unwrap_or(u64::MAX), Relaxed);
        done
    }

    /// Reports work done and checks for a stop.
    ///
    /// # Errors
    /// [`Stop`] with the reason.
    pub fn done(&self, work: u64) -> Result<(), Stop> {
        (self.progress)(work);
        if self.cancel.load(Relaxed) {
            Err(Stop::Interrupted)
        } else if self.deadline.is_some_and(|deadline| Instant::now() > deadline) {
            Err(Stop::Timeout)
        } else {
            Ok(())
        }
    }

    /// Runs a function that reports the number of items done so far, until the watch stops it.
    ///
    /// # Errors
    /// [`Stop`] with the reason, after it was asked to end.
    pub fn counted<T>(&self, all: impl FnOnce(&(dyn Fn(usize) -> bool + Sync)) -> T) -> Result<T, Stop> {
        let (before, stop) = (AtomicUsize::new(0), OnceLock::new());
        let made = all(&|done| {
            let news = done.saturating_sub(before.fetch_max(done, Relaxed));
            match self.done(news as u64) {
                Ok(()) => true,
                Err(why) => {
                    let _ = stop.set(why);
                    false
                }
            }
        });
        stop.get().map_or(Ok(made), |&why| Err(why))
    }
}
