//! The results of a box index, compared with the rule applied to every box.

use predicament_grid::{Bounds, BoxIndex};
use proptest::prelude::*;

/// The rule applied to every box.
fn brute<const D: usize>(boxes: &[Bounds<D>], query: &Bounds<D>, reach: f64) -> Vec<u32> {
    let near = |(_, b): &(u32, &Bounds<D>)| b.is_near(query, reach);
    (0..).zip(boxes).filter(near).map(|(place, _)| place).collect()
}

/// Compares the index with the rule; each box is also a query.
fn check<const D: usize>(boxes: &[Bounds<D>], queries: &[Bounds<D>], reaches: &[f64]) {
    let index = BoxIndex::new(boxes.to_vec());
    let mut found = vec![7];
    // With many boxes, by default one in seven is a query.
    let step = if boxes.len() > 1000 { predicament_effort::some_or_all(7, 1) } else { 1 };
    for query in boxes.iter().step_by(step).chain(queries) {
        for &reach in reaches {
            index.near(query, reach, &mut found);
            assert_eq!(found, brute(boxes, query, reach), "{query:?} within {reach:e}");
        }
    }
}

fn spanned<const D: usize>(a: [f64; D], b: [f64; D]) -> Bounds<D> {
    Bounds::of([a, b])
}

#[test]
fn nothing_and_single_points() {
    check::<2>(&[], &[spanned([0.0; 2], [1.0; 2])], &[0.0, 1.0, f64::INFINITY]);
    let point = spanned([1.0; 3], [1.0; 3]);
    check(&[point], &[spanned([0.0; 3], [1.0; 3]), spanned([2.0; 3], [3.0; 3])], &[0.0, 0.5, 1.0]);
    check(&[point; 100], &[spanned([0.0; 3], [2.0; 3])], &[0.0]);
}

#[test]
fn touching_boxes_are_near_and_a_gap_of_one_bit_is_not() {
    let boxes: Vec<Bounds<2>> = (0..50).map(|i| spanned([f64::from(i), 0.0], [f64::from(i) + 1.0, 1.0])).collect();
    check(&boxes, &[], &[0.0, 1.0, 2.0]);
    let beside = spanned([1.0_f64.next_up(), 0.0], [1.5, 1.0]);
    let mut found = Vec::new();
    BoxIndex::new(vec![boxes[0]]).near(&beside, 0.0, &mut found);
    assert!(found.is_empty());
    BoxIndex::new(vec![boxes[0]]).near(&beside, f64::EPSILON, &mut found);
    assert_eq!(found, [0_u32]);
}

#[test]
fn what_the_exact_gap_admits_is_never_dropped() {
    // 2^53 + 1 is not a double: the gap from 1 to −2^53 is rounded, and so are the sums of sides and reach.
    let far = 2.0_f64.powi(53);
    let boxes = [spanned([-far, 0.0], [-far, 0.0]), spanned([0.1, 0.0], [0.2, 0.0])];
    let queries = [spanned([1.0, 0.0], [1.0, 0.0]), spanned([0.1 + 0.7, 0.0], [0.8, 0.0])];
    check(&boxes, &queries, &[far, far + 2.0, 0.6, 0.7, 0.1, 5e-324]);
    let index = BoxIndex::new(boxes.to_vec());
    let mut found = Vec::new();
    index.near(&queries[0], far + 2.0, &mut found);
    assert!(found.contains(&0));
}

#[test]
fn coordinates_near_the_ends_of_the_range() {
    let ends = [-1.7e308, -1e300, -1.0, -5e-324, 0.0, 5e-324, 1e-300, 1.0, 1e300, 1.7e308];
    let mut boxes = Vec::new();
    for (i, &x) in ends.iter().enumerate() {
        for &y in &ends[i..] {
            boxes.push(spanned([x, y], [y, x]));
            boxes.push(spanned([x, x], [x, y]));
        }
    }
    let boxes: Vec<Bounds<2>> = boxes.iter().cycle().take(300).copied().collect();
    check(&boxes, &[], &[0.0, 1e-300, 1.0, 1e308, f64::MAX, f64::INFINITY]);
}

#[test]
fn crowds_across_a_border_are_found_once() {
    let mut boxes: Vec<Bounds<2>> = Vec::new();
    for crowd in 0..12 {
        let center = [f64::from(crowd % 4), f64::from(crowd / 4)];
        for i in 0..400 {
            let at = [center[0] + f64::from(i % 20 - 10) / 100.0, center[1] + f64::from(i / 20 - 10) / 100.0];
            boxes.push(spanned(at, at.map(|x| x + 0.015)));
        }
    }
    check(&boxes, &[spanned([-1.0, -1.0], [9.0, 9.0]), spanned([0.0, 0.95], [3.0, 1.05])], &[0.0, 0.02, 0.3]);
}

#[test]
fn a_huge_box_and_clusters_among_small_ones() {
    let mut boxes = vec![spanned([-1e6; 3], [1e6; 3]), spanned([1e9; 3], [1e9; 3])];
    for i in 0..2000_u32 {
        let at = [f64::from(i % 13), f64::from(i % 17), f64::from(i % 11)];
        boxes.push(spanned(at, at.map(|x| x + f64::from(i % 3))));
        let tiny = at.map(|x| 100.0 + x * 1e-9);
        boxes.push(spanned(tiny, tiny.map(|x| x + 1e-9)));
    }
    let index = BoxIndex::new(boxes.clone());
    assert!(index.entries() < 60 * boxes.len(), "{} entries", index.entries());
    let some: Vec<Bounds<3>> = boxes.iter().step_by(37).copied().chain([boxes[0], boxes[1]]).collect();
    let mut found = Vec::new();
    for query in &some {
        for reach in [0.0, 1e-9, 2.0] {
            index.near(query, reach, &mut found);
            assert_eq!(found, brute(&boxes, query, reach));
        }
    }
}

#[test]
fn many_long_boxes_take_no_more_memory_than_they_may() {
    // Diagonals of a square, whose boxes are nested, and thin boxes across it.
    let n = 3000;
    let side = f64::from(n);
    let nested = (0..n).map(|i| spanned([f64::from(i); 2], [2.0 * side - f64::from(i); 2]));
    let across = (0..n).map(|i| spanned([0.0, f64::from(i)], [2.0 * side, f64::from(i)]));
    let boxes: Vec<Bounds<2>> = nested.chain(across).collect();
    let index = BoxIndex::new(boxes.clone());
    assert!(index.entries() <= 64 * boxes.len(), "{} entries", index.entries());
    let mut found = Vec::new();
    for query in boxes.iter().step_by(101) {
        index.near(query, 0.0, &mut found);
        assert_eq!(found, brute(&boxes, query, 0.0));
    }
}

#[test]
fn one_thread_enters_what_many_do() {
    let boxes: Vec<Bounds<2>> = (0..20_000_u32)
        .map(|i| {
            let at = [f64::from(i * 7919 % 1009), f64::from(i * 104_729 % 997)];
            spanned(at, at.map(|x| x + f64::from(i % 13)))
        })
        .collect();
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let index = pool.install(|| BoxIndex::new(boxes.clone()));
        let mut found = Vec::new();
        for query in boxes.iter().step_by(211) {
            index.near(query, 0.5, &mut found);
            assert_eq!(found, brute(&boxes, query, 0.5), "{threads} threads");
        }
    }
}

#[test]
#[should_panic(expected = "a reach is a distance")]
fn a_reach_that_is_no_distance_is_refused() {
    BoxIndex::<2>::new(Vec::new()).near(&spanned([0.0; 2], [0.0; 2]), f64::NAN, &mut Vec::new());
}

#[test]
#[should_panic(expected = "coordinates must be finite")]
fn infinite_boxes_are_refused() {
    let _ = BoxIndex::new(vec![Bounds { low: [0.0; 2], high: [f64::INFINITY; 2] }]);
}

/// Coordinates with few values, so that sides coincide; some far outside, and exponents of all sizes.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => (-4_i8..=4).prop_map(f64::from),
        4 => (0_u8..64).prop_map(|i| f64::from(i) * 0.1),
        1 => (-1022_i32..1023, any::<bool>()).prop_map(|(e, s)| 2.0_f64.powi(e) * if s { 1.0 } else { -1.0 }),
    ]
}

fn bounds<const D: usize>() -> impl Strategy<Value = Bounds<D>> {
    let corner = || proptest::array::uniform::<_, D>(coordinate());
    prop_oneof![
        (corner(), corner()).prop_map(|(a, b)| spanned(a, b)),
        corner().prop_map(|a| spanned(a, a)),
        (corner(), 0_usize..D, coordinate()).prop_map(|(a, axis, x)| {
            let mut b = a;
            b[axis] = x;
            spanned(a, b)
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(64, 256)))]

    #[test]
    fn random_boxes_in_the_plane(
        boxes in prop::collection::vec(bounds::<2>(), 0..300),
        queries in prop::collection::vec(bounds::<2>(), 0..20),
        reach in coordinate(),
    ) {
        check(&boxes, &queries, &[0.0, reach.abs()]);
    }

    #[test]
    fn random_boxes_in_space(
        boxes in prop::collection::vec(bounds::<3>(), 0..300),
        queries in prop::collection::vec(bounds::<3>(), 0..20),
        reach in coordinate(),
    ) {
        check(&boxes, &queries, &[0.0, reach.abs()]);
    }

}

proptest! {
    /// The rounded rule accepts all pairs that the exact gap accepts.
    #[test]
    fn a_gap_in_exact_arithmetic_is_kept(a in bounds::<2>(), b in bounds::<2>(), reach in coordinate()) {
        let reach = reach.abs();
        let exact = |x: f64| rug::Rational::from_f64(x).unwrap();
        let near = (0..2).all(|axis| {
            exact(a.low[axis]) - exact(b.high[axis]) <= exact(reach)
                && exact(b.low[axis]) - exact(a.high[axis]) <= exact(reach)
        });
        prop_assert!(!near || a.is_near(&b, reach));
        prop_assert!(reach != 0.0 || near == a.is_near(&b, 0.0));
    }
}
