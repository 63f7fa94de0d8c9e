//! Faults planted in the algorithms of tasks, for `selftest`.
//!
//! A backend with a fault answers questions wrongly; here the questions are
//! answered well and the algorithm that asks them is wrong. A task whose algorithm
//! is tested this way lists its faults in [`Task::planted`]; the faults themselves
//! are types of the crate `algorithms`.

use std::any::Any;

use predicament_algorithms::planted::Fault;
use predicament_corpus::Content;
use predicament_predicates::Predicates;

use crate::{Class, Halt, Task};

/// A class of answers and the check that finds them.
pub type Catch = (Class, &'static str);

/// How a scene of a task is answered wrongly: a backend can refuse to construct what comes up.
pub type Solve<T> = fn(&mut dyn Predicates, &<T as Task>::Content) -> Result<<T as Task>::Answer, Halt>;

/// The algorithm of a task with a fault planted in it.
pub struct Planted<T: Task> {
    /// The name of the fault.
    pub name: &'static str,
    /// What is wrong, in one line.
    pub what: &'static str,
    /// The backend on which the fault shows: one of those that `selftest` takes for honest,
    /// `exact`, `sos`, `sos:edelsbrunner-mucke`, `sos:per-mesh` and `tolerance`.
    pub backend: &'static str,
    /// The checks that have to find it.
    pub caught_by: &'static [Catch],
    /// Answers a scene wrongly.
    pub solve: Solve<T>,
}

impl<T: Task> Planted<T> {
    /// The fault `F` on a backend, caught by these checks.
    #[must_use]
    pub fn new<F: Fault>(backend: &'static str, caught_by: &'static [Catch], solve: Solve<T>) -> Planted<T> {
        Planted { name: F::NAME, what: F::WHAT, backend, caught_by, solve }
    }
}

/// A [`Planted`] whose types are hidden.
pub trait AnyPlanted {
    /// The name of the fault.
    fn name(&self) -> &'static str;

    /// What is wrong, in one line.
    fn what(&self) -> &'static str;

    /// The backend on which the fault shows.
    fn backend(&self) -> &'static str;

    /// The checks that have to find it.
    fn caught_by(&self) -> &'static [Catch];

    /// Answers a scene of the task wrongly.
    ///
    /// # Errors
    /// [`Halt`] where the backend does not construct what comes up.
    fn solve(&self, session: &mut dyn Predicates, content: &dyn Content) -> Result<Box<dyn Any>, Halt>;
}

impl<T: Task> AnyPlanted for Planted<T> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn what(&self) -> &'static str {
        self.what
    }

    fn backend(&self) -> &'static str {
        self.backend
    }

    fn caught_by(&self) -> &'static [Catch] {
        self.caught_by
    }

    fn solve(&self, session: &mut dyn Predicates, content: &dyn Content) -> Result<Box<dyn Any>, Halt> {
        let content: &dyn Any = content;
        let content: &T::Content = content.downcast_ref().expect("the content of a scene of this task");
        Ok(Box::new((self.solve)(session, content)?))
    }
}
