//! The exit codes, part of the contract, so each is a public, documented constant; and failures, which have one.

/// All as it should be.
pub const OK: u8 = 0;
/// Usage, or input that is bad outside of the corpora.
pub const USAGE: u8 = 2;
/// The selection is empty: nothing was run.
pub const NOTHING_SELECTED: u8 = 4;
/// A finding that no expectation lists.
pub const UNEXPECTED: u8 = 100;
/// An expected finding that did not occur.
pub const UNEXPECTED_PASS: u8 = 101;
/// Slower than the baseline, beyond noise.
pub const SLOWER: u8 = 102;
/// Incomplete: a timeout or an interrupt.
pub const INCOMPLETE: u8 = 103;
/// A suite, or the data that it needs, is invalid or missing.
pub const CORPUS: u8 = 104;

/// A failure: what to print in one line, and the code to leave with.
#[derive(Debug)]
pub struct Failure {
    /// One line for stderr.
    pub message: String,
    /// One of the constants of this module.
    pub code: u8,
}

/// The exit code of a command, or the failure that ended it.
pub type Outcome = Result<u8, Failure>;

impl Failure {
    /// Bad usage or input.
    pub fn usage(message: impl std::fmt::Display) -> Failure {
        Failure { message: message.to_string(), code: USAGE }
    }

    /// What the operating system says of a file or folder, with a cure, for `map_err`.
    pub fn io(path: &std::path::Path) -> impl FnOnce(std::io::Error) -> Failure {
        move |error| Failure::usage(predicament_records::Error::io(path)(error))
    }

    /// Nothing matches.
    pub fn nothing(message: impl std::fmt::Display) -> Failure {
        Failure { message: message.to_string(), code: NOTHING_SELECTED }
    }
}
