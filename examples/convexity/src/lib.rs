//! Convexity: the direction in which a polygon turns at each of its corners.

use predicament::corpus::{Canon, Content, Context, LoadedScene, Parts, SceneFormat, Source, Spelled, spelled_points};
use predicament::formats::{CorpusError, Fields, read_points};
use predicament::judge;
use predicament::predicates::{Dimension, Plane, PredicateKind, Predicates, Query, Question, Scene, Sign, Vertex};
use predicament::tasks::output::{self, Files};
use predicament::tasks::signs::classify;
use predicament::tasks::{
    Answer, Asked, Case, Check, Class, Contestant, ExplainError, Explanation, Finding, Halt, How, Outcome, Spoiled,
    Stop, Task, Watch, digest,
};

/// The task.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Convexity;

/// The content of a scene: its points are the corners of a polygon, in order.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Polygon {
    corners: usize,
}

impl Polygon {
    /// The corner before this one, the corner, and the corner after it.
    fn corner(&self, at: usize) -> [Vertex; 3] {
        [at + self.corners - 1, at, at + 1].map(|place| Vertex::input(place % self.corners))
    }

    fn all(&self) -> impl Iterator<Item = [Vertex; 3]> {
        (0..self.corners).map(|at| self.corner(at))
    }
}

impl Content for Polygon {
    fn count(&self) -> usize {
        self.corners
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("convexity");
    }

    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        Some(spelled_points(scene))
    }
}

/// The answer: positive for a left turn, zero for a straight corner.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Turns(pub Vec<Sign>);

impl Answer for Turns {
    fn digest(&self) -> u64 {
        digest(self.0.iter().flat_map(|sign| sign.as_i8().to_le_bytes()))
    }
}

impl SceneFormat for Convexity {
    fn name(&self) -> &'static str {
        "convexity"
    }

    fn about(&self) -> &'static str {
        "the turn at each corner of a polygon"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn read(&self, _: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        let field = fields.required("points")?;
        let (dimension, coordinates) = read_points(&field)?;
        let scene =
            Scene::new(dimension, coordinates).map_err(|why| field.error(why.to_string(), "mend the points"))?;
        if scene.dimension() != Dimension::Two || scene.len() < 3 {
            return Err(field.error("this is no polygon", "write at least three points with two coordinates each"));
        }
        let corners = scene.len();
        Ok(Source::Written(Parts::new(scene, Polygon { corners })))
    }
}

const TURN: Question = Question::Orient2d(Plane::Xy);

impl Task for Convexity {
    type Content = Polygon;
    type Truth = Vec<Sign>;
    type Answer = Turns;

    fn asks(&self, _: &Scene) -> Vec<PredicateKind> {
        vec![PredicateKind::Orient2d]
    }

    /// The exact signs, by the judge's rationals: no backend is asked.
    fn truth(&self, scene: &Scene, content: &Polygon, watch: &Watch) -> Result<Vec<Sign>, Stop> {
        watch.done(content.count() as u64)?;
        Ok(content.all().map(|corner| judge::sign(scene, TURN, &corner)).collect())
    }

    /// The algorithm under test, on any backend's session.
    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Polygon,
        how: &How<'_>,
        answer: &mut Turns,
    ) -> Result<(), Halt> {
        answer.0.clear();
        answer.0.extend(content.all().map(|[a, b, c]| session.orient2d(Plane::Xy, a, b, c)));
        Ok(how.watch.done(content.count() as u64)?)
    }

    /// Puts each corner into a class, by the truth and by what the backend's zero means.
    fn judge(
        &self,
        case: &Case<'_, Convexity>,
        asked: &Asked<'_>,
        answer: &Turns,
        outcome: &mut Outcome,
    ) -> Result<(), Stop> {
        let zero = asked.contract(PredicateKind::Orient2d).zero;
        let ties = asked.backend.tie_judge();
        for (at, corner) in case.content.all().enumerate() {
            let (turn, truth) = (answer.0[at], case.truth[at]);
            let within = |limit| judge::is_within(case.scene(), TURN, &corner, limit);
            let class = match classify(zero, asked.session.band(TURN), turn, truth, within) {
                // A broken tie is right where the backend's own perturbation breaks it so.
                Class::TieBroken if ties.is_some_and(|ties| ties(case.scene(), TURN, &corner) != turn) => {
                    Class::SignFlip
                }
                class => class,
            };
            outcome.note(class, asked.budget.findings_per_class, || {
                let query = Query::of_task("convexity", &[corner[1]]);
                Finding::plain(class, "turn", vec![query], turn.to_string(), truth.to_string())
            });
        }
        Ok(())
    }

    fn describe(&self, _: &LoadedScene, content: &Polygon, _: &Watch) -> Result<String, Stop> {
        Ok(format!("a polygon with {} corners\n", content.count()))
    }

    fn explain(
        &self,
        scene: &Scene,
        content: &Polygon,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let vertex = query.vertices().next().filter(|vertex| vertex.index() < content.corners);
        let vertex = vertex.ok_or_else(|| ExplainError::not_of_task(query, "names no corner"))?;
        let corner = content.corner(vertex.index());
        let about = Explanation {
            vertices: corner.to_vec(),
            truth: vec![format!("exactly: {}", judge::sign(scene, TURN, &corner))],
            ..Explanation::default()
        };
        let turn = |answer: Turns| answer.0[vertex.index()].to_string();
        Ok(about.with_answers(backends, |backend| backend.answer(self, scene, content).map(turn)))
    }

    fn write(&self, _: &Scene, _: &Polygon, answer: &Turns, files: &mut Files) -> Result<(), output::Error> {
        files.write("turns.csv", |out| {
            writeln!(out, "corner,turn")?;
            answer.0.iter().enumerate().try_for_each(|(corner, turn)| writeln!(out, "{corner},{turn}"))
        })
    }

    /// The checks that `judge` can report.
    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::new(Class::SignFlip, "turn", "a corner turns the way that it is said to"),
                Check::new(Class::MissedZero, "turn", "a straight corner is found straight"),
                Check::new(Class::Overreach, "turn", "a corner that is found straight is straight"),
                Check::new(Class::Inconsistent, "turn", "where ties are broken no corner is straight"),
            ]
        }
    }

    /// A fault that `judge` has to find: `selftest` plants it.
    fn spoiled(&self) -> Vec<Spoiled<Convexity>> {
        let turned = |_: &Scene, _: &Polygon, answer: &mut Turns| answer.0.iter_mut().for_each(|turn| *turn = -*turn);
        let checks = &[(Class::SignFlip, "turn")];
        vec![Spoiled::new("convexity-other-way", "every turn is the other way", "exact", checks, turned)]
    }
}
