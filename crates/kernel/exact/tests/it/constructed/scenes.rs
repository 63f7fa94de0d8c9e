//! Scenes with constructed vertices, and judged queries about them.

use predicament_exact::constructed::{Constructed, FILTER};
use predicament_predicates::{Axis, Construction, Dimension, Plane, Scene, Share, Sign, Vertex};

use rug::Rational;

use super::judge::{Judge, PLANES};
use crate::common::Random;

/// The counts of a check, so that a test can verify its coverage.
#[derive(Clone, Copy, Default, Debug)]
pub struct Seen {
    /// The number of queries by answer: negative, zero, positive.
    pub signs: [usize; 3],
    /// The number of queries that the filter settled.
    pub filtered: usize,
}

impl Seen {
    fn add(&mut self, truth: Sign, stage: usize) {
        self.signs[usize::try_from(truth.as_i8() + 1).unwrap()] += 1;
        self.filtered += usize::from(stage == FILTER);
    }

    pub fn all(&self) -> usize {
        self.signs.iter().sum()
    }
}

/// Distinct vertices below n.
pub fn distinct<const N: usize>(random: &mut Random, n: usize) -> [Vertex; N] {
    loop {
        let mut picked: [usize; N] = std::array::from_fn(|_| random.below(n));
        let vertices = picked.map(Vertex::input);
        picked.sort_unstable();
        if picked.windows(2).all(|pair| pair[0] < pair[1]) {
            return vertices;
        }
    }
}

/// A random construction for scenes of this dimension.
pub fn any(random: &mut Random, dimension: Dimension, n: usize) -> Construction {
    match dimension {
        _ if random.below(4) == 0 => Construction::Ratio { ends: distinct(random, n), share: share(random) },
        Dimension::Two => Construction::Ssi([distinct(random, n), distinct(random, n)]),
        Dimension::Three if random.below(2) == 0 => {
            Construction::Lpi { line: distinct(random, n), plane: distinct(random, n) }
        }
        Dimension::Three => Construction::Tpi([distinct(random, n), distinct(random, n), distinct(random, n)]),
    }
}

/// A share of few digits or of many, within the segment or outside of it.
pub fn share(random: &mut Random) -> Share {
    let most = [7, 1000, Share::MOST][random.below(3)];
    let whole = |random: &mut Random| i64::try_from(random.below(usize::try_from(most).unwrap())).unwrap();
    loop {
        let (numerator, denominator) = (whole(random) * [1, -1][random.below(2)], whole(random) + 1);
        if let Ok(share) = Share::new(numerator, denominator) {
            return share;
        }
    }
}

/// Adds up to `count` constructions that define a point; the others must be declined.
pub fn construct(random: &mut Random, scene: &mut Scene, count: usize) {
    let judge = Judge::new(scene);
    let inputs = scene.clone();
    for _ in 0..count {
        let construction = any(random, scene.dimension(), scene.len());
        let mut alone = inputs.clone();
        alone.construct(construction).expect("input vertices of the scene");
        let is_point = judge.meet(&construction).is_some();
        assert_eq!(Constructed::new(&alone).is_ok(), is_point, "{construction} of {inputs:?}");
        if is_point {
            scene.construct(construction).expect("as alone");
        }
    }
}

/// Queries every axis and plane, with constructed vertices in some places and input vertices in the others.
///
/// It queries with and without the filter.
pub fn check(random: &mut Random, scene: &Scene, rounds: usize) -> Seen {
    let judge = Judge::new(scene);
    let constructed = Constructed::new(scene).expect("every construction defines a point");
    let mut seen = Seen::default();
    check_approximations(scene, &judge, &constructed);
    let (n, m) = (scene.len(), scene.constructions().len());
    for _ in 0..rounds {
        let any: [Vertex; 4] = std::array::from_fn(|_| match random.below(2) {
            0 => Vertex::input(random.below(n)),
            _ => Vertex::constructed(random.below(m)),
        });
        check_one(&judge, &constructed, scene, any, &mut seen);
    }
    seen
}

/// Checks that the approximate coordinates are as good as the first and the second filter assume.
pub fn check_approximations(scene: &Scene, judge: &Judge, ours: &Constructed) {
    let power = |exponent: i32| Rational::from(1) << exponent;
    for v in (0..scene.constructions().len()).map(Vertex::constructed) {
        for (&x, truth) in ours.approximation(v).iter().zip(judge.point(v)) {
            let Some(x) = Rational::from_f64(x) else {
                assert!(truth.clone().abs() >= power(999), "{truth} is no reason for {x}");
                continue;
            };
            let granted = x.clone().abs() * Rational::from((65, 64)) * power(-53) + power(-400);
            assert!(Rational::from(&x - truth).abs() <= granted, "{x} for {truth}");
        }
        let (near, slack) = ours.near(v);
        for (&x, truth) in near.iter().zip(judge.point(v)) {
            // (A slack of NaN belongs to numbers that are too large for doubles.)
            let (Some(x), Some(slack)) = (Rational::from_f64(x), Rational::from_f64(slack)) else {
                assert!(slack.is_nan());
                continue;
            };
            assert!(Rational::from(&x - truth).abs() <= slack.clone() * power(-53), "{v}: {x}, {slack}, for {truth}");
        }
    }
}

/// Checks the queries of four given vertices.
pub fn check_one(judge: &Judge, ours: &Constructed, scene: &Scene, [a, b, c, d]: [Vertex; 4], seen: &mut Seen) {
    let (axes, planes): (&[Axis], &[Plane]) = match scene.dimension() {
        Dimension::Two => (&[Axis::X, Axis::Y], &[Plane::Xy]),
        Dimension::Three => (&[Axis::X, Axis::Y, Axis::Z], &PLANES),
    };
    for &axis in axes {
        let truth = judge.compare(axis, [a, b]);
        let (sign, stage) = ours.compare(axis, a, b);
        assert_eq!(sign, truth, "{axis:?} {a} {b} {scene:?}");
        assert_eq!(ours.compare_exactly(axis, [a, b]), truth, "{axis:?} {a} {b} exactly {scene:?}");
        // The filters alone: they answer exactly if they are the stage.
        assert_eq!(ours.compare_by_filter(axis, a, b), (stage == FILTER).then_some(truth), "{axis:?} {a} {b}");
        seen.add(truth, stage);
    }
    for &plane in planes {
        let truth = judge.orient2d(plane, [a, b, c]);
        let (sign, stage) = ours.orient2d(plane, a, b, c);
        assert_eq!(sign, truth, "{plane:?} {a} {b} {c} {scene:?}");
        assert_eq!(ours.orient2d_exactly(plane, [a, b, c]), truth, "{plane:?} {a} {b} {c} exactly {scene:?}");
        assert_eq!(
            ours.orient2d_by_filter(plane, a, b, c),
            (stage == FILTER).then_some(truth),
            "{plane:?} {a} {b} {c}"
        );
        seen.add(truth, stage);
    }
    if scene.dimension() == Dimension::Two {
        // Always exactly: there is no filter whose share could be counted.
        assert_eq!(ours.incircle([a, b, c, d]).0, judge.incircle([a, b, c, d]), "circle {a} {b} {c} {d} {scene:?}");
    }
    if scene.dimension() == Dimension::Three {
        let truth = judge.orient3d([a, b, c, d]);
        let (sign, stage) = ours.orient3d(a, b, c, d);
        assert_eq!(sign, truth, "{a} {b} {c} {d} {scene:?}");
        assert_eq!(ours.orient3d_exactly([a, b, c, d]), truth, "{a} {b} {c} {d} exactly {scene:?}");
        seen.add(truth, stage);
    }
}

/// N random points of this dimension.
pub fn scene(random: &mut Random, dimension: Dimension, n: usize, mut value: impl FnMut(&mut Random) -> f64) -> Scene {
    Scene::new(dimension, (0..n * dimension.count()).map(|_| value(random)).collect()).expect("finite")
}
