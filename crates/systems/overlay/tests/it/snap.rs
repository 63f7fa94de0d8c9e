//! Tests of snap rounding against its definition, and of planted faults.

use std::collections::BTreeSet;

use predicament_overlay::algorithm::snap::{Drawing, Method, SnapError, Snapped, snap};
use predicament_overlay::checks::snap::{Flaw, Pixel, Promise, Rounded, flaws};

/// A linear congruential generator (Knuth's MMIX constants).
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
        // In doubles: the coordinates of these tests are multiples of 2^-7 below 2^7, so a turn is exact.
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
                counted(&lines, &snapped, exponent);
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

/// Compares the reported statistics of a drawing with its chains.
fn counted(lines: &Lines, snapped: &Snapped, exponent: i32) {
    assert_eq!(snapped.merged + snapped.pixels.len(), lines.points.len() + lines.crossings.len());
    assert!(snapped.pixels.windows(2).all(|pair| pair[0] < pair[1]), "each once, ascending");
    let mut edges = BTreeSet::new();
    let mut drift = 0.0_f64;
    for (chain, ends) in snapped.chains.iter().zip(&lines.segments) {
        edges.extend(chain.windows(2).map(|edge| [edge[0].min(edge[1]), edge[0].max(edge[1])]));
        // In the drawing's own units.
        let [a, b] = ends.map(|v| lines.points[v as usize]);
        for &pixel in chain {
            let p = snapped.centre(pixel, exponent);
            let [ab, ap] = [b, p].map(|q| [q[0] - a[0], q[1] - a[1]]);
            let square = ab[0] * ab[0] + ab[1] * ab[1];
            let part = if square > 0.0 { ((ab[0] * ap[0] + ab[1] * ap[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
            drift = drift.max((ap[0] - part * ab[0]).hypot(ap[1] - part * ab[1]));
        }
    }
    assert_eq!(snapped.edges(), edges.into_iter().collect::<Vec<_>>());
    let told = snapped.drift(lines.drawing(), exponent) * 2.0_f64.powi(exponent);
    assert!((told - drift).abs() < 1e-9, "{told} for {drift}");
}

#[test]
fn points_on_segments_are_told_to_chains_of_rounded_points() {
    // An end on a long segment, and one near it.
    let points = [[0.0, 0.0], [9.0, 9.0], [3.0, 3.0], [3.0, 8.0], [6.0, 6.25], [6.0, 8.0]];
    let chain = |touching: &[[u32; 2]]| {
        let drawing = Drawing { points: &points, segments: &[[0, 1], [2, 3], [4, 5]], crossings: &[], touching };
        chains(&snap(drawing, 0, Method::Naive).unwrap())[0].clone()
    };
    assert_eq!(chain(&[]), [[0, 0], [9, 9]]);
    assert_eq!(chain(&[[0, 2], [0, 0]]), [[0, 0], [3, 3], [9, 9]]);
}

/// An integer below 2^53.
#[allow(clippy::cast_precision_loss)] // below 2^53
fn double(i: i64) -> f64 {
    i as f64
}

/// A segment that passes through a point; integer weights of a direction give its ends on both sides.
fn through(at: [f64; 2], direction: [i64; 2], weights: [u32; 2]) -> [[f64; 2]; 2] {
    let [back, forth] = weights.map(f64::from);
    let along = direction.map(double);
    [[at[0] - back * along[0], at[1] - back * along[1]], [at[0] + forth * along[0], at[1] + forth * along[1]]]
}

#[test]
fn crossings_on_the_sides_of_pixels_are_in_the_right_ones() {
    // Nearly parallel, so that estimates are off by many pixels, through a corner of pixels or a thousandth of a pixel
    // beside it.
    let mut random = Random(2);
    let mut large = || i64::from(random.below(1 << 30)) - (1 << 29);
    for round in 0..400_u32 {
        let direction = [large(), large()];
        let near = [direction[0] + large() % 4, direction[1] + 1 + large() % 4];
        if direction[0] * near[1] == direction[1] * near[0] {
            continue;
        }
        let off = [0.0, 1.0 / 1024.0, -1.0 / 1024.0][round as usize % 3];
        let at = [double(large() / 512) + 0.5 + off, double(large() / 512) - 0.5];
        let [e, f] = [(direction, [1 + round % 3, 2]), (near, [3, 1 + round % 2])]
            .map(|(direction, weights)| through(at, direction, weights));
        let lines = Lines { points: [e, f].concat(), segments: vec![[0, 1], [2, 3]], crossings: vec![[0, 1]] };
        let snapped = snap(lines.drawing(), 0, Method::Snap).unwrap();
        assert_eq!(lines.flaws(&chains(&snapped), 0, Promise::Snapped), [], "round {round}");
    }
}

/// Integers x and y with a·y − b·x = 1, for coprime a and b.
fn unit([a, b]: [i64; 2]) -> Option<[i64; 2]> {
    let (mut r, mut s) = ((a, [1, 0]), (b, [0, 1]));
    while s.0 != 0 {
        let times = r.0 / s.0;
        let rest = (r.0 - times * s.0, [0, 1].map(|i: usize| r.1[i] - times * s.1[i]));
        (r, s) = (s, rest);
    }
    (r.0 == 1).then_some([-r.1[1], r.1[0]])
}

#[test]
fn segments_that_miss_a_corner_by_nothing_that_doubles_can_see_are_on_the_right_side() {
    // Between two corners of pixels, past a third one on either side: by less than 2^-40 of a pixel.
    let mut random = Random(3);
    let mut tried = 0;
    for round in 0..200 {
        let large =
            |random: &mut Random| (i64::from(random.below(1 << 31)) << 13) + i64::from(random.below(1 << 13)) + 1;
        let direction = [large(&mut random), large(&mut random)];
        let Some(beside) = unit(direction) else { continue };
        tried += 1;
        // The other way for a descending slope; around the other corner of the segment on the other side.
        let down = if round % 2 == 0 { 1 } else { -1 };
        let other = [direction[0] - beside[0], direction[1] - beside[1]];
        let corners = [[0, 0], beside, other, direction].map(|[x, y]| [x, down * y]);
        // For an ascending slope the lower right or the upper left corner decides; for a descending slope the lower
        // left one.
        let middle = |[x, y]: [i64; 2]| {
            let side = if down == 1 && round % 4 == 0 {
                [-1, 1]
            } else if down == 1 {
                [1, -1]
            } else {
                [1, 1]
            };
            [double(x) + double(side[0]) / 2.0, double(y) + double(side[1]) / 2.0]
        };
        let ends = [corners[0], corners[3]].map(|corner| corner.map(double));
        // Eight pixels around each corner: a leaf of the tree, of which only the first may be met.
        let mut points = ends.to_vec();
        for [x, y] in corners.map(middle) {
            points.extend((0..8).map(|at| [x + f64::from(at % 4), y + double(down) * f64::from(at / 4)]));
        }
        let moved = points.iter().map(|[x, y]| [x - 0.5, y - 0.5]).collect();
        let count = u32::try_from(points.len()).unwrap();
        let mut segments = vec![[0, 1]];
        segments.extend((2..count).map(|at| [at, at]));
        let lines = Lines { points: moved, segments, crossings: Vec::new() };
        let snapped = snap(lines.drawing(), 0, Method::Snap).unwrap();
        assert_eq!(lines.flaws(&chains(&snapped), 0, Promise::Snapped), [], "round {round}");
    }
    assert!(tried > 80, "{tried}");
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
    // Nearly parallel, and so far from the origin that the estimate is useless.
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
    assert_eq!(refused(&[[f64::from_bits(1), 0.0]], &[], &[], 10), SnapError::Point(0), "not scaled exactly");
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
