//! Lists of tasks: the tasks of signs, which every tool has, and lists of tasks of other crates.

use std::sync::{Arc, Mutex, PoisonError};

use predicament_corpus::{SceneFormat, Vocabulary};
use predicament_predicates::{Backend, Derived, PredicateKind};

use crate::signs::Signs;
use crate::{AnyTask, OnTask, Solver, Task};

/// The tasks that ask for single signs, in the order of reports and messages: the five predicates, then those from
/// formulas.
///
/// A task lives as long as the program, and each predicate has one.
fn sign_tasks() -> Vec<&'static Signs> {
    static KNOWN: Mutex<Vec<&'static Signs>> = Mutex::new(Vec::new());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let derived = Derived::all().into_iter().map(PredicateKind::Derived);
    for kind in PredicateKind::ALL.into_iter().chain(derived) {
        if known.iter().all(|task| task.kind() != kind) {
            known.push(Box::leak(Box::new(Signs::of(kind))));
        }
    }
    known.clone()
}

/// The tasks of signs, then the tasks of this list: all tasks of a tool with the list.
#[must_use]
pub fn with_signs(tasks: &impl TaskList) -> Vec<&'static dyn AnyTask> {
    sign_tasks().into_iter().map(|task| task as &'static dyn AnyTask).chain(tasks.tasks()).collect()
}

/// A backend as a solver of the tasks of signs and of these tasks.
pub(crate) fn solvers<B: Backend + 'static>(backend: &Arc<B>, tasks: &impl TaskList) -> Vec<Box<dyn Solver>> {
    let signs = sign_tasks().into_iter().map(|task| Box::new(OnTask::new(backend, *task)) as Box<dyn Solver>);
    signs.chain(tasks.solvers(backend)).collect()
}

/// The vocabulary of tasks, for reading suites.
#[must_use]
pub fn vocabulary(tasks: &[&'static dyn AnyTask]) -> Vocabulary {
    Vocabulary::new(tasks.iter().map(|&task| task as &'static dyn SceneFormat).collect())
}

/// A list of tasks: `()`, or a task and the list before it.
pub trait TaskList: Clone + Send + Sync + 'static {
    /// The tasks; they live as long as the program.
    fn tasks(&self) -> Vec<&'static dyn AnyTask>;

    /// A backend as a solver of each task.
    fn solvers<B: Backend + 'static>(&self, backend: &Arc<B>) -> Vec<Box<dyn Solver>>;
}

impl TaskList for () {
    fn tasks(&self) -> Vec<&'static dyn AnyTask> {
        Vec::new()
    }

    fn solvers<B: Backend + 'static>(&self, _: &Arc<B>) -> Vec<Box<dyn Solver>> {
        Vec::new()
    }
}

impl<T: Task + Clone, Rest: TaskList> TaskList for (T, Rest) {
    fn tasks(&self) -> Vec<&'static dyn AnyTask> {
        // A task lives as long as the program.
        let task: &'static T = Box::leak(Box::new(self.0.clone()));
        let mut tasks = self.1.tasks();
        tasks.push(task);
        tasks
    }

    fn solvers<B: Backend + 'static>(&self, backend: &Arc<B>) -> Vec<Box<dyn Solver>> {
        let mut solvers = self.1.solvers(backend);
        solvers.push(Box::new(OnTask::new(backend, self.0.clone())));
        solvers
    }
}
