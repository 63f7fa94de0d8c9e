//! Volume, area and edge length against two other ways to find them.
//!
//! The whole union is measured in sections, which know no vertices. What the
//! judge can measure in time (all cubes, or a box full of them) it measures from the
//! definition, in rationals, vertices included; both have to agree. Backends run
//! the algorithm by comparing coordinates; what is wrong with their sums is what
//! they make of equal coordinates.

use crate::algorithm::{CubesError, Mass, ScaledCubes, Vertices};
use crate::checks::{Measures, measured};
use predicament_judge::cubes::{self as exact, Cubes as Judged};
use predicament_predicates::{Dimension, PredicateKind, Scene, Vertex, ZeroMeaning};
use rug::{Integer, Rational};

use super::section::MassRow;
use super::{CubeUnion, Cubes, Union};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop, Watch};

/// What is true about a union.
pub struct Truth {
    /// The whole union, in units of a power of two.
    pub measures: Measures,
    /// The vertices of the perturbed union, where the judge has measured all of it.
    pub vertices: Option<Vertices>,
    /// Lengths are multiples of 2 to this.
    pub exponent: i32,
    /// A part of the cubes that the judge has measured, where all are too many.
    part: Option<Part>,
}

/// Some of the cubes as a union of their own.
struct Part {
    scene: Scene,
    content: Cubes,
    of: usize,
    measures: exact::Measures,
}

impl Truth {
    /// Measures the union.
    ///
    /// # Panics
    /// If the scene is not of congruent cubes that exact sums can hold (readers
    /// of scenes see to that), or the two measurements differ.
    pub(super) fn new(scene: &Scene, watch: &Watch) -> Result<Truth, Stop> {
        let unfit = |error: CubesError| -> ! { panic!("no scene of cubes: {error}") };
        let cubes = ScaledCubes::of_scene(scene).unwrap_or_else(|error| unfit(error));
        let measures = measured(&cubes.lowers, cubes.edge);
        watch.done(0)?;
        let judged = Judged::of_scene(scene).unwrap_or_else(|error| panic!("no scene of cubes: {error}"));
        let sample = judged.sample();
        let found = judged.only(&sample).measures();
        watch.done(judged.len() as u64)?;
        let mut truth = Truth { measures, vertices: None, exponent: cubes.exponent, part: None };
        if sample.len() < judged.len() {
            let corners = sample.iter().flat_map(|&cube| [2 * cube, 2 * cube + 1]);
            let corners = corners.flat_map(|corner| scene.point(Vertex::input(corner)).to_vec()).collect();
            let part = Scene::new(Dimension::Three, corners).expect("corners of the scene");
            let content = Cubes { cubes: sample.len() };
            truth.part = Some(Part { scene: part, content, of: judged.len(), measures: found });
        } else {
            let of = [&found.volume, &found.area, &found.edge_length];
            assert_eq!(truth.rationals(&measures).each_ref(), of, "the judge contradicts the sections of a union");
            truth.vertices = Some(vertices(&found));
        }
        Ok(truth)
    }

    /// How many of the cubes the judge has measured, if not all.
    pub(super) fn sampled(&self) -> Option<String> {
        let part = self.part.as_ref()?;
        Some(format!("{} of {} cubes measured from the definition, all in sections", part.content.cubes, part.of))
    }

    /// Volume, area and edge length in the scene's units, exactly.
    fn rationals(&self, of: &Measures) -> [Rational; 3] {
        in_units(of, self.exponent)
    }

    /// The failed checks as [name, found, expected].
    ///
    /// Which vertices there are is for sessions that break ties: the others may
    /// find fewer where coordinates are equal, as long as the sums are right.
    fn checks(&self, found: &Mass, zero: ZeroMeaning) -> Vec<[String; 3]> {
        let truth = &self.measures;
        let mut checks = vec![
            ["volume".to_owned(), found.volume.to_string(), truth.volume.to_string()],
            ["area".to_owned(), found.area.to_string(), truth.area.to_string()],
            ["edge length".to_owned(), found.edge_length.to_string(), truth.edge_length.to_string()],
        ];
        if let Some(vertices) = self.vertices.filter(|_| zero == ZeroMeaning::Never) {
            checks.push(["vertices".to_owned(), kinds(found.vertices), kinds(vertices)]);
        }
        checks.retain(|[_, found, truth]| found != truth);
        if found.vertices.euler_characteristic().is_none() {
            let expected = "a multiple of eight quarters".to_owned();
            checks.push(["euler characteristic".to_owned(), kinds(found.vertices), expected]);
        }
        checks
    }

    /// A sum of products of so many lengths, in the scene's units: rounded once.
    #[allow(clippy::cast_precision_loss)]
    fn in_scene_units(&self, sum: i128, lengths: i32) -> f64 {
        let exponent = lengths * self.exponent;
        // Two steps, as a power of two may be no double where the product is one.
        sum as f64 * 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2)
    }

    /// Volume, area and edge length in the scene's units, each rounded once.
    fn in_units(&self, of: &Measures) -> [f64; 3] {
        [self.in_scene_units(of.volume, 3), self.in_scene_units(of.area, 2), self.in_scene_units(of.edge_length, 1)]
    }
}

fn measures(mass: &Mass) -> Measures {
    Measures { volume: mass.volume, area: mass.area, edge_length: mass.edge_length }
}

/// Measures in units of 2^`exponent`, exactly.
fn in_units(of: &Measures, exponent: i32) -> [Rational; 3] {
    let scaled = |sum: i128, lengths: i32| {
        let shift = lengths * exponent;
        let sum = Rational::from(Integer::from(sum));
        if shift < 0 { sum >> shift.unsigned_abs() } else { sum << shift.unsigned_abs() }
    };
    [scaled(of.volume, 3), scaled(of.area, 2), scaled(of.edge_length, 1)]
}

fn vertices(of: &exact::Measures) -> Vertices {
    let exact::Vertices { corners, edge_faces, three_faces } = of.vertices;
    Vertices { corners, edge_faces, three_faces }
}

fn kinds(of: Vertices) -> String {
    format!("{} corners, {} edge-face, {} three-face", of.corners, of.edge_faces, of.three_faces)
}

impl Part {
    /// Holds the backend's union of these cubes alone against the judge.
    fn finding(&self, asked: &Asked<'_>) -> Option<Finding> {
        let finding = |got: String, truth: String| Finding::plain(Class::Topology, "part", Vec::new(), got, truth);
        let union = match asked.backend.answer(&CubeUnion, &self.scene, &self.content) {
            Ok(union) => union,
            // It took the whole.
            Err(why) => return Some(finding(why.to_string(), format!("the union of {} cubes", self.content.cubes))),
        };
        let found = in_units(&measures(&union.mass), union.exponent);
        let truth = [&self.measures.volume, &self.measures.area, &self.measures.edge_length];
        let breaks_ties = asked.contract(PredicateKind::Compare).zero == ZeroMeaning::Never;
        let (got_vertices, true_vertices) = (union.mass.vertices, vertices(&self.measures));
        let same = found.each_ref() == truth && (!breaks_ties || got_vertices == true_vertices);
        let words = |[volume, area, edges]: [&Rational; 3], of: Vertices| {
            format!("volume {volume}, area {area}, edges {edges}; {}", kinds(of))
        };
        (!same).then(|| finding(words(found.each_ref(), got_vertices), words(truth, true_vertices)))
    }
}

/// Judges the mass properties that were found.
pub(super) fn judge(case: &Case<'_, CubeUnion>, asked: &Asked<'_>, found: &Union, outcome: &mut Outcome) {
    let found = &found.mass;
    let zero = asked.contract(PredicateKind::Compare).zero;
    for [check, got, truth] in case.truth.checks(found, zero) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.push(Finding::plain(Class::Topology, check, Vec::new(), got, truth));
    }
    if let Some(finding) = case.truth.part.as_ref().and_then(|part| part.finding(asked)) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.push(finding);
    }
    if outcome.findings.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
    let [volume, area, edge_length] = case.truth.in_units(&measures(found));
    let [true_volume, limit_area, limit_edge_length] = case.truth.in_units(&case.truth.measures);
    let loaded = case.loaded;
    outcome.row(&MassRow {
        suite: loaded.suite.clone(),
        scene: loaded.name.clone(),
        scene_id: loaded.id.clone(),
        backend: asked.backend.name(),
        cubes: case.content.cubes as u64,
        volume,
        true_volume,
        area,
        limit_area,
        edge_length,
        limit_edge_length,
        corners: found.vertices.corners,
        edge_faces: found.vertices.edge_faces,
        three_faces: found.vertices.three_faces,
    });
}
