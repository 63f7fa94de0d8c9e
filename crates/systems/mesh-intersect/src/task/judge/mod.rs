//! Judging of an overlay of two meshes by its laws, decided in rationals.
//!
//! The laws are in the [checks](crate::checks). This module chooses their order and sample sizes, and repeats the
//! overlay in other ways (`again.rs`). It separates violations that rounding alone explains from others.

mod again;

use std::cell::{LazyCell, OnceCell};
use std::sync::Arc;

use crate::algorithm::overlay::Contradiction;
use crate::checks::{Laws, Point, Settled, Settlement, Violation, Violations, note};
use crate::truth;
use predicament_corpus::Random;
use predicament_judge::rational;
use predicament_predicates::{PredicateKind, Scene, Vertex, ZeroMeaning};
use predicament_slice::checks::{Check as Law, Expected};

use super::content::TwoMeshes;
use super::{MeshIntersect, Overlaid};
use predicament_tasks::rounding::Rounding;
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop, bits};

/// The number of triangles compared with their neighbours, at the two levels.
const CROSSED: [usize; 2] = [16, 2_000];
/// The number of triangles compared with middles of pieces, all together, at the two levels.
const LOCATED: [usize; 2] = [2_000, 400_000];
/// The maximum number of triangles of an overlay whose volumes are summed, at the two levels.
const ADDED_UP: [usize; 2] = [1_500, 40_000];

/// The number of points in space that are located, at the two levels.
const PROBED: [usize; 2] = [8, 200];
/// The checks of laws that rounding of vertices alone can violate: those about planes, areas and volumes.
const METRIC: [&str; 8] = [
    Law::PieceInFace.name(),
    Law::FaceArea.name(),
    "volume",
    "volumes of results",
    "areas of results",
    "a mesh with itself",
    "meshes exchanged",
    "difference by complement",
];
/// The maximum number of triangles of meshes whose contacts are computed from all pairs, at the two levels.
const CONTACTS: [usize; 2] = [40, 300];
/// The maximum number of triangles of meshes that are overlaid again, at the two levels; 24 times as many if ties are
/// not broken, because tie-breaking takes the most time.
const AGAIN: [usize; 2] = [12, 100];

/// The parts of the check that are sampled, as text.
pub(super) fn sampled(content: &TwoMeshes) -> Option<String> {
    (content.triangles() > CROSSED[0])
        .then(|| "pieces cover all triangles, and regions are closed; regions and crossings: an even sample".to_owned())
}

/// Judges an overlay by the laws, and by repeated overlays.
pub(super) fn judge(
    case: &Case<'_, MeshIntersect>,
    asked: &Asked<'_>,
    answer: &Overlaid,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    laws(case, asked, answer, outcome)?;
    let level = usize::from(asked.budget.thorough);
    let many = if has_areas(asked) { 24 * AGAIN[level] } else { AGAIN[level] };
    if case.content.triangles() <= many
        && answer.broken.is_none()
        && let Ok(points) = points(case.scene(), answer, Where::Given)
    {
        let judged = Judging::new(case.scene(), case.content, answer, points, Where::Given);
        judged.measured(&OnceCell::new(), &|judged, found| judged.again(asked, found), outcome)?;
    }
    if outcome.findings.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
    Ok(())
}

/// True if pieces must have an area: only a perturbation makes pieces without.
fn has_areas(asked: &Asked<'_>) -> bool {
    zero(asked) != ZeroMeaning::Never
}

fn zero(asked: &Asked<'_>) -> ZeroMeaning {
    asked.contract(PredicateKind::Orient3d).zero
}

/// Judges an overlay by the laws alone, once for all backends with this answer and this promise.
pub(super) fn laws(
    case: &Case<'_, MeshIntersect>,
    asked: &Asked<'_>,
    answer: &Overlaid,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let key = || {
        let coordinates = answer.rounded.as_deref().map(bits);
        (zero(asked), answer.clone(), coordinates, answer.settled.as_ref().map(places))
    };
    once(case, asked, key, &|outcome| by_laws(case, asked, answer, outcome), outcome)
}

/// Adds an outcome that is found once for a key.
fn once<K: PartialEq + Send + 'static>(
    case: &Case<'_, MeshIntersect>,
    asked: &Asked<'_>,
    key: impl FnOnce() -> K,
    judge: &dyn Fn(&mut Outcome) -> Result<(), Stop>,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let Outcome { counts, findings, .. } = case.once(asked, key, || {
        let mut outcome = Outcome::default();
        judge(&mut outcome).map(|()| outcome)
    })?;
    outcome.counts.merge(&counts);
    outcome.findings.extend(findings);
    Ok(())
}

/// The coordinates of settled results, as bits.
fn places(settled: &Result<super::Settled, super::Unsettled>) -> [Vec<u64>; 4] {
    settled.as_ref().map_or_else(
        |_| Default::default(),
        |settled| settled.results.each_ref().map(|result| bits(&result.rounded.closed.points)),
    )
}

fn by_laws(
    case: &Case<'_, MeshIntersect>,
    asked: &Asked<'_>,
    answer: &Overlaid,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let found = &mut Vec::new();
    if let Some(rule) = answer.broken.map(Contradiction::rule) {
        note(found, rule, "violated".to_owned(), rule);
        report(found, outcome);
        return Ok(());
    }
    let points = match points(case.scene(), answer, Where::Given) {
        Ok(points) => points,
        Err(v) => {
            note(found, "vertex not finite", format!("{v} has no finite coordinates"), "every vertex is a point");
            report(found, outcome);
            return Ok(());
        }
    };
    let level = usize::from(asked.budget.thorough);
    let judged = Judging::new(case.scene(), case.content, answer, points, Where::Given);
    let laws = &judged.laws;
    let exact = OnceCell::new();
    asked.watch.done(0)?;
    laws.closed(found);
    laws.sides(found);
    laws.operations(found);
    report(found, outcome);
    asked.watch.done(0)?;
    let has_areas = has_areas(asked);
    let crossed = |place: Where| if place == Where::Given { CROSSED[level] } else { 1 };
    let pieces = |judged: &Judging<'_>, found: &mut Violations| {
        let triangles_crossed = crossed(judged.place);
        judged.laws.pieces(Expected { is_closed: false, has_areas, may_stand: false, triangles_crossed }, found);
        Ok(())
    };
    // All that these laws read, so that backends with other contacts or limits share what they have in common.
    let parts = LazyCell::new(|| {
        let Overlaid { regions, solids, sources, constructions, before, .. } = answer.clone();
        Arc::new((regions, solids, sources, constructions, before, answer.rounded.as_deref().map(bits)))
    });
    let of_parts = |law: &'static str| (law, Arc::clone(&parts));
    once(
        case,
        asked,
        || (has_areas, of_parts("pieces")),
        &|outcome| judged.measured(&exact, &pieces, outcome),
        outcome,
    )?;
    asked.watch.done(0)?;
    let located = |outcome: &mut Outcome| {
        let mut found = Violations::new();
        laws.located(LOCATED[level], &mut found);
        report(&mut found, outcome);
        Ok(())
    };
    once(case, asked, || of_parts("located"), &located, outcome)?;
    asked.watch.done(0)?;
    let is_added_up = laws.regions.triangles.len() <= ADDED_UP[level];
    if is_added_up {
        let measures = |judged: &Judging<'_>, found: &mut Violations| {
            judged.laws.volumes(found);
            asked.watch.done(0)?;
            judged.laws.results(found);
            Ok(())
        };
        once(case, asked, || of_parts("measures"), &|outcome| judged.measured(&exact, &measures, outcome), outcome)?;
    }
    asked.watch.done(0)?;
    let zeros_are_exact = zero(asked) == ZeroMeaning::Exact;
    laws.topology(zeros_are_exact, found);
    asked.watch.done(0)?;
    if zeros_are_exact && answer.rounded.is_none() && case.content.triangles() <= CONTACTS[level] {
        laws.contacts(&answer.contacts, found);
        asked.watch.done(0)?;
    }
    let settlement = judged.settlement(found);
    if let Some(settlement) = &settlement {
        found.extend(case.once(asked, || settlement.of_surfaces(), || Ok(settlement.surfaces(CROSSED[level])))?);
        asked.watch.done(0)?;
        if is_added_up {
            settlement.planes(found);
        }
        asked.watch.done(0)?;
    }
    laws.probed(&probes(case.scene(), case.content, PROBED[level]), settlement.as_ref(), found);
    report(found, outcome);
    asked.watch.done(0)
}

/// Converts violations to findings.
fn report(found: &mut Violations, outcome: &mut Outcome) {
    for Violation { check, got, law } in found.drain(..) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.push(Finding::plain(Class::Topology, check, Vec::new(), got, law.to_owned()));
    }
}

/// The choice of positions for vertices that a session has rounded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Where {
    /// The session's rounded positions.
    Given,
    /// The exact positions, if they are within the bound of [`Rounding`].
    Exactly,
}

/// All points: those of the scene, then the constructed ones, exact or as the session has rounded them; or a vertex
/// that is not a point, or is off its position.
fn points(scene: &Scene, answer: &Overlaid, place: Where) -> Result<Vec<Point>, Vertex> {
    let vertex = |at: usize| Vertex::constructed(answer.before + at);
    let mut all = truth::given(scene);
    if let (Some(rounded), Where::Exactly) = (&answer.rounded, place) {
        let rounding = Rounding::of_definitions(scene, &answer.constructions, rounded);
        let is_there = rounding.is_within() && rounding.exact.len() == rounded.len();
        all.extend(rounding.exact);
        return if is_there { Ok(all) } else { Err(vertex(0)) };
    }
    if let Some(rounded) = &answer.rounded {
        for (at, point) in rounded.iter().enumerate() {
            if point.iter().any(|x| !x.is_finite()) {
                return Err(vertex(at));
            }
            all.push(point.map(rational));
        }
        return Ok(all);
    }
    truth::points(scene, &answer.constructions).map_err(vertex)
}

/// An answer that is being judged.
pub(super) struct Judging<'a> {
    laws: Laws<'a>,
    answer: &'a Overlaid,
    place: Where,
}

/// A function that checks laws and records violations.
pub(super) type Holds<'l> = dyn Fn(&Judging<'_>, &mut Violations) -> Result<(), Stop> + 'l;

impl<'a> Judging<'a> {
    fn new(
        scene: &'a Scene,
        content: &'a TwoMeshes,
        answer: &'a Overlaid,
        points: Vec<Point>,
        place: Where,
    ) -> Judging<'a> {
        let laws = Laws {
            scene,
            meshes: &content.meshes,
            regions: &answer.regions,
            solids: &answer.solids,
            sources: &answer.sources,
            constructions: &answer.constructions,
            before: answer.before,
            points,
        };
        Judging { laws, answer, place }
    }

    /// Checks laws, some of which are metric: violations that rounding alone explains get the class `Rounded`. `exact`
    /// is filled with the same answer with vertices at their exact positions, when it is first needed.
    fn measured(
        &self,
        exact: &OnceCell<(Rounding<3>, Judging<'a>)>,
        laws: &Holds<'_>,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        let mut found = Violations::new();
        laws(self, &mut found)?;
        let is_metric = |violation: &Violation| METRIC.contains(&violation.check);
        let rounded = self.answer.rounded.as_ref().filter(|_| found.iter().any(is_metric));
        let exact = rounded.map(|rounded| exact.get_or_init(|| self.exactly(rounded)));
        let mut violated = Violations::new();
        if let Some((_, exactly)) = exact {
            laws(exactly, &mut violated)?;
        }
        for violation in found {
            let (mut class, mut got) = (Class::Topology, violation.got.clone());
            if let Some((rounding, _)) = exact.filter(|_| is_metric(&violation)) {
                let (of_rounding, why) = rounding.class(violated.iter().all(|other| other.check != violation.check));
                class = of_rounding;
                got += &format!("; {why}");
            }
            outcome.counts.add(class, 1);
            outcome.findings.push(Finding::plain(class, violation.check, Vec::new(), got, violation.law.to_owned()));
        }
        Ok(())
    }

    /// The same answer with vertices at their exact positions.
    fn exactly(&self, rounded: &[[f64; 3]]) -> (Rounding<3>, Judging<'a>) {
        let rounding = Rounding::of_definitions(self.laws.scene, &self.answer.constructions, rounded);
        let inputs = self.laws.points[..self.laws.scene.len()].iter();
        let points = inputs.chain(&rounding.exact).cloned().collect();
        (rounding, Judging { laws: Laws { points, ..self.laws }, answer: self.answer, place: Where::Exactly })
    }

    /// The results without the perturbation, if they were requested and the session can compute them.
    fn settlement(&self, found: &mut Violations) -> Option<Settlement<'_>> {
        match self.answer.settled.as_ref()? {
            Ok(settled) => {
                let results = settled.results.each_ref().map(|result| Settled {
                    limit: &result.solid.triangles,
                    points: &result.rounded.closed.points,
                    triangles: &result.rounded.closed.triangles,
                    vertices: &result.rounded.vertices,
                    is_whole: result.rounded.counts.left == 0,
                });
                let settlement = Settlement::new(&self.laws, &settled.constructions, results);
                if settlement.is_none() {
                    note(found, "vertex of a limit", "one is not a point".to_owned(), "every vertex is a point");
                }
                settlement
            }
            Err(why) => {
                note(found, "limit", why.to_string(), "a result has a limit if every constructed vertex is a point");
                None
            }
        }
    }
}

/// Points in general position: every second one in the box of both meshes, the others where the boxes of the meshes
/// overlap.
fn probes(scene: &Scene, content: &TwoMeshes, count: usize) -> Vec<[f64; 3]> {
    let mut random = Random::new("points", "mesh-intersect", 1);
    let boxes = content.meshes.each_ref().map(|mesh| {
        let corners = || mesh.triangles().as_flattened().iter().map(|&v| scene.point3(v));
        [0, 1, 2].map(|axis: usize| {
            let along = || corners().map(|p| p[axis]);
            [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]
        })
    });
    let both = |axis: usize| boxes.each_ref().map(|along| along[axis]);
    let within = |random: &mut Random, shared: bool| {
        [0, 1, 2].map(|axis: usize| {
            let [[a, b], [c, d]] = both(axis);
            let [low, high] = if shared { [a.max(c), b.min(d)] } else { [a.min(c), b.max(d)] };
            let part = random.unit();
            low * (1.0 - part) + high * part
        })
    };
    (0..count).map(|at| within(&mut random, at % 2 == 1)).collect()
}
