//! The oracle itself.

use predicament_cube_union::checks::{Measures, measured};

use super::dense;
use super::scenes::Random;

#[test]
fn known_unions_are_measured() {
    assert_eq!(measured(&[], 3), Measures::default());
    assert_eq!(measured(&[[-1, 5, 7]], 2), Measures { volume: 8, area: 24, edge_length: 24 });
    // A corner in each other: three edges of each lose a half, and a hexagon of reflex edges is new.
    assert_eq!(measured(&[[0, 0, 0], [1, 1, 1]], 2), Measures { volume: 15, area: 42, edge_length: 48 });
    // A common face: the first one is further along all axes. As the upper one it leaves a gap, as the lower one none,
    // and the seam is a step all around, with two edges but where they hide inside.
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
