//! Scenes of any task, as text: what `exact`, `sos` and `tolerance` answer to them is judged, and the judge finds nothing.
//!
//! The text is a suite, so that what is found is a scene as it stands. Bytes that are no suite are no case; [`mutate`](crate::mutate)
//! keeps most of them one.

use std::any::Any;
use std::sync::{LazyLock, atomic::AtomicBool};

use predicament_corpus::{Level, LoadedScene, SceneDef, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_triangulate::task::Polygons;
use predicament_tasks::{AnyTask, Budget, Class, Contestant, Outcome, Watch};

/// The backends that are held to their promises.
pub const BACKENDS: [&str; 3] = ["exact", "sos", "tolerance"];

/// Vertices that a scene of the fuzzers has at most, and queries: what takes a second finds less than a thousand that take one in all.
const MOST_VERTICES: usize = 60;
const MOST_QUERIES: usize = 3000;

/// What is sampled beyond the queries themselves.
const BUDGET: Budget = Budget { permutations: 300, relations: 100, ties: 20, ..Budget::QUICK };

/// Backends by name, made once.
static CONTESTANTS: LazyLock<Vec<Box<dyn Contestant>>> =
    LazyLock::new(|| BACKENDS.map(|name| predicament_bundle::backend(name).expect("a backend of the house")).into());

/// The scenes of a text that are written out in it and small.
#[must_use]
pub fn of_text(text: &str) -> Vec<SceneDef> {
    // Generators make as much as they are told to.
    let is_generator = |line: &str| line.trim_start_matches([' ', '\t', '[', '"', '\'']).starts_with("generate");
    if text.lines().any(is_generator) {
        return Vec::new();
    }
    let suite = Suite::parse(predicament_bundle::vocabulary(), "fuzzed.toml", text, None, &Manifest::default());
    suite.map_or_else(|_| Vec::new(), |suite| suite.scenes)
}

/// One fuzz case: the scenes of a text that are of one of these tasks, or of any if none is named.
///
/// # Panics
/// If a backend breaks its promise, with the first finding.
pub fn check(bytes: &[u8], tasks: &[&str]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    for def in of_text(text) {
        if !tasks.is_empty() && !tasks.contains(&def.task) {
            continue;
        }
        if let Some(wrong) = first_wrong(&def, &CONTESTANTS) {
            panic!("{wrong}");
        }
    }
}

/// The first promise that one of these backends breaks on a scene, in words.
#[must_use]
pub fn first_wrong(def: &SceneDef, backends: &[Box<dyn Contestant>]) -> Option<String> {
    // What is somewhere else is not there.
    let loaded = def.load(Level::Quick, &Cache::new("/nowhere")).ok()?;
    if loaded.scene.len() > MOST_VERTICES || loaded.count() > MOST_QUERIES {
        return None;
    }
    let task: &'static dyn AnyTask = predicament_bundle::tasks().iter().copied().find(|task| task.name() == loaded.task)?;
    let never = AtomicBool::new(false);
    let watch = Watch::new(&never, None, &|_| {});
    let content: &dyn Any = loaded.content.as_ref();
    if let Some(Polygons { polygons, .. }) = content.downcast_ref()
        && !polygons.iter().all(|loops| crate::polygons::is_simple(&loaded.scene, loops))
    {
        return None;
    }
    let case = task.case(&loaded, &watch).ok()?;
    if let Some(dispute) = case.dispute() {
        return Some(format!("{}: the judge is not sure: {dispute}", loaded.task));
    }
    backends.iter().find_map(|backend| {
        let outcome = predicament_oracle::run(case.as_ref(), backend.as_ref(), BUDGET, &watch).ok()?;
        broken(&loaded, &backend.name(), &outcome)
    })
}

/// A promise that was broken, if one was.
fn broken(loaded: &LoadedScene, backend: &str, outcome: &Outcome) -> Option<String> {
    let class = Class::ALL
        .into_iter()
        .find(|&class| outcome.counts.get(class) > 0 && !is_promised(loaded.task, backend, class))?;
    let finding = outcome.findings.iter().find(|finding| finding.class == class)?;
    let (count, name) = (outcome.counts.get(class), class.name());
    let (query, got, truth) = (finding.query_text(), &finding.got, &finding.truth);
    Some(format!(
        "{} on {backend}: {count} {name} ({}): {query}: got {got}, true is {truth}",
        loaded.task, finding.check
    ))
}

/// Whether a backend may answer so: by its promise, or for a reason that is documented and in `expected.toml`.
fn is_promised(task: &str, backend: &str, class: Class) -> bool {
    class.is_legal()
        || class == Class::Declined
        || class == Class::Topology
            && match backend {
                // Faces of closed cubes in one plane.
                "exact" => task == "cube-union",
                // A mesh that touches itself and whose vertices move each on its own.
                "sos" => task == "mesh-intersect",
                // Each answer is within the band, and an algorithm that takes them for exact is not.
                _ => true,
            }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SUITE: &str = "title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"orient2d\"\npoints = [[\"0x1.0000000000001p-1\", \"0x1p-1\"], [12, 12], [24, 24]]\n";

    #[test]
    fn a_scene_that_is_written_out_is_judged() {
        let [def] = of_text(SUITE).try_into().unwrap();
        assert_eq!(first_wrong(&def, &CONTESTANTS), None);
        let naive = [predicament_bundle::backend("naive").unwrap()];
        let wrong = first_wrong(&def, &naive).unwrap();
        assert!(wrong.starts_with("orient2d on naive: 1 "), "{wrong}");
        check(SUITE.as_bytes(), &[]);
    }

    #[test]
    fn a_planted_fault_is_caught_on_the_embedded_scenes() {
        for (fault, task) in [("fault:exact-halved-filter", "orient3d"), ("fault:compare-greater-on-ties", "compare")] {
            let faulty = [predicament_bundle::backend(fault).unwrap()];
            let texts = crate::seeds::scenes().into_iter().map(|(_, text)| text);
            let mut defs = texts.flat_map(|text| of_text(&text)).filter(|def| def.task == task);
            assert!(defs.any(|def| first_wrong(&def, &faulty).is_some()), "{fault}");
        }
    }
}
