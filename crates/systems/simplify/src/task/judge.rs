//! The judgement of an answer: its steps are done again, and each decision is compared with exact signs.

use predicament_judge::{Sample, is_within, rational, sign};
use predicament_laws::published;
use predicament_predicates::{Plane, PredicateKind, Query, Question, Scene, Sign, Vertex, ZeroMeaning};

use super::checks::{COUNT, DISTANCE, PERTURBED, REFUSED, STEPS, SURFACE, TRIANGLES, TURNED};
use super::{MeshToSimplify, Simplify, SimplifyRow};
use crate::answer::{Simplified, Step, same_facing};
use crate::checks::{Chains, Facing, Obstacle, Reached, Replay, facing};
use crate::truth::components;
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop};

/// The number of decisions that are compared with exact signs, at levels quick and full.
const DECISIONS: [u64; 2] = [20_000, 200_000];

/// The class of a decision, and the check that gives it.
type Verdict = (Class, &'static str);

/// The rules of a backend for zeros.
struct Rules<'a> {
    asked: &'a Asked<'a>,
    scene: &'a Scene,
    zero: ZeroMeaning,
    /// The largest values for which the session may answer zero: of the formula, and of the three projections.
    bands: [f64; 4],
}

impl<'a> Rules<'a> {
    fn new(asked: &'a Asked<'a>, scene: &'a Scene) -> Rules<'a> {
        let upper = |question: Question| published::band(asked.session, question).map_or(0.0, |band| band.upper);
        let [xy, yz, zx] = [Plane::Xy, Plane::Yz, Plane::Zx].map(|plane| upper(Question::Orient2d(plane)));
        let zero = asked.contract(PredicateKind::Derived(same_facing())).zero;
        Rules { asked, scene, zero, bands: [upper(Question::Derived(same_facing())), xy, yz, zx] }
    }

    /// True if the session may answer zero about a face.
    fn allows_zero(&self, face: [Vertex; 4]) -> bool {
        let limit = self.bands[0];
        limit > 0.0 && is_within(self.scene, Question::Derived(same_facing()), &face, limit)
    }

    /// True if the session may find a face without area before and after.
    fn allows_flat(&self, face @ [u, v, b, c]: [Vertex; 4]) -> bool {
        let planes = [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().zip(&self.bands[1..]);
        self.allows_zero(face)
            && planes.into_iter().all(|(plane, &limit)| {
                let question = Question::Orient2d(plane);
                [u, v].into_iter().all(|apex| is_within(self.scene, question, &[apex, b, c], limit))
            })
    }

    /// The sign of a tie in the perturbed scene; `None` if the backend does not break ties.
    fn tie(&self, face: [Vertex; 4]) -> Option<Sign> {
        let judge = self.asked.backend.tie_judge().filter(|_| self.zero == ZeroMeaning::Never)?;
        Some(judge(self.scene, Question::Derived(same_facing()), &face))
    }

    /// True if the backend may turn this face so.
    fn is_kept(&self, face: [Vertex; 4]) -> bool {
        match facing(self.scene, face) {
            Facing::Same => self.zero != ZeroMeaning::Band || !self.allows_zero(face),
            Facing::Flat => self.tie(face).unwrap_or(Sign::Positive) == Sign::Positive,
            Facing::Undecided => self.tie(face) == Some(Sign::Positive),
            Facing::Turned => false,
        }
    }

    /// The verdict on a face that a collapse has moved, by the truth about it.
    fn collapse(&self, face: [Vertex; 4], known: Facing) -> Verdict {
        if matches!(known, Facing::Flat | Facing::Undecided)
            && let Some(sign) = self.tie(face)
        {
            let class = if sign == Sign::Positive { Class::TieBroken } else { Class::SignFlip };
            return (class, PERTURBED);
        }
        match known {
            Facing::Same | Facing::Flat => (Class::Agree, TURNED),
            _ if self.zero == ZeroMeaning::Band && self.allows_flat(face) => (Class::InBand, TURNED),
            Facing::Undecided => (Class::MissedZero, TURNED),
            Facing::Turned => (Class::SignFlip, TURNED),
        }
    }

    /// The verdict on a face because of which a collapse was refused, by the truth about it.
    fn refusal(&self, face: [Vertex; 4], known: Facing, answer: Sign) -> Verdict {
        if self.zero == ZeroMeaning::Never && answer == Sign::Zero {
            return (Class::Inconsistent, PERTURBED);
        }
        match known {
            Facing::Turned => (Class::Agree, REFUSED),
            Facing::Same if answer == Sign::Negative => (Class::SignFlip, REFUSED),
            Facing::Same if self.allows_zero(face) => (Class::InBand, REFUSED),
            Facing::Same => (Class::Overreach, REFUSED),
            Facing::Flat | Facing::Undecided => match self.tie(face) {
                Some(sign) if sign == answer => (Class::TieBroken, PERTURBED),
                Some(_) => (Class::SignFlip, PERTURBED),
                None if known == Facing::Flat => (Class::MissedZero, REFUSED),
                None => (Class::Agree, REFUSED),
            },
        }
    }
}

/// The verdicts in the order in which they stand for a step: the worst first.
fn rank(class: Class) -> usize {
    let order = [Class::SignFlip, Class::Inconsistent, Class::MissedZero, Class::Overreach, Class::InBand];
    order.iter().position(|&other| other == class).unwrap_or(order.len() + usize::from(class == Class::Agree))
}

/// Judges an answer.
pub(super) fn judge(
    case: &Case<'_, Simplify>,
    asked: &Asked<'_>,
    answer: &Simplified,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let (scene, content) = (case.scene(), case.content);
    let rules = Rules::new(asked, scene);
    let decisions = DECISIONS[usize::from(asked.budget.thorough)];
    let sample = Sample::within(decisions, answer.steps.len(), 1);
    let limit = asked.budget.findings_per_class;
    let mut judged = Judged { rules, content, outcome, limit, faces: Faces::default() };
    let end = judged.steps(answer, sample, asked)?;
    let is_sound = judged.whole(case, answer, end.as_ref());
    if let Some((replay, _)) = &end
        && answer.triangles.len() > content.target
        && is_sound
    {
        judged.stuck(replay, decisions, asked)?;
    }
    let Faces { turned, undecided, needless } = judged.faces;
    let collapsed = answer.steps.iter().filter(|step| matches!(step, Step::Collapse { .. })).count();
    outcome.row(&SimplifyRow {
        suite: case.loaded.suite.clone(),
        scene: case.loaded.name.clone(),
        scene_id: case.loaded.id.clone(),
        backend: asked.backend.name(),
        triangles: content.triangles.len() as u64,
        target: content.target as u64,
        left: answer.triangles.len() as u64,
        collapsed: collapsed as u64,
        refused: (answer.steps.len() - collapsed) as u64,
        turned,
        undecided,
        needless,
        reach: Some(answer.reach).filter(|reach| reach.is_finite()),
    });
    if !sample.is_all() {
        outcome.sampled = Some(format!("decisions compared with exact signs: {sample}"));
    }
    Ok(())
}

/// The end of the steps: the triangles that are left, and how far vertices have moved.
type End = (Replay, (Reached, Chains));

/// Counts of faces.
#[derive(Clone, Copy, Default)]
struct Faces {
    turned: u64,
    undecided: u64,
    needless: u64,
}

struct Judged<'a, 'o> {
    rules: Rules<'a>,
    content: &'a MeshToSimplify,
    outcome: &'o mut Outcome,
    limit: usize,
    faces: Faces,
}

impl Judged<'_, '_> {
    fn note(&mut self, (class, check): Verdict, about: &[Vertex], told: impl FnOnce() -> [String; 2]) {
        self.outcome.note(class, self.limit, || {
            let [got, truth] = told();
            Finding::plain(class, check, vec![Query::of_task("simplify", about)], got, truth)
        });
    }

    /// Does the steps again; `None` if one is impossible.
    fn steps(&mut self, answer: &Simplified, sample: Sample, asked: &Asked<'_>) -> Result<Option<End>, Stop> {
        let (scene, target) = (self.rules.scene, self.content.target);
        let mut replay = Replay::new(scene.len(), &self.content.triangles);
        let (mut reached, mut chains) = (Reached::new(scene.len()), Chains::new(scene.len()));
        let mut went_on = false;
        for (at, step) in answer.steps.iter().enumerate() {
            asked.watch.done(0)?;
            let (Step::Collapse { gone, kept } | Step::Refusal { gone, kept, .. }) = *step;
            went_on |= replay.left() <= target;
            if let Some(why) = wrong(&replay, step) {
                self.note((Class::Topology, STEPS), &[gone, kept], || {
                    [format!("step {at}, {gone} into {kept}: {why}"), "each step is possible".to_owned()]
                });
                return Ok(None);
            }
            if sample.has(at) {
                self.decision(&replay, step);
            }
            if let Step::Collapse { .. } = step {
                replay.collapse(gone, kept);
                reached.join(gone, kept);
                chains.join(scene, gone, kept);
            }
        }
        if went_on {
            self.note((Class::Topology, COUNT), &[], || {
                let got = format!("{} triangles, and the target is {target}", replay.left());
                [got, "steps end when the target is reached".to_owned()]
            });
        }
        Ok(Some((replay, (reached, chains))))
    }

    /// Compares a decision with exact signs.
    fn decision(&mut self, replay: &Replay, step: &Step) {
        let scene = self.rules.scene;
        let (verdict, face) = match *step {
            Step::Refusal { gone, kept, base: [b, c], sign } => {
                let face = [gone, kept, b, c];
                let known = facing(scene, face);
                let is_tie = known == Facing::Flat && self.rules.zero == ZeroMeaning::Never;
                self.faces.needless += u64::from(known.is_kept() && !is_tie);
                (self.rules.refusal(face, known, sign), Some(face))
            }
            Step::Collapse { gone, kept } => {
                let mut worst = ((Class::Agree, TURNED), None);
                for face in replay.moved(gone, kept).map(|[b, c]| [gone, kept, b, c]) {
                    let known = facing(scene, face);
                    self.faces.turned += u64::from(known == Facing::Turned);
                    self.faces.undecided += u64::from(known == Facing::Undecided);
                    let verdict = self.rules.collapse(face, known);
                    if rank(verdict.0) < rank(worst.0.0) || worst.1.is_none() {
                        worst = (verdict, Some(face));
                    }
                }
                worst
            }
        };
        let done = if matches!(step, Step::Collapse { .. }) { "collapsed" } else { "refused" };
        self.note(verdict, face.as_ref().map_or(&[], |face| &face[..]), || {
            let told = face.map(|[u, v, b, c]| format!("{u} into {v}, with face {u} {b} {c}: {done}"));
            let truth = face.map(|face| told_truth(scene, face));
            [told.unwrap_or_default(), truth.unwrap_or_default()]
        });
    }

    /// Judges the triangles and the bound; true if the triangles are those that the steps leave.
    fn whole(&mut self, case: &Case<'_, Simplify>, answer: &Simplified, end: Option<&End>) -> bool {
        let scene = self.rules.scene;
        let mut is_sound = true;
        if let Some((replay, (reached, chains))) = end {
            let turned = |[a, b, c]: [Vertex; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min();
            let sorted = |all: &mut dyn Iterator<Item = [Vertex; 3]>| {
                let mut all: Vec<_> = all.map(turned).collect();
                all.sort_unstable();
                all
            };
            if sorted(&mut replay.triangles()) != sorted(&mut answer.triangles.iter().copied()) {
                is_sound = false;
                self.note((Class::Topology, TRIANGLES), &[], || {
                    [format!("{} triangles", answer.triangles.len()), format!("{} others", replay.left())]
                });
            }
            let farthest = reached.farthest(scene);
            let is_bound = answer.reach.is_infinite() || rational(answer.reach).square() >= farthest;
            if !is_bound || answer.reach > chains.largest() {
                self.note((Class::Topology, DISTANCE), &[], || {
                    let (far, most) = (farthest.to_f64().sqrt(), chains.largest());
                    [format!("at most {:e}", answer.reach), format!("{far:e}, and by steps at most {most:e}")]
                });
            }
        }
        let told = |components: Result<Vec<_>, _>| match components {
            Ok(all) => all.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "),
            Err(flaw) => format!("{flaw}"),
        };
        let found = components(&answer.triangles);
        let (class, check) = if found == case.truth { (Class::Agree, SURFACE) } else { (Class::Topology, SURFACE) };
        self.note((class, check), &[], || [told(found), told(case.truth.clone())]);
        is_sound
    }

    /// Looks for an edge that can be collapsed, if the target was not reached.
    fn stuck(&mut self, replay: &Replay, decisions: u64, asked: &Asked<'_>) -> Result<(), Stop> {
        let edges = replay.edges();
        let sample = Sample::within(decisions, edges.len(), 1);
        for [gone, kept] in sample.places().map(|at| edges[at]) {
            asked.watch.done(0)?;
            let mut moved = replay.moved(gone, kept);
            if replay.obstacle([gone, kept]).is_none() && moved.all(|[b, c]| self.rules.is_kept([gone, kept, b, c])) {
                drop(moved);
                self.note((Class::Topology, COUNT), &[gone, kept], || {
                    let got = format!("{} triangles are left", replay.left());
                    [got, format!("{gone} can be collapsed into {kept}")]
                });
                break;
            }
        }
        Ok(())
    }
}

/// The reason why a step is impossible.
fn wrong(replay: &Replay, step: &Step) -> Option<String> {
    match *step {
        Step::Collapse { gone, kept } => replay.obstacle([gone, kept]).map(|why| why.to_string()),
        Step::Refusal { gone, kept, base: [b, c], sign } => {
            let is_moved = replay.moved(gone, kept).any(|base| base == [b, c] || base == [c, b]);
            let is_edge = replay.obstacle([gone, kept]) != Some(Obstacle::NoEdge);
            (!is_edge || !is_moved || sign == Sign::Positive).then(|| "refused without a face that turns".to_owned())
        }
    }
}

/// The truth about a face, in words.
fn told_truth(scene: &Scene, face: [Vertex; 4]) -> String {
    let sign = sign(scene, Question::Derived(same_facing()), &face);
    format!("{}; exact sign {sign}", facing(scene, face).name())
}
