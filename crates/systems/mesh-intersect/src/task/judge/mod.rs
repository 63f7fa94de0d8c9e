//! The overlay of two meshes against the laws that it satisfies, decided in rationals.
//!
//! Pieces of each triangle cover it once, no piece passes through another one, and each piece is in the region of the other mesh that its
//! middle is in, as the judge of points in meshes says: that is all there is to it (`pieces.rs`, `located.rs`). The rest follows from this and is decided
//! by other means: volumes and areas of results (`measures.rs`), how pieces hang together (`topology.rs`), points of space in results
//! (`located.rs`), and the same overlay asked for in other ways (`again.rs`). What results are without the perturbation, and in doubles, is held
//! against them (`settled.rs`).

mod again;
mod located;
mod measures;
mod pieces;
mod settled;
mod topology;

use std::cell::OnceCell;

use crate::algorithm::overlay::{Contradiction, Regions, Source};
use predicament_judge::{Points, rational};
use predicament_predicates::{PredicateKind, Scene, Vertex, ZeroMeaning};
use predicament_slice::checks::{Check as Law, Expected};
use rug::Rational;

use self::settled::Settlement;
use super::content::TwoMeshes;
use super::{MeshIntersect, Overlaid};
use predicament_tasks::rounding::Rounding;
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop};

/// Triangles held against their neighbours, at the two levels.
const CROSSED: [usize; 2] = [16, 2_000];
/// Triangles that middles of pieces are held against, all together, at the two levels.
const LOCATED: [usize; 2] = [2_000, 400_000];
/// Overlays of more triangles have no volumes added up, at the two levels.
const ADDED_UP: [usize; 2] = [1_500, 40_000];

/// Points of space that are located, at the two levels.
const PROBED: [usize; 2] = [8, 200];
/// The checks of laws that rounded vertices are enough to violate: those about planes, areas and volumes.
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
/// Meshes of more triangles are not overlaid again, at the two levels; of 24 times as many where ties are not broken, which takes the most time.
const AGAIN: [usize; 2] = [12, 100];

type Point = [Rational; 3];

/// What is sampled.
pub(super) fn sampled(content: &TwoMeshes) -> Option<String> {
    (content.triangles() > CROSSED[0])
        .then(|| "pieces cover all triangles, and regions are closed; regions and crossings: an even sample".to_owned())
}

/// Judges an overlay.
pub(super) fn judge(
    case: &Case<'_, MeshIntersect>,
    asked: &Asked<'_>,
    answer: &Overlaid,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    if let Some(rule) = answer.broken.map(Contradiction::rule) {
        note(outcome, rule, "violated".to_owned(), rule);
        return Ok(());
    }
    let points = match points(case.scene(), answer, Where::Given) {
        Ok(points) => points,
        Err(v) => {
            note(outcome, "vertex not finite", format!("{v} has no finite coordinates"), "every vertex is a point");
            return Ok(());
        }
    };
    let level = usize::from(asked.budget.thorough);
    let laws = Laws { scene: case.scene(), content: case.content, answer, points, place: Where::Given };
    let exact = OnceCell::new();
    asked.watch.done(0)?;
    laws.closed(outcome);
    laws.sides(outcome);
    laws.operations(outcome);
    asked.watch.done(0)?;
    let has_areas = asked.contract(PredicateKind::Orient3d).zero != ZeroMeaning::Never;
    let crossed = |place: Where| if place == Where::Given { CROSSED[level] } else { 1 };
    let pieces = |laws: &Laws<'_>, outcome: &mut Outcome| {
        laws.pieces(Expected { is_closed: false, has_areas, triangles_crossed: crossed(laws.place) }, outcome);
        Ok(())
    };
    laws.measured(&exact, &pieces, outcome)?;
    asked.watch.done(0)?;
    laws.located(LOCATED[level], outcome);
    asked.watch.done(0)?;
    if laws.regions().triangles.len() <= ADDED_UP[level] {
        let measures = |laws: &Laws<'_>, outcome: &mut Outcome| {
            laws.volumes(outcome);
            asked.watch.done(0)?;
            laws.results(outcome);
            Ok(())
        };
        laws.measured(&exact, &measures, outcome)?;
    }
    asked.watch.done(0)?;
    laws.topology(outcome);
    asked.watch.done(0)?;
    let settlement = laws.settlement(outcome);
    if let Some(settlement) = &settlement {
        settlement.surfaces(CROSSED[level], outcome);
        asked.watch.done(0)?;
        if laws.regions().triangles.len() <= ADDED_UP[level] {
            settlement.planes(outcome);
        }
        asked.watch.done(0)?;
    }
    laws.probed(PROBED[level], settlement.as_ref(), outcome);
    asked.watch.done(0)?;
    let many = if has_areas { 24 * AGAIN[level] } else { AGAIN[level] };
    if case.content.triangles() <= many {
        laws.measured(&exact, &|laws, outcome| laws.again(asked, outcome), outcome)?;
    }
    if outcome.findings.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
    Ok(())
}

fn note(outcome: &mut Outcome, check: &str, got: String, law: &str) {
    outcome.counts.add(Class::Topology, 1);
    outcome.findings.push(Finding::plain(Class::Topology, check, Vec::new(), got, law.to_owned()));
}

/// Where vertices are that a session has rounded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Where {
    /// Where it has them.
    Given,
    /// Where they are exactly, if that is within the bound of [`Rounding`].
    Exactly,
}

/// All points: those of the scene, then the constructed ones, as they are or as the session has rounded them; or a vertex that is
/// no point, or not where it should be.
fn points(scene: &Scene, answer: &Overlaid, place: Where) -> Result<Vec<Point>, Vertex> {
    let mut all: Vec<Point> = scene.vertices().map(|v| scene.point3(v).map(rational)).collect();
    let vertex = |at: usize| Vertex::constructed(answer.before + at);
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
    let mut exact = Points::of(scene);
    let vertices = exact.construct(&answer.constructions).map_err(|why| vertex(why.index().unwrap_or(0)))?;
    for v in vertices {
        let point = exact.point(v).map(std::borrow::Cow::into_owned).ok_or(v)?;
        all.push(<Point>::try_from(point).map_err(|_| v)?);
    }
    Ok(all)
}

struct Laws<'a> {
    scene: &'a Scene,
    content: &'a TwoMeshes,
    answer: &'a Overlaid,
    points: Vec<Point>,
    place: Where,
}

/// What holds laws and notes what violates them.
type Holds<'l> = dyn Fn(&Laws<'_>, &mut Outcome) -> Result<(), Stop> + 'l;

impl<'a> Laws<'a> {
    /// Holds laws of which some are metric: what rounding alone explains is of the class that says so. `exact` is filled with the
    /// same answer with vertices where they are exactly, once it is needed.
    fn measured(
        &self,
        exact: &OnceCell<(Rounding<3>, Laws<'a>)>,
        laws: &Holds<'_>,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        let mut found = Outcome::default();
        laws(self, &mut found)?;
        let is_metric = |finding: &Finding| METRIC.contains(&finding.check.as_str());
        let rounded = self.answer.rounded.as_ref().filter(|_| found.findings.iter().any(is_metric));
        let exact = rounded.map(|rounded| exact.get_or_init(|| self.exactly(rounded)));
        let mut violated = Outcome::default();
        if let Some((_, exactly)) = exact {
            laws(exactly, &mut violated)?;
        }
        for mut finding in found.findings {
            if let Some((rounding, _)) = exact.filter(|_| is_metric(&finding)) {
                let (class, why) = rounding.class(violated.findings.iter().all(|other| other.check != finding.check));
                finding.class = class;
                finding.got += &format!("; {why}");
            }
            outcome.counts.add(finding.class, 1);
            outcome.findings.push(finding);
        }
        Ok(())
    }

    /// The same answer with vertices where they are exactly.
    fn exactly(&self, rounded: &[[f64; 3]]) -> (Rounding<3>, Laws<'a>) {
        let rounding = Rounding::of_definitions(self.scene, &self.answer.constructions, rounded);
        let inputs = self.points[..self.scene.len()].iter();
        let points = inputs.chain(&rounding.exact).cloned().collect();
        (rounding, Laws { points, place: Where::Exactly, ..*self })
    }
}

impl Laws<'_> {
    /// The results without a perturbation, if they were asked for and the session can say what they are.
    fn settlement(&self, outcome: &mut Outcome) -> Option<Settlement<'_>> {
        match self.answer.settled.as_ref()? {
            Ok(settled) => {
                let settlement = Settlement::new(self, settled);
                if settlement.is_none() {
                    note(outcome, "vertex of a limit", "one is no point".to_owned(), "every vertex is a point");
                }
                settlement
            }
            Err(why) => {
                note(
                    outcome,
                    "limit",
                    why.to_string(),
                    "where each constructed vertex is a point, a result has a limit",
                );
                None
            }
        }
    }

    fn regions(&self) -> &Regions {
        &self.answer.regions
    }

    fn place(&self, v: Vertex) -> usize {
        v.construction().map_or(v.index(), |index| self.scene.len() + index - self.answer.before)
    }

    fn corners(&self, triangle: [Vertex; 3]) -> [&Point; 3] {
        triangle.map(|v| &self.points[self.place(v)])
    }
}

fn name(source: Source) -> String {
    format!("triangle {} of the {} mesh", source.triangle, ["first", "second"][usize::from(source.mesh)])
}
