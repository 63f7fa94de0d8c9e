//! Laws that hold for any union.

use predicament_cube_union::algorithm::{Mass, cube_union};

use super::scenes::{Random, uniform};
use super::union::measures;

fn scenes() -> Vec<(Vec<[i64; 3]>, i64)> {
    let mut random = Random::new(10);
    let mut scenes: Vec<(Vec<[i64; 3]>, i64)> =
        [(50, 4, 2), (400, 20, 4), (2000, 60, 5)].map(|(count, end, edge)| (random.lowers(count, end), edge)).into();
    let (lowers, edge) = uniform(5000, 2.0, 11);
    scenes.push((lowers.iter().map(|lower| lower.map(i64::from)).collect(), edge.into()));
    scenes
}

fn union(lowers: &[[i64; 3]], edge: i64) -> Mass {
    cube_union(lowers, edge).unwrap()
}

#[test]
fn far_apart_unions_add_up() {
    for (lowers, edge) in scenes() {
        let far = lowers.iter().map(|[x, y, z]| [x + (1 << 33), y - (1 << 32), z + 5]);
        let both: Vec<[i64; 3]> = lowers.iter().copied().chain(far).collect();
        let (one, two) = (union(&lowers, edge), union(&both, edge));
        assert_eq!((2 * one.volume, 2 * one.area, 2 * one.edge_length), (two.volume, two.area, two.edge_length));
        assert_eq!(2 * one.vertices.total(), two.vertices.total());
    }
}

#[test]
fn a_union_can_be_moved() {
    for (lowers, edge) in scenes() {
        let moved: Vec<[i64; 3]> = lowers.iter().map(|[x, y, z]| [x - 12_345, y + (1 << 61), z - (1 << 61)]).collect();
        assert_eq!(union(&lowers, edge), union(&moved, edge));
    }
}

#[test]
fn a_union_can_be_scaled() {
    for (lowers, edge) in scenes() {
        let scaled: Vec<[i64; 3]> = lowers.iter().map(|lower| lower.map(|c| 7 * c)).collect();
        let (one, large) = (union(&lowers, edge), union(&scaled, 7 * edge));
        let known = (343 * one.volume, 49 * one.area, 7 * one.edge_length, one.vertices);
        assert_eq!((large.volume, large.area, large.edge_length, large.vertices), known);
    }
}

#[test]
fn a_union_can_be_turned_to_other_axes() {
    for (lowers, edge) in scenes() {
        let turned: Vec<[i64; 3]> = lowers.iter().map(|&[x, y, z]| [z, x, y]).collect();
        let swapped: Vec<[i64; 3]> = lowers.iter().map(|&[x, y, z]| [y, x, z]).collect();
        assert_eq!(union(&lowers, edge), union(&turned, edge));
        assert_eq!(union(&lowers, edge), union(&swapped, edge));
    }
}

#[test]
fn the_mirror_image_through_a_point_has_the_order_reversed() {
    for (lowers, edge) in scenes() {
        let mirrored: Vec<[i64; 3]> = lowers.iter().rev().map(|lower| lower.map(|c| -c)).collect();
        assert_eq!(union(&lowers, edge), union(&mirrored, edge));
    }
}

#[test]
fn a_mirror_image_and_another_order_have_the_same_volume() {
    let mut random = Random::new(12);
    for (lowers, edge) in scenes() {
        let volume = union(&lowers, edge).volume;
        let mirrored: Vec<[i64; 3]> = lowers.iter().map(|&[x, y, z]| [-x, y, z]).collect();
        assert_eq!(union(&mirrored, edge).volume, volume);
        assert_eq!(union(&random.shuffled(&lowers), edge).volume, volume);
    }
}

#[test]
fn without_ties_the_order_makes_no_difference() {
    let mut random = Random::new(13);
    // Coordinates for which all lower and upper faces are apart.
    let lowers: Vec<[i64; 3]> = {
        let [x, y, z] = [(); 3].map(|()| random.shuffled(&(0..800).map(|i| 10 * i).collect::<Vec<i64>>()));
        (0..800).map(|i| [x[i], y[i], z[i]]).collect()
    };
    let one = union(&lowers, 1205);
    assert_eq!(one, union(&random.shuffled(&lowers), 1205));
    let mirrored: Vec<[i64; 3]> = lowers.iter().map(|&[x, y, z]| [-x, y, z]).collect();
    assert_eq!(one, union(&mirrored, 1205));
    // With ties, the measures depend on the order.
    let (stack, reversed) = ([[0, 0, 0], [0, 0, 1]], [[0, 0, 1], [0, 0, 0]]);
    assert_ne!(measures(&union(&stack, 1)), measures(&union(&reversed, 1)));
}

#[test]
fn the_number_of_threads_makes_no_difference() {
    let (lowers, edge) = uniform(predicament_effort::cases(300_000), 1.0, 14);
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| cube_union(&lowers, edge).unwrap())
    };
    assert_eq!(with(1), with(3));
}
