//! The process that the tool runs in: its own program, or another program that calls it.
//!
//! A binding for another language calls the tool inside the process of that language. There the command line belongs to
//! the other program, and so do Ctrl-C, stdout and the end of the process. A [call](crate::Cli::call) does not touch
//! them: it takes its words from the caller, returns the texts and the exit code, and stops when the caller
//! [interrupts](interrupt) it. There is one call at a time, because the commands share the flag that stops them.

use std::ffi::OsString;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A program in another language that has the tool inside: its name in messages, and the words that start it again.
///
/// Some commands start the tool again, to run a scene in a separate process. Without these words they would start the
/// other language's interpreter.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Host {
    /// The name under which messages suggest commands.
    pub name: String,
    /// The program and the arguments before those of the tool, such as `python -m predicament`.
    pub again: Vec<OsString>,
}

/// The result of a [call](crate::Cli::call).
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Called {
    /// The exit code: one of the constants of this crate.
    pub code: u8,
    /// The text that the command would write to stdout.
    pub out: String,
    /// The notes and errors that the command would write to stderr.
    pub told: String,
}

/// The words of the command line, if the process's own are another program's.
static WORDS: Mutex<Option<Vec<OsString>>> = Mutex::new(None);
static HOST: Mutex<Option<Host>> = Mutex::new(None);
/// The texts of the running call.
static TEXTS: Mutex<Option<[String; 2]>> = Mutex::new(None);
static CALLS: Mutex<()> = Mutex::new(());
static IS_CALLED: AtomicBool = AtomicBool::new(false);

fn locked<T>(mutex: &'static Mutex<T>) -> MutexGuard<'static, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Stops the running [call](crate::Cli::call) as Ctrl-C stops the tool: finished work is kept.
pub fn interrupt() {
    if is_called() {
        crate::interrupt::flag().store(true, Ordering::SeqCst);
    }
}

/// True if another program has called the tool, and keeps its stdout, its Ctrl-C and its life.
pub fn is_called() -> bool {
    IS_CALLED.load(Ordering::SeqCst)
}

/// Names the program around the tool.
pub fn set(host: Host) {
    *locked(&HOST) = Some(host);
}

/// The words that start the tool again, if they are not this program's path.
pub fn again() -> Option<Vec<OsString>> {
    locked(&HOST).as_ref().map(|host| host.again.clone())
}

/// Takes these words as the command line.
pub fn set_words(words: Vec<OsString>) {
    *locked(&WORDS) = Some(words);
}

/// The words of the command line, the program's name first.
pub fn words() -> Vec<OsString> {
    locked(&WORDS).clone().unwrap_or_else(|| std::env::args_os().collect())
}

/// The name of the program in lines that suggest a command.
pub fn name() -> String {
    if let Some(host) = &*locked(&HOST) {
        return host.name.clone();
    }
    let called = words().into_iter().next();
    let name = called.as_ref().and_then(|path| Path::new(path).file_stem());
    name.map_or_else(|| "predicament".to_owned(), |name| name.to_string_lossy().into_owned())
}

/// The two streams of texts.
#[derive(Clone, Copy)]
pub enum Stream {
    /// Results.
    Out,
    /// Notes and errors.
    Told,
}

/// Keeps a text for the caller; returns false if the text is for the terminal.
pub fn keeps(stream: Stream, text: &str) -> bool {
    match &mut *locked(&TEXTS) {
        Some(texts) => {
            texts[stream as usize].push_str(text);
            true
        }
        None => false,
    }
}

/// Runs a command inside another program.
pub fn call(words: Vec<OsString>, run: impl FnOnce(Vec<OsString>) -> u8) -> Called {
    let _one = locked(&CALLS);
    let before = locked(&WORDS).replace(words.clone());
    *locked(&TEXTS) = Some(Default::default());
    crate::interrupt::flag().store(false, Ordering::SeqCst);
    crate::out::be_quiet(false);
    IS_CALLED.store(true, Ordering::SeqCst);
    let code = run(words);
    IS_CALLED.store(false, Ordering::SeqCst);
    *locked(&WORDS) = before;
    let [out, told] = locked(&TEXTS).take().unwrap_or_default();
    Called { code, out, told }
}
