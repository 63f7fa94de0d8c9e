//! The keys `points`, `segments`, `pixel` and `method`, and families of segments.

use crate::algorithm::snap::Method;
use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Family, Items, Level, List, Making, Parts, Random, Recipe, Source, Spelled,
    spelled_points,
};
use predicament_formats::{Cache, CorpusError, Entry, Fields};
use predicament_predicates::{Scene, Vertex};

use predicament_crossings::task::content::{lattice, near, short, uniform};
use predicament_tasks::segment_source::SegmentSource;

/// Segments, and the pixels to which they are rounded.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Drawn {
    /// The segments as pairs of ends, the lower one first; ascending, each once, all with a length.
    pub segments: Vec<[Vertex; 2]>,
    /// The binary logarithm of a pixel's side.
    pub pixel: i32,
    /// The method of rounding.
    pub method: Method,
}

impl Drawn {
    fn new(mut segments: Vec<[Vertex; 2]>, pixel: i32, method: Method) -> Drawn {
        segments.iter_mut().for_each(|ends| ends.sort_unstable());
        segments.retain(|[a, b]| a != b);
        segments.sort_unstable();
        segments.dedup();
        Drawn { segments, pixel, method }
    }
}

impl Content for Drawn {
    fn count(&self) -> usize {
        self.segments.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("snap2d");
        canon.text(method_name(self.method));
        canon.text(&self.pixel.to_string());
        canon.vertices(self.segments.as_flattened());
    }

    /// Returns `None` if every segment is a single point: a suite cannot contain such segments.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let lists = vec![List::required("segments", Items::tuples(&self.segments))];
        let words = vec![("pixel", (-self.pixel).to_string()), ("method", format!("\"{}\"", method_name(self.method)))];
        (!self.segments.is_empty()).then(|| Spelled { words, lists, ..spelled_points(scene) })
    }
}

/// The name of a method in suites.
pub fn method_name(method: Method) -> &'static str {
    match method {
        Method::Naive => "naive",
        Method::Snap => "snap",
        Method::Iterated => "iterated",
    }
}

fn parameters(fields: &Fields<'_, '_>) -> Result<(i32, Method), CorpusError> {
    let pixel = fields.integer_or("pixel", 0, 0..=1100);
    let pixel = match fields.get("pixel") {
        None => 0,
        Some(_) => i32::try_from(pixel?).expect("at most 1100"),
    };
    let method = match fields.get("method") {
        None => Method::Snap,
        Some(field) => {
            let name = field.str()?;
            let known = [Method::Naive, Method::Snap, Method::Iterated].into_iter().find(|&m| method_name(m) == name);
            known.ok_or_else(|| {
                field.error(format!("unknown method `{name}`"), "write \"naive\", \"snap\" or \"iterated\"")
            })?
        }
    };
    Ok((-pixel, method))
}

/// Reads a scene.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let (pixel, method) = parameters(fields)?;
    let asked = Asked {
        source: SegmentSource::read(context, fields, "snap2d")?,
        pixel,
        method,
        file: fields.file().to_owned(),
        line: fields.line(),
    };
    if asked.source.is_written() {
        // No cache is read: all coordinates are in the suite.
        return Ok(Source::Written(asked.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(Source::elsewhere(asked))
}

struct Asked {
    source: SegmentSource,
    pixel: i32,
    method: Method,
    file: String,
    line: usize,
}

impl Elsewhere for Asked {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (scene, segments, notes) = self.source.load(cache)?;
        if let Some(v) = too_far(&scene, self.pixel) {
            let message =
                format!("point {v} is 2^50 pixels or more from the origin, or not a multiple of 2^-1074 pixels");
            return Err(CorpusError::file(
                &self.file,
                message,
                "choose another `pixel`: the side of a pixel is 2^-pixel",
            )
            .at_line(self.line));
        }
        Ok(Parts { notes, ..Parts::new(scene, Drawn::new(segments, self.pixel, self.method)) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.source.entry()
    }
}

/// A point for which pixels of this size are too small or too large.
fn too_far(scene: &Scene, pixel: i32) -> Option<Vertex> {
    use crate::algorithm::snap::{Drawing, SnapError, snap};
    let points: Vec<[f64; 2]> = super::points(scene);
    let drawing = Drawing { points: &points, segments: &[], crossings: &[], touching: &[] };
    match snap(drawing, pixel, Method::Naive) {
        Err(SnapError::Point(at)) => Some(Vertex::input(at as usize)),
        _ => None,
    }
}

macro_rules! family {
    ($name:literal, $about:literal, $points:path) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: &[],
            about: $about,
            read: |_, fields| recipe(fields, $points),
        }
    };
}

/// The families of segments.
pub(super) static FAMILIES: [Family; 5] = [
    family!("snap-uniform", "segments between points uniform in the unit square", uniform),
    family!("snap-short", "short segments, uniform in the unit square: each crosses about one other", short),
    family!("snap-lattice", "lines of a lattice and its diagonals: crossings at corners of pixels", lattice),
    family!("snap-near", "segments that pass the centre of the unit square within a few ulps", near),
    family!("snap-fans", "two fans of segments that cross at small angles: many hot pixels near each segment", fans),
];

fn recipe(fields: &Fields<'_, '_>, points: fn(usize, &mut Random) -> Vec<[f64; 2]>) -> Result<Recipe, CorpusError> {
    let (pixel, method) = parameters(fields)?;
    let make = move |making: &Making| {
        let points = points(making.n, &mut making.random());
        let segments = (0..points.len() / 2).map(|at| [2 * at, 2 * at + 1].map(Vertex::input)).collect();
        let scene = Scene::from_points2(&points).expect("generators make finite points");
        Parts::new(scene, Drawn::new(segments, pixel, method))
    };
    Ok(Recipe::new(|n| 4 * n, make))
}

/// Segments from two points at the left to points in a column at the right, in order and in the opposite order.
fn fans(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    (0..n).flat_map(|at| [[0.0, if at % 2 == 0 { 0.25 } else { 0.75 }], [1.0, rng.unit()]]).collect()
}
