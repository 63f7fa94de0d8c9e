//! Both judges agree: on every family of queries, on constructed vertices of every kind, and on cascades of them.

use predicament_families::{self as families, Arrangement, Kind, Random, Trouble};
use predicament_judge::portable::{Number, orientation, points, scene_sign, sphere};
use predicament_judge::sign;
use predicament_predicates::{
    Axis, Construction, Dimension, Plane, PredicateKind, QuerySet, Question, Scene, Sign, Vertex,
};

use crate::random::effort;

/// Asserts that both judges agree on all queries, and returns the number of each sign.
fn agree(scene: &Scene, queries: &QuerySet) -> [usize; 3] {
    let mut seen = [0; 3];
    for query in 0..queries.len() {
        let (question, args) = (queries.question(), queries.args(query));
        let truth = sign(scene, question, args);
        assert_eq!(scene_sign(scene, question, args), Some(truth), "{} of {scene:?}", question.query(args));
        seen[usize::try_from(truth.as_i8() + 1).unwrap()] += 1;
    }
    seen
}

#[test]
fn both_judges_agree_on_every_family() {
    type Family = fn(PredicateKind, &mut Random, &mut Vec<f64>);
    let list: [(&str, Family); 8] = [
        ("uniform", families::uniform),
        ("grid", families::grid),
        ("near", |kind, rng, out| families::near(kind, 4, rng, out)),
        ("kettner", families::kettner),
        ("degenerate", families::degenerate),
        ("wide-scaled", families::wide_scaled),
        ("wide-mixed", families::wide_mixed),
        ("far", families::far),
    ];
    for kind in PredicateKind::ALL {
        let mut all = [0; 3];
        for (name, family) in list {
            let mut rng = Random::new(name, kind.name(), 1);
            let mut coordinates = Vec::new();
            (0..100 * effort()).for_each(|_| family(kind, &mut rng, &mut coordinates));
            let dimension = Dimension::of(families::native(kind)).unwrap();
            let scene = Scene::new(dimension, coordinates).unwrap();
            let queries = QuerySet::new(kind.first_question(), scene.vertices().collect());
            let seen = agree(&scene, &queries);
            assert!(name != "degenerate" || seen[1] == queries.len(), "{kind} {name}: {seen:?}");
            (0..3).for_each(|at| all[at] += seen[at]);
        }
        assert!(all.iter().all(|&count| count > 50), "{kind}: {all:?}");
    }
}

#[test]
fn both_judges_agree_on_constructed_vertices() {
    let kinds: [&[Kind]; 3] = [&[Kind::Ssi], &[Kind::Lpi], &[Kind::Tpi]];
    let mut seen = [0; 3];
    for (&kinds, trouble) in kinds
        .iter()
        .flat_map(|kinds| [Trouble::Uniform, Trouble::Near { ulps: 1 }, Trouble::Degenerate].map(|t| (kinds, t)))
    {
        for question in [
            Question::Compare(Axis::Y),
            Question::Orient2d(Plane::Xy),
            Question::Orient2d(Plane::Zx),
            Question::Orient3d,
        ] {
            let arrangement = Arrangement { kinds, trouble, halvings: 0 };
            let is_flat = arrangement.dimension() == Dimension::Two;
            if is_flat && !matches!(question, Question::Compare(_) | Question::Orient2d(Plane::Xy)) {
                continue;
            }
            let cloud =
                arrangement.queries(question, 40 * effort(), Random::new("portable", question.kind().name(), 2));
            let mut scene = Scene::new(arrangement.dimension(), cloud.coordinates).unwrap();
            cloud.constructions.into_iter().for_each(|construction| {
                scene.construct(construction).unwrap();
            });
            let queries = QuerySet::new(question, cloud.args.unwrap());
            let found = agree(&scene, &queries);
            assert!(trouble != Trouble::Degenerate || found[1] == queries.len(), "{kinds:?} {question:?}: {found:?}");
            (0..3).for_each(|at| seen[at] += found[at]);
        }
    }
    assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
}

#[test]
fn both_judges_agree_on_cascades_and_on_definitions_without_a_point() {
    let mut scene =
        Scene::from_points2(&[[0.0, 0.0], [7.0, 1.0], [1.0, 5.0], [6.0, 4.0], [3.0, -2.0], [-1.0, 2.0]]).unwrap();
    let (v, c) = (Vertex::input, Vertex::constructed);
    for lines in [[[v(0), v(3)], [v(1), v(2)]], [[v(0), v(1)], [v(4), v(2)]], [[c(0), c(1)], [v(5), v(4)]]] {
        scene.construct(Construction::Ssi(lines)).unwrap();
    }
    let all = [c(0), c(1), c(2), v(4), v(5)];
    for args in [[0, 1, 2], [2, 3, 4], [0, 2, 4], [1, 3, 4], [2, 1, 3]].map(|places| places.map(|at| all[at])) {
        agree(&scene, &QuerySet::new(Question::Orient2d(Plane::Xy), args.to_vec()));
    }
    agree(&scene, &QuerySet::new(Question::Incircle, vec![c(0), c(1), c(2), v(4), v(0), c(0), v(2), c(2)]));
    let parallel = scene.construct(Construction::Ssi([[v(0), c(1)], [v(1), v(0)]])).unwrap();
    assert_eq!(scene_sign(&scene, Question::Orient2d(Plane::Xy), &[parallel, v(0), v(2)]), None);
}

#[test]
fn integers_are_numbers_too() {
    let numbers: Vec<Number> = [i64::MIN, i64::MAX, 0, 1, i64::MAX, i64::MIN].map(Number::from).to_vec();
    let [a, b, c] = points(2, &numbers).try_into().unwrap();
    // (MIN − MAX)(1 − MIN) − (MAX − MIN)(0 − MAX), and both differences are 2^64 − 1.
    assert_eq!(orientation(&[&a, &b, &c]), Sign::Negative);
    assert_eq!(orientation(&[&b, &a, &c]), Sign::Positive);
    assert_eq!(orientation(&[&a, &a, &c]), Sign::Zero);
    let circle: Vec<Number> = [1, 0, 0, 1, -1, 0, 0, 0].map(Number::from).to_vec();
    let circle = points(2, &circle);
    assert_eq!(sphere(&circle.iter().collect::<Vec<_>>()), Sign::Positive, "the centre is inside");
    assert_eq!([f64::NAN, f64::INFINITY].map(Number::of), [None; 2]);
}
