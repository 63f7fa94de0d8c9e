//! A program as a solver of a task: it gets the scene, and its answer goes to the task's judge of replies.

use std::sync::Arc;
use std::time::{Duration, Instant};

use predicament_corpus::Content;
use predicament_predicates::{Broken, Class, Counts, Declined, Dimension, Scene};
use predicament_records::Interface;

use super::unasked::Unasked;
use super::{ANSWER, Arrays, Reply};
use crate::solver::{Halt, How, Refusal, Solver, Stopwatch, Then};
use crate::{AnswerError, AnyTask, Phase};

/// Something that answers whole scenes of a task.
pub trait Program: Send + Sync {
    /// The answer to a scene of a task, or the reason for declining it.
    ///
    /// # Errors
    /// [`Broken`] if the program crashes, is silent, or breaks the protocol.
    fn answer(&self, task: &str, dimension: Dimension, question: &Arrays) -> Result<Result<Reply, Declined>, Broken>;
}

/// A program on a task, as a [`Solver`].
pub struct ByProgram {
    program: Arc<dyn Program>,
    task: &'static dyn AnyTask,
}

impl ByProgram {
    /// Combines a program and a task. The task must have a judge of replies.
    #[must_use]
    pub fn new(program: Arc<dyn Program>, task: &'static dyn AnyTask) -> ByProgram {
        ByProgram { program, task }
    }

    /// The scene as the program gets it.
    fn question(&self, scene: &Scene, content: &dyn Content) -> Result<Arrays, Refusal> {
        let question = self.task.question(scene, content);
        question.map_err(|why| Refusal { check: "prepare", why })
    }

    fn answer(&self, scene: &Scene, question: &Arrays) -> Result<Reply, Refusal> {
        match self.program.answer(self.task.name(), scene.dimension(), question) {
            Ok(answer) => answer.map_err(|why| Refusal { check: ANSWER, why }),
            Err(broken) => broken.throw(),
        }
    }
}

impl Solver for ByProgram {
    fn task(&self) -> &dyn AnyTask {
        self.task
    }

    fn solve(
        &self,
        scene: &Scene,
        content: &dyn Content,
        _: &Counts,
        how: &How<'_>,
        then: &mut Then<'_>,
    ) -> Result<(), Halt> {
        how.watch.done(0)?;
        let question = self.question(scene, content).map_err(Halt::Refused)?;
        let reply = self.answer(scene, &question).map_err(Halt::Refused)?;
        how.watch.done(self.task.size_of_content(content) as u64)?;
        then(&Unasked(scene), &reply).map_err(Halt::Stopped)
    }

    fn is_program(&self) -> bool {
        true
    }

    fn interfaces(&self, _: &dyn Content) -> Vec<Interface> {
        vec![Interface::Whole]
    }

    fn stopwatch<'a>(
        &'a self,
        scene: &'a Scene,
        content: &'a dyn Content,
        _: usize,
        _: Interface,
    ) -> Result<Option<Box<dyn Stopwatch + 'a>>, AnswerError> {
        let question = self.question(scene, content).map_err(AnswerError::Refused)?;
        Ok(Some(Box::new(Passes { solver: self, scene, question, last: Reply::default() })))
    }
}

/// Timed answers to one scene.
struct Passes<'a> {
    solver: &'a ByProgram,
    scene: &'a Scene,
    question: Arrays,
    last: Reply,
}

impl Stopwatch for Passes<'_> {
    /// Returns the time by the program's own clock.
    fn pass(&mut self) -> Duration {
        match self.solver.answer(self.scene, &self.question) {
            Ok(reply) => self.last = reply,
            Err(refusal) => {
                Broken { class: Class::Declined, check: "time", message: refusal.to_string() }.throw();
            }
        }
        Duration::from_nanos(self.last.nanoseconds)
    }

    /// One answer by the tool's clock, which includes both messages.
    fn phases(&mut self) -> Vec<Phase> {
        let start = Instant::now();
        self.pass();
        let elapsed = start.elapsed();
        let bytes = self.last.bytes.and_then(|bytes| usize::try_from(bytes).ok());
        vec![Phase { name: "by the tool's clock", unit: "answer", count: 1, elapsed, bytes }]
    }

    fn digest(&self) -> u64 {
        self.last.digest()
    }
}
