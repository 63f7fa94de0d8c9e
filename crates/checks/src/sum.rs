//! Sums of many rationals.

use rug::Rational;

/// The sum, in pairs: partial sums are of few terms each.
pub(crate) fn sum(mut terms: Vec<Rational>) -> Rational {
    while terms.len() > 1 {
        terms = terms
            .chunks(2)
            .map(|pair| match pair {
                [a, b] => Rational::from(a + b),
                rest => rest[0].clone(),
            })
            .collect();
    }
    terms.pop().unwrap_or_default()
}
