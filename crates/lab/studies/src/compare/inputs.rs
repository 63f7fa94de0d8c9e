//! The scenes of a comparison: each task names its families, and each seed makes a scene.

use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_tasks::{AnyTask, Compared, vocabulary};

use crate::Error;

/// Scenes of one kind for one task.
#[derive(Clone, Copy, Debug)]
pub struct Input {
    /// The task.
    pub task: &'static dyn AnyTask,
    /// Their degree of degeneracy, and their generator.
    pub of: Compared,
}

/// The inputs of these tasks, in their order; a task may name none.
#[must_use]
pub fn inputs(tasks: &[&'static dyn AnyTask]) -> Vec<Input> {
    tasks.iter().flat_map(|&task| task.compared_on().iter().map(move |&of| Input { task, of })).collect()
}

/// The `tasks` with inputs, restricted to the given names; all if no names are given.
///
/// # Errors
/// As [`asked`].
pub(crate) fn compared(
    tasks: &[&'static dyn AnyTask],
    names: &[String],
    done: &str,
) -> Result<Vec<&'static dyn AnyTask>, Error> {
    asked(tasks.iter().copied().filter(|task| !task.compared_on().is_empty()).collect(), names, done)
}

/// The tasks with these names; all `tasks` if no names are given.
///
/// # Errors
/// [`Error::Unfit`] with the known names, if one is unknown; `done` is the verb in the message.
pub(crate) fn asked(
    tasks: Vec<&'static dyn AnyTask>,
    names: &[String],
    done: &str,
) -> Result<Vec<&'static dyn AnyTask>, Error> {
    if let Some(unknown) = names.iter().find(|name| tasks.iter().all(|task| task.name() != name.as_str())) {
        let known: Vec<&str> = tasks.iter().map(|task| task.name()).collect();
        return Err(Error::unfit(format!("task `{unknown}` cannot be {done}; the tasks are {}", known.join(", "))));
    }
    let is_asked = |task: &&'static dyn AnyTask| names.is_empty() || names.iter().any(|name| name == task.name());
    Ok(tasks.into_iter().filter(is_asked).collect())
}

/// The size ratio of the timed scene.
const TIMED: usize = 8;

impl Input {
    /// The same kind of scenes in another size.
    #[must_use]
    pub fn sized(&self, n: usize) -> Input {
        Input { of: Compared { n, ..self.of }, ..*self }
    }

    /// The scene of a seed.
    ///
    /// # Errors
    /// [`Error::Unfit`] if the scene cannot be made.
    pub fn scene(&self, seed: u64) -> Result<LoadedScene, Error> {
        self.of_size(self.of.n, seed)
    }

    /// A larger scene, for timing.
    ///
    /// # Errors
    /// As [`Input::scene`].
    pub fn timed(&self, seed: u64) -> Result<LoadedScene, Error> {
        self.of_size(TIMED * self.of.n, seed)
    }

    /// The table of the scene in a suite, under this name.
    #[must_use]
    pub fn table(&self, name: &str, seed: u64) -> String {
        self.table_of_size(name, self.of.n, seed)
    }

    fn table_of_size(&self, name: &str, n: usize, seed: u64) -> String {
        let Input { task, of: Compared { family, keys, .. } } = self;
        let task = task.name();
        let table = format!(
            "[[generate]]\nname = \"{name}\"\nfamily = \"{family}\"\ntask = \"{task}\"\nn = {n}\nseed = {seed}\n"
        );
        if keys.is_empty() { table } else { format!("{table}{keys}\n") }
    }

    fn of_size(&self, n: usize, seed: u64) -> Result<LoadedScene, Error> {
        let name = format!("{}-{seed}", self.of.kind.name());
        let text = format!("title = \"compare\"\n{}", self.table_of_size(&name, n, seed));
        let suite = Suite::parse(&vocabulary(&[self.task]), "compare", &text, None, &Manifest::default())
            .map_err(Error::unfit)?;
        // A generator does not use the cache.
        suite.scenes[0].load(Level::Quick, &Cache::new("compare")).map_err(Error::unfit)
    }
}
