//! Judging of every probe by the plane around it.
//!
//! The map's own flaws and the surroundings of each probe are found first, so that errors in the data never count
//! against a backend.
//!
//! A backend is judged by its answers about every edge in the way, even if raw coordinates decide about the edge. Users
//! run, and benchmarks time, the shortcut that leaves those edges out. A backend whose signs are proved must give the
//! same answers by the shortcut.

use crate::algorithm::locate_all;
use crate::answer::{Location, Locations};
use crate::checks::{Fault, tiling_report};
use crate::truth::Ground;
use predicament_judge::is_within;
use predicament_laws::published;
use predicament_predicates::{Plane, PredicateKind, Predicates, Query, Question, Vertex, ZeroMeaning};

use super::section::LocateRow;
use super::{Located, MapWithProbes, PolygonLocate, describe};
use predicament_tasks::{Answer, AnswerLine, Asked, Case, Class, Finding, Outcome, Stop};

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
    // Proved signs are exact signs, or those of one perturbed scene.
    let shortcut = (contract.proved && zero != ZeroMeaning::Band).then_some(&short.0);
    asked.watch.done(0)?;
    let report = tiling_report(&truth.surroundings, answers, zero);
    let mut violations = report.violations().iter().peekable();
    for (at, answer) in answers.iter().enumerate() {
        let violation = violations.next_if(|violation| violation.probe == at);
        let known = truth.location(at);
        let exact = Location { inside: &known.inside, boundary: &known.boundary };
        let class = match violation {
            Some(violation) => class_of_fault(violation.fault),
            None if answer == exact => Class::Agree,
            None => match zero {
                // A probe that touches nothing has no tie.
                ZeroMeaning::Never if exact.boundary.is_empty() => Class::SignFlip,
                ZeroMeaning::Never => Class::TieBroken,
                ZeroMeaning::Band => in_band(asked.session, content, probes[at], answer, exact),
                ZeroMeaning::Exact if answer.boundary.len() < exact.boundary.len() => Class::MissedZero,
                ZeroMeaning::Exact => Class::Overreach,
            },
        };
        // The shortcut is not compared if the answer is already wrong.
        let by_shortcut = shortcut.map(|all| all.get(at)).filter(|&other| class.is_legal() && other != answer);
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

/// The class of an answer with zeros within a band, if it differs from the exact answer. It must have all boundaries
/// that contain the probe. It may have others only if the probe is within the band of an edge, and within the reach of
/// its box.
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
        // Outward by more than the rounding error of the sums.
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

/// The class of a fault: `Topology` if the answer fits no sector; the other faults are broken promises about zeros.
fn class_of_fault(fault: Fault) -> Class {
    match fault {
        Fault::Gap | Fault::Double | Fault::Misplaced => Class::Topology,
        Fault::FalseBoundary => Class::Overreach,
        Fault::MissedBoundary => Class::MissedZero,
        Fault::UnbrokenTie => Class::Inconsistent,
    }
}
