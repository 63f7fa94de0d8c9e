//! Delaunay triangulations compared with the definition, in any order of insertion, and after removals.

use predicament_delaunay::algorithm::{
    Delaunay2, Triangulation, delaunay2d, delaunay2d_in_order, delaunay2d_in_strips,
};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Counts, MAX_STAGES, Off, Plane, PredicateKind, Predicates, Scene, Sign, Vertex};
use predicament_sos::Sos;
use proptest::prelude::*;

#[allow(clippy::cast_precision_loss)] // small integers
fn scene(points: &[[i64; 2]]) -> Scene {
    Scene::from_points2(&points.iter().map(|point| point.map(|x| x as f64)).collect::<Vec<_>>()).unwrap()
}

/// The canonical triangulation by definition: each triple with an empty circle is in a face; a face is a fan from its
/// smallest vertex. It uses brute force alone.
fn by_definition(session: &dyn Predicates) -> Delaunay2 {
    let scene = session.scene();
    let is_same = |v: Vertex, w: Vertex| {
        [predicament_predicates::Axis::X, predicament_predicates::Axis::Y]
            .into_iter()
            .all(|axis| session.compare(axis, v, w) == Sign::Zero)
    };
    let mut places: Vec<Vertex> = Vec::new();
    let mut copies = Vec::new();
    for v in scene.vertices() {
        match places.iter().find(|&&w| is_same(v, w)) {
            Some(&w) => copies.push([v, w]),
            None => places.push(v),
        }
    }
    let mut triangles = Vec::new();
    for &a in &places {
        for &b in places.iter().filter(|&&b| b > a) {
            for &c in places.iter().filter(|&&c| c > a && c != b) {
                if session.orient2d(Plane::Xy, a, b, c) != Sign::Positive {
                    continue;
                }
                let side = |&d: &Vertex| {
                    if d == a || d == b || d == c { Sign::Negative } else { session.incircle(a, b, c, d) }
                };
                if places.iter().any(|d| side(d) == Sign::Positive) {
                    continue;
                }
                let face: Vec<Vertex> =
                    places.iter().copied().filter(|d| side(d) == Sign::Zero || [a, b, c].contains(d)).collect();
                // The triangle is in the fan from its smallest vertex: no other vertex of the face is between b and c.
                let is_beyond =
                    |&d: &Vertex| [a, b, c].contains(&d) || session.orient2d(Plane::Xy, b, c, d) == Sign::Positive;
                if face[0] == a && face.iter().all(is_beyond) {
                    triangles.push([a, b, c]);
                }
            }
        }
    }
    triangles.sort_unstable();
    let mut chain = Vec::new();
    if triangles.is_empty() {
        chain.clone_from(&places);
        let key = |v: &Vertex| (scene.point(*v).to_vec(), *v);
        chain.sort_by(|v, w| key(v).partial_cmp(&key(w)).unwrap());
        if copies.is_empty() && session.scene().len() > 1 {
            // The order of vertices of a session that breaks ties.
            let order = |v: Vertex, w: Vertex| match session.compare(predicament_predicates::Axis::X, v, w) {
                Sign::Zero => session.compare(predicament_predicates::Axis::Y, v, w),
                sign => sign,
            };
            chain.sort_by(|&v, &w| if v == w { std::cmp::Ordering::Equal } else { order(v, w).as_i8().cmp(&0) });
        }
    }
    Delaunay2 { triangles, chain, copies, ..Delaunay2::default() }
}

/// The tested orders of n vertices.
fn orders(n: usize) -> Vec<Vec<Vertex>> {
    let all: Vec<Vertex> = (0..n).map(Vertex::input).collect();
    let back = all.iter().rev().copied().collect();
    let mut shuffled = all.clone();
    shuffled.sort_by_key(|v| v.index().wrapping_mul(0x9e37_79b9) % 1009);
    vec![all, back, shuffled]
}

fn is_by_definition(points: &[[i64; 2]]) {
    let scene = scene(points);
    let sos = Sos::default();
    let exact = Exact.prepare(&scene, Off).unwrap();
    let sos = sos.prepare(&scene, Off).unwrap();
    for session in [&exact as &dyn Predicates, &sos] {
        let expected = by_definition(session);
        assert_eq!(delaunay2d(session).answer(), expected, "{points:?}");
        for strips in 2..=4 {
            assert_eq!(delaunay2d_in_strips(session, strips).answer(), expected, "{points:?} in {strips} strips");
        }
        for order in orders(points.len()) {
            assert_eq!(delaunay2d_in_order(session, &order).answer(), expected, "{points:?} by {order:?}");
        }
    }
}

#[test]
fn few_repeated_and_collinear_points_are_triangulated() {
    for points in [
        &[][..],
        &[[3, 4]],
        &[[3, 4], [3, 4], [3, 4]],
        &[[3, 4], [0, 0]],
        &[[2, 2], [0, 0], [1, 1], [2, 2], [0, 0]],
        &[[0, 5], [0, 1], [0, 3]],
        &[[0, 0], [4, 0], [0, 3]],
        &[[0, 0], [1, 0], [2, 0], [3, 0], [1, 1], [1, 0]],
        &[[0, 0], [2, 0], [1, 0], [1, 1], [2, 2], [0, 2], [0, 1]],
        // Twelve points on one circle, and its centre.
        &[[5, 0], [4, 3], [3, 4], [0, 5], [-3, 4], [-4, 3], [-5, 0], [-4, -3], [-3, -4], [0, -5], [3, -4], [4, -3]],
        &[
            [5, 0],
            [4, 3],
            [3, 4],
            [0, 5],
            [-3, 4],
            [-4, 3],
            [-5, 0],
            [-4, -3],
            [-3, -4],
            [0, -5],
            [3, -4],
            [4, -3],
            [0, 0],
        ],
    ] {
        is_by_definition(points);
    }
}

#[test]
fn any_order_gives_the_same_triangles() {
    // A grid of 900 places in 1,000 points, and a ring in it.
    let points: Vec<[i64; 2]> = (0..1000_i64).map(|i| [i * 7 % 30, i * 11 / 30 % 30]).collect();
    let scene = scene(&points);
    let sos = Sos::default();
    let exact = Exact.prepare(&scene, Off).unwrap();
    let sos = sos.prepare(&scene, Off).unwrap();
    for session in [&exact as &dyn Predicates, &sos] {
        let expected = delaunay2d(session).answer();
        assert!(expected.triangles.len() > 500 && expected.broken.is_none());
        for strips in [2, 5, 16] {
            assert_eq!(delaunay2d_in_strips(session, strips).answer(), expected, "{strips} strips");
        }
        for order in orders(points.len()) {
            assert_eq!(delaunay2d_in_order(session, &order).answer(), expected);
        }
    }
}

/// Rings and random points: long hulls, and flips far into a strip.
#[test]
fn strips_of_uneven_points_are_joined() {
    let ring = |i: i64, radius: i64| {
        #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)] // rounds to integers
        [f64::cos, f64::sin].map(|of| (of(i as f64) * radius as f64) as i64)
    };
    for points in [
        (0..400).map(|i| ring(i, 1000)).collect::<Vec<_>>(),
        (0..400).map(|i| ring(i, i * i)).collect(),
        (0..400).map(|i| [i % 7 * 100, i * 7919 % 1009]).collect(),
        (0..400).map(|i| [i * i % 401, i * 7919 % 1009]).collect(),
    ] {
        let scene = scene(&points);
        let exact = Exact.prepare(&scene, Off).unwrap();
        let expected = delaunay2d_in_strips(&exact, 1).answer();
        for strips in 2..8 {
            assert_eq!(delaunay2d_in_strips(&exact, strips).answer(), expected, "{strips} strips");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(1500)))]

    #[test]
    fn small_integers_have_the_triangulation_of_the_definition(
        points in (1_i64..9).prop_flat_map(|side| prop::collection::vec([0..=side, 0..=side], 0..22))
    ) {
        is_by_definition(&points);
    }

    #[test]
    fn what_is_removed_and_inserted_again_leaves_no_trace(
        points in (1_i64..9).prop_flat_map(|side| prop::collection::vec([0..=side, 0..=side], 1..30)),
        steps in prop::collection::vec(any::<prop::sample::Index>(), 1..60),
        perturbed: bool,
    ) {
        let scene = scene(&points);
        let sos = Sos::default();
        let exact = Exact.prepare(&scene, Off).unwrap();
        let sos = sos.prepare(&scene, Off).unwrap();
        let session: &dyn Predicates = if perturbed { &sos } else { &exact };
        let mut present: Vec<bool> = vec![true; points.len()];
        let mut triangulation = delaunay2d(session);
        for step in steps {
            let at = step.index(points.len());
            let v = Vertex::input(at);
            if present[at] {
                triangulation.remove(session, v).unwrap();
            } else {
                triangulation.insert(session, v).unwrap();
            }
            present[at] = !present[at];
            let left: Vec<Vertex> = scene.vertices().filter(|v| present[v.index()]).collect();
            triangulation.cut_faces();
            prop_assert_eq!(triangulation.answer(), delaunay2d_in_order(session, &left).answer());
        }
    }
}

#[test]
fn walks_past_fans_are_short() {
    // Points within two ulps of a line, across a power of two: thousands of triangles there share a vertex.
    let n = 40_000;
    let mut state = 1_u64;
    let mut next = |below: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % below
    };
    let mut point = || {
        let x = 0.5 + f64::from(u32::try_from(next(1 << 31)).expect("31 bits")) / f64::from(1 << 27);
        [x, f64::from_bits(x.to_bits() + next(5) - 2)]
    };
    let scene = Scene::from_points2(&(0..n).map(|_| point()).collect::<Vec<_>>()).unwrap();
    let counts = Counts::new();
    let session = Exact.prepare(&scene, &counts).unwrap();
    assert!(delaunay2d(&session).count() > n);
    let asked: u64 = (0..MAX_STAGES).map(|stage| counts.get(PredicateKind::Orient2d, stage)).sum();
    assert!(asked < 14 * n as u64, "{asked} orient2d for {n} points");
}

#[test]
fn what_is_not_there_is_not_removed() {
    let scene = scene(&[[0, 0], [4, 0], [0, 3], [1, 1]]);
    let session = Exact.prepare(&scene, Off).unwrap();
    let three: Vec<Vertex> = scene.vertices().take(3).collect();
    let mut triangulation = delaunay2d_in_order(&session, &three);
    let before = triangulation.answer();
    assert!(triangulation.remove(&session, Vertex::input(3)).is_err());
    assert_eq!(triangulation.answer(), before);
    assert!(Triangulation::default().remove(&session, Vertex::input(0)).is_err());
}
