//! A session's properties besides its signs: conventions, stages, refusals.

use crate::common::Random;
use crate::rational;
use predicament_exact::{Exact, Session, determinant, estimate, stage};
use predicament_predicates::{
    Axis, Backend, Construction, Counts, DefinitionError, MAX_STAGES, Off, Plane, PredicateKind, Predicates, Question,
    Scene, Sign, Tally, Vertex, ZeroMeaning,
};
use robust::{Coord, Coord3D};

fn v(index: usize) -> Vertex {
    Vertex::input(index)
}

fn prepare<'s, T: Tally + 's>(scene: &'s Scene, tally: T) -> Session<'s, T> {
    Exact.prepare(scene, tally).expect("every scene can be prepared")
}

#[test]
fn the_convention_is_that_of_robust() {
    let flat = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.25, 0.25]]).unwrap();
    let session = prepare(&flat, Off);
    assert_eq!(session.orient2d(Plane::Xy, v(0), v(1), v(2)), Sign::Positive, "counterclockwise");
    assert_eq!(session.incircle(v(0), v(1), v(2), v(3)), Sign::Positive, "inside");
    let solid =
        Scene::from_points3(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [0.1, 0.1, -0.1]])
            .unwrap();
    let session = prepare(&solid, Off);
    assert_eq!(session.orient3d(v(0), v(1), v(2), v(3)), Sign::Positive, "below");
    assert_eq!(session.insphere(v(0), v(1), v(2), v(3), v(4)), Sign::Positive, "inside");

    let mut random = Random(4);
    for _ in 0..1000 {
        let points: [[f64; 2]; 4] = random.points(Random::unit);
        let [a, b, c, d] = points.map(|[x, y]| Coord { x, y });
        let scene = Scene::from_points2(&points).unwrap();
        let session = prepare(&scene, Off);
        assert_eq!(session.orient2d(Plane::Xy, v(0), v(1), v(2)), Sign::of(robust::orient2d(a, b, c)));
        assert_eq!(session.incircle(v(0), v(1), v(2), v(3)), Sign::of(robust::incircle(a, b, c, d)));

        let points: [[f64; 3]; 5] = random.points(Random::unit);
        let [a, b, c, d, e] = points.map(|[x, y, z]| Coord3D { x, y, z });
        let scene = Scene::from_points3(&points).unwrap();
        let session = prepare(&scene, Off);
        assert_eq!(session.orient3d(v(0), v(1), v(2), v(3)), Sign::of(robust::orient3d(a, b, c, d)));
        assert_eq!(session.insphere(v(0), v(1), v(2), v(3), v(4)), Sign::of(robust::insphere(a, b, c, d, e)));
    }
}

/// Points with many ties, near ties, huge and tiny numbers.
fn mixed<const D: usize>(seed: u64, n: usize) -> Vec<[f64; D]> {
    let values = [0.0, -0.0, 1.0, 1.0f64.next_up(), 0.1, 0.3, 5e-324, 1e-200, 1e180, -2.0, 1e25];
    let mut random = Random(seed);
    (0..n).map(|_| random.points::<1, D>(|random| *random.pick(&values))[0]).collect()
}

#[test]
fn swapping_two_arguments_flips_every_sign() {
    let flat = Scene::from_points2(&mixed(5, 40)).unwrap();
    let solid = Scene::from_points3(&mixed(6, 40)).unwrap();
    let mut random = Random(7);
    for (scene, questions) in [
        (&flat, &[Question::Compare(Axis::Y), Question::Orient2d(Plane::Xy), Question::Incircle][..]),
        (&solid, &[Question::Compare(Axis::Z), Question::Orient2d(Plane::Zx), Question::Orient3d, Question::Insphere]),
    ] {
        let session = prepare(scene, Off);
        for &question in questions {
            for _ in 0..2000 {
                let mut args: Vec<Vertex> =
                    (0..question.kind().arity()).map(|_| v(random.below(scene.len()))).collect();
                let sign = question.ask(&session, &args);
                let (i, j) = (random.below(args.len()), random.below(args.len()));
                let expected = if i == j { sign } else { -sign };
                args.swap(i, j);
                assert_eq!(question.ask(&session, &args), expected, "{question:?} {args:?}");
            }
        }
    }
}

#[test]
fn every_query_is_tallied_once_where_it_was_decided() {
    let scene = Scene::from_points3(&mixed(8, 60)).unwrap();
    let counts = Counts::new();
    let session = prepare(&scene, &counts);
    let mut expected = [[0; stage::NAMES.len()]; PredicateKind::ALL.len()];
    let mut random = Random(9);
    for _ in 0..500 {
        let [a, b, c, d, e] = std::array::from_fn(|_| v(random.below(scene.len())));
        let decided = [
            (PredicateKind::Compare, session.decide_compare(Axis::X, a, b), session.compare(Axis::X, a, b)),
            (
                PredicateKind::Orient2d,
                session.decide_orient2d(Plane::Yz, a, b, c),
                session.orient2d(Plane::Yz, a, b, c),
            ),
            (PredicateKind::Orient3d, session.decide_orient3d(a, b, c, d), session.orient3d(a, b, c, d)),
            (PredicateKind::Insphere, session.decide_insphere(a, b, c, d, e), session.insphere(a, b, c, d, e)),
        ];
        for (kind, (sign, stage), asked) in decided {
            assert_eq!(sign, asked);
            expected[kind.index()][stage] += 1;
        }
    }
    for kind in PredicateKind::ALL {
        for (stage, name) in stage::NAMES.iter().enumerate() {
            assert_eq!(counts.get(kind, stage), expected[kind.index()][stage], "{kind} {name}");
        }
    }
    for stage in [stage::SEMI_STATIC, stage::INTEGER, stage::DYADIC] {
        assert!(expected.iter().any(|row| row[stage] > 0), "no query got to {}", stage::NAMES[stage]);
    }
}

/// The stage that settles the turn of three points, given other points in the scene.
fn settled(points: [[f64; 2]; 3], others: &[[f64; 2]]) -> (Sign, usize) {
    let scene = Scene::from_points2(&[&points, others].concat()).unwrap();
    prepare(&scene, Off).decide_orient2d(Plane::Xy, v(0), v(1), v(2))
}

#[test]
fn each_stage_settles_what_it_can_prove() {
    let turn = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let tie = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]];
    let uneven_tie = [[0.0, 0.0], [1.0 + f64::EPSILON, 1.0 + f64::EPSILON], [1.0, 1.0]];
    let tiny_tie = uneven_tie.map(|p| p.map(|x| x * 2f64.powi(-1000)));
    let far_tie = [[0.0, 0.0], [1e17, 1e17], [1.0, 1.0]];
    let [long, wide] = [[[1.0 + f64::EPSILON, 0.5]], [[5e-324, f64::MAX]]];
    assert_eq!(settled(turn, &[]), (Sign::Positive, stage::SEMI_STATIC), "its own filter, before anything is planned");
    assert_eq!(settled(tie, &[]), (Sign::Zero, stage::DOUBLE), "short numbers: floats make no error");
    assert_eq!(settled(turn, &long), (Sign::Positive, stage::SEMI_STATIC));
    let long_turn = [[1e-20, 0.0], [1.0, 0.0], [0.0, 1.0]];
    assert_eq!(settled(long_turn, &[]), (Sign::Positive, stage::SEMI_STATIC));
    assert_eq!(settled(long_turn, &[[1e20, 0.1]]), (Sign::Positive, stage::SEMI_STATIC));
    assert_eq!(settled(uneven_tie, &[]), (Sign::Zero, stage::INTEGER));
    assert_eq!(settled(tiny_tie, &[]), (Sign::Zero, stage::INTEGER), "no float can be trusted, but all fits");
    assert_eq!(settled(far_tie, &[[0.5, 0.25]]), (Sign::Zero, stage::INTEGER), "59 bits: no double differences");
    assert_eq!(settled(far_tie, &[[0.5, 1e-3]]), (Sign::Zero, stage::INTEGER), "in a unit of its own");
    let long_tie = [[0.0, 0.0], [1e17, 1e17], [0.3, 0.3]];
    assert_eq!(settled(long_tie, &[]), (Sign::Zero, stage::WIDE_INTEGER), "112 bits");
    let cluster = [[1e17, 1e17], [1e17 + 16.0, 1e17 + 16.0], [1e17 + 32.0, 1e17 + 32.0]];
    assert_eq!(settled(cluster, &[[0.5, 1e-3]]), (Sign::Zero, stage::INTEGER));
    let flat_tie = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.1], [2.0, 2.0, 0.2], [3.0, 3.0, 0.7]];
    for (other, stage) in [([0.5, 1e-3, 1e10], stage::INTEGER), ([0.5, 1e-3, 1e3], stage::INTEGER)] {
        let scene = Scene::from_points3(&[&flat_tie[..], &[other]].concat()).unwrap();
        assert_eq!(prepare(&scene, Off).decide_orient3d(v(0), v(1), v(2), v(3)), (Sign::Zero, stage));
    }
    let long_tie = [[1e17, 1e17, 0.1], [1.0, 1.0, 1e-3], [0.3, 0.3, 7.7], [0.0, 0.0, 0.0]];
    let scene = Scene::from_points3(&long_tie).unwrap();
    assert_eq!(prepare(&scene, Off).decide_orient3d(v(0), v(1), v(2), v(3)), (Sign::Zero, stage::WIDE_INTEGER));
    // Scenes that are too wide for anything but the points alone.
    assert_eq!(settled(turn, &wide), (Sign::Positive, stage::SEMI_STATIC));
    assert_eq!(settled(long_turn, &wide), (Sign::Positive, stage::SEMI_STATIC));
    assert_eq!(settled(uneven_tie, &wide), (Sign::Zero, stage::INTEGER), "in a unit of its own");
    let wide_tie = [[0.0, 0.0], [1e200, 1e-200], [2e200, 2e-200]];
    assert_eq!(settled(wide_tie, &[]), (Sign::Zero, stage::INTEGER), "differences are doubles");
    let longest_tie = [[0.1, 0.1], [1e200, 1e200], [3.0, 3.0]];
    assert_eq!(settled(longest_tie, &[]), (Sign::Zero, stage::DYADIC));
}

/// Overflow and underflow that would make a filter without a guard answer wrongly.
#[test]
fn the_filter_does_not_answer_where_nothing_is_proved() {
    // The products underflow to zero, although zero looks exact.
    let below = [[1e-200, 0.0], [0.0, 1e-200], [0.0, 0.0]];
    assert_eq!(estimate::orient2d(below[0], below[1], below[2]).certain(determinant::ORIENT2D.bound), Some(Sign::Zero));
    assert_eq!(settled(below, &[]), (Sign::Positive, stage::INTEGER));
    // ∞ − ∞.
    let above = [[1e200, 1e200], [1e200, 2e200], [0.0, 0.0]];
    assert!(estimate::orient2d(above[0], above[1], above[2]).determinant.is_nan());
    assert_eq!(settled(above, &[]), (Sign::Positive, stage::INTEGER));
}

#[test]
fn values_are_the_determinants() {
    let value = rational::orient2d([3.0, 0.0], [0.0, 0.5], [0.0, 0.0]);
    assert_eq!(value.to_rational(), 1.5);
    assert!((value.log2() - 1.5f64.log2()).abs() < 1e-11);
    // In units of the least double: a negative corner, and a point outside its sphere. Rows minus the last one,
    // eliminated by hand, leave diag(1, 1, -1, -10).
    let tiny = rational::insphere([5e-324, 0.0, 0.0], [0.0, 5e-324, 0.0], [0.0, 0.0, -5e-324], [0.0; 3], [1e-323; 3]);
    assert_eq!(tiny.sign(), Sign::Positive);
    assert_eq!(tiny.to_rational() << (5 * 1074), 10);
    assert!((tiny.log2() - (10f64.log2() - 5.0 * 1074.0)).abs() < 1e-11);
    assert_eq!(rational::orient3d([0.0; 3], [1.0; 3], [2.0; 3], [4.0; 3]).log2(), f64::NEG_INFINITY);
}

#[test]
fn what_the_scene_lacks_is_declined() {
    use PredicateKind::{Compare, Incircle, Insphere, Orient2d, Orient3d};
    let flat = Scene::from_points2(&[[0.0; 2]]).unwrap();
    let solid = Scene::from_points3(&[[0.0; 3]]).unwrap();
    for (scene, declined) in [(&flat, &[Orient3d, Insphere][..]), (&solid, &[Incircle])] {
        let session = prepare(scene, Off);
        for kind in PredicateKind::ALL {
            let answer = session.supports(kind);
            assert_eq!(answer.is_err(), declined.contains(&kind), "{kind}");
            if let Err(reason) = answer {
                assert_eq!(reason.predicate, Some(kind));
            }
        }
    }
    assert_eq!(prepare(&flat, Off).supports(Compare), Ok(()));
    assert_eq!(prepare(&flat, Off).supports(Orient2d), Ok(()));
}

#[test]
fn the_backend_introduces_itself() {
    assert_eq!(Exact.name(), "exact");
    assert_eq!(Exact.stages(), stage::NAMES);
    assert!(Exact.stages().len() <= MAX_STAGES);
    for kind in PredicateKind::ALL {
        let contract = Exact.contract(kind);
        assert!(contract.proved && contract.zero == ZeroMeaning::Exact);
    }
}

/// The static filter alone answers exactly if it is the settling stage, with the same sign.
#[test]
fn the_static_filter_alone_is_the_first_stage() {
    let mut random = Random(12);
    let mut counts = [0_usize; 2];
    for round in 0..200 {
        let mut points: [[f64; 3]; 5] = random.points(Random::unit);
        if round % 2 == 0 {
            // The last one is near the plane of the first three.
            let [a, b, c, d, _] = &mut points;
            *d = [0, 1, 2].map(|axis: usize| a[axis] + 0.25 * (b[axis] - a[axis]) + 0.5 * (c[axis] - a[axis]));
        }
        let mut scene = Scene::from_points3(&points).unwrap();
        let x = scene.construct(Construction::Lpi { line: [v(3), v(4)], plane: [v(0), v(1), v(2)] }).unwrap();
        let session = prepare(&scene, Off);
        for [a, b, c, d] in [[0, 1, 2, 3], [3, 1, 0, 2], [0, 1, 2, 4], [4, 3, 1, 0]].map(|of| of.map(v)) {
            let decided = session.decide_orient3d(a, b, c, d);
            let expected = (decided.1 == stage::STATIC).then_some(decided);
            assert_eq!(session.filter_orient3d(a, b, c, d), expected, "{points:?} {a} {b} {c} {d}");
            counts[usize::from(expected.is_some())] += 1;
        }
        // The static filter handles input vertices only.
        assert_eq!(session.filter_orient3d(v(0), v(1), v(3), x), None);
    }
    assert!(counts.iter().all(|&count| count > 150), "{counts:?}");
}

/// A session on top of this one refuses a definition by its index and its reason, and nothing of the batch remains.
#[test]
fn definitions_that_are_not_accepted_are_refused() {
    let square =
        Scene::from_points2(&[[0.0, 0.0], [4.0, 4.0], [0.0, 4.0], [4.0, 0.0], [0.0, 2.0], [4.0, 2.0]]).unwrap();
    let mut session = prepare(&square, Off);
    let of = |lines: [[usize; 2]; 2]| Construction::Ssi(lines.map(|line| line.map(v)));
    let [first, second] = [of([[0, 1], [2, 3]]), of([[4, 5], [0, 1]])];
    let without_4 = |definition: &Construction| {
        let has_4 = definition.flats().flatten().any(|&vertex| vertex == v(4));
        if has_4 { Err(DefinitionError::Other("not about vertex 4".into())) } else { Ok(()) }
    };
    let refused = session.construct_where(&[first, second], without_4).unwrap_err();
    assert_eq!(refused.index(), Some(1));
    assert!(refused.to_string().ends_with("not about vertex 4"), "{refused}");
    assert_eq!(session.scene(), &square);
    let found = session.construct_where(&[first], without_4).unwrap();
    assert_eq!(session.orient2d(Plane::Xy, v(4), v(5), found[0]), Sign::Zero, "(2, 2) is on the line");
    // Existing definitions are not checked again.
    assert_eq!(
        session.construct_where(&[first], |_| Err(DefinitionError::Other("nothing new".into()))).unwrap(),
        found
    );
}
