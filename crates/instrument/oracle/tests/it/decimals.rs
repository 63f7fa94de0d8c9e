//! The second truth: answers about decimals, by backends that know them and by backends that do not.

use predicament_corpus::{LoadedScene, Suite};
use predicament_formats::{Cache, CorpusError, Manifest};
use predicament_predicates::Predicates;
use predicament_tasks::replies::{Arrays, Reply};
use predicament_tasks::{Agreement, Asked, Budget, Outcome, Purpose};

use crate::common::{judged_by_name, suite, task, with_case};

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

/// Parcels share borders and blocks share faces as written, and not as stored: backends with a band are right about
/// what was written, and exact signs about the doubles.
#[test]
fn shared_sides_are_judged_as_they_were_written() {
    let scenes = suite("written");
    let of = |task: &str, digits: &str| {
        let is = |loaded: &&LoadedScene| loaded.task == task && loaded.name.contains(digits);
        scenes.iter().find(is).unwrap()
    };
    for (task, right, count) in [
        ("contacts2d", "tolerance", 16),
        ("contacts3d", "tolerance", 35),
        ("overlay2d", "tolerance", 1),
        ("overlay2d", "grid:0.01", 1),
        ("mesh-intersect", "sos:per-mesh", 1),
    ] {
        let loaded = of(task, "digits-2");
        let [exact, right] = ["exact", right].map(|backend| agreement(loaded, backend));
        assert_eq!((exact.answers, exact.doubles, exact.written), (count, count, 0), "{task}: {exact:?}");
        assert_eq!((right.answers, right.written), (count, count), "{task}: {right:?}");
    }
}

/// Without digits behind the point both truths are the same: no judge mixes up the doubles and the decimals.
#[test]
fn integers_have_one_truth_for_every_task() {
    for (task, family) in [
        ("contacts2d", "parcels"),
        ("contacts3d", "blocks"),
        ("overlay2d", "overlay-parcels"),
        ("mesh-intersect", "intersect-blocks"),
    ] {
        for (figure, place) in [("general", "survey"), ("rectangle", "metres"), ("grid", "degrees")] {
            let text = format!(
                "title = \"t\"\n[[generate]]\nfamily = \"{family}\"\ntask = \"{task}\"\ntruth = \"decimals\"\n\
                 digits = 0\nfigure = \"{figure}\"\nplace = \"{place}\"\nn = 16\nseed = 7\n"
            );
            let loaded = read(&text).unwrap();
            for backend in ["exact", "sos", "naive", "grid:1"] {
                let Some(agreement) = judged_by_name(&loaded, backend).agreement else { continue };
                let Agreement { doubles, written, .. } = agreement;
                // Vertices that a session rounds are judged by their definitions there.
                let is_rounded = task == "mesh-intersect" && doubles < written;
                assert!(doubles == written || is_rounded, "{task} {figure} {backend}: {agreement:?}");
                assert!(backend != "exact" || doubles == agreement.answers, "{task} {figure}: {agreement:?}");
            }
        }
    }
}

/// Answers of other programs have coordinates in doubles, near the decimals. They are compared with those, up to
/// rounding.
#[test]
fn answers_of_programs_are_judged_by_the_decimals() {
    let scenes = suite("written");
    let loaded = scenes.iter().find(|loaded| loaded.task == "overlay2d").unwrap();
    let (task, exact) = (task(loaded), predicament_bundle::backend("exact").unwrap());
    let of = |loaded: &LoadedScene| {
        let mut arrays = None;
        let (scene, content) = (&loaded.scene, loaded.content.as_ref());
        let asked = exact.answer_any(loaded.task, scene, content, Purpose::Use, &mut |answer| {
            arrays = task.as_reply(scene, content, answer);
        });
        asked.unwrap();
        arrays.unwrap()
    };
    let agreement = |arrays: Arrays| {
        let (mut outcome, reply) = (Outcome::default(), Reply { arrays, ..Reply::default() });
        with_case(loaded, |case, watch| {
            let judge = &mut |session: &mut dyn Predicates| {
                let asked = Asked { backend: exact.as_ref(), session, budget: Budget::QUICK, watch };
                case.judge(&asked, &reply, &mut outcome).unwrap();
            };
            exact.with_session(&loaded.scene, judge).unwrap();
        });
        outcome.agreement.unwrap()
    };
    // The exact results as written, in doubles.
    let mut right = of(loaded.similar.as_ref().unwrap());
    let rings = right.polygons("union").unwrap();
    let moved = |by: f64| {
        let scaled = |ring: &Vec<[f64; 2]>| ring.iter().map(|point| point.map(|x| x / 100.0 + by)).collect();
        rings.iter().map(|polygon| polygon.iter().map(scaled).collect()).collect::<Vec<Vec<Vec<[f64; 2]>>>>()
    };
    for part in ["union", "intersection", "difference", "symmetric-difference"] {
        right.remove(part);
    }
    for (by, written) in [(0.0, 1), (0.5, 0)] {
        let mut arrays = right.clone();
        arrays.add_polygons("union", &moved(by));
        assert_eq!(agreement(arrays).written, written, "moved by {by}");
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
