//! Scenes of any task, as text: the answers of `exact`, `sos` and `tolerance` are judged, without findings.
//!
//! The text is a suite, so that a find is a scene already. Bytes that are not a suite are skipped;
//! [`mutate`](crate::mutate) keeps most of them a suite.

use std::any::Any;
use std::sync::{LazyLock, atomic::AtomicBool};

use predicament_corpus::{Level, LoadedScene, SceneDef, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_tasks::{AnyTask, Budget, Class, Contestant, Outcome, Watch};
use predicament_triangulate::task::Polygons;

/// The backends whose promises are checked.
pub const BACKENDS: [&str; 3] = ["exact", "sos", "tolerance"];

/// The maximum number of vertices, and of queries, of a fuzzed scene: one slow scene of a second finds less than a
/// thousand scenes that take a second in total.
const MOST_VERTICES: usize = 60;
const MOST_QUERIES: usize = 3000;

/// The budget for samples beyond the queries themselves.
const BUDGET: Budget = Budget { permutations: 300, relations: 100, ties: 20, ..Budget::QUICK };

/// The backends by name, created once.
static CONTESTANTS: LazyLock<Vec<Box<dyn Contestant>>> =
    LazyLock::new(|| BACKENDS.map(|name| predicament_bundle::backend(name).expect("a backend of the house")).into());

/// The scenes that are written in a text and small.
#[must_use]
pub fn of_text(text: &str) -> Vec<SceneDef> {
    // Generators can make scenes of any size.
    let is_generator = |line: &str| line.trim_start_matches([' ', '\t', '[', '"', '\'']).starts_with("generate");
    if text.lines().any(is_generator) {
        return Vec::new();
    }
    let suite = Suite::parse(predicament_bundle::vocabulary(), "fuzzed.toml", text, None, &Manifest::default());
    suite.map_or_else(|_| Vec::new(), |suite| suite.scenes)
}

/// Runs one fuzz case: the scenes of a text that are of one of these tasks, or of any task if the list is empty.
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
    // Data outside of the text is not available.
    let loaded = def.load(Level::Quick, &Cache::new("/nowhere")).ok()?;
    if loaded.scene.len() > MOST_VERTICES || loaded.count() > MOST_QUERIES {
        return None;
    }
    let task: &'static dyn AnyTask =
        predicament_bundle::tasks().iter().copied().find(|task| task.name() == loaded.task)?;
    let never = AtomicBool::new(false);
    let watch = Watch::new(&never, None, &|_| {});
    let content: &dyn Any = loaded.content.as_ref();
    if let Some(Polygons { polygons, .. }) = content.downcast_ref()
        && !polygons.iter().all(|loops| crate::polygons::is_simple(&loaded.scene, loops))
    {
        return None;
    }
    let case = task.case(&loaded, &watch).ok()?;
    // A change of the text can make it no scene of its task, or contradict the signs that it states.
    if case.dispute().is_some() {
        return None;
    }
    backends.iter().find_map(|backend| {
        let outcome = predicament_oracle::run(case.as_ref(), backend.as_ref(), BUDGET, &watch).ok()?;
        broken(&loaded, &backend.name(), &outcome)
    })
}

/// The broken promise in words, if there is one.
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

/// True if a backend may answer so: by its promise, or for a reason that is documented and in `expected.toml`.
fn is_promised(task: &str, backend: &str, class: Class) -> bool {
    class.is_legal()
        || class == Class::Declined
        || class == Class::Topology
            && match backend {
                // Coplanar faces of closed cubes.
                "exact" => task == "cube-union",
                // A mesh that touches itself and whose vertices move independently.
                "sos" => ["mesh-intersect", "slice"].contains(&task),
                // Each answer is within the band, but an algorithm that treats them as exact may fail.
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

    /// A run begins with these scenes, and would end with the first that breaks a promise.
    #[test]
    fn the_embedded_scenes_break_no_promise() {
        let mut wrong = Vec::new();
        for (name, text) in crate::seeds::scenes() {
            let broken = of_text(&text).into_iter().filter_map(|def| first_wrong(&def, &CONTESTANTS));
            wrong.extend(broken.map(|why| format!("{name}: {why}")));
        }
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
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
