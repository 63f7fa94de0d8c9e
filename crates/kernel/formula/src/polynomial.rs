//! Formulas as polynomials with whole coefficients, expanded: the one form in which equal formulas are equal.

use std::collections::BTreeMap;

use crate::program::{Op, Program, whole};

/// The most monomials of a polynomial.
const MOST_MONOMIALS: usize = 50_000;

/// The exponents of a monomial, one for each variable.
pub type Exponents = Vec<u8>;

/// A polynomial: monomials with coefficients that are not zero.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Polynomial {
    terms: BTreeMap<Exponents, i128>,
}

impl Polynomial {
    /// The polynomial of a program about `points` points of `dimension` coordinates.
    ///
    /// Coordinate k of point i is variable i·`dimension` + k.
    ///
    /// # Errors
    /// The reason, if the polynomial has too many monomials, or a coefficient that 128 bits cannot hold.
    pub fn of(program: &Program, points: usize, dimension: usize) -> Result<Polynomial, String> {
        let variables = points * dimension;
        let coordinate = |point: usize, axis: usize| {
            let mut exponents = vec![0; variables];
            exponents[point * dimension + axis] = 1;
            Polynomial { terms: BTreeMap::from([(exponents, 1)]) }
        };
        let constant = |number: f64| Polynomial::constant(whole(number), variables);
        let arithmetic = |op, [a, b]: [&Polynomial; 2]| match op {
            Op::Add(..) => a.plus(b, 1),
            Op::Sub(..) => a.plus(b, -1),
            Op::Mul(..) => a.times(b),
            _ => Polynomial::default().plus(a, -1),
        };
        let found = program.evaluate(coordinate, constant, arithmetic);
        found.ok_or_else(|| {
            format!("the expanded polynomial has more than {MOST_MONOMIALS} monomials, or too large coefficients")
        })
    }

    fn constant(number: i128, variables: usize) -> Polynomial {
        let mut terms = BTreeMap::new();
        if number != 0 {
            terms.insert(vec![0; variables], number);
        }
        Polynomial { terms }
    }

    fn plus(&self, other: &Polynomial, factor: i128) -> Option<Polynomial> {
        let mut sum = self.clone();
        for (exponents, coefficient) in &other.terms {
            sum.gain(exponents.clone(), coefficient.checked_mul(factor)?)?;
        }
        Some(sum)
    }

    fn times(&self, other: &Polynomial) -> Option<Polynomial> {
        let mut product = Polynomial::default();
        for (left, a) in &self.terms {
            for (right, b) in &other.terms {
                let exponents =
                    left.iter().zip(right).map(|(x, y)| x.checked_add(*y)).collect::<Option<Exponents>>()?;
                product.gain(exponents, a.checked_mul(*b)?)?;
            }
        }
        (product.terms.len() <= MOST_MONOMIALS).then_some(product)
    }

    fn gain(&mut self, exponents: Exponents, coefficient: i128) -> Option<()> {
        use std::collections::btree_map::Entry;
        match self.terms.entry(exponents) {
            Entry::Vacant(vacant) if coefficient != 0 => {
                vacant.insert(coefficient);
            }
            Entry::Vacant(_) => {}
            Entry::Occupied(mut occupied) => {
                let sum = occupied.get().checked_add(coefficient)?;
                if sum == 0 {
                    occupied.remove();
                } else {
                    *occupied.get_mut() = sum;
                }
            }
        }
        Some(())
    }

    /// The monomials and their coefficients.
    pub fn terms(&self) -> impl Iterator<Item = (&[u8], i128)> {
        self.terms.iter().map(|(exponents, &coefficient)| (exponents.as_slice(), coefficient))
    }

    /// The number of monomials.
    #[must_use]
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Returns true if the polynomial is zero.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// The largest total degree of a monomial.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.degrees().max().unwrap_or(0)
    }

    /// Returns true if all monomials have one total degree.
    #[must_use]
    pub fn is_homogeneous(&self) -> bool {
        let degree = self.degree();
        self.degrees().all(|other| other == degree)
    }

    fn degrees(&self) -> impl Iterator<Item = u32> {
        self.terms.keys().map(|exponents| exponents.iter().map(|&exponent| u32::from(exponent)).sum())
    }

    /// The largest exponent of a variable.
    #[must_use]
    pub fn degree_in(&self, variable: usize) -> u8 {
        self.terms.keys().map(|exponents| exponents[variable]).max().unwrap_or(0)
    }

    /// The polynomial with other exponents for each monomial; monomials that become equal are added.
    ///
    /// `None` if `map` returns `None`, or if a coefficient needs more than 128 bits.
    #[must_use]
    pub fn mapped(&self, map: impl Fn(&[u8]) -> Option<Exponents>) -> Option<Polynomial> {
        let mut mapped = Polynomial::default();
        for (exponents, &coefficient) in &self.terms {
            mapped.gain(map(exponents)?, coefficient)?;
        }
        Some(mapped)
    }

    /// The sum; `None` if a coefficient needs more than 128 bits.
    #[must_use]
    pub fn sum(&self, other: &Polynomial) -> Option<Polynomial> {
        self.plus(other, 1)
    }

    /// The negative.
    #[must_use]
    pub fn negated(&self) -> Polynomial {
        Polynomial { terms: self.terms.iter().map(|(exponents, &c)| (exponents.clone(), -c)).collect() }
    }

    /// The coefficient of the monomial Πεᵢ^`powers[i]` in the polynomial of xᵢ + εᵢ: a Taylor coefficient.
    ///
    /// `None` if a coefficient needs more than 128 bits.
    #[must_use]
    pub fn taylor(&self, powers: &[u8]) -> Option<Polynomial> {
        let is_multiple = |exponents: &[u8]| exponents.iter().zip(powers).all(|(have, need)| have >= need);
        Polynomial::taylor_of(self.terms().filter(|(exponents, _)| is_multiple(exponents)), powers)
    }

    /// The Taylor coefficient of some monomials, all of them multiples of these powers.
    pub(crate) fn taylor_of<'t>(
        monomials: impl Iterator<Item = (&'t [u8], i128)>,
        powers: &[u8],
    ) -> Option<Polynomial> {
        let mut found = Polynomial::default();
        for (exponents, mut coefficient) in monomials {
            let mut left = Exponents::with_capacity(exponents.len());
            for (&have, &need) in exponents.iter().zip(powers) {
                coefficient = coefficient.checked_mul(binomial(have, need))?;
                left.push(have - need);
            }
            found.gain(left, coefficient)?;
        }
        Some(found)
    }
}

fn binomial(n: u8, k: u8) -> i128 {
    (0..i128::from(k)).fold(1, |product, i| product * (i128::from(n) - i) / (i + 1))
}

impl std::fmt::Display for Polynomial {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} monomials of degree {}", self.len(), self.degree())
    }
}
