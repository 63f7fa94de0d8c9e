//! Verdicts that backends share: an outcome depends on the scene and its backend alone.

use predicament_oracle::roster::DEFAULT;
use predicament_oracle::run_spoiled;
use predicament_tasks::{AnyCase, Budget, Outcome, Watch, run};

use crate::common::{suite, task, with_case};

/// Small scenes of the tasks whose judges share verdicts: some with ties and findings, some that all backends answer
/// alike. Before them is a check that finds a spoiled answer: one promise may forbid the fault, and another allow it.
const SCENES: [(&str, &str, &[&str]); 4] = [
    (
        "intersections",
        "triangle without area",
        &["tetrahedra", "touching-tips", "chimney", "sliver-through-a-cube", "shared-edge"],
    ),
    (
        "overlays",
        "loop orientation",
        &["crossings-within-an-ulp-sweep", "many-through-one-point-grid", "shared-edge", "identical"],
    ),
    (
        "slices",
        "triangle without area",
        &["open-box", "cube-along-a-face", "tetrahedron-by-a-vertex", "pencil-of-planes-apart"],
    ),
    ("snaps", "ends", &["fine-naive", "twice-and-crossed-snap", "a-point-and-halves-iterated"]),
];

/// Each backend with its honest answer and with each spoiled one.
type Answered<'a> = (&'a str, Option<usize>);

/// The outcomes of some answers, all judged with one case.
fn outcomes(answered: &[Answered<'_>], case: &dyn AnyCase, watch: &Watch) -> Vec<Outcome> {
    let faults = case.task().spoiled_answers();
    let of = |&(name, spoiled): &Answered<'_>| {
        let backend = predicament_bundle::backend(name).unwrap();
        match spoiled {
            None => run(case, backend.as_ref(), Budget::QUICK, watch).unwrap(),
            Some(at) => run_spoiled(case, faults[at].as_ref(), backend.as_ref(), Budget::QUICK, watch).unwrap(),
        }
    };
    answered.iter().map(of).collect()
}

#[test]
fn an_outcome_does_not_depend_on_other_backends() {
    let mut findings = 0;
    for (of, check, names) in SCENES {
        let scenes = suite(of);
        for loaded in names.iter().map(|name| scenes.iter().find(|loaded| loaded.name == **name).expect(name)) {
            let faults = task(loaded).spoiled_answers();
            let is_caught = |at: &usize| faults[*at].caught_by().iter().any(|catch| catch.1 == check);
            let spoiled: Vec<usize> = (0..faults.len()).filter(is_caught).collect();
            let of_backend = |&name: &&'static str| {
                let spoiled = spoiled.iter().map(move |&at| (name, Some(at)));
                [(name, None)].into_iter().chain(spoiled).collect::<Vec<_>>()
            };
            let mut answered: Vec<Answered<'_>> = DEFAULT.iter().flat_map(of_backend).collect();
            let of_all = |answered: &[Answered<'_>]| with_case(loaded, |case, watch| outcomes(answered, case, watch));
            let mut alone: Vec<Outcome> = answered.iter().flat_map(|one| of_all(&[*one])).collect();
            findings += alone.iter().filter(|outcome| !outcome.findings.is_empty()).count();
            assert_eq!(of_all(&answered), alone, "{}", loaded.name);
            answered.reverse();
            alone.reverse();
            assert_eq!(of_all(&answered), alone, "{}", loaded.name);
        }
    }
    assert!(findings > 20, "{findings}");
}
