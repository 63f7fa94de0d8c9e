//! The reasons why a study has no result.

use predicament_tasks::Stop;

/// The reason why a study has no result.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Error {
    /// The watch stopped it.
    Stopped(Stop),
    /// An argument or a backend does not fit the study, in one line.
    Unfit(String),
    /// A result cannot be written in the requested format, in one line.
    Format(String),
}

impl Error {
    /// The error for an argument or a backend that does not fit the study.
    pub fn unfit(why: impl std::fmt::Display) -> Error {
        Error::Unfit(why.to_string())
    }

    /// The error for a result that cannot be written.
    pub fn format(why: impl std::fmt::Display) -> Error {
        Error::Format(why.to_string())
    }
}

impl From<Stop> for Error {
    fn from(stop: Stop) -> Error {
        Error::Stopped(stop)
    }
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Error::Stopped(Stop::Interrupted) => f.write_str("interrupted"),
            Error::Stopped(Stop::Timeout) => f.write_str("out of time"),
            Error::Unfit(why) | Error::Format(why) => f.write_str(why),
        }
    }
}

impl std::error::Error for Error {}
