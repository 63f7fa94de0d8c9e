//! The text of a new suite.

use std::path::Path;

use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_formats::{CorpusError, Manifest};
use predicament_records::format::thousands;
use predicament_tasks::AnyTask;

use super::data::Data;
use crate::out::program;
use crate::select::Selector;
use crate::tool::Tool;

/// The suite around the scene.
const TEMPLATE: &str = include_str!("../../../../templates/suite.toml");

/// Where a scene says what is asked about its points.
const QUERIES: &str = "{queries}";

/// Which queries are asked about points.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Draw {
    /// Consecutive points.
    Tuples,
    /// Random ones.
    Random,
}

impl Draw {
    /// More points than this are asked about at random: consecutive points of a file are often neighbours.
    const MOST_TUPLED: usize = 1000;
    /// The number of random queries.
    const QUERIES: usize = 1000;

    /// The choice of queries by the number of points.
    pub fn of(loaded: &LoadedScene) -> Draw {
        if loaded.scene.len() > Draw::MOST_TUPLED { Draw::Random } else { Draw::Tuples }
    }
}

/// A suite to be written.
pub struct Draft<'a> {
    pub tool: &'a Tool,
    pub file: &'a Path,
    pub task: &'static dyn AnyTask,
    pub data: Option<&'a Data>,
    /// How many decimals of the data are rounded; with none, decimals are not rounded.
    pub rounded: Option<usize>,
    pub draw: Draw,
}

impl Draft<'_> {
    /// The text of the suite.
    pub fn text(&self) -> String {
        let title = self.file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        let names: Vec<&str> = self.tool.tasks().iter().map(|task| task.name()).collect();
        TEMPLATE
            .replace("{scene}", &self.scene())
            .replace("{round}", &self.round())
            .replace("{program}", &program())
            .replace("{file}", &self.file.display().to_string())
            .replace("{tasks}", &names.join(", "))
            .replace("{task}", self.task.name())
            .replace("\"{title}\"", &toml::Value::String(title).to_string())
    }

    /// The scene of the task's template, with data that are written out or in a file.
    fn scene(&self) -> String {
        let (kept, dropped) = if self.data.is_some() { ("@file ", "@written ") } else { ("@written ", "@file ") };
        let queries = match self.draw {
            Draw::Tuples => "\"tuples\"".to_owned(),
            Draw::Random => format!("{{ random = {}, seed = 1 }}", Draw::QUERIES),
        };
        let template = self.task.template();
        let lines = template.lines().filter(|line| !line.starts_with(dropped));
        let line = |line: &str| {
            let line = line.strip_prefix(kept).unwrap_or(line).replace(QUERIES, &queries);
            self.data.map_or(line.clone(), |data| line.replace("{data}", &reference(&line, data))) + "\n"
        };
        lines.map(line).collect()
    }

    fn round(&self) -> String {
        match (self.rounded, self.data) {
            (Some(count), Some(data)) => {
                let (decimals, their) = if count == 1 { ("decimal", "Its nearest double is") } else { ("decimals", "Their nearest doubles are") };
                let have = if count == 1 { "has" } else { "have" };
                format!(
                    "# {} {decimals} of {} {have} digits that no double holds. {their} used; the report counts \
                     them.\nround = true",
                    thousands(count as u64),
                    data.path
                )
            }
            _ => "# A decimal such as 0.1 means the double that prints like this. Decimals with digits that no double holds are refused.\n\
                  # `{program} corpus fmt {file}` writes them as hex floats into a new file; this key reads their nearest doubles:\n\
                  # round = true"
                .to_owned(),
        }
    }

    /// Reads the suite and its data.
    ///
    /// # Errors
    /// [`CorpusError`] as `run` would have it.
    pub fn load(&self) -> Result<LoadedScene, CorpusError> {
        let (name, text) = (self.file.display().to_string(), self.text());
        let suite = Suite::parse(self.tool.vocabulary(), &name, &text, self.file.parent(), &Manifest::default())?;
        let cache =
            Selector::everything().cache().map_err(|why| CorpusError::usage(&name, why.message, "name a cache"))?;
        suite.scenes[0].load(Level::Quick, &cache)
    }

    /// A line about the data and what is asked about them.
    pub fn told(&self, loaded: &LoadedScene) -> String {
        let of_columns = self.data.and_then(|data| data.columns.as_ref());
        let of_columns = of_columns.map_or_else(String::new, |columns| format!(" of the columns {columns}"));
        let is_drawn = self.draw == Draw::Random && self.task.template().contains(QUERIES);
        let queries = if is_drawn {
            format!("{} random", thousands(Draw::QUERIES as u64))
        } else {
            thousands(loaded.count() as u64)
        };
        format!(
            "{}: {} points with {} coordinates{of_columns}; the suite asks {queries} queries of {}",
            self.data.map_or("", |data| &data.path),
            thousands(loaded.scene.len() as u64),
            loaded.scene.dimension().count(),
            self.task.name()
        )
    }
}

/// The path of the data, with the columns where a key takes points.
fn reference(line: &str, data: &Data) -> String {
    let path = toml::Value::String(data.path.clone()).to_string();
    match data.columns.as_ref().filter(|_| line.trim_start().starts_with("points")) {
        Some(columns) => format!("{path}, columns = {}", columns.toml()),
        None => path,
    }
}
