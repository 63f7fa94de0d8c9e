//! The driver of the hierarchy under audit: which pairs it asks about, and when it stops.
//!
//! The streams ask the algorithms one by one, with a hierarchy of the audit's own.
//! Here the driver does it, on scenes of one pair, with a session of the backend.

use predicament_algorithms::contacts::contacts_planted;
use predicament_algorithms::contacts::planted::{ForgottenSubPairs, LostSubPair, Planted, SkippedVertices};
use predicament_algorithms::planted::Honest;
use predicament_checks::audit::{PairKind, Published, Verdict};
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Backend, Dimension, Off, Scene, Vertex};
use predicament_tasks::{Stop, Watch};
use predicament_tolerance::{Float, Tolerance};
use rayon::prelude::*;

use super::stream::{CHUNK, draw, length};
use super::{Algorithm, Form, Row, Scheme, ThresholdPairs, Thresholds};
use crate::Precision;

/// The driver, or one with a planted fault.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Driver {
    /// As it has to be.
    Honest,
    /// Loses the last registration of a level.
    LostSubPair,
    /// Asks about pairs that have ended.
    ForgottenSubPairs,
    /// Never compares vertices.
    SkippedVertices,
}

impl Driver {
    /// Those with a fault.
    pub const PLANTED: [Driver; 3] = [Driver::LostSubPair, Driver::ForgottenSubPairs, Driver::SkippedVertices];

    /// In words, with dashes.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Driver::Honest => "corrected",
            Driver::LostSubPair => "lost-sub-pair",
            Driver::ForgottenSubPairs => "forgotten-sub-pairs",
            Driver::SkippedVertices => "skipped-vertices",
        }
    }
}

/// What became of the scenes of one dimension and precision.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Hierarchy {
    /// Scenes of one pair and its faces.
    pub scenes: u64,
    /// Registered pairs.
    pub registered: u64,
    /// Pairs that had ended.
    pub ended: u64,
    /// Answers by [`Verdict`].
    verdicts: [u64; Verdict::ALL.len()],
}

impl Hierarchy {
    /// How many answers had this verdict.
    #[must_use]
    pub fn count(&self, verdict: Verdict) -> u64 {
        self.verdicts[verdict as usize]
    }

    /// How many answers broke the guarantee.
    #[must_use]
    pub fn violations(&self) -> u64 {
        Verdict::ALL.into_iter().filter(|verdict| !verdict.is_legal()).map(|verdict| self.count(verdict)).sum()
    }

    fn plus(mut self, later: Hierarchy) -> Hierarchy {
        self.scenes += later.scenes;
        self.registered += later.registered;
        self.ended += later.ended;
        for (count, more) in self.verdicts.iter_mut().zip(later.verdicts) {
            *count += more;
        }
        self
    }
}

/// Holds a driver to the guarantee on so many scenes of one pair each.
///
/// # Errors
/// [`Stop`] where the watch says so; it is told of scenes.
pub fn hierarchy(
    driver: Driver,
    dimension: Dimension,
    precision: Precision,
    scenes: u64,
    seed: u64,
    watch: &Watch,
) -> Result<Hierarchy, Stop> {
    let top = Algorithm::all().filter(|algorithm| algorithm.dimension == dimension).last().expect("both dimensions");
    let row = Row { algorithm: top, precision, form: Form::Corrected };
    // As many chunks as a stream has, of fewer pairs: each scene is prepared.
    let size = CHUNK / 16;
    let chunk = |at: u64| {
        let count = size.min(scenes - at * size);
        let drawn = draw("hierarchy", row, seed, at);
        let found = match precision {
            Precision::Double => judge::<f64>(driver, row, count, drawn),
            Precision::Single => judge::<f32>(driver, row, count, drawn),
        };
        watch.done(count).map(|()| found)
    };
    let chunks = (0..scenes.div_ceil(size)).into_par_iter().map(chunk);
    chunks.try_reduce(Hierarchy::default, |found, later| Ok(found.plus(later)))
}

fn judge<F: Float>(driver: Driver, row: Row, count: u64, [seed, bits]: [u64; 2]) -> Hierarchy {
    let dimension = row.algorithm.dimension;
    // Half of L to each complex: the session makes an L of them that is a little larger.
    let half = F::nearest(length(row.precision, bits) / 2.0).wide();
    let thresholds =
        Thresholds { length: 2.0 * half, ..Scheme::<F>::new(dimension, 2.0 * half, Form::Corrected).thresholds() };
    let mut pairs = ThresholdPairs::new(seed, thresholds, |x| F::nearest(x).wide());
    let kinds: Vec<PairKind> =
        Algorithm::all().filter(|algorithm| algorithm.dimension == dimension).map(|algorithm| algorithm.kind).collect();
    let mut found = Hierarchy::default();
    for at in 0..count {
        let kind = kinds[usize::try_from(at).expect("a chunk") % kinds.len()];
        let pair: [Vec<[f64; 3]>; 2] = match dimension {
            Dimension::Two => pairs.plane(kind.ranks()).map(|s| s.into_iter().map(|[x, y]| [x, y, 0.0]).collect()),
            Dimension::Three => pairs.space(kind.ranks()),
        };
        found = found.plus(one::<F>(driver, dimension, &pair, half));
    }
    found
}

fn one<F: Float>(driver: Driver, dimension: Dimension, pair: &[Vec<[f64; 3]>; 2], half: f64) -> Hierarchy {
    let points = pair.iter().flatten();
    let coordinates: Vec<f64> = points.flat_map(|point| point[..dimension.count()].iter().copied()).collect();
    let scene = Scene::new(dimension, coordinates).expect("generators make finite points");
    let complex = |from: usize, count: usize| {
        let v = |i: usize| Vertex::input(from + i);
        let mut given = Simplices::default();
        match count {
            1 => given.vertices.push(v(0)),
            2 => given.edges.push([v(0), v(1)]),
            3 => given.triangles.push([v(0), v(1), v(2)]),
            _ => given.tetrahedra.push([v(0), v(1), v(2), v(3)]),
        }
        Complex::new(&scene, &given).expect("a simplex of the scene")
    };
    let [a, b] = [complex(0, pair[0].len()), complex(pair[0].len(), pair[1].len())];
    let scene = scene.with_primitive_lengths([half; 2]);
    let backend = Tolerance::<F>::new();
    let session = backend.prepare(&scene, Off).expect("L is in the middle of the format's range");
    debug_assert!(Published::of(&session).is_some());
    let contacts = match driver {
        Driver::Honest => run::<Honest, _>(&session, [&a, &b]),
        Driver::LostSubPair => run::<LostSubPair, _>(&session, [&a, &b]),
        Driver::ForgottenSubPairs => run::<ForgottenSubPairs, _>(&session, [&a, &b]),
        Driver::SkippedVertices => run::<SkippedVertices, _>(&session, [&a, &b]),
    };
    let audit = predicament_checks::audit::audit(&session, &a, &b, &contacts);
    let verdicts = Verdict::ALL.map(|verdict| PairKind::ALL.into_iter().map(|kind| audit.count(kind, verdict)).sum());
    Hierarchy { scenes: 1, registered: contacts.registered.len() as u64, ended: audit.ended, verdicts }
}

fn run<F: Planted, S: predicament_predicates::Predicates>(
    session: &S,
    [a, b]: [&Complex; 2],
) -> predicament_algorithms::contacts::Contacts {
    contacts_planted::<F, S>(session, a, b)
}
