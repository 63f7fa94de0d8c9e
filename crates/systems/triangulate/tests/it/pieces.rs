//! Outer loops that have edges in common, as the parcels of a map have.

use std::collections::{BTreeMap, BTreeSet};

use predicament_exact::Exact;
use predicament_predicates::{Backend, Off, Plane, Vertex};
use predicament_triangulate::algorithm::{oriented, triangulate};
use proptest::prelude::*;

use super::triangulate::{METHODS, check, doubled_area, scene};

/// The number of squares in a row of the grid.
const SIDE: usize = 4;

/// Directed edges with the inside on their left.
type Border = BTreeSet<[usize; 2]>;

/// The corners of a border that is one loop and passes through no corner twice.
fn walked(border: &Border) -> Option<Vec<usize>> {
    let next: BTreeMap<usize, usize> = border.iter().map(|&[from, to]| (from, to)).collect();
    let mut walk = vec![border.first()?[0]];
    while walk.len() < border.len() {
        walk.push(*next.get(walk.last()?).filter(|to| !walk.contains(to))?);
    }
    Some(walk)
}

/// Divides a grid of triangles into random pieces without holes: the points of the grid, and the corners of each piece.
fn pieces(next: &mut impl FnMut() -> usize) -> (Vec<[i32; 2]>, Vec<Vec<usize>>) {
    let shear = [(1, 0), (2, 1), (3, -2)][next() % 3];
    let steps = || (0..=SIDE).flat_map(|y| (0..=SIDE).map(move |x| [x, y].map(|step| i32::try_from(step).unwrap())));
    let points = steps().map(|[x, y]| [2 * x + shear.0 * y, 3 * y + shear.1 * x]).collect();
    let mut borders: Vec<Border> = Vec::new();
    for square in 0..SIDE * SIDE {
        let a = square / SIDE * (SIDE + 1) + square % SIDE;
        let [b, c, d] = [a + 1, a + SIDE + 2, a + SIDE + 1];
        let halves = if next().is_multiple_of(2) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
        borders.extend(halves.map(|[a, b, c]| Border::from([[a, b], [b, c], [c, a]])));
    }
    for _ in 0..8 * borders.len() {
        let [one, other] = [next(), next()].map(|pick| pick % borders.len());
        let (common, rest): (Border, Border) = borders[one]
            .union(&borders[other])
            .partition(|[a, b]| [one, other].iter().any(|&at| borders[at].contains(&[*b, *a])));
        if one != other && !common.is_empty() && walked(&rest).is_some() {
            borders[one] = rest;
            borders.swap_remove(other);
        }
    }
    (points, borders.iter().filter_map(walked).collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn pieces_are_outer_loops_and_have_their_triangles(seed: u64, are_apart: bool) {
        let mut state = seed | 1;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            usize::try_from(state >> 33).unwrap()
        };
        let (mut points, pieces) = pieces(&mut next);
        let mut loops: Vec<Vec<Vertex>> = Vec::new();
        for mut piece in pieces {
            if next().is_multiple_of(4) {
                continue;
            }
            if are_apart {
                let first = points.len();
                points.extend(piece.clone().into_iter().map(|corner| points[corner]).collect::<Vec<_>>());
                piece = (first..points.len()).collect();
            }
            let start = next() % piece.len();
            piece.rotate_left(start);
            if next().is_multiple_of(2) {
                piece.reverse();
            }
            loops.push(piece.into_iter().map(Vertex::input).collect());
        }
        let scene = scene(&points);
        let exact = Exact.prepare(&scene, Off).unwrap();
        let turned = oriented(&exact, Plane::Xy, false, &loops);
        prop_assert!(turned.iter().all(|one| doubled_area(&points, one) > 0), "{points:?} {loops:?}");
        for method in METHODS {
            check(&points, &turned, &triangulate(&exact, Plane::Xy, false, &turned, method));
        }
    }
}
