//! The results of a backend: its times over pairs with the reference, its errors over its own scenes, independent of
//! other backends.

use predicament_studies::Study;
use predicament_studies::compare::{
    ASKED_TWICE, BARELY, Compare, Compared, Measure, REFERENCE, Ratio, Share, left_out, standings, tradeoffs,
};
use predicament_studies::laws::Format;
use predicament_tasks::Contestant;
use proptest::prelude::*;

use crate::{backend, quiet};

fn row(input: usize, backend: &str, measure: &str, unit: &str, value: f64, of: u64) -> Measure {
    let [task, family] = ["orient2d", "family"].map(|word| format!("{word}{input}"));
    let words = [task, "near".to_owned(), family, backend.to_owned(), measure.to_owned(), unit.to_owned()];
    let [task, kind, family, backend, measure, unit] = words;
    Measure { task, kind, family, backend, measure, unit, value, low: value, high: value, of }
}

/// A backend on an input: scenes by class, wrong answers per hundred, and a time.
fn rows(input: usize, backend: &str, scenes: [u64; 5], wrong: u64, time: Option<f64>) -> Vec<Measure> {
    let asked: u64 = scenes.iter().sum();
    let n = |x: u64| f64::from(u32::try_from(x).unwrap());
    let names = ["not done", "right", "undecided", "rounded"];
    let mut all: Vec<Measure> =
        (0..4).map(|at| row(input, backend, names[at], "share of scenes", n(scenes[at]) / n(asked), asked)).collect();
    let answered = asked - scenes[0];
    if answered > 0 {
        all.push(row(input, backend, "wrong scenes", "per 1000 scenes", 1e3 * n(scenes[4]) / n(answered), answered));
        all.push(row(input, backend, "topology", "per 1000 scenes", 1e3 * n(scenes[4] / 2) / n(answered), answered));
        all.push(row(input, backend, "wrong answers", "per 10^6 answers", 1e4 * n(wrong), 100));
        all.push(row(input, backend, "in_band", "per 10^6 answers", 1e4 * n(100 - wrong) / 2.0, 100));
    }
    all.extend(time.map(|time| row(input, backend, "time", "ns a query", time, 7)));
    all
}

/// The ratio of a backend's times.
fn ratio(measures: &[Measure], backend: &str) -> Ratio {
    standings(measures).into_iter().find(|of| of.backend == backend).unwrap().time.unwrap()
}

/// A backend that declines slow inputs is not fast.
///
/// Means over its own inputs said 9 times as fast, although it takes a tenth more.
#[test]
fn times_are_compared_on_what_both_answered() {
    let mut measures = Vec::new();
    for (input, time) in [(0, 100.0), (1, 100.0), (2, 100.0), (3, 1e6), (4, 1e6)] {
        measures.extend(rows(input, REFERENCE, [0, 5, 0, 0, 0], 0, Some(time)));
        let is_easy = input < 3;
        let scenes = if is_easy { [0, 3, 2, 0, 0] } else { [5, 0, 0, 0, 0] };
        measures.extend(rows(input, "tolerance", scenes, 0, is_easy.then_some(1.1 * time)));
    }
    let mean = |backend: &str| {
        let times = measures.iter().filter(|row| row.backend == backend && row.measure == "time").map(|row| row.value);
        predicament_records::geometric_mean(times).unwrap()
    };
    assert!(mean("tolerance") < 0.05 * mean(REFERENCE), "means over own inputs mislead");
    let time = ratio(&measures, "tolerance");
    assert!((time.value - 1.1).abs() < 1e-12 && (time.pairs, time.of) == (3, 5), "{time:?}");
    assert_eq!(ratio(&measures, REFERENCE).value, 1.0);
    let tolerance = standings(&measures).remove(1);
    assert_eq!(tolerance.inputs, [3, 5]);
    let scenes = tolerance.scenes;
    assert_eq!([scenes.asked, scenes.right, scenes.undecided, scenes.wrong, scenes.not_done], [25, 9, 6, 0, 10]);
    assert_eq!((tolerance.laws, tolerance.answers), (Share { count: 0, of: 15 }, Share { count: 0, of: 300 }));
}

#[test]
fn inputs_that_barely_depend_on_predicates_are_left_out_and_named() {
    let mut measures = Vec::new();
    for (input, twice) in [(0, 1.9), (1, BARELY - 0.05), (2, BARELY)] {
        measures.extend(rows(input, REFERENCE, [0, 2, 0, 0, 0], 0, Some(100.0)));
        measures.extend(rows(input, "naive", [0, 1, 0, 0, 1], 7, Some(if input == 1 { 100.0 } else { 400.0 })));
        measures.push(row(input, REFERENCE, ASKED_TWICE, "times the time", twice, 7));
    }
    let time = ratio(&measures, "naive");
    assert!((time.value - 4.0).abs() < 1e-12 && (time.pairs, time.left_out, time.of) == (2, 1, 3), "{time:?}");
    assert_eq!(left_out(&measures).iter().map(|([task, ..], _)| *task).collect::<Vec<_>>(), ["orient2d1"]);
    let page = study(&[]).page(&Compared { measures, conditioning: Vec::new(), promises: Vec::new() });
    assert!(
        page.contains("barely depends on predicates are left out") && page.contains("orient2d1 near (1.05×)"),
        "{page}"
    );
    assert!(page.contains("2 of 3 inputs"), "{page}");
}

const BACKENDS: [&str; 7] = [REFERENCE, "tolerance", "tolerance:f32", "sos", "epsilon:1e-10", "epsilon:1e-12", "naive"];

/// Any results of all backends on four inputs.
fn any_measures() -> impl Strategy<Value = Vec<Measure>> {
    let one = (prop::array::uniform5(0_u64..4), 0_u64..100, prop::option::of(1.0_f64..1e4));
    let twice = prop::collection::vec(1.0_f64..2.0, 4);
    (prop::collection::vec(one, 4 * BACKENDS.len()), twice).prop_map(|(all, twice)| {
        let mut measures = Vec::new();
        for (at, (mut scenes, wrong, time)) in all.into_iter().enumerate() {
            scenes[1] += 1;
            let (input, backend) = (at / BACKENDS.len(), BACKENDS[at % BACKENDS.len()]);
            measures.extend(rows(input, backend, scenes, wrong, time));
        }
        measures.extend((0..4).map(|at| row(at, REFERENCE, ASKED_TWICE, "times the time", twice[at], 7)));
        measures
    })
}

proptest! {
    #[test]
    fn no_third_backend_changes_what_is_said(measures in any_measures(), removed in 1..BACKENDS.len()) {
        let removed = BACKENDS[removed];
        let rest: Vec<Measure> = measures.iter().filter(|row| row.backend != removed).cloned().collect();
        let (before, after) = (standings(&measures), standings(&rest));
        prop_assert_eq!(after.len(), BACKENDS.len() - 1);
        for of in &after {
            let same = before.iter().find(|other| other.backend == of.backend);
            prop_assert_eq!(Some(of), same);
        }
        // Members of a curve are compared only with each other.
        let (before, after) = (tradeoffs(&measures), tradeoffs(&rest));
        for of in after.iter().filter(|of| of.knob.is_none() && !of.backend.starts_with("epsilon:") || !removed.starts_with("epsilon:")) {
            let same = before.iter().find(|other| other.backend == of.backend);
            prop_assert_eq!(Some(of), same);
        }
    }
}

#[test]
fn only_a_parameter_that_is_turned_makes_a_curve() {
    let mut measures = Vec::new();
    for input in 0..3 {
        for backend in BACKENDS {
            // One member of the curve declines the last input: no member is shown on it.
            let is_declined = backend == "epsilon:1e-12" && input == 2;
            let scenes = if is_declined { [4, 0, 0, 0, 0] } else { [0, 2, 0, 0, 2] };
            measures.extend(rows(input, backend, scenes, 10, (!is_declined).then_some(50.0)));
        }
    }
    for of in tradeoffs(&measures) {
        let is_curve = of.backend.starts_with("epsilon:");
        assert_eq!(of.knob, is_curve.then_some("epsilon:"), "{of:?}");
        assert_eq!(of.time.map(|time| (time.pairs, time.of)), Some(if is_curve { (2, 2) } else { (3, 3) }), "{of:?}");
        assert_eq!(of.answers.of, if is_curve { 200 } else { 300 });
        assert_eq!(of.scenes, Share { count: if is_curve { 2 } else { 3 }, of: if is_curve { 8 } else { 12 } });
        assert_eq!(of.not_done.count, 0);
    }
    // Alone, it is a point over its own inputs.
    measures.retain(|row| row.backend != "epsilon:1e-10");
    let all = tradeoffs(&measures);
    let alone = all.iter().find(|of| of.backend == "epsilon:1e-12").unwrap();
    assert_eq!((alone.knob, alone.not_done), (None, Share { count: 4, of: 12 }));
}

fn study(tasks: &[&str]) -> Compare {
    Compare {
        backends: Vec::new(),
        tasks: tasks.iter().map(|task| (*task).to_owned()).collect(),
        scenes: 3,
        samples: 1,
        trials: 0,
        queries: 0,
        seed: 5,
        out: "nowhere".into(),
        format: Format::Csv,
    }
}

/// Every scene is in one class, and the reference is timed with each query computed twice.
#[test]
fn scenes_are_counted_once_and_inputs_are_timed_twice() {
    let names = ["exact", "tolerance", "sos:per-mesh", "epsilon:1e-4"];
    let backends = names.map(backend);
    let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
    let tasks = ["orient2d", "contacts2d", "delaunay2d", "slice"];
    let of = study(&tasks).survey(&backends, &quiet()).unwrap();
    // Without that measure no input is left out, however slow the machine is.
    let (twice, measures): (Vec<Measure>, Vec<Measure>) =
        of.measures.into_iter().partition(|row| row.measure == ASKED_TWICE);
    let all = standings(&measures);
    assert_eq!(all.iter().map(|of| of.backend).collect::<Vec<_>>(), names);
    for of in &all {
        let scenes = of.scenes;
        let parts = [scenes.right, scenes.undecided, scenes.rounded, scenes.wrong, scenes.not_done];
        assert_eq!(parts.iter().sum::<u64>(), scenes.asked, "{of:?}");
        assert_eq!(scenes.asked, all[0].scenes.asked, "{of:?}");
    }
    let [exact, tolerance, per_mesh, epsilon] = &all[..] else { panic!("{all:?}") };
    assert_eq!((exact.answers.count, exact.in_band.count, exact.scenes.undecided), (0, 0, 0));
    assert!(tolerance.scenes.undecided > 0 && tolerance.in_band.count > 0, "{tolerance:?}");
    assert!(per_mesh.scenes.not_done > per_mesh.scenes.asked / 2, "{per_mesh:?}");
    assert!(per_mesh.time.is_some_and(|time| time.pairs < per_mesh.inputs[1]), "{per_mesh:?}");
    assert!(epsilon.answers.count > 0 && epsilon.scenes.wrong > 0, "{epsilon:?}");
    // Signs of single queries have no laws.
    assert!(exact.laws.of > 0 && exact.laws.of < exact.scenes.asked, "{exact:?}");
    let inputs = measures.iter().filter(|row| row.measure == "not done" && row.backend == REFERENCE).count();
    assert_eq!(twice.len(), inputs);
    assert!(twice.iter().all(|row| row.backend == REFERENCE && row.value.is_finite() && row.value > 0.0), "{twice:?}");
}
