//! The syntax of a task's scenes in suites: its name, its keys, its generators.

use std::borrow::Cow;
use std::sync::Arc;

use predicament_formats::{CorpusError, Field, Fields, TableKind, use_one_of};

use crate::{Context, Level, Parts, Random, Source};

/// The syntax of one task's scenes in suites.
pub trait SceneFormat: Send + Sync {
    /// The task's name in suites, CSV files and on the command line.
    fn name(&self) -> &'static str;

    /// A one-line description of the questions, with the source.
    fn about(&self) -> &'static str;

    /// A commented scene to start from, for `predicament corpus new`; empty if there is none.
    ///
    /// Lines that start with `@written ` are for scenes with data in the suite. Lines that start with `@file ` are for
    /// scenes with data in a file, `{data}`. `{task}` is the task's name. `{queries}` is the value of that key:
    /// `"tuples"`, or random queries about many points.
    fn template(&self) -> String {
        String::new()
    }

    /// The keys of the task's `[[scene]]` tables besides the keys of all scenes (`name`, `task`, `round`, `truth`,
    /// `tags`, `source`, `analysis`).
    fn keys(&self) -> &'static [&'static str];

    /// The keys of the task's scenes and generators that hold coordinates: numbers, arrays of numbers, or tables that
    /// hold some of these keys. `corpus fmt` makes them lossless.
    fn coordinate_keys(&self) -> &'static [&'static str] {
        &[]
    }

    /// The keys of the task that take a data file as `{ path = … }`: `solve TASK FILE` writes the file names there.
    fn file_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    /// The kind of scenes of the task that can also be judged by the decimals that were written (`truth = "decimals"`).
    fn in_decimals(&self) -> InDecimals {
        InDecimals::Never
    }

    /// Reads a `[[scene]]` table. Keys that it does not read are errors.
    ///
    /// # Errors
    /// [`CorpusError`] at the line that is wrong.
    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError>;

    /// The task's generator families.
    fn families(&self) -> &'static [Family] {
        &[]
    }

    /// The keys of the task's `[[generate]]` tables besides the keys of all generators (`family`, `n`, `n_full`, `seed`
    /// and the keys of scenes) and of the families.
    fn generator_keys(&self) -> &'static [&'static str] {
        &[]
    }

    /// Lines of a `[[generate]]` table, such as `shift = 1`, for keys that a family needs, or that make its scenes
    /// large. A command that tries all families gives each family the lines of its keys.
    fn sample_keys(&self) -> &'static [&'static str] {
        &[]
    }

    /// The keys of generators that are part of a scene's default name.
    fn naming_keys(&self) -> &'static [&'static str] {
        &[]
    }
}

/// The kind of scenes whose answers can also be judged by the decimals that were written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum InDecimals {
    /// No scene: answers depend on more than the shape of the points.
    Never,
    /// Scenes that are integers below 2^53 times a power of ten: the task judges the integers.
    Integers,
    /// Scenes of any decimals.
    AnyDigits,
}

/// A family of generated scenes: one kind of difficulty.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// The family's name in `[[generate]]` tables.
    pub name: &'static str,
    /// The family's name in `throughput.csv`; `None` if each scene is its own family.
    pub reported_as: Option<&'static str>,
    /// The parameters that the family takes besides the task's generator keys.
    pub parameters: &'static [&'static str],
    /// A one-line description.
    pub about: &'static str,
    /// Reads the family's parameters.
    pub read: fn(task: &'static str, fields: &Fields<'_, '_>) -> Result<Recipe, CorpusError>,
}

/// A scene generator: a family with its parameters.
#[derive(Clone)]
pub struct Recipe {
    /// The number of queries, if the parameters fix it.
    pub fixed_size: Option<usize>,
    make: Arc<dyn Fn(&Making) -> Parts + Send + Sync>,
    coordinates: Arc<dyn Fn(u64) -> u64 + Send + Sync>,
}

impl Recipe {
    /// A recipe for any number of queries n.
    ///
    /// `coordinates` returns an approximate upper bound on a scene's number of coordinates; scenes that are too large
    /// are refused before they are generated. It must grow with n and not overflow.
    pub fn new(
        coordinates: impl Fn(u64) -> u64 + Send + Sync + 'static,
        make: impl Fn(&Making) -> Parts + Send + Sync + 'static,
    ) -> Recipe {
        Recipe { fixed_size: None, make: Arc::new(make), coordinates: Arc::new(coordinates) }
    }

    /// An approximate upper bound on the number of coordinates in a scene of n.
    #[must_use]
    pub fn coordinates(&self, n: u64) -> u64 {
        (self.coordinates)(n)
    }

    /// A recipe whose parameters fix the number of queries.
    #[must_use]
    pub fn of_size(self, size: usize) -> Recipe {
        Recipe { fixed_size: Some(size), ..self }
    }

    /// Generates a scene.
    #[must_use]
    pub fn make(&self, making: &Making) -> Parts {
        (self.make)(making)
    }
}

/// The request to a recipe.
#[derive(Clone, Copy, Debug)]
pub struct Making {
    /// The family's name.
    pub family: &'static str,
    /// The task's name.
    pub task: &'static str,
    /// The seed of the suite.
    pub seed: u64,
    /// The number of queries, or the size for families that make a single whole.
    pub n: usize,
    /// The amount of work of the run.
    pub level: Level,
}

impl Making {
    /// The stream of random numbers of this family, task and seed.
    #[must_use]
    pub fn random(&self) -> Random {
        Random::new(self.family, self.task, self.seed)
    }
}

/// All tasks whose scenes suites can hold.
#[derive(Clone)]
pub struct Vocabulary {
    tasks: Arc<[&'static dyn SceneFormat]>,
    pub(crate) scene: Arc<TableKind>,
    pub(crate) generator: Arc<TableKind>,
}

impl std::fmt::Debug for Vocabulary {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.names()).finish()
    }
}

/// The keys of every `[[scene]]` table.
const SCENE: [&str; 8] = ["name", "task", "round", "truth", "invalid", "tags", "source", "analysis"];
/// The keys of every `[[generate]]` table besides those of scenes.
const GENERATOR: [&str; 5] = ["family", "n", "n_full", "seed", "coordinates"];

impl Vocabulary {
    /// A vocabulary with these tasks, in the order of messages and reports.
    ///
    /// # Panics
    /// If two tasks have the same name.
    #[must_use]
    pub fn new(tasks: Vec<&'static dyn SceneFormat>) -> Vocabulary {
        for (at, task) in tasks.iter().enumerate() {
            let taken = tasks[..at].iter().any(|other| other.name() == task.name());
            assert!(!taken, "two tasks are called `{}`", task.name());
        }
        let kind = |name: &'static str, keys: Vec<&'static str>| {
            let mut all: Vec<&'static str> = SCENE.into_iter().chain(keys).collect();
            all.sort_unstable();
            all.dedup();
            Arc::new(TableKind { name, keys: Cow::Owned(all) })
        };
        let scene = kind("scene", tasks.iter().flat_map(|task| task.keys()).copied().collect());
        let of_families = tasks.iter().flat_map(|task| task.families()).flat_map(|family| family.parameters);
        let of_tasks = tasks.iter().flat_map(|task| task.generator_keys());
        let generator = kind("generator", GENERATOR.into_iter().chain(of_tasks.chain(of_families).copied()).collect());
        Vocabulary { tasks: tasks.into(), scene, generator }
    }

    /// The tasks, in the order of messages and reports.
    #[must_use]
    pub fn tasks(&self) -> &[&'static dyn SceneFormat] {
        &self.tasks
    }

    /// The names of the tasks.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.tasks.iter().map(|task| task.name())
    }

    /// The task that a table names.
    pub(crate) fn task(&self, field: &Field<'_, '_>) -> Result<&'static dyn SceneFormat, CorpusError> {
        let name = field.str()?;
        self.tasks.iter().copied().find(|task| task.name() == name).ok_or_else(|| {
            let known: Vec<&str> = self.names().collect();
            field.error(format!("no task is called `{name}`"), use_one_of(name, &known))
        })
    }

    /// The message and fix for a scene key that only one or two other tasks know: the scene was probably meant for
    /// them.
    pub(crate) fn foreign(&self, key: &str, task: &'static dyn SceneFormat) -> Option<(String, String)> {
        if SCENE.contains(&key) || task.keys().contains(&key) {
            return None;
        }
        let others: Vec<&str> =
            self.tasks.iter().filter(|other| other.keys().contains(&key)).map(|other| other.name()).collect();
        let message = format!("`{key}` is a key of {}, not of {}", others.join(" and "), task.name());
        (1..=2).contains(&others.len()).then(|| (message, format!("remove it, or write `task = \"{}\"`", others[0])))
    }

    /// The family of a task that a table names.
    pub(crate) fn family(
        &self,
        field: &Field<'_, '_>,
        task: &'static dyn SceneFormat,
    ) -> Result<&'static Family, CorpusError> {
        let name = field.str()?;
        if let Some(family) = task.families().iter().find(|family| family.name == name) {
            return Ok(family);
        }
        let families = |task: &&'static dyn SceneFormat| task.families().iter().map(|family| family.name);
        let others: Vec<&str> = self
            .tasks
            .iter()
            .filter(|task| families(task).any(|family| family == name))
            .map(|task| task.name())
            .collect();
        if others.is_empty() {
            let mut known: Vec<&str> = Vec::new();
            for family in self.tasks.iter().flat_map(families) {
                if !known.contains(&family) {
                    known.push(family);
                }
            }
            return Err(field.error(format!("no family is called `{name}`"), use_one_of(name, &known)));
        }
        let message = format!("family {name} does not generate scenes for {}", task.name());
        Err(field.error(message, format!("use it for {}", others.join(", "))))
    }
}
