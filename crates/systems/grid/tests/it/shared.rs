//! The boxes that two sets share space with, compared with all pairs of boxes.

use predicament_grid::{Bounds, shared};
use proptest::prelude::*;

/// Asserts that no box is missed; returns the number of boxes and the number of kept boxes.
fn check(first: &[Bounds<3>], second: &[Bounds<3>]) -> [usize; 2] {
    let counts = [first.len(), second.len()];
    let (kept, all) = shared(counts, [&|place| first[place], &|place| second[place]]);
    for (set, (own, other)) in [(first, second), (second, first)].into_iter().enumerate() {
        let whole = own.iter().fold(Bounds::NOTHING, |all, one| all.union(one));
        assert_eq!(all[set], whole);
        assert!(kept[set].is_sorted_by(|a, b| a < b) && kept[set].iter().all(|&place| (place as usize) < own.len()));
        for (place, one) in (0..).zip(own) {
            let meets = other.iter().any(|other| one.is_near(other, 0.0));
            assert!(!meets || kept[set].binary_search(&place).is_ok(), "{place} of set {set}: {one:?}");
        }
    }
    [counts[0] + counts[1], kept[0].len() + kept[1].len()]
}

fn spanned(a: [f64; 3], b: [f64; 3]) -> Bounds<3> {
    Bounds::of([a, b])
}

/// Boxes of this size on a sheet of 40 × 40 boxes, by two of its directions.
fn sheet(u: [f64; 3], v: [f64; 3]) -> Vec<Bounds<3>> {
    let at = |i: f64, j: f64| [0, 1, 2].map(|axis: usize| u[axis] * i + v[axis] * j);
    let place = |i: u32, j: u32| (f64::from(i) - 20.0, f64::from(j) - 20.0);
    let pairs = (0..40).flat_map(|i| (0..40).map(move |j| place(i, j)));
    pairs.map(|(i, j)| spanned(at(i, j), at(i + 1.0, j + 1.0))).collect()
}

#[test]
fn few_boxes_of_two_sheets_that_cross_are_kept() {
    let [first, second] = [sheet([1., 0., 0.], [0., 1., 0.]), sheet([0., 1., 0.25], [0.25, 0., 1.])];
    let [all, kept] = check(&first, &second);
    assert!(kept < all / 5, "{kept} of {all}");
    // One sheet is beside the other, in a box that the other's box meets.
    let above: Vec<Bounds<3>> = sheet([1., 0., 0.25], [0., 1., 0.125]);
    let below = above.iter().map(|one| spanned(one.low.map(|x| x - 4.0), one.high.map(|x| x - 4.0)));
    let [all, kept] = check(&above, &below.collect::<Vec<_>>());
    assert!(kept < all / 5, "{kept} of {all}");
}

#[test]
fn boxes_at_the_ends_of_the_range() {
    let ends = [-1.7e308, -1e300, -1.0, -5e-324, 0.0, 5e-324, 1e-300, 1.0, 1e300, 1.7e308];
    let mut boxes = vec![Bounds::NOTHING];
    for (i, &x) in ends.iter().enumerate() {
        for (j, &y) in ends.iter().enumerate() {
            boxes.push(spanned([x, y, x], [x, y, y]));
            boxes.push(spanned([x, y, ends[(i + j) % 10]], [ends[(i + 2 * j) % 10], y, x]));
        }
    }
    let (odd, even): (Vec<_>, Vec<_>) = boxes.iter().enumerate().partition(|(at, _)| at % 2 == 1);
    let [odd, even] = [odd, even].map(|of| of.into_iter().map(|(_, one)| *one).collect::<Vec<_>>());
    check(&odd, &even);
    check(&boxes, &boxes);
    for single in &boxes {
        check(&[*single], &boxes);
    }
}

#[test]
fn sets_that_are_empty_or_apart_keep_nothing() {
    let far = [spanned([1e308; 3], [1.5e308; 3])];
    let near = [spanned([-1e308; 3], [0.0; 3]), Bounds::NOTHING];
    assert_eq!(check(&far, &near), [3, 0]);
    assert_eq!(check(&[], &near), [2, 0]);
    assert_eq!(check(&near, &[]), [2, 0]);
    assert_eq!(check(&[], &[]), [0, 0]);
    // A gap of one bit, and no gap.
    let unit = [spanned([0.0; 3], [1.0; 3])];
    assert_eq!(check(&unit, &[spanned([1.0_f64.next_up(), 0.0, 0.0], [2.0; 3])]), [2, 0]);
    assert_eq!(check(&unit, &[spanned([1.0; 3], [2.0; 3])]), [2, 2]);
}

#[test]
fn many_boxes_are_taken_in_parts_and_a_huge_one_among_them() {
    // More boxes than one thread takes at a time, and more than the sample that determines the grid.
    let line = |by: f64| (0..20_000_u32).map(move |i| [f64::from(i % 200), f64::from(i / 200), by]);
    let small: Vec<Bounds<3>> = line(0.0).map(|p| spanned(p, p.map(|x| x + 0.5))).collect();
    let points: Vec<Bounds<3>> = line(0.25).step_by(7).map(|p| spanned(p, p)).collect();
    let (kept, _) = shared([small.len(), points.len()], [&|place| small[place], &|place| points[place]]);
    assert!(small.iter().zip(0..).step_by(7).all(|(_, place)| kept[0].binary_search(&place).is_ok()));
    assert_eq!(kept[1].len(), points.len());
    assert!(kept[0].len() < small.len() * 3 / 4, "{}", kept[0].len());
    let mut huge = points.clone();
    huge.push(spanned([-1e9; 3], [1e9; 3]));
    let (kept, _) = shared([small.len(), huge.len()], [&|place| small[place], &|place| huge[place]]);
    assert_eq!((kept[0].len(), kept[1].len()), (small.len(), huge.len()));
}

/// Coordinates with few values, so that sides coincide; some far outside, and exponents of all sizes.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => (-4_i8..=4).prop_map(f64::from),
        4 => (0_u8..64).prop_map(|i| f64::from(i) * 0.1),
        1 => (-1074_i32..1023, any::<bool>()).prop_map(|(e, s)| 2.0_f64.powi(e) * if s { 1.0 } else { -1.0 }),
    ]
}

fn bounds() -> impl Strategy<Value = Bounds<3>> {
    let corner = || proptest::array::uniform3(coordinate());
    prop_oneof![
        (corner(), corner()).prop_map(|(a, b)| spanned(a, b)),
        corner().prop_map(|a| spanned(a, a)),
        (corner(), 0_usize..3, coordinate()).prop_map(|(a, axis, x)| {
            let mut b = a;
            b[axis] = x;
            spanned(a, b)
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(5_000)))]

    #[test]
    fn random_boxes(
        first in prop::collection::vec(bounds(), 0..120),
        second in prop::collection::vec(bounds(), 0..120),
    ) {
        check(&first, &second);
    }
}
