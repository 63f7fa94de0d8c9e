//! Thick primitives: three sides, and drawings without overlaps.

use predicament_contacts::algorithm::thick::{Disc, Drawing, Edge, MOST_ROUNDS, Settled, Side, settle, side};
use rug::Rational;

/// A stream of pseudorandom numbers (Steele, Lea and Flood's SplitMix).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number in [0, 1).
    fn unit(&mut self) -> f64 {
        f64::from(u32::try_from(self.bits() >> 32).unwrap()) / 4_294_967_296.0
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + self.unit() * (high - low)
    }
}

fn disc(x: f64, y: f64, radius: f64) -> Disc {
    Disc { centre: [x, y], radius }
}

fn edge(from: u32, to: u32, radius: f64) -> Edge {
    Edge { ends: [from, to], radius, passes: [1, 0] }
}

fn distance([a, b]: [[f64; 2]; 2], p: [f64; 2]) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let square = along[0] * along[0] + along[1] * along[1];
    let part = ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / square;
    let part = if square > 0.0 { part.clamp(0.0, 1.0) } else { 0.0 };
    (p[0] - a[0] - part * along[0]).hypot(p[1] - a[1] - part * along[1])
}

#[test]
fn a_point_is_left_right_or_on() {
    let line = [[0.0, 0.0], [4.0, 0.0]];
    for (p, radius, expected) in [
        (disc(2.0, 1.0, 0.25), 0.25, Side::Left),
        (disc(2.0, -1.0, 0.25), 0.25, Side::Right),
        (disc(2.0, 0.5, 0.25), 0.25, Side::On),
        (disc(2.0, -0.5, 0.25), 0.25, Side::On),
        (disc(4.5, 0.0, 0.25), 0.25, Side::On),
        (disc(4.75, 0.125, 0.25), 0.25, Side::Left),
        (disc(2.0, 0.0, 0.0), 0.0, Side::On),
    ] {
        assert_eq!(side(line, radius, p), expected, "{p:?}");
        let back = match expected {
            Side::Left => Side::Right,
            Side::On => Side::On,
            Side::Right => Side::Left,
        };
        assert_eq!(side([line[1], line[0]], radius, p), back, "seen from the other end");
    }
}

#[test]
fn discs_merge_edges_are_divided_and_crossings_become_discs() {
    // Two ends that overlap.
    let drawing = Drawing {
        discs: vec![disc(0.0, 0.0, 0.125), disc(4.0, 0.0, 0.125), disc(4.125, 0.0, 0.125), disc(4.0, 4.0, 0.125)],
        edges: vec![edge(0, 1, 0.0), edge(2, 3, 0.0)],
    };
    let settled = settle(drawing);
    assert!(settled.is_settled);
    assert_eq!((settled.merged, settled.divided, settled.crossed), (1, 0, 0));
    assert_eq!((settled.drawing.discs.len(), settled.drawing.edges.len()), (3, 2));
    let merged = settled.drawing.discs[1];
    assert!((merged.centre[0] - 4.0625).abs() < 1e-12 && (0.1875..0.1876).contains(&merged.radius), "{merged:?}");
    // A vertex on an edge.
    let drawing = Drawing {
        discs: vec![disc(0.0, 0.0, 0.125), disc(4.0, 0.0, 0.125), disc(2.0, 0.125, 0.125), disc(2.0, 3.0, 0.125)],
        edges: vec![edge(0, 1, 0.0625), edge(2, 3, 0.0625)],
    };
    let settled = settle(drawing);
    assert_eq!((settled.merged, settled.divided, settled.crossed), (0, 1, 0));
    assert_eq!(settled.drawing.edges.len(), 3);
    let thickest = settled.drawing.edges.iter().map(|edge| edge.radius).fold(0.0, f64::max);
    assert!((0.1875..0.1876).contains(&thickest), "as thick as the way that it was moved: {thickest}");
    // A crossing.
    let drawing = Drawing {
        discs: vec![disc(0.0, 0.0, 0.0), disc(4.0, 4.0, 0.0), disc(0.0, 4.0, 0.0), disc(4.0, 0.0, 0.0)],
        edges: vec![edge(0, 1, 0.0), edge(2, 3, 0.0)],
    };
    let settled = settle(drawing);
    assert_eq!((settled.merged, settled.divided, settled.crossed), (0, 0, 1));
    assert_eq!((settled.drawing.discs[4].centre, settled.drawing.edges.len()), ([2.0, 2.0], 4));
}

#[test]
fn edges_that_are_passed_to_and_fro_are_gone() {
    let there = Edge { ends: [0, 1], radius: 0.0, passes: [1, 0] };
    let back = Edge { ends: [1, 0], radius: 0.25, passes: [1, 0] };
    let both = Drawing { discs: vec![disc(0.0, 0.0, 0.0), disc(1.0, 0.0, 0.0)], edges: vec![there, back] };
    assert_eq!(settle(both.clone()).drawing, Drawing::default());
    let twice = Drawing { edges: vec![there, Edge { passes: [-1, 1], ..back }], ..both };
    let settled = settle(twice).drawing;
    assert_eq!(settled.edges, [Edge { ends: [0, 1], radius: 0.25, passes: [2, -1] }]);
    assert!(settled.discs.iter().all(|disc| disc.radius == 0.25), "a vertex is as thick as its edges");
}

/// Closed chains of random points, a few of them near earlier ones.
fn tangle(count: u32, radius: f64, random: &mut Random) -> Drawing {
    let mut drawing = Drawing::default();
    for at in 0..count {
        let centre = match drawing.discs.last() {
            Some(&Disc { centre: [x, y], .. }) if random.bits().is_multiple_of(4) => {
                [x + random.between(-2.0, 2.0) * radius, y + random.between(-2.0, 2.0) * radius]
            }
            _ => [random.unit(), random.unit()],
        };
        drawing.discs.push(Disc { centre, radius });
        let operand = at % 2;
        let next = if at + 2 < count { at + 2 } else { operand };
        let passes = if operand == 0 { [1, 0] } else { [0, 1] };
        drawing.edges.push(Edge { ends: [at, next], radius, passes });
    }
    drawing
}

/// For each disc and operand, the number of passes that leave the disc minus the number that arrive.
fn balance(drawing: &Drawing) -> Vec<[i32; 2]> {
    let mut balance = vec![[0; 2]; drawing.discs.len()];
    for edge in &drawing.edges {
        for (end, sign) in edge.ends.into_iter().zip([1, -1]) {
            balance[end as usize].iter_mut().zip(edge.passes).for_each(|(sum, times)| *sum += sign * times);
        }
    }
    balance
}

fn overlaps(settled: &Settled) -> usize {
    let Drawing { discs, edges } = &settled.drawing;
    let line = |edge: &Edge| edge.ends.map(|end| discs[end as usize].centre);
    let apart = |a: &Disc, b: &Disc| (a.centre[0] - b.centre[0]).hypot(a.centre[1] - b.centre[1]);
    let mut count = 0;
    for (at, disc) in (0..).zip(discs) {
        count += discs[..at as usize].iter().filter(|other| apart(disc, other) <= disc.radius + other.radius).count();
        let foreign = edges.iter().filter(|edge| !edge.ends.contains(&at));
        count += foreign.filter(|edge| side(line(edge), edge.radius, *disc) == Side::On).count();
    }
    count
}

#[test]
fn nothing_overlaps_afterwards_chains_stay_closed_and_everything_is_covered() {
    for seed in 0..40 {
        let mut random = Random(seed);
        let radius = [0.0, 1e-9, 1e-4, 1e-3][usize::try_from(seed % 4).unwrap()];
        let before = tangle(24, radius, &mut random);
        let settled = settle(before.clone());
        assert!(settled.is_settled && settled.crossed > 0, "seed {seed}");
        assert_eq!(overlaps(&settled), 0, "seed {seed}");
        assert!(balance(&settled.drawing).iter().all(|sum| *sum == [0, 0]), "seed {seed}");
    }
}

#[test]
fn everything_is_covered_by_what_has_become_of_it() {
    let mut swallowed = 0;
    for seed in 0..40 {
        let mut random = Random(seed);
        let radius = [0.0, 1e-9, 1e-4, 1e-3][usize::try_from(seed % 4).unwrap()];
        let mut before = tangle(24, radius, &mut random);
        // All numbers of passes differ, so an edge is never removed because another one goes back.
        for (at, edge) in before.edges.iter_mut().enumerate() {
            edge.passes = [1 << at, 0];
        }
        let settled = settle(before.clone());
        let Drawing { discs, edges } = &settled.drawing;
        if edges.is_empty() {
            // The whole drawing became one disc, which has no edges and is removed.
            swallowed += 1;
            continue;
        }
        for edge in &before.edges {
            let [a, b] = edge.ends.map(|end| before.discs[end as usize].centre);
            for _ in 0..8 {
                let t = random.unit();
                let p = [0, 1].map(|i: usize| a[i] + t * (b[i] - a[i]));
                let covers =
                    |edge: &Edge| distance(edge.ends.map(|end| discs[end as usize].centre), p) <= edge.radius + 1e-15;
                let is_in = |disc: &Disc| (p[0] - disc.centre[0]).hypot(p[1] - disc.centre[1]) <= disc.radius + 1e-15;
                assert!(edges.iter().any(covers) || discs.iter().any(is_in), "seed {seed}: {p:?} of {edge:?}");
            }
        }
    }
    assert!((1..=10).contains(&swallowed), "of the thickest, some are: {swallowed}");
}

#[test]
fn radii_as_large_as_everything_end_in_one_disc_or_none() {
    let mut random = Random(1);
    let settled = settle(tangle(24, 0.5, &mut random));
    assert!(settled.is_settled && settled.drawing.edges.is_empty(), "{} rounds are enough", MOST_ROUNDS);
}

/// A drawing of discs and edges of radius 0, each with a different number of passes.
fn drawn(discs: Vec<Disc>, ends: &[[u32; 2]]) -> Drawing {
    let edges = (1..).zip(ends).map(|(times, &ends)| Edge { ends, radius: 0.0, passes: [times, 0] }).collect();
    Drawing { discs, edges }
}

#[test]
fn what_is_done_is_counted() {
    // The first two discs become one that reaches the third: two rounds.
    let far = disc(9.0, 0.0, 0.0);
    let settled = settle(drawn(
        vec![disc(0.0, 0.0, 1.0), disc(1.75, 0.0, 1.0), disc(0.875, 2.5, 0.75), far],
        &[[0, 3], [1, 3], [2, 3]],
    ));
    assert_eq!((settled.merged, settled.divided, settled.crossed), (2, 0, 0));
    // Two vertices on one edge.
    let on =
        vec![disc(0.0, 0.0, 0.0), disc(8.0, 0.0, 0.0), disc(5.0, 0.0, 0.0), disc(2.0, 0.0, 0.0), disc(3.0, 4.0, 0.0)];
    let settled = settle(drawn(on, &[[0, 1], [2, 4], [3, 4]]));
    assert_eq!((settled.merged, settled.divided, settled.crossed, settled.drawing.edges.len()), (0, 2, 0, 5));
    // Three edges across one, not in their order along it: the parts are consecutive, and touch nothing else.
    let mut across = vec![disc(0.0, 0.0, 0.0), disc(8.0, 0.0, 0.0)];
    across.extend([6.0, 1.0, 3.0].into_iter().flat_map(|x| [disc(x, -1.0, 0.0), disc(x, 5.0, 0.0)]));
    let settled = settle(drawn(across, &[[0, 1], [2, 3], [4, 5], [6, 7]]));
    assert_eq!((settled.merged, settled.divided, settled.crossed, settled.drawing.edges.len()), (0, 0, 3, 10));
    assert_eq!(settled.largest(), settled.drawing.discs.iter().map(|disc| disc.radius).fold(0.0, f64::max));
    assert_eq!(settle(drawn(vec![disc(0.0, 0.0, 0.25), far], &[[0, 1]])).largest(), 0.25, "a disc thicker than edges");
}

#[test]
fn drawings_that_take_too_many_rounds_are_told() {
    // A large disc and small ones: each touches the disc that covers the previous ones, and nothing else.
    let spiral = |count: u32| {
        let mut discs = vec![disc(0.0, 0.0, 16.0)];
        let ([mut x, mut y], mut radius) = ([0.0, 0.0], 16.0);
        for at in 0..count {
            let [u, v] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][at as usize % 4];
            let out = radius + 0.5;
            discs.push(disc(x + out * u, y + out * v, 1.0));
            // The cover of both goes 3/2 beyond the old one on this side.
            (x, y, radius) = (x + 0.75 * u, y + 0.75 * v, radius + 0.75);
        }
        discs.push(disc(1e4, 0.0, 0.0));
        let ends: Vec<[u32; 2]> = (0..=count).map(|at| [at, count + 1]).collect();
        settle(drawn(discs, &ends))
    };
    let few = spiral(20);
    assert!(few.is_settled && few.merged == 20, "{}", few.merged);
    let many = spiral(u32::try_from(MOST_ROUNDS).unwrap() + 6);
    assert!(!many.is_settled);
    assert_eq!(many.merged, MOST_ROUNDS, "one a round");
}

fn square(from: [&Rational; 2], to: [f64; 2]) -> Rational {
    let minus = |i: usize| Rational::from_f64(to[i]).unwrap() - from[i];
    minus(0).square() + minus(1).square()
}

/// True if a disc covers another one, in rationals.
fn covers(disc: Disc, other: Disc) -> bool {
    let [x, y] = disc.centre.map(|x| Rational::from_f64(x).unwrap());
    let spare = Rational::from_f64(disc.radius).unwrap() - Rational::from_f64(other.radius).unwrap();
    spare >= 0 && spare.square() >= square([&x, &y], other.centre)
}

#[test]
fn discs_cover_what_they_have_come_from_whatever_was_rounded() {
    let mut random = Random(7);
    let mut inside = 0;
    for round in 0..2_000 {
        // Near the origin mostly radii are rounded, farther away positions.
        let origin = [0.0, 0.0, 1e3][round % 3];
        let mut one = || disc(origin + random.unit(), origin + random.unit(), random.between(0.0, 1.0));
        let [a, b] = [one(), one()];
        if (a.centre[0] - b.centre[0]).hypot(a.centre[1] - b.centre[1]) > a.radius + b.radius {
            continue;
        }
        let settled = settle(drawn(vec![a, b, disc(-1e4, 0.0, 0.0)], &[[0, 2], [1, 2]]));
        assert_eq!(settled.merged, 1, "round {round}");
        let merged = settled.drawing.discs[0];
        assert!(covers(merged, a) && covers(merged, b), "round {round}: {merged:?} of {a:?} and {b:?}");
        inside += usize::from(merged == a || merged == b);
        // A smaller disc would not cover both, up to rounding.
        let least = ((a.centre[0] - b.centre[0]).hypot(a.centre[1] - b.centre[1]) + a.radius + b.radius) / 2.0;
        assert!(merged.radius <= least.max(a.radius).max(b.radius) * (1.0 + 1e-12) + 1e-12, "round {round}");
    }
    assert!(inside > 50, "discs in discs: {inside}");
}

#[test]
fn edges_cover_what_they_have_come_from_whatever_was_rounded() {
    let mut random = Random(8);
    let exactly = |p: [f64; 2]| p.map(|x| Rational::from_f64(x).unwrap());
    let turn = |a: &[Rational; 2], b: &[Rational; 2], p: &[Rational; 2]| {
        let minus = |p: &[Rational; 2], i: usize| Rational::from(&p[i] - &a[i]);
        minus(b, 0) * minus(p, 1) - minus(b, 1) * minus(p, 0)
    };
    let mut divided = 0;
    for round in 0..1_000 {
        // A vertex beside an edge.
        let left = [0.0, -2.0, 1e3][round % 3];
        let [a, b] = [disc(left, random.unit(), 0.0), disc(left + 4.0, random.unit(), 0.0)];
        // With radius 0, a vertex is on the edge only by rounding.
        let radius = [0.25, 1e-12, 0.0][round / 3 % 3];
        let part = random.unit();
        let on = a.centre[1] + part * (b.centre[1] - a.centre[1]);
        let beside = disc(left + part * 4.0, on + random.between(-0.5, 0.5) * radius, 0.0);
        let mut drawing = drawn(vec![a, b, beside, disc(left + part * 4.0, 9.0, 0.0)], &[[0, 1], [2, 3]]);
        drawing.edges[0].radius = radius;
        let settled = settle(drawing);
        divided += settled.divided;
        let [p, q, r] = [a, b, beside].map(|disc| exactly(disc.centre));
        let away = turn(&p, &q, &r).square() / square([&p[0], &p[1]], b.centre);
        for part in settled.drawing.edges.iter().filter(|edge| edge.passes[0].abs() == 1 && settled.divided > 0) {
            let grown = Rational::from_f64(part.radius).unwrap() - Rational::from_f64(radius).unwrap();
            assert!(grown.square() >= away, "round {round}: {part:?}");
        }
        // A crossing, of edges that are nearly parallel in every other round.
        let tilt = if round / 3 % 2 == 0 { 1.0 } else { 1e-6 };
        let [c, d] = [
            disc(left, a.centre[1] - tilt * random.unit() - 1e-7, 0.0),
            disc(left + 4.0, b.centre[1] + tilt * random.unit() + 1e-7, 0.0),
        ];
        let settled = settle(drawn(vec![a, b, c, d], &[[0, 1], [2, 3]]));
        assert_eq!(settled.crossed, 1, "round {round}");
        let made = settled
            .drawing
            .discs
            .iter()
            .find(|disc| ![a, b, c, d].iter().any(|end| end.centre == disc.centre))
            .unwrap();
        let radius = Rational::from_f64(made.radius).unwrap();
        for [from, to] in [[a, b], [c, d]] {
            let [p, q, r] = [from, to, *made].map(|disc| exactly(disc.centre));
            let away = turn(&p, &q, &r).square() / square([&p[0], &p[1]], to.centre);
            assert!(radius.clone().square() >= away, "round {round}: {made:?}");
        }
        assert!(made.radius < 1e-6, "and no thicker than rounding");
    }
    assert!(divided > 700, "{divided}");
}
