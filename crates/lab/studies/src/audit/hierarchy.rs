//! The audit of the hierarchy's driver: the pairs that it queries, and the point where it stops.
//!
//! The streams query the algorithms one by one, with the audit's own hierarchy. Here the driver does it, on scenes of
//! one pair, with a session of the backend.

use predicament_contacts::algorithm::pairs::{Contact, contacts};
use predicament_contacts::checks::audit::{PairKind, Published, Verdict};
use predicament_mesh::{Complex, Simplex, Simplices};
use predicament_predicates::{Backend, Dimension, Off, Scene, Vertex};
use predicament_tasks::{Stop, Watch};
use predicament_tolerance::{Float, Tolerance};
use rayon::prelude::*;

use super::stream::{CHUNK, draw, length};
use super::{Algorithm, Form, Row, Scheme, ThresholdPairs, Thresholds};
use crate::Precision;

/// The driver, or one with spoiled registrations.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Driver {
    /// The correct driver.
    Honest,
    /// The last registration below full dimension is lost.
    LostSubPair,
    /// The driver also registers a pair that the first registration below full dimension should have excluded.
    ForgottenSubPairs,
    /// The driver registers no two vertices.
    SkippedVertices,
}

impl Driver {
    /// The drivers that lose registrations or add some.
    pub const PLANTED: [Driver; 3] = [Driver::LostSubPair, Driver::ForgottenSubPairs, Driver::SkippedVertices];

    /// The driver's name, in words with dashes.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Driver::Honest => "corrected",
            Driver::LostSubPair => "lost-sub-pair",
            Driver::ForgottenSubPairs => "forgotten-sub-pairs",
            Driver::SkippedVertices => "skipped-vertices",
        }
    }

    /// Applies the driver's fault to the registrations of a scene.
    fn spoil(self, dimension: Dimension, [a, b]: [&Complex; 2], registered: &mut Vec<Contact>) {
        let is_below = |contact: &Contact| usize::from(contact.a.rank + contact.b.rank) < dimension.count();
        match self {
            Driver::Honest => {}
            Driver::LostSubPair => {
                let last = registered.iter().rposition(is_below);
                last.map(|at| registered.remove(at));
            }
            Driver::ForgottenSubPairs => {
                let ended = |contact: &Contact| {
                    let more = above(a, contact.a).map(|a| Contact { a, ..*contact });
                    more.or_else(|| Some(Contact { b: above(b, contact.b)?, ..*contact }))
                };
                let more = registered.iter().filter(|contact| is_below(contact)).find_map(ended);
                registered.extend(more);
            }
            Driver::SkippedVertices => registered.retain(|contact| contact.a.rank + contact.b.rank > 0),
        }
    }
}

/// A simplex of one more vertex that has this one as a face.
fn above(complex: &Complex, simplex: Simplex) -> Option<Simplex> {
    let face = complex.vertices_of(simplex);
    let all = (0..).map(|index| Simplex { rank: simplex.rank + 1, index });
    let count = match simplex.rank {
        0 => complex.edges().len(),
        1 => complex.triangles().len(),
        _ => complex.tetrahedra().len(),
    };
    all.take(count).find(|&other| face.iter().all(|v| complex.vertices_of(other).contains(v)))
}

/// The results on the scenes of one dimension and precision.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Hierarchy {
    /// The number of scenes of one pair and its faces.
    pub scenes: u64,
    /// The number of registered pairs.
    pub registered: u64,
    /// The number of pairs with a registered sub-pair.
    pub ended: u64,
    /// The number of answers by [`Verdict`].
    verdicts: [u64; Verdict::ALL.len()],
}

impl Hierarchy {
    /// The number of answers with this verdict.
    #[must_use]
    pub fn count(&self, verdict: Verdict) -> u64 {
        self.verdicts[verdict as usize]
    }

    /// The number of answers that broke the guarantee.
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

/// Checks a driver against the guarantee, on scenes of one pair each.
///
/// # Errors
/// [`Stop`] if the watch says so; it counts scenes.
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
    // As many chunks as a stream has, of fewer pairs, because each scene is prepared.
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
    // Half of L for each complex: the session computes from them an L that is a little larger.
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
    assert!(Published::of(&session).is_some());
    let mut found = contacts(&session, &a, &b);
    driver.spoil(dimension, [&a, &b], &mut found.registered);
    let audit = predicament_contacts::checks::audit::audit(&session, &a, &b, &found);
    let verdicts = Verdict::ALL.map(|verdict| PairKind::ALL.into_iter().map(|kind| audit.count(kind, verdict)).sum());
    Hierarchy { scenes: 1, registered: found.registered.len() as u64, ended: audit.ended, verdicts }
}
