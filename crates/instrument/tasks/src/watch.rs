//! Interrupts, deadlines and progress of long work.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
use std::time::{Duration, Instant};

/// Why work stopped early.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stop {
    /// The user interrupted.
    Interrupted,
    /// The deadline passed.
    Timeout,
}

/// A flag, a deadline and a progress hook, looked at between chunks of work from any thread.
pub struct Watch<'a> {
    cancel: &'a AtomicBool,
    deadline: Option<Instant>,
    progress: &'a (dyn Fn(u64) + Sync),
}

impl<'a> Watch<'a> {
    /// Watches a flag and a time limit that starts now; `progress` is told of work as it gets done.
    #[must_use]
    pub fn new(cancel: &'a AtomicBool, limit: Option<Duration>, progress: &'a (dyn Fn(u64) + Sync)) -> Watch<'a> {
        Watch { cancel, deadline: limit.map(|limit| Instant::now() + limit), progress }
    }

    /// The same flag and progress with the time limit started again.
    #[must_use]
    pub fn restarted(&self, limit: Option<Duration>) -> Watch<'a> {
        Watch::new(self.cancel, limit, self.progress)
    }

    /// Reports work done and asks whether to go on.
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

    /// Runs something that tells how many items it has done so far, as long as the watch lets it.
    ///
    /// # Errors
    /// [`Stop`] with the reason, once it was told to end.
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
