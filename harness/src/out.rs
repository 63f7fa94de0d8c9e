//! Prints to stdout without losing the exit code.
//!
//! `println!` panics if stdout is a closed pipe or a full disk, and then the exit code of the command is lost. Here a
//! failed write is recorded, the command continues, and its exit code stays.

use std::borrow::Cow;
use std::path::Path;

use predicament_records::Hold;

use crate::colour::obeyed;
use crate::failure::Failure;
use crate::host::{self, Stream};
use crate::progress::aside;
use std::fmt::Arguments;
use std::io::{ErrorKind, Write};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

static FAILED: Mutex<Option<std::io::Error>> = Mutex::new(None);

/// Writes to stdout; after the first failure it writes nothing.
pub fn print(text: Arguments<'_>) {
    let text = text.to_string();
    if host::keeps(Stream::Out, &harmless(&text)) {
        return;
    }
    let mut failed = FAILED.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    if failed.is_none() {
        let mut stdout = std::io::stdout().lock();
        let text = obeyed(harmless(&text).into_owned());
        *failed = aside(|| stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush())).err();
    }
}

/// The reason why output was lost, if that is an error. A reader that closes the pipe (`predicament … | head`) is not
/// an error.
pub fn lost() -> Option<String> {
    let failed = FAILED.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    failed.as_ref().filter(|error| error.kind() != ErrorKind::BrokenPipe).map(ToString::to_string)
}

/// A text without control characters that a terminal obeys, because folders from other people are printed too.
fn harmless(text: &str) -> Cow<'_, str> {
    let is_harmless = |c: char| !c.is_control() || matches!(c, '\n' | '\t' | '\r');
    if text.chars().all(is_harmless) {
        return Cow::Borrowed(text);
    }
    Cow::Owned(
        text.chars().map(|c| if is_harmless(c) { c.to_string() } else { c.escape_default().to_string() }).collect(),
    )
}

/// A text with its line breaks replaced by spaces.
pub fn one_line(text: &str) -> Cow<'_, str> {
    if text.contains(['\n', '\r']) { Cow::Owned(text.replace(['\n', '\r'], " ")) } else { Cow::Borrowed(text) }
}

/// Prints a line to stdout.
macro_rules! say {
    () => { $crate::out::print(format_args!("\n")) };
    ($($arg:tt)*) => { $crate::out::print(format_args!("{}\n", format_args!($($arg)*))) };
}

/// Prints to stdout without a line end.
macro_rules! say_text {
    ($($arg:tt)*) => { $crate::out::print(format_args!($($arg)*)) };
}

/// Writes a line to stderr. If stderr is closed or full, the line is lost but the command and its exit code are not.
pub fn tell(line: Arguments<'_>) {
    let line = format!("{line}\n");
    if !host::keeps(Stream::Told, &harmless(&line)) {
        let _ = aside(|| std::io::stderr().write_all(harmless(&line).as_bytes()));
    }
}

/// Prints a line to stderr.
macro_rules! tell {
    ($($arg:tt)*) => { $crate::out::tell(format_args!($($arg)*)) };
}

static QUIET: AtomicBool = AtomicBool::new(false);

/// Turns notes and progress off, or on again; requested output and errors stay.
pub fn be_quiet(is_quiet: bool) {
    QUIET.store(is_quiet, Ordering::Relaxed);
}

/// True if notes and progress are off.
pub fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Prints a note to stderr, unless notes are off.
macro_rules! note {
    ($($arg:tt)*) => {
        if !$crate::out::is_quiet() {
            tell!("{}: {}", $crate::out::program(), format_args!($($arg)*));
        }
    };
}

/// Locks a file that is edited in place, waiting for other processes that edit it. Read the file after this.
pub fn hold(file: &Path) -> Result<Hold, Failure> {
    let words = host::words();
    let words: Vec<_> = words.iter().skip(1).take(2).map(|word| word.to_string_lossy()).collect();
    Hold::take(file, &format!("{} {}", program(), words.join(" "))).map_err(Failure::usage)
}

/// The name under which the tool was called, for lines that suggest a command.
pub fn program() -> String {
    host::name()
}

/// A text quoted as one word of a shell command.
pub fn word(text: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-+=:,@%".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_one_word_to_a_shell() {
        assert_eq!(word("out/run-1"), "out/run-1");
        assert_eq!(word("my out's"), r"'my out'\''s'");
    }
}
