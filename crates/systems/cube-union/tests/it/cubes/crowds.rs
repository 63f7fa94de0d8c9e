//! Many cubes that share all or some of their coordinates.

use predicament_cube_union::algorithm::{ByIndex, Vertices, cube_union, union_in_order};
use predicament_cube_union::checks::Measures;

use super::dense;
use super::scenes::{Random, lattice};
use super::union::{check, measures};

/// More cubes than a word holds, in random places of these, each several times in a row.
fn in_runs(random: &mut Random, places: &[[i64; 3]], longest: i64) -> Vec<[i64; 3]> {
    let mut lowers = Vec::new();
    while lowers.len() <= 70 {
        let place = places[usize::try_from(random.below(i64::try_from(places.len()).unwrap())).unwrap()];
        let times = 1 + random.below(longest);
        lowers.extend((0..times).map(|_| place));
    }
    lowers
}

/// The measures of n identical cubes: the upper corner of the first cube and the lower corner of the last are on the
/// boundary, and six edges are stairs of n steps.
fn identical(n: u32, edge: i64) -> (Measures, Vertices) {
    let (count, e) = (i128::from(n), i128::from(edge));
    let known = Measures { volume: e.pow(3), area: 6 * e * e, edge_length: (6 + 6 * (2 * count - 1)) * e };
    let n = u64::from(n);
    (known, Vertices { corners: 6 * n + 2, edge_faces: 6 * (n - 1), ..Vertices::default() })
}

#[test]
fn identical_cubes_are_a_flight_of_steps() {
    for n in [1_u32, 2, 3, 4, 5, 63, 64, 65, 66, 67, 68, 130, 200] {
        let mass = check(&vec![[4, -5, 6]; n as usize], 7);
        assert_eq!((measures(&mass), mass.vertices), identical(n, 7));
    }
}

#[test]
fn identical_cubes_may_be_many() {
    let n = predicament_effort::cases(200_000);
    let mass = cube_union(&vec![[-3, 0, 1 << 20]; n as usize], 1_i32 << 28).unwrap();
    assert_eq!((measures(&mass), mass.vertices), identical(n, 1 << 28));
}

#[test]
fn runs_of_identical_cubes_are_right_whatever_is_around() {
    let mut random = Random::new(30);
    for round in 0..150 {
        let edge = 1 + random.below(3);
        // From all cubes at one point to cubes that extend beyond it, on each side.
        let (end, longest) = (1 + edge + random.below(2), 1 + random.below(12));
        let places = random.lowers(2 + round % 9, end);
        let lowers = in_runs(&mut random, &places, longest);
        let mass = check(&lowers, edge);
        let moved = cube_union(&dense::moved(&lowers), edge * dense::K).unwrap();
        assert_eq!(mass.vertices, moved.vertices, "{lowers:?} of {edge}");
    }
}

#[test]
fn long_runs_of_every_type_meet_at_a_point() {
    // The eight octants around a point, twelve wedges and six half-spaces, in several orders.
    let mut random = Random::new(31);
    let places = lattice(3, 1);
    for _ in 0..20 {
        let order = random.shuffled(&places);
        let lowers: Vec<[i64; 3]> = order.iter().flat_map(|&place| vec![place; 4]).collect();
        // (2, 2, 2) is covered by the middle cube, unless that cube is left out.
        let around: Vec<[i64; 3]> = lowers.iter().copied().filter(|lower| *lower != [1, 1, 1]).collect();
        for lowers in [&lowers, &around] {
            let mass = cube_union(lowers, 2).unwrap();
            assert_eq!(union_in_order(&ByIndex { lowers, edge: 2 }, lowers, 2), Ok(mass), "{lowers:?}");
        }
    }
}
