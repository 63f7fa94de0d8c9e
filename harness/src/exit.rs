//! The exit codes: part of the contract, so each is a public, documented constant.

use std::process::ExitCode;

use predicament_records::{self as records, RunDir, Status, SummaryRow};

use crate::out::program;

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

/// What a command gives back.
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

/// The run in a folder. One that was ended before it had begun is incomplete; what else can't be read is bad input.
pub fn open(folder: impl AsRef<std::path::Path>) -> Result<RunDir, Failure> {
    let code = |folder| if RunDir::is_unbegun(folder) { INCOMPLETE } else { USAGE };
    RunDir::open(&folder).map_err(|error| Failure { message: error.to_string(), code: code(folder.as_ref()) })
}

/// The code of a run that has ended so, with these rows.
pub fn of_rows(ended: records::Outcome, rows: &[SummaryRow]) -> u8 {
    let has = |status: Status| rows.iter().any(|row| row.status == status);
    if ended != records::Outcome::Complete {
        INCOMPLETE
    } else if has(Status::Unexpected) {
        UNEXPECTED
    } else if has(Status::UnexpectedPass) {
        UNEXPECTED_PASS
    } else {
        OK
    }
}

/// Prints a failure and turns an outcome into the process' exit code.
pub fn code(outcome: Outcome) -> ExitCode {
    match outcome {
        Ok(code) => match crate::out::lost() {
            Some(why) => {
                tell!("{}: stdout: {why}; some of the output is lost", program());
                ExitCode::from(if code == OK { USAGE } else { code })
            }
            None => ExitCode::from(code),
        },
        Err(failure) => {
            tell!("{}: {}", program(), failure.message);
            ExitCode::from(failure.code)
        }
    }
}

/// The table for `--help`.
pub const HELP: &str = "\
Exit codes:
    0  ok
    2  usage or bad input
    4  nothing selected
  100  unexpected finding
  101  unexpected pass: an expected finding did not occur
  102  slower than the baseline, beyond noise
  103  incomplete: a timeout or an interrupt
  104  corpus invalid, or its data missing";
