//! The union, compared with the oracle.

use predicament_cube_union::algorithm::{ByIndex, Mass, cube_union, union_in_order};
use predicament_cube_union::checks::{Measures, measured};

use super::dense;
use super::scenes;
use super::scenes::{Random, uniform};

pub fn measures(mass: &Mass) -> Measures {
    Measures { volume: mass.volume, area: mass.area, edge_length: mass.edge_length }
}

/// Asserts that both paths find the oracle's measures, and a closed surface.
pub fn check(lowers: &[[i64; 3]], edge: i64) -> Mass {
    let mass = cube_union(lowers, edge).unwrap();
    assert_eq!(measures(&mass), measured(lowers, edge), "{lowers:?} of {edge}");
    assert_eq!(union_in_order(&ByIndex { lowers, edge }, lowers, edge), Ok(mass), "{lowers:?} of {edge}");
    assert!(mass.vertices.euler_characteristic().is_some(), "{lowers:?} of {edge}");
    mass
}

#[test]
fn no_cubes_have_no_mass() {
    assert_eq!(cube_union::<i32>(&[], 1), Ok(Mass::default()));
    assert_eq!(union_in_order(&ByIndex { lowers: &[], edge: 1 }, &[], 1), Ok(Mass::default()));
}

#[test]
fn three_cubes_on_a_small_grid_are_right_wherever_they_are() {
    let places = scenes::lattice(3, 1);
    for &edge in predicament_effort::some_or_all(&[2][..], &[1, 2]) {
        for &a in &places {
            for &b in &places {
                for &c in &places {
                    check(&[a, b, c], edge);
                }
            }
        }
    }
}

#[test]
fn cubes_on_crowded_grids_are_right() {
    let mut random = Random::new(2);
    for round in 0..400 {
        let (count, end, edge) = (1 + round % 60, 1 + random.below(12), 1 + random.below(7));
        let count = if predicament_effort::whole() { count } else { count / 2 };
        check(&random.lowers(count, end), edge);
    }
}

#[test]
fn the_vertices_are_those_of_moved_cubes() {
    let mut random = Random::new(3);
    for round in 0..300 {
        let (count, end, edge) = (1 + round % 40, 1 + random.below(6), 1 + random.below(4));
        let lowers = random.lowers(count, end);
        let (mass, moved) = (cube_union(&lowers, edge).unwrap(), cube_union(&dense::moved(&lowers), edge * dense::K));
        assert_eq!(mass.vertices, moved.unwrap().vertices, "{lowers:?} of {edge}");
    }
}

#[test]
fn dense_and_sparse_crowds_are_right() {
    let mut random = Random::new(4);
    for (count, end, edge) in
        [(1500, 1000, 100), (1500, 1000, 1), (800, 1000, 400), (600, 1000, 3000), (300, 1_000_000_000, 1), (900, 40, 5)]
    {
        let count = predicament_effort::some_or_all(count / 2, count);
        check(&random.lowers(count, end), edge);
    }
}

#[test]
fn many_cubes_in_few_places_are_right() {
    // More cubes than a word holds, in cells that are points.
    let mut random = Random::new(5);
    for (count, end, edge) in [(70, 1, 1), (150, 1, 5), (400, 2, 1), (300, 2, 3), (500, 3, 2)] {
        check(&random.lowers(count, end), edge);
    }
}

#[test]
fn clusters_far_apart_are_right() {
    let mut random = Random::new(6);
    let mut lowers = Vec::new();
    for _ in 0..6 {
        let center = [(); 3].map(|()| random.below(1 << 38));
        for offset in random.lowers(80, 60) {
            lowers.push([0, 1, 2].map(|axis| center[axis] + offset[axis]));
        }
    }
    check(&lowers, 20);
    // On a line, in a plane, and at the ends of the range of i32.
    let flat: Vec<_> = random.lowers(300, 1 << 40).into_iter().map(|[x, y, _]| [x, y % 30, 7]).collect();
    check(&flat, 11);
    let ends = [i32::MIN, i32::MIN + 4, i32::MAX - 4, i32::MAX];
    let corners: Vec<[i32; 3]> = (0..64).map(|i| [ends[i % 4], ends[i / 4 % 4], ends[i / 16]]).collect();
    let wide: Vec<[i64; 3]> = corners.iter().map(|corner| corner.map(i64::from)).collect();
    assert_eq!(cube_union(&corners, 7).unwrap(), check(&wide, 7));
}

#[test]
fn thousands_of_random_cubes_are_right() {
    let (lowers, edge) = uniform(predicament_effort::cases(20_000), 1.0, 7);
    let mass = cube_union(&lowers, edge).unwrap();
    let lowers: Vec<[i64; 3]> = lowers.iter().map(|lower| lower.map(i64::from)).collect();
    assert_eq!(measures(&mass), measured(&lowers, edge.into()));
}
