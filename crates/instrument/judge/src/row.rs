//! Points over one denominator, the form that constructed points and integer determinants use.

use rug::{Integer, Rational};

/// A point over one denominator: its coordinates are integers divided by the weight.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) coordinates: Vec<Integer>,
    /// The common denominator, positive.
    pub(crate) weight: Integer,
}

impl Row {
    /// The coordinates as fractions.
    pub(crate) fn point(&self) -> Vec<Rational> {
        self.coordinates.iter().map(|x| Rational::from((x, &self.weight))).collect()
    }

    /// The point over the least denominator.
    pub(crate) fn reduced(mut self) -> Row {
        let common = self.coordinates.iter().fold(self.weight.clone(), |common, x| common.gcd(x));
        self.coordinates.iter_mut().for_each(|x| x.div_exact_mut(&common));
        self.weight.div_exact_mut(&common);
        self
    }
}
