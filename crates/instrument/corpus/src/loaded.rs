//! A loaded scene: points, content, and what its suite says about it.

use std::any::Any;
use std::sync::Arc;

use predicament_formats::ImportNotes;
use predicament_predicates::{Scene, SceneError, Vertex};

use crate::{Content, content_id};

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

    /// The same scene with its points elsewhere, and the content id of that.
    ///
    /// # Errors
    /// One line, where the coordinates make no scene, are not as many as the scene has, or the scene has constructed vertices.
    pub fn moved(self, coordinates: Vec<f64>) -> Result<LoadedScene, MoveError> {
        let (scene, content) = moved(&self.scene, &self.content, coordinates)?;
        Ok(LoadedScene { id: content_id(&scene, content.as_ref()), scene, content, ..self })
    }

    /// The number of questions: see [`Content::count`].
    #[must_use]
    pub fn count(&self) -> usize {
        self.content.count()
    }
}

/// A scene and its content with the points elsewhere, in their order. Which vertices are of the second of two meshes stays.
///
/// # Errors
/// One line, where the coordinates make no scene, are not as many as the scene has, or the scene has constructed vertices.
pub(crate) fn moved(
    scene: &Scene,
    content: &Arc<dyn Content>,
    coordinates: Vec<f64>,
) -> Result<(Scene, Arc<dyn Content>), MoveError> {
    if !scene.constructions().is_empty() {
        return Err(MoveError::Constructed);
    }
    let (had, has) = (scene.coordinates().len(), coordinates.len());
    if had != has {
        return Err(MoveError::Count { had, given: has });
    }
    let mut elsewhere = Scene::new(scene.dimension(), coordinates).map_err(MoveError::Scene)?;
    if let Some(second) = scene.second_mesh() {
        let vertices = second.iter().enumerate().filter(|(_, is)| **is).map(|(at, _)| Vertex::input(at));
        elsewhere = elsewhere.with_second_mesh(vertices.collect::<Vec<_>>());
    }
    let (elsewhere, other) = content.moved(elsewhere);
    Ok((elsewhere, other.unwrap_or_else(|| Arc::clone(content))))
}

/// Why the points of a scene are not moved.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum MoveError {
    /// The scene has constructed vertices.
    Constructed,
    /// Another number of coordinates is given.
    Count {
        /// How many coordinates the scene has.
        had: usize,
        /// How many are given.
        given: usize,
    },
    /// The coordinates are not those of a scene.
    Scene(SceneError),
}

impl std::fmt::Display for MoveError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            MoveError::Constructed => f.write_str("the scene has constructed vertices, which do not move"),
            MoveError::Count { had, given } => write!(f, "the scene has {had} coordinates, and {given} are given"),
            MoveError::Scene(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for MoveError {}
