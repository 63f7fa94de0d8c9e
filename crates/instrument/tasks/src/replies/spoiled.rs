//! Right answers of programs with planted faults.

use std::any::Any;

use predicament_corpus::Content;
use predicament_predicates::Scene;

use super::{Arrays, Replies, Reply};
use crate::Task;
use crate::spoiled::{AnySpoiled, Catch};

/// A program's answer with a fault planted in it.
pub struct SpoiledReply<T: Task> {
    /// The name of the fault.
    pub name: &'static str,
    /// The fault, in one line.
    pub what: &'static str,
    /// The backend that gives the right answer, as in [`Spoiled`](crate::Spoiled).
    pub backend: &'static str,
    /// The checks that must find it.
    pub caught_by: &'static [Catch],
    /// The function that damages an answer.
    pub spoil: fn(&Scene, &T::Content, &mut Arrays),
}

/// A [`SpoiledReply`] with the judge that makes replies of answers.
pub(crate) struct Planted<T: Task> {
    pub spoiled: SpoiledReply<T>,
    pub judge: &'static dyn Replies<T>,
}

impl<T: Task> AnySpoiled for Planted<T> {
    fn name(&self) -> &'static str {
        self.spoiled.name
    }

    fn what(&self) -> &'static str {
        self.spoiled.what
    }

    fn backend(&self) -> &'static str {
        self.spoiled.backend
    }

    fn caught_by(&self) -> &'static [Catch] {
        self.spoiled.caught_by
    }

    fn spoil(&self, scene: &Scene, content: &dyn Content, answer: &dyn Any) -> Box<dyn Any> {
        let content: &dyn Any = content;
        let content: &T::Content = content.downcast_ref().expect("the content of a scene of this task");
        let answer = answer.downcast_ref::<T::Answer>().expect("an answer of this task");
        let mut arrays = self.judge.reply_of(scene, content, answer);
        (self.spoiled.spoil)(scene, content, &mut arrays);
        Box::new(Reply { arrays, ..Reply::default() })
    }
}
