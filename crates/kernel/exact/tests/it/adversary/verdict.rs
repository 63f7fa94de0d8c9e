//! The rounding error of some points, in rationals.

use crate::rational::Value;
use predicament_arithmetic::bound::UNIT_ROUNDOFF;
use rug::Rational;

use super::traced::Formula;

/// The error of x + y, exactly.
pub struct Verdict {
    /// The error |(x + y) − D|.
    error: Rational,
    /// The sum |x + y|.
    sum: Rational,
    /// The permanent of the coordinates as given.
    permanent: Rational,
}

impl Verdict {
    /// The verdict about x and y as this formula computes them.
    pub fn new<const D: usize, const N: usize>(
        formula: Formula<D, N>,
        points: &[[f64; D]; N],
        truth: &Value,
    ) -> Verdict {
        let [x, y] = formula(points).map(|part| exact(part.value));
        let sum = x + y;
        let error = (&sum - truth.to_rational()).abs();
        Verdict { error, sum: sum.abs(), permanent: permanent(points) }
    }

    /// Returns true if the error is at most `constant`·P + `price`·u·|x + y|.
    ///
    /// This is the proved bound if `price` is 0 for orient2d and insphere, ½ for orient3d, and less than 15 for
    /// incircle. Near ties depend only on this part of the bound.
    pub fn within(&self, constant: f64, price: f64) -> bool {
        self.error <= exact(constant) * &self.permanent + self.paid(price)
    }

    /// Returns true if the error is at most `bound` + `price`·u·|x + y|.
    pub fn below(&self, bound: f64, price: f64) -> bool {
        self.error <= exact(bound) + self.paid(price)
    }

    fn paid(&self, price: f64) -> Rational {
        exact(price * UNIT_ROUNDOFF) * &self.sum
    }

    /// The constant, in units of u, for which the bound would just hold.
    pub fn badness(&self, price: f64) -> f64 {
        let error = &self.error - self.paid(price);
        (error / &self.permanent / exact(UNIT_ROUNDOFF)).to_f64()
    }
}

/// The permanent of the differences from the last point.
///
/// It is the sum of the magnitudes of all products with one entry from each row and column. The columns are the axes
/// and, if there are more rows than axes, the squared lengths.
fn permanent<const D: usize, const N: usize>(points: &[[f64; D]; N]) -> Rational {
    let rows = points[..N - 1].iter().map(|point| {
        let differences = (0..D).map(|axis| (exact(point[axis]) - exact(points[N - 1][axis])).abs());
        let mut row: Vec<Rational> = differences.collect();
        if N - 1 > D {
            row.push(row.iter().map(|x| Rational::from(x * x)).sum());
        }
        row
    });
    expand(&rows.collect::<Vec<_>>(), &mut vec![false; N - 1])
}

fn expand(rows: &[Vec<Rational>], taken: &mut [bool]) -> Rational {
    let Some((row, rest)) = rows.split_first() else {
        return Rational::from(1);
    };
    let mut sum = Rational::new();
    for (column, entry) in row.iter().enumerate() {
        if !taken[column] {
            taken[column] = true;
            sum += entry * expand(rest, taken);
            taken[column] = false;
        }
    }
    sum
}

fn exact(x: f64) -> Rational {
    Rational::from_f64(x).expect("finite")
}
