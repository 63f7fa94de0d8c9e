//! The truth about decimals: signs about the numbers that were written, not about their doubles.
//!
//! Decimals of one scene are integers over one power of ten. All predicates are homogeneous, so that the power changes
//! no sign, and the determinants are those of the integers.

use std::borrow::Cow;
use std::collections::BTreeMap;

use predicament_predicates::{Question, Scene, Sign, Vertex};
use rug::ops::Pow;
use rug::{Integer, Rational};

use crate::constructed::Solver;
use crate::determinant::{Verdict, axes, verdict_of};
use crate::integers;
use crate::row::Row;

/// The points of a scene as they were written: integers over one power of ten, in place of its coordinates.
pub struct Decimals<'a> {
    scene: &'a Scene,
    digits: u32,
    numerators: &'a [i128],
}

impl<'a> Decimals<'a> {
    /// The scene whose coordinates are `numerators` over 10^`digits`; constructed vertices are defined by these points.
    ///
    /// # Panics
    /// If there is not one numerator for each coordinate.
    #[must_use]
    pub fn new(scene: &'a Scene, digits: u32, numerators: &'a [i128]) -> Decimals<'a> {
        assert_eq!(numerators.len(), scene.coordinates().len(), "one numerator for each coordinate");
        Decimals { scene, digits, numerators }
    }

    /// The exact sign of a query about the decimals.
    ///
    /// # Panics
    /// If the query does not fit the scene, uses a construction that gives no point, or asks a formula.
    #[must_use]
    pub fn sign(&self, question: Question, args: &[Vertex]) -> Sign {
        let rows: Vec<_> = args.iter().map(|&v| Cow::Owned(self.row(v))).collect();
        integers::sign_of_rows(&rows, axes(&question), question.kind().is_lifted())
    }

    /// The exact determinant of a query about the decimals with its permanent, in rationals.
    ///
    /// # Panics
    /// As [`sign`](Decimals::sign).
    #[must_use]
    pub fn verdict(&self, question: Question, args: &[Vertex]) -> Verdict {
        let one = Integer::from(10).pow(self.digits);
        let point = |v| self.row(v).point().into_iter().map(|x| x / &one).collect::<Vec<Rational>>();
        verdict_of(question, args, |v| Cow::Owned(point(v)))
    }

    /// The point in units of the last digit, over one denominator.
    fn row(&self, v: Vertex) -> Row {
        let stride = self.scene.dimension().count();
        let input = |v: Vertex| Row {
            coordinates: self.numerators[v.index() * stride..][..stride].iter().map(|&n| n.into()).collect(),
            weight: Integer::from(1),
        };
        let row = Solver { scene: self.scene, input: &input, known: BTreeMap::new() }.row(v);
        row.unwrap_or_else(|| panic!("{v} is not a point"))
    }
}

#[cfg(test)]
mod tests {
    use predicament_predicates::{Construction, Plane};

    use super::*;

    const ORIENT2D: Question = Question::Orient2d(Plane::Xy);

    fn inputs<const N: usize>(ids: [usize; N]) -> [Vertex; N] {
        ids.map(Vertex::input)
    }

    /// The points (0.1, 0.1), (0.2, 0.2) and (0.3, 0.3) are on a line, and their doubles too; (0.1, 0.3), (0.2, 0.6)
    /// and (0.3, 0.9) are on a line, and their doubles are not.
    #[test]
    fn a_line_of_decimals_is_no_line_of_doubles() {
        let points = [[0.1, 0.3], [0.2, 0.6], [0.3, 0.9]];
        let scene = Scene::from_points2(&points).unwrap();
        let decimals = Decimals::new(&scene, 1, &[1, 3, 2, 6, 3, 9]);
        let args = inputs([0, 1, 2]);
        assert_eq!(decimals.sign(ORIENT2D, &args), Sign::Zero);
        assert_eq!(decimals.verdict(ORIENT2D, &args).sign(), Sign::Zero);
        assert_ne!(crate::sign(&scene, ORIENT2D, &args), Sign::Zero);
        let beside = Decimals::new(&scene, 1, &[1, 3, 2, 6, 3, 10]);
        assert_eq!(beside.sign(ORIENT2D, &args), Sign::Positive);
        assert_eq!(beside.verdict(ORIENT2D, &args).determinant, Rational::from((1, 100)));
    }

    #[test]
    fn constructed_points_are_those_of_the_decimals() {
        let points = [[0.1, 0.1], [0.3, 0.7], [0.1, 0.7], [0.3, 0.1], [0.2, 0.0]];
        let mut scene = Scene::from_points2(&points).unwrap();
        let [a, b, c, d, e] = inputs([0, 1, 2, 3, 4]);
        let meet = scene.construct(Construction::Ssi([[a, b], [c, d]])).unwrap();
        let decimals = Decimals::new(&scene, 1, &[1, 1, 3, 7, 1, 7, 3, 1, 2, 0]);
        let question = Question::Compare(predicament_predicates::Axis::X);
        assert_eq!(decimals.sign(question, &[meet, e]), Sign::Zero);
        assert_eq!(decimals.verdict(question, &[meet, e]).sign(), Sign::Zero);
    }
}
