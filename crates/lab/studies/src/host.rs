//! The host of a study: where it reports progress and is told to stop.
//!
//! A study knows neither terminals nor signals: whoever starts it watches it.
//! The tool draws a progress bar and listens to Ctrl-C; a test does neither.

use std::sync::atomic::AtomicBool;

use predicament_tasks::Watch;

/// Follows a study while it measures, and can stop it.
pub trait Host {
    /// What the work looks at between its chunks, and reports to.
    fn watch(&self) -> &Watch<'_>;

    /// A part of the work begins: so many units, which are called so.
    fn begin(&self, total: u64, unit: &str) {
        let _ = (total, unit);
    }

    /// The study turns to this backend or algorithm.
    fn turn_to(&self, what: &str) {
        let _ = what;
    }
}

/// A host that shows no progress and never stops a study.
pub struct Quiet(Watch<'static>);

impl Quiet {
    /// A host for tests and for programs that wait.
    #[must_use]
    pub fn new() -> Quiet {
        static NEVER: AtomicBool = AtomicBool::new(false);
        Quiet(Watch::new(&NEVER, None, &|_| {}))
    }
}

impl Default for Quiet {
    fn default() -> Quiet {
        Quiet::new()
    }
}

impl Host for Quiet {
    fn watch(&self) -> &Watch<'_> {
        &self.0
    }
}
