//! Scenes of the embedded corpora, and backends run on them.

use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;

use predicament_corpus::{Level, Library, LoadedScene, SceneDef};
use predicament_formats::Cache;
use predicament_oracle::run;
use predicament_tasks::{AnyCase, AnyTask, Budget, Class, Contestant, Outcome, Watch};

/// The embedded suites, read once.
fn library() -> &'static Library {
    static LIBRARY: OnceLock<Library> = OnceLock::new();
    LIBRARY.get_or_init(|| Library::embedded(predicament_bundle::vocabulary()).unwrap())
}

/// The embedded scenes that need no download.
pub fn definitions() -> Vec<SceneDef> {
    let scenes = library().suites().unwrap().iter().flat_map(|suite| &suite.scenes);
    scenes.filter(|definition| !definition.needs_fetch()).cloned().collect()
}

pub fn loaded(definition: &SceneDef) -> LoadedScene {
    definition.load(Level::Quick, &Cache::new("nowhere")).unwrap()
}

/// The scene with this name, in any suite.
pub fn load(name: &str) -> LoadedScene {
    let found = definitions().into_iter().find(|definition| definition.name == name);
    loaded(&found.unwrap_or_else(|| panic!("no scene {name}")))
}

/// All scenes of a suite.
pub fn suite(name: &str) -> Vec<LoadedScene> {
    library().suite(name).unwrap().scenes.iter().map(loaded).collect()
}

pub fn task(loaded: &LoadedScene) -> &'static dyn AnyTask {
    predicament_bundle::tasks().iter().copied().find(|task| task.name() == loaded.task).expect("a task of the house")
}

/// Calls `then` with the scene and its exact answers.
pub fn with_case<R>(loaded: &LoadedScene, then: impl FnOnce(&dyn AnyCase, &Watch) -> R) -> R {
    let (cancel, silent) = (AtomicBool::new(false), |_: u64| {});
    let watch = Watch::new(&cancel, None, &silent);
    then(task(loaded).case(loaded, &watch).unwrap().as_ref(), &watch)
}

/// The outcome of a backend on a scene, at level quick.
pub fn judged(loaded: &LoadedScene, contestant: &dyn Contestant) -> Outcome {
    with_case(loaded, |case, watch| run(case, contestant, Budget::QUICK, watch).unwrap())
}

/// The outcome of a backend, given by name, on a scene, at level quick.
pub fn judged_by_name(loaded: &LoadedScene, backend: &str) -> Outcome {
    judged(loaded, predicament_bundle::backend(backend).unwrap().as_ref())
}

/// The classes that occur, with their checks.
pub fn checks(outcome: &Outcome) -> Vec<(Class, &str)> {
    let mut checks: Vec<_> = outcome.findings.iter().map(|finding| (finding.class, finding.check.as_str())).collect();
    checks.sort_unstable_by_key(|(class, check)| (*class as usize, *check));
    checks.dedup();
    checks
}
