//! Near boxes against all pairs: on lattices, where most boxes touch, far apart, and near the largest doubles.

use predicament_judge::boxes::{Boxes, Extent, are_near, extent};

/// A pseudo-random sequence with a long period.
fn numbers(mut state: u64) -> impl FnMut() -> f64 {
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 40).expect("24 bits"))
    }
}

fn boxes<const D: usize>(count: usize, scale: f64, seed: u64) -> Vec<Extent<D>> {
    let mut next = numbers(seed);
    let one = |_| {
        let low: [f64; D] = std::array::from_fn(|_| (next() % 32.0) * scale);
        let high: [f64; D] = std::array::from_fn(|axis| low[axis] + (next() % 4.0) * scale);
        [low, high]
    };
    (0..count).map(one).collect()
}

fn hold<const D: usize>(all: &[Extent<D>], reach: f64) -> usize {
    let index = Boxes::new(all.to_vec());
    let (mut found, mut pairs) = (Vec::new(), 0);
    for one in all {
        index.near(one, reach, &mut found);
        let is_near = |place: &u32| are_near(&all[*place as usize], one, reach);
        let wanted: Vec<u32> = (0..u32::try_from(all.len()).expect("a few")).filter(is_near).collect();
        assert_eq!(found, wanted, "{one:?} within {reach}");
        pairs += found.len();
    }
    pairs
}

#[test]
fn those_near_are_those_of_all_pairs() {
    for count in [0, 1, 8, 9, 500] {
        for (scale, reach) in [(1.0, 0.0), (1.0, 1.0), (5e306, 0.0), (1e-310, 0.0), (0.0, 0.0)] {
            let [in_plane, in_space] =
                [hold(&boxes::<2>(count, scale, 1), reach), hold(&boxes::<3>(count, scale, 2), reach)];
            assert!(in_plane >= count && in_space >= count, "each is near itself");
            assert!(scale == 0.0 || count < 8 || in_plane < count * count, "not all are near");
        }
    }
}

#[test]
fn a_ray_is_a_box_without_an_end() {
    let all = boxes::<2>(300, 1.0, 3);
    let index = Boxes::new(all.clone());
    let mut found = Vec::new();
    index.near(&[[7.0, 9.0], [7.0, f64::INFINITY]], 0.0, &mut found);
    let is_above = |&place: &u32| {
        let [low, high] = all[place as usize];
        low[0] <= 7.0 && 7.0 <= high[0] && 9.0 <= high[1]
    };
    assert_eq!(found, (0..300).filter(is_above).collect::<Vec<u32>>());
    assert!(found.len() > 5 && found.len() < 100, "{}", found.len());
}

#[test]
fn what_holds_nothing_is_near_nothing() {
    let nothing: Extent<2> = extent([]);
    assert!(!are_near(&nothing, &[[0.0; 2]; 2], 1.0));
    assert_eq!(extent([[1.0, 5.0], [2.0, 3.0]]), [[1.0, 3.0], [2.0, 5.0]]);
}
