//! Progress on stderr: a bar or a spinner. It is hidden without a terminal and with `--quiet`.

use std::io::IsTerminal;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// The time between two pictures of a bar or spinner.
const TICK: Duration = Duration::from_millis(200);
/// The time before a spinner is shown: quick commands show none.
const PATIENCE: Duration = Duration::from_millis(500);

/// The spinner that is shown, if any.
static SPINNER: Mutex<Option<ProgressBar>> = Mutex::new(None);

fn is_hidden() -> bool {
    crate::out::is_quiet() || !std::io::stderr().is_terminal()
}

/// A bar over `total` units of work.
pub fn bar(total: u64, unit: &str) -> ProgressBar {
    if is_hidden() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr());
    let style = format!("{{elapsed_precise}} [{{bar:32}}] {{human_pos}}/{{human_len}} {unit} ({{eta}}) {{msg}}");
    if let Ok(style) = ProgressStyle::with_template(&style) {
        bar.set_style(style.progress_chars("=> "));
    }
    bar.enable_steady_tick(TICK);
    bar
}

/// A spinner beside what the command does, shown after half a second until it is dropped.
pub struct Working {
    spinner: ProgressBar,
    /// Ends the wait when it is dropped.
    ended: Option<Sender<()>>,
    shows: Option<JoinHandle<()>>,
}

/// Says what the command does, as long as the value lives.
pub fn working(what: impl Into<String>) -> Working {
    let spinner = ProgressBar::hidden();
    spinner.set_message(what.into());
    if is_hidden() {
        return Working { spinner, ended: None, shows: None };
    }
    if let Ok(style) = ProgressStyle::with_template("{elapsed_precise} {spinner} {msg}") {
        spinner.set_style(style);
    }
    let (ended, end) = channel();
    let shown = spinner.clone();
    let shows = std::thread::spawn(move || {
        if end.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
            *self::spinner() = Some(shown.clone());
            shown.set_draw_target(ProgressDrawTarget::stderr());
            shown.enable_steady_tick(TICK);
        }
    });
    Working { spinner, ended: Some(ended), shows: Some(shows) }
}

impl Working {
    /// Says what the command does now.
    pub fn now(&self, what: impl Into<String>) {
        self.spinner.set_message(what.into());
    }
}

impl Drop for Working {
    fn drop(&mut self) {
        drop(self.ended.take());
        if let Some(shows) = self.shows.take() {
            let _ = shows.join();
        }
        self.spinner.finish_and_clear();
        *spinner() = None;
    }
}

fn spinner() -> std::sync::MutexGuard<'static, Option<ProgressBar>> {
    SPINNER.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Prints with the spinner out of the way.
pub fn aside<T>(print: impl FnOnce() -> T) -> T {
    let spinner = spinner().clone();
    match spinner {
        Some(spinner) => spinner.suspend(print),
        None => print(),
    }
}
