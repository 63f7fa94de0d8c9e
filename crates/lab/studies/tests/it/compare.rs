//! The comparison: known errors of planted contacts are measured, a broken promise is detected, and rows are
//! reproducible.

use predicament_predicates::Derived;
use predicament_report::Block;
use predicament_studies::compare::{Compare, Compared, Verdict, inputs};
use predicament_studies::laws::Format;
use predicament_studies::{Host, Study};
use predicament_tasks::{Contestant, Kind};

use crate::{backend, quiet};

fn study(tasks: &[&str], scenes: u32) -> Compare {
    Compare {
        backends: Vec::new(),
        tasks: tasks.iter().map(|task| (*task).to_owned()).collect(),
        scenes,
        samples: 0,
        trials: 0,
        queries: 0,
        seed: 5,
        out: "nowhere".into(),
        format: Format::Csv,
    }
}

fn compared(study: &Compare, names: &[&str]) -> Compared {
    let backends: Vec<Box<dyn Contestant>> = names.iter().map(|name| backend(name)).collect();
    let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
    study.survey(&backends, &quiet()).unwrap()
}

/// A number about a backend; `None` if there is no row.
fn value(of: &Compared, kind: Kind, backend: &str, measure: &str, unit: &str) -> Option<f64> {
    let is = |row: &&predicament_studies::compare::Measure| {
        row.kind == kind.name() && row.backend == backend && row.measure == measure && row.unit == unit
    };
    of.measures.iter().find(is).map(|row| row.value)
}

#[test]
fn what_is_far_off_is_measured_as_far_off() {
    let of = compared(&study(&["contacts2d"], 3), &["exact", "epsilon:1e-4", "fault:tolerance-mirrored-weight"]);
    for kind in Kind::ALL {
        let location = |backend: &str| value(&of, kind, backend, "location: 99 %", "L").unwrap();
        // Weights in plain floating point, of edges that may cross at small angles.
        assert!(location("exact") < 1e-8, "{kind:?}: {}", location("exact"));
        assert_eq!(value(&of, kind, "exact", "registered apart", "share of contacts"), Some(0.0));
    }
    // Contacts within a wide distance are registered, and are elsewhere.
    let wide = value(&of, Kind::Near, "epsilon:1e-4", "location: max", "L").unwrap();
    assert!(wide > 1e-3, "{wide}");
    // The fraction from the wrong end: half of an edge on average.
    let weight = value(&of, Kind::Degenerate, "fault:tolerance-mirrored-weight", "weight: max", "of one").unwrap();
    assert!(weight > 0.1, "{weight}");
}

#[test]
fn a_broken_promise_is_seen() {
    let small = study(&["contacts2d"], 2);
    for (name, holds) in [("tolerance", true), ("fault:tolerance-wide-contacts", false)] {
        let mut of = compared(&small, &[name]);
        assert!(small.holds(&of));
        // The fault does not claim to be proved.
        of.promises[0].proved = true;
        assert_eq!(small.holds(&of), holds, "{name}");
        assert_eq!(value(&of, Kind::Near, name, "overreach", "per 10^6 answers").map(|x| x == 0.0), Some(holds));
    }
    // A control proves nothing, so it breaks no promise.
    let small = study(&["orient2d"], 1);
    let of = compared(&small, &["naive", "exact"]);
    assert_eq!(value(&of, Kind::Near, "naive", "wrong scenes", "per 1000 scenes"), Some(1000.0));
    assert!(small.holds(&of));
}

#[test]
fn rows_are_the_same_on_any_number_of_threads() {
    let small = study(&["contacts3d", "mesh-locate"], 2);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| small.rows(&compared(&small, &["sos", "tolerance"])).unwrap())
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn every_input_makes_scenes_of_two_sizes() {
    let mut again = Vec::new();
    let inputs = inputs(predicament_bundle::tasks());
    for input in &inputs {
        let [small, large] = [input.scene(3).unwrap(), input.timed(3).unwrap()];
        assert!(small.scene.len() < large.scene.len(), "{input:?}");
        again.extend((small.id == input.scene(4).unwrap().id).then_some(input.of.family));
    }
    // Bricks, lattices, grids: their scenes are counted once.
    assert!(3 * again.len() < inputs.len(), "{again:?}");
    let of = compared(&study(&["polygon-locate"], 4), &["exact"]);
    let declined = |kind: Kind| of.measures.iter().find(|row| row.kind == kind.name() && row.measure == "declined");
    assert_eq!([Kind::General, Kind::Degenerate].map(|kind| declined(kind).unwrap().of), [4, 1]);
    let unknown = study(&["orient4d"], 1).survey(&[], &quiet()).unwrap_err();
    assert!(unknown.to_string().contains("orient2d"), "{unknown}");
}

/// New tasks join automatically: this test names none.
#[test]
fn every_task_is_compared_on_general_and_degenerate_scenes() {
    let inputs = inputs(predicament_bundle::tasks());
    for task in predicament_bundle::tasks() {
        if Derived::named(task.name()).is_some() {
            // Predicates from formulas are timed and judged in a suite of their own.
            assert!(inputs.iter().all(|input| input.task != *task), "{}", task.name());
            continue;
        }
        let kinds: Vec<Kind> = inputs.iter().filter(|input| input.task == *task).map(|input| input.of.kind).collect();
        assert!(kinds.is_sorted() && kinds.windows(2).all(|pair| pair[0] < pair[1]), "{}: {kinds:?}", task.name());
        assert!(kinds.contains(&Kind::General) && kinds.contains(&Kind::Degenerate), "{}: {kinds:?}", task.name());
    }
}

#[test]
fn bits_are_those_of_the_arithmetic_that_was_needed() {
    let small = study(&["orient3d", "crossings", "contacts2d"], 1);
    let of = compared(&small, &["exact", "naive", "shewchuk", "tolerance:f32"]);
    let bits = |task: &str, kind: Kind, backend: &str| {
        let is = |row: &&predicament_studies::compare::Measure| {
            row.task == task && row.kind == kind.name() && row.backend == backend && row.measure == "bits"
        };
        of.measures.iter().find(is).map(|row| row.value)
    };
    // Filters settle general position. Three differences of 53 bits each are far longer than a double.
    assert_eq!(bits("orient3d", Kind::General, "exact"), Some(53.0));
    let near = bits("orient3d", Kind::Near, "exact").unwrap();
    assert!((150.0..200.0).contains(&near), "{near}");
    for kind in Kind::ALL {
        assert_eq!(bits("orient3d", kind, "naive"), Some(53.0));
        assert_eq!(bits("orient3d", kind, "shewchuk"), None, "it does not say");
    }
    assert_eq!(bits("contacts2d", Kind::General, "tolerance:f32"), Some(24.0));
    // Crossings of a lattice compare constructed points.
    assert_eq!(bits("crossings", Kind::Degenerate, "exact"), None);
    let page = small.page(&of);
    assert!(page.contains("| bits |") && page.contains("| near | exact | "), "{page}");
    // The shares of stages are of all queries.
    let shares = of.measures.iter().filter(|row| {
        [&*row.task, &row.kind, &row.backend] == ["orient3d", "near", "exact"] && row.measure.starts_with("stage: ")
    });
    let sum: f64 = shares.map(|row| row.value).sum();
    assert!((sum - 1.0).abs() < 1e-12, "{sum}");
}

#[test]
fn fewer_stages_are_a_curve_that_ends_without_an_error() {
    let names: Vec<String> = (1..=6).map(|stages| format!("exact:stages={stages}")).collect();
    let names: Vec<String> = std::iter::once("exact".to_owned()).chain(names).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let small = Compare { samples: 1, ..study(&["insphere"], 1) };
    let mut of = compared(&small, &names);
    let wrong: Vec<f64> =
        names[1..].iter().map(|name| value(&of, Kind::Near, name, "sign_flip", "per 10^6 answers").unwrap()).collect();
    assert!(wrong[0] > 0.0 && wrong.windows(2).all(|pair| pair[0] >= pair[1]), "{wrong:?}");
    assert_eq!(wrong[5], 0.0);
    assert!(of.promises.iter().skip(1).all(|of| !of.proved), "a control");
    let plots = small.plots(&of).unwrap();
    let curve = plots.iter().find(|file| file.name == "error-time-answers.svg").unwrap().text();
    assert!(curve.contains("\nexact:stages=6\n") && curve.contains("<polyline"), "one curve: {curve}");
    let page = small.page(&of);
    let table = &page[page.find("## One parameter turned").unwrap()..];
    assert!(names[1..].iter().all(|name| table.contains(&format!("| `{name}` | "))), "{table}");
    let verdict = predicament_studies::compare::sweeps(&of.measures)[0].verdict.clone();
    let Verdict::Default(default) = verdict else { panic!("the last stages are right: {verdict:?}") };
    assert_eq!(value(&of, Kind::Near, default, "sign_flip", "per 10^6 answers"), Some(0.0));
    assert!(page.contains(&format!("`{default}` can be the default")), "{page}");
    // Without times there is no horizontal axis.
    of.measures.retain(|row| row.measure != "time");
    assert!(!small.page(&of).contains("One parameter turned"));
    assert!(small.plots(&of).unwrap().is_empty());
    assert!(small.page(&of).contains("and it is the first of them"));
}

#[test]
fn a_folder_is_a_section_of_a_report() {
    let folder = std::env::temp_dir().join(format!("predicament-compare-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    assert_eq!(predicament_studies::compare::section(&folder), Ok(None));
    let small = study(&["contacts2d"], 1);
    let of = compared(&small, &["exact", "epsilon:1e-4"]);
    let files = small.rows(&of).unwrap();
    for file in &files {
        std::fs::write(folder.join(&file.name), &file.bytes).unwrap();
    }
    let file = files.iter().find(|file| file.name == "compare.csv").unwrap();
    let section = predicament_studies::compare::section(&folder).unwrap().unwrap();
    assert_eq!(section.id, "compare");
    // The ranking with a row for each backend, and at the end the long table: three kinds of input.
    let is_table = |block: &Block| matches!(block, Block::Table(_));
    assert!(is_table(&section.blocks[0]));
    let counts: Vec<usize> = section
        .blocks
        .iter()
        .filter(|block| is_table(block))
        .map(|table| format!("{table:?}").matches("epsilon:1e-4").count())
        .collect();
    assert_eq!(counts, [1, 3]);
    std::fs::write(folder.join("compare.csv"), file.text().replace(",1.0,", ",one,")).unwrap();
    let why = predicament_studies::compare::section(&folder).unwrap_err().to_string();
    assert!(why.contains("compare.csv:"), "{why}");
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn the_first_screen_has_the_decision_tree() {
    let section = predicament_studies::compare::decision();
    let [Block::Plot { picture, .. }] = &section.blocks[..] else { panic!("{section:?}") };
    assert_eq!(section.id, "which");
    assert!(picture.svg.contains("currentColor") && picture.svg.contains("viewBox=\"0 0 400 "), "{}", picture.svg);
    for backend in ["naive", "exact", "tolerance", "sos", "sos:per-mesh"] {
        assert!(picture.svg.contains(backend), "{backend}");
    }
}

#[test]
fn plain_doubles_are_wrong_where_queries_are_nearly_degenerate() {
    let backends = ["exact", "sos", "tolerance", "naive"].map(backend);
    let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
    let quiet = quiet();
    let found = predicament_studies::compare::conditioning(&backends, 60, 1, quiet.watch()).unwrap();
    for row in &found {
        assert!(row.low <= row.share && row.share <= row.high, "{row:?}");
        if row.backend != "naive" {
            assert_eq!(row.wrong, 0, "{row:?}");
        } else if row.log2_relative_det >= -44 {
            // Rounding errors are far below: u is 2^-53.
            assert_eq!(row.wrong, 0, "{row:?}");
        }
        assert!(row.in_band == 0 || row.backend == "tolerance", "{row:?}");
    }
    assert!(found.iter().filter(|row| row.backend == "naive").map(|row| row.wrong).sum::<u64>() > 0);
    for task in ["orient2d", "orient3d", "incircle", "insphere"] {
        let bins = found.iter().filter(|row| row.task == task && row.backend == "exact").count();
        assert!(bins > 8, "{task}: {bins}");
    }
    assert!(found.iter().any(|row| row.backend == "tolerance" && row.in_band > 0));
}
