//! Errors that prevent or end a search.

use predicament_formats::CorpusError;

/// The reason why a search does not begin, or cannot continue.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum SearchError {
    /// A scene cannot be read from its text.
    Scene(CorpusError),
    /// A text has no scene, or more than one.
    NotOneScene,
    /// The task cannot write its scenes out.
    NotWritten {
        /// The task.
        task: String,
    },
    /// A scene of the population cannot be read.
    Member {
        /// The scene's number.
        number: u64,
        /// The reason.
        why: Box<SearchError>,
    },
    /// A find cannot be read.
    Find {
        /// The number of the find, from 1.
        number: usize,
        /// The reason.
        why: Box<SearchError>,
    },
    /// The population's number of islands differs from the task's number of measures.
    Islands {
        /// The number of islands.
        found: usize,
        /// The number of measures of the task.
        measures: usize,
    },
    /// The suites contain no small scene of the task to start from.
    NoSeeds {
        /// The task.
        task: String,
    },
    /// The scene to shrink cannot be read from its text.
    Start(CorpusError),
    /// The scene to shrink, written out, does not show the finding.
    NotShown,
    /// The search was interrupted before it evaluated a scene.
    Interrupted,
}

impl std::fmt::Display for SearchError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            // The text is not in a separate file.
            SearchError::Scene(error) => {
                if let Some(line) = error.line() {
                    write!(f, "line {line} of the scene: ")?;
                }
                write!(f, "{}; {}", error.message, error.cure)
            }
            SearchError::NotOneScene => f.write_str("a suite with one scene was expected"),
            SearchError::NotWritten { task } => write!(f, "the task {task} cannot write its scenes out"),
            SearchError::Member { number, why } => write!(f, "scene {number}: {why}"),
            SearchError::Find { number, why } => write!(f, "find {number}: {why}"),
            SearchError::Islands { found, measures } => {
                write!(f, "{found} islands where the task has {measures} measures")
            }
            SearchError::NoSeeds { task } => {
                write!(f, "these suites have no small scene of {task} to start from; name others")
            }
            SearchError::Start(error) => error.fmt(f),
            SearchError::NotShown => f.write_str("the scene, written out, does not show the finding"),
            SearchError::Interrupted => f.write_str("interrupted before the scene was evaluated"),
        }
    }
}

impl std::error::Error for SearchError {}
