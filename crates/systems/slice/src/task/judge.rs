//! Judging of the parts by the laws for parts of a mesh, decided in rationals.

use crate::algorithm::{Part, Source};
use crate::checks as laws;
use crate::checks::{Expected, Piece, Slices};
use crate::truth;
use predicament_judge::rational;
use predicament_predicates::{PredicateKind, Scene, Vertex, ZeroMeaning};
use rug::Rational;

use super::{Cut, Slice};
use predicament_tasks::rounding::{Excuse, Rounding};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop, bits};

/// The number of triangles that are compared with their neighbours, at levels quick and full.
const TRIANGLES_CROSSED: [usize; 2] = [100, 4_000];

/// Judges the parts of a mesh.
pub(super) fn judge(
    case: &Case<'_, Slice>,
    asked: &Asked<'_>,
    answer: &Cut,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    if let Some((broken, place)) = answer.sliced.broken {
        let place = place.map_or("in the end".to_owned(), |place| format!("at plane {place}"));
        note(outcome, Class::Topology, broken.rule(), format!("violated {place}"), "holds".to_owned());
        if answer.sliced.broken.is_some_and(|(_, place)| place.is_some()) {
            // The parts are incomplete: laws about them mean nothing.
            return Ok(());
        }
    }
    let slices = match slices(case, answer) {
        Ok(slices) => slices,
        Err(vertex) => {
            let got = format!("{vertex} has no finite coordinates");
            note(outcome, Class::Topology, "vertex not finite", got, "every vertex is a point".to_owned());
            return Ok(());
        }
    };
    let expected = Expected {
        is_closed: case.content.is_closed,
        has_areas: asked.contract(PredicateKind::Orient3d).zero != ZeroMeaning::Never,
        may_stand: true,
        triangles_crossed: TRIANGLES_CROSSED[usize::from(asked.budget.thorough)],
    };
    let key = || (expected.has_areas, answer.clone(), answer.rounded.as_deref().map(bits));
    let flaws = case.once(asked, key, || Ok(slices.flaws(expected)))?;
    let is_metric = |flaw: &&laws::Flaw| flaw.check.is_metric();
    let excuse = answer.rounded.as_ref().filter(|_| flaws.iter().any(|flaw| is_metric(&flaw))).map(|rounded| {
        let rounding = Rounding::of_definitions(case.scene(), &answer.sliced.constructions, rounded);
        // The laws for the exact vertices; only the metric laws count.
        let inputs = slices.points[..case.scene().len()].iter();
        let slices = Slices { points: inputs.chain(&rounding.exact).cloned().collect(), ..slices.clone() };
        let violated = slices.flaws(Expected { triangles_crossed: 1, ..expected });
        let violated = violated.iter().filter(is_metric).map(|flaw| flaw.check).collect();
        Excuse { rounding, violated }
    });
    for flaw in flaws {
        let told = format!("{} times, first: {}", flaw.count, flaw.what);
        let (class, got) = Excuse::judged(excuse.as_ref().filter(|_| is_metric(&&flaw)), &flaw.check, told);
        note(outcome, class, flaw.check.name(), got, flaw.check.law().to_owned());
    }
    if outcome.findings.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
    Ok(())
}

fn note(outcome: &mut Outcome, class: Class, check: &str, got: String, law: String) {
    outcome.counts.add(class, 1);
    outcome.findings.push(Finding::plain(class, check, Vec::new(), got, law));
}

/// The parts with the session's points, or the vertex that is not a point.
fn slices(case: &Case<'_, Slice>, answer: &Cut) -> Result<Slices, Vertex> {
    let (scene, content) = (case.scene(), case.content);
    let place = |v: Vertex| {
        let place = v.construction().map_or(v.index(), |index| scene.len() + index - answer.before);
        u32::try_from(place).expect("a scene holds fewer than 2^32 vertices of both kinds")
    };
    let piece = |source: &Source| match *source {
        Source::Face(face) => Piece::Face(face as usize),
        Source::Cap(plane) => Piece::Cap(plane as usize),
        Source::Cover => Piece::Cover,
    };
    let part = |part: &Part| laws::Part {
        triangles: part.triangles.iter().map(|triangle| triangle.map(place)).collect(),
        pieces: part.sources.iter().map(piece).collect(),
        open: part.open.iter().map(|around| around.iter().map(|&v| place(v)).collect()).collect(),
    };
    let inputs = scene.vertices().map(|v| scene.point3(v).map(rational));
    let points = inputs.chain(constructed(scene, answer)?).collect();
    Ok(Slices {
        points,
        faces: content.faces.iter().map(<[u32]>::to_vec).collect(),
        planes: content.planes.iter().map(|plane| plane.map(place)).collect(),
        parts: answer.sliced.parts.iter().map(part).collect(),
    })
}

/// The constructed vertices: exact, or as the session has rounded them.
fn constructed(scene: &Scene, answer: &Cut) -> Result<Vec<[Rational; 3]>, Vertex> {
    let vertex = |at: usize| Vertex::constructed(answer.before + at);
    if let Some(rounded) = &answer.rounded {
        let exactly = |(at, point): (usize, &[f64; 3])| {
            let finite = point.iter().all(|x| x.is_finite());
            if finite { Ok(point.map(rational)) } else { Err(vertex(at)) }
        };
        return rounded.iter().enumerate().map(exactly).collect();
    }
    truth::constructed(scene, &answer.sliced.constructions).map_err(vertex)
}
