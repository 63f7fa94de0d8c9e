//! Right answers with planted faults, for `selftest`.
//!
//! A faulty backend gives wrong signs. Here an honest backend answers, and the answer is damaged afterwards. Each check
//! of a judge that no backend's fault needs has such an answer: a task lists them in [`Task::spoiled`]. `cargo xtask
//! mutants --planted` tests that scenes lead an algorithm to the places where it can go wrong.

use std::any::Any;

use predicament_corpus::Content;
use predicament_predicates::Scene;

use crate::{Class, Task};

/// A class of findings, and the check that reports them.
pub type Catch = (Class, &'static str);

/// The right answer of a task with a fault planted in it.
pub struct Spoiled<T: Task> {
    /// The name of the fault.
    pub name: &'static str,
    /// The fault, in one line.
    pub what: &'static str,
    /// The backend that gives the right answer: one of those that `selftest` takes for honest, `exact`, `sos`,
    /// `sos:edelsbrunner-mucke`, `sos:per-mesh` and `tolerance`.
    pub backend: &'static str,
    /// The checks that must find it.
    pub caught_by: &'static [Catch],
    /// The function that damages an answer.
    pub spoil: Spoil<T>,
}

impl<T: Task> Spoiled<T> {
    /// A fault with a name, a description, a backend and the checks that must find it.
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

/// A function that damages an answer to a scene.
pub type Spoil<T> = fn(&Scene, &<T as Task>::Content, &mut <T as Task>::Answer);

/// A [`Spoiled`] with erased types.
pub trait AnySpoiled {
    /// The name of the fault.
    fn name(&self) -> &'static str;

    /// The fault, in one line.
    fn what(&self) -> &'static str;

    /// The backend that gives the right answer.
    fn backend(&self) -> &'static str;

    /// The checks that must find it.
    fn caught_by(&self) -> &'static [Catch];

    /// Returns the damaged copy of a right answer.
    fn spoil(&self, scene: &Scene, content: &dyn Content, answer: &dyn Any) -> Box<dyn Any>;
}

impl<T: Task> AnySpoiled for Spoiled<T> {
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

    fn spoil(&self, scene: &Scene, content: &dyn Content, answer: &dyn Any) -> Box<dyn Any> {
        let content: &dyn Any = content;
        let content: &T::Content = content.downcast_ref().expect("the content of a scene of this task");
        let mut answer: T::Answer = answer.downcast_ref::<T::Answer>().expect("an answer of this task").clone();
        (self.spoil)(scene, content, &mut answer);
        Box::new(answer)
    }
}
