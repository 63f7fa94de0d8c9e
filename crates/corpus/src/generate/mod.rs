//! Families of scenes made by programs.
//!
//! A family is a way of being difficult: nearly degenerate, exactly
//! degenerate, far away, huge. The same family, task, parameters and seed give
//! the same bits on every platform: ChaCha8 is seeded with a hash of them,
//! and coordinates come from integer arithmetic, + − · / and square roots
//! only, which IEEE 754 rounds the same everywhere.

mod band;
mod constructed;
mod contacts;
mod cubes;
mod degenerate;
mod families;
mod far;
mod kettner;
mod maps;
mod near;
mod partition;
mod pixels;
mod plain;
mod random;
mod shape;
mod wide;

use predicament_predicates::{Axis, Construction, Dimension, PredicateKind, QuerySet, Question, Scene, Vertex};

use crate::document::{Field, Fields};
use crate::probes::with_probes;
use crate::suite::Probing;
use crate::{CorpusError, Level, Task, Work};
use constructed::Arrangement;
use contacts::Pair;
use cubes::Cubes;
use families::FAMILIES;
pub use families::{FamilyInfo, families};
use partition::Ends;
use pixels::PixelMap;
pub use random::Random;

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
    Arrangement(Arrangement),
    Pair(Pair),
    Cells(Ends),
    Cubes(Cubes),
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
        if let Some(arrangement) = Arrangement::read(text, fields)? {
            return Ok(Family { info, recipe: Recipe::Arrangement(arrangement) });
        }
        if let Some(pair) = Pair::read(text, fields)? {
            return Ok(Family { info, recipe: Recipe::Pair(pair) });
        }
        if let Some(cubes) = Cubes::read(text, fields)? {
            return Ok(Family { info, recipe: Recipe::Cubes(cubes) });
        }
        let recipe = match text {
            "uniform" => Recipe::Uniform,
            "grid" => Recipe::Grid,
            "near" => Recipe::Near { ulps: fields.integer_or("ulps", 4, 1..=1 << 20).map(u64::cast_signed)? },
            "kettner" => Recipe::Kettner,
            "degen" => Recipe::Degen,
            "midpoint-collinear" => Recipe::Midpoint,
            "wide-scaled" => Recipe::WideScaled,
            "wide-mixed" => Recipe::WideMixed,
            "far" => Recipe::Far,
            "band" => Recipe::Band,
            "pixel-map" => Recipe::PixelMap(PixelMap::read(fields)?),
            "cells-uniform" => Recipe::Cells(Ends::Uniform),
            "cells-degen" => Recipe::Cells(Ends::Repeated),
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

    /// The number of coordinates of the family's points, where it is not for the question to say.
    pub(crate) fn dimension(&self) -> Option<Dimension> {
        match &self.recipe {
            Recipe::Arrangement(arrangement) => Some(arrangement.dimension()),
            _ => None,
        }
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
        Cloud { coordinates, args: None, constructions: Vec::new() }
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
            Recipe::Band
            | Recipe::PixelMap(_)
            | Recipe::Arrangement(_)
            | Recipe::Pair(_)
            | Recipe::Cells(_)
            | Recipe::Cubes(_)
            | Recipe::Tiling
            | Recipe::Bricks => {
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

/// Points, what is constructed from them, and the queries where these are not
/// simply one after the other.
struct Cloud {
    coordinates: Vec<f64>,
    args: Option<Vec<Vertex>>,
    constructions: Vec<Construction>,
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
    /// Cells of a line with probes.
    Cells { axis: Axis, dimension: Dimension },
    /// A map with probes.
    Map(Probing),
    /// Congruent cubes.
    Cubes,
    /// Two complexes.
    Contacts,
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
    /// Makes the scene. The queries of a smaller amount come first in a larger one,
    /// unless they make a whole: cells, maps, cubes, complexes.
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
            Shape::Cells { axis, dimension } => match self.family.recipe {
                Recipe::Cells(ends) => partition::make(ends, n, axis, dimension, &mut rng),
                _ => unreachable!("{} makes no cells", self.family.name()),
            },
            Shape::Cubes => match self.family.recipe {
                Recipe::Cubes(cubes) => cubes.make(n, &mut rng),
                _ => unreachable!("{} makes no cubes", self.family.name()),
            },
            Shape::Contacts => match self.family.recipe {
                Recipe::Pair(pair) => pair.make(n, &mut rng),
                _ => unreachable!("{} makes no complexes", self.family.name()),
            },
            Shape::Signs { question, dimension } => {
                let cloud = match self.family.recipe {
                    Recipe::Arrangement(arrangement) => arrangement.queries(question, n, rng),
                    _ => {
                        let cloud = self.family.points(question.kind(), n, &mut rng);
                        let mut rest = Random::new(self.family.name(), "coordinates that nobody asks about", self.seed);
                        let coordinates = shape::place(cloud.coordinates, question, dimension, &mut rest);
                        Cloud { coordinates, ..cloud }
                    }
                };
                let mut scene = Scene::new(dimension, cloud.coordinates).expect("generators make finite points");
                for construction in cloud.constructions {
                    scene.construct(construction).expect("generators construct from the scene's points");
                }
                let args = cloud.args.unwrap_or_else(|| scene.vertices().collect());
                (scene, Work::Signs(QuerySet::new(question, args)))
            }
        }
    }
}
