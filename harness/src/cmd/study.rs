//! Runs a study: a built-in study, or one that another crate added.
//!
//! A study measures and formats. This module provides the same threads, backends by name, Ctrl-C handling, progress
//! bar, folder and exit code for all studies.

use std::path::Path;
use std::process::Command;
use std::sync::{Mutex, PoisonError};

use indicatif::ProgressBar;
use predicament_engines::{EngineError, PREFIX, swept};
use predicament_studies::{Error, Host, Ready};
use predicament_tasks::{AnyTask, Contestant, Watch};

use crate::exit::{self, Failure};
use crate::shared::set_threads;
use crate::tool::{Tool, each};
use crate::{interrupt, progress};

/// Runs the command.
pub fn run(study: &dyn Ready, tool: &Tool) -> exit::Outcome {
    set_threads(study.threads())?;
    let names = study.backends();
    let swept = each(&names).map(|name| match name.strip_prefix(PREFIX) {
        Some(engine) => Ok(swept(engine)?.into_iter().map(|engine| format!("{PREFIX}{engine}")).collect()),
        None => Ok(vec![name.to_owned()]),
    });
    let names = swept.collect::<Result<Vec<Vec<String>>, EngineError>>().map_err(Failure::usage)?.concat();
    let backends = if names.is_empty() { Vec::new() } else { tool.pick(&names)? };
    if let Some(folder) = study.out() {
        std::fs::create_dir_all(folder).map_err(Failure::io(folder))?;
    }
    interrupt::listen();
    let bar = Mutex::new(ProgressBar::hidden());
    let told = |work: u64| held(&bar).inc(work);
    let host = Terminal { tool, bar: &bar, watch: Watch::new(interrupt::flag(), None, &told) };
    let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
    let report = study.report(&backends, &host);
    held(&bar).finish_and_clear();
    let report = report.map_err(|error| failure(error, study.out()))?;
    if let Some(folder) = study.out() {
        report.write(folder).map_err(Failure::usage)?;
    }
    say_text!("{}", report.printed);
    if let Some(folder) = study.out() {
        say!("\n{}", folder.display());
    }
    Ok(if report.holds { exit::OK } else { exit::UNEXPECTED })
}

fn failure(error: Error, out: Option<&Path>) -> Failure {
    match error {
        Error::Stopped(_) => {
            let done = if out.is_some() { "written" } else { "printed" };
            Failure { message: format!("{error}; nothing was {done}"), code: exit::INCOMPLETE }
        }
        Error::Unfit(_) | Error::Format(_) => Failure::usage(error),
    }
}

/// Shows a study's progress on stderr, and stops the study at Ctrl-C.
struct Terminal<'a> {
    tool: &'a Tool,
    /// The progress bar of the current part of the study.
    bar: &'a Mutex<ProgressBar>,
    watch: Watch<'a>,
}

impl Host for Terminal<'_> {
    fn watch(&self) -> &Watch<'_> {
        &self.watch
    }

    fn tasks(&self) -> &[&'static dyn AnyTask] {
        self.tool.tasks()
    }

    fn backend(&self, name: &str) -> Result<Box<dyn Contestant>, Error> {
        self.tool.backend(name).map_err(Error::unfit)
    }

    fn again(&self, arguments: &[String]) -> Result<Option<String>, Error> {
        let program = std::env::current_exe().map_err(Error::unfit)?;
        let output = Command::new(program).args(arguments).output().map_err(Error::unfit)?;
        if output.status.success() {
            return Ok(Some(String::from_utf8_lossy(&output.stdout).into_owned()));
        }
        let why = String::from_utf8_lossy(&output.stderr);
        Err(Error::Unfit(format!("`{}`: {}", arguments.join(" "), why.trim())))
    }

    fn begin(&self, total: u64, unit: &str) {
        let mut bar = held(self.bar);
        bar.finish_and_clear();
        *bar = progress::bar(total, unit);
    }

    fn turn_to(&self, what: &str) {
        held(self.bar).set_message(what.to_owned());
    }
}

/// The current bar. A panic while the lock was held leaves the bar valid. A clone is cheap.
fn held(bar: &Mutex<ProgressBar>) -> std::sync::MutexGuard<'_, ProgressBar> {
    bar.lock().unwrap_or_else(PoisonError::into_inner)
}
