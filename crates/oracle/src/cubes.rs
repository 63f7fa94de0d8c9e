//! Unions of cubes: volume, area and edge length against another way to find them.
//!
//! The truth is measured twice: from sections of the union, which know of no
//! vertices, and by the algorithm under test on integers, which asks no
//! session. Backends run the same algorithm by comparing coordinates; what is
//! wrong with their sums is what they make of equal coordinates.

use std::hint::black_box;
use std::time::{Duration, Instant};

use predicament_algorithms::cube_union::{CubesError, Mass, ScaledCubes, cube_union, cube_union_by};
use predicament_checks::cubes::{Measures, measured};
use predicament_predicates::{Backend, Counts, Off, PredicateKind, Predicates, Scene, ZeroMeaning};

use crate::contestant::{Stopwatch, digest};
use crate::outcome::{Finding, MassCounts, Outcome};
use crate::{Class, Stop, Watch, prepared};

/// The predicate that the union asks.
const ASKED: [PredicateKind; 1] = [PredicateKind::Compare];

/// Cubes, and what is true about their union.
pub struct CubesCase<'a> {
    scene: &'a Scene,
    cubes: usize,
    truth: Mass,
    /// Lengths are multiples of 2 to this.
    exponent: i32,
}

impl<'a> CubesCase<'a> {
    /// Measures the union, twice.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    ///
    /// # Panics
    /// If the scene is not of congruent cubes that exact sums can hold (readers
    /// of scenes see to that), or the two measurements differ.
    pub fn new(scene: &'a Scene, watch: &Watch) -> Result<CubesCase<'a>, Stop> {
        let unfit = |error: CubesError| -> ! { panic!("no scene of cubes: {error}") };
        let cubes = ScaledCubes::of_scene(scene).unwrap_or_else(|error| unfit(error));
        let truth = cube_union(&cubes.lowers, cubes.edge).unwrap_or_else(|error| unfit(error));
        watch.done(0)?;
        let again = measured(&cubes.lowers, cubes.edge);
        assert_eq!(measures(&truth), again, "the judge contradicts itself about a union of cubes");
        watch.done(cubes.lowers.len() as u64)?;
        Ok(CubesCase { scene, cubes: cubes.lowers.len(), truth, exponent: cubes.exponent })
    }

    /// The mass properties, in units of a power of two.
    #[must_use]
    pub fn truth(&self) -> &Mass {
        &self.truth
    }

    /// What each check has to say: its name, what was found, what is true.
    ///
    /// Which vertices there are is for sessions that break ties: the others may
    /// find fewer where coordinates are equal, as long as the sums are right.
    fn checks(&self, found: &Mass, zero: ZeroMeaning) -> Vec<[String; 3]> {
        let truth = &self.truth;
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

    fn mass_counts(&self, found: &Mass) -> MassCounts {
        let of = |mass: &Mass| {
            [
                self.in_scene_units(mass.volume, 3),
                self.in_scene_units(mass.area, 2),
                self.in_scene_units(mass.edge_length, 1),
            ]
        };
        MassCounts {
            cubes: self.cubes as u64,
            found: of(found),
            truth: of(&self.truth),
            vertices: [found.vertices.corners, found.vertices.edge_faces, found.vertices.three_faces],
        }
    }
}

fn measures(mass: &Mass) -> Measures {
    Measures { volume: mass.volume, area: mass.area, edge_length: mass.edge_length }
}

/// Runs one backend on one union.
///
/// # Errors
/// [`Stop`] where the watch says so.
pub fn run<B: Backend>(backend: &B, case: &CubesCase, watch: &Watch) -> Result<Outcome, Stop> {
    let queries = case.cubes as u64;
    let counts = Counts::new();
    let session = match prepared::asking(backend, case.scene, &counts, &ASKED) {
        Ok(session) => session,
        Err(refusal) => return Ok(refusal.outcome(queries)),
    };
    watch.done(0)?;
    let found = union(&session);
    watch.done(queries)?;
    let stages = prepared::stages(backend, &counts, &ASKED);
    let mut outcome = Outcome { queries, stages, mass: Some(case.mass_counts(&found)), ..Outcome::default() };
    for [check, got, truth] in case.checks(&found, backend.contract(PredicateKind::Compare).zero) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.push(Finding::plain(Class::Topology, check, String::new(), got, truth));
    }
    if outcome.findings.is_empty() {
        outcome.counts.add(Class::Agree, queries);
    }
    Ok(outcome)
}

fn union<P: Predicates>(session: &P) -> Mass {
    cube_union_by(session).map(|(mass, _)| mass).expect("the case was measured, and the session compares")
}

/// The mass properties by a backend.
pub(crate) fn found<B: Backend>(backend: &B, case: &CubesCase) -> Result<Mass, String> {
    let session = prepared::asking(backend, case.scene, Off, &ASKED)?;
    Ok(union(&session))
}

/// Prepares a backend for timed passes.
pub(crate) fn stopwatch<'a, B: Backend>(
    backend: &'a B,
    case: &'a CubesCase,
) -> Result<Box<dyn Stopwatch + 'a>, String> {
    let session = prepared::asking(backend, case.scene, Off, &ASKED)?;
    Ok(Box::new(CubesWatch { session, out: Mass::default() }))
}

struct CubesWatch<P> {
    session: P,
    out: Mass,
}

impl<P: Predicates> Stopwatch for CubesWatch<P> {
    fn pass(&mut self) -> Duration {
        let start = Instant::now();
        self.out = black_box(union(&self.session));
        start.elapsed()
    }

    fn digest(&self) -> u64 {
        digest_of(&self.out)
    }
}

/// The digest of a known answer, for comparison with [`Stopwatch::digest`].
#[must_use]
pub fn digest_of(mass: &Mass) -> u64 {
    let of = mass.vertices;
    let sums = [mass.volume, mass.area, mass.edge_length].map(i128::to_le_bytes);
    let counts = [of.corners, of.edge_faces, of.three_faces].map(u64::to_le_bytes);
    digest(sums.into_iter().flatten().chain(counts.into_iter().flatten()))
}
