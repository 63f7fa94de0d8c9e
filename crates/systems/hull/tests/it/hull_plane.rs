//! Convex hulls in the plane, compared with the definition.

use predicament_exact::Exact;
use predicament_hull::algorithm::{Hull2, PlaneMethod, hull2d};
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use predicament_sos::Sos;
use proptest::prelude::*;

use crate::common::by_definition;

const METHODS: [PlaneMethod; 2] = [PlaneMethod::Chain, PlaneMethod::Divide];

fn hulls(session: &dyn Predicates) -> [Hull2; 2] {
    METHODS.map(|method| hull2d(session, method))
}

#[allow(clippy::cast_precision_loss)] // small integers
fn scene(points: &[[i64; 2]]) -> Scene {
    Scene::from_points2(&points.iter().map(|point| point.map(|x| x as f64)).collect::<Vec<_>>()).unwrap()
}

fn is_by_definition(points: &[[i64; 2]]) {
    let scene = scene(points);
    let expected: Vec<Vertex> = by_definition::plane(points).into_iter().map(Vertex::input).collect();
    for hull in hulls(&Exact.prepare(&scene, Off).unwrap()) {
        assert_eq!(hull, Hull2 { vertices: expected.clone(), broken: None }, "{points:?}");
    }
}

#[test]
fn few_repeated_and_collinear_points_have_hulls() {
    for points in [
        &[][..],
        &[[3, 4]],
        &[[3, 4], [3, 4], [3, 4]],
        &[[3, 4], [0, 0]],
        &[[2, 2], [0, 0], [1, 1], [2, 2], [0, 0]],
        &[[0, 5], [0, 1], [0, 3]],
        &[[0, 0], [2, 0], [1, 0], [1, 1], [2, 2], [0, 2], [0, 1]],
    ] {
        is_by_definition(points);
    }
}

#[test]
fn an_octagon_throws_away_what_is_inside_only() {
    // A disc of lattice points: many on each edge of the hull and of the octagon.
    let disc = |radius: i64| {
        let all = (-radius..=radius).flat_map(move |x| (-radius..=radius).map(move |y| [x, y]));
        all.filter(move |[x, y]| x * x + y * y <= radius * radius).collect::<Vec<_>>()
    };
    for points in
        [disc(6), disc(8), (0..100).map(|i| [i % 10, i / 10]).collect(), (0..100).map(|i| [i, 2 * i]).collect()]
    {
        assert!(points.len() >= 100);
        is_by_definition(&points);
    }
}

#[test]
fn perturbed_points_have_one_hull() {
    let grid: Vec<[i64; 2]> = (0..100).map(|i| [i % 7, i / 11]).collect();
    let scene = scene(&grid);
    let sos = Sos::default();
    let session = sos.prepare(&scene, Off).unwrap();
    let [chain, divide] = hulls(&session);
    assert_eq!(chain, divide);
    assert_eq!(chain.broken, None);
    let corners = by_definition::plane(&grid).len();
    assert!(chain.vertices.len() > corners, "{} vertices, {corners} without the perturbation", chain.vertices.len());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(2000)))]

    #[test]
    fn small_integers_have_the_hull_of_the_definition(
        points in (1_i64..9).prop_flat_map(|side| prop::collection::vec([0..=side, 0..=side], 0..90))
    ) {
        is_by_definition(&points);
    }
}
