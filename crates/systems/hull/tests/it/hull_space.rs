//! Convex hulls in space, compared with the definition.

use predicament_exact::Exact;
use predicament_hull::algorithm::{Hull3, SpaceMethod, hull3d};
use predicament_predicates::{Backend, Off, Predicates, Scene};
use predicament_sos::Sos;
use proptest::prelude::*;

use crate::common::by_definition;

const METHODS: [SpaceMethod; 2] = [SpaceMethod::Incremental, SpaceMethod::Divide];

fn hulls(session: &dyn Predicates) -> [Hull3; 2] {
    METHODS.map(|method| hull3d(session, method))
}

#[allow(clippy::cast_precision_loss)] // small integers
fn scene(points: &[[i64; 3]]) -> Scene {
    Scene::from_points3(&points.iter().map(|point| point.map(|x| x as f64)).collect::<Vec<_>>()).unwrap()
}

fn is_by_definition(points: &[[i64; 3]]) {
    let scene = scene(points);
    let (vertices, faces) = by_definition::space(points);
    let expected = Hull3 { vertices, faces, broken: None };
    for (hull, method) in hulls(&Exact.prepare(&scene, Off).unwrap()).into_iter().zip(METHODS) {
        assert_eq!(hull, expected, "{method:?} of {points:?}");
    }
}

/// The hull of perturbed points is simplicial, the same by both methods, and a sphere.
fn is_simplicial(points: &[[i64; 3]], sos: Sos) {
    let scene = scene(points);
    let session = sos.prepare(&scene, Off).unwrap();
    let [incremental, divide] = hulls(&session);
    assert_eq!(incremental, divide, "{points:?}");
    assert_eq!(incremental.broken, None);
    if points.len() > 3 {
        assert!(incremental.faces.iter().all(|face| face.len() == 3));
        assert_eq!(incremental.faces.len(), 2 * incremental.vertices.len() - 4);
    }
}

/// A lattice of points.
fn lattice(side: i64) -> Vec<[i64; 3]> {
    (0..side * side * side).map(|i| [i % side, i / side % side, i / (side * side)]).collect()
}

#[test]
fn few_repeated_collinear_and_coplanar_points_have_hulls() {
    for points in [
        &[][..],
        &[[3, 4, 5]],
        &[[3, 4, 5], [3, 4, 5]],
        &[[1, 1, 1], [0, 0, 0], [2, 2, 2], [2, 2, 2], [0, 0, 0]],
        &[[0, 0, 1], [0, 0, 0], [0, 0, 2]],
        &[[0, 0, 0], [1, 2, 3], [2, 5, 1]],
        &[[0, 1, 0], [0, 1, 1], [0, 0, 1], [0, 0, 0], [0, 0, 0]],
        &[[0, 1, 2], [1, 2, 0], [2, 0, 1], [3, 0, 0], [0, 3, 0], [1, 1, 1]],
    ] {
        is_by_definition(points);
        is_simplicial(points, Sos::default());
    }
}

#[test]
fn a_lattice_has_six_faces() {
    let points = lattice(6);
    let scene = scene(&points);
    for hull in hulls(&Exact.prepare(&scene, Off).unwrap()) {
        assert_eq!((hull.vertices.len(), hull.faces.len(), hull.broken), (8, 6, None));
        assert!(hull.faces.iter().all(|face| face.len() == 4));
    }
    is_simplicial(&points, Sos::default());
}

#[test]
fn parts_of_many_faces_are_stitched() {
    // Points of a paraboloid, cospherical in groups, and of a cone: hulls with few points inside.
    let bowl: Vec<[i64; 3]> =
        (0_i64..400).map(|i| [i % 20, i / 20, (i % 20 - 9).pow(2) + (i / 20 - 7).pow(2)]).collect();
    let cone: Vec<[i64; 3]> = (0_i64..90).flat_map(|i| [[i, i * i, 0], [i, i * i, i]]).collect();
    for points in [bowl, cone] {
        let scene = scene(&points);
        let [incremental, divide] = hulls(&Exact.prepare(&scene, Off).unwrap());
        assert_eq!((incremental.broken, divide.broken), (None, None));
        assert_eq!(incremental, divide);
        assert!(incremental.vertices.len() > 90);
        is_simplicial(&points, Sos::default());
    }
}

#[test]
fn a_box_in_the_middle_takes_nothing_of_the_hull() {
    // More points than the filter needs: a lattice, the corners of which are the hull; points in a cube and in a ball,
    // some of them twice; and a needle along a diagonal.
    let mut state = 7_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        i64::try_from(state >> 44).unwrap() - (1 << 19)
    };
    let cube: Vec<[i64; 3]> = (0..5000).map(|_| [next(), next(), next()]).collect();
    let is_in_ball = |point: &&[i64; 3]| point.iter().map(|x| x * x).sum::<i64>() < 1 << 38;
    let ball: Vec<[i64; 3]> = cube.iter().filter(is_in_ball).flat_map(|&point| [point, point, point]).collect();
    let needle: Vec<[i64; 3]> = cube.iter().map(|&[x, y, z]| [x, x + y / 4096, x + z / 4096]).collect();
    for points in [lattice(17), cube, ball, needle] {
        assert!(points.len() > 4096);
        let scene = scene(&points);
        let [incremental, divide] = hulls(&Exact.prepare(&scene, Off).unwrap());
        assert_eq!((incremental.broken, divide.broken), (None, None));
        assert_eq!(incremental, divide);
        is_simplicial(&points, Sos::default());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(50, 2000)))]

    #[test]
    fn small_integers_have_the_hull_of_the_definition(
        points in (1_i64..7, 1_i64..7, 0_i64..7)
            .prop_flat_map(|(x, y, z)| prop::collection::vec([0..=x, 0..=y, 0..=z], 0..70))
    ) {
        is_by_definition(&points);
    }

    #[test]
    fn perturbed_points_have_one_hull(
        points in (1_i64..6).prop_flat_map(|side| prop::collection::vec([0..=side, 0..=side, 0..=side], 0..60))
    ) {
        is_simplicial(&points, Sos::default());
    }
}
