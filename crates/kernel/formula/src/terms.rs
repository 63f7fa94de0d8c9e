//! Simulation of Simplicity for any polynomial: the terms that break a tie, largest first.
//!
//! Each coordinate x of the arguments becomes x + ε, with an infinitesimal of its own. The value is then a sum of
//! Taylor coefficients times products of infinitesimals (Edelsbrunner and Mücke 1990, section 3; Franklin and
//! Magalhães, the infinitesimals ε^(b^i)). The infinitesimals shrink so fast that the smallest one that occurs in a
//! product decides its size, then the power of that, then the next one. The sign of the sum is the sign of the first
//! coefficient that is not zero.
//!
//! **There always is one.** Take the monomial x^α of the polynomial whose product of infinitesimals ε^α is smallest. No
//! other monomial is divisible by x^α, since its product would be smaller still. So the coefficient of ε^α is a
//! constant, and it is not zero. The list ends there. The argument needs different vertices: if an argument occurs
//! twice, its variables are one, and the polynomial may vanish for every perturbation. [`Terms::of`] then returns an
//! empty list.

use std::collections::BTreeSet;

use crate::polynomial::Polynomial;
use crate::program::{Builder, Program};

/// The most products of infinitesimals that are tried.
const MOST_PRODUCTS: usize = 2_000_000;

/// The order of the coordinates of one vertex, the largest infinitesimal first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Order {
    /// x, y, z: Franklin's, x_i + ε^(b^i).
    FirstLargest,
    /// z, y, x: that of Edelsbrunner and Mücke.
    LastLargest,
}

/// The terms that break ties of one polynomial for one order of its arguments.
#[derive(Clone, PartialEq, Debug)]
pub struct Terms {
    /// The powers of the infinitesimals of each term, by variable.
    powers: Vec<Vec<u8>>,
    /// The coefficients; the last one is a constant unless the perturbation leaves ties.
    coefficients: Vec<Polynomial>,
    programs: Vec<Program>,
}

impl Terms {
    /// The terms for arguments with these ranks: `ranks[i]` is the place of argument i among the different vertices, by
    /// index, and equal arguments have equal ranks.
    ///
    /// # Errors
    /// The reason, if the list is too long to derive.
    pub fn of(polynomial: &Polynomial, ranks: &[usize], coordinates: usize, order: Order) -> Result<Terms, String> {
        // The place of each variable: larger places are smaller infinitesimals.
        let place = |variable: usize| {
            let (point, axis) = (variable / coordinates, variable % coordinates);
            let within = if order == Order::FirstLargest { axis } else { coordinates - 1 - axis };
            ranks[point] * coordinates + within
        };
        let to: Vec<usize> = (0..ranks.len() * coordinates).map(place).collect();
        // Variables by place; equal arguments have become one.
        let placed = merged(polynomial, &to)?;
        if !has_few_products(&placed) {
            return Err(format!("more than {MOST_PRODUCTS} products of infinitesimals"));
        }
        let mut terms = Terms { powers: Vec::new(), coefficients: Vec::new(), programs: Vec::new() };
        let all: Vec<Monomial<'_>> = placed.terms().collect();
        let mut visit = |powers: &[u8], multiples: &[Monomial<'_>]| -> Result<bool, String> {
            let coefficient = Polynomial::taylor_of(multiples.iter().copied(), powers)
                .ok_or("a coefficient of a term needs more than 128 bits")?;
            // The first product is empty: the value itself.
            if coefficient.is_empty() || powers.iter().all(|&power| power == 0) {
                return Ok(false);
            }
            let back = unplaced(&coefficient, &to);
            let negative = back.negated();
            if !terms.coefficients.iter().any(|known| *known == back || *known == negative) {
                terms.programs.push(program(&back, coordinates));
                terms.coefficients.push(back);
                terms.powers.push(to.iter().map(|&place| powers[place]).collect());
            }
            Ok(coefficient.degree() == 0)
        };
        let mut powers = vec![0; to.len()];
        each_product(&all, to.len(), &mut powers, &mut visit)?;
        Ok(terms)
    }

    /// The terms if some points move together by η·(ε, ε², ε³, …), the perturbation of a whole mesh.
    ///
    /// As η is smaller than every power of ε, terms of a lower degree come first.
    ///
    /// Ties within the moved points, or within the others, stay: then the list is empty or has no constant.
    ///
    /// # Errors
    /// The reason, if the list is too long to derive.
    pub fn of_moved(polynomial: &Polynomial, moves: &[bool], coordinates: usize) -> Result<Terms, String> {
        let mut products = BTreeSet::new();
        for (exponents, _) in polynomial.terms() {
            let moved: Vec<u8> = exponents
                .iter()
                .enumerate()
                .map(|(at, &power)| if moves[at / coordinates] { power } else { 0 })
                .collect();
            divisors(&moved, &mut products);
        }
        let mut by_monomial: std::collections::BTreeMap<[usize; 2], Polynomial> = std::collections::BTreeMap::new();
        for reversed in products.into_iter().skip(1) {
            let powers: Vec<u8> = reversed.into_iter().rev().collect();
            let degree = powers.iter().copied().map(usize::from).sum();
            let size = powers.iter().enumerate().map(|(at, &power)| usize::from(power) * (at % coordinates + 1)).sum();
            let coefficient = polynomial.taylor(&powers).ok_or("a coefficient of a term needs more than 128 bits")?;
            let sum = by_monomial.entry([degree, size]).or_default();
            *sum = sum.sum(&coefficient).ok_or("a coefficient of a term needs more than 128 bits")?;
        }
        let coefficients: Vec<Polynomial> = by_monomial.into_values().filter(|term| !term.is_empty()).collect();
        let programs = coefficients.iter().map(|term| program(term, coordinates)).collect();
        Ok(Terms { powers: Vec::new(), coefficients, programs })
    }

    /// The programs of the terms, to be evaluated in this order until one is not zero.
    #[must_use]
    pub fn programs(&self) -> &[Program] {
        &self.programs
    }

    /// The terms as polynomials in the coordinates of the arguments.
    #[must_use]
    pub fn coefficients(&self) -> &[Polynomial] {
        &self.coefficients
    }

    /// The powers of the infinitesimals of each term, by variable.
    #[must_use]
    pub fn powers(&self) -> &[Vec<u8>] {
        &self.powers
    }
}

/// A monomial: its exponents and its coefficient.
type Monomial<'p> = (&'p [u8], i128);

/// A visit of a product, by its powers and the monomials that are multiples of it; true if it is the last.
type Visit<'v, 'p> = dyn FnMut(&[u8], &[Monomial<'p>]) -> Result<bool, String> + 'v;

/// Visits the products of infinitesimals of some monomials, with the multiples of each among them, until a visit
/// returns true; returns true if one did.
///
/// The largest product comes first: the one with the lowest power of the smallest infinitesimal, which is the last of
/// the `open` variables. The powers of those after them are given.
fn each_product<'p>(
    multiples: &[Monomial<'p>],
    open: usize,
    powers: &mut [u8],
    visit: &mut Visit<'_, 'p>,
) -> Result<bool, String> {
    let Some(last) = open.checked_sub(1) else { return visit(powers, multiples) };
    let most = multiples.iter().map(|(exponents, _)| exponents[last]).max().unwrap_or(0);
    let mut rest = multiples.to_vec();
    for power in 0..=most {
        rest.retain(|(exponents, _)| exponents[last] >= power);
        powers[last] = power;
        if each_product(&rest, last, powers, visit)? {
            return Ok(true);
        }
    }
    powers[last] = 0;
    Ok(false)
}

/// True if there are at most [`MOST_PRODUCTS`] products of infinitesimals.
fn has_few_products(polynomial: &Polynomial) -> bool {
    let count = |exponents: &[u8]| exponents.iter().fold(1_usize, |all, &e| all.saturating_mul(usize::from(e) + 1));
    if polynomial.terms().fold(0_usize, |all, (exponents, _)| all.saturating_add(count(exponents))) <= MOST_PRODUCTS {
        return true;
    }
    // Some may be products of several monomials.
    let mut products = BTreeSet::new();
    polynomial.terms().all(|(exponents, _)| {
        divisors(exponents, &mut products);
        products.len() <= MOST_PRODUCTS
    })
}

/// Adds all divisors of a monomial, with exponents from the smallest infinitesimal on.
fn divisors(exponents: &[u8], into: &mut BTreeSet<Vec<u8>>) {
    let mut divisors: Vec<Vec<u8>> = vec![Vec::new()];
    for &exponent in exponents.iter().rev() {
        divisors = divisors
            .into_iter()
            .flat_map(|start| (0..=exponent).map(move |power| [start.as_slice(), &[power]].concat()))
            .collect();
    }
    into.extend(divisors);
}

/// The polynomial with variable `i` renamed to `to[i]`; several may become one.
fn merged(polynomial: &Polynomial, to: &[usize]) -> Result<Polynomial, String> {
    let variables = to.len();
    polynomial
        .mapped(|exponents| {
            let mut renamed = vec![0_u8; variables];
            for (&exponent, &to) in exponents.iter().zip(to) {
                renamed[to] = renamed[to].checked_add(exponent)?;
            }
            Some(renamed)
        })
        .ok_or_else(|| "a coefficient needs more than 128 bits".to_owned())
}

/// The polynomial with variables by argument again; of equal arguments the first one is named.
fn unplaced(polynomial: &Polynomial, to: &[usize]) -> Polynomial {
    let from = |place: usize| to.iter().position(|&to| to == place).unwrap_or(place);
    let renamed = polynomial.mapped(|exponents| {
        let mut renamed = vec![0_u8; exponents.len()];
        for (place, &exponent) in exponents.iter().enumerate() {
            if exponent > 0 {
                renamed[from(place)] = exponent;
            }
        }
        Some(renamed)
    });
    renamed.unwrap_or_default()
}

/// A program that evaluates a polynomial, monomial by monomial.
fn program(polynomial: &Polynomial, coordinates: usize) -> Program {
    let mut builder = Builder::default();
    let mut sum = builder.constant(0.0);
    for (exponents, coefficient) in polynomial.terms() {
        let mut product = builder.whole(coefficient);
        for (variable, &exponent) in exponents.iter().enumerate() {
            let x = builder.coordinate(variable / coordinates, variable % coordinates);
            for _ in 0..exponent {
                product = builder.mul(product, x);
            }
        }
        sum = builder.add(sum, product);
    }
    builder.finish(sum)
}
