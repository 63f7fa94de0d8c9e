//! Selects the scenes that a command works on.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use predicament_corpus::{Level, LoadedScene, SceneDef, SeenIds, Suite};
use predicament_formats::{Cache, CorpusError, ErrorKind, hex};
use predicament_records::{NotSelected, Plan, PlannedScene, Shard, Whole, part_of_id};
use regex::Regex;
use sha2::{Digest, Sha256};

use crate::exit::{CORPUS, Failure, USAGE};
use crate::out::program;
use crate::programs::is_within;
use crate::progress;
use crate::shared::tell_remarks;
use crate::tool::Tool;

/// The reason why a suite is left out if the command line names other suites.
pub const NOT_NAMED: &str = "not named on the command line";

/// The part of a command line that selects scenes.
#[derive(clap::Args, Clone)]
pub struct Selector {
    /// Suites by name, or your own TOML files; default: all that need no download
    pub suites: Vec<String>,

    /// Only scenes whose `suite/scene` matches this regular expression
    #[arg(short = 'f', long = "filter", value_name = "RE")]
    pub filter: Option<String>,

    /// The amount of work: `quick` takes seconds, `full` is what the authors of the suites chose
    #[arg(long, default_value = "quick", value_name = "quick|full")]
    pub level: Level,

    /// The folder of fetched data; default: $PREDICAMENT_CACHE or the user's cache
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
}

/// The command line arguments that name the suites of a plan. `folder` is the plan's folder, or the plan's file if it
/// came alone. If the plan names a file outside it, a note says so once, before the file is read.
pub fn suites_of(folder: &Path, plan: &Plan) -> Vec<String> {
    plan.suites.iter().map(|suite| suite_of(folder, plan, suite)).collect()
}

/// The command line argument that names one suite of a plan; see [`suites_of`].
pub fn suite_of(folder: &Path, plan: &Plan, suite: &str) -> String {
    static TOLD: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    let argument = plan.argument(suite).to_owned();
    if argument != suite && !is_within(Path::new(&argument), folder) {
        let mut told = TOLD.lock().unwrap_or_else(PoisonError::into_inner);
        if told.insert(argument.clone()) {
            note!("{} names the suite file {argument} for `{suite}`; reading that file", folder.display());
        }
    }
    argument
}

/// The selected suites and scenes.
pub struct Selection {
    pub level: Level,
    pub suites: Vec<Suite>,
    pub cache: Cache,
    pub not_selected: Vec<NotSelected>,
    filter: Option<Regex>,
    /// Suites that were named by a file, with the file's absolute path.
    paths: BTreeMap<String, String>,
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
    /// This selector, with a single scene name among the suites taken as a filter if no suite has this name.
    pub fn with_names(mut self, tool: &Tool) -> Result<Selector, Failure> {
        let library = tool.library()?;
        let is_suite = |name: &String| name.ends_with(".toml") || library.names().any(|suite| suite == name);
        let (suites, mut scenes): (Vec<String>, Vec<String>) = self.suites.drain(..).partition(is_suite);
        self.suites = suites;
        if let (None, Some(scene), 1) = (&self.filter, scenes.first(), scenes.len()) {
            self.filter = Some(format!("/{}$", regex::escape(scene)));
            scenes.clear();
        }
        self.suites.append(&mut scenes);
        Ok(self)
    }

    /// A selector for every scene that needs no download, at level quick.
    pub fn everything() -> Selector {
        Selector { suites: Vec::new(), filter: None, level: Level::Quick, cache: None }
    }

    /// Finds the suites; scenes are loaded later, one at a time.
    pub fn select(&self, tool: &Tool) -> Result<Selection, Failure> {
        let filter = self.filter.as_deref().map(Regex::new).transpose();
        let filter = filter.map_err(|error| {
            let error = error.to_string();
            let last = error.lines().last().unwrap_or_default().trim();
            Failure::usage(format!("--filter: {last}; give a regular expression such as `near.*orient`"))
        })?;
        let library = tool.library()?;
        let own = tool.own_suites()?;
        let cache = self.cache()?;
        let mut not_selected = Vec::new();
        let suites = if self.suites.is_empty() {
            let (fetched, ready): (Vec<_>, Vec<_>) =
                library.suites()?.iter().cloned().partition(|suite| suite.needs_fetch);
            not_selected.extend(fetched.into_iter().map(|suite| NotSelected {
                reason: format!(
                    "needs fetched data and was not named; `{} corpus fetch`, then name `{}`",
                    program(),
                    suite.name
                ),
                suite: suite.name,
            }));
            own.into_iter().chain(ready).collect()
        } else {
            let find = |name: &String| match own.iter().find(|suite| suite.name == *name) {
                Some(suite) => Ok(suite.clone()),
                None => library.suite(name),
            };
            let named: Vec<Suite> = self.suites.iter().map(find).collect::<Result<_, _>>()?;
            for (at, suite) in named.iter().enumerate() {
                if named[..at].iter().any(|other| other.name == suite.name) {
                    return Err(Failure::usage(format!(
                        "two suites are called `{}`; rename a file or name it once",
                        suite.name
                    )));
                }
            }
            let rest = library.names().filter(|name| named.iter().all(|other| other.name != *name));
            not_selected.extend(rest.map(|name| NotSelected { suite: name.to_owned(), reason: NOT_NAMED.to_owned() }));
            named
        };
        let named_by_file = |suite: &&Suite| {
            let is_file = |name: &&String| name.ends_with(".toml") && **name == suite.file();
            self.suites.iter().any(|name| is_file(&name))
        };
        let absolute =
            |file: &str| std::path::absolute(file).map_or_else(|_| file.to_owned(), |path| path.display().to_string());
        let paths =
            suites.iter().filter(named_by_file).map(|suite| (suite.name.clone(), absolute(suite.file()))).collect();
        Ok(Selection { level: self.level, suites, cache, not_selected, filter, paths })
    }

    /// The cache that the command line names, or the user's cache.
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
        self.suites.iter().flat_map(|suite| &suite.scenes).filter(|def| self.passes(&def.suite, &def.name)).collect()
    }

    /// True if a scene of this suite passes the filter.
    pub fn passes(&self, suite: &str, scene: &str) -> bool {
        self.filter.as_ref().is_none_or(|filter| filter.is_match(&format!("{suite}/{scene}")))
    }

    /// The command line argument for the suite of a scene: its name, or the file that was named.
    pub fn argument(&self, def: &SceneDef) -> String {
        self.paths.get(&def.suite).cloned().unwrap_or_else(|| def.suite.clone())
    }

    /// The text after the name of a scene or suite: ` of FILE` if a file was named, otherwise empty.
    pub fn of_file(&self, suite: &str) -> String {
        self.paths.get(suite).map_or_else(String::new, |file| format!(" of {file}"))
    }

    /// The failure that nothing is selected, with the named files.
    pub fn nothing(&self) -> Failure {
        let files: Vec<&str> = self.paths.values().map(String::as_str).collect();
        let of = if files.is_empty() { String::new() } else { format!(" of {}", files.join(" and ")) };
        let list = format!("{} corpus list --scenes", program());
        Failure::nothing(format!("no scene{of} is selected; `{list}` lists all scenes"))
    }

    /// The files of the suites that were named by path.
    pub fn paths(&self) -> BTreeMap<String, String> {
        self.paths.clone()
    }

    /// The SHA-256 of these files. A file that was removed since it was read has none.
    pub fn hashes(&self) -> BTreeMap<String, String> {
        let hash = |path: &String| std::fs::read(path).ok().map(|bytes| hex(&Sha256::digest(bytes)));
        self.paths.iter().filter_map(|(suite, path)| Some((suite.clone(), hash(path)?))).collect()
    }

    /// Loads one scene.
    pub fn load(&self, def: &SceneDef) -> Result<LoadedScene, Failure> {
        Ok(def.load(self.level, &self.cache)?)
    }

    /// Loads every selected scene for its id and size. Refuses two scenes with the same contents.
    pub fn plan(&self) -> Result<Vec<Planned>, Failure> {
        Ok(self.part(Shard::WHOLE)?.0)
    }

    /// Loads every selected scene, and returns those of the shard and a description of the whole. A part may be empty.
    pub fn part(&self, shard: Shard) -> Result<(Vec<Planned>, Option<Whole>), Failure> {
        let _working = progress::working("reading scenes");
        let mut seen = SeenIds::new();
        let (mut planned, mut all, mut places) = (Vec::new(), Vec::new(), Vec::new());
        let mut room = Room(KEPT);
        for def in self.defs() {
            let loaded = self.load(def)?;
            tell_remarks(&loaded);
            seen.insert(def, &loaded)?;
            let plan = planned_scene(&loaded);
            all.push(plan.clone());
            // Shards depend on the content id only, so a scene is in the same shard whatever else is selected.
            if part_of_id(&loaded.id, shard.count()) == shard.index() {
                places.push(all.len() as u64 - 1);
                planned.push(Planned { def: def.clone(), plan, kept: room.keep(loaded) });
            }
        }
        if all.is_empty() {
            return Err(self.nothing());
        }
        let whole = (shard != Shard::WHOLE).then(|| Whole::new(&all, places));
        Ok((planned, whole))
    }

    /// The scenes of an earlier plan; no others are loaded.
    ///
    /// # Errors
    /// The first scene that is gone or has changed, with the failure that `changed` makes from it and from its
    /// [file](Self::of_file).
    pub fn of_plan(
        &self,
        scenes: &[PlannedScene],
        changed: impl Fn(&PlannedScene, &str) -> Failure,
    ) -> Result<Vec<Planned>, Failure> {
        let defs: BTreeMap<(&str, &str), &SceneDef> =
            self.defs().into_iter().map(|def| ((&*def.suite, &*def.name), def)).collect();
        let mut room = Room(KEPT);
        let changed = |scene: &PlannedScene| changed(scene, &self.of_file(&scene.suite));
        let load = |scene: &PlannedScene| {
            let def = defs.get(&(&*scene.suite, &*scene.scene)).ok_or_else(|| changed(scene))?;
            let loaded = self.load(def)?;
            if planned_scene(&loaded) != *scene {
                return Err(changed(scene));
            }
            Ok(Planned { def: (*def).clone(), plan: scene.clone(), kept: room.keep(loaded) })
        };
        scenes.iter().map(load).collect()
    }
}

/// The number of coordinates kept in memory between planning and running: half a gigabyte.
const KEPT: usize = 1 << 26;

/// The number of coordinates that may still be kept.
struct Room(usize);

impl Room {
    /// The scene, if it may be kept.
    fn keep(&mut self, scene: LoadedScene) -> Option<LoadedScene> {
        let size = scene.scene.coordinates().len() + 8 * scene.count();
        let kept = (size <= self.0).then_some(scene);
        self.0 -= if kept.is_some() { size } else { 0 };
        kept
    }
}

/// A scene of a plan.
pub struct Planned {
    /// The definition of the scene.
    pub def: SceneDef,
    /// The entry of the plan for the scene.
    pub plan: PlannedScene,
    /// The scene itself, unless it is too large to be kept.
    kept: Option<LoadedScene>,
}

impl Planned {
    /// The scene, loaded unless it was kept.
    pub fn take(&mut self, selection: &Selection) -> Result<LoadedScene, Failure> {
        match self.kept.take() {
            Some(loaded) => Ok(loaded),
            None => selection.load(&self.def),
        }
    }
}

/// The entry of a plan for a scene.
pub fn planned_scene(loaded: &LoadedScene) -> PlannedScene {
    PlannedScene {
        suite: loaded.suite.clone(),
        scene: loaded.name.clone(),
        scene_id: loaded.id.clone(),
        task: loaded.task.to_owned(),
        family: loaded.family.clone(),
        queries: loaded.count() as u64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The data file is removed once the plan is made.
    #[test]
    fn a_scene_is_loaded_once() {
        let folder = tempfile::tempdir().unwrap();
        let [suite, points] = ["mine.toml", "points.csv"].map(|name| folder.path().join(name));
        let scene =
            "title = \"Mine\"\n[[scene]]\nname = \"a\"\ntask = \"orient2d\"\npoints = { path = \"points.csv\" }\n";
        std::fs::write(&suite, scene).unwrap();
        std::fs::write(&points, "0, 0\n1, 0\n0, 1\n").unwrap();
        let selector = Selector { suites: vec![suite.display().to_string()], ..Selector::everything() };
        let selection = selector
            .select(&crate::tool::Tool::new((), &predicament_bundle::Systems, crate::tool::Guests::default()))
            .unwrap();
        let mut planned = selection.plan().unwrap();
        std::fs::remove_file(&points).unwrap();
        assert_eq!(planned[0].take(&selection).unwrap().count(), 1);
        assert_eq!(
            planned[0].take(&selection).err().map(|failure| failure.code),
            Some(CORPUS),
            "it is given away once"
        );
    }
}
