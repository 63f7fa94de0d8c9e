//! A judge without GMP: signs by integers of a library in pure Rust, for tests of other people's predicates.
//!
//! The crate `conformance` asks it, so that a test needs no C compiler and no `m4`. It is a second computation of the
//! same signs, by other arithmetic and in part by other formulas: the points of definitions become homogeneous
//! coordinates, and constructed points are their joins and meets. The tests compare it with [`sign`](crate::sign()).
//!
//! * [`Number`]: a coordinate; a double or an integer.
//! * [`Point`]: a point in homogeneous coordinates; [`points`] reads input points, [`Point::ssi`], [`Point::lpi`],
//!   [`Point::tpi`] and [`Point::ratio`] construct.
//! * [`orientation`], [`sphere`]: the signs.
//! * [`scene_sign`]: the sign of a query about a scene.

use num_bigint::{BigInt, Sign as Side};
use predicament_predicates::{Axis, Construction, Plane, Question, Scene, Sign, Vertex};

use crate::split::split;

/// A coordinate: an integer times a power of two.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Number {
    significand: i64,
    exponent: i32,
}

impl Number {
    /// The value of a double; `None` if it is not finite.
    #[must_use]
    pub fn of(x: f64) -> Option<Number> {
        if !x.is_finite() {
            return None;
        }
        let (significand, exponent) = split(x);
        let significand = significand.cast_signed();
        Some(Number::odd(if x < 0.0 { -significand } else { significand }, exponent))
    }

    /// The number without factors of two in its significand, so that integers are short.
    fn odd(significand: i64, exponent: i32) -> Number {
        if significand == 0 {
            return Number { significand, exponent: 0 };
        }
        let zeros = significand.trailing_zeros();
        Number { significand: significand >> zeros, exponent: exponent + zeros.cast_signed() }
    }
}

impl From<i64> for Number {
    fn from(n: i64) -> Number {
        Number::odd(n, 0)
    }
}

/// A point in homogeneous coordinates: the coordinates times the weight, and the weight, which is positive.
///
/// Only points of one unit can be compared with each other: points of one call of [`points`], and points constructed
/// from them.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Point(Vec<BigInt>);

/// The points with these coordinates, point after point, in one unit.
///
/// # Panics
/// If `dimension` is 0.
#[must_use]
pub fn points(dimension: usize, coordinates: &[Number]) -> Vec<Point> {
    let lowest = coordinates.iter().filter(|x| x.significand != 0).map(|x| x.exponent).min().unwrap_or(0);
    let whole = |x: &Number| match x.significand {
        0 => BigInt::ZERO,
        significand => BigInt::from(significand) << (x.exponent - lowest).unsigned_abs(),
    };
    let point = |point: &[Number]| Point(point.iter().map(whole).chain([BigInt::from(1)]).collect());
    coordinates.chunks_exact(dimension).map(point).collect()
}

impl Point {
    /// The point where two lines of the plane meet, each through two points; `None` if they do not meet in one point.
    #[must_use]
    pub fn ssi(lines: [[&Point; 2]; 2]) -> Option<Point> {
        let [first, second] = lines.map(|line| hyperplane(&line));
        positive(cross(&[&first, &second]))
    }

    /// The point where a line of space meets a plane; `None` if they do not meet in one point.
    #[must_use]
    pub fn lpi([p, q]: [&Point; 2], plane: [&Point; 3]) -> Option<Point> {
        let plane = hyperplane(&plane);
        let [at_p, at_q] = [p, q].map(|point| plane.iter().zip(&point.0).map(|(a, x)| a * x).sum::<BigInt>());
        positive(p.0.iter().zip(&q.0).map(|(p, q)| &at_q * p - &at_p * q).collect())
    }

    /// The point where three planes meet; `None` if they do not meet in one point.
    #[must_use]
    pub fn tpi(planes: [[&Point; 3]; 3]) -> Option<Point> {
        let [first, second, third] = planes.map(|plane| hyperplane(&plane));
        positive(cross(&[&first, &second, &third]))
    }

    /// The point αa + (1 − α)c, for α = p/q; `None` if q is not positive.
    #[must_use]
    pub fn ratio([a, c]: [&Point; 2], [p, q]: [i64; 2]) -> Option<Point> {
        let [p, q] = [p, q].map(BigInt::from);
        let weight = |point: &Point| point.0.last().cloned().unwrap_or_default();
        let [of_a, of_c] = [weight(c) * &p, weight(a) * (&q - &p)];
        let row = a.0.iter().zip(&c.0).map(|(a, c)| a * &of_a + c * &of_c).collect();
        if q.sign() == Side::Plus { positive(row) } else { None }
    }

    /// The point with only these of its coordinates.
    ///
    /// # Panics
    /// If there is no such coordinate.
    #[must_use]
    pub fn on(&self, axes: &[usize]) -> Point {
        let weight = self.0.len() - 1;
        assert!(axes.iter().all(|&axis| axis < weight), "{weight} coordinates");
        Point(axes.iter().chain([&weight]).map(|&at| self.0[at].clone()).collect())
    }

    fn has_weight_one(&self) -> bool {
        self.0.last() == Some(&BigInt::from(1))
    }
}

/// The sign of the determinant with one row (coordinates, 1) for each point: the order on a line, the turn in a plane,
/// the side in space.
///
/// # Panics
/// If the number of points is not one more than the number of coordinates.
#[must_use]
pub fn orientation(points: &[&Point]) -> Sign {
    if points.iter().all(|point| point.has_weight_one()) {
        return sign_of(&determinant(&differences(points)));
    }
    sign_of(&determinant(&points.iter().map(|point| point.0.clone()).collect::<Vec<_>>()))
}

/// The sign of the determinant with one row (coordinates, their sum of squares, 1) for each point: the side of the
/// circle or sphere.
///
/// # Panics
/// If the number of points is not two more than the number of coordinates.
#[must_use]
pub fn sphere(points: &[&Point]) -> Sign {
    let squares = |row: &[BigInt]| row.iter().map(|x| x * x).sum::<BigInt>();
    if points.iter().all(|point| point.has_weight_one()) {
        let mut rows = differences(points);
        rows.iter_mut().for_each(|row| row.push(squares(row)));
        return sign_of(&determinant(&rows));
    }
    let row = |point: &&Point| {
        let (weight, row) = point.0.split_last().expect("a weight");
        row.iter().map(|x| x * weight).chain([squares(row), weight * weight]).collect()
    };
    sign_of(&determinant(&points.iter().map(row).collect::<Vec<_>>()))
}

/// The exact sign of a query about a scene; `None` if it uses a construction that gives no point.
///
/// # Panics
/// If the query does not fit the scene, or is about a formula.
#[must_use]
pub fn scene_sign(scene: &Scene, question: Question, args: &[Vertex]) -> Option<Sign> {
    let axes: &[usize] = match question {
        Question::Compare(Axis::X) => &[0],
        Question::Compare(Axis::Y) => &[1],
        Question::Compare(Axis::Z) => &[2],
        Question::Orient2d(Plane::Xy) | Question::Incircle => &[0, 1],
        Question::Orient2d(Plane::Yz) => &[1, 2],
        Question::Orient2d(Plane::Zx) => &[2, 0],
        Question::Orient3d | Question::Insphere => &[0, 1, 2],
        Question::Derived(derived) => panic!("{}: formulas are for the other judge", derived.name()),
    };
    let mut inputs = Vec::new();
    args.iter().for_each(|&v| collect(scene, v, &mut inputs));
    inputs.sort_unstable();
    inputs.dedup();
    let numbers = inputs.iter().flat_map(|&v| scene.point(v));
    let numbers: Vec<Number> = numbers.map(|&x| Number::of(x).expect("scenes are finite")).collect();
    let known = points(scene.dimension().count(), &numbers);
    let on: Vec<Point> =
        args.iter().map(|&v| Some(solve(scene, v, &inputs, &known)?.on(axes))).collect::<Option<_>>()?;
    let on: Vec<&Point> = on.iter().collect();
    Some(if question.kind().is_lifted() { sphere(&on) } else { orientation(&on) })
}

/// Adds the input vertices that a vertex is or is constructed from.
fn collect(scene: &Scene, v: Vertex, inputs: &mut Vec<Vertex>) {
    match v.construction() {
        None => inputs.push(v),
        Some(index) => scene.constructions()[index].flats().flatten().for_each(|&v| collect(scene, v, inputs)),
    }
}

fn solve(scene: &Scene, v: Vertex, inputs: &[Vertex], known: &[Point]) -> Option<Point> {
    let Some(index) = v.construction() else {
        return inputs.binary_search(&v).ok().map(|at| known[at].clone());
    };
    let of = |v: Vertex| solve(scene, v, inputs, known);
    match scene.constructions()[index] {
        Construction::Ssi([[a, b], [c, d]]) => Point::ssi([[&of(a)?, &of(b)?], [&of(c)?, &of(d)?]]),
        Construction::Lpi { line: [p, q], plane: [a, b, c] } => {
            Point::lpi([&of(p)?, &of(q)?], [&of(a)?, &of(b)?, &of(c)?])
        }
        Construction::Tpi(planes) => {
            let points: Vec<Point> = planes.as_flattened().iter().map(|&v| of(v)).collect::<Option<_>>()?;
            let plane = |first: usize| [&points[first], &points[first + 1], &points[first + 2]];
            Point::tpi([plane(0), plane(3), plane(6)])
        }
        Construction::Ratio { ends: [a, c], share } => Point::ratio([&of(a)?, &of(c)?], share.fraction()),
    }
}

/// The rows of all points but the last, minus the last; without weights, which are one.
fn differences(points: &[&Point]) -> Vec<Vec<BigInt>> {
    let Some((last, others)) = points.split_last() else { return Vec::new() };
    let size = last.0.len() - 1;
    others.iter().map(|point| point.0.iter().zip(&last.0).take(size).map(|(x, y)| x - y).collect()).collect()
}

/// The line through two points of the plane, or the plane through three points of space; zero if they do not span it.
fn hyperplane(points: &[&Point]) -> Vec<BigInt> {
    cross(&points.iter().map(|point| &point.0).collect::<Vec<_>>())
}

/// The vector that is orthogonal to all rows; there is one row fewer than coordinates.
fn cross(rows: &[&Vec<BigInt>]) -> Vec<BigInt> {
    let minor = |left_out: usize| {
        let row = |row: &&Vec<BigInt>| {
            row.iter().enumerate().filter(|&(at, _)| at != left_out).map(|(_, x)| x.clone()).collect()
        };
        let minor = determinant(&rows.iter().map(row).collect::<Vec<_>>());
        if left_out.is_multiple_of(2) { minor } else { -minor }
    };
    (0..=rows.len()).map(minor).collect()
}

/// The point with a positive weight; `None` for a point at infinity, and for no point.
fn positive(row: Vec<BigInt>) -> Option<Point> {
    match row.last()?.sign() {
        Side::Plus => Some(Point(row)),
        Side::NoSign => None,
        Side::Minus => Some(Point(row.into_iter().map(|x| -x).collect())),
    }
}

/// The determinant of a square matrix, column by column: the minor of each set of k rows in the first k columns is
/// computed from the minors of the sets with one row less.
fn determinant(rows: &[Vec<BigInt>]) -> BigInt {
    assert!(rows.iter().all(|row| row.len() == rows.len()), "a square matrix of {} rows", rows.len());
    let mut minors = vec![BigInt::from(1)];
    for set in 1_usize..1 << rows.len() {
        let column = set.count_ones() as usize - 1;
        let mut minor = BigInt::ZERO;
        for (above, row) in (0..rows.len()).filter(|row| set >> row & 1 == 1).enumerate() {
            let term = &rows[row][column] * &minors[set ^ 1 << row];
            if (above + column).is_multiple_of(2) {
                minor += term;
            } else {
                minor -= term;
            }
        }
        minors.push(minor);
    }
    minors.pop().expect("the minor of no rows")
}

fn sign_of(value: &BigInt) -> Sign {
    match value.sign() {
        Side::Minus => Sign::Negative,
        Side::NoSign => Sign::Zero,
        Side::Plus => Sign::Positive,
    }
}
