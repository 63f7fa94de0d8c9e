//! Lattices, whose measures have closed forms.

use predicament_cube_union::algorithm::cube_union;
use predicament_cube_union::checks::Measures;

use super::scenes::{Random, lattice};
use super::union::{check, measures};

#[test]
fn cubes_apart_add_up() {
    for (n, edge) in [(1, 3), (2, 1), (5, 4), (20, 9)] {
        let mass = cube_union(&lattice(n, edge + 1), edge).unwrap();
        let (count, edge) = (i128::from(n).pow(3), i128::from(edge));
        let known =
            Measures { volume: count * edge.pow(3), area: 6 * count * edge * edge, edge_length: 12 * count * edge };
        assert_eq!(measures(&mass), known);
        assert_eq!(mass.vertices.euler_characteristic(), Some(2 * count));
    }
}

#[test]
fn cubes_that_touch_fuse_or_part_by_their_order() {
    for (n, edge) in [(2_i64, 1), (3, 4), (6, 2), (16, 5)] {
        let mut lowers = lattice(n, edge);
        let (n, e) = (i128::from(n), i128::from(edge));
        // In ascending order, each cube is moved into the cubes after it.
        let fused = cube_union(&lowers, edge).unwrap();
        assert_eq!((fused.volume, fused.area), ((n * e).pow(3), 6 * (n * e).pow(2)));
        assert_eq!(fused.vertices.euler_characteristic(), Some(2));
        // In descending order, there is a gap on every side.
        lowers.reverse();
        let apart = cube_union(&lowers, edge).unwrap();
        assert_eq!(
            measures(&apart),
            Measures { volume: (n * e).pow(3), area: 6 * n.pow(3) * e * e, edge_length: 12 * n.pow(3) * e }
        );
        assert_eq!(apart.vertices.euler_characteristic(), Some(2 * n.pow(3)));
    }
}

#[test]
fn cubes_that_overlap_are_one_block() {
    for (n, pitch, edge) in [(2, 1, 2), (4, 1, 5), (7, 3, 5), (10, 3, 4)] {
        let lowers = Random::new(8).shuffled(&lattice(n, pitch));
        let mass = cube_union(&lowers, edge).unwrap();
        let side = i128::from((n - 1) * pitch + edge);
        assert_eq!((mass.volume, mass.area), (side.pow(3), 6 * side * side));
        assert_eq!(mass.vertices.euler_characteristic(), Some(2));
    }
}

#[test]
fn lattices_in_any_order_are_right() {
    let mut random = Random::new(9);
    for (n, pitch, edge) in [(2, 1, 1), (3, 1, 1), (3, 1, 2), (4, 2, 2), (4, 2, 3), (5, 1, 2), (5, 3, 3), (4, 1, 4)] {
        for _ in 0..3 {
            check(&random.shuffled(&lattice(n, pitch)), edge);
        }
    }
}

#[test]
fn ties_are_broken_alike_in_large_input() {
    // Sorted in several parts, in which the cubes must keep their order in the input.
    let (n, edge) = (predicament_effort::some_or_all(65, 70), 3);
    let mut lowers = lattice(n, edge);
    let (count, side) = (i128::from(n).pow(3), i128::from(n * edge));
    let fused = cube_union(&lowers, edge).unwrap();
    assert_eq!((fused.volume, fused.area), (side.pow(3), 6 * side.pow(2)));
    lowers.reverse();
    let apart = cube_union(&lowers, edge).unwrap();
    assert_eq!((apart.volume, apart.area, apart.edge_length), (27 * count, 54 * count, 36 * count));
}
