//! The host of a study, to which it reports progress and which can stop it.
//!
//! A study knows neither terminals nor signals: the program that starts it watches it. The tool draws a progress bar
//! and listens to Ctrl-C; a test does neither.

use std::sync::atomic::AtomicBool;

use predicament_predicates::Broken;
use predicament_tasks::{AnyTask, Contestant, Watch};

use crate::Error;

/// An observer of a running study, which can also stop it.
pub trait Host {
    /// The watch that the work checks between its chunks, and reports to.
    fn watch(&self) -> &Watch<'_>;

    /// The available tasks, for a study that goes through them.
    fn tasks(&self) -> &[&'static dyn AnyTask];

    /// A backend on these tasks, by its name.
    ///
    /// It is for backends that the study needs besides the requested ones.
    ///
    /// # Errors
    /// [`Error::Unfit`] with the known names.
    fn backend(&self, name: &str) -> Result<Box<dyn Contestant>, Error>;

    /// Runs the tool again in a new process, with these arguments; returns its standard output, or the cause of its
    /// death if it crashed or was killed. `None` if the host has no tool.
    ///
    /// # Errors
    /// [`Error::Unfit`] if the process refuses the arguments, [`Error::Stopped`] if the host was interrupted meanwhile.
    fn again(&self, arguments: &[String]) -> Result<Option<Result<String, Broken>>, Error> {
        let _ = arguments;
        Ok(None)
    }

    /// Begins a part of the work, with this many units of this name.
    fn begin(&self, total: u64, unit: &str) {
        let _ = (total, unit);
    }

    /// Reports the backend or algorithm that the study measures next.
    fn turn_to(&self, what: &str) {
        let _ = what;
    }
}

/// A function that finds a backend by its name.
type Find = fn(&str) -> Result<Box<dyn Contestant>, Error>;

/// A host that shows no progress and never stops a study.
pub struct Quiet {
    watch: Watch<'static>,
    tasks: &'static [&'static dyn AnyTask],
    find: Find,
}

impl Quiet {
    /// A host for tests and for programs that wait, without tasks and backends.
    #[must_use]
    pub fn new() -> Quiet {
        Quiet::on(&[], |name| Err(Error::Unfit(format!("no backend is called `{name}`"))))
    }

    /// A host with these tasks and backends.
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
