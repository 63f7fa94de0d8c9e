//! Loaded scenes: points, content, and the descriptions in the suite.

use std::any::Any;
use std::sync::Arc;

use predicament_formats::{ImportNotes, Written};
use predicament_predicates::{Scene, SceneError, Vertex};

use crate::{Content, content_id};

/// A scene with its content and its descriptions in the suite, ready for a task.
#[derive(Clone, Debug)]
pub struct LoadedScene {
    /// The name of the scene's suite.
    pub suite: String,
    /// The scene's name in the suite.
    pub name: String,
    /// The content id: see [`content_id`](crate::content_id).
    pub id: String,
    /// The name of the task.
    pub task: &'static str,
    /// The family's name in `throughput.csv`; the scene's name if it has no family.
    pub family: String,
    /// Free words for selecting scenes.
    pub tags: Vec<String>,
    /// The origin of the scene.
    pub source: String,
    /// One sentence for the report.
    pub analysis: String,
    /// True if the scene is marked as invalid input of its task: programs should refuse it.
    pub is_invalid: bool,
    /// The points.
    pub scene: Scene,
    /// The questions about the points.
    pub content: Arc<dyn Content>,
    /// Counts of changes by the importer.
    pub notes: ImportNotes,
    /// Remarks that a user would not expect, one a line.
    pub remarks: Vec<String>,
    /// The decimals of the coordinates, a second truth beside the doubles; `None` if the suite does not ask for it.
    pub written: Option<Written>,
    /// The scene as written times a power of ten, for tasks that judge decimals as integers.
    pub similar: Option<Arc<LoadedScene>>,
}

impl LoadedScene {
    /// The content, if it has this type.
    #[must_use]
    pub fn content<C: Content>(&self) -> Option<&C> {
        let any: &dyn Any = self.content.as_ref();
        any.downcast_ref()
    }

    /// The scene with its points moved, and its new content id. It has no truth of decimals.
    ///
    /// # Errors
    /// [`MoveError`] if the coordinates make no scene, if their number differs from the scene's, or if the scene has
    /// constructed vertices.
    pub fn moved(self, coordinates: Vec<f64>) -> Result<LoadedScene, MoveError> {
        let (scene, content) = moved(&self.scene, &self.content, coordinates)?;
        Ok(LoadedScene {
            id: content_id(&scene, content.as_ref()),
            scene,
            content,
            written: None,
            similar: None,
            ..self
        })
    }

    /// The number of questions: see [`Content::count`].
    #[must_use]
    pub fn count(&self) -> usize {
        self.content.count()
    }
}

/// A scene and its content with moved points, in the same order. The split of vertices into two meshes stays.
///
/// # Errors
/// [`MoveError`] if the coordinates make no scene, if their number differs from the scene's, or if the scene has
/// constructed vertices.
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
    elsewhere = elsewhere.with_weights_of(scene);
    if let Some(second) = scene.second_mesh() {
        let vertices = second.iter().enumerate().filter(|(_, is)| **is).map(|(at, _)| Vertex::input(at));
        elsewhere = elsewhere.with_second_mesh(vertices.collect::<Vec<_>>());
    }
    let (elsewhere, other) = content.moved(elsewhere);
    Ok((elsewhere, other.unwrap_or_else(|| Arc::clone(content))))
}

/// The reason why the points of a scene cannot be moved.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum MoveError {
    /// The scene has constructed vertices.
    Constructed,
    /// The number of given coordinates is wrong.
    Count {
        /// The number of the scene's coordinates.
        had: usize,
        /// The number of given coordinates.
        given: usize,
    },
    /// The coordinates do not make a scene.
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
