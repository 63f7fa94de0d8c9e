//! Verdicts that backends share: an outcome depends on the scene and its backend alone.

use predicament_oracle::roster::DEFAULT;
use predicament_oracle::run_spoiled;
use predicament_tasks::{AnyCase, Budget, Outcome, Watch, run};

use crate::common::{suite, task, with_case};

/// Small scenes of the tasks whose judges share verdicts: some with ties and findings, some that all backends answer
/// alike.
const SCENES: [(&str, &[&str]); 4] = [
    ("intersections", &["tetrahedra", "touching-tips", "chimney", "sliver-through-a-cube", "shared-edge"]),
    ("overlays", &["crossings-within-an-ulp-sweep", "many-through-one-point-grid", "shared-edge", "identical"]),
    ("slices", &["open-box", "cube-along-a-face", "tetrahedron-by-a-vertex", "pencil-of-planes-apart"]),
    ("snaps", &["fine-naive", "twice-and-crossed-snap", "a-point-and-halves-iterated"]),
];

/// The outcomes of all backends, of honest answers and of spoiled ones.
fn outcomes(backends: &[&str], spoiled: &[usize], case: &dyn AnyCase, watch: &Watch) -> Vec<Outcome> {
    let faults = case.task().spoiled_answers();
    let of = |name: &&str| {
        let backend = predicament_bundle::backend(name).unwrap();
        let honest = run(case, backend.as_ref(), Budget::QUICK, watch).unwrap();
        let spoiled =
            |&at: &usize| run_spoiled(case, faults[at].as_ref(), backend.as_ref(), Budget::QUICK, watch).unwrap();
        [honest].into_iter().chain(spoiled.iter().map(spoiled).collect::<Vec<_>>()).collect::<Vec<_>>()
    };
    backends.iter().flat_map(of).collect()
}

#[test]
fn an_outcome_does_not_depend_on_other_backends() {
    let mut findings = 0;
    for (of, names) in SCENES {
        let scenes = suite(of);
        for loaded in names.iter().map(|name| scenes.iter().find(|loaded| loaded.name == **name).expect(name)) {
            // Answers with a fault that one promise forbids and another allows.
            let faults = task(loaded).spoiled_answers();
            let without_area =
                |at: &usize| faults[*at].caught_by().iter().any(|catch| catch.1 == "triangle without area");
            let spoiled: Vec<usize> = (0..faults.len()).filter(without_area).collect();
            let mut backends = DEFAULT.to_vec();
            let of_all = |backends: &[&str]| with_case(loaded, |case, watch| outcomes(backends, &spoiled, case, watch));
            let alone: Vec<Outcome> = backends.iter().flat_map(|backend| of_all(&[backend])).collect();
            findings += alone.iter().filter(|outcome| !outcome.findings.is_empty()).count();
            assert_eq!(of_all(&backends), alone, "{}", loaded.name);
            backends.reverse();
            let of_each = 1 + spoiled.len();
            let backwards: Vec<Outcome> = of_all(&backends).chunks(of_each).rev().flatten().cloned().collect();
            assert_eq!(backwards, alone, "{}", loaded.name);
        }
    }
    assert!(findings > 20, "{findings}");
}
