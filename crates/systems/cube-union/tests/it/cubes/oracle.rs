//! Tests of the oracle.

use predicament_cube_union::checks::{Measures, measured};

use super::dense;
use super::scenes::Random;

#[test]
fn known_unions_are_measured() {
    assert_eq!(measured(&[], 3), Measures::default());
    assert_eq!(measured(&[[-1, 5, 7]], 2), Measures { volume: 8, area: 24, edge_length: 24 });
    // Each cube has a corner in the other: three edges of each lose a half, and a hexagon of reflex edges is new.
    assert_eq!(measured(&[[0, 0, 0], [1, 1, 1]], 2), Measures { volume: 15, area: 42, edge_length: 48 });
    // A common face: the first cube is further along all axes. If the first is the upper cube, there is a gap,
    // otherwise not. The seam is a step all around, with two edges except where they are inside.
    assert_eq!(measured(&[[0, 0, 2], [0, 0, 0]], 2), Measures { volume: 16, area: 48, edge_length: 48 });
    assert_eq!(measured(&[[0, 0, 0], [0, 0, 2]], 2), Measures { volume: 16, area: 40, edge_length: 48 });
}

#[test]
fn sections_measure_what_moved_cubes_tend_to() {
    let mut random = Random::new(1);
    for round in 0..600 {
        let (count, end, edge) = (1 + round % 8, 1 + random.below(5), 1 + random.below(4));
        let lowers = random.lowers(count, end);
        assert_eq!(measured(&lowers, edge), dense::limit(&lowers, edge), "{lowers:?} of {edge}");
    }
}
