//! The degeneracy of a scene's queries, decided exactly.
//!
//! The measure is |det| / permanent: the determinant over its value if no two of its terms cancelled. It is 1 for a
//! query that any arithmetic gets right, near 2^-53 where double precision starts to guess, and 0 for an exact tie. It
//! does not change when a query is scaled.

use std::collections::BTreeMap;
use std::fmt;

use predicament_corpus::{homogeneous, integer, lowest_exponent};
use predicament_judge::Verdict;
use predicament_predicates::{Axis, QuerySet, Question, Scene, Vertex};
use rug::{Integer, Rational};

/// The maximum number of queries measured: of larger scenes, a deterministic sample.
const SAMPLE: usize = 10_000;

/// Queries counted by ⌊log₂(|det| / permanent)⌋.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Histogram {
    /// Queries that are exactly degenerate.
    pub zeros: usize,
    /// The others, by exponent.
    pub buckets: BTreeMap<i64, usize>,
}

impl Histogram {
    /// The number of queries counted.
    #[must_use]
    pub fn total(&self) -> usize {
        self.zeros + self.buckets.values().sum::<usize>()
    }
}

impl fmt::Display for Histogram {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{:>8}  {:>8}", "log2", "queries")?;
        writeln!(f, "{:>8}  {:>8}", "-inf", self.zeros)?;
        for (exponent, count) in &self.buckets {
            writeln!(f, "{exponent:>8}  {count:>8}")?;
        }
        Ok(())
    }
}

/// The degeneracy of a scene's queries; of more than 10,000 queries, evenly spread ones.
#[must_use]
pub fn degeneracy(scene: &Scene, queries: &QuerySet) -> Histogram {
    let mut histogram = Histogram::default();
    let stride = queries.len().div_ceil(SAMPLE).max(1);
    for query in (0..queries.len()).step_by(stride) {
        match relative(scene, queries, query) {
            None => histogram.zeros += 1,
            Some(exponent) => *histogram.buckets.entry(exponent).or_default() += 1,
        }
    }
    histogram
}

/// The value ⌊log₂(|det| / permanent)⌋, or `None` if the determinant is zero.
fn relative(scene: &Scene, queries: &QuerySet, query: usize) -> Option<i64> {
    let args = queries.args(query);
    if let Question::Derived(_) = queries.question() {
        let Verdict { determinant, permanent } = predicament_judge::verdict(scene, queries.question(), args);
        let over_one = |x: &Rational, y: &Rational| Integer::from(x.numer() * y.denom()).abs();
        let [det, permanent] = [over_one(&determinant, &permanent), over_one(&permanent, &determinant)];
        return (!det.is_zero()).then(|| floor_log2_of_ratio(&det, &permanent));
    }
    let Magnitudes { det, permanent } = match queries.question() {
        Question::Compare(axis) => {
            let rows = weighted(scene, args, &[axis]);
            let a = Integer::from(&rows[0][0] * &rows[1][1]);
            let b = Integer::from(&rows[1][0] * &rows[0][1]);
            Magnitudes { det: Integer::from(&a - &b), permanent: a.abs() + b.abs() }
        }
        Question::Orient2d(plane) => minor(&relative_to_last_weighted(&weighted(scene, args, &plane.axes()))),
        Question::Orient3d => minor(&relative_to_last_weighted(&weighted(scene, args, &[Axis::X, Axis::Y, Axis::Z]))),
        Question::Incircle | Question::Insphere => {
            minor(&lifted(relative_to_last(&integers(args, |v| scene.point(v).to_vec()))))
        }
        Question::Derived(_) => return None,
    };
    let det = det.abs();
    if det.is_zero() {
        return None;
    }
    Some(floor_log2_of_ratio(&det, &permanent))
}

/// A determinant, and the same sum with every product positive.
struct Magnitudes {
    det: Integer,
    permanent: Integer,
}

/// The coordinates as integers: all multiplied by one power of two, which keeps all ratios.
fn integers(args: &[Vertex], row: impl Fn(Vertex) -> Vec<f64>) -> Vec<Vec<Integer>> {
    let rows: Vec<Vec<f64>> = args.iter().map(|&v| row(v)).collect();
    let lowest = lowest_exponent(rows.iter().flatten().copied());
    rows.into_iter().map(|row| row.into_iter().map(|x| integer(x, lowest)).collect()).collect()
}

/// Some coordinates of each vertex times its weight, and the weight.
fn weighted(scene: &Scene, args: &[Vertex], axes: &[Axis]) -> Vec<Vec<Integer>> {
    let row = |&v: &Vertex| {
        let point = homogeneous(scene, v).expect("constructions of a suite are points");
        let (weight, coordinates) = point.split_last().expect("a weight");
        axes.iter().map(|axis| &coordinates[axis.index()]).chain([weight]).cloned().collect()
    };
    args.iter().map(row).collect()
}

/// Each row, multiplied by its weight and the last row's weight, which keeps all ratios.
fn relative_to_last_weighted(rows: &[Vec<Integer>]) -> Vec<Vec<Integer>> {
    let (last, others) = rows.split_last().expect("a query has vertices");
    let width = last.len() - 1;
    let entry =
        |row: &[Integer], i: usize| Integer::from(&row[i] * &last[width]) - Integer::from(&last[i] * &row[width]);
    others.iter().map(|row| (0..width).map(|i| entry(row, i)).collect()).collect()
}

fn relative_to_last(rows: &[Vec<Integer>]) -> Vec<Vec<Integer>> {
    let (last, others) = rows.split_last().expect("a query has vertices");
    others.iter().map(|row| row.iter().zip(last).map(|(a, b)| Integer::from(a - b)).collect()).collect()
}

/// Appends the sum of squares to each row.
fn lifted(mut rows: Vec<Vec<Integer>>) -> Vec<Vec<Integer>> {
    for row in &mut rows {
        let lift = row.iter().map(|x| Integer::from(x.square_ref())).sum();
        row.push(lift);
    }
    rows
}

/// Determinant and permanent of the absolute values, along the last column.
fn minor(rows: &[Vec<Integer>]) -> Magnitudes {
    let width = rows.len();
    if let [row] = rows {
        return Magnitudes { det: row[0].clone(), permanent: row[0].clone().abs() };
    }
    let mut sum = Magnitudes { det: Integer::new(), permanent: Integer::new() };
    for (at, row) in rows.iter().enumerate() {
        let others: Vec<Vec<Integer>> =
            rows.iter().enumerate().filter(|&(i, _)| i != at).map(|(_, row)| row[..width - 1].to_vec()).collect();
        let Magnitudes { det, permanent } = minor(&others);
        let det = det * &row[width - 1];
        if (at + width).is_multiple_of(2) {
            sum.det -= det;
        } else {
            sum.det += det;
        }
        sum.permanent += permanent * row[width - 1].clone().abs();
    }
    sum
}

/// The value ⌊log₂(a / b)⌋ for positive a, b.
fn floor_log2_of_ratio(a: &Integer, b: &Integer) -> i64 {
    let guess = i64::from(a.significant_bits()) - i64::from(b.significant_bits());
    // a / b lies between 2^(guess - 1) and 2^(guess + 1).
    let shift = u32::try_from(guess.unsigned_abs()).expect("bit lengths fit");
    let not_less = if guess < 0 { Integer::from(a << shift) >= *b } else { *a >= Integer::from(b << shift) };
    if not_less { guess } else { guess - 1 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use rug::Rational;

    fn of(question: Question, points: &[&[f64]]) -> Option<i64> {
        let dimension = match points[0].len() {
            2 => predicament_predicates::Dimension::Two,
            _ => predicament_predicates::Dimension::Three,
        };
        let scene = Scene::new(dimension, points.concat()).unwrap();
        let queries = QuerySet::new(question, scene.vertices().collect());
        relative(&scene, &queries, 0)
    }

    #[test]
    fn known_ratios() {
        use predicament_predicates::{Axis, Plane};
        let xy = Question::Orient2d(Plane::Xy);
        // The case det = 1·1, without a second term.
        assert_eq!(of(xy, &[&[1.0, 0.0], &[0.0, 1.0], &[0.0, 0.0]]), Some(0));
        // det = 2 - 1, permanent 3.
        assert_eq!(of(xy, &[&[2.0, 1.0], &[1.0, 1.0], &[0.0, 0.0]]), Some(-2));
        assert_eq!(of(xy, &[&[2.0, 2.0], &[1.0, 1.0], &[0.0, 0.0]]), None);
        assert_eq!(of(Question::Compare(Axis::X), &[&[5e-324, 0.0], &[-5e-324, 0.0]]), Some(0));
        assert_eq!(of(Question::Compare(Axis::Y), &[&[1.0, 3.0], &[2.0, 5.0]]), Some(-2));
        // Corners of a unit box: the fifth in the middle of the sphere through four.
        let [o, x, y, z, m] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0; 3]];
        assert_eq!(of(Question::Insphere, &[&o, &x, &y, &z, &m]), None);
        assert!(of(Question::Insphere, &[&o, &x, &y, &z, &[0.5; 3]]).is_some());
    }

    proptest! {
        #[test]
        fn orient3d_agrees_with_straight_rationals(
            c in proptest::array::uniform12(prop_oneof![-8.0..8.0f64, (-4i8..4).prop_map(f64::from), 1e-310..1e-300f64])
        ) {
            let r = |i: usize, k: usize| Rational::from_f64(c[3 * i + k]).unwrap() - Rational::from_f64(c[9 + k]).unwrap();
            let (mut det, mut permanent) = (Rational::new(), Rational::new());
            for (p, even) in [([0, 1, 2], true), ([1, 2, 0], true), ([2, 0, 1], true), ([0, 2, 1], false), ([2, 1, 0], false), ([1, 0, 2], false)] {
                let product = r(p[0], 0) * r(p[1], 1) * r(p[2], 2);
                permanent += product.clone().abs();
                if even { det += product } else { det -= product }
            }
            let got = of(Question::Orient3d, &[&c[..3], &c[3..6], &c[6..9], &c[9..]]);
            match got {
                None => prop_assert!(det.is_zero()),
                Some(exponent) => {
                    let ratio = det.abs() / permanent;
                    let low = Rational::from(1) << i32::try_from(exponent).unwrap();
                    prop_assert!(low <= ratio && ratio < low * 2u32);
                }
            }
        }
    }
}
