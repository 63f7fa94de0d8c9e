//! Runs a study: a built-in study, or one that another crate added.
//!
//! A study measures and formats. This module provides the same threads, backends by name, Ctrl-C handling, progress
//! bar, folder and exit code for all studies.

use std::path::Path;
use std::process::Stdio;
use std::sync::atomic::Ordering;
use std::sync::{Mutex, PoisonError};

use indicatif::ProgressBar;
use predicament_engines::{EngineError, PREFIX, swept};
use predicament_predicates::{Broken, Class};
use predicament_studies::{Error, Host, Ready};
use predicament_tasks::{AnyTask, Contestant, Stop, Watch};

use crate::child::{self, End};
use crate::death::{Said, death, unable};
use crate::exit::{self, Failure};
use crate::shared::set_threads;
use crate::tool::{Tool, each};
use crate::{interrupt, progress};

/// Runs the command.
pub fn run(study: &dyn Ready, tool: &Tool) -> exit::Outcome {
    child::end_with_parent();
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

    fn again(&self, arguments: &[String]) -> Result<Option<Result<String, Broken>>, Error> {
        let unfit = |failure: Failure| Error::Unfit(failure.message);
        let mut command = child::command().map_err(unfit)?;
        command.args(arguments);
        let mut child = child::start(command, Stdio::piped()).map_err(unfit)?;
        let (printed, said) = (Said::all(child.stdout.take()), Said::last(child.stderr.take()));
        let status = match child::wait(&mut child, None) {
            // Ctrl-C reaches both processes; the child may have ended before this process looked.
            End::Exit(status) if !interrupt::flag().load(Ordering::Relaxed) => status,
            _ => return Err(Error::Stopped(Stop::Interrupted)),
        };
        let code = status.and_then(|status| status.code());
        if [exit::OK, exit::UNEXPECTED].iter().any(|&fine| code == Some(i32::from(fine))) {
            return Ok(Some(Ok(printed.text())));
        }
        let said = said.text();
        if let Some(failure) = unable(status, &said) {
            return Err(unfit(failure));
        }
        let (check, message) = death(status, &said);
        Ok(Some(Err(Broken { class: Class::Panic, check, message })))
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
