//! The truth about a union: measured in sections, which do not use vertices, and by the judge's cells.
//!
//! There are two unions: that of the perturbed cubes, for backends that break ties, and that of the closed cubes, for
//! backends whose zero means zero. They are equal if no two faces are in one plane.

use crate::checks::{Measures, Ties, measured, measured_by};
use predicament_judge::cubes::{self as exact, Cubes as Judged};
use predicament_judge::rational;
use predicament_predicates::{Dimension, Scene, Vertex};
use predicament_tasks::{Stop, Watch};
use rug::{Integer, Rational};

/// The truth about a union.
pub struct Truth {
    /// The measures of the whole union, in units of a power of two.
    pub measures: Measures,
    /// The vertices of the perturbed union, if the judge has measured all of it.
    pub vertices: Option<exact::Vertices>,
    /// The measures of the whole union of closed cubes, in the same units.
    pub closed: Measures,
    /// The measures and vertices of the union of closed cubes by the judge's cells, if there are few enough cells.
    pub counted: Option<exact::Closed>,
    /// The exponent of the unit: lengths are multiples of 2^`exponent`.
    pub exponent: i32,
    /// The part of the cubes that the judge has measured, if it has not measured all.
    pub(crate) part: Option<Part>,
}

/// Some of the cubes as a separate union.
pub(crate) struct Part {
    pub(crate) scene: Scene,
    pub(crate) cubes: usize,
    pub(crate) of: usize,
    pub(crate) measures: exact::Measures,
    pub(crate) closed: Option<exact::Closed>,
}

impl Truth {
    /// Measures the union.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    ///
    /// # Panics
    /// If the scene does not consist of congruent cubes that exact sums can hold (readers of scenes check this), or the
    /// two measurements differ.
    pub fn new(scene: &Scene, watch: &Watch) -> Result<Truth, Stop> {
        let judged = Judged::of_scene(scene).unwrap_or_else(|error| panic!("not a scene of cubes: {error}"));
        let (lowers, edge, exponent) = integers(scene);
        let measures = measured(&lowers, edge);
        let is_tied = judged.have_common_planes();
        let closed = if is_tied { measured_by(&lowers, edge, Ties::Merged) } else { measures };
        watch.done(0)?;
        let sample = judged.sample();
        let sampled = judged.only(&sample);
        let found = sampled.measures();
        watch.done(judged.len() as u64)?;
        let is_whole = sample.len() == judged.len();
        let counted = match is_tied {
            true => judged.closed(),
            false => is_whole.then(|| untied(&found)),
        };
        if let Some(counted) = &counted {
            let of = [&counted.volume, &counted.area, &counted.edge_length];
            let by_sections = in_units(&closed, exponent);
            assert_eq!(by_sections.each_ref(), of, "the cells contradict the sections of a union of closed cubes");
        }
        let mut truth = Truth { measures, vertices: None, closed, counted, exponent, part: None };
        if !is_whole {
            let corners = sample.iter().flat_map(|&cube| [2 * cube, 2 * cube + 1]);
            let corners = corners.flat_map(|corner| scene.point(Vertex::input(corner)).to_vec()).collect();
            let part = Scene::new(Dimension::Three, corners).expect("corners of the scene");
            let closed = if sampled.have_common_planes() { sampled.closed() } else { Some(untied(&found)) };
            let (cubes, of) = (sample.len(), judged.len());
            truth.part = Some(Part { scene: part, cubes, of, measures: found, closed });
        } else {
            let of = [&found.volume, &found.area, &found.edge_length];
            let by_sections = in_units(&measures, exponent);
            assert_eq!(by_sections.each_ref(), of, "the judge contradicts the sections of a union");
            truth.vertices = Some(found.vertices);
        }
        Ok(truth)
    }

    /// The number of cubes that the judge has measured, in words, if it is not all.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        let part = self.part.as_ref()?;
        Some(format!("{} of {} cubes measured by the definition, and all by sections", part.cubes, part.of))
    }

    /// A sum of products of this many lengths, in the scene's units: rounded once.
    #[allow(clippy::cast_precision_loss)]
    fn in_scene_units(&self, sum: i128, lengths: i32) -> f64 {
        let exponent = lengths * self.exponent;
        // Two steps, as a power of two may not be a double even if the product is.
        sum as f64 * 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2)
    }

    /// Volume, area and edge length in the scene's units, each rounded once.
    pub(crate) fn in_units(&self, of: &Measures) -> [f64; 3] {
        [self.in_scene_units(of.volume, 3), self.in_scene_units(of.area, 2), self.in_scene_units(of.edge_length, 1)]
    }
}

/// The measures of the union of closed cubes, of which no two have faces in one plane: those of the perturbed union.
fn untied(moved: &exact::Measures) -> exact::Closed {
    let exact::Vertices { corners, edge_faces, three_faces } = moved.vertices;
    // The filled octants of the three kinds.
    let counts = [(0b1, corners), (0b1_1111, edge_faces), (0b111_1111, three_faces)];
    let [corners, edge_faces, three_faces] = counts.map(|(_, count)| count.cast_signed());
    let counts = counts.into_iter().filter(|&(_, count)| count > 0);
    exact::Closed {
        volume: moved.volume.clone(),
        area: moved.area.clone(),
        edge_length: moved.edge_length.clone(),
        // By Gauss and Bonnet, half of the characteristic of the boundary.
        euler_characteristic: (corners - edge_faces + three_faces) / 8,
        vertices: counts.map(|(octants, count)| (exact::shape(octants), count)).collect(),
    }
}

/// The measures of the union of closed and of open cubes, in units of a power of two, and the exponent of the unit.
pub(crate) fn closed_and_open(scene: &Scene) -> ([Measures; 2], i32) {
    let (lowers, edge, exponent) = integers(scene);
    ([Ties::Closed, Ties::Open].map(|ties| measured_by(&lowers, edge, ties)), exponent)
}

/// Measures in units of 2^`exponent`, exactly.
pub(crate) fn in_units(of: &Measures, exponent: i32) -> [Rational; 3] {
    let scaled = |sum: i128, lengths: i32| {
        let shift = lengths * exponent;
        let sum = Rational::from(Integer::from(sum));
        if shift < 0 { sum >> shift.unsigned_abs() } else { sum << shift.unsigned_abs() }
    };
    [scaled(of.volume, 3), scaled(of.area, 2), scaled(of.edge_length, 1)]
}

/// The lower corners and the edge in units of the coarsest power of two that divides all coordinates, and its exponent.
/// Without cubes the edge is 1; if all coordinates are zero, the exponent is 0.
fn integers(scene: &Scene) -> (Vec<[i64; 3]>, i64, i32) {
    let points: Vec<[Rational; 3]> = scene.vertices().map(|v| scene.point3(v).map(rational)).collect();
    // A double is an odd integer times a power of two, or zero.
    let zeros = |of: &Integer| i64::from(of.find_one(0).unwrap_or(0));
    let finest = |x: &Rational| (!x.is_zero()).then(|| zeros(x.numer()) - zeros(x.denom()));
    let exponent = points.as_flattened().iter().filter_map(finest).min().unwrap_or(0);
    let exponent = i32::try_from(exponent).expect("an exponent of a double");
    let unit = if exponent < 0 {
        Rational::from(1) >> exponent.unsigned_abs()
    } else {
        Rational::from(1) << exponent.unsigned_abs()
    };
    let units = |x: &Rational| Rational::from(x / &unit).numer().to_i64().expect("coordinates of at most 62 bits");
    let lowers: Vec<[i64; 3]> = points.iter().step_by(2).map(|lower| lower.each_ref().map(units)).collect();
    let edge = points.get(1).map_or(1, |upper| units(&upper[0]) - lowers[0][0]);
    (lowers, edge, exponent)
}
