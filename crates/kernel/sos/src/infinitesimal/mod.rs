//! The judge of ties: perturbed determinants as polynomials in the infinitesimals.
//!
//! The judge does not use term lists. The coordinates of a query's vertices become polynomials in one positive
//! infinitesimal ε, the textbook determinant of their differences is multiplied out, and its sign is that of the
//! coefficient of the lowest power of ε. This is slow, plain, and the reason to trust the fast method.
//!
//! # Exponents
//! In a scene, coordinate number n moves by ε^(B^n), with B = 3 or 2 by the scheme: too large to write down for the
//! thousandth vertex. A monomial's exponent is Σ dₙ·B^n with the degrees dₙ < B as digits, so exponents compare like
//! digit strings, from the highest place down. Removing places that are zero in all strings of a query changes no
//! comparison. So a query's vertices are renumbered 0, 1, 2… in the order of their indices, and twenty coordinates at
//! most remain: every exponent fits into 64 bits.
//!
//! # Truncation
//! Products of polynomials drop the powers above a limit. The remaining powers are right, as exponents only ever add
//! up; if all of them cancel, the limit rises to include the next vertex.

mod constructed;
mod formula;
mod polynomial;

pub use constructed::judge_per_mesh;

use predicament_predicates::{Axis, Question, Scene, Sign, Vertex};
use rug::{Integer, Rational};

use crate::Scheme;

/// The sign of the perturbed determinant behind a question.
///
/// It is zero only if a vertex occurs twice, or if it is zero for constructed vertices wherever the input vertices are.
///
/// # Panics
/// If `args` are not the vertices that the question takes, or the scene lacks one of them or an axis.
#[must_use]
pub fn judge(scheme: Scheme, scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    assert_eq!(args.len(), question.kind().arity(), "{} has its number of vertices", question.kind());
    if let Question::Derived(derived) = question {
        return formula::judge(scheme, scene, derived, args);
    }
    if args.iter().any(|v| v.is_constructed()) {
        assert_eq!(scheme, Scheme::PerCoordinate, "only this scheme moves constructed vertices");
        return constructed::judge(scene, question, args);
    }
    let perturbed = Perturbed::new(scheme, scene, args);
    let limits = perturbed.limits();
    let differences = |axes: &[Axis]| -> Vec<Vec<Series>> {
        (0..args.len() - 1).map(|a| axes.iter().map(|&axis| perturbed.difference(axis, a)).collect()).collect()
    };
    let matrix = match question {
        Question::Compare(axis) => differences(&[axis]),
        Question::Orient2d(plane) => differences(&plane.axes()),
        Question::Orient3d => differences(&[Axis::X, Axis::Y, Axis::Z]),
        Question::Incircle | Question::Insphere => {
            let axes = [Axis::X, Axis::Y, Axis::Z];
            let axes = if question == Question::Incircle { &axes[..2] } else { &axes[..] };
            let mut matrix = differences(axes);
            for (a, row) in matrix.iter_mut().enumerate() {
                row.push(perturbed.lift_difference(axes, a));
            }
            matrix
        }
        Question::Derived(_) => return Sign::Zero,
    };
    limits.map(|limit| determinant(&matrix, limit).sign()).find(|sign| !sign.is_zero()).unwrap_or(Sign::Zero)
}

/// A polynomial in ε: exponents, ascending, with nonzero coefficients.
#[derive(Clone, Debug, Default)]
struct Series(Vec<(u64, Integer)>);

impl Series {
    /// The polynomial of these terms, sorted, with equal exponents added up.
    fn collect(mut terms: Vec<(u64, Integer)>) -> Series {
        terms.sort_unstable_by_key(|&(exponent, _)| exponent);
        terms.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 += &next.1;
            }
            same
        });
        terms.retain(|(_, coefficient)| !coefficient.is_zero());
        Series(terms)
    }

    fn minus(&self, other: &Series) -> Series {
        let negative = other.0.iter().map(|(exponent, coefficient)| (*exponent, Integer::from(-coefficient)));
        Series::collect(self.0.iter().cloned().chain(negative).collect())
    }

    /// The product up to ε^limit.
    fn times(&self, other: &Series, limit: u64) -> Series {
        let mut terms = Vec::new();
        for (a, x) in &self.0 {
            let within = other.0.iter().take_while(|(b, _)| a + b <= limit);
            terms.extend(within.map(|(b, y)| (a + b, Integer::from(x * y))));
        }
        Series::collect(terms)
    }

    /// The sign for all small enough ε > 0.
    fn sign(&self) -> Sign {
        self.0.first().map_or(Sign::Zero, |(_, coefficient)| Sign::from(coefficient.cmp0()))
    }
}

/// The vertices of one query, moved.
struct Perturbed {
    scheme: Scheme,
    /// The coordinates, over one common denominator.
    points: Vec<Vec<Integer>>,
    /// For each vertex, the number of the query's vertices with a smaller index.
    ranks: Vec<u32>,
}

impl Perturbed {
    /// The vertices of a query, with integer coordinates.
    ///
    /// A positive factor common to all coordinates multiplies the coefficient of a monomial of degree k by the factor's
    /// k-th power, which changes no sign.
    fn new(scheme: Scheme, scene: &Scene, args: &[Vertex]) -> Perturbed {
        let rational = |&x: &f64| Rational::from_f64(x).expect("a scene's coordinates are finite");
        let points: Vec<Vec<Rational>> = args.iter().map(|&v| scene.point(v).iter().map(rational).collect()).collect();
        // Denominators of doubles are powers of two: the largest is a common one.
        let common = points.iter().flatten().map(Rational::denom).max().cloned().unwrap_or_else(|| Integer::from(1));
        let integer = |x: Rational| {
            let (numerator, own) = x.into_numer_denom();
            numerator << (common.significant_bits() - own.significant_bits())
        };
        let mut indices: Vec<Vertex> = args.to_vec();
        indices.sort_unstable();
        indices.dedup();
        Perturbed {
            scheme,
            points: points.into_iter().map(|point| point.into_iter().map(integer).collect()).collect(),
            ranks: args
                .iter()
                .map(|v| (0..).zip(&indices).find(|&(_, i)| i == v).map_or(0, |(rank, _)| rank))
                .collect(),
        }
    }

    /// The number of places of a vertex among the exponents' digits: three coordinates and the lift.
    ///
    /// A 2D scene leaves some of them unused.
    const PLACES: u32 = 4;

    /// The exponent of coordinate 0…2 or lift 3 of a vertex.
    fn exponent(&self, rank: u32, coordinate: u32) -> u64 {
        match self.scheme {
            Scheme::PerCoordinate => 3_u64.pow(rank * Self::PLACES + coordinate),
            // ε(i, j) = ε^(2^(iδ − j)) for i, j counted from 1
            Scheme::EdelsbrunnerMucke => 2_u64.pow((rank + 1) * Self::PLACES - (coordinate + 1)),
        }
    }

    /// The limits: no infinitesimal at all, then those of one more vertex each.
    fn limits(&self) -> impl Iterator<Item = u64> + use<> {
        let base = if self.scheme == Scheme::PerCoordinate { 3_u64 } else { 2 };
        (0..=5).map(move |vertices| base.pow(vertices * Self::PLACES) - 1)
    }

    /// A coordinate after the move.
    fn coordinate(&self, axis: Axis, a: usize) -> Series {
        let place = [0, 1, 2][axis.index()];
        let x = self.points[a][axis.index()].clone();
        Series::collect(vec![(0, x), (self.exponent(self.ranks[a], place), Integer::from(1))])
    }

    /// A coordinate minus the coordinate of the last vertex, after the move.
    fn difference(&self, axis: Axis, a: usize) -> Series {
        self.coordinate(axis, a).minus(&self.coordinate(axis, self.points.len() - 1))
    }

    /// The lift of a vertex after the move.
    ///
    /// It is the sum of squares of the moved coordinates, or the sum of the old squares with a separate move.
    fn lift(&self, axes: &[Axis], a: usize) -> Series {
        let terms = match self.scheme {
            Scheme::PerCoordinate => {
                let moved = axes.iter().map(|&axis| self.coordinate(axis, a));
                moved.flat_map(|x| x.times(&x, u64::MAX).0).collect()
            }
            Scheme::EdelsbrunnerMucke => {
                let squares = axes.iter().map(|axis| (0, self.points[a][axis.index()].clone().square()));
                squares.chain([(self.exponent(self.ranks[a], 3), Integer::from(1))]).collect()
            }
        };
        Series::collect(terms)
    }

    fn lift_difference(&self, axes: &[Axis], a: usize) -> Series {
        self.lift(axes, a).minus(&self.lift(axes, self.points.len() - 1))
    }
}

/// The determinant of a square matrix up to ε^limit, along its first column.
fn determinant(matrix: &[Vec<Series>], limit: u64) -> Series {
    /// The minors of the columns from `column` on, over the rows in `rows`.
    fn minor(matrix: &[Vec<Series>], column: usize, rows: &[usize], limit: u64) -> Series {
        if rows.is_empty() {
            return Series(vec![(0, Integer::from(1))]);
        }
        let mut terms = Vec::new();
        for (place, &row) in rows.iter().enumerate() {
            let rest = [&rows[..place], &rows[place + 1..]].concat();
            let product = matrix[row][column].times(&minor(matrix, column + 1, &rest, limit), limit);
            let signed = product.0.into_iter().map(|(e, c)| (e, if place % 2 == 0 { c } else { -c }));
            terms.extend(signed);
        }
        Series::collect(terms)
    }
    minor(matrix, 0, &(0..matrix.len()).collect::<Vec<_>>(), limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn series(terms: &[(u64, i32)]) -> Series {
        Series::collect(terms.iter().map(|&(exponent, c)| (exponent, Integer::from(c))).collect())
    }

    #[test]
    fn the_lowest_power_decides() {
        assert_eq!(series(&[(3, 5), (1, -1)]).sign(), Sign::Negative);
        assert_eq!(series(&[(1, 1), (3, 5), (1, -1)]).sign(), Sign::Positive);
        assert_eq!(series(&[]).sign(), Sign::Zero);
        let product = series(&[(0, 1), (1, 1)]).times(&series(&[(0, 1), (1, -1)]), 9);
        assert_eq!(product.0, [(0, Integer::from(1)), (2, Integer::from(-1))]);
        assert_eq!(series(&[(1, 1)]).times(&series(&[(1, 1)]), 1).sign(), Sign::Zero, "truncated");
    }

    #[test]
    fn a_tie_of_two_goes_to_the_smaller_index() {
        let scene = Scene::from_points2(&[[1.0, 2.0]; 3]).unwrap();
        let [a, b] = [0, 2].map(Vertex::input);
        for scheme in Scheme::ALL {
            for axis in [Axis::X, Axis::Y] {
                assert_eq!(judge(scheme, &scene, Question::Compare(axis), &[a, b]), Sign::Positive);
                assert_eq!(judge(scheme, &scene, Question::Compare(axis), &[b, a]), Sign::Negative);
                assert_eq!(judge(scheme, &scene, Question::Compare(axis), &[b, b]), Sign::Zero);
            }
        }
    }
}
