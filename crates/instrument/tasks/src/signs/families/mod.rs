//! Families of generated sign scenes: the keys of their tables, and the scenes of their queries.
//!
//! The crate `families` makes the queries of the five predicates; the module `formula` makes those of formulas.

mod formula;
mod list;
mod read;

use predicament_corpus::{Making, Parts, Random, Recipe};
use predicament_families::{Cloud, native, place};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::formula::Formula;
use predicament_predicates::{Axis, Dimension, PredicateKind, QuerySet, Question, Scene, SceneError, Sign};

pub(super) use list::of;

use super::{SignQueries, queries};

/// Points near and on the zeros of a formula, at several scales, with the exact sign at each: half near, half ties.
///
/// If the formula has weights, each point ends with its weight. The same seed gives the same points.
#[must_use]
pub fn adversaries(formula: &Formula, count: usize, seed: u64) -> Vec<(Vec<Vec<f64>>, Sign)> {
    let mut rng = Random::new("adversaries", formula.name(), seed);
    let one = |at: usize| {
        let mut all = Vec::new();
        if at.is_multiple_of(2) {
            formula::near(formula, 2, &mut rng, &mut all)
        } else {
            formula::tie(formula, &mut rng, &mut all)
        }
        let points: Vec<Vec<f64>> = all.chunks(formula.coordinates()).map(<[f64]>::to_vec).collect();
        let slices: Vec<&[f64]> = points.iter().map(Vec::as_slice).collect();
        let value = predicament_judge::formula_value(formula, &slices).unwrap_or_default();
        (points, value.cmp0().into())
    };
    (0..count).map(one).collect()
}

/// The keys of a generator's table that all families share.
#[derive(Clone, Copy)]
struct Asked {
    question: Question,
    dimension: Dimension,
}

impl Asked {
    /// Reads `axis`, `plane` and `dimension`; `fixed` is the dimension of the family's points, if the table cannot
    /// choose it.
    fn read(task: &'static str, fields: &Fields<'_, '_>, fixed: Option<Dimension>) -> Result<Asked, CorpusError> {
        let kind: PredicateKind = task.parse().unwrap_or_else(|error| panic!("{error}"));
        let question = queries::question(fields, kind)?;
        let fits = |dimension, cure: &str| {
            queries::fits(question, dimension).map_err(|(message, _)| fields.error(message, cure))?;
            Ok(Asked { question, dimension })
        };
        if let Some(dimension) = fixed {
            return fits(dimension, "choose an axis or a plane that the family's points have");
        }
        let dimension = match (kind, fields.get("dimension")) {
            (PredicateKind::Compare | PredicateKind::Orient2d, Some(field)) if field.integer(2..=3)? == 3 => {
                Dimension::Three
            }
            (PredicateKind::Orient3d | PredicateKind::Insphere, _) => Dimension::Three,
            (PredicateKind::Derived(derived), _) => derived.dimension(),
            (PredicateKind::Compare | PredicateKind::Orient2d | PredicateKind::Incircle, _) => Dimension::Two,
        };
        fits(dimension, "write `dimension = 3`")
    }

    fn kind(self) -> PredicateKind {
        self.question.kind()
    }

    /// The number of coordinates of a number of queries without common points.
    fn coordinates(self, queries: u64) -> u64 {
        queries * (self.kind().arity() * self.dimension.count()) as u64
    }

    /// The scene of a cloud.
    fn parts(self, cloud: Cloud) -> Parts {
        let mut scene = self.scene(cloud.coordinates).expect("generators make finite points");
        for construction in cloud.constructions {
            scene.construct(construction).expect("generators construct from the scene's points");
        }
        let args = cloud.args.unwrap_or_else(|| scene.vertices().collect());
        Parts::new(scene, SignQueries::new(QuerySet::new(self.question, args)))
    }

    /// The scene of points; each ends with its weight if the question is about weights.
    fn scene(self, coordinates: Vec<f64>) -> Result<Scene, SceneError> {
        let Question::Derived(derived) = self.question else { return Scene::new(self.dimension, coordinates) };
        if !derived.formula().is_weighted() {
            return Scene::new(self.dimension, coordinates);
        }
        let weighted = coordinates.chunks_exact(self.dimension.count() + 1);
        let weights = weighted.clone().map(|point| point[point.len() - 1]).collect();
        let points = weighted.flat_map(|point| &point[..point.len() - 1]).copied().collect();
        Scene::new(self.dimension, points)?.with_weights(weights)
    }

    /// Integers of points in a family's own plane, with zeros for coordinates that the question does not use.
    fn in_its_plane(self, integers: Vec<i128>) -> Vec<i128> {
        let (Question::Orient2d(plane), Dimension::Three) = (self.question, self.dimension) else { return integers };
        let [x, y] = plane.axes().map(Axis::index);
        let placed = |pair: &[i128; 2]| {
            let mut point = [0; 3];
            (point[x], point[y]) = (pair[0], pair[1]);
            point
        };
        integers.as_chunks().0.iter().flat_map(placed).collect()
    }

    /// The scene of a cloud whose points are in the family's own plane.
    fn placed(self, cloud: Cloud, making: &Making) -> Parts {
        let mut rest = Random::new(making.family, "coordinates that nobody asks about", making.seed);
        let coordinates = place(cloud.coordinates, self.question, self.dimension, &mut rest);
        self.parts(Cloud { coordinates, ..cloud })
    }
}

/// A recipe that makes a scene query by query: a smaller scene is a prefix of a larger one.
fn by_query(
    task: &'static str,
    fields: &Fields<'_, '_>,
    query: impl Fn(PredicateKind, &mut Random, &mut Vec<f64>) + Send + Sync + 'static,
) -> Result<Recipe, CorpusError> {
    let asked = Asked::read(task, fields, None)?;
    Ok(Recipe::new(
        move |n| asked.coordinates(n),
        move |making| {
            let (kind, mut rng) = (asked.kind(), making.random());
            let mut coordinates = Vec::with_capacity(making.n * kind.arity() * native(kind));
            for _ in 0..making.n {
                query(kind, &mut rng, &mut coordinates);
            }
            asked.placed(Cloud { coordinates, ..Cloud::default() }, making)
        },
    ))
}
