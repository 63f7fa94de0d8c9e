//! From a definition to a scene that is ready to be asked.

use predicament_predicates::{Dimension, Plane, PredicateKind, QuerySet, Question, Scene};

use super::scene::{Content, MapSource, SceneDef};
use super::{cubes, points};
use crate::import::topojson;
use crate::probes::with_probes;
use crate::{Cache, CorpusError, Level, LoadedScene, Work};

impl SceneDef {
    /// Reads, generates or imports the scene.
    ///
    /// # Errors
    /// [`CorpusError`] where a data file is missing or wrong; data that was
    /// not fetched yet is an error that says how to fetch it.
    pub fn load(&self, level: Level, cache: &Cache) -> Result<LoadedScene, CorpusError> {
        match &self.content {
            Content::Inline(inline) => Ok(self.around(inline.0.clone(), inline.1.clone())),
            Content::Csv { path, constructed, plan } => {
                let (dimension, coordinates) = points::read_csv(path)?;
                let mut scene = self.scene(dimension, coordinates)?;
                constructed.add_to(&mut scene, &self.file)?;
                let queries = plan.queries(&self.file, &scene)?;
                Ok(self.around(scene, Work::Signs(queries)))
            }
            Content::Cubes(path) => {
                let (scene, work) = cubes::read_csv(path)?;
                Ok(self.around(scene, work))
            }
            Content::Fixture(entry) => {
                let text = cache.read(entry)?;
                let file = cache.path(entry).display().to_string();
                let (scene, expected) = points::read_fixture(&file, &text, self.task)?;
                let question = self.task.predicate().and_then(plain_question).expect("fixtures ask for signs");
                let queries = QuerySet::new(question, scene.vertices().collect());
                Ok(LoadedScene { expected: Some(expected), ..self.around(scene, Work::Signs(queries)) })
            }
            Content::Map(source) => self.load_map(source, level, cache),
            Content::Contacts(contacts) => {
                let (scene, work, notes) = contacts.assemble(&self.file, cache)?;
                Ok(LoadedScene { notes, ..self.around(scene, work) })
            }
            Content::Generated(generator) => {
                let (scene, work) = generator.run(self.task, level);
                Ok(self.around(scene, work))
            }
        }
    }

    fn scene(&self, dimension: Dimension, coordinates: Vec<f64>) -> Result<Scene, CorpusError> {
        Scene::new(dimension, coordinates)
            .map_err(|error| CorpusError::file(&self.file, error.to_string(), "correct the points").at_line(self.line))
    }

    fn load_map(&self, source: &MapSource, level: Level, cache: &Cache) -> Result<LoadedScene, CorpusError> {
        let (file, text) = source.origin.read(cache)?;
        let imported = topojson::read(&file, &text, &source.object)?;
        let (scene, work) = with_probes(imported.points, imported.map, source.probing, level);
        Ok(LoadedScene { notes: imported.notes, ..self.around(scene, work) })
    }
}

/// The question of a fixture's rows; none has rows for `compare`.
fn plain_question(kind: PredicateKind) -> Option<Question> {
    match kind {
        PredicateKind::Compare => None,
        PredicateKind::Orient2d => Some(Question::Orient2d(Plane::Xy)),
        PredicateKind::Orient3d => Some(Question::Orient3d),
        PredicateKind::Incircle => Some(Question::Incircle),
        PredicateKind::Insphere => Some(Question::Insphere),
    }
}
