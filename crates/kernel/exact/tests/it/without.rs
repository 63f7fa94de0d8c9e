//! The control without one device: its answers are those of `exact`, and what it lacks settles nothing.

use predicament_exact::without::{BATCH, DEVICES, DOUBLES, INTEGERS, NOTHING, PLAN, SEMI_STATIC, STATIC, Without};
use predicament_exact::{Exact, stage};
use predicament_predicates::{
    Backend, Batches, Counts, Dimension, Plane, PredicateKind, Predicates, Question, Scene, Sign, Vertex,
};

use crate::common::{Random, nudge};

/// The number of queries that each stage has settled, over all predicates.
type Settled = [u64; stage::NAMES.len()];

/// Scenes that need each stage: general ones, small integers, ties of many bits, near and wide ones; large ones, too.
fn scenes() -> Vec<Scene> {
    let mut random = Random(5);
    let mut scenes = Vec::new();
    for count in [150, 2100] {
        for kind in 0..7 {
            let mut point = || -> [f64; 3] {
                let [x, y, z] = [(); 3].map(|()| random.unit());
                match kind {
                    0 => [x, y, z],
                    1 => [x, y, z].map(|x| (x * 8.0).round()),
                    2 => [x, y, 0.5 * x + 0.25 * y].map(|x| (x * 1e6).round() * 0.125),
                    3 => [x, 0.3 * x + 0.1, nudge(0.3 * x + 0.7 * y, 1)],
                    4 => [x, x, y].map(|x| x * [1.0, f64::exp2(70.0), f64::exp2(-140.0)][random.below(3)]),
                    5 => {
                        let far = x * [1.0, f64::exp2(40.0)][random.below(2)];
                        [far, far, y]
                    }
                    _ => [x, y, z].map(|x| 1e17 + (x * 64.0).round() * 1024.0),
                }
            };
            let points: Vec<[f64; 3]> = (0..count).map(|_| point()).collect();
            scenes.push(Scene::from_points3(&points).unwrap());
            scenes.push(Scene::from_points2(&points.iter().map(|&[x, y, _]| [x, y]).collect::<Vec<_>>()).unwrap());
            scenes.push(Scene::from_points2(&points.iter().map(|&[x, _, z]| [x, z]).collect::<Vec<_>>()).unwrap());
        }
    }
    scenes
}

/// The answers of a backend about a scene, one by one and in batches, and the stages of either.
fn answers<B: Backend>(backend: &B, scene: &Scene) -> ([Vec<Sign>; 2], [Settled; 2]) {
    let questions: &[Question] = match scene.dimension() {
        Dimension::Two => &[Question::Orient2d(Plane::Xy), Question::Incircle],
        Dimension::Three => &[Question::Orient2d(Plane::Zx), Question::Orient3d, Question::Insphere],
    };
    let counts = [Counts::new(), Counts::new()];
    let [single, batch] = [0, 1].map(|at: usize| backend.prepare(scene, &counts[at]).unwrap());
    let mut random = Random(3);
    let mut signs = [Vec::new(), Vec::new()];
    for question in questions {
        // Neighbours in the list, and any vertices: some twice.
        let arity = question.kind().arity();
        let mut args: Vec<Vertex> = (0..60 * arity).map(Vertex::input).collect();
        args.retain(|v| v.index() < scene.len());
        args.truncate(args.len() / arity * arity);
        args.extend((0..60 * arity).map(|_| Vertex::input(random.below(scene.len().min(300)))));
        let mut out = vec![Sign::Zero; args.len() / arity];
        question.ask_singly(&single, &args, &mut out);
        signs[0].extend_from_slice(&out);
        question.ask_batch(&batch, &args, &mut out);
        signs[1].extend_from_slice(&out);
    }
    // One line and one plane with many points.
    let [a, b, c] = [3, 9, 1].map(Vertex::input);
    let points: Vec<Vertex> = (0..100).map(Vertex::input).collect();
    let mut out = vec![Sign::Zero; points.len()];
    let plane = if scene.dimension() == Dimension::Two { Plane::Xy } else { Plane::Yz };
    signs[0].extend(points.iter().map(|&p| single.orient2d(plane, a, b, p)));
    batch.orient2d_line(plane, [a, b], &points, &mut out);
    signs[1].extend_from_slice(&out);
    if scene.dimension() == Dimension::Three {
        signs[0].extend(points.iter().map(|&p| single.orient3d(a, b, c, p)));
        batch.orient3d_plane([a, b, c], &points, &mut out);
        signs[1].extend_from_slice(&out);
    }
    let settled = counts.each_ref().map(|counts| {
        std::array::from_fn(|stage| PredicateKind::DETERMINANTS.iter().map(|&kind| counts.get(kind, stage)).sum())
    });
    (signs, settled)
}

/// The sums over all scenes of what each stage settles without a device; the answers must be those of `exact`.
fn without<const DEVICE: usize>(scenes: &[Scene]) -> [Settled; 2] {
    let mut sums = [[0; stage::NAMES.len()]; 2];
    for (at, scene) in scenes.iter().enumerate() {
        let (signs, settled) = answers(&Without::<DEVICE>, scene);
        let (whole, of_whole) = answers(&Exact, scene);
        assert_eq!(whole[0], whole[1]);
        assert_eq!(signs, whole, "without {}, scene {at}", DEVICES[DEVICE]);
        if DEVICE == NOTHING {
            assert_eq!(settled, of_whole, "the control takes another way than `exact` in scene {at}");
        }
        for (sum, settled) in sums.iter_mut().zip(settled) {
            sum.iter_mut().zip(settled).for_each(|(sum, settled)| *sum += settled);
        }
    }
    sums
}

#[test]
fn answers_do_not_depend_on_a_device_and_what_is_left_out_settles_nothing() {
    let scenes = scenes();
    let whole = without::<NOTHING>(&scenes);
    // In singles and batches together, each stage but the comparison settles something: it can be missed.
    let seen = |stage: usize, of: &[Settled; 2]| of[0][stage] + of[1][stage];
    assert!((stage::DOUBLE..=stage::DYADIC).all(|stage| seen(stage, &whole) > 0), "{whole:?}");
    let lacks = |of: [Settled; 2], stages: &[usize]| {
        assert!(stages.iter().all(|&stage| seen(stage, &of) == 0), "{stages:?}: {of:?}");
    };
    lacks(without::<STATIC>(&scenes), &[stage::STATIC]);
    lacks(without::<SEMI_STATIC>(&scenes), &[stage::SEMI_STATIC]);
    lacks(without::<DOUBLES>(&scenes), &[stage::DOUBLE]);
    lacks(without::<INTEGERS>(&scenes), &[stage::INTEGER, stage::WIDE_INTEGER]);
    lacks(without::<PLAN>(&scenes), &[stage::STATIC, stage::WIDE_INTEGER]);
    let [single, batch] = without::<BATCH>(&scenes);
    assert!(single == batch && single == whole[0] && single != whole[1], "a batch is a loop: {single:?} {batch:?}");
}

#[test]
fn a_control_has_the_name_of_its_device_and_no_proof() {
    assert_eq!(Without::<SEMI_STATIC>.name(), "exact:without=semi-static");
    assert!(!Without::<PLAN>.contract(PredicateKind::Orient3d).proved);
    let batches = [Without::<BATCH>.batches(PredicateKind::Orient2d), Without::<PLAN>.batches(PredicateKind::Orient2d)];
    assert_eq!(batches, [Batches::Loop, Batches::Own]);
}
