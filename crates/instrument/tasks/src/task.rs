//! The trait of a task.

use std::collections::BTreeMap;

use predicament_corpus::{Content, LoadedScene, SceneFormat};
use predicament_formats::Written;
use predicament_predicates::{Declined, PredicateKind, Predicates, Query, QuerySet, Scene, Sign, Vertex};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_report::drawing::Role;

use crate::decimals;
use crate::output::{self, Canvas, Files};
use crate::replies::Replies;
use crate::{
    Agreement, Asked, Case, Check, Compared, Contestant, Dispute, ExplainError, Halt, How, Knob, Outcome, Phase,
    Spoiled, Stop, Turns, Watch,
};

/// An answer to everything that a scene asks. Timed passes reuse it, so that they do not time memory allocation.
pub trait Answer: Default + Clone + Send + Sync + 'static {
    /// A digest of everything that is judged: equal digests mean equal answers (with the usual odds for 64 bits).
    fn digest(&self) -> u64;
}

/// A task: keys, truth, solving, judging, explaining, output and report of one kind of question.
///
/// [`SceneFormat`] defines its scenes in suites; this trait defines the rest. A value is a task with its parameters
/// (`orient2d` and `orient3d` are values of one type), so every method takes `&self`.
pub trait Task: SceneFormat + Sized + 'static {
    /// The questions of a scene, besides its points.
    type Content: Content;
    /// The right answers, from the crate `judge` or another computation that shares nothing with
    /// [`solve`](Task::solve).
    type Truth: Send + Sync + 'static;
    /// The answers of a backend to one scene.
    type Answer: Answer;

    /// The predicates that the task uses: a session that refuses one of them declines the scene, and stages are counted
    /// for these.
    fn asks(&self, scene: &Scene) -> Vec<PredicateKind>;

    /// Checks that a session supports the task.
    ///
    /// # Errors
    /// [`Declined`] with the session's reason.
    fn supported(&self, session: &dyn Predicates) -> Result<(), Declined> {
        self.asks(session.scene()).into_iter().try_for_each(|kind| session.supports(kind))
    }

    /// True if solving adds vertices to the session: timed passes then begin with a fresh session.
    fn constructs(&self) -> bool {
        false
    }

    /// True if the answer to a scene is judged as a whole: one broken law makes it wrong. Otherwise each query has its
    /// own answer, with a class.
    fn judges_whole(&self) -> bool {
        false
    }

    /// True if the scenes of the task have two meshes, the second of which a perturbation can move as a whole.
    fn has_two_meshes(&self) -> bool {
        false
    }

    /// True if [`solve`](Task::solve) checks its watch often enough to be stopped by it. Otherwise it runs in a
    /// separate process under a time limit.
    fn looks_at_watch(&self) -> bool {
        false
    }

    /// Computes the truth about a scene, once for all backends.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    fn truth(&self, scene: &Scene, content: &Self::Content, watch: &Watch) -> Result<Self::Truth, Stop>;

    /// Computes the truth about the decimals that were written. By default it is the truth about `scene`, which is then
    /// the written scene times a power of ten.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    fn truth_as_written(
        &self,
        scene: &Scene,
        content: &Self::Content,
        written: &Written,
        watch: &Watch,
    ) -> Result<Self::Truth, Stop> {
        let _ = written;
        self.truth(scene, content, watch)
    }

    /// Compares an answer to the doubles of a case with the truth of decimals. `own` is its outcome about the doubles.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the judge.
    fn agreement(
        &self,
        case: &Case<'_, Self>,
        written: &Case<'_, Self>,
        asked: &Asked<'_>,
        answer: &Self::Answer,
        own: &Outcome,
    ) -> Result<Agreement, Stop> {
        let _ = case;
        decimals::by_judge(self, written, asked, answer, own)
    }

    /// The part of the scene that the truth covers, if not all, as text.
    fn sampled(&self, truth: &Self::Truth) -> Option<String> {
        let _ = truth;
        None
    }

    /// The reason why the scene is not judged: published answers that differ from the truth, or a content that is not
    /// one of the task although it was read, such as a polygon that crosses itself. All commands refuse such a scene
    /// with the same exit code, and hunts discard it.
    fn dispute(&self, case: &Case<'_, Self>) -> Option<Dispute> {
        let _ = case;
        None
    }

    /// Answers everything that the scene asks. `run`, `bench`, `replay` and pictures all use it. A task without special
    /// speed needs can query through `&dyn Predicates`.
    ///
    /// # Errors
    /// [`Halt`] if the watch stops the work, or the session refuses to construct a vertex.
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
    /// [`Stop`] if the watch stops the judge.
    fn judge(
        &self,
        case: &Case<'_, Self>,
        asked: &Asked<'_>,
        answer: &Self::Answer,
        outcome: &mut Outcome,
    ) -> Result<(), Stop>;

    /// Describes a scene in a few lines of text, for `corpus gen`.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    fn describe(&self, loaded: &LoadedScene, content: &Self::Content, watch: &Watch) -> Result<String, Stop>;

    /// Repeats one query of a finding alone, for `replay`.
    ///
    /// # Errors
    /// [`ExplainError`] if the query does not belong to this task or scene.
    fn explain(
        &self,
        scene: &Scene,
        content: &Self::Content,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError>;

    /// Offers the files of an answer for other programs. It is called twice, to list the files and to write those that
    /// the user wants: work for one file belongs into the closure that makes it.
    ///
    /// # Errors
    /// [`output::Error`] if a file cannot hold the answer, or the file system refuses.
    fn write(
        &self,
        scene: &Scene,
        content: &Self::Content,
        answer: &Self::Answer,
        files: &mut Files,
    ) -> Result<(), output::Error>;

    /// Draws a scene, and an answer to it if there is one; by default, only the points.
    ///
    /// # Errors
    /// If a vertex of the answer is not a point.
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

    /// The queries of a scene that only asks one predicate. They are timed one by one and in batches, in
    /// [orders](crate::Rounds) that a branch predictor cannot learn. For other scenes, whole answers are timed.
    fn queries<'c>(&self, content: &'c Self::Content) -> Option<&'c QuerySet> {
        let _ = content;
        None
    }

    /// The size of a scene, for the growth of times; by default the number of queries.
    fn size(&self, content: &Self::Content) -> usize {
        content.count()
    }

    /// The approximate memory for finding an answer and writing its files, in bytes; `None` if it is not known. `solve`
    /// refuses scenes for which the memory does not suffice.
    fn memory(&self, scene: &Scene, content: &Self::Content) -> Option<u64> {
        let _ = (scene, content);
        None
    }

    /// Scenes of any size whose answers grow like the scenes, for the study of scale; `None` if the task is not in it.
    fn scaled(&self) -> Option<Compared> {
        None
    }

    /// True if solving uses all threads of the current pool: benches time it on each requested number of threads.
    fn takes_threads(&self) -> bool {
        false
    }

    /// The number of primitives by which the tables of a bench divide the time of a scene; `None` if the task has no
    /// such tables.
    fn primitives(&self, scene: &Scene, content: &Self::Content) -> Option<u64> {
        let _ = (scene, content);
        None
    }

    /// The text of a bench folder about its scenes, as Markdown: `primitives` by the id of each scene that has some, on
    /// a number of threads.
    ///
    /// # Errors
    /// If a table of the run cannot be read.
    fn timed(
        &self,
        run: &RunDir,
        primitives: &BTreeMap<String, u64>,
        threads: &[usize],
    ) -> Result<String, predicament_records::Error> {
        let _ = (run, primitives, threads);
        Ok(String::new())
    }

    /// Times the parts of the algorithm that use no predicate, one after the other, on all threads of the current pool.
    /// `bench` reports them once for all backends.
    fn building(&self, scene: &Scene, content: &Self::Content) -> Vec<Phase> {
        let _ = (scene, content);
        Vec::new()
    }

    /// Times the parts of [`solve`](Task::solve) that use predicates, one after the other, on all threads of the
    /// current pool. If solving adds vertices to a session, the session is fresh.
    fn asking<P: Predicates>(&self, session: &mut P, content: &Self::Content) -> Vec<Phase> {
        let _ = (session, content);
        Vec::new()
    }

    /// The scenes on which `compare` compares backends and from which `stress` starts, at most one of each
    /// [kind](crate::Kind); empty if the task takes no part.
    fn compared(&self) -> &'static [Compared] {
        &[]
    }

    /// The positions of a knob at which `stress` keeps scenes of the task valid.
    fn turns(&self, knob: Knob) -> Turns {
        let _ = knob;
        Turns::Nowhere("the task does not declare a limit")
    }

    /// The checks that its judge can report, each with its meaning: a finding outside this list is a mistake. An empty
    /// list declares nothing.
    fn checks(&self) -> &'static [Check] {
        &[]
    }

    /// Answers with planted faults, each of which the judge must find.
    fn spoiled(&self) -> Vec<Spoiled<Self>> {
        Vec::new()
    }

    /// The judge of other programs' answers; `None` if the task is not open to other programs.
    fn replies(&self) -> Option<&'static dyn Replies<Self>> {
        None
    }

    /// The tables that judging adds rows to, besides those of every run.
    fn tables(&self) -> Vec<TableSpec> {
        Vec::new()
    }

    /// The task's section of a report.
    ///
    /// # Errors
    /// If a table of a run cannot be read.
    fn section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        let _ = runs;
        Ok(None)
    }
}

/// The truth about one query and each backend's answer to it, for `replay`.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Explanation {
    /// The vertices of the query, for their coordinates.
    pub vertices: Vec<Vertex>,
    /// The truth, as lines.
    pub truth: Vec<String>,
    /// The heads of the columns after the backend's name; empty if the single column needs no head.
    pub heads: Vec<String>,
    /// For each backend its name and its cells.
    pub rows: Vec<(String, Vec<String>)>,
    /// For each backend its name and its signs of all permutations of the vertices, in lexicographic order, negated for
    /// odd permutations: a consistent backend has equal signs. The exact signs come first.
    pub permutations: Vec<(String, Vec<Sign>)>,
}

impl Explanation {
    /// A table with one cell for each backend: its answer, or the reason why it declines.
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
