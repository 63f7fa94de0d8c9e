//! Backends selected by name at run time.

use std::any::Any;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use predicament_corpus::Content;
use predicament_judge::TieJudge;
use predicament_predicates::{
    Backend, Batches, Contract, Counts, Declined, Off, PredicateKind, Predicates, Question, Scene, Sign, Vertex,
};

use crate::list::solvers;
use crate::{AnswerError, How, Purpose, Solver, Task, TaskList, Watch};

/// A backend that the command line can select.
pub trait Contestant: Send + Sync {
    /// The full name, with parameters.
    fn name(&self) -> String;

    /// The backend's contract for a predicate.
    fn contract(&self, kind: PredicateKind) -> Contract;

    /// The names of its stages, cheapest first.
    fn stages(&self) -> &'static [&'static str];

    /// The backend's own batch support for this predicate.
    fn batches(&self, kind: PredicateKind) -> Batches;

    /// The version of the library behind it, if it is an external library.
    fn version(&self) -> Option<String>;

    /// The same backend with predicates that return at once, if calls to it have a cost; it measures that cost.
    fn binding(&self) -> Option<Box<dyn Contestant>>;

    /// Prepares a scene and passes the session to `ask`, for queries that need not be fast.
    ///
    /// # Errors
    /// [`Declined`]; then `ask` is not called.
    fn with_session(&self, scene: &Scene, ask: &mut dyn FnMut(&mut dyn Predicates)) -> Result<(), Declined>;

    /// Prepares a scene like `with_session`, and counts the stages that settle queries.
    ///
    /// # Errors
    /// [`Declined`]; then `ask` is not called.
    fn with_counted_session(
        &self,
        scene: &Scene,
        counts: &Counts,
        ask: &mut dyn FnMut(&mut dyn Predicates),
    ) -> Result<(), Declined>;

    /// The independent judge of its tie-breaking, if it breaks ties.
    fn tie_judge(&self) -> Option<&TieJudge>;

    /// The backend as a solver of the task with this name.
    fn solver(&self, task: &str) -> Option<&dyn Solver>;
}

impl dyn Contestant + '_ {
    /// The answer to a scene of a task.
    ///
    /// # Errors
    /// [`AnswerError`] if the backend declines or does not know the task.
    pub fn answer<T: Task>(&self, task: &T, scene: &Scene, content: &T::Content) -> Result<T::Answer, AnswerError> {
        let mut found = None;
        self.answer_any(task.name(), scene, content, Purpose::Use, &mut |answer| {
            found = answer.downcast_ref::<T::Answer>().cloned()
        })?;
        found.ok_or_else(|| AnswerError::TwoTasks { task: task.name() })
    }

    /// Passes the answer to a scene of the task with this name, of the task's type, to `then`.
    ///
    /// # Errors
    /// [`AnswerError`] if the backend declines or does not know the task.
    pub fn answer_any(
        &self,
        task: &str,
        scene: &Scene,
        content: &dyn Content,
        purpose: Purpose,
        then: &mut dyn FnMut(&dyn Any),
    ) -> Result<(), AnswerError> {
        let solver = self
            .solver(task)
            .ok_or_else(|| AnswerError::UnknownTask { backend: self.name(), task: task.to_owned() })?;
        let (never, quiet) = (AtomicBool::new(false), |_: u64| {});
        let watch = Watch::new(&never, None, &quiet);
        let how = How { purpose, watch: &watch };
        let solved = solver.solve(scene, content, &Counts::new(), &how, &mut |_, answer| {
            then(answer);
            Ok(())
        });
        Ok(solved?)
    }

    /// Evaluates one query alone in a scene; returns the sign, and the stage that settled it.
    ///
    /// # Errors
    /// [`Declined`].
    pub fn ask(
        &self,
        scene: &Scene,
        question: Question,
        args: &[Vertex],
    ) -> Result<(Sign, Option<&'static str>), Declined> {
        let counts = Counts::new();
        let mut asked = Err(Declined::scene("the backend asked for no session"));
        self.with_counted_session(scene, &counts, &mut |session| {
            asked = session.supports(question.kind()).map(|()| question.ask(session, args));
        })?;
        Ok((asked?, stage(self.stages(), &counts, question.kind())))
    }
}

/// The first stage that has settled a query of this kind.
pub(crate) fn stage(stages: &[&'static str], counts: &Counts, kind: PredicateKind) -> Option<&'static str> {
    stages.iter().enumerate().find(|&(stage, _)| counts.get(kind, stage) > 0).map(|(_, &name)| name)
}

/// A backend with the data that judging needs, on the tasks of signs and those of a list.
pub struct Entry<B, L = ()> {
    backend: Arc<B>,
    tie_judge: Option<Box<TieJudge>>,
    tasks: L,
    solvers: Vec<Box<dyn Solver>>,
}

impl<B: Backend + 'static> Entry<B> {
    /// A backend without tie-breaking.
    pub fn new(backend: B) -> Entry<B> {
        Entry::shared(Arc::new(backend), None, ())
    }

    /// A backend that breaks ties, with an independent judge of its tie-breaking.
    pub fn breaking_ties(
        backend: B,
        judge: impl Fn(&Scene, Question, &[Vertex]) -> Sign + Send + Sync + 'static,
    ) -> Entry<B> {
        Entry::shared(Arc::new(backend), Some(Box::new(judge)), ())
    }
}

impl<B: Backend + 'static, L: TaskList> Entry<B, L> {
    /// A shared backend on the tasks of signs and these tasks, with a judge of its tie-breaking, if it breaks ties.
    pub fn shared(backend: Arc<B>, tie_judge: Option<Box<TieJudge>>, tasks: L) -> Entry<B, L> {
        Entry { solvers: solvers(&backend, &tasks), backend, tie_judge, tasks }
    }

    /// The backend with solvers of its own for some tasks, in place of algorithms that query its predicates.
    #[must_use]
    pub fn with_solvers(mut self, mut own: Vec<Box<dyn Solver>>) -> Entry<B, L> {
        // The first solver of a task counts.
        own.append(&mut self.solvers);
        self.solvers = own;
        self
    }
}

impl<B: Backend + 'static, L: TaskList> Contestant for Entry<B, L> {
    fn name(&self) -> String {
        self.backend.name()
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        self.backend.contract(kind)
    }

    fn stages(&self) -> &'static [&'static str] {
        self.backend.stages()
    }

    fn batches(&self, kind: PredicateKind) -> Batches {
        self.backend.batches(kind)
    }

    fn version(&self) -> Option<String> {
        self.backend.version()
    }

    fn binding(&self) -> Option<Box<dyn Contestant>> {
        let binding = Arc::new(self.backend.binding()?);
        Some(Box::new(Entry::shared(binding, None, self.tasks.clone())))
    }

    fn with_session(&self, scene: &Scene, ask: &mut dyn FnMut(&mut dyn Predicates)) -> Result<(), Declined> {
        let mut session = self.backend.prepare(scene, Off)?;
        ask(&mut session);
        Ok(())
    }

    fn with_counted_session(
        &self,
        scene: &Scene,
        counts: &Counts,
        ask: &mut dyn FnMut(&mut dyn Predicates),
    ) -> Result<(), Declined> {
        let mut session = self.backend.prepare(scene, counts)?;
        ask(&mut session);
        Ok(())
    }

    fn tie_judge(&self) -> Option<&TieJudge> {
        self.tie_judge.as_deref()
    }

    fn solver(&self, task: &str) -> Option<&dyn Solver> {
        self.solvers.iter().map(AsRef::as_ref).find(|solver| solver.task().name() == task)
    }
}
