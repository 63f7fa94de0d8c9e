//! Polynomials with whole coefficients: the exact values of traced formulas, and their permanents.

use std::collections::BTreeMap;

use crate::trace::{Node, Traced};

/// A product of powers of symbols, as a sorted list with repetitions.
pub type Monomial = Vec<String>;

/// A polynomial: the coefficient of each monomial, none of them zero.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Polynomial(pub BTreeMap<Monomial, i64>);

impl Polynomial {
    /// A constant.
    #[must_use]
    pub fn constant(value: i64) -> Polynomial {
        Polynomial(if value == 0 { BTreeMap::new() } else { BTreeMap::from([(Vec::new(), value)]) })
    }

    /// A symbol.
    #[must_use]
    pub fn symbol(name: &str) -> Polynomial {
        Polynomial(BTreeMap::from([(vec![name.to_owned()], 1)]))
    }

    /// The sum of this polynomial and `factor` times the other.
    #[must_use]
    pub fn plus(&self, other: &Polynomial, factor: i64) -> Polynomial {
        let mut sum = self.clone();
        for (monomial, coefficient) in &other.0 {
            let entry = sum.0.entry(monomial.clone()).or_insert(0);
            *entry += factor * coefficient;
            if *entry == 0 {
                sum.0.remove(monomial);
            }
        }
        sum
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Polynomial) -> Polynomial {
        let mut product = Polynomial::default();
        for (left, a) in &self.0 {
            for (right, b) in &other.0 {
                let mut monomial = [left.as_slice(), right].concat();
                monomial.sort();
                product = product.plus_term(monomial, a * b);
            }
        }
        product
    }

    fn plus_term(mut self, monomial: Monomial, coefficient: i64) -> Polynomial {
        let entry = self.0.entry(monomial.clone()).or_insert(0);
        *entry += coefficient;
        if *entry == 0 {
            self.0.remove(&monomial);
        }
        self
    }

    /// The polynomial with other symbols in place of its own.
    #[must_use]
    pub fn renamed(&self, name: impl Fn(&str) -> String) -> Polynomial {
        let mut renamed = Polynomial::default();
        for (monomial, coefficient) in &self.0 {
            let mut monomial: Monomial = monomial.iter().map(|symbol| name(symbol)).collect();
            monomial.sort();
            renamed = renamed.plus_term(monomial, *coefficient);
        }
        renamed
    }

    /// The terms that have the symbol, and the others.
    #[must_use]
    pub fn split(&self, symbol: &str) -> [Polynomial; 2] {
        let of = |has: bool| {
            let terms = self.0.iter().filter(|(monomial, _)| monomial.iter().any(|name| name == symbol) == has);
            Polynomial(terms.map(|(monomial, coefficient)| (monomial.clone(), *coefficient)).collect())
        };
        [of(true), of(false)]
    }

    /// The sum of all coefficients' magnitudes: a bound of the value if no symbol is above one.
    #[must_use]
    pub fn weight(&self) -> i64 {
        self.0.values().map(|coefficient| coefficient.abs()).sum()
    }
}

/// The exact value of a traced formula as a polynomial in its inputs, without any rounding.
///
/// # Panics
/// If the formula has a quotient, a root or a magnitude.
#[must_use]
pub fn exact(x: Traced) -> Polynomial {
    match x.node() {
        Node::One => Polynomial::constant(1),
        Node::Input(name) => Polynomial::symbol(&name),
        Node::Add(x, y) => exact(x).plus(&exact(y), 1),
        Node::Sub(x, y) => exact(x).plus(&exact(y), -1),
        Node::Mul(x, y) => exact(x).times(&exact(y)),
        Node::Neg(x) => Polynomial::default().plus(&exact(x), -1),
        Node::Abs(_) | Node::Div(..) | Node::Sqrt(_) => panic!("{} is not a polynomial", x.text(4)),
    }
}

/// The determinant of rows of polynomials, by Leibniz' formula.
#[must_use]
pub fn determinant(rows: &[Vec<Polynomial>]) -> Polynomial {
    let Some((first, rest)) = rows.split_first() else { return Polynomial::constant(1) };
    let mut sum = Polynomial::default();
    for (column, entry) in first.iter().enumerate() {
        let minor: Vec<Vec<Polynomial>> = rest
            .iter()
            .map(|row| row.iter().enumerate().filter(|(at, _)| *at != column).map(|(_, entry)| entry.clone()).collect())
            .collect();
        sum = sum.plus(&entry.times(&determinant(&minor)), if column % 2 == 0 { 1 } else { -1 });
    }
    sum
}
