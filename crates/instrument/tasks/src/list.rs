//! Tasks that come together: the signs, which every tool has, and lists of tasks of other crates.

use std::sync::Arc;

use predicament_corpus::{SceneFormat, Vocabulary};
use predicament_predicates::Backend;

use crate::signs::Signs;
use crate::{AnyTask, OnTask, Solver, Task};

/// The tasks that ask for single signs, in the order of reports and messages.
const SIGNS: [&Signs; 5] = [&Signs::COMPARE, &Signs::ORIENT2D, &Signs::ORIENT3D, &Signs::INCIRCLE, &Signs::INSPHERE];

/// The tasks of this list behind those that ask for single signs: what a tool with the list can be asked.
#[must_use]
pub fn with_signs(tasks: &impl TaskList) -> Vec<&'static dyn AnyTask> {
    SIGNS.into_iter().map(|task| task as &'static dyn AnyTask).chain(tasks.tasks()).collect()
}

/// A backend on each of these tasks, and on those that ask for single signs.
pub(crate) fn solvers<B: Backend + 'static>(backend: &Arc<B>, tasks: &impl TaskList) -> Vec<Box<dyn Solver>> {
    let signs = SIGNS.into_iter().map(|task| Box::new(OnTask::new(backend, *task)) as Box<dyn Solver>);
    signs.chain(tasks.solvers(backend)).collect()
}

/// The vocabulary of tasks, for reading suites.
#[must_use]
pub fn vocabulary(tasks: &[&'static dyn AnyTask]) -> Vocabulary {
    Vocabulary::new(tasks.iter().map(|&task| task as &'static dyn SceneFormat).collect())
}

/// A list of tasks: `()`, or a task behind those of a list.
pub trait TaskList: Clone + Send + Sync + 'static {
    /// The tasks, which live as long as the program.
    fn tasks(&self) -> Vec<&'static dyn AnyTask>;

    /// A backend on each of them.
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
        // A task lives as long as the program that it is part of.
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
