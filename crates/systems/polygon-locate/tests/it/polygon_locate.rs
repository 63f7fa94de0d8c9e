//! Tests of ray casting against winding numbers, and of the guarantees of the index and the parallel driver.

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use crate::common::maps::problem;
use crate::common::rings::{grid_points, rings, ulp_points};
use crate::common::turns::{banded, one_flip};
use crate::common::winding::{Truth, brute_force, with};
use predicament_controls::Naive;
use predicament_exact::Exact;
use predicament_mesh::PolygonMap;
use predicament_polygon_locate::algorithm::{CHUNK, LocateIndex, Locations, Scratch, locate_all, question_all};
use predicament_predicates::{Axis, Backend, Off, Plane, Predicates, Scene, Sign, Vertex};
use predicament_sos::Sos;
use predicament_tolerance::Tolerance;
use proptest::prelude::*;

fn located<P: Predicates>(map: &PolygonMap, session: &P) -> Locations {
    let scene = session.scene();
    let queries: Vec<Vertex> = scene.vertices().collect();
    locate_all(&LocateIndex::new(map, scene), session, &queries, &|_| true)
}

/// The number of queries for which a session differs from brute force.
fn disagreements<P: Predicates>(map: &PolygonMap, session: &P) -> usize {
    let answers = located(map, session);
    assert!(answers.is_complete());
    let scene = session.scene();
    let wrong = |(at, q): &(usize, Vertex)| {
        let truths = brute_force(map, scene, *q);
        answers.inside(*at) != with(&truths, Truth::Inside) || answers.boundary(*at) != with(&truths, Truth::Boundary)
    };
    scene.vertices().enumerate().filter(wrong).count()
}

fn check_exact(map: &PolygonMap, scene: &Scene) {
    assert_eq!(disagreements(map, &Exact.prepare(scene, Off).unwrap()), 0);
}

/// Checks that the perturbed answer is the exact answer for a query on no boundary. For a query on a boundary it is
/// still an answer, unless the query is that very vertex.
fn check_perturbed(map: &PolygonMap, scene: &Scene) {
    let sos = Sos::default();
    let answers = located(map, &sos.prepare(scene, Off).unwrap());
    let of_map: Vec<Vertex> = map.edges().flat_map(|(_, ends)| ends).collect();
    for (at, q) in scene.vertices().enumerate() {
        let truths = brute_force(map, scene, q);
        if with(&truths, Truth::Boundary).is_empty() {
            assert_eq!(answers.inside(at), with(&truths, Truth::Inside), "at {q}");
        }
        if !of_map.contains(&q) {
            assert!(answers.boundary(at).is_empty(), "ties are broken at {q}");
        }
    }
}

const SQUARE: [[f64; 2]; 4] = [[0., 0.], [4., 0.], [4., 4.], [0., 4.]];

#[test]
fn the_figure_of_the_paper() {
    // Figure 2's cases: below a vertex between two edges, inside under a
    // vertex, and beside; a diamond and one point for each
    let points = [[0., 2.], [2., 0.], [4., 2.], [2., 4.], [2., 2.], [2., -1.], [0., 0.], [4., 1.], [4., 2.], [1., 1.]];
    let (map, scene) = problem(&points, &[vec![vec![0, 1, 2, 3]]]);
    let session = Exact.prepare(&scene, Off).unwrap();
    let answers = located(&map, &session);
    let inside: Vec<usize> = (0..points.len()).filter(|&at| answers.inside(at) == [0]).collect();
    let boundary: Vec<usize> = (0..points.len()).filter(|&at| answers.boundary(at) == [0]).collect();
    assert_eq!(inside, [4]);
    assert_eq!(boundary, [0, 1, 2, 3, 8, 9]);
    check_exact(&map, &scene);
    check_perturbed(&map, &scene);
}

#[test]
fn vertical_edges_are_touched_but_never_crossed() {
    let mut points = SQUARE.to_vec();
    for x in [0., 2., 4.] {
        points.extend([-1., 0., 2., 4., 5.].map(|y: f64| [x, y]));
    }
    let (map, scene) = problem(&points, &[vec![vec![0, 1, 2, 3]]]);
    let session = Exact.prepare(&scene, Off).unwrap();
    let answers = located(&map, &session);
    let column = |from: usize| -> String {
        let letter = |at: usize| match (answers.inside(at), answers.boundary(at)) {
            ([0], []) => 'i',
            ([], [0]) => 'b',
            ([], []) => '.',
            _ => '?',
        };
        (from..from + 5).map(letter).collect()
    };
    assert_eq!([column(4), column(9), column(14)], [".bbb.", ".bib.", ".bbb."]);
}

#[test]
fn borders_are_shared_and_double_use_cancels() {
    let points = [[0., 0.], [1., 0.], [2., 0.], [2., 1.], [1., 1.], [0., 1.]];
    // two cells side by side, and one region that uses its middle edge twice
    let cells = vec![vec![vec![0, 1, 4, 5]], vec![vec![1, 2, 3, 4]], vec![vec![0, 1, 4, 5], vec![1, 2, 3, 4]]];
    let (map, scene) = problem(&points, &cells);
    let index = LocateIndex::new(&map, &scene);
    assert_eq!((index.len(), index.regions()), (7, 3));
    let owners = |a: usize, b: usize| {
        let edge = index.edges().find(|&edge| [[a, b], [b, a]].contains(&index.ends(edge).map(Vertex::index)));
        index.owners(edge.expect("an edge of the map"))
    };
    assert_eq!(owners(0, 1), [0, 2]);
    assert_eq!(owners(1, 4), [0, 1]);
    assert_eq!(owners(3, 4), [1, 2]);
    let x = |v: Vertex| scene.coordinate(Axis::X, v);
    assert!(index.edges().map(|edge| index.ends(edge)).all(|[u, v]| (x(u), u) < (x(v), v)), "from left to right");
    assert!(LocateIndex::new(&PolygonMap::new(), &scene).is_empty());
}

#[test]
fn rings_inside_rings() {
    let ring = |r: f64| [[-r, -r], [r, -r], [r, r], [-r, r]];
    let mut points: Vec<[f64; 2]> = [ring(8.), ring(4.), ring(2.)].concat();
    points.extend([[0., 0.], [3., 0.], [6., 0.], [9., 0.], [3., 3.], [2., 2.], [-4., 1.]]);
    let rings: Vec<Vec<usize>> = vec![vec![0, 1, 2, 3], vec![4, 5, 6, 7], vec![8, 9, 10, 11]];
    // land with a lake that has an island; the lake as a region of its own
    let (map, scene) = problem(&points, &[rings.clone(), rings[1..].to_vec()]);
    check_exact(&map, &scene);
    check_perturbed(&map, &scene);
    let answers = located(&map, &Exact.prepare(&scene, Off).unwrap());
    let inside: Vec<&[u32]> = (12..16).map(|at| answers.inside(at)).collect();
    assert_eq!(inside, [&[0][..], &[1], &[0], &[]]);
}

#[test]
fn the_answer_does_not_depend_on_threads_or_chunks() {
    let (map, scene) = lattice(60);
    let session = Exact.prepare(&scene, Off).unwrap();
    let index = LocateIndex::new(&map, &scene);
    let queries: Vec<Vertex> = (0..3 * CHUNK + 17).map(|at| Vertex::input(at % scene.len())).collect();
    let with_threads = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| locate_all(&index, &session, &queries, &|_| true))
    };
    let all = with_threads(1);
    assert!(all.is_complete() && all.len() == queries.len());
    assert_eq!(with_threads(2), all);
    assert_eq!(with_threads(5), all);
    let mut scratch = Scratch::new();
    for (&q, location) in queries.iter().zip(all.iter()) {
        assert_eq!(index.locate(&session, q, &mut scratch), location);
    }
}

#[test]
fn progress_counts_up_and_can_stop() {
    let (map, scene) = lattice(20);
    let session = Exact.prepare(&scene, Off).unwrap();
    let index = LocateIndex::new(&map, &scene);
    let queries = vec![Vertex::input(7); 20 * CHUNK];
    let most = AtomicUsize::new(0);
    let whole = locate_all(&index, &session, &queries, &|done| {
        most.fetch_max(done, Relaxed);
        true
    });
    assert_eq!((whole.len(), most.into_inner()), (queries.len(), queries.len()));

    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let part = pool.install(|| locate_all(&index, &session, &queries, &|done| done < 3 * CHUNK));
    assert!(!part.is_complete());
    assert!(part.len().is_multiple_of(CHUNK) && part.len() <= 3 * CHUNK);
    assert!(part.iter().zip(whole.iter()).all(|(a, b)| a == b));
    assert!(locate_all(&index, &session, &[], &|_| false).is_complete());
}

/// A map of n × n unit cells with integer corners; the corners come first.
fn lattice(n: usize) -> (PolygonMap, Scene) {
    #[allow(clippy::cast_precision_loss)] // small
    let points: Vec<[f64; 2]> =
        (0..(n + 1) * (n + 1)).map(|at| [(at % (n + 1)) as f64, (at / (n + 1)) as f64]).collect();
    let cell = |at: usize| {
        let corner = at % n + at / n * (n + 1);
        vec![vec![corner, corner + 1, corner + n + 2, corner + n + 1]]
    };
    problem(&points, &(0..n * n).map(cell).collect::<Vec<_>>())
}

#[test]
fn one_wrong_sign_is_seen() {
    // a diamond, and a square: raw coordinates force the side of its top edge
    let diamond = [[0., 2.], [2., 0.], [4., 2.], [2., 4.], [1., 2.5], [1., 5.]];
    let square = [[0., 0.], [4., 0.], [4., 4.], [0., 4.], [1., 1.], [1., 5.]];
    // by the shortcut, and with every edge asked about
    let planted = |points: &[[f64; 2]], flipped: [usize; 3]| {
        let (map, scene) = problem(points, &[vec![vec![0, 1, 2, 3]]]);
        let session = one_flip(&scene, flipped.map(Vertex::input));
        let index = LocateIndex::new(&map, &scene);
        let queries: Vec<Vertex> = scene.vertices().collect();
        [locate_all, question_all].map(|locate| {
            let answers = locate(&index, &session, &queries, &|_| true);
            let wrong = |&(at, q): &(usize, Vertex)| {
                let truths = brute_force(&map, &scene, q);
                answers.inside(at) != with(&truths, Truth::Inside)
                    || answers.boundary(at) != with(&truths, Truth::Boundary)
            };
            scene.vertices().enumerate().filter(wrong).map(|(at, _)| at).collect::<Vec<_>>()
        })
    };
    assert!(planted(&diamond, [0, 1, 2]).iter().all(Vec::is_empty), "a triple that is never asked");
    assert_eq!(planted(&diamond, [0, 3, 4]), [vec![4], vec![4]], "the inner point under the left top edge");
    assert_eq!(planted(&square, [2, 3, 4]), [vec![], vec![4]], "under the top edge, whose box does not hold it");
}

/// A board of quads over shared vertices, whose corners are displaced so far that they coincide, fold over and line up.
fn shaken_board() -> impl Strategy<Value = (PolygonMap, Scene)> {
    const N: usize = 7;
    let shake = prop::array::uniform2((0..3_i32).prop_map(f64::from));
    prop::collection::vec(shake, (N + 1) * (N + 1)).prop_map(|shakes| {
        #[allow(clippy::cast_precision_loss)] // small
        let corner = |(at, [dx, dy]): (usize, [f64; 2])| [(at % (N + 1)) as f64 + dx, (at / (N + 1)) as f64 + dy];
        let mut points: Vec<[f64; 2]> = shakes.into_iter().enumerate().map(corner).collect();
        let halves = |at: i32| [f64::from(at % 11) - 0.5, f64::from(at / 11) / 2.0];
        points.extend((0..220).map(halves));
        let cell = |at: usize| {
            let corner = at % N + at / N * (N + 1);
            vec![vec![corner, corner + 1, corner + N + 2, corner + N + 1]]
        };
        problem(&points, &(0..N * N).map(cell).collect::<Vec<_>>())
    })
}

/// The rule of 4.2, with every query to the session about every edge.
fn ask_everything<P: Predicates>(index: &LocateIndex, session: &P, q: Vertex) -> [Vec<u32>; 2] {
    let mut odd = vec![false; index.regions()];
    let mut touched = vec![false; index.regions()];
    for edge in index.edges() {
        let [u, v] = index.ends(edge);
        let [of_u, of_v] = [u, v].map(|v| session.compare(Axis::X, v, q));
        let past = [of_u, of_v].map(|of| of != Sign::Positive);
        let [left, right] = if of_u > of_v { [v, u] } else { [u, v] };
        let (crosses, touches) = if of_u == of_v {
            let [a, b] = [u, v].map(|v| session.compare(Axis::Y, v, q));
            (false, of_u.is_zero() && a * b != Sign::Positive)
        } else if of_u * of_v == Sign::Positive {
            (false, false)
        } else {
            let side = session.orient2d(Plane::Xy, left, right, q);
            (past[0] != past[1] && side == Sign::Negative, side.is_zero())
        };
        for &region in index.owners(edge) {
            odd[region as usize] ^= crosses;
            touched[region as usize] |= touches;
        }
    }
    let regions =
        |is: &dyn Fn(usize) -> bool| (0..).zip(0..odd.len()).filter(|&(_, at)| is(at)).map(|(r, _)| r).collect();
    [regions(&|at| odd[at] && !touched[at]), regions(&|at| touched[at])]
}

#[test]
fn a_point_far_below_a_steep_edge_is_not_on_it() {
    // A point in line with the edge from 0 to 1 by the scene's tolerance, and a point just as near to its line, beside
    // the edge itself.
    let width = 2f64.powi(-46);
    let points = [[1., 3.], [1. + width, 4.], [3., 3.5], [0., 0.], [1. + width / 2., 0.5], [1. + width / 2., 3.25]];
    let (map, scene) = problem(&points, &[vec![vec![0, 1, 2]]]);
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let [below, beside] = [4, 5].map(Vertex::input);
    assert_eq!(session.orient2d(Plane::Xy, Vertex::input(0), Vertex::input(1), below), Sign::Zero);
    let index = LocateIndex::new(&map, &scene);
    let mut scratch = Scratch::new();
    for (q, boundary) in [(below, &[][..]), (beside, &[0])] {
        let location = index.question(&session, q, &mut scratch);
        assert_eq!((location.inside, location.boundary), (&[][..], boundary), "{q}, all asked");
        let location = index.locate(&session, q, &mut scratch);
        assert_eq!((location.inside, location.boundary), (&[][..], boundary), "{q}");
    }
}

/// Checks for sessions of all kinds that queries decided by coordinates can be left out, and that the library's own
/// method of querying everything equals that of this test.
fn check_against_asking_everything(map: &PolygonMap, scene: &Scene) {
    fn check<P: Predicates>(map: &PolygonMap, session: &P) {
        let index = LocateIndex::new(map, session.scene());
        let mut scratch = Scratch::new();
        for q in session.scene().vertices() {
            let [inside, boundary] = ask_everything(&index, session, q);
            let location = index.locate(session, q, &mut scratch);
            assert_eq!((location.inside, location.boundary), (&inside[..], &boundary[..]), "at {q}");
            let location = index.question(session, q, &mut scratch);
            assert_eq!((location.inside, location.boundary), (&inside[..], &boundary[..]), "at {q}, all asked");
        }
    }
    let exact = || Exact.prepare(scene, Off).unwrap();
    check(map, &exact());
    check(map, &Sos::default().prepare(scene, Off).unwrap());
    check(map, &Naive::default().prepare(scene, Off).unwrap());
    // within a row, across rows, and everything
    for reach in [1e-12, 0.25, 1.5, 1e300] {
        check(map, &banded(scene, reach));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(8, 600)))]

    #[test]
    fn what_coordinates_force_need_not_be_asked_on_shaken_boards((map, scene) in shaken_board()) {
        check_against_asking_everything(&map, &scene);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(600)))]

    #[test]
    fn crossing_and_winding_agree_on_grids(points in grid_points(), regions in rings(12)) {
        let (map, scene) = problem(&points, &regions);
        check_exact(&map, &scene);
        check_perturbed(&map, &scene);
    }

    #[test]
    fn crossing_and_winding_agree_within_ulps(points in ulp_points(), regions in rings(12)) {
        let (map, scene) = problem(&points, &regions);
        check_exact(&map, &scene);
        check_perturbed(&map, &scene);
    }

    #[test]
    fn what_coordinates_force_need_not_be_asked(points in grid_points(), regions in rings(12)) {
        let (map, scene) = problem(&points, &regions);
        check_against_asking_everything(&map, &scene);
    }

    #[test]
    fn what_coordinates_force_need_not_be_asked_within_ulps(points in ulp_points(), regions in rings(12)) {
        let (map, scene) = problem(&points, &regions);
        check_against_asking_everything(&map, &scene);
    }
}
