//! The promise itself: |d| ≤ T₋ is registered, and registered queries have |d| ≤ T₊, for exact d.
//!
//! Queries are aimed at T₋, T and T₊.

use predicament_arithmetic::Scaled;
use predicament_predicates::{Backend, Band, Dimension, Off, Plane, Predicates, Question, Scene, Sign, Vertex};
use predicament_tolerance::Tolerance;
use rug::{Integer, Rational};

/// The number of queries; fewer for circles and spheres, whose exact determinants take longer.
fn queries(question: Question) -> usize {
    predicament_effort::some_or_all(1, 5) * if is_lifted(question) { 1_000 } else { 5_000 }
}

/// SplitMix64: a few lines, and the same numbers in every run.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A random number in [−½, ½).
    #[allow(clippy::cast_precision_loss)] // 53 bits fit
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 2.0_f64.powi(-53) - 0.5
    }

    /// A target ± T₋, T or T₊, off by up to a half of it or only by 2⁻¹⁶.
    fn aim(&mut self, band: Band) -> f64 {
        let target = match self.bits() % 3 {
            0 => band.lower,
            1 => band.width,
            _ => band.upper,
        };
        let scale = 1_u32 << (self.bits() % 16);
        let off = self.unit() / f64::from(scale);
        target * (1.0 + off) * if self.bits() & 1 == 0 { 1.0 } else { -1.0 }
    }
}

fn rational(x: f64) -> Rational {
    Rational::from_f64(x).expect("finite")
}

/// Returns true if the rows of the question's determinant end with a squared length.
fn is_lifted(question: Question) -> bool {
    matches!(question, Question::Incircle | Question::Insphere)
}

/// The exact determinant of the differences to the last point.
///
/// For circles and spheres their squared lengths are the last column. It uses Laplace expansion on integers, with the
/// coordinates over one power of two.
fn exact(scene: &Scene, question: Question, args: &[Vertex]) -> Rational {
    let mut points = [[0.0; 3]; 5];
    for (to, v) in points.iter_mut().zip(args) {
        to[..scene.dimension().count()].copy_from_slice(scene.point(*v));
    }
    let Scaled { integers, exponent } = Scaled::new(points).expect("finite");
    let (last, others) = integers[..args.len()].split_last().expect("not empty");
    let row = |point: &[Integer; 3]| -> Vec<Integer> {
        let pairs = point.iter().zip(last).take(scene.dimension().count());
        let mut row: Vec<Integer> = pairs.map(|(x, y)| Integer::from(x - y)).collect();
        if is_lifted(question) {
            row.push(row.iter().map(|x| Integer::from(x.square_ref())).sum());
        }
        row
    };
    Rational::from(determinant(&others.iter().map(row).collect::<Vec<_>>())) << (exponent * degree(question))
}

fn determinant(rows: &[Vec<Integer>]) -> Integer {
    let [first, rest @ ..] = rows else { return Integer::from(1) };
    let minor = |column: usize| -> Vec<Vec<Integer>> {
        let without = |row: &Vec<Integer>| {
            row.iter().enumerate().filter(|(at, _)| *at != column).map(|(_, x)| x.clone()).collect()
        };
        rest.iter().map(without).collect()
    };
    let terms = first.iter().enumerate().map(|(column, x)| {
        let term = determinant(&minor(column)) * x;
        if column % 2 == 0 { term } else { -term }
    });
    terms.sum()
}

/// The degree of the determinant: one length per row, and one more for a lift.
fn degree(question: Question) -> i32 {
    i32::try_from(question.kind().arity() - 1 + usize::from(is_lifted(question))).expect("small")
}

/// The findings of a checker that knows only the promise.
#[derive(Default, Debug)]
struct Found {
    missed: usize,
    overreached: usize,
    flipped: usize,
    registered: usize,
    largest_error: f64,
}

/// Asks queries that are built and judged one by one.
///
/// `answer` turns an estimate into a sign, so that faults can be planted.
fn check(question: Question, scale: f64, answer: impl Fn(f64, Band) -> Option<Sign>) -> Found {
    let dimension = dimension(question);
    let mut random = Random(42);
    let mut found = Found::default();
    let corner = |at: f64| vec![at * scale; dimension.count()];
    for _ in 0..queries(question) / 50 {
        // two corners make L the same for all scenes
        let mut coordinates = [corner(-0.5), corner(0.5)].concat();
        let frame = Scene::new(dimension, coordinates.clone()).unwrap();
        let band = Tolerance.prepare(&frame, Off).unwrap().band(question).unwrap();
        for _ in 0..50 {
            coordinates.extend(near(&mut random, question, scale, band));
        }
        let scene = Scene::new(dimension, coordinates).unwrap();
        let session = Tolerance.prepare(&scene, Off).unwrap();
        assert_eq!(session.band(question), Some(band), "the points stay in the frame");
        let vertices: Vec<Vertex> = scene.vertices().skip(2).collect();
        for args in vertices.chunks(question.kind().arity()) {
            let estimate = session.estimate(question, args).unwrap();
            let sign = answer(estimate, band).unwrap_or_else(|| question.ask(&session, args));
            let d = exact(&scene, question, args);
            let size = d.clone().abs();
            found.missed += usize::from(size <= rational(band.lower) && !sign.is_zero());
            found.overreached += usize::from(size > rational(band.upper) && sign.is_zero());
            found.registered += usize::from(sign.is_zero());
            found.flipped += usize::from(!sign.is_zero() && Sign::from(d.cmp0()) != sign);
            found.largest_error = found.largest_error.max((d - rational(estimate)).to_f64().abs());
        }
    }
    found
}

/// The coordinates of one query whose determinant is near a threshold.
///
/// They are inside the frame, because L would grow otherwise.
fn near(random: &mut Random, question: Question, scale: f64, band: Band) -> Vec<f64> {
    loop {
        let unscaled = if is_lifted(question) { near_sphere } else { near_plane };
        let aim = random.aim(band) / scale.powi(degree(question));
        let flat: Vec<f64> = unscaled(random, dimension(question), aim).into_iter().map(|x| x * scale).collect();
        if flat.iter().all(|x| x.abs() <= 0.5 * scale) {
            return flat;
        }
    }
}

fn point(random: &mut Random, dimension: Dimension) -> Vec<f64> {
    (0..dimension.count()).map(|_| random.unit()).collect()
}

fn normal(u: &[f64], v: &[f64]) -> [f64; 3] {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

fn minus(p: &[f64], q: &[f64]) -> Vec<f64> {
    p.iter().zip(q).map(|(x, y)| x - y).collect()
}

fn dot(u: &[f64], v: &[f64]) -> f64 {
    u.iter().zip(v).map(|(x, y)| x * y).sum()
}

/// Points on a line or in a plane, with the last one moved off it.
fn near_plane(random: &mut Random, dimension: Dimension, aim: f64) -> Vec<f64> {
    let (a, b) = (point(random, dimension), point(random, dimension));
    let mut points = vec![a.clone(), b.clone()];
    let [s, t] = [random.unit() + 0.5, random.unit() + 0.5];
    let u = minus(&b, &a);
    let last = match dimension {
        // on the line a b, then off it by area / length
        Dimension::Two => {
            let off = aim / dot(&u, &u);
            vec![a[0] + s * u[0] - off * u[1], a[1] + s * u[1] + off * u[0]]
        }
        // in the plane a b c, then off it by volume / area
        Dimension::Three => {
            let c = point(random, dimension);
            let v = minus(&c, &a);
            let n = normal(&u, &v);
            let off = aim / dot(&n, &n);
            points.push(c);
            (0..3).map(|i| a[i] + s * u[i] + t * v[i] + off * n[i]).collect()
        }
    };
    points.push(last);
    points.concat()
}

/// Points on a circle or sphere, with the last one moved off it.
///
/// The determinant is twice the area or six times the volume of the others, times the power of the last.
fn near_sphere(random: &mut Random, dimension: Dimension, aim: f64) -> Vec<f64> {
    let center: Vec<f64> = point(random, dimension).iter().map(|x| x / 4.0).collect();
    let radius = 0.35 + 0.3 * random.unit();
    let on = |random: &mut Random, radius: f64| -> Vec<f64> {
        let to = point(random, dimension);
        let length = dot(&to, &to).sqrt();
        to.iter().zip(&center).map(|(x, o)| o + x * radius / length).collect()
    };
    let mut points: Vec<Vec<f64>> = (0..=dimension.count()).map(|_| on(random, radius)).collect();
    let [u, v] = [1, 2].map(|i| minus(&points[i], &points[0]));
    let size = match dimension {
        Dimension::Two => u[0] * v[1] - u[1] * v[0],
        Dimension::Three => dot(&normal(&u, &v), &minus(&points[3], &points[0])),
    };
    points.push(on(random, (radius * radius + aim / size).max(0.0).sqrt()));
    points.concat()
}

const QUESTIONS: [Question; 4] =
    [Question::Orient2d(Plane::Xy), Question::Orient3d, Question::Incircle, Question::Insphere];

fn dimension(question: Question) -> Dimension {
    match question {
        Question::Orient2d(_) | Question::Incircle => Dimension::Two,
        _ => Dimension::Three,
    }
}

#[test]
fn everything_up_to_the_lower_bound_and_nothing_beyond_the_upper_is_registered() {
    for question in QUESTIONS {
        for scale in [1.0, 1e-55, 3e50] {
            let found = check(question, scale, |_, _| None);
            assert_eq!((found.missed, found.overreached, found.flipped), (0, 0, 0), "{question:?} {scale}: {found:?}");
            assert!(found.registered > queries(question) / 20, "{question:?} {scale}: {found:?}");
        }
    }
}

#[test]
fn computed_determinants_stay_within_the_error_bounds() {
    // E[a] ≤ 9 ε L² and E[v] ≤ 47 ε L³ are the paper's
    for (question, bound) in QUESTIONS.into_iter().zip([9.0, 47.0, 129.0, 1129.0]) {
        let error = check(question, 1.0, |_, _| None).largest_error;
        assert!(error > 0.0 && error <= bound * f64::EPSILON, "{question:?}: {error:e}");
    }
}

#[test]
fn a_tolerance_outside_its_bounds_is_caught() {
    let with = |factor: f64| {
        move |estimate: f64, band: Band| {
            Some(if estimate.abs() <= band.width * factor { Sign::Zero } else { Sign::of(estimate) })
        }
    };
    for question in QUESTIONS {
        assert_eq!(check(question, 1.0, with(1.0)).missed, 0, "the wrapper alone changes nothing");
        // κ₋/κ = 10/21, and ½ for the others
        let narrow = check(question, 1.0, with(0.45));
        assert!(narrow.missed > 0 && narrow.overreached == 0, "{question:?}: {narrow:?}");
        // κ₊/κ = 32/21, ξ₊/ξ = 1.485, and 1.5 for circles and spheres
        let wide = check(question, 1.0, with(1.6));
        assert!(wide.missed == 0 && wide.overreached > 0, "{question:?}: {wide:?}");
    }
}
