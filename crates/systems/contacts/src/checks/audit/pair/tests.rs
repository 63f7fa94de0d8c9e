//! Tests of the quantities that the paper bounds away from zero, for pairs with known values.

use super::*;

/// The pair's feet: its squared distance and its guarded quantities.
fn values<const D: usize>(first: &[[f64; D]], second: &[[f64; D]]) -> (Rational, Vec<Rational>) {
    let pair = Pair::new(first, second);
    // Coordinates are quarters, so that a lost or doubled power of two is noticed.
    assert!(pair.exponent < -1, "{pair:?}");
    let feet = pair.feet().unwrap();
    (feet.distance_squared.value(), feet.guarded.iter().map(Quantity::value).collect())
}

fn all(numbers: &[f64]) -> Vec<Rational> {
    numbers.iter().map(|&x| Rational::from_f64(x).unwrap()).collect()
}

const CORNER: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];

#[test]
fn the_feet_of_an_edge_guard_their_distances_to_its_ends() {
    let flat = values(&[[0.0, 0.0], [4.0, 0.0]], &[[1.0, 0.25]]);
    assert_eq!(flat, (Rational::from((1, 16)), all(&[1.0, 9.0])));
    let deep = values(&CORNER[..2], &[[1.0, 0.0, 0.25]]);
    assert_eq!(deep, (Rational::from((1, 16)), all(&[1.0, 9.0])));
}

#[test]
fn crossings_of_the_plane_guard_areas() {
    // Twice the areas with the second edge are 2 and 6, with the first edge 1 and 7.
    let edges = values(&[[0.0, 0.0], [4.0, 0.0]], &[[1.0, -0.25], [1.0, 1.75]]);
    assert_eq!(edges, (Rational::new(), all(&[4.0, 36.0, 1.0, 49.0])));
    // Of 16, the vertex gives 7 to the first corner, 4 and 5 to the others.
    let triangle = values(&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]], &[[1.0, 1.25]]);
    assert_eq!(triangle, (Rational::new(), all(&[49.0, 16.0, 25.0])));
}

#[test]
fn near_pairs_of_space_guard_squared_areas_and_weights() {
    // m² = (4 · 4)², and the feet are at a quarter of one edge and three eighths of the other.
    let edges = values(&CORNER[..2], &[[1.0, -1.5, 0.25], [1.0, 2.5, 0.25]]);
    let squares = [65_536.0, 64.0 * 64.0, 96.0 * 96.0, 192.0 * 192.0, 160.0 * 160.0];
    assert_eq!(edges, (Rational::from((1, 16)), all(&squares)));
    // Weights 1/8, 1/4 and 5/8.
    let triangle = values(&CORNER[..3], &[[1.0, 2.5, 0.25]]);
    let squares = [65_536.0, 32.0 * 32.0, 64.0 * 64.0, 160.0 * 160.0];
    assert_eq!(triangle, (Rational::from((1, 16)), all(&squares)));
}

#[test]
fn crossings_of_space_guard_volumes() {
    // The corners give parts of 32, and the heights of the ends times 16.
    let edge = values(&CORNER[..3], &[[1.0, 2.5, -0.25], [1.0, 2.5, 1.75]]);
    assert_eq!(edge, (Rational::new(), all(&[16.0, 64.0, 400.0, 16.0, 784.0])));
    // The weights are 1/2, 1, 5/4 and 5/4 of 4, in parts of 64.
    let vertex = values(&CORNER, &[[1.0, 1.25, 1.25]]);
    assert_eq!(vertex, (Rational::new(), all(&[64.0, 256.0, 400.0, 400.0])));
}

#[test]
fn a_foot_at_an_end_is_not_inside() {
    let feet = |second: &[[f64; 3]]| {
        [&CORNER[..2], &CORNER[..3], &CORNER].map(|first| {
            (PairKind::of([first.len() - 1, second.len() - 1].map(|rank| u8::try_from(rank).unwrap())).is_some())
                .then(|| Pair::new(first, second).feet().is_some())
        })
    };
    // Beside the first end, between the ends, beside the second end.
    assert_eq!(feet(&[[0.0, 0.0, 0.25]]), [Some(false); 3]);
    assert_eq!(feet(&[[1.0, 0.0, 0.25]]), [Some(true), Some(false), Some(false)]);
    assert_eq!(feet(&[[4.0, 0.0, 0.25]]), [Some(false); 3]);
    assert_eq!(feet(&[[1.0, 1.0, 0.25]]), [Some(true), Some(true), Some(true)]);
    assert_eq!(feet(&[[2.0, 2.0, 0.25]]), [Some(true), Some(false), Some(false)]);
    // An edge over a side of the triangle, over its inside, and with an end in its plane.
    let over = |x: f64, low: f64| [[x, 1.0, low], [x, 1.0, 1.0]];
    assert_eq!(feet(&over(0.0, -1.0))[1], Some(false));
    assert_eq!(feet(&over(1.0, -1.0))[1], Some(true));
    assert_eq!(feet(&over(1.0, 0.0))[1], Some(false));
    assert_eq!(feet(&over(1.0, 0.5))[1], Some(false));
}

#[test]
fn the_error_of_weights_is_the_largest_of_both_simplices() {
    let feet = Pair::new(&CORNER[..2], &[[1.0, -1.0, 0.25], [1.0, 3.0, 0.25]]).feet().unwrap();
    let exact = [0.75, 0.25, 0.0, 0.0];
    assert_eq!(feet.weight_error(&[exact, exact]), 0.0);
    assert_eq!(feet.weight_error(&[[0.75, 0.5, 0.0, 0.0], exact]), 0.25);
    assert_eq!(feet.weight_error(&[[0.875, 0.25, 0.0, 0.0], [0.75, 0.0, 0.0, 0.0]]), 0.25);
    assert_eq!(feet.weight_error(&[exact, [0.25, 0.25, 0.0, 0.0]]), 0.5);
    assert_eq!(feet.weight_error(&[[0.75, f64::NAN, 0.0, 0.0], exact]), f64::INFINITY);
}

#[test]
fn kinds_are_those_of_ranks_in_either_order() {
    for kind in PairKind::ALL {
        let [high, low] = kind.ranks();
        assert_eq!([PairKind::of([high, low]), PairKind::of([low, high])], [Some(kind); 2]);
    }
    assert_eq!([[2, 2], [3, 1], [4, 0]].map(PairKind::of), [None; 3]);
    let top = |dimension| PairKind::ALL.map(|kind| kind.is_top(dimension));
    assert_eq!(top(Dimension::Two), [false, false, true, true, false, false]);
    assert_eq!(top(Dimension::Three), [false, false, false, false, true, true]);
}

#[test]
fn facets_are_one_vertex_less_of_either_simplex() {
    let ranks = |first: &[[f64; 3]], second: &[[f64; 3]]| {
        Pair::new(first, second).facets().iter().map(|pair| pair.kind().ranks()).collect::<Vec<_>>()
    };
    assert_eq!(ranks(&CORNER[..1], &CORNER[1..2]), Vec::<[u8; 2]>::new());
    assert_eq!(ranks(&CORNER[..2], &CORNER[2..3]), [[0, 0]; 2]);
    assert_eq!(ranks(&CORNER[..2], &CORNER[2..]), [[1, 0]; 4]);
    assert_eq!(ranks(&CORNER[..3], &CORNER[2..]), [[1, 1], [1, 1], [1, 1], [2, 0], [2, 0]]);
    assert_eq!(ranks(&CORNER, &CORNER[..1]), [[2, 0]; 4]);
}
