//! The host of a study: where it reports progress and is told to stop.
//!
//! A study knows neither terminals nor signals: whoever starts it watches it.
//! The tool draws a progress bar and listens to Ctrl-C; a test does neither.

use std::sync::atomic::AtomicBool;

use predicament_tasks::{AnyTask, Contestant, Watch};

use crate::Error;

/// Follows a study while it measures, and can stop it.
pub trait Host {
    /// What the work looks at between its chunks, and reports to.
    fn watch(&self) -> &Watch<'_>;

    /// The tasks that there are, for a study that goes through them.
    fn tasks(&self) -> &[&'static dyn AnyTask];

    /// A backend on these tasks, by its name: one that the study needs besides those that it was asked for.
    ///
    /// # Errors
    /// [`Error::Unfit`] with the names that there are.
    fn backend(&self, name: &str) -> Result<Box<dyn Contestant>, Error>;

    /// A part of the work begins: so many units, which are called so.
    fn begin(&self, total: u64, unit: &str) {
        let _ = (total, unit);
    }

    /// The study turns to this backend or algorithm.
    fn turn_to(&self, what: &str) {
        let _ = what;
    }
}

/// How a backend is found by its name.
type Find = fn(&str) -> Result<Box<dyn Contestant>, Error>;

/// A host that shows no progress and never stops a study.
pub struct Quiet {
    watch: Watch<'static>,
    tasks: &'static [&'static dyn AnyTask],
    find: Find,
}

impl Quiet {
    /// A host for tests and for programs that wait, without tasks and backends of its own.
    #[must_use]
    pub fn new() -> Quiet {
        Quiet::on(&[], |name| Err(Error::Unfit(format!("no backend is called `{name}`"))))
    }

    /// The same with these tasks and backends.
    #[must_use]
    pub fn on(tasks: &'static [&'static dyn AnyTask], find: Find) -> Quiet {
        static NEVER: AtomicBool = AtomicBool::new(false);
        Quiet { watch: Watch::new(&NEVER, None, &|_| {}), tasks, find }
    }
}

impl Default for Quiet {
    fn default() -> Quiet {
        Quiet::new()
    }
}

impl Host for Quiet {
    fn watch(&self) -> &Watch<'_> {
        &self.watch
    }

    fn tasks(&self) -> &[&'static dyn AnyTask] {
        self.tasks
    }

    fn backend(&self, name: &str) -> Result<Box<dyn Contestant>, Error> {
        (self.find)(name)
    }
}
