//! Polynomials in the coordinates of up to five points, with rational coefficients.

use std::collections::BTreeMap;

use rug::Rational;

/// The maximum number of points of a predicate.
pub const PLACES: usize = 5;
/// The maximum number of coordinates of a point.
pub const AXES: usize = 3;

/// The degree in each coordinate, point after point.
pub type Powers = [u8; PLACES * AXES];

/// A polynomial, without zero coefficients.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Polynomial(BTreeMap<Powers, Rational>);

impl Polynomial {
    /// A constant polynomial.
    #[must_use]
    pub fn constant(value: i32) -> Polynomial {
        let term = (value != 0).then(|| (Powers::default(), Rational::from(value)));
        Polynomial(term.into_iter().collect())
    }

    /// The polynomial of one coordinate of the point at a place.
    #[must_use]
    pub fn coordinate(place: usize, axis: usize) -> Polynomial {
        let mut powers = [0; PLACES * AXES];
        powers[place * AXES + axis] = 1;
        Polynomial(BTreeMap::from([(powers, Rational::from(1))]))
    }

    /// Returns true if the polynomial vanishes everywhere.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The highest monomial and its coefficient; `None` for zero.
    #[must_use]
    pub fn leading(&self) -> Option<(&Powers, &Rational)> {
        self.0.last_key_value()
    }

    /// The highest total degree of a monomial; 0 for zero.
    #[must_use]
    pub fn degree(&self) -> u8 {
        self.0.keys().map(|powers| powers.iter().sum()).max().unwrap_or(0)
    }

    /// Adds `factor` × the monomial `shift` × `other`.
    pub fn add_product(&mut self, factor: &Rational, shift: &Powers, other: &Polynomial) {
        for (powers, coefficient) in &other.0 {
            let powers = std::array::from_fn(|i| powers[i] + shift[i]);
            let sum = self.0.entry(powers).or_default();
            *sum += Rational::from(factor * coefficient);
            if sum.is_zero() {
                self.0.remove(&powers);
            }
        }
    }

    /// The sum.
    #[must_use]
    pub fn plus(mut self, other: &Polynomial) -> Polynomial {
        self.add_product(&Rational::from(1), &Powers::default(), other);
        self
    }

    /// The difference.
    #[must_use]
    pub fn minus(mut self, other: &Polynomial) -> Polynomial {
        self.add_product(&Rational::from(-1), &Powers::default(), other);
        self
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Polynomial) -> Polynomial {
        let mut product = Polynomial::default();
        for (powers, coefficient) in &self.0 {
            product.add_product(coefficient, powers, other);
        }
        product
    }
}

/// The determinant of a square matrix, expanded along its first row.
#[must_use]
pub fn determinant(rows: &[Vec<Polynomial>]) -> Polynomial {
    let Some((first, rest)) = rows.split_first() else {
        return Polynomial::constant(1);
    };
    let mut sum = Polynomial::default();
    for (column, entry) in first.iter().enumerate().filter(|(_, entry)| !entry.is_zero()) {
        let minor: Vec<Vec<Polynomial>> = rest
            .iter()
            .map(|row| row.iter().enumerate().filter(|&(c, _)| c != column).map(|(_, entry)| entry.clone()).collect())
            .collect();
        let product = entry.times(&determinant(&minor));
        sum = if column.is_multiple_of(2) { sum.plus(&product) } else { sum.minus(&product) };
    }
    sum
}
