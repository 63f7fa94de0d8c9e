//! The content of a scene: the questions about its points, as the library handles them.
//!
//! Each task has its own content type: queries, cells, a map with probes. The library only stores it, hashes it and
//! counts it.

use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

use predicament_formats::{Cache, CorpusError, Entry, ImportNotes, Written};
use predicament_predicates::Scene;

use crate::{Canon, Level, Spelled};

/// One task's questions about a scene's points: queries, cells, a map with probes.
pub trait Content: Any + Debug + Send + Sync {
    /// The number of questions: queries, probes, simplices. Progress and times per query use this number.
    fn count(&self) -> usize;

    /// Feeds the content to the content id: a text that is unique to the task, then all values.
    fn canon(&self, canon: &mut Canon);

    /// The scene after its points have moved, updated with what the content knows about its points, and the content for
    /// that scene. The content is `None` if it does not depend on the points' coordinates.
    fn moved(&self, scene: Scene) -> (Scene, Option<Arc<dyn Content>>) {
        (scene, None)
    }

    /// The scene and its questions in written form, without the name of the task; `None` if they cannot be written.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let _ = scene;
        None
    }
}

/// A scene with its content.
#[derive(Clone, Debug)]
pub struct Parts {
    /// The points of the scene.
    pub scene: Scene,
    /// The questions about the points.
    pub content: Arc<dyn Content>,
    /// Counts of changes by the importer.
    pub notes: ImportNotes,
    /// Remarks that a user would not expect, such as points that no query names, one a line.
    pub remarks: Vec<String>,
    /// The decimals of the coordinates, if a generator knows them; used only by scenes with a truth of decimals.
    pub written: Option<Written>,
}

impl Parts {
    /// A scene that no importer changed.
    #[must_use]
    pub fn new(scene: Scene, content: impl Content) -> Parts {
        Parts { scene, content: Arc::new(content), notes: ImportNotes::default(), remarks: Vec::new(), written: None }
    }
}

/// The source of a scene's points and content.
pub enum Source {
    /// Written in the suite: read and checked with it.
    Written(Parts),
    /// Elsewhere: a data file, a download, a generator.
    Elsewhere(Arc<dyn Elsewhere>),
}

impl Source {
    /// A scene that is generated or read when it is loaded.
    #[must_use]
    pub fn elsewhere(elsewhere: impl Elsewhere + 'static) -> Source {
        Source::Elsewhere(Arc::new(elsewhere))
    }
}

/// A scene that is not written in its suite.
pub trait Elsewhere: Send + Sync {
    /// Reads, generates or imports the scene.
    ///
    /// # Errors
    /// [`CorpusError`] if a data file is missing or wrong; for data that is not yet fetched, the error says how to
    /// fetch it.
    fn load(&self, level: Level, cache: &Cache) -> Result<Parts, CorpusError>;

    /// The fetched file that the scene needs (the first, if there are two), if any.
    fn fetch_entry(&self) -> Option<&Entry> {
        None
    }
}
