//! Every probe against the plane around it.
//!
//! The map's own flaws and the surroundings of each probe are found first, so
//! that what is wrong with the data is never counted against a backend.
//!
//! A backend is judged by what it says about every edge in the way, whether or
//! not raw coordinates decide about it. What users run, and what is timed, is
//! the shortcut that leaves those edges out; a backend whose signs are proved
//! has to give the same answers by it.

use crate::algorithm::{Location, Locations, locate_all, question_all};
use crate::checks::{Fault, Flaws, Ground, Surroundings, map_flaws, surroundings, tiling_report};
use predicament_judge::{Judged, Sample, is_within, locate as judge};
use predicament_laws::published;
use predicament_predicates::{Plane, PredicateKind, Predicates, Query, Question, Scene, Vertex, ZeroMeaning};
use rayon::prelude::*;

use super::section::LocateRow;
use super::{Located, MapWithProbes, PolygonLocate, describe};
use predicament_tasks::{Answer, AnswerLine, Asked, Case, Class, Finding, Outcome, Stop, Watch};

/// What is true about a map and its probes.
pub struct Truth {
    /// The map's own flaws.
    pub flaws: Flaws,
    /// What is around each probe.
    pub surroundings: Surroundings,
    /// Where the probes of a sample are: by all edges of the map, without an index.
    exact: Vec<judge::Location>,
    sample: Sample,
    /// Where all probes are, by the driver on the judge's signs: it tells ties of other probes, no right from wrong.
    by_signs: Locations,
}

impl Truth {
    /// Finds the map's flaws and the truth about the probes.
    pub(super) fn new(scene: &Scene, content: &MapWithProbes, watch: &Watch) -> Result<Truth, Stop> {
        let (index, probes) = (content.locate_index(scene), content.vertices());
        let session = Judged::exact(scene);
        let flaws = map_flaws(index, &session);
        watch.done(0)?;
        let surroundings = surroundings(index, &session, &probes);
        watch.done(0)?;
        let regions = content.map.regions().iter();
        let rings = regions.map(|region| region.rings.iter().map(|ring| ring.vertices().to_vec()).collect());
        let borders = judge::Borders::new(scene, &rings.collect::<Vec<Vec<Vec<Vertex>>>>());
        let sample = judge::sample(probes.len(), borders.len());
        let places: Vec<usize> = sample.places().collect();
        let exact = places.par_iter().map(|&place| borders.locate(probes[place])).collect();
        let by_signs = watch.counted(|go_on| question_all(index, &session, &probes, go_on))?;
        Ok(Truth { flaws, surroundings, exact, sample, by_signs })
    }

    /// How many probes were located without an index, if not all.
    pub(super) fn sampled(&self) -> Option<String> {
        (!self.sample.is_all())
            .then(|| format!("probes by all edges: {}; the others by their surroundings", self.sample))
    }

    /// Where a probe is.
    fn location(&self, at: usize) -> Location<'_> {
        if self.sample.has(at) {
            let exact = &self.exact[at / self.sample.step()];
            Location { inside: &exact.inside, boundary: &exact.boundary }
        } else {
            location(&self.by_signs, at)
        }
    }

    /// How many probes stand on each kind of ground.
    #[must_use]
    pub fn grounds(&self, probes: usize) -> Vec<(&'static str, usize)> {
        let count = |ground| (0..probes).filter(|&at| self.surroundings.ground(at) == ground).count();
        Ground::ALL.into_iter().map(|ground| (ground.name(), count(ground))).filter(|&(_, n)| n > 0).collect()
    }
}

/// Judges the locations of all probes.
pub(super) fn judge(
    case: &Case<'_, PolygonLocate>,
    asked: &Asked<'_>,
    answers: &Locations,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let (content, truth) = (case.content, &case.truth);
    let contract = asked.contract(PredicateKind::Orient2d);
    let zero = contract.zero;
    let probes: Vec<Vertex> = content.vertices();
    let short = Located(locate_all(content.locate_index(case.scene()), asked.session, &probes, &|_| true));
    outcome.digest = Some(short.digest());
    // Proved signs are exact ones, or those of one perturbed scene.
    let shortcut = (contract.proved && zero != ZeroMeaning::Band).then_some(&short.0);
    asked.watch.done(0)?;
    let report = tiling_report(&truth.surroundings, answers, zero);
    let mut violations = report.violations().iter().peekable();
    for (at, answer) in answers.iter().enumerate() {
        let violation = violations.next_if(|violation| violation.probe == at);
        let exact = truth.location(at);
        let class = match violation {
            Some(violation) => class_of_fault(violation.fault),
            None if answer == exact => Class::Agree,
            None => match zero {
                // Where the probe touches nothing there is no tie.
                ZeroMeaning::Never if exact.boundary.is_empty() => Class::SignFlip,
                ZeroMeaning::Never => Class::TieBroken,
                ZeroMeaning::Band => in_band(asked.session, content, probes[at], answer, exact),
                ZeroMeaning::Exact if answer.boundary.len() < exact.boundary.len() => Class::MissedZero,
                ZeroMeaning::Exact => Class::Overreach,
            },
        };
        // What is wrong already is no matter of the shortcut.
        let by_shortcut = shortcut.map(|all| location(all, at)).filter(|&other| class.is_legal() && other != answer);
        let class = if by_shortcut.is_some() { Class::Topology } else { class };
        if asked.budget.answers {
            let [answer, exact] = [answer, exact].map(|location| describe(&content.map, location));
            outcome.answers.push(AnswerLine { query: at, args: vec![probes[at]], answer, exact, class, stage: "" });
        }
        outcome.note(class, asked.budget.findings_per_class, || {
            let (check, got, truth) = match (violation, by_shortcut) {
                (Some(violation), _) => (violation.fault.name(), answer, exact),
                (None, Some(other)) => ("shortcut", other, answer),
                (None, None) => ("exact location", answer, exact),
            };
            let query = Query::of_task("polygon-locate", &[probes[at]]);
            let [got, truth] = [got, truth].map(|location| describe(&content.map, location));
            Finding::plain(class, check, vec![query], got, truth)
        });
    }
    for ground in Ground::ALL {
        let counts = report.counts(ground);
        if counts.probes() > 0 {
            outcome.row(&LocateRow {
                suite: case.loaded.suite.clone(),
                scene: case.loaded.name.clone(),
                scene_id: case.loaded.id.clone(),
                backend: asked.backend.name(),
                surroundings: ground.name().to_owned(),
                probes: counts.probes() as u64,
                in_none: counts.none as u64,
                in_one: counts.one as u64,
                in_many: counts.more as u64,
                on_boundary: counts.boundary as u64,
                violations: report.violations().iter().filter(|violation| violation.ground == ground).count() as u64,
            });
        }
    }
    Ok(())
}

/// The class of an answer with zeros within a band, where it is not the exact one: all boundaries that the probe is on are found, and others
/// only where the probe is within the band of an edge, and within the reach of its box.
fn in_band(
    session: &dyn Predicates,
    content: &MapWithProbes,
    probe: Vertex,
    answer: Location<'_>,
    exact: Location<'_>,
) -> Class {
    if exact.boundary.iter().any(|region| answer.boundary.binary_search(region).is_err()) {
        return Class::MissedZero;
    }
    let (scene, question, reach) = (session.scene(), Question::Orient2d(Plane::Xy), session.reach());
    let limit = published::band(session, question).map_or(0.0, |band| band.upper);
    let p = scene.point2(Plane::Xy, probe);
    let is_near = |[u, v]: [Vertex; 2]| {
        let ends = [u, v].map(|v| scene.point2(Plane::Xy, v));
        // Outward by more than the sums are rounded.
        (0..2).all(|axis| {
            let (low, high) = (ends[0][axis].min(ends[1][axis]), ends[0][axis].max(ends[1][axis]));
            (low - reach).next_down() <= p[axis] && p[axis] <= (high + reach).next_up()
        }) && is_within(scene, question, &[u, v, probe], limit)
    };
    let is_explained = |region: &u32| {
        let rings = &content.map.regions()[*region as usize].rings;
        exact.boundary.binary_search(region).is_ok() || rings.iter().flat_map(|ring| ring.edges()).any(is_near)
    };
    if answer.boundary.iter().all(is_explained) { Class::InBand } else { Class::Overreach }
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
