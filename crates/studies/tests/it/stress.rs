//! Stress: backends break where it is known that they do, and what is proved does not.

use predicament_studies::laws::Format;
use predicament_studies::stress::{BreakPoint, Knob, Stress, Stressed};
use predicament_studies::{Quiet, Study};
use predicament_tasks::Contestant;

use crate::backend;

fn study(tasks: &[&str], knobs: &[Knob]) -> Stress {
    Stress {
        backends: Vec::new(),
        tasks: tasks.iter().map(|task| (*task).to_owned()).collect(),
        knobs: knobs.to_vec(),
        scenes: 2,
        samples: 0,
        tuples: 60,
        seed: 3,
        out: "nowhere".into(),
        format: Format::Csv,
    }
}

fn stressed(study: &Stress, names: &[&str]) -> Stressed {
    let backends: Vec<Box<dyn Contestant>> = names.iter().map(|name| backend(name)).collect();
    let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
    study.survey(&backends, &Quiet::new()).unwrap()
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
    // One with a band declines where its tolerances are no doubles.
    assert!(of(&found, Knob::Scale, "up", "tolerance").declines_at.is_some());
    // Plain determinants are not zero where they should be, before anything is moved.
    assert_eq!(of(&found, Knob::Noise, "up", "naive").breaks_at, Some(-1075));
    // What subtracts nothing first drowns far from the origin.
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
    // A promise that is broken, or a law, is seen.
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
    let unknown = Stress { tasks: vec!["overlay2d".to_owned()], ..study }.survey(&[], &Quiet::new()).unwrap_err();
    assert!(unknown.to_string().contains("contacts3d"), "{unknown}");
}
