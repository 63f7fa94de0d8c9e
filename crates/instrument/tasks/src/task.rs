//! The trait that a task implements.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use predicament_corpus::{Content, LoadedScene, SceneFormat};
use predicament_predicates::{Declined, PredicateKind, Predicates, Query, QuerySet, Scene, Sign, Vertex};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_report::drawing::Role;

use crate::output::Canvas;
use crate::{
    Asked, Case, Check, Compared, Contestant, Dispute, ExplainError, Halt, How, Knob, Outcome, Phase, Spoiled, Stop,
    Turns, Watch,
};

/// An answer to everything that a scene asks. It is reused from pass to pass
/// where time is measured, so that memory is not.
pub trait Answer: Default + Clone + Send + Sync + 'static {
    /// A digest of all that is judged: equal digests, equal answers (with the
    /// usual odds for 64 bits).
    fn digest(&self) -> u64;
}

/// One task: keys, truth, solving, judging, explaining, output and report of one kind of question.
///
/// How its scenes are written in suites is [`SceneFormat`]; the rest is here.
/// A value is a task with its parameters (`orient2d` and `orient3d` are values of
/// one type), so every method takes `&self`.
pub trait Task: SceneFormat + Sized + 'static {
    /// What a scene asks besides its points.
    type Content: Content;
    /// The right answers, from the crate `judge` or another computation that shares nothing with
    /// [`solve`](Task::solve).
    type Truth: Send + Sync + 'static;
    /// The answers of a backend to one scene.
    type Answer: Answer;

    /// The predicates that it asks: a session that refuses one of them declines the
    /// scene, and stages are counted for these.
    fn asks(&self, scene: &Scene) -> Vec<PredicateKind>;

    /// Whether a session can be asked at all.
    ///
    /// # Errors
    /// [`Declined`] with the session's reason.
    fn supported(&self, session: &dyn Predicates) -> Result<(), Declined> {
        self.asks(session.scene()).into_iter().try_for_each(|kind| session.supports(kind))
    }

    /// Whether solving adds vertices to the session: timed passes then begin with a fresh one.
    fn constructs(&self) -> bool {
        false
    }

    /// Whether the answer to a scene is judged as a whole: if one law is broken, the answer is. Otherwise each query has an
    /// answer of its own, with a class.
    fn judges_whole(&self) -> bool {
        false
    }

    /// Whether [`solve`](Task::solve) looks at its watch often enough to be stopped by it. What
    /// does not runs in a process of its own under a time limit.
    fn looks_at_watch(&self) -> bool {
        false
    }

    /// Computes the truth about a scene, once for all backends.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    fn truth(&self, scene: &Scene, content: &Self::Content, watch: &Watch) -> Result<Self::Truth, Stop>;

    /// How much of the scene the truth is about, where that is not all of it.
    fn sampled(&self, truth: &Self::Truth) -> Option<String> {
        let _ = truth;
        None
    }

    /// Holds what came with the data, if anything, against the truth.
    fn dispute(&self, case: &Case<'_, Self>) -> Option<Dispute> {
        let _ = case;
        None
    }

    /// Answers everything. Run, bench, replay and pictures all come through here.
    /// Where it needs no speed of its own it asks through `&dyn Predicates`.
    ///
    /// # Errors
    /// [`Halt`] where the watch says so, or the session refuses to construct a vertex.
    fn solve<P: Predicates>(
        &self,
        session: &mut P,
        content: &Self::Content,
        how: &How<'_>,
        answer: &mut Self::Answer,
    ) -> Result<(), Halt>;

    /// Classifies an answer and adds findings and rows to the outcome.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    fn judge(
        &self,
        case: &Case<'_, Self>,
        asked: &Asked<'_>,
        answer: &Self::Answer,
        outcome: &mut Outcome,
    ) -> Result<(), Stop>;

    /// A scene in a few lines of text, for `corpus gen`.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    fn describe(&self, loaded: &LoadedScene, content: &Self::Content, watch: &Watch) -> Result<String, Stop>;

    /// Asks one query of a finding again, alone, for `replay`.
    ///
    /// # Errors
    /// [`ExplainError`] where the query is not one of this task or the scene.
    fn explain(
        &self,
        scene: &Scene,
        content: &Self::Content,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError>;

    /// Writes an answer for other programs into a folder that exists; the files written.
    ///
    /// # Errors
    /// That of the file system.
    fn write(
        &self,
        scene: &Scene,
        content: &Self::Content,
        answer: &Self::Answer,
        folder: &Path,
    ) -> std::io::Result<Vec<PathBuf>>;

    /// Draws a scene, and an answer to it if there is one: its points, where a task has nothing else to show.
    ///
    /// # Errors
    /// Where a vertex of the answer is no point.
    fn draw(
        &self,
        scene: &Scene,
        content: &Self::Content,
        answer: Option<&Self::Answer>,
        canvas: &mut Canvas,
    ) -> std::io::Result<()> {
        let _ = (content, answer);
        canvas.points(scene, "points", Role::Given, scene.vertices()).map(|_| ())
    }

    /// The queries of a scene that asks nothing but one predicate. They are timed one by one and in batches, in
    /// [orders](crate::Rounds) that no branch predictor can learn; of other scenes whole answers are timed.
    fn queries<'c>(&self, content: &'c Self::Content) -> Option<&'c QuerySet> {
        let _ = content;
        None
    }

    /// How large a scene is, by which the growth of times is told: the number of queries where it has no better measure.
    fn size(&self, content: &Self::Content) -> usize {
        content.count()
    }

    /// Whether solving takes all threads of the current pool: benches time it on each number of threads that they are given.
    fn takes_threads(&self) -> bool {
        false
    }

    /// By how many primitives the tables of a bench divide the time of a scene; none where the task has no such tables.
    fn primitives(&self, scene: &Scene, content: &Self::Content) -> Option<u64> {
        let _ = (scene, content);
        None
    }

    /// What a bench folder says about its scenes, as Markdown: `primitives` by the id of each scene that has some, on so many threads.
    ///
    /// # Errors
    /// Where a table of the run cannot be read.
    fn timed(
        &self,
        run: &RunDir,
        primitives: &BTreeMap<String, u64>,
        threads: &[usize],
    ) -> Result<String, predicament_records::Error> {
        let _ = (run, primitives, threads);
        Ok(String::new())
    }

    /// Times the parts of using the algorithm that ask no predicate, one after the other, on all threads of the current
    /// pool. `bench` has them for all backends at once.
    fn building(&self, scene: &Scene, content: &Self::Content) -> Vec<Phase> {
        let _ = (scene, content);
        Vec::new()
    }

    /// Times the parts of [`solve`](Task::solve) that ask predicates, one after the other, on all threads of the current pool. A session that
    /// solving adds vertices to is a new one.
    fn asking<P: Predicates>(&self, session: &mut P, content: &Self::Content) -> Vec<Phase> {
        let _ = (session, content);
        Vec::new()
    }

    /// The scenes on which `compare` holds backends against each other and from which `stress` begins, at most one of each
    /// [kind](crate::Kind); none where the task takes no part.
    fn compared(&self) -> &'static [Compared] {
        &[]
    }

    /// How far `stress` can turn a knob until its scenes are no scenes of the task any more.
    fn turns(&self, knob: Knob) -> Turns {
        let _ = knob;
        Turns::Nowhere("the task does not say how far")
    }

    /// The checks that its judge can report, each with its meaning: a finding that none of these has is a mistake. Without any
    /// nothing is declared.
    fn checks(&self) -> &'static [Check] {
        &[]
    }

    /// Its answers with faults planted in them, each of which its judge has to find.
    fn spoiled(&self) -> Vec<Spoiled<Self>> {
        Vec::new()
    }

    /// The tables that judging adds rows to, besides those of every run.
    fn tables(&self) -> Vec<TableSpec> {
        Vec::new()
    }

    /// Its section of a report.
    ///
    /// # Errors
    /// Where a table of a run cannot be read.
    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        let _ = runs;
        Ok(None)
    }
}

/// The truth about one query and each backend's answer to it, for `replay`.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Explanation {
    /// The vertices that it is about, for their coordinates.
    pub vertices: Vec<Vertex>,
    /// What is true, in lines.
    pub truth: Vec<String>,
    /// The heads of the columns after the backend's name; none where one needs no head.
    pub heads: Vec<String>,
    /// For each backend its name and its cells.
    pub rows: Vec<(String, Vec<String>)>,
    /// For each backend its name and its signs of all permutations of the vertices, in lexicographic order, each sign turned where the
    /// permutation is odd: one who contradicts nothing has one sign. The exact signs come first.
    pub permutations: Vec<(String, Vec<Sign>)>,
}

impl Explanation {
    /// One cell for each backend: what it answers, or why it declines.
    #[must_use]
    pub fn with_answers<E: std::fmt::Display>(
        mut self,
        backends: &[&dyn Contestant],
        ask: impl Fn(&dyn Contestant) -> Result<String, E>,
    ) -> Explanation {
        let row =
            |&backend: &&dyn Contestant| (backend.name(), vec![ask(backend).unwrap_or_else(|why| why.to_string())]);
        self.rows = backends.iter().map(row).collect();
        self
    }
}
