//! The results of a column index, compared with the rule applied to every segment.

use predicament_grid::Columns;
use proptest::prelude::*;

type Segment = [[f64; 2]; 2];

fn box_of(&[a, b]: &Segment) -> [[f64; 2]; 2] {
    [[a[0].min(b[0]), a[1].min(b[1])], [a[0].max(b[0]), a[1].max(b[1])]]
}

/// The rule of [`Columns::above`] at reach 0, without columns.
fn brute_above(segments: &[Segment], [x, y]: [f64; 2]) -> Vec<u32> {
    let matters = |(segment, _): &(&Segment, u32)| {
        let [low, high] = box_of(segment);
        low[0] <= x && x <= high[0] && high[1] >= y
    };
    segments.iter().zip(0..).filter(matters).map(|(_, at)| at).collect()
}

fn brute_overlaps(segments: &[Segment]) -> Vec<[u32; 2]> {
    let boxes: Vec<_> = segments.iter().map(box_of).collect();
    let mut pairs = Vec::new();
    for (i, a) in (0..).zip(&boxes) {
        for (j, b) in (0..).zip(&boxes[..i as usize]) {
            if (0..2).all(|axis| a[0][axis] <= b[1][axis] && b[0][axis] <= a[1][axis]) {
                pairs.push([j, i]);
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

fn check(segments: &[Segment], queries: &[[f64; 2]]) {
    let columns = Columns::new(segments);
    assert!(columns.count() <= segments.len().max(1));
    let mut overlaps: Vec<_> = (0..columns.count()).flat_map(|column| columns.overlaps(column)).collect();
    overlaps.sort_unstable();
    assert_eq!(overlaps, brute_overlaps(segments));
    let ends = segments.as_flattened();
    // every x with every y, so that ends are hit exactly, from below and above
    for &[x, _] in queries.iter().chain(ends) {
        for &[_, y] in queries.iter().chain(ends) {
            let mut found: Vec<u32> = columns.above([x, y], 0.0).collect();
            let tops: Vec<f64> = found.iter().map(|&at| box_of(&segments[at as usize])[1][1]).collect();
            assert!(tops.is_sorted_by(|a, b| a >= b), "from the highest down");
            found.sort_unstable();
            assert_eq!(found, brute_above(segments, [x, y]), "at {x:e} {y:e}");
        }
    }
}

#[test]
fn degenerate_inputs() {
    let far = [[-1e308, -1e308], [1e308, 1e308], [0.0, -0.0], [5e-324, 0.5]];
    check(&[], &far);
    check(&[[[1.0, 2.0], [1.0, 2.0]]], &far);
    check(&[[[1.0, 2.0], [3.0, 2.0]]], &far);
    let vertical: Vec<Segment> = (0..20).map(|i| [[2.5, f64::from(i)], [2.5, f64::from(i + 1)]]).collect();
    check(&vertical, &far);
    let bars: Vec<Segment> = (0..20).map(|i| [[f64::from(i), -1.0], [f64::from(i), 1.0]]).collect();
    check(&bars, &far);
    let m = f64::MAX;
    check(&[[[-m, -m], [m, m]], [[-m, m], [m, -m]], [[0.0, 0.0], [m, 1.0]], [[0.0, 0.0], [1.0, 1.0]]], &far);
    let s = 5e-324;
    check(
        &[[[0.0, 0.0], [s, s]], [[s, 0.0], [3.0 * s, 1.0]], [[-s, 0.0], [-0.0, s]], [[7.0 * s, 0.0], [s, 0.0]]],
        &far,
    );
    check(&[[[1.0, 0.0], [1.0_f64.next_up(), 1.0]], [[1.0, 5.0], [1.0, 6.0]]], &far);
    // one outlier makes the columns useless, not the answers wrong
    let mut cluster: Vec<Segment> = (0..20).map(|i| [[f64::from(i), 0.0], [f64::from(i + 1), 1.0]]).collect();
    cluster.push([[1e300, 0.0], [1e301, 1.0]]);
    check(&cluster, &far);
}

#[test]
fn borders_of_columns_are_hit_exactly() {
    // unit steps: columns are half a unit wide, and every end is a border
    let steps: Vec<Segment> = (0..32).map(|i| [[f64::from(i), 0.0], [f64::from(i + 1), f64::from(i % 3)]]).collect();
    let halves: Vec<[f64; 2]> = (0..=64).map(|i| [f64::from(i) / 2.0, 0.0]).collect();
    check(&steps, &halves);
    let around: Vec<[f64; 2]> = halves.iter().flat_map(|&[x, y]| [[x.next_up(), y], [x.next_down(), y]]).collect();
    check(&steps, &around);
}

#[test]
fn a_ray_sees_few_of_many() {
    // a 300 × 300 board of unit squares: 180,600 edges, 300 across any column
    let mut segments = Vec::new();
    for i in 0..=300 {
        for j in 0..300 {
            let (i, j) = (f64::from(i), f64::from(j));
            segments.push([[i, j], [i, j + 1.0]]);
            segments.push([[j, i], [j + 1.0, i]]);
        }
    }
    let columns = Columns::new(&segments);
    assert!(columns.entries() <= 4 * segments.len());
    assert_eq!(columns.above([150.5, 280.5], 0.0).count(), 20);
    assert_eq!(columns.above([150.5, -1.0], 0.0).count(), 301);
    assert_eq!(columns.above([150.5, 301.0], 0.0).count(), 0);
    assert_eq!(columns.above([-0.5, 0.0], 0.0).count(), 0);
}

#[test]
fn reach_looks_further_down() {
    let columns = Columns::new(&[[[0.0, 0.0], [1.0, 0.0]]]);
    assert_eq!(columns.above([0.5, 0.1], 0.0).count(), 0);
    assert_eq!(columns.above([0.5, 0.1], 0.09).count(), 0);
    assert_eq!(columns.above([0.5, 0.1], 0.1).count(), 1);
    assert_eq!(columns.above([0.5, 1.0], f64::INFINITY).count(), 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn small_integers(
        segments in prop::collection::vec(prop::array::uniform2(prop::array::uniform2((-6..6_i32).prop_map(f64::from))), 0..24),
        queries in prop::collection::vec(prop::array::uniform2((-14..14_i32).prop_map(|x| f64::from(x) / 2.0)), 1..8),
    ) {
        check(&segments, &queries);
    }

    #[test]
    fn all_finite_doubles(
        segments in prop::collection::vec(prop::array::uniform2(prop::array::uniform2(finite())), 0..12),
        queries in prop::collection::vec(prop::array::uniform2(finite()), 1..6),
    ) {
        check(&segments, &queries);
    }
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}
