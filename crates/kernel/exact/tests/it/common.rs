//! The independent judge, and points for it.

use predicament_exact::{Exact, raw};
use predicament_predicates::{Axis, Backend, Off, Plane, Predicates, QuerySet, Question, Scene, Sign, Vertex};
use proptest::prelude::*;
use rug::{Integer, Rational};

/// The sign of the determinant of homogeneous rows (p, 1) or (p, |p|², 1), by Bareiss' elimination in integers.
///
/// It uses no differences and no expansion by minors.
fn judge<const D: usize>(points: &[[f64; D]], lifted: bool) -> Sign {
    let rows: Vec<Vec<Rational>> =
        points.iter().map(|p| p.iter().map(|&x| Rational::from_f64(x).expect("finite")).collect()).collect();
    // Scaling the coordinates by a positive number keeps the sign.
    let scale = rows.iter().flatten().map(Rational::denom).max().expect("rows").clone();
    let homogeneous = rows.iter().map(|row| {
        let mut row: Vec<Integer> = row.iter().map(|x| Rational::from(x * &scale).into_numer_denom().0).collect();
        if lifted {
            row.push(row.iter().map(|x| Integer::from(x * x)).sum());
        }
        row.push(Integer::from(1));
        row
    });
    bareiss(homogeneous.collect())
}

fn bareiss(mut m: Vec<Vec<Integer>>) -> Sign {
    let n = m.len();
    let mut sign = Sign::Positive;
    let mut previous = Integer::from(1);
    for k in 0..n - 1 {
        let Some(pivot) = (k..n).find(|&i| !m[i][k].is_zero()) else {
            return Sign::Zero;
        };
        if pivot != k {
            m.swap(pivot, k);
            sign = -sign;
        }
        for i in k + 1..n {
            for j in k + 1..n {
                let entry = Integer::from(&m[i][j] * &m[k][k]) - Integer::from(&m[i][k] * &m[k][j]);
                m[i][j] = entry.div_exact(&previous);
            }
        }
        previous = m[k][k].clone();
    }
    sign * Sign::from(m[n - 1][n - 1].cmp0())
}

/// The turn of three points.
pub fn orient2d(points: &[[f64; 2]; 3]) -> Sign {
    judge(points, false)
}

/// The side of the fourth point on the plane of three.
pub fn orient3d(points: &[[f64; 3]; 4]) -> Sign {
    judge(points, false)
}

/// The position of the fourth point relative to the circle of three.
pub fn incircle(points: &[[f64; 2]; 4]) -> Sign {
    judge(points, true)
}

/// The position of the fifth point relative to the sphere of four.
pub fn insphere(points: &[[f64; 3]; 5]) -> Sign {
    judge(points, true)
}

/// Numbers that widen a scene's exponent range to that of all doubles.
const WIDE: [f64; 3] = [5e-324, f64::MAX, 0.0];

/// Asks the exact backend twice: in a scene of these points alone, and in a very wide scene.
///
/// In the wide scene each query must be planned separately.
fn ask<const D: usize>(question: Question, points: &[[f64; D]], scene: impl Fn(&[[f64; D]]) -> Scene) -> Sign {
    let args: Vec<Vertex> = (0..points.len()).map(Vertex::input).collect();
    let answer = |points: &[[f64; D]]| {
        let scene = scene(points);
        let session = Exact.prepare(&scene, Off).expect("every scene can be prepared");
        session.supports(question.kind()).expect("a scene of the right dimension");
        let single = question.ask(&session, &args);
        // Eight that are processed together, and one more.
        let mut batch = [Sign::Zero; 9];
        QuerySet::new(question, args.repeat(batch.len())).ask_batch(&session, 0..batch.len(), &mut batch);
        assert_eq!([batch[0], batch[8]], [single; 2], "{question:?} as a batch: {points:?}");
        // The last vertex repeated, beside the line or plane of the others.
        let mut beside = [single; 9];
        match (question, &args[..]) {
            (Question::Orient2d(plane), &[a, b, c]) => session.orient2d_line(plane, [a, b], &[c; 9], &mut beside),
            (Question::Orient3d, &[a, b, c, d]) => session.orient3d_plane([a, b, c], &[d; 9], &mut beside),
            _ => {}
        }
        assert_eq!([beside[0], beside[8]], [single; 2], "{question:?} beside: {points:?}");
        single
    };
    let with = |point: [f64; D]| answer(&[points, &[point]].concat());
    // (A batch may use another code path if a query has the last point of the scene.)
    let answers = [answer(points), with(points[0]), with(std::array::from_fn(|i| WIDE[i]))];
    assert_eq!(answers, [answers[0]; 3], "{question:?} alone, with another point and in a wide scene: {points:?}");
    answers[0]
}

fn ask2(question: Question, points: &[[f64; 2]]) -> Sign {
    ask(question, points, |points| Scene::from_points2(points).expect("finite"))
}

fn ask3(question: Question, points: &[[f64; 3]]) -> Sign {
    ask(question, points, |points| Scene::from_points3(points).expect("finite"))
}

/// Judges all predicates of three points of the plane.
pub fn check_orient2d(points: &[[f64; 2]; 3]) -> Sign {
    let truth = orient2d(points);
    assert_eq!(ask2(Question::Orient2d(Plane::Xy), points), truth, "orient2d {points:?}");
    assert_eq!(raw::orient2d(*points), truth, "raw orient2d {points:?}");
    truth
}

/// Judges the side of the fourth point.
pub fn check_orient3d(points: &[[f64; 3]; 4]) -> Sign {
    let truth = orient3d(points);
    assert_eq!(ask3(Question::Orient3d, points), truth, "orient3d {points:?}");
    assert_eq!(raw::orient3d(*points), truth, "raw orient3d {points:?}");
    truth
}

/// Judges the position of the fourth point relative to the circle.
pub fn check_incircle(points: &[[f64; 2]; 4]) -> Sign {
    let truth = incircle(points);
    assert_eq!(ask2(Question::Incircle, points), truth, "incircle {points:?}");
    assert_eq!(raw::incircle(*points), truth, "raw incircle {points:?}");
    truth
}

/// Judges the position of the fifth point relative to the sphere.
pub fn check_insphere(points: &[[f64; 3]; 5]) -> Sign {
    let truth = insphere(points);
    assert_eq!(ask3(Question::Insphere, points), truth, "insphere {points:?}");
    assert_eq!(raw::insphere(*points), truth, "raw insphere {points:?}");
    truth
}

/// Judges two coordinates on every axis, and three points in every plane.
pub fn check_projections(points: &[[f64; 3]; 3]) {
    for plane in [Plane::Xy, Plane::Yz, Plane::Zx] {
        let axes = plane.axes().map(Axis::index);
        let flat = points.map(|p| axes.map(|axis| p[axis]));
        assert_eq!(ask3(Question::Orient2d(plane), points), orient2d(&flat), "{plane:?} {points:?}");
    }
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        let [a, b] = [0, 1].map(|i| Rational::from_f64(points[i][axis.index()]).expect("finite"));
        assert_eq!(ask3(Question::Compare(axis), &points[..2]), Sign::from(a.cmp(&b)), "{axis:?} {points:?}");
    }
}

/// Any finite double, with all bit patterns equally likely.
fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

/// Points with such coordinates.
pub fn points<const N: usize, const D: usize>() -> impl Strategy<Value = [[f64; D]; N]> {
    proptest::collection::vec(finite(), N * D)
        .prop_map(|flat| std::array::from_fn(|i| std::array::from_fn(|j| flat[i * D + j])))
}

/// SplitMix64 (Steele, Lea and Flood 2014): small, seeded, the same everywhere.
pub struct Random(pub u64);

impl Random {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below n.
    #[allow(clippy::cast_possible_truncation)] // below n
    pub fn below(&mut self, n: usize) -> usize {
        ((u128::from(self.bits()) * n as u128) >> 64) as usize
    }

    /// A number in [0, 1), a multiple of 2^-53.
    #[allow(clippy::cast_precision_loss)] // 53 bits fit
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A random element.
    pub fn pick<'a, X>(&mut self, from: &'a [X]) -> &'a X {
        &from[self.below(from.len())]
    }

    /// N points with coordinates from this source.
    pub fn points<const N: usize, const D: usize>(
        &mut self,
        mut value: impl FnMut(&mut Random) -> f64,
    ) -> [[f64; D]; N] {
        std::array::from_fn(|_| std::array::from_fn(|_| value(self)))
    }
}

/// The number x moved by some ulps, up or down.
pub fn nudge(x: f64, ulps: i64) -> f64 {
    let step = if ulps < 0 { f64::next_down } else { f64::next_up };
    (0..ulps.unsigned_abs()).fold(x, |x, _| step(x))
}

/// Calls f with every way to fill N points of D coordinates with these values.
pub fn every<const N: usize, const D: usize>(values: &[f64], mut f: impl FnMut(&[[f64; D]; N])) {
    let mut digits = [[0; D]; N];
    loop {
        f(&digits.map(|point| point.map(|i| values[i])));
        // Count up; a carry out of the last digit ends the loop.
        let carried = digits.as_flattened_mut().iter_mut().all(|digit| {
            *digit = (*digit + 1) % values.len();
            *digit == 0
        });
        if carried {
            return;
        }
    }
}
