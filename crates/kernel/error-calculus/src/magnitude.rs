//! The largest possible size of a quantity.

use rug::Rational;

use crate::enclosure::root_up;

/// The magnitude c ε^e L^p, an upper bound of |x|.
///
/// The paper's magnitude is c L^p. The power of ε is ours. It is zero except for the tolerances, which are multiples of
/// √ε, ε^¼, ε^¾ and ε. Powers are counted in quarters, because two square roots of an integer power give quarters.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Magnitude {
    /// The coefficient c.
    pub c: Rational,
    /// 4p, for L^p.
    pub length_quarters: i32,
    /// 4e, for ε^e.
    pub epsilon_quarters: i32,
}

impl Magnitude {
    /// The magnitude c L^p.
    #[must_use]
    pub fn new(c: impl Into<Rational>, p: i32) -> Magnitude {
        Magnitude { c: c.into(), length_quarters: 4 * p, epsilon_quarters: 0 }
    }

    /// The magnitude ε, without a length.
    #[must_use]
    pub fn epsilon() -> Magnitude {
        Magnitude { c: 1.into(), length_quarters: 0, epsilon_quarters: 4 }
    }

    /// The power p of L.
    #[must_use]
    pub fn p(&self) -> Rational {
        Rational::from((self.length_quarters, 4))
    }

    /// The power e of ε.
    #[must_use]
    pub fn e(&self) -> Rational {
        Rational::from((self.epsilon_quarters, 4))
    }

    pub(crate) fn product(&self, other: &Magnitude) -> Magnitude {
        Magnitude {
            c: Rational::from(&self.c * &other.c),
            length_quarters: self.length_quarters + other.length_quarters,
            epsilon_quarters: self.epsilon_quarters + other.epsilon_quarters,
        }
    }

    /// Rule H: the square root, with the root of c rounded up; `None` if a power would be an eighth.
    pub(crate) fn root(&self) -> Option<Magnitude> {
        let even = self.length_quarters % 2 == 0 && self.epsilon_quarters % 2 == 0;
        even.then(|| Magnitude {
            c: root_up(&self.c),
            length_quarters: self.length_quarters / 2,
            epsilon_quarters: self.epsilon_quarters / 2,
        })
    }

    /// The coefficients c of two magnitudes with the same p, for a sum.
    ///
    /// The higher power of ε is converted to the lower one.
    pub(crate) fn common(&self, other: &Magnitude) -> Option<[Rational; 2]> {
        (self.length_quarters == other.length_quarters).then(|| {
            let at = self.epsilon_quarters.min(other.epsilon_quarters);
            [self, other].map(|magnitude| magnitude.lowered_to(at))
        })
    }

    /// The coefficient c for a lower power e: c times the largest ε to the difference, rounded up.
    fn lowered_to(&self, epsilon_quarters: i32) -> Rational {
        let fourth = root_up(&root_up(&crate::rules::largest_epsilon()));
        (epsilon_quarters..self.epsilon_quarters).fold(self.c.clone(), |c, _| c * &fourth)
    }
}
