//! Why a search does not begin, or cannot go on.

use predicament_formats::CorpusError;

/// Why a search does not begin, or cannot go on.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum SearchError {
    /// A scene cannot be read from its text.
    Scene(CorpusError),
    /// A text has none or more than one scene.
    NotOneScene,
    /// The task cannot write its scenes out.
    NotWritten {
        /// The task.
        task: String,
    },
    /// A scene of the population cannot be read.
    Member {
        /// Its number.
        number: u64,
        /// Why.
        why: Box<SearchError>,
    },
    /// A find cannot be read.
    Find {
        /// Its number, from 1.
        number: usize,
        /// Why.
        why: Box<SearchError>,
    },
    /// The population has another number of islands than the task has measures.
    Islands {
        /// How many islands there are.
        found: usize,
        /// How many measures the task has.
        measures: usize,
    },
    /// The suites have no small scene of the task to begin with.
    NoSeeds {
        /// The task.
        task: String,
    },
    /// The scene that is to be made smaller cannot be read from its text.
    Start(CorpusError),
    /// The scene that is to be made smaller, written out, does not show the finding.
    NotShown,
    /// The search was interrupted before it looked at a scene.
    Interrupted,
}

impl std::fmt::Display for SearchError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            // The text is in no file of its own.
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
            SearchError::NoSeeds { task } => write!(f, "no small scene of {task} is in these suites; name others"),
            SearchError::Start(error) => error.fmt(f),
            SearchError::NotShown => f.write_str("the scene, written out, does not show the finding"),
            SearchError::Interrupted => f.write_str("interrupted before the scene was looked at once"),
        }
    }
}

impl std::error::Error for SearchError {}
