//! Tasks with erased types, for crates that treat all tasks alike.

use std::any::Any;
use std::collections::BTreeMap;
use std::path::Path;

use predicament_corpus::{Content, LoadedScene, SceneFormat};
use predicament_predicates::{Declined, PredicateKind, Query, Scene};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;

use crate::decimals;
use crate::output::{self, Canvas, Choice, Written};
use crate::replies::{self, Arrays, Example, FORM_CHECK, Part, Planted, Reply};
use crate::{
    Agreement, Answer, AnySpoiled, Asked, Case, Check, Compared, Contestant, Dispute, ExplainError, Explanation, Knob,
    Outcome, Phase, Stop, Task, Turns, Watch,
};

/// A [`Task`] with erased types. Every task implements it.
pub trait AnyTask: SceneFormat {
    /// Calls [`Task::asks`].
    fn kinds(&self, scene: &Scene) -> Vec<PredicateKind>;

    /// Calls [`Task::looks_at_watch`].
    fn looks_at_the_watch(&self) -> bool;

    /// A loaded scene of this task with the truth about it.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    fn case<'a>(&'a self, loaded: &'a LoadedScene, watch: &Watch) -> Result<Box<dyn AnyCase + 'a>, Stop>;

    /// Calls [`Task::describe`].
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    fn describe_scene(&self, loaded: &LoadedScene, watch: &Watch) -> Result<String, Stop>;

    /// Calls [`Task::explain`].
    ///
    /// # Errors
    /// [`ExplainError`] if the query does not belong to this task or scene.
    fn explain_query(
        &self,
        loaded: &LoadedScene,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError>;

    /// Writes the chosen files of [`Task::write`] into a folder, as [`output::write`].
    ///
    /// # Errors
    /// [`output::Error`].
    fn write_answer(
        &self,
        loaded: &LoadedScene,
        answer: &dyn Any,
        folder: &Path,
        choice: &Choice,
    ) -> Result<Written, output::Error>;

    /// Calls [`Task::draw`], with an answer of the task's type.
    ///
    /// # Errors
    /// If a vertex of the answer is not a point.
    fn draw_scene(&self, loaded: &LoadedScene, answer: Option<&dyn Any>, canvas: &mut Canvas) -> std::io::Result<()>;

    /// Calls [`Answer::digest`] of an answer of the task's type, or of a program's answer.
    fn digest_of(&self, answer: &dyn Any) -> u64;

    /// Calls [`Task::size`].
    fn size_of(&self, loaded: &LoadedScene) -> usize;

    /// Calls [`Task::size`] with the content of a scene of the task.
    fn size_of_content(&self, content: &dyn Content) -> usize;

    /// Calls [`Task::memory`].
    fn memory_of(&self, loaded: &LoadedScene) -> Option<u64>;

    /// Calls [`Task::scaled`].
    fn scaled_on(&self) -> Option<Compared>;

    /// Calls [`Task::takes_threads`].
    fn is_threaded(&self) -> bool;

    /// Calls [`Task::primitives`].
    fn primitives_of(&self, loaded: &LoadedScene) -> Option<u64>;

    /// Calls [`Task::timed`].
    ///
    /// # Errors
    /// If a table of the run cannot be read.
    fn timed_in(
        &self,
        run: &RunDir,
        primitives: &BTreeMap<String, u64>,
        threads: &[usize],
    ) -> Result<String, predicament_records::Error>;

    /// Calls [`Task::building`].
    fn building_phases(&self, loaded: &LoadedScene) -> Vec<Phase>;

    /// Calls [`Task::constructs`].
    fn constructs_vertices(&self) -> bool;
    /// Calls [`Task::judges_whole`].
    fn is_judged_whole(&self) -> bool;
    /// Calls [`Task::has_two_meshes`].
    fn is_on_two_meshes(&self) -> bool;

    /// Calls [`Task::compared`].
    fn compared_on(&self) -> &'static [Compared];

    /// Calls [`Task::turns`].
    fn turned_by(&self, knob: Knob) -> Turns;

    /// The checks of [`Task::checks`], and those of the judge of replies.
    fn declared_checks(&self) -> Vec<Check>;

    /// Calls [`Task::spoiled`].
    fn spoiled_answers(&self) -> Vec<Box<dyn AnySpoiled>>;

    /// The start of an engine that answers the task. `None` if the task is not open to other programs.
    fn example_engine(&self) -> Option<Example>;

    /// The parts of another program's answer; `None` if the task is not open to other programs.
    fn parts_of_replies(&self) -> Option<&'static [Part]>;

    /// A scene of the task as other programs get it.
    ///
    /// # Errors
    /// [`Declined`] with the reason if it cannot be put to other programs.
    fn question(&self, scene: &Scene, content: &dyn Content) -> Result<Arrays, Declined>;

    /// A backend's answer in the form of a program's answer: see
    /// [`Replies::reply_of`](crate::replies::Replies::reply_of). `None` if the task is not open to other programs.
    fn as_reply(&self, scene: &Scene, content: &dyn Content, answer: &dyn Any) -> Option<Arrays>;

    /// Calls [`Task::tables`].
    fn own_tables(&self) -> Vec<TableSpec>;

    /// Calls [`Task::section`].
    ///
    /// # Errors
    /// If a table of a run cannot be read.
    fn own_section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error>;
}

impl std::fmt::Debug for dyn AnyTask {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// Tasks are equal if their names are equal.
impl PartialEq for dyn AnyTask {
    fn eq(&self, other: &dyn AnyTask) -> bool {
        self.name() == other.name()
    }
}

/// A [`Case`] with erased types.
pub trait AnyCase: Send + Sync {
    /// The scene.
    fn loaded(&self) -> &LoadedScene;

    /// The scene's task.
    fn task(&self) -> &dyn AnyTask;

    /// Calls [`Task::sampled`].
    fn sampled(&self) -> Option<String>;

    /// The result of [`Task::dispute`], or [`Dispute::Valid`] if the scene is marked as invalid input and is not. A
    /// mark that the judge confirms is no dispute: see [`AnyCase::invalid`].
    fn dispute(&self) -> Option<Dispute>;

    /// The reason why the scene is invalid input of its task, if it is marked as such and the judge confirms it.
    /// Only programs get such a scene: they should refuse it.
    fn invalid(&self) -> Option<String>;

    /// Calls [`Task::judge`], with an answer of the task's type.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the judge.
    fn judge(&self, asked: &Asked<'_>, answer: &dyn Any, outcome: &mut Outcome) -> Result<(), Stop>;

    /// The truth, a [`Task::Truth`].
    fn truth(&self) -> &dyn Any;
}

fn content<'a, T: Task>(task: &T, loaded: &'a LoadedScene) -> &'a T::Content {
    loaded.content().unwrap_or_else(|| panic!("{}/{} is not a scene of {}", loaded.suite, loaded.name, task.name()))
}

fn typed_content<T: Task>(content: &dyn Content) -> &T::Content {
    let content: &dyn Any = content;
    content.downcast_ref().expect("the content of a scene of this task")
}

fn typed<T: Task>(answer: &dyn Any) -> &T::Answer {
    answer.downcast_ref().expect("an answer of the task that is asked")
}

impl<T: Task> AnyTask for T {
    fn kinds(&self, scene: &Scene) -> Vec<PredicateKind> {
        self.asks(scene)
    }

    fn looks_at_the_watch(&self) -> bool {
        self.looks_at_watch()
    }

    fn case<'a>(&'a self, loaded: &'a LoadedScene, watch: &Watch) -> Result<Box<dyn AnyCase + 'a>, Stop> {
        let content = content(self, loaded);
        let truth = self.truth(&loaded.scene, content, watch)?;
        let written = decimals::as_written(self, loaded, watch)?;
        Ok(Box::new(CaseOf { task: self, case: Case::new(loaded, content, truth), written }))
    }

    fn describe_scene(&self, loaded: &LoadedScene, watch: &Watch) -> Result<String, Stop> {
        self.describe(loaded, content(self, loaded), watch)
    }

    fn explain_query(
        &self,
        loaded: &LoadedScene,
        query: &Query,
        backends: &[&dyn Contestant],
    ) -> Result<Explanation, ExplainError> {
        let exists = |v| match predicament_predicates::Vertex::construction(v) {
            None => v.index() < loaded.scene.len(),
            Some(index) => index < loaded.scene.constructions().len(),
        };
        match query.vertices().find(|&v| !exists(v)) {
            Some(vertex) => Err(ExplainError::NoVertex { query: query.clone(), vertex }),
            None => self.explain(&loaded.scene, content(self, loaded), query, backends),
        }
    }

    fn write_answer(
        &self,
        loaded: &LoadedScene,
        answer: &dyn Any,
        folder: &Path,
        choice: &Choice,
    ) -> Result<Written, output::Error> {
        if let Some(reply) = answer.downcast_ref::<Reply>() {
            return output::write(folder, choice, |files| replies::write(self.replies(), reply, files));
        }
        let (content, answer) = (content(self, loaded), typed::<T>(answer));
        output::write(folder, choice, |files| self.write(&loaded.scene, content, answer, files))
    }

    fn draw_scene(&self, loaded: &LoadedScene, answer: Option<&dyn Any>, canvas: &mut Canvas) -> std::io::Result<()> {
        let content = content(self, loaded);
        if let Some(reply) = answer.and_then(<dyn Any>::downcast_ref::<Reply>) {
            self.draw(&loaded.scene, content, None, canvas)?;
            return replies::draw(self.replies(), &loaded.scene, reply, canvas);
        }
        self.draw(&loaded.scene, content, answer.map(typed::<T>), canvas)
    }

    fn digest_of(&self, answer: &dyn Any) -> u64 {
        answer.downcast_ref::<Reply>().map_or_else(|| typed::<T>(answer).digest(), Reply::digest)
    }

    fn size_of(&self, loaded: &LoadedScene) -> usize {
        self.size(content(self, loaded))
    }

    fn size_of_content(&self, content: &dyn Content) -> usize {
        self.size(typed_content::<T>(content))
    }

    fn memory_of(&self, loaded: &LoadedScene) -> Option<u64> {
        self.memory(&loaded.scene, content(self, loaded))
    }

    fn scaled_on(&self) -> Option<Compared> {
        self.scaled()
    }

    fn is_threaded(&self) -> bool {
        self.takes_threads()
    }

    fn primitives_of(&self, loaded: &LoadedScene) -> Option<u64> {
        self.primitives(&loaded.scene, content(self, loaded))
    }

    fn timed_in(
        &self,
        run: &RunDir,
        primitives: &BTreeMap<String, u64>,
        threads: &[usize],
    ) -> Result<String, predicament_records::Error> {
        self.timed(run, primitives, threads)
    }

    fn building_phases(&self, loaded: &LoadedScene) -> Vec<Phase> {
        self.building(&loaded.scene, content(self, loaded))
    }

    fn constructs_vertices(&self) -> bool {
        self.constructs()
    }

    fn is_judged_whole(&self) -> bool {
        self.judges_whole()
    }

    fn is_on_two_meshes(&self) -> bool {
        self.has_two_meshes()
    }

    fn compared_on(&self) -> &'static [Compared] {
        self.compared()
    }

    fn turned_by(&self, knob: Knob) -> Turns {
        self.turns(knob)
    }

    fn declared_checks(&self) -> Vec<Check> {
        let of_replies = self.replies().map(|judge| judge.checks().iter().copied().chain([FORM_CHECK]));
        self.checks().iter().copied().chain(of_replies.into_iter().flatten()).collect()
    }

    fn spoiled_answers(&self) -> Vec<Box<dyn AnySpoiled>> {
        let own = self.spoiled().into_iter().map(|spoiled| Box::new(spoiled) as Box<dyn AnySpoiled>);
        let of_replies = self.replies().into_iter().flat_map(|judge| {
            judge.spoiled().into_iter().map(move |spoiled| Box::new(Planted { spoiled, judge }) as Box<dyn AnySpoiled>)
        });
        own.chain(of_replies).collect()
    }

    fn parts_of_replies(&self) -> Option<&'static [Part]> {
        self.replies().map(|judge| judge.parts())
    }

    fn example_engine(&self) -> Option<Example> {
        self.replies().map(|judge| judge.example())
    }

    fn question(&self, scene: &Scene, content: &dyn Content) -> Result<Arrays, Declined> {
        let judge = self.replies().ok_or_else(|| Declined::scene(replies::not_open(self.name())))?;
        judge.open(scene, typed_content::<T>(content))?;
        let spelled = content.spelled(scene);
        let mut question =
            replies::question(&spelled.ok_or_else(|| Declined::scene("the scene has no written form"))?)?;
        judge.more(scene, typed_content::<T>(content), &mut question);
        Ok(question)
    }

    fn as_reply(&self, scene: &Scene, content: &dyn Content, answer: &dyn Any) -> Option<Arrays> {
        Some(self.replies()?.reply_of(scene, typed_content::<T>(content), typed::<T>(answer)))
    }

    fn own_tables(&self) -> Vec<TableSpec> {
        let of_replies = self.replies().map(|_| TableSpec::of::<replies::ReplyRow>());
        self.tables().into_iter().chain(of_replies).collect()
    }

    fn own_section(&self, runs: &[RunDir]) -> Result<Option<Section>, predicament_records::Error> {
        self.section(runs)
    }
}

struct CaseOf<'a, T: Task> {
    task: &'a T,
    case: Case<'a, T>,
    /// The same scene as it was written.
    written: Option<Case<'a, T>>,
}

impl<T: Task> AnyCase for CaseOf<'_, T> {
    fn loaded(&self) -> &LoadedScene {
        self.case.loaded
    }

    fn task(&self) -> &dyn AnyTask {
        self.task
    }

    fn sampled(&self) -> Option<String> {
        self.task.sampled(&self.case.truth)
    }

    fn dispute(&self) -> Option<Dispute> {
        match (self.case.loaded.is_invalid, self.task.dispute(&self.case)) {
            (true, Some(Dispute::Invalid { .. })) => None,
            (true, None) => Some(Dispute::Valid),
            (_, dispute) => dispute,
        }
    }

    fn invalid(&self) -> Option<String> {
        match self.task.dispute(&self.case) {
            Some(Dispute::Invalid { why, .. }) if self.case.loaded.is_invalid => Some(why),
            _ => None,
        }
    }

    fn judge(&self, asked: &Asked<'_>, answer: &dyn Any, outcome: &mut Outcome) -> Result<(), Stop> {
        if let Some(reply) = answer.downcast_ref::<Reply>() {
            outcome.digest = Some(reply.digest());
            let judge = self.task.replies().expect("only tasks with a judge of replies are put to programs");
            replies::judge(judge, &self.case, asked, reply, outcome)?;
            if let Some(written) = &self.written {
                let mut other = Outcome::default();
                let digits = self.case.loaded.written.as_ref().map_or(0, predicament_formats::Written::digits);
                replies::judge(judge, written, asked, &reply.scaled(judge.parts(), digits), &mut other)?;
                outcome.agreement = Some(Agreement::of_wholes(outcome, &other));
            }
            return Ok(());
        }
        let answer = typed::<T>(answer);
        outcome.digest = Some(answer.digest());
        outcome.sampled = self.sampled();
        self.task.judge(&self.case, asked, answer, outcome)?;
        if let Some(written) = &self.written {
            outcome.agreement = Some(self.task.agreement(&self.case, written, asked, answer, outcome)?);
        }
        Ok(())
    }

    fn truth(&self) -> &dyn Any {
        &self.case.truth
    }
}
