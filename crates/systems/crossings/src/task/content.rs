//! The key `segments`: pairs of points, and families of them.

use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Family, Items, Level, List, Making, Parts, Random, Recipe, Source, Spelled,
    spelled_points,
};
use predicament_formats::bits::integer;
use predicament_formats::{Cache, CorpusError, Entry, Fields};
use predicament_predicates::{Scene, Vertex};

use predicament_tasks::segment_source::SegmentSource;

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

    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        Some(Spelled { lists: vec![List::required("segments", Items::tuples(&self.0))], ..spelled_points(scene) })
    }
}

/// Reads `points` and `segments`.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let asked = Asked(SegmentSource::read(context, fields, "crossings")?);
    if asked.0.is_written() {
        // Nothing comes from the cache: everything is written out.
        return Ok(Source::Written(asked.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(Source::elsewhere(asked))
}

/// The source of a scene's segments.
struct Asked(SegmentSource);

impl Elsewhere for Asked {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (scene, segments, notes) = self.0.load(cache)?;
        Ok(Parts { notes, ..Parts::new(scene, Segments(segments)) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.0.entry()
    }
}

/// The families of segments.
pub(super) static FAMILIES: [Family; 4] = [
    Family {
        name: "segments-uniform",
        reported_as: Some("segments-uniform"),
        parameters: &[],
        about: "segments between points uniform in the unit square",
        read: |_, _| Ok(recipe(uniform)),
    },
    Family {
        name: "segments-short",
        reported_as: Some("segments-short"),
        parameters: &[],
        about: "short segments, uniform in the unit square: each crosses about one other",
        read: |_, _| Ok(recipe(short)),
    },
    Family {
        name: "segments-lattice",
        reported_as: Some("segments-lattice"),
        parameters: &[],
        about: "lines of a lattice and its diagonals: three or four cross in each lattice point",
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
    Recipe::new(
        |n| 4 * n,
        move |making: &Making| {
            let points = points(making.n, &mut making.random());
            let segments = (0..points.len() / 2).map(|at| [2 * at, 2 * at + 1].map(Vertex::input)).collect();
            Parts::new(Scene::from_points2(&points).expect("generators make finite points"), Segments(segments))
        },
    )
}

/// Segments between points uniform in the unit square.
pub fn uniform(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    (0..2 * n).map(|_| [rng.unit(), rng.unit()]).collect()
}

/// Short segments, uniform in the unit square: each crosses about one other.
pub fn short(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    let side = i64::try_from(n.isqrt().max(1)).expect("scenes are smaller than memory");
    let length = 1.5 / integer(side);
    let segment = |_| {
        let a = [rng.unit(), rng.unit()];
        [a, a.map(|x| x + rng.between(-length, length))]
    };
    (0..n).flat_map(segment).collect()
}

/// Segments of the lines x = i, y = i, x + y = i and x − y = i in turn, through a square and half a unit beyond it.
pub fn lattice(n: usize, _: &mut Random) -> Vec<[f64; 2]> {
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

/// Segments through the centre, up to the rounding of the second end.
pub fn near(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    let end = |rng: &mut Random| [rng.unit(), rng.unit()];
    (0..n)
        .flat_map(|_| {
            let a = end(rng);
            let stretch = rng.between(0.5, 1.0);
            [a, a.map(|x| 0.5 + stretch * (0.5 - x))]
        })
        .collect()
}
