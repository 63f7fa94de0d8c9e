//! The exit code of a command, and its output on failure.

use predicament_records::{self as records, RunDir, Status, SummaryRow};

pub use crate::failure::{
    CORPUS, Failure, INCOMPLETE, NOTHING_SELECTED, OK, Outcome, SLOWER, UNEXPECTED, UNEXPECTED_PASS, USAGE,
};
use crate::out::program;

/// Opens the run in a folder. A run that was ended before it began is incomplete; anything else that can't be read is
/// bad input.
pub fn open(folder: impl AsRef<std::path::Path>) -> Result<RunDir, Failure> {
    let code = |folder| if RunDir::is_unbegun(folder) { INCOMPLETE } else { USAGE };
    RunDir::open(&folder).map_err(|error| Failure { message: error.to_string(), code: code(folder.as_ref()) })
}

/// The exit code of a run with this outcome and these rows.
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

/// Prints a failure and turns an outcome into the exit code of the process.
pub fn code(outcome: Outcome) -> u8 {
    match outcome {
        Ok(code) => match crate::out::lost() {
            Some(why) => {
                tell!("{}: stdout: {why}; some of the output is lost", program());
                if code == OK { USAGE } else { code }
            }
            None => code,
        },
        Err(failure) => {
            tell!("{}: {}", program(), failure.message);
            failure.code
        }
    }
}

/// The table of exit codes for `--help`.
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
