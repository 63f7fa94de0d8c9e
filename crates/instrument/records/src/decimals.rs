//! `decimals.csv`: the answers that agree with the doubles, and with the decimals that were written.

use crate::{PlannedScene, RowError};

crate::table! {
    /// `decimals.csv`: one scene with a truth of decimals on one backend.
    ///
    /// A backend gets doubles. The same answers are compared with the doubles and with the numbers that were written.
    /// For a task that is judged as a whole there is one answer, which is right if no check fails.
    pub struct DecimalsRow [Clone, PartialEq, Eq, Debug] in "decimals.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The task.
        pub task: String,
        /// The scene's family.
        pub family: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The number of answers.
        pub answers: u64,
        /// Answers that are right about the doubles.
        pub doubles: u64,
        /// Answers that are right about the decimals.
        pub written: u64,
        /// Answers whose sign is zero by the decimals; 0 for tasks without signs.
        pub ties: u64,
        /// Zeros by the decimals that were answered by zero.
        pub ties_found: u64,
    }

    fn check(&self) -> Result<(), RowError> {
        RowError::check_count(self.answers)?;
        let is_part = self.doubles.max(self.written) <= self.answers && self.ties_found <= self.ties;
        if is_part && self.ties <= self.answers {
            Ok(())
        } else {
            Err(RowError::Contradiction("more right answers than answers"))
        }
    }
}

impl DecimalsRow {
    /// The row of a scene and backend without answers.
    #[must_use]
    pub fn new(of: &PlannedScene, backend: &str) -> DecimalsRow {
        let [suite, scene, scene_id, task] = of.labels();
        let (family, backend) = (of.family.clone(), backend.to_owned());
        let [answers, doubles, written, ties, ties_found] = [0; 5];
        DecimalsRow { suite, scene, scene_id, task, family, backend, answers, doubles, written, ties, ties_found }
    }
}
