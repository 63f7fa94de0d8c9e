//! Snap rounding against its definition, and faults that are found.

use predicament_algorithms::snap::{Drawing, Method, SnapError, Snapped, snap};
use predicament_checks::snap::{Flaw, Pixel, Promise, Rounded, flaws};

/// A linear congruence (Knuth's MMIX constants).
struct Random(u64);

impl Random {
    fn below(&mut self, end: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        u32::try_from(self.0 >> 32).unwrap() % end
    }
}

struct Lines {
    points: Vec<[f64; 2]>,
    segments: Vec<[u32; 2]>,
    crossings: Vec<[u32; 2]>,
}

impl Lines {
    /// Segments between points, with all pairs that cross.
    fn new(points: Vec<[f64; 2]>, segments: Vec<[u32; 2]>) -> Lines {
        let at = |v: u32| points[v as usize];
        // In doubles: those of these tests are multiples of 2^-7 below 2^7, so that a turn is exact.
        let turn = |a: u32, b: u32, c: u32| {
            let [a, b, c] = [a, b, c].map(at);
            let turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            turn.partial_cmp(&0.0).unwrap()
        };
        let mut crossings = Vec::new();
        for (t, &[c, d]) in segments.iter().enumerate() {
            for (s, &[a, b]) in segments.iter().enumerate().take(t) {
                let sides = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)];
                if sides.iter().all(|side| side.is_ne()) && sides[0] != sides[1] && sides[2] != sides[3] {
                    crossings.push([s, t].map(|at| u32::try_from(at).unwrap()));
                }
            }
        }
        Lines { points, segments, crossings }
    }

    fn random(random: &mut Random, segments: u32, extent: u32) -> Lines {
        let points: Vec<[f64; 2]> =
            (0..2 * segments).map(|_| [0, 1].map(|_| f64::from(random.below(128 * extent)) / 128.0 - 3.0)).collect();
        Lines::new(points, (0..segments).map(|at| [2 * at, 2 * at + 1]).collect())
    }

    fn drawing(&self) -> Drawing<'_> {
        Drawing { points: &self.points, segments: &self.segments, crossings: &self.crossings, touching: &[] }
    }

    fn flaws(&self, chains: &[Vec<Pixel>], exponent: i32, promise: Promise) -> Vec<Flaw> {
        let Lines { points, segments, crossings } = self;
        flaws(Rounded { points, segments, crossings, exponent, chains, step: 1 }, promise)
    }
}

fn chains(snapped: &Snapped) -> Vec<Vec<Pixel>> {
    let of = |chain: &Vec<u32>| chain.iter().map(|&at| snapped.pixels[at as usize]).collect();
    snapped.chains.iter().map(of).collect()
}

const BOTH: [(Method, Promise); 2] = [(Method::Snap, Promise::Snapped), (Method::Iterated, Promise::Iterated)];

#[test]
fn random_drawings_are_rounded_as_defined() {
    let mut random = Random(1);
    let (mut longer, mut merged, mut naive) = (0, 0, 0);
    for round in 0..40 {
        let lines = Lines::random(&mut random, 2 + round % 23, [4, 16, 60][round as usize % 3]);
        for exponent in [-3, 0, 1] {
            let mut drawn = Vec::new();
            for (method, promise) in BOTH {
                let snapped = snap(lines.drawing(), exponent, method).unwrap();
                assert_eq!(lines.flaws(&chains(&snapped), exponent, promise), [], "{round}, 2^{exponent}, {method:?}");
                // Half the diagonal of a pixel.
                let drift = snapped.drift(lines.drawing(), exponent);
                assert!(method == Method::Iterated || drift <= 0.5_f64.sqrt() + 1e-9, "{drift}");
                merged += snapped.merged;
                drawn.push(snapped);
            }
            longer += usize::from(drawn[0].chains != drawn[1].chains);
            let rounded = snap(lines.drawing(), exponent, Method::Naive).unwrap();
            naive += usize::from(
                lines
                    .flaws(&chains(&rounded), exponent, Promise::Iterated)
                    .iter()
                    .any(|flaw| matches!(flaw, Flaw::Crossing(..))),
            );
        }
    }
    assert!(longer > 3 && merged > 300 && naive > 10, "{longer} iterated, {merged} merged, {naive} naive ones cross");
}

#[test]
fn a_pixel_has_its_lower_sides() {
    // Along the upper and the lower side of the pixel at 0, and through its corners.
    let lines = |a: [f64; 2], b: [f64; 2]| Lines::new(vec![[0.0, 0.0], [0.0, 0.0], a, b], vec![[0, 1], [2, 3]]);
    for (a, b, is_met) in [
        ([-2.0, 0.5], [2.0, 0.5], false),
        ([-2.0, -0.5], [2.0, -0.5], true),
        ([0.5, -2.0], [0.5, 2.0], false),
        ([-0.5, -2.0], [-0.5, 2.0], true),
        ([-1.5, 0.5], [0.5, -1.5], true),
        ([-0.5, 1.5], [1.5, -0.5], false),
        ([-1.5, -0.5], [0.5, 1.5], false),
        ([-0.5, -1.5], [1.5, 0.5], false),
        ([0.5, 2.0], [0.4375, 0.4375], true),
        ([0.5, 2.0], [0.5, 0.4375], false),
    ] {
        let lines = lines(a, b);
        for (a, b) in [(2, 3), (3, 2)] {
            let lines = Lines { segments: vec![[0, 1], [a, b]], points: lines.points.clone(), crossings: Vec::new() };
            let snapped = snap(lines.drawing(), 0, Method::Snap).unwrap();
            assert_eq!(chains(&snapped)[1].contains(&[0, 0]), is_met, "{a:?} {b:?}");
            assert_eq!(lines.flaws(&chains(&snapped), 0, Promise::Snapped), []);
        }
    }
}

#[test]
fn crossings_far_from_their_estimate_are_found() {
    // Nearly parallel, and so far from the origin that the estimate is worth nothing.
    let far = 2_f64.powi(40);
    for up in [1.0, 3.0, 1e-9] {
        let lines = Lines {
            points: vec![[-far, -1.0 - up], [far, 1.0 + up], [-far, -1.0], [far, 1.0 + up / 3.0]],
            segments: vec![[0, 1], [2, 3]],
            crossings: vec![[0, 1]],
        };
        for (method, promise) in BOTH {
            let snapped = snap(lines.drawing(), 0, method).unwrap();
            assert_eq!(lines.flaws(&chains(&snapped), 0, promise), [], "{up}");
        }
    }
}

#[test]
fn what_is_no_drawing_is_refused() {
    let points = [[0.0, 0.0], [2.0, 2.0], [0.0, 1.0], [2.0, 3.0], [f64::NAN, 0.0], [2_f64.powi(50), 0.0]];
    let refused = |points: &[[f64; 2]], segments: &[[u32; 2]], crossings: &[[u32; 2]], exponent: i32| {
        snap(Drawing { points, segments, crossings, touching: &[] }, exponent, Method::Snap).unwrap_err()
    };
    assert_eq!(refused(&points[..5], &[], &[], 0), SnapError::Point(4));
    assert_eq!(refused(&[points[0], points[5]], &[], &[], 0), SnapError::Point(1));
    assert_eq!(refused(&[[2_f64.powi(-1074), 0.0]], &[], &[], 10), SnapError::Point(0), "not scaled exactly");
    assert_eq!(refused(&points[..4], &[[0, 4]], &[], 0), SnapError::Segment(0));
    assert_eq!(refused(&points[..4], &[[0, 1], [2, 3]], &[[0, 1]], 0), SnapError::Crossing(0), "parallel");
    assert_eq!(refused(&points[..4], &[[0, 2], [1, 3]], &[[0, 1]], 0), SnapError::Crossing(0), "apart");
    assert_eq!(refused(&points[..4], &[[0, 1]], &[[0, 1]], 0), SnapError::Crossing(0), "not there");
    for why in [SnapError::Point(4), SnapError::Segment(1), SnapError::Crossing(2)] {
        assert_eq!(why.to_string().lines().count(), 1);
    }
}

#[test]
fn each_fault_is_found() {
    // A cross, a vertex near one of its arms, and one far away.
    let lines = Lines::new(
        vec![[0.0, 0.0], [8.0, 4.25], [0.0, 4.0], [8.0, 0.0], [2.0, 1.0], [2.0, 7.0], [20.0, 20.0], [21.0, 20.0]],
        vec![[0, 1], [2, 3], [4, 5], [6, 7]],
    );
    let snapped = snap(lines.drawing(), 0, Method::Snap).unwrap();
    let right = chains(&snapped);
    assert_eq!(lines.flaws(&right, 0, Promise::Snapped), []);
    let found = |change: &dyn Fn(&mut Vec<Vec<Pixel>>), promise: Promise| -> Vec<&'static str> {
        let mut changed = right.clone();
        change(&mut changed);
        let mut names: Vec<_> = lines.flaws(&changed, 0, promise).iter().map(Flaw::name).collect();
        names.dedup();
        names
    };
    assert!(found(&|chains| chains[3].truncate(1), Promise::Snapped).contains(&"ends"));
    assert!(found(&|chains| chains[3].insert(1, [20, 21]), Promise::Snapped).contains(&"hot pixels only"));
    let middle = right[0].iter().position(|pixel| *pixel == [2, 1]).expect("the end near the arm");
    let without = |chains: &mut Vec<Vec<Pixel>>| {
        chains[0].remove(middle);
    };
    assert!(found(&without, Promise::Snapped).contains(&"all hot pixels"));
    assert!(found(&|chains| chains[3].insert(1, [8, 4]), Promise::Snapped).contains(&"own hot pixels only"));
    assert!(found(&|chains| chains[0].insert(1, [8, 4]), Promise::Snapped).contains(&"one way"));
    assert!(
        found(&|chains| chains[0].retain(|p| *p == [0, 0] || *p == [8, 4]), Promise::Snapped)
            .contains(&"no new crossing")
    );
    assert!(found(&without, Promise::Iterated).contains(&"no vertex near an edge"));
}
