//! What is asked about a scene's points, as the library sees it.
//!
//! Each task has a content type of its own: queries, cells, a map with probes.
//! The library only carries it, hashes it and counts it.

use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

use predicament_formats::{Cache, CorpusError, Entry, ImportNotes};
use predicament_predicates::Scene;

use crate::{Canon, Level, Spelled};

/// What one task asks about a scene's points: queries, cells, a map with probes.
pub trait Content: Any + Debug + Send + Sync {
    /// The number of questions: queries, probes, simplices. Progress and times per query go by it.
    fn count(&self) -> usize;

    /// Feeds everything that makes the content what it is to the content id: a
    /// text that no other task begins with, then the values.
    fn canon(&self, canon: &mut Canon);

    /// The scene with what the content tells it about its points, which have moved, and the content over it; none where
    /// the content holds nothing that depends on where points are.
    fn moved(&self, scene: Scene) -> (Scene, Option<Arc<dyn Content>>) {
        (scene, None)
    }

    /// The scene and what is asked about it, written out without the name of the task; none where it cannot be.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let _ = scene;
        None
    }
}

/// A scene with its content.
#[derive(Clone, Debug)]
pub struct Parts {
    /// The points.
    pub scene: Scene,
    /// What is asked about them.
    pub content: Arc<dyn Content>,
    /// What an importer changed.
    pub notes: ImportNotes,
}

impl Parts {
    /// A scene that no importer changed.
    #[must_use]
    pub fn new(scene: Scene, content: impl Content) -> Parts {
        Parts { scene, content: Arc::new(content), notes: ImportNotes::default() }
    }
}

/// Where a scene's points and content come from.
pub enum Source {
    /// Written out in the suite: read and checked with it.
    Written(Parts),
    /// Elsewhere: a data file, a download, a generator.
    Elsewhere(Arc<dyn Elsewhere>),
}

impl Source {
    /// A scene that is made or read when it is loaded.
    #[must_use]
    pub fn elsewhere(elsewhere: impl Elsewhere + 'static) -> Source {
        Source::Elsewhere(Arc::new(elsewhere))
    }
}

/// A scene that is not written out in its suite.
pub trait Elsewhere: Send + Sync {
    /// Reads, generates or imports the scene.
    ///
    /// # Errors
    /// [`CorpusError`] where a data file is missing or wrong; data that was not
    /// fetched yet is an error that says how to fetch it.
    fn load(&self, level: Level, cache: &Cache) -> Result<Parts, CorpusError>;

    /// The fetched file that it needs (the first, where there are two), if any.
    fn fetch_entry(&self) -> Option<&Entry> {
        None
    }
}
