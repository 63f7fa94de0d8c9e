//! The second truth: answers about decimals, by backends that know them and by backends that do not.

use predicament_corpus::{LoadedScene, Suite};
use predicament_formats::{Cache, CorpusError, Manifest};
use predicament_tasks::Agreement;

use crate::common::{judged_by_name, suite};

fn read(text: &str) -> Result<LoadedScene, CorpusError> {
    let suite = Suite::parse(predicament_bundle::vocabulary(), "mine.toml", text, None, &Manifest::default())?;
    suite.scenes[0].load(predicament_corpus::Level::Quick, &Cache::new("nowhere"))
}

fn scene(keys: &str) -> Result<LoadedScene, CorpusError> {
    read(&format!("title = \"t\"\n[[scene]]\nname = \"s\"\n{keys}\n"))
}

fn agreement(loaded: &LoadedScene, backend: &str) -> Agreement {
    judged_by_name(loaded, backend).agreement.expect("a scene with a truth of decimals")
}

/// A grid of the written digits is right about what was written, and exact signs are right about the doubles; each is
/// wrong about the other, so that neither comparison can be replaced by the other.
#[test]
fn a_grid_is_right_about_decimals_and_exact_signs_about_doubles() {
    let scenes = suite("written");
    let is_asked =
        |loaded: &&LoadedScene| loaded.family == "decimals" && ["orient2d", "insphere"].contains(&loaded.task);
    for loaded in scenes.iter().filter(is_asked) {
        let digits = loaded.written.as_ref().unwrap().digits();
        let (grid, exact) = (agreement(loaded, &format!("grid:1e-{digits}")), agreement(loaded, "exact"));
        let name = &loaded.name;
        assert_eq!((grid.written, grid.ties_found), (grid.answers, grid.ties), "{name}");
        assert_eq!(exact.doubles, exact.answers, "{name}");
        assert!(exact.ties > 100 && exact.ties < exact.answers - 100, "{name}: {exact:?}");
        // Points on one axis have equal doubles where they have equal decimals.
        let is_skew = !name.contains("figure-grid");
        assert_eq!(exact.written < exact.answers && grid.doubles < grid.answers, is_skew, "{name}: {exact:?} {grid:?}");
    }
}

#[test]
fn tasks_other_than_signs_are_judged_by_the_integers() {
    let scenes = suite("written");
    for (name, answers) in [("shared-border", 6), ("hull-on-an-edge", 1), ("streets", 1)] {
        let loaded = scenes.iter().find(|loaded| loaded.name == name).unwrap();
        let (exact, grid) = (agreement(loaded, "exact"), agreement(loaded, "grid:0.01"));
        assert_eq!((exact.answers, exact.doubles), (answers, answers), "{name}: {exact:?}");
        assert_eq!(grid.written, answers, "{name}: {grid:?}");
        assert!(exact.written < answers, "{name}: {exact:?}");
    }
}

/// Points that agree in doubles and in decimals are judged alike.
#[test]
fn decimals_that_are_doubles_have_one_truth() {
    let loaded =
        scene("task = \"orient2d\"\ntruth = \"decimals\"\npoints = [[0.5, 1.5], [1, 3], [1.25, 3.75]]").unwrap();
    let exact = agreement(&loaded, "exact");
    assert_eq!((exact.doubles, exact.written, exact.ties, exact.ties_found), (1, 1, 1, 1));
}

#[test]
fn an_id_tells_decimals_apart_that_have_the_same_doubles() {
    let of = |keys: &str| scene(&format!("task = \"orient2d\"\n{keys}")).unwrap().id;
    let points = |last: &str| format!("points = [[0.1, 0.3], [0.2, 0.6], [0.3, \"{last}\"]]");
    let decimals = |last: &str| of(&format!("truth = \"decimals\"\n{}", points(last)));
    assert_eq!(of(&points("0.9")), of(&format!("truth = \"doubles\"\n{}", points("0.9000"))));
    assert_eq!(decimals("0.9"), decimals("0.900"));
    assert_ne!(decimals("0.9"), of(&points("0.9")));
    assert_ne!(decimals("0.9"), decimals("0.90000000000000002"));
}

#[test]
fn a_scene_with_decimals_is_written_out_with_them() {
    for loaded in suite("written") {
        let Some(spelled) = loaded.spelled() else {
            assert!(loaded.name.contains("survey"), "{}: cannot be written out", loaded.name);
            continue;
        };
        let again = spelled.loaded(predicament_bundle::vocabulary(), "again").unwrap();
        assert_eq!(again.id, loaded.id, "{}", loaded.name);
    }
}

#[test]
fn what_has_no_decimals_is_refused_with_a_cure() {
    for (keys, message) in [
        ("task = \"orient2d\"\ntruth = \"exact\"\npoints = [[0, 0], [1, 0], [2, 0]]", "`exact` is no truth"),
        (
            "task = \"snap2d\"\ntruth = \"decimals\"\npixel = 0\npoints = [[0, 0], [1, 0]]",
            "snap2d has no truth of decimals",
        ),
        (
            "task = \"orient2d\"\ntruth = \"decimals\"\npoints = [[\"1e30\", 0], [\"1e-30\", 0], [2, 0]]",
            "needs more than 36 digits",
        ),
        (
            "task = \"hull2d\"\ntruth = \"decimals\"\npoints = [[1e9, 0], [0.0000000001, 0], [2, 1]]",
            "no integers below 2^53",
        ),
        (
            "task = \"orient2d\"\ntruth = \"decimals\"\npoints = [[0.1, 0], [0.10000000000000001, 0], [2, 0]]",
            "two different decimals",
        ),
    ] {
        let error = scene(keys).unwrap_err();
        assert!(error.message.contains(message) && !error.cure.is_empty(), "{keys}: {error}");
        assert!(error.to_string().contains("mine.toml:"), "{error}");
    }
}
