//! How large a quantity can be.

use rug::Rational;

use crate::enclosure::root_up;

/// The magnitude c ε^e L^p, an upper bound of |x|.
///
/// The paper's is c L^p. The power of ε is ours and zero for everything but the
/// tolerances, which are multiples of √ε, ε^¼, ε^¾ and ε. Powers are counted in
/// quarters, which two square roots of an integer power need.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Magnitude {
    /// c.
    pub c: Rational,
    /// 4p, for L^p.
    pub length_quarters: i32,
    /// 4e, for ε^e.
    pub epsilon_quarters: i32,
}

impl Magnitude {
    /// c L^p.
    #[must_use]
    pub fn new(c: impl Into<Rational>, p: i32) -> Magnitude {
        Magnitude { c: c.into(), length_quarters: 4 * p, epsilon_quarters: 0 }
    }

    /// ε, of no length.
    #[must_use]
    pub fn epsilon() -> Magnitude {
        Magnitude { c: 1.into(), length_quarters: 0, epsilon_quarters: 4 }
    }

    /// p.
    #[must_use]
    pub fn p(&self) -> Rational {
        Rational::from((self.length_quarters, 4))
    }

    /// e.
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

    /// Rule H: the root, with that of c rounded up; none for an eighth of a power.
    pub(crate) fn root(&self) -> Option<Magnitude> {
        let even = self.length_quarters % 2 == 0 && self.epsilon_quarters % 2 == 0;
        even.then(|| Magnitude {
            c: root_up(&self.c),
            length_quarters: self.length_quarters / 2,
            epsilon_quarters: self.epsilon_quarters / 2,
        })
    }

    /// The two c of magnitudes with the same p, for a sum: the higher power of ε
    /// becomes the lower one.
    pub(crate) fn common(&self, other: &Magnitude) -> Option<[Rational; 2]> {
        (self.length_quarters == other.length_quarters).then(|| {
            let at = self.epsilon_quarters.min(other.epsilon_quarters);
            [self, other].map(|magnitude| magnitude.lowered_to(at))
        })
    }

    /// c for ε^e with a lower e: times the largest ε to the rest, rounded up.
    fn lowered_to(&self, epsilon_quarters: i32) -> Rational {
        let fourth = root_up(&root_up(&crate::rules::largest_epsilon()));
        (epsilon_quarters..self.epsilon_quarters).fold(self.c.clone(), |c, _| c * &fourth)
    }
}
