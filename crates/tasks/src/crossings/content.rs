//! `segments`: pairs of points, and families of them.

use predicament_corpus::{Canon, Content, Family, Making, Parts, Random, Recipe};
use predicament_formats::bits::integer;
use predicament_formats::{CorpusError, Fields, read_points};
use predicament_predicates::{Dimension, Scene, Vertex};

/// Segments of the plane by their ends.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Segments(pub Vec<[Vertex; 2]>);

impl Content for Segments {
    fn count(&self) -> usize {
        self.0.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("crossings");
        canon.vertices(self.0.as_flattened());
    }
}

/// Reads `points` and `segments`; without the latter, every two points in turn are a segment.
pub(super) fn read(fields: &Fields<'_, '_>) -> Result<Parts, CorpusError> {
    let field = fields.required("points")?;
    let (dimension, coordinates) = read_points(&field)?;
    if dimension == Dimension::Three {
        return Err(field.error("crossings takes points of 2 coordinates, not of 3", "give every point 2 coordinates"));
    }
    let scene =
        Scene::new(dimension, coordinates).map_err(|error| field.error(error.to_string(), "correct the points"))?;
    let mut segments: Vec<[Vertex; 2]> = Vec::new();
    match fields.get("segments") {
        None if scene.len() % 2 == 1 => {
            let message = format!("{} points don't divide into segments", scene.len());
            return Err(field.error(message, "add or remove a point, or write `segments`"));
        }
        None => segments.extend((0..scene.len() / 2).map(|at| [2 * at, 2 * at + 1].map(Vertex::input))),
        Some(listed) => {
            for item in listed.items("segments: arrays of the indices of two points")? {
                let ends: Vec<Vertex> =
                    item.items("the indices of two points")?.map(|end| end.point()).collect::<Result<_, _>>()?;
                let [a, b] = *ends.as_slice() else {
                    let message = format!("a segment of {} ends", ends.len());
                    return Err(item.error(message, "write the indices of two points"));
                };
                if let Some(unknown) = ends.iter().find(|end| end.index() >= scene.len()) {
                    let message = format!("the end {unknown} is out of range: the scene has {} points", scene.len());
                    return Err(item.error(message, "indices count from 0"));
                }
                if a == b {
                    return Err(item.error(format!("both ends are point {a}"), "name two points"));
                }
                segments.push([a, b]);
            }
        }
    }
    if segments.is_empty() {
        return Err(field.error("a scene without segments", "write at least one"));
    }
    Ok(Parts::new(scene, Segments(segments)))
}

/// The families of segments.
pub(super) static FAMILIES: [Family; 3] = [
    Family {
        name: "segments-uniform",
        reported_as: Some("segments-uniform"),
        parameters: &[],
        about: "segments between points uniform in the unit square",
        read: |_, _| Ok(recipe(uniform)),
    },
    Family {
        name: "segments-lattice",
        reported_as: Some("segments-lattice"),
        parameters: &[],
        about: "lines of a lattice and its diagonals: three or four cross in each point of it",
        read: |_, _| Ok(recipe(lattice)),
    },
    Family {
        name: "segments-near",
        reported_as: Some("segments-near"),
        parameters: &[],
        about: "segments that pass the centre of the unit square within a few ulps",
        read: |_, _| Ok(recipe(near)),
    },
];

fn recipe(points: fn(usize, &mut Random) -> Vec<[f64; 2]>) -> Recipe {
    Recipe::new(move |making: &Making| {
        let points = points(making.n, &mut making.random());
        let segments = (0..points.len() / 2).map(|at| [2 * at, 2 * at + 1].map(Vertex::input)).collect();
        Parts::new(Scene::from_points2(&points).expect("generators make finite points"), Segments(segments))
    })
}

fn uniform(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    (0..2 * n).map(|_| [rng.unit(), rng.unit()]).collect()
}

/// The lines x = i, y = i, x + y = i and x − y = i in turn, through a square and half a unit beyond it.
fn lattice(n: usize, _: &mut Random) -> Vec<[f64; 2]> {
    let side = i64::try_from(n.div_ceil(4).max(1)).expect("scenes are smaller than memory");
    let (low, high) = (-0.5, integer(side) + 0.5);
    (0..n)
        .flat_map(|at| {
            let i = integer(i64::try_from(at / 4).expect("scenes are smaller than memory"));
            match at % 4 {
                0 => [[i, low], [i, high]],
                1 => [[low, i], [high, i]],
                2 => [[low, i - low], [high, i - high]],
                _ => [[low, low - i], [high, high - i]],
            }
        })
        .collect()
}

/// Through the centre up to the rounding of the second end.
fn near(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    let end = |rng: &mut Random| [rng.unit(), rng.unit()];
    (0..n)
        .flat_map(|_| {
            let a = end(rng);
            let stretch = rng.between(0.5, 1.0);
            [a, a.map(|x| 0.5 + stretch * (0.5 - x))]
        })
        .collect()
}
