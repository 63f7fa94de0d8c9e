//! A constraint on the tolerances, decided at one ε at a time, for L = 1.
//!
//! Both sides are enclosed by rationals; a side is less than another where the
//! enclosures say so. What can't be decided that way says so too.

use predicament_error_calculus::Enclosure;
use rug::Rational;

use super::coefficient::{Coefficient, Tolerance};

/// Whose a constraint is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Origin {
    /// One of the paper's "tolerance constraints".
    Paper,
    /// A step that the paper's argument in 5.4.4 takes.
    Argument,
    /// What the paper's argument needs and doesn't state, or what our bands need.
    Ours,
}

impl Origin {
    /// In a table.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Origin::Paper => "paper",
            Origin::Argument => "argument",
            Origin::Ours => "ours",
        }
    }
}

/// A machine epsilon and its fourth root.
#[derive(Clone, Debug)]
pub struct At {
    /// ε.
    pub epsilon: Rational,
    /// ε^¼: exact for 2⁻⁵², enclosed elsewhere.
    pub fourth: Enclosure,
}

impl At {
    /// For one ε.
    #[must_use]
    pub fn new(epsilon: Rational) -> At {
        At { fourth: Enclosure::exact(epsilon.clone()).sqrt().sqrt(), epsilon }
    }

    /// k ε.
    #[must_use]
    pub fn times(&self, k: impl Into<Rational>) -> Enclosure {
        Enclosure::exact(k.into() * &self.epsilon)
    }

    /// c ε^e of a tolerance.
    #[must_use]
    pub fn of(&self, tolerance: &Tolerance, c: Coefficient) -> Enclosure {
        c.value() * self.fourth.power(tolerance.epsilon_quarters)
    }

    pub(super) fn lower(&self, tolerance: &Tolerance) -> Enclosure {
        self.of(tolerance, tolerance.lower)
    }

    pub(super) fn width(&self, tolerance: &Tolerance) -> Enclosure {
        self.of(tolerance, tolerance.width)
    }

    pub(super) fn upper(&self, tolerance: &Tolerance) -> Enclosure {
        self.of(tolerance, tolerance.upper)
    }

    /// min(T₊ − T, T − T₋).
    pub(super) fn room(&self, tolerance: &Tolerance) -> Enclosure {
        (self.upper(tolerance) - self.width(tolerance)).min(self.width(tolerance) - self.lower(tolerance))
    }
}

/// Both sides of an inequality, for L = 1.
pub type Sides = Box<dyn Fn(&At) -> [Enclosure; 2]>;

/// One constraint.
pub struct Constraint {
    /// The section of the paper that states the constraint.
    pub section: &'static str,
    /// In the paper's words.
    pub text: String,
    /// Whose it is.
    pub origin: Origin,
    pub(super) test: Test,
}

pub(super) enum Test {
    /// The first side exceeds the second.
    Greater(Sides),
    /// Equal, as numbers before the same power of ε; decided once.
    Same(bool),
}

/// The verdict about a constraint at one ε.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Decision {
    /// It holds.
    Holds,
    /// It doesn't.
    Fails,
    /// The enclosures overlap.
    Undecided,
}

impl Decision {
    /// In a table.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Decision::Holds => "holds",
            Decision::Fails => "fails",
            Decision::Undecided => "undecided",
        }
    }
}

impl Constraint {
    /// An inequality.
    pub fn greater(
        section: &'static str,
        origin: Origin,
        text: impl Into<String>,
        sides: impl Fn(&At) -> [Enclosure; 2] + 'static,
    ) -> Constraint {
        Constraint { section, text: text.into(), origin, test: Test::Greater(Box::new(sides)) }
    }

    pub(super) fn same(section: &'static str, text: impl Into<String>, holds: bool) -> Constraint {
        Constraint { section, text: text.into(), origin: Origin::Paper, test: Test::Same(holds) }
    }

    /// Decides it.
    #[must_use]
    pub fn decide(&self, at: &At) -> Decision {
        let sides = match &self.test {
            Test::Same(true) => return Decision::Holds,
            Test::Same(false) => return Decision::Fails,
            Test::Greater(sides) => sides,
        };
        let [left, right] = sides(at);
        if left.lower > right.upper {
            Decision::Holds
        } else if left.upper <= right.lower {
            Decision::Fails
        } else {
            Decision::Undecided
        }
    }

    /// Left minus right, in units of the power of L; none for an equation.
    #[must_use]
    pub fn slack(&self, at: &At) -> Option<Enclosure> {
        match &self.test {
            Test::Same(_) => None,
            Test::Greater(sides) => {
                let [left, right] = sides(at);
                Some(left - right)
            }
        }
    }
}
