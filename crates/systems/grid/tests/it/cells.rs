//! The sum of labels of a point's cell, compared with the sum over all segments.

use predicament_grid::{Cells, End, Labels};
use proptest::prelude::*;

type Segment = [[f64; 2]; 2];

/// Closed rings; the label of a segment is one bit for its ring.
struct Rings {
    segments: Vec<Segment>,
    labels: Vec<u64>,
}

impl Rings {
    fn new(rings: &[Vec<[f64; 2]>]) -> Rings {
        let mut all = Rings { segments: Vec::new(), labels: Vec::new() };
        for (bit, ring) in rings.iter().enumerate() {
            for (at, &from) in ring.iter().enumerate() {
                all.segments.push([from, ring[(at + 1) % ring.len()]]);
                all.labels.push(1 << bit);
            }
        }
        all
    }
}

/// Sums of labels, numbered in the order of their first use.
struct Sums<'a> {
    labels: &'a [u64],
    now: u64,
    met: Vec<u64>,
}

impl Labels for Sums<'_> {
    fn clear(&mut self) {
        self.now = 0;
    }
    fn toggle(&mut self, segment: u32) {
        self.now ^= self.labels[segment as usize];
    }
    fn number(&mut self) -> u32 {
        let at = self.met.iter().position(|&sum| sum == self.now).unwrap_or_else(|| {
            self.met.push(self.now);
            self.met.len() - 1
        });
        u32::try_from(at).unwrap()
    }
}

/// Breaks ties at x by a coin, once per pair of coordinates, as a perturbation would.
fn is_past(end: [f64; 2], x: f64) -> bool {
    end[0] < x || (end[0] == x && (end[1] + 0.0).to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 63 == 1)
}

/// True if the ray crosses the segment; a coin decides if the segment's box does not.
fn crosses(&[a, b]: &Segment, [x, y]: [f64; 2]) -> bool {
    let coin = (a[0] + b[1]).to_bits().wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 63 == 1;
    let is_below = y < a[1].min(b[1]) || (y <= a[1].max(b[1]) && coin);
    is_below && is_past(a, x) != is_past(b, x)
}

fn check(rings: &[Vec<[f64; 2]>], queries: &[[f64; 2]]) {
    let Rings { segments, labels } = Rings::new(rings);
    let mut sums = Sums { labels: &labels, now: 0, met: Vec::new() };
    let cells = Cells::new(&segments, &mut sums);
    assert!(cells.entries() <= 4 * segments.len() && cells.count() <= (4 * segments.len()).max(1));
    let ends = segments.as_flattened();
    for &[x, _] in queries.iter().chain(ends) {
        for &[_, y] in queries.iter().chain(ends) {
            let everything = segments.iter().zip(&labels).filter(|(segment, _)| crosses(segment, [x, y]));
            let expected = everything.fold(0, |sum, (_, label)| sum ^ label);
            let cell = cells.at(x, [y, y]).expect("one height is in one row");
            let mut cover = sums.met[cell.above as usize];
            for entry in cell.entries {
                let pivot = entry.pivot.map(|end| entry.ends[usize::from(end == End::Second)]);
                let counts = crosses(&entry.ends, [x, y]) != pivot.is_some_and(|pivot| is_past(pivot, x));
                cover ^= if counts { labels[entry.segment as usize] } else { 0 };
            }
            assert_eq!(cover, expected, "at {x:e} {y:e}");
            assert!(cell.entries.is_sorted_by(|a, b| a.segment < b.segment));
        }
    }
}

#[test]
fn degenerate_inputs() {
    let m = f64::MAX;
    let s = 5e-324;
    let far = [[-m, -m], [m, m], [0.0, -0.0], [s, 0.5], [-s, -1.0]];
    check(&[], &far);
    check(&[vec![[1.0, 2.0], [1.0, 2.0]]], &far);
    check(&[vec![[-m, -m], [m, -m], [m, m], [-m, m]], vec![[0.0, 0.0], [1.0, 0.0], [-0.0, 1.0]]], &far);
    check(&[vec![[0.0, 0.0], [s, s], [3.0 * s, 0.0]], vec![[-s, 0.0], [-0.0, s], [s, -s]]], &far);
    check(&[(0..20).map(|i| [2.5, f64::from(i % 7)]).collect()], &far);
    check(&[(0..20).map(|i| [f64::from(i % 7), -0.0]).collect()], &far);
    let mut board: Vec<Vec<[f64; 2]>> = (0..36)
        .map(|at| [f64::from(at % 6), f64::from(at / 6)])
        .map(|[x, y]| vec![[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]])
        .collect();
    let halves: Vec<[f64; 2]> = (-1..14).map(|i| [f64::from(i) / 2.0, f64::from(i) / 2.0]).collect();
    check(&board, &halves);
    // one outlier makes the cells useless, not the answers wrong
    board.push(vec![[1e300, 0.0], [1e301, 1.0], [1e300, 1e300]]);
    check(&board, &halves);
}

#[test]
fn a_cell_sees_few_of_many() {
    let ring = |i: i32, j: i32| {
        let [x, y] = [f64::from(i), f64::from(j)];
        vec![[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]]
    };
    let board: Vec<Vec<[f64; 2]>> = (0..6).flat_map(|i| (0..10).map(move |j| ring(20 * i, 20 * j))).collect();
    let Rings { segments, labels } = Rings::new(&board);
    let cells = Cells::new(&segments, &mut Sums { labels: &labels, now: 0, met: Vec::new() });
    let most = (0..180).map(|y| cells.at(60.5, [f64::from(y) + 0.5; 2]).unwrap().entries.len()).max();
    assert!(most.is_some_and(|most| (1..=8).contains(&most)), "{most:?}");
    assert!(cells.at(60.5, [0.0, 180.0]).is_none(), "several rows");
}

fn rings(point: impl Strategy<Value = [f64; 2]>, most: usize) -> impl Strategy<Value = Vec<Vec<[f64; 2]>>> {
    prop::collection::vec(prop::collection::vec(point, 2..most), 0..8)
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn small_integers(rings in rings(prop::array::uniform2((-6..6_i32).prop_map(f64::from)), 9)) {
        check(&rings, &[[-7.0, -7.0], [7.0, 7.0], [0.5, 0.5], [-3.5, 2.5]]);
    }

    #[test]
    fn short_steps(
        start in prop::collection::vec(prop::array::uniform2((0..12_i32).prop_map(f64::from)), 1..8),
        steps in prop::collection::vec(prop::array::uniform2((-1..2_i32).prop_map(f64::from)), 2..9),
    ) {
        let walk = |&[x, y]: &[f64; 2]| steps.iter().map(|[dx, dy]| [x + dx, y + dy]).collect();
        check(&start.iter().map(walk).collect::<Vec<_>>(), &[[5.5, 5.5], [0.5, -0.5]]);
    }

    #[test]
    fn all_finite_doubles(rings in rings(prop::array::uniform2(finite()), 5), q in prop::array::uniform2(finite())) {
        check(&rings, &[q]);
    }
}
