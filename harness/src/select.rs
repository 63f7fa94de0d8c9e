//! Which scenes a command works on.

use std::path::PathBuf;

use predicament_corpus::{Cache, CorpusError, ErrorKind, Level, Library, LoadedScene, SceneDef, SeenIds, Suite};
use predicament_report::{NotSelected, PlannedScene, Shard};
use regex::Regex;

use crate::exit::{CORPUS, Failure, USAGE};

/// The part of a command line that selects scenes.
#[derive(clap::Args, Clone)]
pub struct Selector {
    /// Suites by name, or TOML files of your own; all that need no download if left out
    pub suites: Vec<String>,

    /// Only scenes whose `suite/scene` matches this regular expression
    #[arg(short = 'f', long = "filter", value_name = "RE")]
    pub filter: Option<String>,

    /// How much: `quick` takes seconds, `full` is what the suites' authors thought worth it
    #[arg(long, default_value = "quick", value_name = "quick|full")]
    pub level: Level,

    /// Where fetched data lie; $PREDICAMENT_CACHE or the user's cache if left out
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
}

/// What was selected.
pub struct Selection {
    pub level: Level,
    pub suites: Vec<Suite>,
    pub cache: Cache,
    pub not_selected: Vec<NotSelected>,
    filter: Option<Regex>,
}

impl From<CorpusError> for Failure {
    fn from(error: CorpusError) -> Failure {
        let code = match error.kind {
            ErrorKind::Usage => USAGE,
            ErrorKind::Corpus => CORPUS,
        };
        Failure { message: error.to_string(), code }
    }
}

impl Selector {
    /// Finds the suites; scenes are loaded later, one at a time.
    pub fn select(&self) -> Result<Selection, Failure> {
        let filter = self.filter.as_deref().map(Regex::new).transpose();
        let filter = filter.map_err(|error| {
            let error = error.to_string();
            let last = error.lines().last().unwrap_or_default().trim();
            Failure::usage(format!("--filter: {last}; give a regular expression such as `near.*orient`"))
        })?;
        let library = Library::embedded()?;
        let cache = self.cache()?;
        let mut not_selected = Vec::new();
        let suites = if self.suites.is_empty() {
            let (fetched, ready): (Vec<_>, Vec<_>) =
                library.suites().iter().cloned().partition(|suite| suite.needs_fetch);
            not_selected.extend(fetched.into_iter().map(|suite| NotSelected {
                reason: format!(
                    "needs fetched data and was not named; `predicament corpus fetch`, then name `{}`",
                    suite.name
                ),
                suite: suite.name,
            }));
            ready
        } else {
            let named: Result<Vec<Suite>, Failure> = self.suites.iter().map(|name| Ok(library.suite(name)?)).collect();
            let named = named?;
            for (at, suite) in named.iter().enumerate() {
                if named[..at].iter().any(|other| other.name == suite.name) {
                    return Err(Failure::usage(format!(
                        "two suites are called `{}`; rename a file or name it once",
                        suite.name
                    )));
                }
            }
            let rest = library.suites().iter().filter(|suite| named.iter().all(|other| other.name != suite.name));
            not_selected.extend(rest.map(|suite| NotSelected {
                suite: suite.name.clone(),
                reason: "not named on the command line".to_owned(),
            }));
            named
        };
        Ok(Selection { level: self.level, suites, cache, not_selected, filter })
    }

    /// The cache that the command line names, or the user's.
    pub fn cache(&self) -> Result<Cache, Failure> {
        Ok(match &self.cache {
            Some(folder) => Cache::new(folder),
            None => Cache::default_dir()?,
        })
    }
}

impl Selection {
    /// The definitions that pass the filter, in suite order.
    pub fn defs(&self) -> Vec<&SceneDef> {
        let passes = |def: &SceneDef| {
            self.filter.as_ref().is_none_or(|filter| filter.is_match(&format!("{}/{}", def.suite, def.name)))
        };
        self.suites.iter().flat_map(|suite| &suite.scenes).filter(|def| passes(def)).collect()
    }

    /// Loads one scene.
    pub fn load(&self, def: &SceneDef) -> Result<LoadedScene, Failure> {
        Ok(def.load(self.level, &self.cache)?)
    }

    /// Loads every selected scene once, for its id and its size, and keeps those
    /// of the shard. Refuses two scenes with the same contents.
    pub fn plan(&self, shard: Shard) -> Result<Vec<(SceneDef, PlannedScene)>, Failure> {
        let mut seen = SeenIds::new();
        let mut planned = Vec::new();
        for def in self.defs() {
            let loaded = self.load(def)?;
            seen.insert(def, &loaded)?;
            if in_shard(&loaded.id, shard) {
                planned.push((def.clone(), planned_scene(&loaded)));
            }
        }
        if planned.is_empty() {
            return Err(Failure::nothing("no scene is selected; see `predicament corpus list` for what there is"));
        }
        Ok(planned)
    }
}

/// What a plan says of a scene.
pub fn planned_scene(loaded: &LoadedScene) -> PlannedScene {
    PlannedScene {
        suite: loaded.suite.clone(),
        scene: loaded.name.clone(),
        scene_id: loaded.id.clone(),
        task: loaded.task.name().to_owned(),
        family: loaded.family.clone(),
        queries: loaded.work.len() as u64,
    }
}

/// Shards go by content id: the same scene is in the same shard whatever else is selected.
fn in_shard(id: &str, shard: Shard) -> bool {
    let digits = id.get(..15).unwrap_or(id);
    u64::from_str_radix(digits, 16).is_ok_and(|id| id % u64::from(shard.count()) + 1 == u64::from(shard.index()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_id_is_in_exactly_one_shard() {
        for n in 1..6 {
            for i in 0..200_u64 {
                let id = format!("{:016x}", i.wrapping_mul(0x9e37_79b9_7f4a_7c15));
                let hits = (1..=n).filter(|&k| in_shard(&id, Shard::new(k, n).unwrap())).count();
                assert_eq!(hits, 1, "{id} of {n}");
            }
        }
    }
}
