//! Faults planted in the algorithms of tasks, for `selftest`.
//!
//! A backend with a fault answers questions wrongly; here the questions are
//! answered well and the algorithm that asks them is wrong. A task whose algorithm
//! is tested this way lists its faults in [`Task::planted`]; the faults themselves
//! are types of the crate `algorithms`.

use std::any::Any;

use predicament_algorithms::planted::Fault;
use predicament_corpus::Content;
use predicament_predicates::{Predicates, Scene};

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

/// The right answer of a task with a fault planted in it: what is wrong is what is handed over.
///
/// A judge has checks that no fault of one place in the algorithm reaches, since others stand before them.
pub struct Spoiled<T: Task> {
    /// The name of the fault.
    pub name: &'static str,
    /// What is wrong, in one line.
    pub what: &'static str,
    /// The backend that gives the right answer: see [`Planted::backend`].
    pub backend: &'static str,
    /// The checks that have to find it.
    pub caught_by: &'static [Catch],
    /// Spoils an answer.
    pub spoil: Spoil<T>,
}

impl<T: Task> Spoiled<T> {
    /// A fault with this name: what is wrong, on a backend, caught by these checks.
    #[must_use]
    pub fn new(
        name: &'static str,
        what: &'static str,
        backend: &'static str,
        caught_by: &'static [Catch],
        spoil: Spoil<T>,
    ) -> Spoiled<T> {
        Spoiled { name, what, backend, caught_by, spoil }
    }
}

/// How an answer to a scene is spoiled.
pub type Spoil<T> = fn(&Scene, &<T as Task>::Content, &mut <T as Task>::Answer);

/// A [`Planted`] or [`Spoiled`] whose types are hidden.
pub trait AnyPlanted {
    /// The name of the fault.
    fn name(&self) -> &'static str;

    /// What is wrong, in one line.
    fn what(&self) -> &'static str;

    /// The backend on which the fault shows.
    fn backend(&self) -> &'static str;

    /// The checks that have to find it.
    fn caught_by(&self) -> &'static [Catch];

    /// Whether a right answer is spoiled; else the algorithm is wrong.
    fn spoils(&self) -> bool;

    /// Answers a scene of the task wrongly; none where it is the answer that is spoiled.
    ///
    /// # Errors
    /// [`Halt`] where the backend does not construct what comes up.
    fn solve(&self, session: &mut dyn Predicates, content: &dyn Content) -> Option<Result<Box<dyn Any>, Halt>>;

    /// A right answer once it is spoiled; none where it is the algorithm that is wrong.
    fn spoil(&self, scene: &Scene, content: &dyn Content, answer: &dyn Any) -> Option<Box<dyn Any>>;
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

    fn spoils(&self) -> bool {
        false
    }

    fn solve(&self, session: &mut dyn Predicates, content: &dyn Content) -> Option<Result<Box<dyn Any>, Halt>> {
        let answer = (self.solve)(session, typed::<T>(content));
        Some(answer.map(|answer| Box::new(answer) as Box<dyn Any>))
    }

    fn spoil(&self, _: &Scene, _: &dyn Content, _: &dyn Any) -> Option<Box<dyn Any>> {
        None
    }
}

impl<T: Task> AnyPlanted for Spoiled<T> {
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

    fn spoils(&self) -> bool {
        true
    }

    fn solve(&self, _: &mut dyn Predicates, _: &dyn Content) -> Option<Result<Box<dyn Any>, Halt>> {
        None
    }

    fn spoil(&self, scene: &Scene, content: &dyn Content, answer: &dyn Any) -> Option<Box<dyn Any>> {
        let mut answer: T::Answer = answer.downcast_ref::<T::Answer>().expect("an answer of this task").clone();
        (self.spoil)(scene, typed::<T>(content), &mut answer);
        Some(Box::new(answer))
    }
}

fn typed<T: Task>(content: &dyn Content) -> &T::Content {
    let content: &dyn Any = content;
    content.downcast_ref().expect("the content of a scene of this task")
}
