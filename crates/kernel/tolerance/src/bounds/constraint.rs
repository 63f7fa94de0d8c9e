//! A constraint on the tolerances, decided at one ε at a time, for L = 1.
//!
//! Rationals enclose both sides; one side is less than the other if the enclosures prove it. A constraint that the
//! enclosures cannot decide is reported as undecided.

use predicament_error_calculus::Enclosure;
use rug::Rational;

use super::coefficient::{Coefficient, Tolerance};

/// The source of a constraint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Origin {
    /// One of the paper's "tolerance constraints".
    Paper,
    /// A step that the paper's argument in 5.4.4 takes.
    Argument,
    /// A condition that the paper's argument needs without stating it, or that our bands need.
    Ours,
}

impl Origin {
    /// The origin's text in tables.
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
    /// The machine epsilon ε.
    pub epsilon: Rational,
    /// ε^¼: exact for 2⁻⁵², enclosed elsewhere.
    pub fourth: Enclosure,
}

impl At {
    /// The values for one ε.
    #[must_use]
    pub fn new(epsilon: Rational) -> At {
        At { fourth: Enclosure::exact(epsilon.clone()).sqrt().sqrt(), epsilon }
    }

    /// The product k ε.
    #[must_use]
    pub fn times(&self, k: impl Into<Rational>) -> Enclosure {
        Enclosure::exact(k.into() * &self.epsilon)
    }

    /// The product c ε^e of a tolerance.
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

    /// The gap min(T₊ − T, T − T₋).
    pub(super) fn room(&self, tolerance: &Tolerance) -> Enclosure {
        (self.upper(tolerance) - self.width(tolerance)).min(self.width(tolerance) - self.lower(tolerance))
    }
}

/// Both sides of an inequality, for L = 1.
pub type Sides = Box<dyn Fn(&At) -> [Enclosure; 2]>;

/// One constraint on the tolerances.
pub struct Constraint {
    /// The section of the paper that states the constraint.
    pub section: &'static str,
    /// The constraint in the paper's words.
    pub text: String,
    /// The source of the constraint.
    pub origin: Origin,
    pub(super) test: Test,
}

pub(super) enum Test {
    /// The constraint that the first side exceeds the second.
    Greater(Sides),
    /// The constraint that both sides are equal as coefficients of the same power of ε; decided once.
    Same(bool),
}

/// The verdict about a constraint at one ε.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Decision {
    /// The constraint holds.
    Holds,
    /// The constraint fails.
    Fails,
    /// The enclosures overlap.
    Undecided,
}

impl Decision {
    /// The decision's text in tables.
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
    /// A constraint that is an inequality.
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

    /// Decides the constraint.
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

    /// Left minus right, in units of the power of L; `None` for an equation.
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
