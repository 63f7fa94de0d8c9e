//! The scenes of a task for a position of a knob.

use predicament_corpus::{LoadedScene, Random};
use predicament_tasks::{AnyTask, Compared, Kind, Knob};

use super::turned::turned;
use crate::Error;
use crate::compare::Input;

/// A position of a knob, and its scenes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Position {
    /// The task.
    pub task: &'static str,
    /// The knob.
    pub knob: Knob,
    /// The position of the knob.
    pub at: i32,
    /// The unchanged scenes.
    pub input: Input,
}

impl Position {
    /// The positions of a knob at which a task has scenes.
    ///
    /// Empty if the task has no scenes of the kind that the knob begins with.
    pub fn all(task: &'static dyn AnyTask, knob: Knob) -> Vec<Position> {
        let kind = if knob.is_of_degenerate() { Kind::Degenerate } else { Kind::General };
        let Some(of) = task.compared_on().iter().find(|of| of.kind == kind) else { return Vec::new() };
        let turns = task.turned_by(knob);
        let position = |&at: &i32| {
            let times = if knob == Knob::Size { usize::try_from(at).unwrap_or(1) } else { 1 };
            // A quarter of the comparison's size: there are many positions.
            let n = (of.n / 4).max(12).min(of.n) * times;
            let input = Input { task, of: Compared { n, ..*of } };
            Position { task: task.name(), knob, at, input }
        };
        knob.positions().iter().filter(|&&at| turns.reaches(at)).map(position).collect()
    }

    /// The scene of a seed.
    ///
    /// # Errors
    /// [`Error::Unfit`] if the scene cannot be made, or its points are no longer finite.
    pub fn scene(&self, seed: u64) -> Result<LoadedScene, Error> {
        let loaded = self.input.scene(seed)?;
        let mut random = Random::new(self.knob.name(), self.task, seed);
        let scene = &loaded.scene;
        let coordinates = turned(self.knob, self.at, scene.dimension(), scene.coordinates(), &mut random);
        loaded.moved(coordinates).map_err(Error::unfit)
    }
}
