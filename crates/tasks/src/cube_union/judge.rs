//! Volume, area and edge length against another way to find them.
//!
//! Backends run the algorithm by comparing coordinates; what is wrong with
//! their sums is what they make of equal coordinates.

use predicament_algorithms::cube_union::{CubesError, Mass, ScaledCubes, cube_union};
use predicament_checks::cubes::{Measures, measured};
use predicament_predicates::{PredicateKind, Scene, ZeroMeaning};

use super::CubeUnion;
use super::section::MassRow;
use crate::{Asked, Case, Class, Finding, Outcome, Stop, Watch};

/// What is true about a union.
pub struct Truth {
    /// The mass properties, in units of a power of two.
    pub mass: Mass,
    /// Lengths are multiples of 2 to this.
    pub exponent: i32,
}

impl Truth {
    /// Measures the union, twice.
    ///
    /// # Panics
    /// If the scene is not of congruent cubes that exact sums can hold (readers
    /// of scenes see to that), or the two measurements differ.
    pub(super) fn new(scene: &Scene, watch: &Watch) -> Result<Truth, Stop> {
        let unfit = |error: CubesError| -> ! { panic!("no scene of cubes: {error}") };
        let cubes = ScaledCubes::of_scene(scene).unwrap_or_else(|error| unfit(error));
        let mass = cube_union(&cubes.lowers, cubes.edge).unwrap_or_else(|error| unfit(error));
        watch.done(0)?;
        let again = measured(&cubes.lowers, cubes.edge);
        assert_eq!(measures(&mass), again, "the judge contradicts itself about a union of cubes");
        watch.done(cubes.lowers.len() as u64)?;
        Ok(Truth { mass, exponent: cubes.exponent })
    }

    /// The failed checks as [name, found, expected].
    ///
    /// Which vertices there are is for sessions that break ties: the others may
    /// find fewer where coordinates are equal, as long as the sums are right.
    fn checks(&self, found: &Mass, zero: ZeroMeaning) -> Vec<[String; 3]> {
        let truth = &self.mass;
        let kinds = |mass: &Mass| {
            let of = mass.vertices;
            format!("{} corners, {} edge-face, {} three-face", of.corners, of.edge_faces, of.three_faces)
        };
        let mut checks = vec![
            ["volume".to_owned(), found.volume.to_string(), truth.volume.to_string()],
            ["area".to_owned(), found.area.to_string(), truth.area.to_string()],
            ["edge length".to_owned(), found.edge_length.to_string(), truth.edge_length.to_string()],
        ];
        if zero == ZeroMeaning::Never {
            checks.push(["vertices".to_owned(), kinds(found), kinds(truth)]);
        }
        checks.retain(|[_, found, truth]| found != truth);
        if found.vertices.euler_characteristic().is_none() {
            checks.push(["euler characteristic".to_owned(), kinds(found), "a multiple of eight quarters".to_owned()]);
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

    /// Volume, area and edge length in the scene's units.
    fn in_units(&self, mass: &Mass) -> [f64; 3] {
        [
            self.in_scene_units(mass.volume, 3),
            self.in_scene_units(mass.area, 2),
            self.in_scene_units(mass.edge_length, 1),
        ]
    }
}

fn measures(mass: &Mass) -> Measures {
    Measures { volume: mass.volume, area: mass.area, edge_length: mass.edge_length }
}

/// Judges the mass properties that were found.
pub(super) fn judge(case: &Case<'_, CubeUnion>, asked: &Asked<'_>, found: &Mass, outcome: &mut Outcome) {
    let zero = asked.contract(PredicateKind::Compare).zero;
    for [check, got, truth] in case.truth.checks(found, zero) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.push(Finding::plain(Class::Topology, check, Vec::new(), got, truth));
    }
    if outcome.findings.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
    let [volume, area, edge_length] = case.truth.in_units(found);
    let [true_volume, true_area, true_edge_length] = case.truth.in_units(&case.truth.mass);
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
        true_area,
        edge_length,
        true_edge_length,
        corners: found.vertices.corners,
        edge_faces: found.vertices.edge_faces,
        three_faces: found.vertices.three_faces,
    });
}
