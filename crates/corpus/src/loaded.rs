//! A loaded scene: points, content, and what its suite says about it.

use std::any::Any;
use std::sync::Arc;

use predicament_formats::ImportNotes;
use predicament_predicates::Scene;

use crate::Content;

/// A scene with its content, ready for a task, and all that its suite says about it.
#[derive(Clone, Debug)]
pub struct LoadedScene {
    /// The suite it is from.
    pub suite: String,
    /// Its name in the suite.
    pub name: String,
    /// The content id: see [`content_id`](crate::content_id).
    pub id: String,
    /// The name of the task.
    pub task: &'static str,
    /// The family as `throughput.csv` calls it; the scene's name where it has none.
    pub family: String,
    /// Free words to select by.
    pub tags: Vec<String>,
    /// Where the scene is from.
    pub source: String,
    /// One sentence that ends up in the report.
    pub analysis: String,
    /// The points.
    pub scene: Scene,
    /// What is asked.
    pub content: Arc<dyn Content>,
    /// What an importer changed.
    pub notes: ImportNotes,
}

impl LoadedScene {
    /// The content, where it is of this type.
    #[must_use]
    pub fn content<C: Content>(&self) -> Option<&C> {
        let any: &dyn Any = self.content.as_ref();
        any.downcast_ref()
    }

    /// The number of questions: see [`Content::count`].
    #[must_use]
    pub fn count(&self) -> usize {
        self.content.count()
    }
}
