//! The start of a hunt: small scenes of suites, and points with small integer coordinates.

use predicament_corpus::{Level, LoadedScene, Random, SceneDef, Spelled, Suite};
use predicament_formats::{Cache, CorpusError};
use predicament_predicates::{Dimension, QuerySet, Question, Scene, Vertex};
use predicament_tasks::Budget;
use predicament_tasks::signs::SignQueries;

use super::heights::kind_of;
use super::moves::MOST_ROWS;
use crate::{drop_unnamed, edit::keep_items};

/// A scene that a hunt starts from.
#[derive(Clone, PartialEq, Debug)]
pub struct Seed {
    /// The names of the suite and the scene.
    pub name: String,
    /// The scene.
    pub spelled: Spelled,
}

/// The number of probes kept of a scene that has many.
const PROBES: usize = 8;

/// The number of queries kept of a scene that has many: each becomes a separate seed, with the vertices that it names.
const QUERIES: usize = 3;

/// The seeds of a task: scenes that are written out in suites, and are small or consist of queries.
///
/// If there are none, the seeds are scenes that are read on demand. Maps and meshes for point location are always read
/// on demand, even if a suite's text contains them.
///
/// # Errors
/// [`CorpusError`] if a scene cannot be loaded.
pub fn seeds(suites: &[Suite], task: &str) -> Result<Vec<Seed>, CorpusError> {
    let of_task = || suites.iter().flat_map(|suite| &suite.scenes).filter(|def| def.task == task && !def.needs_fetch());
    let is_held = of_task().any(SceneDef::is_written);
    let mut seeds = Vec::new();
    for def in of_task().filter(|def| def.is_written() == is_held) {
        let loaded = def.load(Level::Quick, &Cache::new(""))?;
        seeds.extend(of_scene(&loaded));
    }
    Ok(seeds)
}

fn of_scene(loaded: &LoadedScene) -> Vec<Seed> {
    let Some(spelled) = loaded.spelled() else { return Vec::new() };
    let name = format!("{}/{}", loaded.suite, loaded.name);
    let parts = match spelled.lists.as_slice() {
        [list] if list.key == "queries" && spelled.constructions.is_empty() => {
            let count = list.items.len();
            let one = |query: usize| drop_unnamed(&keep_items(&spelled, 0, |at| at == query));
            if count <= 1 { vec![drop_unnamed(&spelled)] } else { Budget::spread(count, 1, QUERIES).map(one).collect() }
        }
        _ => vec![fewer_probes(spelled)],
    };
    let small = |part: &Spelled| !part.rows().is_empty() && part.rows().len() <= MOST_ROWS;
    parts.into_iter().filter(small).map(|spelled| Seed { name: name.clone(), spelled }).collect()
}

/// The scene with some of its probes, if it has many: maps and meshes for point location have hundreds.
fn fewer_probes(spelled: Spelled) -> Spelled {
    let Some(list) = spelled.lists.iter().position(|list| list.key == "probes") else { return spelled };
    let kept: Vec<usize> = Budget::spread(spelled.lists[list].items.len(), 1, PROBES).collect();
    keep_items(&spelled, list, |at| kept.contains(&at))
}

/// True if a task has shapes, which are points with small integer coordinates and queries about them: the tasks of
/// signs have.
#[must_use]
pub fn has_shapes(task: &str) -> bool {
    kind_of(task).is_some()
}

/// A few points with small integer coordinates, and queries of a predicate about them; `None` for tasks without shapes.
#[must_use]
pub(super) fn shape(task: &str, random: &mut Random) -> Option<Spelled> {
    let kind = kind_of(task)?;
    let (question, dimension) = (kind.first_question(), kind.dimension().unwrap_or(Dimension::Two));
    let mut number = |low: i64, high: i64| random.integer(low, high);
    let arity = kind.arity();
    let more = usize::try_from(number(0, 3)).unwrap_or_default();
    let size = number(1, 8);
    #[allow(clippy::cast_precision_loss)] // small
    let coordinates: Vec<f64> = (0..(arity + more) * dimension.count()).map(|_| number(-size, size) as f64).collect();
    let mut scene = Scene::new(dimension, coordinates).ok()?;
    if let Question::Derived(derived) = question
        && derived.formula().is_weighted()
    {
        #[allow(clippy::cast_precision_loss)] // small
        let weights = (0..scene.len()).map(|_| number(-size, size) as f64).collect();
        scene = scene.with_weights(weights).ok()?;
    }
    let mut args: Vec<Vertex> = Vec::new();
    for _ in 0..number(1, 3) {
        let mut left: Vec<Vertex> = scene.vertices().collect();
        for _ in 0..arity {
            let last = i64::try_from(left.len()).unwrap_or(1) - 1;
            args.push(left.remove(usize::try_from(number(0, last)).unwrap_or_default()));
        }
    }
    let content = SignQueries::new(QuerySet::new(question, args));
    let spelled = predicament_corpus::Content::spelled(&content, &scene)?;
    Some(Spelled { task: kind.name(), ..spelled })
}
