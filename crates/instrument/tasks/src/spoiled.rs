//! Right answers with faults planted in them, for `selftest`.
//!
//! A backend with a fault answers questions wrongly; here the questions are answered well, by an honest backend, and what is
//! handed over is wrong. Each check of a judge that no backend's fault needs has such an answer: a task lists them in
//! [`Task::spoiled`]. That scenes lead an algorithm to the places where it can go wrong is for `cargo xtask mutants --planted`.

use std::any::Any;

use predicament_corpus::Content;
use predicament_predicates::Scene;

use crate::{Class, Task};

/// A class of answers and the check that finds them.
pub type Catch = (Class, &'static str);

/// The right answer of a task with a fault planted in it.
pub struct Spoiled<T: Task> {
    /// The name of the fault.
    pub name: &'static str,
    /// What is wrong, in one line.
    pub what: &'static str,
    /// The backend that gives the right answer: one of those that `selftest` takes for honest,
    /// `exact`, `sos`, `sos:edelsbrunner-mucke`, `sos:per-mesh` and `tolerance`.
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

/// A [`Spoiled`] whose types are hidden.
pub trait AnySpoiled {
    /// The name of the fault.
    fn name(&self) -> &'static str;

    /// What is wrong, in one line.
    fn what(&self) -> &'static str;

    /// The backend that gives the right answer.
    fn backend(&self) -> &'static str;

    /// The checks that have to find it.
    fn caught_by(&self) -> &'static [Catch];

    /// A right answer once it is spoiled.
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
