//! Cells of a line: every probe against the rule without infinitesimals, and the cells against each other.

use std::hint::black_box;
use std::time::{Duration, Instant};

use predicament_algorithms::interval::{Place, cells_at, place};
use predicament_checks::partition::{exact_place, partition_fault, perturbed_place};
use predicament_predicates::{Axis, Backend, Counts, Off, PredicateKind, Predicates, Scene, Vertex, ZeroMeaning};
use rayon::prelude::*;

use crate::contestant::{Stopwatch, digest};
use crate::outcome::{Finding, Outcome};
use crate::signs::Budget;
use crate::{Class, Stop, Watch, prepared};

/// The predicate that locating asks.
const ASKED: [PredicateKind; 1] = [PredicateKind::Compare];

/// Probes between two looks at the watch.
const CHUNK: usize = 1024;

/// The cells that a probe is not outside of, ascending.
pub type Cells = Vec<(usize, Place)>;

/// Cells and probes, and what is true about them.
pub struct IntervalCase<'a> {
    scene: &'a Scene,
    axis: Axis,
    cells: &'a [[Vertex; 2]],
    probes: &'a [Vertex],
    /// By their coordinates.
    exact: Vec<Cells>,
}

impl<'a> IntervalCase<'a> {
    /// Finds the truth about the probes.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    pub fn new(
        scene: &'a Scene,
        axis: Axis,
        cells: &'a [[Vertex; 2]],
        probes: &'a [Vertex],
        watch: &Watch,
    ) -> Result<IntervalCase<'a>, Stop> {
        let mut case = IntervalCase { scene, axis, cells, probes, exact: Vec::new() };
        case.exact = case.all(watch, |probe| case.by_rule(exact_place, probe))?;
        Ok(case)
    }

    /// What is located.
    #[must_use]
    pub fn probes(&self) -> &[Vertex] {
        self.probes
    }

    /// The answer by a rule about coordinates and numbers.
    fn by_rule(&self, rule: impl Fn(&Scene, Axis, [Vertex; 2], Vertex) -> Place, probe: Vertex) -> Cells {
        let places = self.cells.iter().map(|&cell| rule(self.scene, self.axis, cell, probe));
        places.enumerate().filter(|&(_, place)| place != Place::Outside).collect()
    }

    fn all<T: Send>(&self, watch: &Watch, locate: impl Fn(Vertex) -> T + Sync) -> Result<Vec<T>, Stop> {
        let chunks: Result<Vec<Vec<T>>, Stop> = self
            .probes
            .par_chunks(CHUNK)
            .map(|probes| {
                let found = probes.iter().map(|&probe| locate(probe)).collect();
                watch.done(probes.len() as u64).map(|()| found)
            })
            .collect();
        Ok(chunks?.into_iter().flatten().collect())
    }

    fn locate<P: Predicates>(&self, session: &P, probe: Vertex) -> Cells {
        cells_at(session, self.axis, self.cells, probe).collect()
    }

    /// Where the probe is, seen from all cells as one.
    fn whole<P: Predicates>(&self, session: &P, probe: Vertex) -> Place {
        match (self.cells.first(), self.cells.last()) {
            (Some(&[left, _]), Some(&[_, right])) => place(session, self.axis, [left, right], probe),
            _ => Place::Outside,
        }
    }

    /// The class of an answer and the check that it is from.
    fn judge(&self, zero: ZeroMeaning, at: usize, whole: Place, found: &Cells) -> (Class, &'static str) {
        let exact = &self.exact[at];
        if let Some(fault) = partition_fault(whole, found.iter().map(|&(_, place)| place)) {
            return (Class::Topology, fault.name());
        }
        let at_end = |cells: &Cells| cells.iter().any(|&(_, place)| place == Place::AtEnd);
        match zero {
            ZeroMeaning::Never if at_end(found) => (Class::Inconsistent, "never zero"),
            ZeroMeaning::Never if *found != self.by_rule(perturbed_place, self.probes[at]) => {
                (Class::SignFlip, "half-open rule")
            }
            ZeroMeaning::Never if at_end(exact) => (Class::TieBroken, "cells"),
            ZeroMeaning::Never => (Class::Agree, "cells"),
            ZeroMeaning::Exact | ZeroMeaning::Band => {
                let lost = |from: &Cells, to: &Cells| {
                    from.iter().any(|&(cell, place)| place == Place::AtEnd && !to.contains(&(cell, Place::AtEnd)))
                };
                let class = match (found == exact, lost(exact, found), lost(found, exact)) {
                    (true, _, _) => Class::Agree,
                    (false, true, _) => Class::MissedZero,
                    (false, false, true) => Class::Overreach,
                    (false, false, false) => Class::SignFlip,
                };
                (class, "cells")
            }
        }
    }

    /// Cells in words: `in 3`, `between 3 and 4`.
    #[must_use]
    pub fn describe(cells: &Cells) -> String {
        let of = |wanted: Place| {
            let cells = cells.iter().filter(|&&(_, place)| place == wanted);
            cells.map(|(cell, _)| cell.to_string()).collect::<Vec<_>>().join(", ")
        };
        match (of(Place::Inside), of(Place::AtEnd)) {
            (inside, ends) if inside.is_empty() && ends.is_empty() => "in none".to_owned(),
            (inside, ends) if ends.is_empty() => format!("in {inside}"),
            (inside, ends) if inside.is_empty() => format!("at the end of {ends}"),
            (inside, ends) => format!("in {inside}; at the end of {ends}"),
        }
    }

    /// The cells of one vertex, for `replay`, in words.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    pub fn locate_one<B: Backend>(&self, backend: &B, probe: Vertex) -> Result<String, String> {
        let session = prepared::asking(backend, self.scene, Off, &ASKED)?;
        Ok(IntervalCase::describe(&self.locate(&session, probe)))
    }
}

/// Runs one backend on one line.
///
/// # Errors
/// [`Stop`] where the watch says so.
pub fn run<B: Backend>(backend: &B, case: &IntervalCase, budget: Budget, watch: &Watch) -> Result<Outcome, Stop> {
    let queries = case.probes.len() as u64;
    let counts = Counts::new();
    let session = match prepared::asking(backend, case.scene, &counts, &ASKED) {
        Ok(session) => session,
        Err(refusal) => return Ok(refusal.outcome(queries)),
    };
    let zero = backend.contract(PredicateKind::Compare).zero;
    let found = case.all(watch, |probe| case.locate(&session, probe))?;
    let mut outcome = Outcome { queries, stages: prepared::stages(backend, &counts, &ASKED), ..Outcome::default() };
    for (at, (cells, &probe)) in found.iter().zip(case.probes).enumerate() {
        let (class, check) = case.judge(zero, at, case.whole(&session, probe), cells);
        outcome.counts.add(class, 1);
        if !class.is_legal() && outcome.counts.get(class) <= budget.findings_per_class as u64 {
            let truth = match zero {
                ZeroMeaning::Never => case.by_rule(perturbed_place, probe),
                ZeroMeaning::Exact | ZeroMeaning::Band => case.exact[at].clone(),
            };
            let [got, truth] = [cells, &truth].map(IntervalCase::describe);
            outcome.findings.push(Finding::plain(class, check, format!("interval({probe})"), got, truth));
        }
    }
    Ok(outcome)
}

/// The cells of all probes, in order.
pub(crate) fn found<B: Backend>(backend: &B, case: &IntervalCase) -> Result<Vec<Cells>, String> {
    let session = prepared::asking(backend, case.scene, Off, &ASKED)?;
    Ok(case.probes.iter().map(|&probe| case.locate(&session, probe)).collect())
}

/// Prepares a backend for timed passes over all probes.
pub(crate) fn stopwatch<'a, B: Backend>(
    backend: &'a B,
    case: &'a IntervalCase,
) -> Result<Box<dyn Stopwatch + 'a>, String> {
    let session = prepared::asking(backend, case.scene, Off, &ASKED)?;
    Ok(Box::new(IntervalWatch { session, case, out: Vec::new() }))
}

struct IntervalWatch<'a, P> {
    session: P,
    case: &'a IntervalCase<'a>,
    /// Per probe its cells, then `usize::MAX`.
    out: Vec<(usize, Place)>,
}

impl<P: Predicates> Stopwatch for IntervalWatch<'_, P> {
    fn pass(&mut self) -> Duration {
        self.out.clear();
        let start = Instant::now();
        for &probe in self.case.probes {
            self.out.extend(cells_at(&self.session, self.case.axis, self.case.cells, probe));
            self.out.push(END);
        }
        black_box(&mut self.out);
        start.elapsed()
    }

    fn digest(&self) -> u64 {
        digest_places(self.out.iter().copied())
    }
}

/// Behind the cells of a probe.
const END: (usize, Place) = (usize::MAX, Place::Outside);

fn digest_places(places: impl Iterator<Item = (usize, Place)>) -> u64 {
    digest(places.flat_map(|(cell, place)| {
        let [a, b, c, d, e, f, g, h] = (cell as u64).to_le_bytes();
        [a, b, c, d, e, f, g, h, u8::from(place == Place::AtEnd)]
    }))
}

/// The digest of known answers, for comparison with [`Stopwatch::digest`].
#[must_use]
pub fn digest_of(found: &[Cells]) -> u64 {
    digest_places(found.iter().flat_map(|cells| cells.iter().copied().chain([END])))
}
