//! Families of scenes made by programs.
//!
//! A family is a way of being difficult: nearly degenerate, exactly
//! degenerate, far away, huge. The same family, task, parameters and seed give
//! the same bits on every platform: ChaCha8 is seeded with a hash of them,
//! and coordinates come from integer arithmetic, + − · / and square roots
//! only, which IEEE 754 rounds the same everywhere.

mod band;
mod degenerate;
mod far;
mod kettner;
mod maps;
mod near;
mod pixels;
mod plain;
mod random;
mod shape;
mod wide;

use predicament_predicates::{Dimension, PredicateKind, QuerySet, Question, Scene, Vertex};

use crate::document::{Field, Fields};
use crate::probes::with_probes;
use crate::suite::Probing;
use crate::{CorpusError, Level, Task, Work};
use pixels::PixelMap;
pub(crate) use random::Random;

/// A family of generated scenes, for listings.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FamilyInfo {
    /// The name in `[[generate]]` tables.
    pub name: &'static str,
    /// The name in `throughput.csv`.
    pub reported_as: &'static str,
    /// The tasks that it can generate for.
    pub tasks: &'static [Task],
    /// The parameters that it takes besides `n`, `seed` and the question's.
    pub parameters: &'static [&'static str],
    /// What it is, in one line.
    pub about: &'static str,
}

const SIGNS: &[Task] = &[Task::Compare, Task::Orient2d, Task::Orient3d, Task::Incircle, Task::Insphere];
const MAPS: &[Task] = &[Task::PolygonLocate];

const fn family(
    name: &'static str,
    reported_as: &'static str,
    tasks: &'static [Task],
    parameters: &'static [&'static str],
    about: &'static str,
) -> FamilyInfo {
    FamilyInfo { name, reported_as, tasks, parameters, about }
}

const FAMILIES: [FamilyInfo; 17] = [
    family("uniform", "uniform", SIGNS, &[], "multiples of 2^-53, uniform in [0, 1)"),
    family("grid", "grid", SIGNS, &[], "integers from 0 to 15: many ties, all arithmetic short"),
    family("near", "near", SIGNS, &["ulps"], "moved by at most so many ulps off a line, plane, circle or sphere"),
    family(
        "kettner",
        "kettner",
        SIGNS,
        &[],
        "0.5 + k·2^-53, k < 256, against a line, plane, circle or sphere through 0.5",
    ),
    family("degen", "degen", SIGNS, &[], "exactly degenerate in general position: every answer is 0"),
    family(
        "decimal-collinear",
        "decimal-collinear",
        &[Task::Orient2d],
        &["digits"],
        "collinear decimals, rounded to doubles",
    ),
    family(
        "decimal-coplanar",
        "decimal-coplanar",
        &[Task::Orient3d],
        &["digits"],
        "coplanar decimals, rounded to doubles",
    ),
    family(
        "decimal-cocircular",
        "decimal-cocircular",
        &[Task::Incircle],
        &["digits"],
        "cocircular decimals, rounded to doubles",
    ),
    family(
        "decimal-cospherical",
        "decimal-cospherical",
        &[Task::Insphere],
        &["digits"],
        "cospherical decimals, rounded to doubles",
    ),
    family(
        "midpoint-collinear",
        "midpoint-collinear",
        &[Task::Orient2d, Task::Orient3d],
        &[],
        "two points and their rounded midpoint; in 3D with any fourth",
    ),
    family("wide-scaled", "wide", SIGNS, &[], "uniform, near and degen queries scaled by 2^k, subnormal to 2^1023"),
    family("wide-mixed", "wide", SIGNS, &[], "every coordinate with its own exponent, subnormal to 2^1023"),
    family("far", "far", SIGNS, &[], "unit clusters 2^20 to 2^45 away from the origin"),
    family(
        "band",
        "band",
        &[Task::Orient2d, Task::Orient3d],
        &[],
        "determinants around the tolerance scheme's thresholds",
    ),
    family(
        "pixel-map",
        "pixel-map",
        &[Task::Orient2d],
        &["p", "q", "r", "side", "step"],
        "a square of neighbours of p against fixed q and r (Kettner et al.)",
    ),
    family("tiling", "tiling", MAPS, &[], "a jittered n×n quadrilateral tiling with lakes, islands and sea"),
    family("bricks", "bricks", MAPS, &[], "n courses of n bricks: axis-parallel borders and collinear runs"),
];

/// Every family, for listings.
#[must_use]
pub fn families() -> &'static [FamilyInfo] {
    &FAMILIES
}

/// A family with its parameters.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Family {
    info: &'static FamilyInfo,
    recipe: Recipe,
}

#[derive(Clone, PartialEq, Debug)]
enum Recipe {
    Uniform,
    Grid,
    Near { ulps: i64 },
    Kettner,
    Degen,
    Decimal { digits: u32 },
    Midpoint,
    WideScaled,
    WideMixed,
    Far,
    Band,
    PixelMap(PixelMap),
    Tiling,
    Bricks,
}

impl Family {
    /// Reads `family` and the parameters that go with it.
    pub(crate) fn read(name: &Field<'_, '_>, fields: &Fields<'_, '_>, task: Task) -> Result<Family, CorpusError> {
        let text = name.str()?;
        let Some(info) = FAMILIES.iter().find(|info| info.name == text) else {
            let known = FAMILIES.map(|info| info.name).join(", ");
            return Err(name.error(format!("no family is called `{text}`"), format!("use one of {known}")));
        };
        if !info.tasks.contains(&task) {
            let tasks: Vec<_> = info.tasks.iter().map(|task| task.name()).collect();
            let message = format!("family {text} generates nothing for {task}");
            return Err(name.error(message, format!("use it for {}", tasks.join(", "))));
        }
        let recipe = match text {
            "uniform" => Recipe::Uniform,
            "grid" => Recipe::Grid,
            "near" => Recipe::Near {
                ulps: fields.get("ulps").map_or(Ok(4), |f| f.integer(1..=1 << 20)).map(u64::cast_signed)?,
            },
            "kettner" => Recipe::Kettner,
            "degen" => Recipe::Degen,
            "midpoint-collinear" => Recipe::Midpoint,
            "wide-scaled" => Recipe::WideScaled,
            "wide-mixed" => Recipe::WideMixed,
            "far" => Recipe::Far,
            "band" => Recipe::Band,
            "pixel-map" => Recipe::PixelMap(PixelMap::read(fields)?),
            "tiling" => Recipe::Tiling,
            "bricks" => Recipe::Bricks,
            _ => Recipe::Decimal {
                digits: fields.integer_or("digits", 1, 1..=9).map(|n| u32::try_from(n).unwrap_or(9))?,
            },
        };
        Ok(Family { info, recipe })
    }

    /// The name in suites.
    pub(crate) fn name(&self) -> &'static str {
        self.info.name
    }

    /// The name in `throughput.csv`.
    pub(crate) fn reported_as(&self) -> &'static str {
        self.info.reported_as
    }

    /// The parameters that the family takes.
    pub(crate) fn parameters(&self) -> &'static [&'static str] {
        self.info.parameters
    }

    /// The number of queries, where the parameters fix it.
    pub(crate) fn fixed_size(&self) -> Option<usize> {
        match &self.recipe {
            Recipe::PixelMap(map) => Some(map.pixels()),
            _ => None,
        }
    }

    /// Points for `n` queries of one kind.
    fn points(&self, kind: PredicateKind, n: usize, rng: &mut Random) -> Cloud {
        match &self.recipe {
            Recipe::Band => return band::band(kind, n, rng),
            Recipe::PixelMap(map) => return map.points(),
            _ => {}
        }
        let mut coordinates = Vec::with_capacity(n * kind.arity() * native(kind));
        for _ in 0..n {
            self.query(kind, rng, &mut coordinates);
        }
        Cloud { coordinates, args: None }
    }

    /// Appends the points of one query.
    fn query(&self, kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
        match self.recipe {
            Recipe::Uniform => plain::uniform(kind, rng, out),
            Recipe::Grid => plain::grid(kind, rng, out),
            Recipe::Near { ulps } => near::near(kind, ulps, rng, out),
            Recipe::Kettner => kettner::kettner(kind, rng, out),
            Recipe::Degen => degenerate::scaled(kind, rng, out),
            Recipe::Decimal { digits } => degenerate::decimal(kind, digits, rng, out),
            Recipe::Midpoint => near::midpoint(kind, rng, out),
            Recipe::WideScaled => wide::scaled(kind, rng, out),
            Recipe::WideMixed => wide::mixed(kind, rng, out),
            Recipe::Far => far::far(kind, rng, out),
            Recipe::Band | Recipe::PixelMap(_) | Recipe::Tiling | Recipe::Bricks => {
                unreachable!("{} is not made query by query", self.name())
            }
        }
    }
}

/// The number of coordinates in which a family thinks about a predicate.
fn native(kind: PredicateKind) -> usize {
    match kind {
        PredicateKind::Compare | PredicateKind::Orient2d | PredicateKind::Incircle => 2,
        PredicateKind::Orient3d | PredicateKind::Insphere => 3,
    }
}

/// Points, and the queries where these are not simply one after the other.
struct Cloud {
    coordinates: Vec<f64>,
    args: Option<Vec<Vertex>>,
}

/// How many queries, by level.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Amount {
    pub(crate) quick: usize,
    pub(crate) full: usize,
}

/// What is made of a family's points.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    /// Queries in 2D or 3D.
    Signs { question: Question, dimension: Dimension },
    /// A map with probes.
    Map(Probing),
}

/// A generated scene before it is generated.
#[derive(Clone, Debug)]
pub(crate) struct Generator {
    pub(crate) family: Family,
    pub(crate) amount: Amount,
    pub(crate) shape: Shape,
    pub(crate) seed: u64,
}

impl Generator {
    /// Makes the scene. The queries of a smaller amount come first in a larger one.
    pub(crate) fn run(&self, task: Task, level: Level) -> (Scene, Work) {
        let n = match level {
            Level::Quick => self.amount.quick,
            Level::Full => self.amount.full,
        };
        let mut rng = Random::new(self.family.name(), task.name(), self.seed);
        match self.shape {
            Shape::Map(probing) => {
                let (points, map) = match self.family.recipe {
                    Recipe::Bricks => maps::bricks(n),
                    _ => maps::tiling(n, &mut rng),
                };
                with_probes(points, map, probing, level)
            }
            Shape::Signs { question, dimension } => {
                let cloud = self.family.points(question.kind(), n, &mut rng);
                let mut rest = Random::new(self.family.name(), "coordinates that nobody asks about", self.seed);
                let coordinates = shape::place(cloud.coordinates, question, dimension, &mut rest);
                let scene = Scene::new(dimension, coordinates).expect("generators make finite points");
                let args = cloud.args.unwrap_or_else(|| scene.vertices().collect());
                (scene, Work::Signs(QuerySet::new(question, args)))
            }
        }
    }
}
