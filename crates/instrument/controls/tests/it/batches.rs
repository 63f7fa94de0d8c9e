//! Batches of controls equal single queries, bit for bit.

use predicament_controls::{Epsilon, Naive, Pivot, Shewchuk};
use predicament_predicates::{
    Axis, Backend, Batches, Construction, Counts, Off, Plane, PredicateKind, Predicates, QuerySet, Question, Scene,
    Sign, Vertex,
};
use proptest::prelude::*;

const POINTS: usize = 50;

/// Coordinates whose determinants are rounded, underflow, overflow or are NaN.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -1.0..1.0_f64,
        // Small integers, which give ties.
        4 => (-2..3_i32).prop_map(f64::from),
        // Near a line, so that signs depend on the order of the operations.
        4 => (0..1000_u32).prop_map(|ulps| f64::from(ulps) * f64::EPSILON + 0.5),
        1 => (-50..50_i32).prop_map(|units| f64::from(units) * f64::from_bits(1)),
        1 => (-1.0..1.0_f64).prop_map(|x| x * 1e-160),
        1 => (-1.0..1.0_f64).prop_map(|x| x * f64::MAX),
        1 => (-1.0..1.0_f64).prop_map(|x| x * 1e100),
        1 => prop::sample::select(vec![0.0, -0.0, f64::MIN_POSITIVE, f64::MAX, f64::MIN]),
    ]
}

fn points<const D: usize>() -> impl Strategy<Value = Vec<[f64; D]>> {
    prop::collection::vec(prop::array::uniform(coordinate()), POINTS)
}

/// The vertices of many queries; vertices beyond the points are constructed, if the scene has constructed vertices.
fn vertices() -> impl Strategy<Value = Vec<usize>> {
    // Full and partial blocks of 64 queries.
    prop::collection::vec(0..POINTS + 2, 0..900)
}

fn questions(scene: &Scene) -> Vec<Question> {
    let all = [
        Question::Compare(Axis::X),
        Question::Compare(Axis::Y),
        Question::Compare(Axis::Z),
        Question::Orient2d(Plane::Xy),
        Question::Orient2d(Plane::Yz),
        Question::Orient2d(Plane::Zx),
        Question::Orient3d,
        Question::Incircle,
        Question::Insphere,
    ];
    let is_flat = scene.dimension().count() == 2;
    let fits = |question: &Question| match question {
        Question::Compare(Axis::Z) | Question::Orient2d(Plane::Yz | Plane::Zx) => !is_flat,
        _ => scene.has_dimension_for(question.kind()).is_ok(),
    };
    all.into_iter().filter(fits).collect()
}

/// Compares batches of a backend with its single queries.
fn check(backend: &impl Backend, scene: &Scene, vertices: &[usize]) {
    let (counts, session) = (Counts::new(), backend.prepare(scene, Off).unwrap());
    let counted = backend.prepare(scene, &counts).unwrap();
    for question in questions(scene) {
        let takes_constructed = !matches!(question, Question::Incircle | Question::Insphere);
        let vertex = |&at: &usize| match at.checked_sub(POINTS) {
            Some(index) if takes_constructed && index < scene.constructions().len() => Vertex::constructed(index),
            Some(_) => Vertex::input(at - POINTS),
            None => Vertex::input(at),
        };
        let whole = vertices.len() - vertices.len() % question.kind().arity();
        let queries = QuerySet::new(question, vertices[..whole].iter().map(vertex).collect());
        let mut out = vec![Sign::Zero; queries.len()];
        queries.ask_batch(&session, 0..queries.len(), &mut out);
        for (at, &sign) in out.iter().enumerate() {
            let one = question.ask(&session, queries.args(at));
            assert_eq!(sign, one, "{}: {question:?} of {:?}", backend.name(), queries.args(at));
        }
        let before = counts.get(question.kind(), 0);
        queries.ask_batch(&counted, 0..queries.len(), &mut out);
        assert_eq!(counts.get(question.kind(), 0) - before, queries.len() as u64, "tallied");
    }
}

fn check_all(scene: &Scene, vertices: &[usize]) {
    for pivot in [Pivot::Last, Pivot::First, Pivot::Homogeneous] {
        check(&Naive { pivot }, scene, vertices);
    }
    check(&Epsilon::default(), scene, vertices);
    check(&Epsilon::new(0.25).unwrap(), scene, vertices);
    check(&Shewchuk, scene, vertices);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn of_the_plane(points in points::<2>(), vertices in vertices()) {
        check_all(&Scene::from_points2(&points).unwrap(), &vertices);
    }

    #[test]
    fn of_space(points in points::<3>(), vertices in vertices()) {
        check_all(&Scene::from_points3(&points).unwrap(), &vertices);
    }

    #[test]
    fn of_constructed_vertices(points in points::<2>(), vertices in vertices()) {
        let mut scene = Scene::from_points2(&points).unwrap();
        let v = Vertex::input;
        for lines in [[[v(0), v(1)], [v(2), v(3)]], [[v(4), v(5)], [v(6), v(7)]]] {
            scene.construct(Construction::Ssi(lines)).unwrap();
        }
        check_all(&scene, &vertices);
    }
}

#[test]
fn vertices_that_the_scene_lacks_are_refused_as_by_single_queries() {
    let scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
    let naive = Naive::default();
    let session = naive.prepare(&scene, Off).unwrap();
    let v = Vertex::input;
    let ask = |c: usize| {
        let mut out = [Sign::Zero];
        std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            session.orient2d_batch(Plane::Xy, &[[v(0), v(1), v(c)]], &mut out);
        }))
        .map(|()| out[0])
    };
    assert_eq!(ask(2).unwrap(), Sign::Positive);
    assert!(ask(3).is_err(), "the scene has three points");
    let mut out = [Sign::Zero];
    let solid = std::panic::AssertUnwindSafe(|| session.compare_batch(Axis::Z, &[[v(0), v(1)]], &mut out));
    assert!(std::panic::catch_unwind(solid).is_err(), "the scene has two axes");
}

#[test]
fn who_has_batches_of_its_own_says_so() {
    for kind in PredicateKind::ALL {
        for pivot in [Pivot::Last, Pivot::First] {
            assert_eq!(Naive { pivot }.batches(kind), Batches::Own);
        }
        assert_eq!(Epsilon::default().batches(kind), Batches::Own);
        assert_eq!(Naive { pivot: Pivot::Homogeneous }.batches(kind), Batches::Loop);
        assert_eq!(Shewchuk.batches(kind), Batches::Loop);
    }
}
