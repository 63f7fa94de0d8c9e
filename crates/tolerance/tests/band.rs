//! The promise itself: |d| ≤ T₋ is registered, and what is registered has
//! |d| ≤ T₊, for exact d. Queries are aimed at T₋, T and T₊.

use predicament_predicates::{Backend, Band, Dimension, Off, Plane, Predicates, Question, Scene, Sign, Vertex};
use predicament_tolerance::Tolerance;
use rug::Rational;

const QUERIES: usize = 100_000;

/// SplitMix64: a few lines, and the same numbers for ever.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [−½, ½).
    #[allow(clippy::cast_precision_loss)] // 53 bits fit
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 2.0_f64.powi(-53) - 0.5
    }

    /// ± T₋, T or T₊, off by up to a half of it or only by 2⁻¹⁶.
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

/// det(a − c, b − c) or det(a − d, b − d, c − d): Laplace on exact differences.
fn exact(scene: &Scene, args: &[Vertex]) -> Rational {
    let (last, others) = args.split_last().expect("not empty");
    let row = |v: &Vertex| -> Vec<Rational> {
        let pairs = scene.point(*v).iter().zip(scene.point(*last));
        pairs.map(|(&x, &y)| rational(x) - rational(y)).collect()
    };
    determinant(&others.iter().map(row).collect::<Vec<_>>())
}

fn determinant(rows: &[Vec<Rational>]) -> Rational {
    let [first, rest @ ..] = rows else { return Rational::from(1) };
    let minor = |column: usize| -> Vec<Vec<Rational>> {
        let without = |row: &Vec<Rational>| {
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

/// What a checker that knows only the promise finds.
#[derive(Default, Debug)]
struct Found {
    missed: usize,
    overreached: usize,
    flipped: usize,
    registered: usize,
    largest_error: f64,
}

/// Asks queries that are built and judged one by one; `answer` turns an
/// estimate into a sign, so that faults can be planted.
fn check(dimension: Dimension, scale: f64, answer: impl Fn(f64, Band) -> Option<Sign>) -> Found {
    let mut random = Random(42);
    let mut found = Found::default();
    let corner = |at: f64| vec![at * scale; dimension.count()];
    for _ in 0..QUERIES / 50 {
        // two corners make L the same for all scenes
        let mut coordinates = [corner(-0.5), corner(0.5)].concat();
        let frame = Scene::new(dimension, coordinates.clone()).unwrap();
        let question = if dimension == Dimension::Two { Question::Orient2d(Plane::Xy) } else { Question::Orient3d };
        let band = Tolerance.prepare(&frame, Off).unwrap().band(question).unwrap();
        for _ in 0..50 {
            coordinates.extend(near(&mut random, dimension, scale, band));
        }
        let scene = Scene::new(dimension, coordinates).unwrap();
        let session = Tolerance.prepare(&scene, Off).unwrap();
        assert_eq!(session.band(question), Some(band), "the points stay in the frame");
        let vertices: Vec<Vertex> = scene.vertices().skip(2).collect();
        for args in vertices.chunks(question.kind().arity()) {
            let estimate = session.estimate(question, args).unwrap();
            let sign = answer(estimate, band).unwrap_or_else(|| question.ask(&session, args));
            let d = exact(&scene, args);
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
fn near(random: &mut Random, dimension: Dimension, scale: f64, band: Band) -> Vec<f64> {
    loop {
        let mut point = || -> Vec<f64> { (0..dimension.count()).map(|_| random.unit() * scale).collect() };
        let (a, b) = (point(), point());
        let mut points = vec![a.clone(), b.clone()];
        let [s, t] = [random.unit() + 0.5, random.unit() + 0.5];
        let last = match dimension {
            // on the line a b, then off it by area / length
            Dimension::Two => {
                let u = [b[0] - a[0], b[1] - a[1]];
                let off = random.aim(band) / (u[0] * u[0] + u[1] * u[1]);
                vec![a[0] + s * u[0] - off * u[1], a[1] + s * u[1] + off * u[0]]
            }
            // in the plane a b c, then off it by volume / area
            Dimension::Three => {
                let c: Vec<f64> = (0..3).map(|_| random.unit() * scale).collect();
                let [u, v] = [&b, &c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
                let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
                let off = random.aim(band) / n.iter().map(|x| x * x).sum::<f64>();
                points.push(c);
                (0..3).map(|i| a[i] + s * u[i] + t * v[i] + off * n[i]).collect()
            }
        };
        points.push(last);
        // inside the frame, or L would grow
        let flat = points.concat();
        if flat.iter().all(|x| x.abs() <= 0.5 * scale) {
            return flat;
        }
    }
}

const DIMENSIONS: [Dimension; 2] = [Dimension::Two, Dimension::Three];

#[test]
fn everything_up_to_the_lower_bound_and_nothing_beyond_the_upper_is_registered() {
    for dimension in DIMENSIONS {
        for scale in [1.0, 1e-60, 3e50] {
            let found = check(dimension, scale, |_, _| None);
            assert_eq!((found.missed, found.overreached, found.flipped), (0, 0, 0), "{dimension:?} {scale}: {found:?}");
            assert!(found.registered > QUERIES / 20, "{found:?}");
        }
    }
}

#[test]
fn computed_determinants_stay_within_the_error_bounds_of_the_paper() {
    let area = check(Dimension::Two, 1.0, |_, _| None).largest_error;
    assert!(area > 0.0 && area <= 9.0 * f64::EPSILON, "E[a] ≤ 9 ε L²: {area:e}");
    let volume = check(Dimension::Three, 1.0, |_, _| None).largest_error;
    assert!(volume > 0.0 && volume <= 47.0 * f64::EPSILON, "E[v] ≤ 47 ε L³: {volume:e}");
}

#[test]
fn a_tolerance_outside_its_bounds_is_caught() {
    let with = |factor: f64| {
        move |estimate: f64, band: Band| {
            Some(if estimate.abs() <= band.width * factor { Sign::Zero } else { Sign::of(estimate) })
        }
    };
    for dimension in DIMENSIONS {
        assert_eq!(check(dimension, 1.0, with(1.0)).missed, 0, "the wrapper alone changes nothing");
        // κ₋/κ = 10/21 and ξ₋/ξ = ½
        let narrow = check(dimension, 1.0, with(0.45));
        assert!(narrow.missed > 0 && narrow.overreached == 0, "{dimension:?}: {narrow:?}");
        // κ₊/κ = 32/21 and ξ₊/ξ = 1.485
        let wide = check(dimension, 1.0, with(1.6));
        assert!(wide.missed == 0 && wide.overreached > 0, "{dimension:?}: {wide:?}");
    }
}
