//! The exit codes, and failures, which carry one. The codes are part of the contract, so each is a public, documented
//! constant.

/// Success: all is as expected.
pub const OK: u8 = 0;
/// Wrong usage, or bad input outside of the corpora.
pub const USAGE: u8 = 2;
/// Empty selection: nothing was run.
pub const NOTHING_SELECTED: u8 = 4;
/// An unexpected finding.
pub const UNEXPECTED: u8 = 100;
/// An expected finding that did not occur.
pub const UNEXPECTED_PASS: u8 = 101;
/// A time slower than the baseline, beyond noise.
pub const SLOWER: u8 = 102;
/// An incomplete run, because of a timeout or an interrupt.
pub const INCOMPLETE: u8 = 103;
/// A suite, or the data that it needs, is invalid or missing.
pub const CORPUS: u8 = 104;

/// A failure: a message of one line, and the exit code.
#[derive(Debug)]
pub struct Failure {
    /// The message, one line for stderr.
    pub message: String,
    /// The exit code: one of the constants of this module.
    pub code: u8,
}

/// The exit code of a command, or the failure that ended it.
pub type Outcome = Result<u8, Failure>;

impl Failure {
    /// Bad usage or input.
    pub fn usage(message: impl std::fmt::Display) -> Failure {
        Failure { message: message.to_string(), code: USAGE }
    }

    /// An error of the operating system about a file or folder, with a cure, for `map_err`.
    pub fn io(path: &std::path::Path) -> impl FnOnce(std::io::Error) -> Failure {
        move |error| Failure::usage(predicament_records::Error::io(path)(error))
    }

    /// An empty selection.
    pub fn nothing(message: impl std::fmt::Display) -> Failure {
        Failure { message: message.to_string(), code: NOTHING_SELECTED }
    }
}
