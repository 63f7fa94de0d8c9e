//! Sums of many rationals.

use rug::Rational;

/// The sum of the terms, added in pairs so that partial sums have few terms each.
pub fn sum(mut terms: Vec<Rational>) -> Rational {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_has_all_its_terms() {
        for count in 0..12_u32 {
            // Powers of two over three: different subsets have different sums.
            let terms = (0..count).map(|i| Rational::from((1_u32 << i, 3_u32))).collect();
            assert_eq!(sum(terms), Rational::from(((1_u32 << count) - 1, 3_u32)));
        }
    }
}
