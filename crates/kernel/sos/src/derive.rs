//! Derivation of the term lists from the schemes; none is copied from a paper.
//!
//! For each scheme and predicate: expand the determinant of the perturbed points into monomials of infinitesimals,
//! order them by size, and keep the coefficients up to the first one that is a nonzero constant. Coefficients that
//! can't be the first nonzero one are dropped (see [`ideal`]). The file `tables.rs` is [`tables`]' output; a test
//! compares them.

pub mod ideal;
pub mod polynomial;

use std::fmt::Write as _;

use predicament_predicates::{PredicateKind, Sign};
use rug::Rational;

use crate::Scheme;
use ideal::Ideal;
use polynomial::{AXES, Polynomial, Powers, determinant};

/// The largest degree of powers of a coefficient that are searched for in the ideal.
///
/// At 5 the linear algebra of spheres would take minutes instead of seconds.
const POWER_DEGREE: u8 = 4;

/// The columns of a predicate's matrix.
#[derive(Clone, Copy)]
struct Shape {
    /// The number of coordinates of a point.
    axes: usize,
    /// True if their sum of squares follows.
    lifted: bool,
}

impl Shape {
    fn of(kind: PredicateKind) -> Shape {
        let (axes, lifted) = match kind {
            PredicateKind::Compare => (1, false),
            PredicateKind::Orient2d => (2, false),
            PredicateKind::Orient3d => (3, false),
            PredicateKind::Incircle => (2, true),
            PredicateKind::Insphere => (3, true),
            PredicateKind::Derived(_) => unreachable!("tables are of the five predicates"),
        };
        Shape { axes, lifted }
    }

    /// The number of columns that carry data: coordinates and lift.
    fn data(self) -> usize {
        self.axes + usize::from(self.lifted)
    }

    /// The number of rows: one vertex more than data columns.
    fn rows(self) -> usize {
        self.data() + 1
    }

    /// A row of the unperturbed matrix.
    fn row(self, place: usize) -> Vec<Polynomial> {
        let coordinates = (0..self.axes).map(|axis| Polynomial::coordinate(place, axis));
        let lift = self.lifted.then(|| {
            (0..self.axes)
                .map(|axis| Polynomial::coordinate(place, axis))
                .map(|x| x.times(&x))
                .reduce(|a, b| a.plus(&b))
        });
        coordinates.chain(lift.flatten()).chain([Polynomial::constant(1)]).collect()
    }
}

/// One row's share of a monomial: the infinitesimal of a column, to a power.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Move {
    row: usize,
    column: usize,
    power: u8,
}

impl Move {
    /// The row's replacement in the coefficient.
    ///
    /// It is the factor of the infinitesimal in the perturbed row.
    fn replacement(self, scheme: Scheme, shape: Shape) -> Vec<Polynomial> {
        let mut row = vec![Polynomial::default(); shape.rows()];
        if self.power == 1 {
            row[self.column] = Polynomial::constant(1);
        }
        if scheme == Scheme::PerCoordinate && shape.lifted {
            // (x + e)² = x² + 2x·e + e²
            let x = Polynomial::coordinate(self.row, self.column);
            row[shape.axes] = if self.power == 1 { x.clone().plus(&x) } else { Polynomial::constant(1) };
        }
        row
    }
}

/// A monomial of the perturbed determinant.
///
/// It has at most one move per row, as the determinant is linear in each row and no entry mixes two infinitesimals.
type Monomial = Vec<Move>;

/// All candidate monomials, the largest infinitesimal first.
fn monomials(scheme: Scheme, shape: Shape) -> Vec<Monomial> {
    let squares = scheme == Scheme::PerCoordinate && shape.lifted;
    let columns = if scheme == Scheme::PerCoordinate { shape.axes } else { shape.data() };
    let powers = if squares { 1..=2 } else { 1..=1 };
    let mut all: Vec<Monomial> = vec![Vec::new()];
    for row in 0..shape.rows() {
        let moves: Vec<Move> =
            (0..columns).flat_map(|column| powers.clone().map(move |power| Move { row, column, power })).collect();
        let longer = all.iter().flat_map(|shorter| moves.iter().map(|&next| [shorter.as_slice(), &[next]].concat()));
        all = longer.chain(all.iter().cloned()).collect();
    }
    // The smallest infinitesimal that occurs decides first, then its power.
    all.sort_by_key(|monomial| {
        let mut digits = vec![0; shape.rows() * columns];
        for &Move { row, column, power } in monomial {
            let within = match scheme {
                Scheme::PerCoordinate => column,
                Scheme::EdelsbrunnerMucke => columns - 1 - column,
            };
            digits[row * columns + within] = power;
        }
        digits.reverse();
        digits
    });
    all
}

/// A term with its monomial.
struct Derived {
    monomial: Monomial,
    sign: Sign,
    gap: Option<[usize; 3]>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    lift: Option<[Option<usize>; AXES]>,
}

impl Derived {
    /// The remaining matrix, after column operations on the replaced rows:
    /// * a row (…1…) strikes its column;
    /// * a row (…1…, 2x in the lift) strikes its column after 2x times that column was subtracted from the lift, which
    ///   turns x_c² into (x_c − x)² up to a multiple of the column of ones;
    /// * two such rows of one column differ by 2(x_b − x_a) in the lift alone, so the second strikes the lift and
    ///   leaves a factor.
    fn new(scheme: Scheme, shape: Shape, monomial: Monomial) -> Derived {
        let moving_lift = scheme == Scheme::PerCoordinate && shape.lifted;
        let mut about = [None; AXES];
        let mut struck: Vec<usize> = Vec::new();
        let mut gap = None;
        for &Move { row, column, power } in &monomial {
            if power == 2 {
                struck.push(shape.axes);
            } else if let Some(first) = monomial.iter().find(|m| m.column == column && m.row < row && m.power == 1) {
                struck.push(shape.axes);
                gap = Some([column, first.row, row]);
            } else {
                struck.push(column);
                if moving_lift {
                    about[column] = Some(row);
                }
            }
        }
        let lift_left = shape.lifted && !struck.contains(&shape.axes);
        Derived {
            rows: (0..shape.rows()).filter(|row| monomial.iter().all(|m| m.row != *row)).collect(),
            columns: (0..shape.axes).filter(|column| !struck.contains(column)).collect(),
            lift: lift_left.then_some(about),
            gap,
            monomial,
            sign: Sign::Positive,
        }
    }

    /// The term as a polynomial, in the form of its evaluation.
    fn polynomial(&self, shape: Shape) -> Polynomial {
        let lift = |row: usize, about: &[Option<usize>; AXES]| {
            (0..shape.axes)
                .map(|axis| {
                    let origin = about[axis].map_or_else(Polynomial::default, |row| Polynomial::coordinate(row, axis));
                    let x = Polynomial::coordinate(row, axis).minus(&origin);
                    x.times(&x)
                })
                .fold(Polynomial::default(), |sum, square| sum.plus(&square))
        };
        let matrix: Vec<Vec<Polynomial>> = self
            .rows
            .iter()
            .map(|&row| {
                let coordinates = self.columns.iter().map(|&column| Polynomial::coordinate(row, column));
                let lift = self.lift.iter().map(|about| lift(row, about));
                coordinates.chain(lift).chain([Polynomial::constant(1)]).collect()
            })
            .collect();
        let minor = determinant(&matrix);
        match self.gap {
            Some([column, from, to]) => {
                minor.times(&Polynomial::coordinate(from, column).minus(&Polynomial::coordinate(to, column)))
            }
            None => minor,
        }
    }

    /// The Rust expression of the [`Term`](crate::Term).
    fn source(&self) -> String {
        let mut source = format!("Term::minor({:?}, &{:?}, &{:?})", self.sign, self.rows, self.columns);
        if let Some(about) = self.lift {
            let _ = write!(source, ".lifted({about:?})");
        }
        if let Some([column, from, to]) = self.gap {
            let _ = write!(source, ".times(Gap {{ column: {column}, from: {from}, to: {to} }})");
        }
        source
    }

    fn monomial_name(&self) -> String {
        let factor = |m: &Move| format!("ε({},{}){}", m.row, m.column, if m.power == 2 { "²" } else { "" });
        self.monomial.iter().map(factor).collect::<Vec<_>>().join("·")
    }
}

/// The terms of one predicate, the largest first, ending with a constant.
///
/// # Panics
/// If a coefficient does not equal its simplified term: then the simplification is wrong, and no table must be written.
fn terms(scheme: Scheme, kind: PredicateKind) -> Vec<Derived> {
    let shape = Shape::of(kind);
    let variables = (0..shape.rows()).flat_map(|row| (0..shape.axes).map(move |axis| row * AXES + axis));
    let mut ideal = Ideal::new(variables.collect());
    let mut kept = Vec::new();
    for monomial in monomials(scheme, shape) {
        let mut matrix: Vec<_> = (0..shape.rows()).map(|place| shape.row(place)).collect();
        for m in &monomial {
            matrix[m.row] = m.replacement(scheme, shape);
        }
        let coefficient = determinant(&matrix);
        if coefficient.is_zero() || ideal.implies(&coefficient, POWER_DEGREE) {
            continue;
        }
        let last = coefficient.degree() == 0;
        if !monomial.is_empty() {
            let mut term = Derived::new(scheme, shape, monomial);
            term.sign = sign_of_multiple(&coefficient, &term.polynomial(shape))
                .unwrap_or_else(|| panic!("the coefficient of {} was simplified wrongly", term.monomial_name()));
            kept.push(term);
        }
        ideal.insert(coefficient);
        if last {
            break;
        }
    }
    kept
}

/// The sign of the number r with `polynomial` = r·`of`, if there is one.
fn sign_of_multiple(polynomial: &Polynomial, of: &Polynomial) -> Option<Sign> {
    let ratio = Rational::from(polynomial.leading()?.1 / of.leading()?.1);
    let mut difference = polynomial.clone();
    difference.add_product(&Rational::from(-&ratio), &Powers::default(), of);
    difference.is_zero().then(|| Sign::from(ratio.cmp0()))
}

const HEADER: &str = "\
//! The terms that break ties, by scheme and predicate.
//!
//! Generated by `cargo run --release -p predicament-sos --features gmp --bin derive_sos_terms`; do not edit.
//!
//! Each line names its monomial: ε(r,c) is the infinitesimal of coordinate c
//! of the vertex at the sorted place r.

use predicament_predicates::Sign::{Negative, Positive};

use crate::{Gap, Term};
";

/// The source text of `tables.rs`.
///
/// # Panics
/// If a derivation contradicts itself: then no table must be written.
#[must_use]
pub fn tables() -> String {
    let mut text = HEADER.to_owned();
    for scheme in Scheme::ALL {
        for kind in PredicateKind::ALL {
            let name = format!("{scheme}_{kind}").replace('-', "_").to_uppercase();
            let terms = terms(scheme, kind);
            let _ = writeln!(text, "\n/// {kind}, {scheme}.\npub const {name}: &[Term] = &[");
            for term in &terms {
                let _ = writeln!(text, "    {}, // {}", term.source(), term.monomial_name());
            }
            text.push_str("];\n");
        }
    }
    text
}
