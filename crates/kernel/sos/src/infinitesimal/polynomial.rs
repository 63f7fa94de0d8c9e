//! The number types of a question's evaluation: integers, and polynomials in infinitesimals with integer coefficients.

use predicament_predicates::Sign;
use rug::Integer;
use smallvec::{SmallVec, smallvec};

/// The entries of determinants.
pub(super) trait Number: Clone + Default {
    fn constant(c: Integer) -> Self;

    fn is_zero(&self) -> bool;

    /// Adds a product, or subtracts it.
    fn add_product(&mut self, a: &Self, b: &Self, negative: bool);
}

impl Number for Integer {
    fn constant(c: Integer) -> Integer {
        c
    }

    fn is_zero(&self) -> bool {
        Integer::is_zero(self)
    }

    fn add_product(&mut self, a: &Integer, b: &Integer, negative: bool) {
        if negative { *self -= a * b } else { *self += a * b }
    }
}

/// Nonzero coefficients by monomial, ascending.
///
/// The key of a product is the sum of the keys. The code that makes keys defines their meaning, but the smallest key
/// must be that of the largest monomial.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Polynomial(SmallVec<[(u128, Integer); 1]>);

impl Polynomial {
    /// Adds 1 times a new monomial that is smaller than all existing ones.
    pub(super) fn push(&mut self, key: u128) {
        assert!(self.0.last().is_none_or(|(last, _)| *last < key), "monomials come in order");
        self.0.push((key, Integer::from(1)));
    }

    /// The sign of the largest monomial's coefficient.
    pub(super) fn sign(&self) -> Sign {
        self.0.first().map_or(Sign::Zero, |(_, c)| c.cmp0().into())
    }

    /// Adds terms in ascending order, each key once.
    fn merge(&mut self, terms: SmallVec<[(u128, Integer); 1]>) {
        if self.0.is_empty() {
            self.0 = terms;
            return;
        }
        let mut merged = SmallVec::with_capacity(self.0.len() + terms.len());
        let mut own = std::mem::take(&mut self.0).into_iter().peekable();
        for (key, c) in terms {
            while let Some(first) = own.next_if(|(own, _)| *own < key) {
                merged.push(first);
            }
            let sum = match own.next_if(|(own, _)| *own == key) {
                Some((_, own)) => own + c,
                None => c,
            };
            if !sum.is_zero() {
                merged.push((key, sum));
            }
        }
        merged.extend(own);
        self.0 = merged;
    }
}

impl Number for Polynomial {
    fn constant(c: Integer) -> Polynomial {
        Polynomial(if c.is_zero() { SmallVec::new() } else { smallvec![(0, c)] })
    }

    fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    fn add_product(&mut self, a: &Polynomial, b: &Polynomial, negative: bool) {
        let (few, many) = if a.0.len() <= b.0.len() { (&a.0, &b.0) } else { (&b.0, &a.0) };
        // Row by row each is sorted already.
        for (left, x) in few {
            let product = |(right, y): &(u128, Integer)| {
                let product = Integer::from(x * y);
                (left + right, if negative { -product } else { product })
            };
            self.merge(many.iter().map(product).collect());
        }
    }
}

/// The determinant of these columns.
///
/// For each set of rows it computes the minor in the first columns, from those of the sets with one row less.
pub(super) fn determinant<N: Number>(matrix: &[Vec<N>], columns: &[usize]) -> N {
    let mut minors = vec![N::default(); 1 << matrix.len()];
    minors[0] = N::constant(Integer::from(1));
    for set in 1_usize..1 << matrix.len() {
        let last = set.count_ones() as usize - 1;
        if last == 0 {
            minors[set] = matrix[set.trailing_zeros() as usize][columns[0]].clone();
            continue;
        }
        let mut minor = N::default();
        for (above, row) in (0..matrix.len()).filter(|row| set >> row & 1 == 1).enumerate() {
            let (entry, rest) = (&matrix[row][columns[last]], &minors[set ^ 1 << row]);
            if !entry.is_zero() && !rest.is_zero() {
                minor.add_product(entry, rest, (above + last) % 2 == 1);
            }
        }
        minors[set] = minor;
    }
    minors.pop().expect("the empty set is one")
}

/// The maximal minors of n rows of n + 1 entries, with alternating signs.
///
/// They form the vector that is orthogonal to all rows. The minor of the first rows in each set of columns is expanded
/// along its last row, so that the maximal minors share all smaller ones.
pub(super) fn orthogonal<N: Number>(rows: &[Vec<N>]) -> Vec<N> {
    let all = (1_usize << (rows.len() + 1)) - 1;
    let mut minors = vec![N::default(); all + 1];
    for set in 1..all {
        let last = set.count_ones() as usize - 1;
        let columns = (0..=rows.len()).filter(|column| set >> column & 1 == 1);
        if last == 0 {
            columns.for_each(|column| minors[set] = rows[0][column].clone());
            continue;
        }
        let mut minor = N::default();
        for (left, column) in columns.enumerate() {
            let (entry, rest) = (&rows[last][column], &minors[set ^ 1 << column]);
            if !entry.is_zero() && !rest.is_zero() {
                minor.add_product(entry, rest, (left + last) % 2 == 1);
            }
        }
        minors[set] = minor;
    }
    let signed = |without: usize| {
        let minor = std::mem::take(&mut minors[all ^ 1 << without]);
        if without.is_multiple_of(2) {
            return minor;
        }
        let mut negative = N::default();
        negative.add_product(&minor, &N::constant(Integer::from(1)), true);
        negative
    };
    (0..=rows.len()).map(signed).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use proptest::prelude::*;

    use super::*;

    /// A polynomial as a map from monomials to coefficients.
    type Plain = BTreeMap<u128, i64>;

    fn polynomial(plain: &Plain) -> Polynomial {
        let terms = plain.iter().filter(|(_, c)| **c != 0);
        Polynomial(terms.map(|(&key, &c)| (key, Integer::from(c))).collect())
    }

    fn plain() -> impl Strategy<Value = Plain> {
        prop::collection::btree_map(0_u128..6, -3..4_i64, 0..5)
    }

    proptest! {
        #[test]
        fn products_are_added_term_by_term(sum in plain(), a in plain(), b in plain(), negative: bool) {
            let mut expected = sum.clone();
            for (i, x) in &a {
                for (j, y) in &b {
                    *expected.entry(i + j).or_default() += if negative { -x * y } else { x * y };
                }
            }
            let mut found = polynomial(&sum);
            found.add_product(&polynomial(&a), &polynomial(&b), negative);
            prop_assert_eq!(found, polynomial(&expected));
        }

        #[test]
        fn orthogonal_vectors_are_the_minors_without_a_column(count in 1..4_usize, entries in prop::array::uniform12(-9..9_i32)) {
            let rows: Vec<Vec<Integer>> = (0..count)
                .map(|row| (0..=count).map(|column| Integer::from(entries[4 * row + column])).collect())
                .collect();
            let minor = |without: usize| {
                let columns: Vec<usize> = (0..=count).filter(|&column| column != without).collect();
                determinant(&rows, &columns) * if without.is_multiple_of(2) { 1 } else { -1 }
            };
            prop_assert_eq!(orthogonal(&rows), (0..=count).map(minor).collect::<Vec<_>>());
        }
    }

    #[test]
    fn determinants_of_some_columns() {
        let rows = [[2, 7, 1, 0], [3, 1, 4, 5], [0, 1, 6, 2]];
        let matrix: Vec<Vec<Integer>> = rows.iter().map(|row| row.map(Integer::from).to_vec()).collect();
        assert_eq!(determinant(&matrix[..2], &[0, 2]), 5);
        assert_eq!(determinant(&matrix[..2], &[2, 0]), -5);
        assert_eq!(determinant(&matrix, &[0, 1, 2]), -119);
        let normal = orthogonal(&matrix);
        for row in &rows {
            let product: Integer = row.iter().zip(&normal).map(|(x, n)| Integer::from(x * n)).sum();
            assert_eq!(product, 0);
        }
        assert_eq!(normal[3], 119);
    }
}
