//! Polynomials in a few infinitesimals, truncated at the degrees of a monomial.
//!
//! A [`Cut`] is a degree for each of some infinitesimals. Monomials with a higher degree in any of them are dropped, as
//! sums and products never lead back from there. All remaining coefficients are stored in one array, whose last entry
//! is that of the monomial in question. Most numbers are constants, and the deciding monomials have a low degree.

use smallvec::{SmallVec, smallvec};

use crate::integer::Integer;

/// The coefficients of a series.
pub(super) trait Coefficient: Clone {
    fn one() -> Self;
    fn zero() -> Self;
    /// A whole number.
    fn whole(n: i64) -> Self;
    fn is_zero(&self) -> bool;
    fn add(&mut self, other: &Self);
    fn subtract(&mut self, other: &Self);
    /// Adds a product.
    fn add_product(&mut self, a: &Self, b: &Self);
}

impl Coefficient for super::residue::Residue {
    #[inline]
    fn one() -> Self {
        Self::ONE
    }

    #[inline]
    fn zero() -> Self {
        Self::ZERO
    }

    fn whole(n: i64) -> Self {
        Self::scaled(n, 0)
    }

    #[inline]
    fn is_zero(&self) -> bool {
        Self::is_zero(*self)
    }

    #[inline]
    fn add(&mut self, other: &Self) {
        *self = self.plus(*other);
    }

    #[inline]
    fn subtract(&mut self, other: &Self) {
        *self = self.minus(*other);
    }

    #[inline]
    fn add_product(&mut self, a: &Self, b: &Self) {
        *self = self.plus(a.times(*b));
    }
}

impl Coefficient for Integer {
    fn one() -> Self {
        Integer::ONE
    }

    fn zero() -> Self {
        Integer::ZERO
    }

    fn whole(n: i64) -> Self {
        Integer::from(n)
    }

    fn is_zero(&self) -> bool {
        Integer::is_zero(self)
    }

    fn add(&mut self, other: &Self) {
        *self += other;
    }

    fn subtract(&mut self, other: &Self) {
        *self -= other;
    }

    fn add_product(&mut self, a: &Self, b: &Self) {
        Integer::add_product(self, a, b);
    }
}

/// A truncated polynomial: its coefficients, by the monomial's index.
pub(super) type Series<C> = SmallVec<[C; 2]>;

/// The degrees up to which series are stored, one for each infinitesimal.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Cut {
    degrees: SmallVec<[usize; 8]>,
}

impl Cut {
    pub(super) fn new(degrees: impl IntoIterator<Item = usize>) -> Cut {
        Cut { degrees: degrees.into_iter().collect() }
    }

    /// The number of stored monomials.
    pub(super) fn len(&self) -> usize {
        self.degrees.iter().map(|degree| degree + 1).product()
    }

    /// Returns true if only constants are stored.
    pub(super) fn is_constant(&self) -> bool {
        self.len() == 1
    }

    /// The index of an infinitesimal's power, if it is stored.
    pub(super) fn place(&self, infinitesimal: usize, power: usize) -> Option<usize> {
        let stride: usize = self.degrees[..infinitesimal].iter().map(|degree| degree + 1).product();
        (power <= self.degrees[infinitesimal]).then_some(power * stride)
    }

    fn times<C: Coefficient>(&self, a: &Series<C>, b: &Series<C>) -> Series<C> {
        let mut product: Series<C> = smallvec![C::zero(); self.len()];
        if self.degrees.len() == 1 {
            for (i, x) in a.iter().enumerate() {
                product[i..].iter_mut().zip(b).for_each(|(sum, y)| sum.add_product(x, y));
            }
            return product;
        }
        for (i, x) in a.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
            for (j, y) in b.iter().enumerate().filter(|(_, y)| !y.is_zero()) {
                if self.fits(i, j) {
                    product[i + j].add_product(x, y);
                }
            }
        }
        product
    }

    /// Returns true if the product of two stored monomials is stored.
    #[inline]
    pub(super) fn fits(&self, mut i: usize, mut j: usize) -> bool {
        self.degrees.iter().all(|degree| {
            let base = degree + 1;
            let within = i % base + j % base <= *degree;
            (i, j) = (i / base, j / base);
            within
        })
    }
}

/// A truncated polynomial, in the form that its cut allows.
pub(super) trait Number: Clone {
    type Coefficient: Coefficient;

    fn constant(cut: &Cut, c: Self::Coefficient) -> Self;
    /// A constant plus an infinitesimal, by the index of that monomial.
    fn moved(cut: &Cut, c: Self::Coefficient, monomial: usize) -> Self;
    fn times(&self, other: &Self, cut: &Cut) -> Self;
    fn sum(self, other: &Self) -> Self;
    fn difference(self, other: &Self) -> Self;
    /// The coefficient of the cut's own monomial.
    fn last(self) -> Self::Coefficient;
}

impl<C: Coefficient> Number for Series<C> {
    type Coefficient = C;

    fn constant(cut: &Cut, c: C) -> Self {
        let mut series: Series<C> = smallvec![c];
        series.resize(cut.len(), C::zero());
        series
    }

    fn moved(cut: &Cut, c: C, monomial: usize) -> Self {
        let mut series = Self::constant(cut, c);
        series[monomial] = C::one();
        series
    }

    fn times(&self, other: &Self, cut: &Cut) -> Self {
        cut.times(self, other)
    }

    fn sum(mut self, other: &Self) -> Self {
        self.iter_mut().zip(other).for_each(|(x, y)| x.add(y));
        self
    }

    fn difference(mut self, other: &Self) -> Self {
        self.iter_mut().zip(other).for_each(|(x, y)| x.subtract(y));
        self
    }

    fn last(mut self) -> C {
        self.pop().expect("a series has a coefficient for its cut")
    }
}

/// A polynomial that is truncated at degree zero or one of one infinitesimal: most are.
#[derive(Clone, Copy)]
pub(super) struct Short<C, const N: usize>([C; N]);

impl<C: Coefficient, const N: usize> Number for Short<C, N> {
    type Coefficient = C;

    #[inline]
    fn constant(_: &Cut, c: C) -> Self {
        let mut coefficients = std::array::from_fn(|_| C::zero());
        coefficients[0] = c;
        Short(coefficients)
    }

    #[inline]
    fn moved(cut: &Cut, c: C, monomial: usize) -> Self {
        let mut number = Self::constant(cut, c);
        number.0[monomial] = C::one();
        number
    }

    #[inline]
    fn times(&self, other: &Self, cut: &Cut) -> Self {
        const { assert!(N == 1 || N == 2, "larger powers need a loop") };
        let mut product = Self::constant(cut, C::zero());
        product.0[0].add_product(&self.0[0], &other.0[0]);
        if N == 2 {
            product.0[1].add_product(&self.0[0], &other.0[1]);
            product.0[1].add_product(&self.0[1], &other.0[0]);
        }
        product
    }

    #[inline]
    fn sum(mut self, other: &Self) -> Self {
        self.0.iter_mut().zip(&other.0).for_each(|(x, y)| x.add(y));
        self
    }

    #[inline]
    fn difference(mut self, other: &Self) -> Self {
        self.0.iter_mut().zip(&other.0).for_each(|(x, y)| x.subtract(y));
        self
    }

    #[inline]
    fn last(self) -> C {
        let [.., last] = self.0.as_slice() else { unreachable!("a constant at least") };
        last.clone()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use proptest::prelude::*;

    use super::*;

    /// A polynomial by degrees in two infinitesimals, not truncated.
    type Plain = BTreeMap<[usize; 2], Integer>;

    fn times(a: &Plain, b: &Plain) -> Plain {
        let mut product = Plain::new();
        for (i, x) in a {
            for (j, y) in b {
                *product.entry([i[0] + j[0], i[1] + j[1]]).or_insert(Integer::ZERO) += &(x * y);
            }
        }
        product
    }

    fn cut(cut: &Cut, plain: &Plain) -> Series<Integer> {
        let mut series = Series::constant(cut, Integer::ZERO);
        for (&[i, j], x) in plain {
            if let (Some(first), Some(second)) = (cut.place(0, i), cut.place(1, j)) {
                series[first + second] += x;
            }
        }
        series
    }

    fn plain() -> impl Strategy<Value = Plain> {
        prop::collection::btree_map([0_usize..4, 0_usize..4], (-9..9_i64).prop_map(Integer::from), 0..6)
    }

    proptest! {
        #[test]
        fn what_is_kept_is_as_if_nothing_had_been_dropped(a in plain(), b in plain(), m in 0_usize..3, n in 0_usize..3) {
            let kept = Cut::new([m, n]);
            let [x, y] = [&a, &b].map(|plain| cut(&kept, plain));
            prop_assert_eq!(kept.times(&x, &y), cut(&kept, &times(&a, &b)));
            prop_assert_eq!(x.clone().sum(&y).difference(&y), x);
        }
    }

    #[test]
    fn the_last_place_is_that_of_the_monomial() {
        let cut = Cut::new([2, 0, 3]);
        assert_eq!(Series::constant(&cut, Integer::from(7)).len(), 12);
        assert_eq!((cut.place(0, 2), cut.place(1, 0), cut.place(2, 3)), (Some(2), Some(0), Some(9)));
        assert_eq!((cut.place(0, 3), cut.place(1, 1)), (None, None));
        assert_eq!(Series::constant(&Cut::default(), Integer::from(7)).to_vec(), [Integer::from(7)]);
    }
}
