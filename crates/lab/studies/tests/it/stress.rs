//! Stress: backends break where they are known to, and proved backends do not.

use predicament_corpus::{Level, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_report::Block;
use predicament_studies::Study;
use predicament_studies::compare::Measure;
use predicament_studies::laws::Format;
use predicament_studies::stress::{BreakPoint, Stress, Stressed};
use predicament_tasks::{Contestant, Knob, Turns};

use crate::{backend, quiet};

fn study(tasks: &[&str], knobs: &[Knob]) -> Stress {
    Stress {
        backends: Vec::new(),
        tasks: tasks.iter().map(|task| (*task).to_owned()).collect(),
        knobs: knobs.to_vec(),
        scenes: 2,
        samples: 0,
        tuples: 60,
        seed: 3,
        suites: None,
        out: "nowhere".into(),
        format: Format::Csv,
    }
}

fn stressed(study: &Stress, names: &[&str]) -> Stressed {
    let backends: Vec<Box<dyn Contestant>> = names.iter().map(|name| backend(name)).collect();
    let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
    study.survey(&backends, &quiet()).unwrap()
}

fn of<'a>(stressed: &'a Stressed, knob: Knob, way: &str, backend: &str) -> &'a BreakPoint {
    let is = |row: &&BreakPoint| row.knob == knob.name() && row.way == way && row.backend == backend;
    stressed.breaks.iter().find(is).unwrap()
}

#[test]
fn backends_break_where_they_do() {
    let study = study(&["insphere"], &[Knob::Noise, Knob::Scale, Knob::Translation]);
    let found = stressed(&study, &["exact", "sos", "tolerance", "naive", "naive:nalgebra", "shewchuk"]);
    for proved in ["exact", "sos"] {
        for knob in [Knob::Noise, Knob::Scale, Knob::Translation] {
            let row = of(&found, knob, "up", proved);
            assert_eq!((row.breaks_at, row.declines_at, row.scenes), (None, None, 2), "{row:?}");
        }
    }
    assert!(study.holds(&found));
    // Its products overflow and underflow: adaptive arithmetic is right in between.
    let [down, up] = ["down", "up"].map(|way| of(&found, Knob::Scale, way, "shewchuk").clone());
    assert_eq!((down.holds_to, down.breaks_at), (Some(-150), Some(-250)));
    assert_eq!((up.holds_to, up.breaks_at), (Some(150), Some(250)));
    // A backend with a band declines if its tolerances are not doubles.
    assert!(of(&found, Knob::Scale, "up", "tolerance").declines_at.is_some());
    // Plain determinants are not zero where they should be, before anything is moved.
    assert_eq!(of(&found, Knob::Noise, "up", "naive").breaks_at, Some(-1075));
    // A backend that does not subtract first fails far from the origin.
    assert!(of(&found, Knob::Translation, "up", "naive:nalgebra").breaks_at.is_some_and(|at| at <= 32));
    let violations = |law: &str, backend: &str| -> u64 {
        let own = found.violations.iter().filter(|row| row.law == law && row.backend == backend);
        own.map(|row| row.violations).sum()
    };
    assert_eq!(found.violations.iter().filter(|row| row.backend == "exact").count(), 19);
    for law in ["scaling", "reflection", "translation", "affine map", "lift", "renaming"] {
        assert_eq!(violations(law, "exact") + violations(law, "sos"), 0, "{law}");
    }
    assert!(violations("scaling", "shewchuk") > 0 && violations("translation", "naive:nalgebra") > 0);
    // A band promises nothing about whole scenes: they are in the tables, and not in the exit code.
    let mut doctored = found.clone();
    let of_tolerance = doctored.measures.iter().find(|row| row.backend == "tolerance").unwrap().clone();
    doctored.measures.push(Measure { measure: "topology".to_owned(), value: 1.0, ..of_tolerance });
    assert!(study.holds(&doctored));
    // A broken promise or law is detected.
    let mut doctored = found.clone();
    doctored.violations.iter_mut().find(|row| row.backend == "sos").unwrap().violations = 1;
    assert!(!study.holds(&doctored));
    let mut doctored = found;
    let row = doctored.measures.iter_mut().find(|row| row.backend == "exact" && row.measure == "sign_flip");
    row.unwrap().value = 1.0;
    assert!(!study.holds(&doctored));
}

#[test]
fn meshes_and_contacts_stay_what_they_are() {
    let study =
        Stress { tuples: 0, scenes: 1, ..study(&["contacts3d", "mesh-intersect"], &[Knob::Turn, Knob::Aspect]) };
    let found = stressed(&study, &["sos:per-mesh"]);
    for row in &found.breaks {
        assert_eq!((row.breaks_at, row.declines_at), (None, None), "{row:?}");
    }
    let again = stressed(&study, &["sos:per-mesh"]);
    assert_eq!(study.rows(&found).unwrap(), study.rows(&again).unwrap());
    let unknown = Stress { tasks: vec!["orient4d".to_owned()], ..study }.survey(&[], &quiet()).unwrap_err();
    assert!(unknown.to_string().contains("contacts3d"), "{unknown}");
}

#[test]
fn a_knob_that_does_not_fit_a_task_is_listed_with_the_reason() {
    let mut fits = 0;
    for task in predicament_bundle::tasks() {
        for knob in Knob::ALL {
            let why = match task.turned_by(knob) {
                Turns::Everywhere => {
                    fits += 1;
                    continue;
                }
                Turns::UpTo(last, why) => {
                    assert!(
                        knob.positions().iter().any(|at| at.abs() > last),
                        "{}: {knob:?} is everywhere",
                        task.name()
                    );
                    why
                }
                Turns::Nowhere(why) => why,
            };
            assert!(!why.contains("does not declare"), "{}: {knob:?}", task.name());
            let study = Stress { scenes: 1, ..study(&[task.name()], &[knob]) };
            // No backend: limits are known without answers.
            let found = stressed(&study, &[]);
            let [row] = &found.limits[..] else { panic!("{:?}", found.limits) };
            assert_eq!((&*row.task, &*row.knob, &*row.why), (task.name(), knob.name(), why));
            assert!(study.page(&found).contains(&format!("| {} | {} | ", task.name(), knob.name())));
        }
    }
    assert!(fits > 100, "{fits}");
    let found = stressed(&Stress { tuples: 0, scenes: 1, ..study(&["cube-union"], &[Knob::Turn]) }, &["exact"]);
    assert!(found.measures.is_empty());
    assert!(table_row(&found, "cube-union").contains(" n/a |"));
}

/// A scene that is not valid would be a backend's mistake in the tables.
#[test]
fn scenes_are_valid_for_their_task_at_every_position() {
    let knobs: Vec<Knob> = Knob::ALL.into_iter().filter(|&knob| knob != Knob::Size).collect();
    stressed(&Stress { tuples: 0, scenes: 1, ..study(&[], &knobs) }, &[]);
}

/// The first row of a task in the page.
fn table_row(of: &Stressed, task: &str) -> String {
    let page = study(&[], &[]).page(of);
    page.lines().find(|line| line.starts_with(&format!("| {task} |"))).unwrap().to_owned()
}

/// Scenes at the last position of a knob are valid scenes of their task.
///
/// Proved backends answer them as promised.
#[test]
fn algorithms_hold_where_their_scenes_are_moved_as_far_as_they_can_be() {
    for (task, knob) in [
        ("interval", Knob::Translation),
        ("triangulate", Knob::Precision),
        ("slice", Knob::Pythagorean),
        ("cube-union", Knob::Scale),
        ("polygon-locate", Knob::Noise),
        ("snap2d", Knob::Translation),
        ("overlay2d", Knob::Turn),
        ("mesh-locate", Knob::Turn),
    ] {
        let study = Stress { tuples: 0, scenes: 1, ..study(&[task], &[knob]) };
        let found = stressed(&study, &["exact", "sos"]);
        assert!(!found.measures.is_empty() && study.holds(&found), "{task}, {knob:?}: {:?}", found.breaks);
    }
}

#[test]
fn the_scenes_of_each_position_are_suites_that_are_read_back() {
    let study = Stress {
        tuples: 0,
        scenes: 1,
        suites: Some("suites".into()),
        ..study(&["orient2d", "contacts2d", "polygon-locate"], &[Knob::Scale, Knob::Noise])
    };
    let found = stressed(&study, &["naive"]);
    let suites = study.suites(&found).unwrap();
    assert_eq!(suites.len(), Knob::Scale.positions().len() + Knob::Noise.positions().len());
    let load = |name: &str| {
        let file = suites.iter().find(|file| file.name.ends_with(&format!("suites/{name}"))).unwrap();
        let suite =
            Suite::parse(predicament_bundle::vocabulary(), name, file.text(), None, &Manifest::default()).unwrap();
        let cache = Cache::new("nowhere");
        suite.scenes.iter().map(|scene| scene.load(Level::Quick, &cache).unwrap()).collect::<Vec<_>>()
    };
    let (rest, scaled) = (load("scale_0.toml"), load("scale_-50.toml"));
    assert_eq!(rest.len(), 3);
    let factor = 1.0 / f64::from(1 << 25) / f64::from(1 << 25);
    for (one, other) in rest.iter().zip(&scaled) {
        assert_eq!((&one.name, one.task, one.count()), (&other.name, other.task, other.count()));
        let times: Vec<f64> = one.scene.coordinates().iter().map(|x| x * factor).collect();
        assert_eq!(other.scene.coordinates(), times);
        assert_ne!(one.id, other.id);
        // Lengths of primitives are those of the moved points.
        let lengths = |loaded: &predicament_corpus::LoadedScene| loaded.scene.primitive_lengths();
        assert_eq!(lengths(other), lengths(one).map(|lengths| lengths.map(|length| length * factor)));
    }
    // A break point can be kept: plain doubles are wrong there as before.
    let noisy = load("noise_-53.toml");
    let turns = noisy.iter().find(|scene| scene.task == "orient2d").unwrap();
    let kept = Stress { scenes: 1, ..study.clone() };
    let wrong = |of: &Stressed| {
        let is = |row: &&predicament_studies::compare::Measure| {
            [&*row.task, &row.kind, &row.family, &row.measure] == ["orient2d", "noise", "-53", "sign_flip"]
        };
        of.measures.iter().find(is).map(|row| row.value * f64::from(u32::try_from(row.of).unwrap()) / 1e6).unwrap()
    };
    let task = predicament_bundle::tasks().iter().copied().find(|task| task.name() == "orient2d").unwrap();
    let quiet = quiet();
    let watch = predicament_studies::Host::watch(&quiet);
    let case = task.case(turns, watch).unwrap();
    let outcome =
        predicament_tasks::run(case.as_ref(), backend("naive").as_ref(), predicament_tasks::Budget::QUICK, watch);
    let flips = outcome.unwrap().counts.get(predicament_tasks::Class::SignFlip);
    assert_eq!(f64::from(u32::try_from(flips).unwrap()), wrong(&stressed(&kept, &["naive"])).round());
}

#[test]
fn times_are_measured_and_shown() {
    let study = Stress { tuples: 0, scenes: 1, samples: 1, ..study(&["orient2d"], &[Knob::Size]) };
    let found = stressed(&study, &["exact"]);
    assert_eq!(found.measures.iter().filter(|row| row.measure == "time").count(), Knob::Size.positions().len());
    assert!(study.page(&found).contains("## Time along the knobs"));
    assert!(study.plots(&found).unwrap().iter().any(|file| file.name == "stress-size-time.svg"));
}

#[test]
fn a_folder_is_a_section_of_a_report() {
    let folder = std::env::temp_dir().join(format!("predicament-stress-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    assert_eq!(predicament_studies::stress::section(&folder), Ok(None));
    let study = study(&["orient2d"], &[Knob::Scale, Knob::Noise]);
    let of = stressed(&study, &["exact", "epsilon:1e-10"]);
    for file in study.rows(&of).unwrap().into_iter().chain(study.plots(&of).unwrap()) {
        std::fs::write(folder.join(&file.name), &file.bytes).unwrap();
    }
    let section = predicament_studies::stress::section(&folder).unwrap().unwrap();
    assert_eq!(section.id, "stress");
    // Noise, and scale in both directions, each with its cells; then plots.
    let shown = format!("{:?}", section.blocks);
    for caption in ["noise: ", "scale: ", "scale, down: "] {
        assert_eq!(shown.matches(&format!("caption: \"{caption}")).count(), 1, "{shown}");
    }
    let breaks = of.breaks.iter().find(|row| row.backend == "epsilon:1e-10" && row.breaks_at.is_some()).unwrap();
    assert!(shown.contains(&format!("text: \"{}", breaks.breaks_at.unwrap())), "{shown}");
    assert!(shown.contains("file: \"stress-noise.svg\""), "{shown}");
    let plots = section.blocks.iter().filter_map(|block| match block {
        Block::Plot { picture, .. } => Some(picture),
        _ => None,
    });
    let mut plots = plots.peekable();
    assert!(
        plots.peek().is_some()
            && plots.all(|picture| picture.pdf.as_ref().is_some_and(|pdf| pdf.starts_with(b"%PDF-")))
    );
    std::fs::write(folder.join("breaks.csv"), "task,knob\nx,y\n").unwrap();
    let why = predicament_studies::stress::section(&folder).unwrap_err().to_string();
    assert!(why.contains("breaks.csv:2") && why.contains("predicament study stress"), "{why}");
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn values_of_a_parameter_are_compared_over_all_positions() {
    let study = study(&["orient2d"], &[Knob::Noise]);
    let found = stressed(&study, &["exact", "epsilon:1e-15", "epsilon:1e-5"]);
    let page = study.page(&found);
    let part = &page[page.find("## Values of parameters").expect("two values")..];
    assert!(part.contains("| `epsilon:1e-5` | ") && part.contains("There is no default"), "{part}");
    let plots = study.plots(&found).unwrap();
    assert!(!plots.iter().any(|file| file.name.starts_with("stress-values")), "no times, no plot");
    assert!(!study.page(&stressed(&study, &["exact", "epsilon:1e-5"])).contains("## Values of parameters"));
}
