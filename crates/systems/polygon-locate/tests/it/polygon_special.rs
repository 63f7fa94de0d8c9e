//! Tests of the paper's own test against the generic code, and of both against winding numbers.

use crate::common::agreement::{Probed, grid, sign_of_d};
use crate::common::rings::{grid_points, rings, ulp_points};
use crate::common::turns::one_flip;
use predicament_exact::Exact;
use predicament_polygon_locate::algorithm::special::{OnEdge, Point, crosses, locate};
use predicament_polygon_locate::algorithm::{LocateIndex, Scratch, locate_all_specially};
use predicament_predicates::{Backend, Off, Plane, Predicates, Sign, Vertex};
use predicament_sos::Sos;
use proptest::prelude::*;

const SQUARE: [[f64; 2]; 4] = [[0., 0.], [4., 0.], [4., 4.], [0., 4.]];
const DIAMOND: [[f64; 2]; 4] = [[0., 2.], [2., 0.], [4., 2.], [2., 4.]];

#[test]
fn the_steps_of_the_paper_edge_by_edge() {
    let never = |_, _, _| -> Sign { panic!("decided without D") };
    let edge = [[0., 0.], [4., 2.]];
    let back = [edge[1], edge[0]];
    for ends in [edge, back] {
        for x in [-1., 4., 5.] {
            assert_eq!(crosses([x, 0.], ends, never), Ok(false), "step 3: {x} is not in [0, 4)");
        }
        assert_eq!(crosses([0., -1.], ends, sign_of_d), Ok(true), "straight below the left end");
        assert_eq!(crosses([2., 0.5], ends, sign_of_d), Ok(true));
        assert_eq!(crosses([2., 1.5], ends, sign_of_d), Ok(false));
        assert_eq!(crosses([2., 1.], ends, sign_of_d), Err(OnEdge));
        assert_eq!(crosses([0., 0.], ends, sign_of_d), Err(OnEdge), "the left end");
        assert_eq!(crosses([4., 2.], ends, never), Ok(false), "the right end is not reported");
    }
    assert_eq!(crosses([0., 1.], [[0., 0.], [0., 4.]], never), Ok(false), "step 1");
}

#[test]
fn step_5_reports_boundaries_by_half() {
    let reported = |corners: &[[f64; 2]]| {
        let probed = Probed::new(corners, &[vec![vec![0, 1, 2, 3]]], &[]);
        let on = |p: &Point| locate(&probed.map, &probed.scene, *p, &sign_of_d) == [Err(OnEdge)];
        grid(0., 4., 2.).into_iter().filter(on).collect::<Vec<_>>()
    };
    // all of the lower and upper edge except their right ends; nothing of the vertical edges
    assert_eq!(reported(&SQUARE), [[0., 0.], [2., 0.], [0., 4.], [2., 4.]]);
    // every vertex but the rightmost
    assert_eq!(reported(&DIAMOND), [[2., 0.], [0., 2.], [2., 4.]]);
}

#[test]
fn both_codes_agree_on_all_small_triangles() {
    let corners = grid(0., 4., 2.);
    let places = grid(-1., 5., 1.);
    for [a, b, c] in tuples(corners.len()).step_by(predicament_effort::some_or_all(2, 1)) {
        Probed::new(&[corners[a], corners[b], corners[c]], &[vec![vec![0, 1, 2]]], &places).check();
    }
}

#[test]
fn both_codes_agree_on_all_small_quadrangles() {
    let corners = grid(0., 4., 2.);
    let places = grid(0., 4., if predicament_effort::whole() { 1. } else { 2. });
    // With a neighbour that shares two of the vertices. One in four by default: nine is odd, so every corner occurs in
    // every position.
    for [a, b, c, d] in tuples(corners.len()).step_by(predicament_effort::some_or_all(4, 1)) {
        let points = [corners[a], corners[b], corners[c], corners[d]];
        Probed::new(&points, &[vec![vec![0, 1, 2, 3]], vec![vec![0, 2, 1]]], &places).check();
    }
}

/// All tuples of numbers below `n`.
fn tuples<const N: usize>(n: usize) -> impl Iterator<Item = [usize; N]> {
    let count = (0..N).fold(1, |count, _| count * n);
    (0..count).map(move |mut at| {
        std::array::from_fn(|_| {
            let digit = at % n;
            at /= n;
            digit
        })
    })
}

#[test]
fn many_queries_are_located_as_one_by_one() {
    let places = grid(-1., 5., 0.5);
    let probed = Probed::new(&[SQUARE, DIAMOND].concat(), &[vec![vec![0, 1, 2, 3]], vec![vec![4, 5, 6, 7]]], &places);
    let index = LocateIndex::new(&probed.map, &probed.scene);
    let queries: Vec<Vertex> = (0..9000).map(|at| probed.probes(at % places.len())[at % 2]).collect();
    let all = locate_all_specially(&index, &probed.scene, &sign_of_d, &queries, &|_| true);
    assert!(all.is_complete() && all.len() == queries.len());
    let mut scratch = Scratch::new();
    for (at, location) in all.iter().enumerate() {
        assert_eq!(index.locate_specially(places[at % places.len()], &sign_of_d, &mut scratch), location);
    }
    let some = locate_all_specially(&index, &probed.scene, &sign_of_d, &queries, &|_| false);
    assert!(!some.is_complete());
}

#[test]
fn a_wrong_sign_in_either_code_is_seen() {
    let places = grid(-1., 5., 1.);
    let probed = Probed::new(&DIAMOND, &[vec![vec![0, 1, 2, 3]]], &places);
    let sos = Sos::default();
    let exact = || Exact.prepare(&probed.scene, Off).unwrap();
    let perturbed = || sos.prepare(&probed.scene, Off).unwrap();
    let found = probed.disagreements(&exact(), &perturbed(), &sign_of_d);
    assert!(found.is_empty(), "{found:?}");

    // the inner point at (1, 2), under the left top edge
    let place = places.iter().position(|place| *place == [1., 2.]).unwrap();
    let [first, left, top] = [probed.probes(place)[0].index(), places.len(), places.len() + 3];
    let flipped = [first, left, top].map(Vertex::input);
    let wrong = one_flip(&probed.scene, flipped);
    assert_eq!(wrong.orient2d(Plane::Xy, flipped[1], flipped[2], flipped[0]), Sign::Positive, "above, by mistake");
    assert_eq!(probed.disagreements(&wrong, &perturbed(), &sign_of_d), ["exact, at [1.0, 2.0]"]);
    let of_generic = probed.disagreements(&exact(), &wrong, &sign_of_d);
    assert!(of_generic.iter().any(|found| found.contains("sos misses what the special test has, at [1.0, 2.0]")));
    let wrong_once = [DIAMOND[0], DIAMOND[3], [1., 2.]];
    let backwards = |l, r, p| if [l, r, p] == wrong_once { -sign_of_d(l, r, p) } else { sign_of_d(l, r, p) };
    let of_special = probed.disagreements(&exact(), &perturbed(), &backwards);
    assert!(of_special.iter().any(|found| found == "the special test, at [1.0, 2.0]"), "{of_special:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(75, 300)))]

    #[test]
    fn both_codes_agree_on_grids(points in grid_points(), regions in rings(12)) {
        Probed::new(&points[..12], &regions, &points).check();
    }

    #[test]
    fn both_codes_agree_within_ulps(points in ulp_points(), regions in rings(12)) {
        Probed::new(&points[..12], &regions, &points).check();
    }
}
