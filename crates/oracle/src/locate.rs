//! Maps: every probe against the plane around it.
//!
//! The map's own flaws and the surroundings of each probe are found with the
//! exact backend first, so that what is wrong with the data is never counted
//! against a backend. (The exact backend is itself held against winding
//! numbers in rationals, in the tests of `algorithms`.)
//!
//! A backend is judged by what it says about every edge in the way, whether or
//! not raw coordinates decide about it. What users run, and what is timed, is
//! the shortcut that leaves those edges out; a backend whose signs are proved
//! has to give the same answers by it.

use std::hint::black_box;
use std::time::{Duration, Instant};

use predicament_algorithms::polygon_locate::{LocateIndex, Location, Locations, Scratch, locate_all, question_all};
use predicament_checks::tiling::{Fault, Flaws, Ground, Surroundings, map_flaws, surroundings, tiling_report};
use predicament_exact::Exact;
use predicament_mesh::PolygonMap;
use predicament_predicates::{Backend, Counts, Off, PredicateKind, Predicates, Scene, Vertex, ZeroMeaning};

use crate::contestant::{Stopwatch, digest};
use crate::outcome::{Finding, LocateCounts, Outcome};
use crate::signs::Budget;
use crate::{Class, Stop, Watch, prepared};

/// The predicates that locating asks.
const ASKED: [PredicateKind; 2] = [PredicateKind::Compare, PredicateKind::Orient2d];

/// A map with its probes, and what is true about them.
pub struct LocateCase<'a> {
    scene: &'a Scene,
    map: &'a PolygonMap,
    index: LocateIndex,
    probes: Vec<Vertex>,
    flaws: Flaws,
    surroundings: Surroundings,
    exact: Locations,
    build: Duration,
}

impl<'a> LocateCase<'a> {
    /// Builds the index, finds the map's flaws and the truth about the probes.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    ///
    /// # Panics
    /// If the scene is not 2D: maps are.
    pub fn new(
        scene: &'a Scene,
        map: &'a PolygonMap,
        probes: Vec<Vertex>,
        watch: &Watch,
    ) -> Result<LocateCase<'a>, Stop> {
        let start = Instant::now();
        let index = LocateIndex::new(map, scene);
        let build = start.elapsed();
        let session = Exact.prepare(scene, Off).expect("the exact backend takes every scene");
        let flaws = map_flaws(&index, &session);
        watch.done(0)?;
        let surroundings = surroundings(&index, &session, &probes);
        watch.done(0)?;
        let exact = all(&index, &session, &probes, watch)?;
        Ok(LocateCase { scene, map, index, probes, flaws, surroundings, exact, build })
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        self.scene
    }

    /// The map.
    #[must_use]
    pub fn map(&self) -> &PolygonMap {
        self.map
    }

    /// The map's edges, ready for queries.
    #[must_use]
    pub fn index(&self) -> &LocateIndex {
        &self.index
    }

    /// What is located.
    #[must_use]
    pub fn probes(&self) -> &[Vertex] {
        &self.probes
    }

    /// The map's own flaws.
    #[must_use]
    pub fn flaws(&self) -> &Flaws {
        &self.flaws
    }

    /// How many probes stand on each kind of ground.
    #[must_use]
    pub fn grounds(&self) -> Vec<(&'static str, usize)> {
        let count = |ground| (0..self.probes.len()).filter(|&at| self.surroundings.ground(at) == ground).count();
        Ground::ALL.into_iter().map(|ground| (ground.name(), count(ground))).filter(|&(_, n)| n > 0).collect()
    }

    /// How long the index took to build.
    #[must_use]
    pub fn build_time(&self) -> Duration {
        self.build
    }

    /// The exact answers.
    #[must_use]
    pub fn exact(&self) -> &Locations {
        &self.exact
    }
}

/// All locations, every edge asked about, in the pool's threads.
fn all<P: Predicates>(index: &LocateIndex, session: &P, probes: &[Vertex], watch: &Watch) -> Result<Locations, Stop> {
    let before = std::sync::atomic::AtomicUsize::new(0);
    let stop = std::sync::OnceLock::new();
    let locations = question_all(index, session, probes, &|done| {
        let news = done.saturating_sub(before.fetch_max(done, std::sync::atomic::Ordering::Relaxed));
        match watch.done(news as u64) {
            Ok(()) => true,
            Err(why) => {
                let _ = stop.set(why);
                false
            }
        }
    });
    stop.get().map_or(Ok(locations), |&why| Err(why))
}

/// Runs one backend on one map.
///
/// # Errors
/// [`Stop`] where the watch says so.
pub fn run<B: Backend>(backend: &B, case: &LocateCase, budget: Budget, watch: &Watch) -> Result<Outcome, Stop> {
    let queries = case.probes.len() as u64;
    let counts = Counts::new();
    let session = match prepared::asking(backend, case.scene, &counts, &ASKED) {
        Ok(session) => session,
        Err(refusal) => return Ok(refusal.outcome(queries)),
    };
    let contract = backend.contract(PredicateKind::Orient2d);
    let zero = contract.zero;
    let answers = all(&case.index, &session, &case.probes, watch)?;

    let mut outcome = Outcome { queries, stages: prepared::stages(backend, &counts, &ASKED), ..Outcome::default() };
    // Proved signs are exact ones, or those of one perturbed scene.
    let shortcut = (contract.proved && zero != ZeroMeaning::Band)
        .then(|| locate_all(&case.index, &session, &case.probes, &|_| true));
    let report = tiling_report(&case.surroundings, &answers, zero);
    let mut violations = report.violations().iter().peekable();
    for (probe, answer) in answers.iter().enumerate() {
        let violation = violations.next_if(|violation| violation.probe == probe);
        let truth = location(&case.exact, probe);
        let class = match violation {
            Some(violation) => class_of_fault(violation.fault),
            None if answer == truth => Class::Agree,
            None => match zero {
                ZeroMeaning::Never => Class::TieBroken,
                ZeroMeaning::Band => Class::InBand,
                ZeroMeaning::Exact if answer.boundary.len() < truth.boundary.len() => Class::MissedZero,
                ZeroMeaning::Exact => Class::Overreach,
            },
        };
        let by_shortcut = shortcut.as_ref().map(|all| location(all, probe)).filter(|&other| other != answer);
        let class = if class.is_legal() && by_shortcut.is_some() { Class::Topology } else { class };
        outcome.counts.add(class, 1);
        if !class.is_legal() && outcome.counts.get(class) <= budget.findings_per_class as u64 {
            outcome.findings.push(match (violation, by_shortcut) {
                (Some(violation), _) => case.finding(class, violation.fault.name(), probe, answer, truth),
                (None, Some(other)) => case.finding(class, "shortcut", probe, other, answer),
                (None, None) => case.finding(class, "exact location", probe, answer, truth),
            });
        }
    }
    outcome.locate = Ground::ALL
        .into_iter()
        .filter_map(|ground| {
            let counts = report.counts(ground);
            (counts.probes() > 0).then(|| LocateCounts {
                surroundings: ground.name().to_owned(),
                probes: counts.probes() as u64,
                in_none: counts.none as u64,
                in_one: counts.one as u64,
                in_many: counts.more as u64,
                on_boundary: counts.boundary as u64,
                violations: report.violations().iter().filter(|violation| violation.ground == ground).count() as u64,
            })
        })
        .collect();
    Ok(outcome)
}

fn location(all: &Locations, at: usize) -> Location<'_> {
    Location { inside: all.inside(at), boundary: all.boundary(at) }
}

/// Where an answer fits no sector, topology is broken; the other faults are
/// broken promises about zeros.
fn class_of_fault(fault: Fault) -> Class {
    match fault {
        Fault::Gap | Fault::Double | Fault::Misplaced => Class::Topology,
        Fault::FalseBoundary => Class::Overreach,
        Fault::MissedBoundary => Class::MissedZero,
        Fault::UnbrokenTie => Class::Inconsistent,
    }
}

impl LocateCase<'_> {
    fn finding(&self, class: Class, check: &str, probe: usize, got: Location, truth: Location) -> Finding {
        let query = format!("polygon-locate({})", self.probes[probe]);
        Finding::plain(class, check, query, self.describe(got), self.describe(truth))
    }

    /// A location in words: `in France; on Spain, Andorra`.
    #[must_use]
    pub fn describe(&self, location: Location) -> String {
        let names = |regions: &[u32]| {
            let names = regions.iter().map(|&region| self.map.regions()[region as usize].name.as_str());
            names.collect::<Vec<_>>().join(", ")
        };
        match (location.inside, location.boundary) {
            ([], []) => "in none".to_owned(),
            (inside, []) => format!("in {}", names(inside)),
            ([], boundary) => format!("on {}", names(boundary)),
            (inside, boundary) => format!("in {}; on {}", names(inside), names(boundary)),
        }
    }

    /// Locates one vertex with a backend, for `replay`: in words, and by the
    /// shortcut as well where that is different.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    pub fn locate_one<B: Backend>(&self, backend: &B, vertex: Vertex) -> Result<String, String> {
        let session = prepared::asking(backend, self.scene, Off, &ASKED)?;
        let asked = self.describe(self.index.question(&session, vertex, &mut Scratch::new()));
        let by_shortcut = self.describe(self.index.locate(&session, vertex, &mut Scratch::new()));
        Ok(if asked == by_shortcut { asked } else { format!("{asked} (by the shortcut: {by_shortcut})") })
    }
}

/// All answers of a backend by the shortcut, in order.
pub(crate) fn locations<B: Backend>(backend: &B, case: &LocateCase) -> Result<Locations, String> {
    let session = prepared::asking(backend, case.scene, Off, &ASKED)?;
    Ok(locate_all(&case.index, &session, &case.probes, &|_| true))
}

/// Prepares a backend for timed passes over all probes.
pub(crate) fn stopwatch<'a, B: Backend>(
    backend: &'a B,
    case: &'a LocateCase,
) -> Result<Box<dyn Stopwatch + 'a>, String> {
    let session = prepared::asking(backend, case.scene, Off, &ASKED)?;
    Ok(Box::new(LocateWatch { session, case, scratch: Scratch::new(), out: LocationSink::default() }))
}

struct LocateWatch<'a, P> {
    session: P,
    case: &'a LocateCase<'a>,
    scratch: Scratch,
    out: LocationSink,
}

impl<P: Predicates> Stopwatch for LocateWatch<'_, P> {
    fn pass(&mut self) -> Duration {
        self.out.clear();
        let start = Instant::now();
        for &probe in &self.case.probes {
            self.out.push(self.case.index.locate(&self.session, probe, &mut self.scratch));
        }
        black_box(&mut self.out);
        start.elapsed()
    }

    fn digest(&self) -> u64 {
        self.out.digest()
    }
}

/// Where timed passes write their answers: for each probe how many regions it
/// is inside of, how many boundaries it is on, then the regions.
#[derive(Default)]
pub struct LocationSink(Vec<u32>);

impl LocationSink {
    /// Forgets all answers, and keeps the memory.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Takes the next answer.
    #[inline]
    pub fn push(&mut self, location: Location) {
        // A map has far fewer than 2^32 regions, so both lengths fit.
        #[allow(clippy::cast_possible_truncation)]
        self.0.extend([location.inside.len() as u32, location.boundary.len() as u32]);
        self.0.extend(location.inside);
        self.0.extend(location.boundary);
    }

    /// A digest of the answers and their order.
    #[must_use]
    pub fn digest(&self) -> u64 {
        digest(self.0.iter().flat_map(|x| x.to_le_bytes()))
    }
}

/// The digest of known answers, for comparison with [`Stopwatch::digest`].
#[must_use]
pub fn digest_of(locations: &Locations) -> u64 {
    let mut out = LocationSink::default();
    locations.iter().for_each(|location| out.push(location));
    out.digest()
}
