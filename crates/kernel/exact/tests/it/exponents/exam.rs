//! One query on every rung that can answer it, judged.

use predicament_arithmetic::{Arithmetic, Fixed, Plan, short_rows, units};
use predicament_exact::{
    Exact,
    determinant::{self, Determinant},
    dyadic, estimate, raw,
};
use predicament_predicates::{Backend, Dimension, Off, Plane, QuerySet, Question, Scene, Sign, Vertex};

use crate::common::{self, Random};
use crate::rational;

/// One of this many queries is judged again, by elimination.
const AGAIN: usize = 16;
/// The number of queries that share a scene.
const CROWD: usize = 512;

/// One of this many queries runs.
pub fn one_in() -> usize {
    predicament_effort::some_or_all(50, 1)
}

/// A predicate, rung by rung.
pub struct Predicate<const D: usize, const N: usize> {
    question: Question,
    determinant: Determinant,
    truth: fn([[f64; D]; N]) -> rational::Value,
    judge: fn(&[[f64; D]; N]) -> Sign,
    raw: fn([[f64; D]; N]) -> Sign,
    filter: fn([[f64; D]; N], f64) -> Option<Sign>,
    integer: fn([[Fixed<1>; D]; N]) -> Sign,
    wide_integer: fn([[Fixed<2>; D]; N]) -> Sign,
    dyadic: fn([[f64; D]; N]) -> Sign,
}

pub const ORIENT2D: Predicate<2, 3> = Predicate {
    question: Question::Orient2d(Plane::Xy),
    determinant: determinant::ORIENT2D,
    truth: |[a, b, c]| rational::orient2d(a, b, c),
    judge: common::orient2d,
    raw: raw::orient2d,
    filter: |[a, b, c], bound| estimate::orient2d(a, b, c).certain(bound),
    integer: |[a, b, _]| determinant::orient2d::<1, 2>([a, b]),
    wide_integer: |[a, b, _]| determinant::orient2d::<2, 4>([a, b]),
    dyadic: |[a, b, c]| dyadic::orient2d(a, b, c),
};

pub const ORIENT3D: Predicate<3, 4> = Predicate {
    question: Question::Orient3d,
    determinant: determinant::ORIENT3D,
    truth: |[a, b, c, d]| rational::orient3d(a, b, c, d),
    judge: common::orient3d,
    raw: raw::orient3d,
    filter: |[a, b, c, d], bound| estimate::orient3d(a, b, c, d).certain(bound),
    integer: |[a, b, c, _]| determinant::orient3d::<1, 2, 3>([a, b, c]),
    wide_integer: |[a, b, c, _]| determinant::orient3d::<2, 4, 6>([a, b, c]),
    dyadic: |[a, b, c, d]| dyadic::orient3d(a, b, c, d),
};

pub const INCIRCLE: Predicate<2, 4> = Predicate {
    question: Question::Incircle,
    determinant: determinant::INCIRCLE,
    truth: |[a, b, c, d]| rational::incircle(a, b, c, d),
    judge: common::incircle,
    raw: raw::incircle,
    filter: |[a, b, c, d], bound| estimate::incircle(a, b, c, d).certain(bound),
    integer: |[a, b, c, _]| determinant::incircle::<1, 2, 4>([a, b, c]),
    wide_integer: |[a, b, c, _]| determinant::incircle::<2, 4, 8>([a, b, c]),
    dyadic: |[a, b, c, d]| dyadic::incircle(a, b, c, d),
};

pub const INSPHERE: Predicate<3, 5> = Predicate {
    question: Question::Insphere,
    determinant: determinant::INSPHERE,
    truth: |[a, b, c, d, e]| rational::insphere(a, b, c, d, e),
    judge: common::insphere,
    raw: raw::insphere,
    filter: |[a, b, c, d, e], bound| estimate::insphere(a, b, c, d, e).certain(bound),
    integer: |[a, b, c, d, _]| determinant::insphere::<1, 2, 3, 5>([a, b, c, d]),
    wide_integer: |[a, b, c, d, _]| determinant::insphere::<2, 4, 6, 10>([a, b, c, d]),
    dyadic: |[a, b, c, d, e]| dyadic::insphere(a, b, c, d, e),
};

/// A double of this exponent with a random sign and significand; zero for `None`.
///
/// A short double has three bits.
pub fn double(random: &mut Random, exponent: Option<i32>, short: bool) -> f64 {
    let negative = random.below(2) == 0;
    let Some(exponent) = exponent else { return if negative { -0.0 } else { 0.0 } };
    let power = match u64::try_from(exponent + 1023) {
        Ok(biased @ 1..) => f64::from_bits(biased << 52),
        _ => f64::from_bits(1 << (exponent + 1074)),
    };
    let significand = if short {
        *random.pick(&[1.0, 1.25, 1.5, 1.75])
    } else {
        // The last one may round up to 2.
        let any = 1.0 + random.unit();
        *random.pick(&[1.0, 1.0 + f64::EPSILON, 2.0 - f64::EPSILON, any])
    };
    let magnitude = (significand * power).min(f64::MAX);
    if negative { -magnitude } else { magnitude }
}

/// The counts of an exam, so that a test can verify its coverage.
#[derive(Clone, Copy, Default, Debug)]
pub struct Seen {
    /// The number of queries by answer: negative, zero, positive.
    pub signs: [usize; 3],
    /// The number of queries that the filter settled, if it may run.
    pub filtered: usize,
    /// The number of queries that doubles settle without error.
    pub double: usize,
    /// The number of queries with differences of one limb.
    pub integer: usize,
    /// The number of queries with differences of two limbs.
    pub wide_integer: usize,
}

impl Seen {
    pub fn all(&self) -> usize {
        self.signs.iter().sum()
    }
}

/// An exam that asks query after query: each alone, and all in crowds.
pub struct Exam<const D: usize, const N: usize> {
    predicate: Predicate<D, N>,
    random: Random,
    effort: Random,
    seen: Seen,
    crowd: Vec<[[f64; D]; N]>,
    truths: Vec<Sign>,
}

impl<const D: usize, const N: usize> Exam<D, N> {
    pub fn new(predicate: Predicate<D, N>, seed: u64) -> Exam<D, N> {
        let (crowd, truths) = (Vec::with_capacity(CROWD), Vec::with_capacity(CROWD));
        Exam { predicate, random: Random(seed), effort: Random(seed), seen: Seen::default(), crowd, truths }
    }

    /// A double of this exponent, or zero; short in every other query.
    pub fn double(&mut self, exponent: Option<i32>) -> f64 {
        double(&mut self.random, exponent, self.seen.all().is_multiple_of(2))
    }

    /// Judges these points, or skips them if the effort is reduced.
    pub fn check(&mut self, points: [[f64; D]; N]) {
        if self.effort.below(one_in()) == 0 {
            self.judge(points);
        }
    }

    /// Judges the points in some order of points and axes, on each rung that can answer.
    fn judge(&mut self, points: [[f64; D]; N]) {
        let points = self.shuffled(points);
        let Predicate { determinant: Determinant { form, bound }, question, .. } = self.predicate;
        let truth = (self.predicate.truth)(points).sign();
        if self.seen.all().is_multiple_of(AGAIN) {
            assert_eq!((self.predicate.judge)(&points), truth, "two computations about {points:?}");
        }
        assert_eq!((self.predicate.raw)(points), truth, "raw {question:?} {points:?}");
        assert_eq!((self.predicate.dyadic)(points), truth, "dyadic {question:?} {points:?}");
        let plan = Plan::of(&points);
        if plan.allows_filters(form)
            && let Some(sign) = (self.predicate.filter)(points, bound)
        {
            assert_eq!(sign, truth, "filter {question:?} {points:?}");
            self.seen.filtered += 1;
        }
        if plan.arithmetic(form) == Arithmetic::Double {
            assert_eq!((self.predicate.filter)(points, 0.0), Some(truth), "double {question:?} {points:?}");
            self.seen.double += 1;
        }
        if let Some(rows) = short_rows(points) {
            assert_eq!((self.predicate.integer)(rows), truth, "integer {question:?} {points:?}");
            self.seen.integer += 1;
        }
        if plan.has_finite_differences() && plan.bits() <= determinant::BITS[1] {
            let last = points[N - 1].map(|x| units(x, plan.lowest()));
            let row = |p: [f64; D]| {
                std::array::from_fn(|axis| Fixed::from(units(p[axis], plan.lowest()).wrapping_sub(last[axis])))
            };
            assert_eq!((self.predicate.wide_integer)(points.map(row)), truth, "wide integer {question:?} {points:?}");
            self.seen.wide_integer += 1;
        }
        assert_eq!(answers(question, &[points])[0], [truth; 2], "{question:?} {points:?}");
        self.crowd.push(points);
        self.truths.push(truth);
        if self.crowd.len() == CROWD {
            self.ask_crowd();
        }
        self.seen.signs[usize::try_from(truth.as_i8() + 1).expect("0, 1 or 2")] += 1;
    }

    /// Judges the points, and the points with one coordinate moved by an ulp to either side.
    pub fn check_around(&mut self, points: [[f64; D]; N]) {
        self.check(points);
        let (row, axis) = (self.random.below(N), self.random.below(D));
        for neighbour in [f64::next_up, f64::next_down] {
            let mut points = points;
            points[row][axis] = neighbour(points[row][axis]);
            if points[row][axis].is_finite() {
                self.check(points);
            }
        }
    }

    /// Asks the remaining crowd, and returns the counts.
    pub fn end(mut self) -> Seen {
        self.ask_crowd();
        println!("{:?}: {:?}", self.predicate.question, self.seen);
        self.seen
    }

    /// Asks all queries in one scene, one by one and as a batch: the ladder plans each query separately.
    fn ask_crowd(&mut self) {
        let found = answers(self.predicate.question, &self.crowd);
        for ((points, truth), found) in self.crowd.iter().zip(&self.truths).zip(found) {
            assert_eq!(found, [*truth; 2], "{:?} in a crowd: {points:?}", self.predicate.question);
        }
        self.crowd.clear();
        self.truths.clear();
    }

    fn shuffled(&mut self, mut points: [[f64; D]; N]) -> [[f64; D]; N] {
        for i in 1..N {
            points.swap(i, self.random.below(i + 1));
        }
        let turn = self.random.below(D);
        points.iter_mut().for_each(|point| point.rotate_left(turn));
        points
    }
}

/// The session's answers, alone and in a batch.
fn answers<const D: usize, const N: usize>(question: Question, queries: &[[[f64; D]; N]]) -> Vec<[Sign; 2]> {
    let dimension = if D == 2 { Dimension::Two } else { Dimension::Three };
    let scene = Scene::new(dimension, queries.as_flattened().as_flattened().to_vec()).expect("finite");
    let session = Exact.prepare(&scene, Off).expect("every scene can be prepared");
    let queries = QuerySet::new(question, scene.vertices().collect::<Vec<Vertex>>());
    let mut batch = vec![Sign::Zero; queries.len()];
    queries.ask_batch(&session, 0..queries.len(), &mut batch);
    batch.into_iter().enumerate().map(|(i, sign)| [question.ask(&session, queries.args(i)), sign]).collect()
}
