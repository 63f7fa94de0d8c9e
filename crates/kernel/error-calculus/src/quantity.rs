//! Quantities: bounds of a number and of its error, instead of its value.

use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::Arc;

use rug::{Integer, Rational};

use crate::magnitude::Magnitude;
use crate::rules::{self, Error, largest_epsilon};
use crate::{Field, Ring, Root};

/// A quantity in the sense of section 2, which generic code runs on to derive its floating-point error bound.
///
/// Each operation applies the most restricted of the rules A to K that fits (C before B, E before D). The result is
/// invalid if an operand is invalid or no rule fits. Everything is exact except the root of a c, which is rounded up.
///
/// # Which ε
/// The machine epsilon, 2⁻⁵² for doubles: every operation is charged with it, which is twice the largest error of
/// rounding to nearest.
///
/// # Powers of two
/// A product with a power of two has no rounding error, as nothing underflows. Constants know whether they are powers
/// of two. ε is 2^−k, a power of two for every binary format.
///
/// # Rule G
/// Its c is 1, which is not a bound of |x₁/x₂| in general. It is a bound in the paper's use, the coordinates of a unit
/// vector. It is not a bound of 1/m, but it is again a bound of û · (1/m), if û has c ≥ 1 as every edge has. For other
/// uses only the quotient's own error is safe, as that error is relative to the quotient.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Quantity {
    expression: Arc<str>,
    state: Option<State>,
}

/// Everything except s; present if v is true.
#[derive(Clone, PartialEq, Eq, Debug)]
struct State {
    magnitude: Magnitude,
    nonnegative: bool,
    error: Error,
    relative: bool,
    /// True for 2^k with integer k, and ε times that: a factor that causes no rounding error.
    power_of_two: bool,
    /// The error of a sum or difference by rule B or D, without its own rounding error.
    inherited: Option<Error>,
}

/// A bound of an error: aε + bε², without the factor L or the magnitude.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Bound {
    /// The coefficient a of ε.
    pub first: Rational,
    /// The coefficient b of ε².
    pub second: Rational,
}

impl Bound {
    /// The bound as the paper states it, an integer times ε.
    ///
    /// It is at least first·ε + second·ε² for every ε < 10⁻⁵.
    #[must_use]
    pub fn rounded_up(&self) -> Integer {
        ((&self.second * largest_epsilon()) + &self.first).ceil().numer().clone()
    }

    /// The value first·ε + second·ε².
    #[must_use]
    pub fn at(&self, epsilon: &Rational) -> Rational {
        (Rational::from(&self.second * epsilon) + &self.first) * epsilon
    }
}

impl Quantity {
    /// Rule K: an exact coordinate, at most L/2 after the scene is shifted.
    #[must_use]
    pub fn coordinate(name: &str) -> Quantity {
        Quantity::exact(name, Magnitude::new((1, 2), 1), false)
    }

    /// Rule J: a constant, which must be a floating-point number.
    #[must_use]
    pub fn constant(value: impl Into<Rational>) -> Quantity {
        let value = value.into();
        let name = value.to_string();
        let nonnegative = value >= 0;
        let power = rules::is_power_of_two(&value);
        Quantity::exact(&name, Magnitude::new(value.abs(), 0), nonnegative).power_of_two(power)
    }

    /// The number ε: a constant by rule J, and a power of two.
    #[must_use]
    pub fn epsilon() -> Quantity {
        Quantity::exact("ε", Magnitude::epsilon(), true).power_of_two(true)
    }

    /// The number L, from which the tolerances are computed: c = 1, p = 1.
    ///
    /// It has no error, as the bounds are in terms of this very number.
    #[must_use]
    pub fn length() -> Quantity {
        Quantity::given("L")
    }

    /// A given length, nonnegative and at most L, without an error: c = 1, p = 1.
    #[must_use]
    pub fn given(name: &str) -> Quantity {
        Quantity::exact(name, Magnitude::new(1, 1), true)
    }

    fn exact(name: &str, magnitude: Magnitude, nonnegative: bool) -> Quantity {
        Quantity {
            expression: name.into(),
            state: Some(State {
                magnitude,
                nonnegative,
                error: Error::none(),
                relative: true,
                power_of_two: false,
                inherited: None,
            }),
        }
    }

    fn power_of_two(mut self, is: bool) -> Quantity {
        if let Some(state) = &mut self.state {
            state.power_of_two = is;
        }
        self
    }

    /// The expression s, with a pair of brackets for every operation.
    #[must_use]
    pub fn expression(&self) -> &str {
        &self.expression
    }

    /// The flag v: true if there is a bound.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        self.state.is_some()
    }

    /// The magnitude: c and p (and our e).
    #[must_use]
    pub fn magnitude(&self) -> Option<&Magnitude> {
        self.state.as_ref().map(|state| &state.magnitude)
    }

    /// The flag n: true if the quantity is never negative.
    #[must_use]
    pub fn is_nonnegative(&self) -> bool {
        self.state.as_ref().is_some_and(|state| state.nonnegative)
    }

    /// The error coefficients a and b.
    #[must_use]
    pub fn error(&self) -> Option<&Error> {
        self.state.as_ref().map(|state| &state.error)
    }

    /// The flag r: true if the error is relative to the quantity, not to c L^p.
    #[must_use]
    pub fn is_relative(&self) -> bool {
        self.state.as_ref().is_some_and(|state| state.relative)
    }

    /// The absolute error E\[x\] over ε^e L^p; `None` if the quantity is invalid.
    #[must_use]
    pub fn absolute(&self) -> Option<Bound> {
        self.state.as_ref().map(|State { magnitude: Magnitude { c, .. }, error, .. }| Bound {
            first: Rational::from(c * &error.a),
            second: Rational::from(c * &error.b),
        })
    }

    /// The relative error R\[x\]; `None` if the error is not relative to the quantity.
    #[must_use]
    pub fn relative(&self) -> Option<Bound> {
        self.state
            .as_ref()
            .filter(|state| state.relative)
            .map(|State { error, .. }| Bound { first: error.a.clone(), second: error.b.clone() })
    }

    /// The same quantity with a relative error, because |x| is known to be at least `smallest` times ε^e L^p.
    ///
    /// This is not one of the paper's rules, but its reasoning in 4.1 and 5.4.4.
    ///
    /// For a sum or difference the factor applies only to the operands' errors: its own rounding error is already
    /// relative to it ([`rules::bounded_below`]).
    ///
    /// # Panics
    /// If `smallest` isn't positive.
    #[must_use]
    pub fn at_least(mut self, smallest: &Rational) -> Quantity {
        assert!(*smallest > 0, "a lower bound of {} has to be positive", self.expression);
        if let Some(state) = &mut self.state
            && !state.relative
        {
            let factor = Rational::from(&state.magnitude.c / smallest);
            match &state.inherited {
                Some(inherited) => state.error = rules::bounded_below(inherited, &factor),
                None => {
                    state.error.a *= &factor;
                    state.error.b *= &factor;
                }
            }
            state.relative = true;
        }
        self
    }

    /// The same quantity, known to be nonnegative.
    #[must_use]
    pub fn nonnegative(mut self) -> Quantity {
        if let Some(state) = &mut self.state {
            state.nonnegative = true;
        }
        self
    }

    fn binary(self, sign: char, other: Quantity, rule: impl Fn(&State, &State, bool) -> Option<State>) -> Quantity {
        let same = self.expression == other.expression;
        let state = self.state.as_ref().zip(other.state.as_ref()).and_then(|(x, y)| rule(x, y, same));
        Quantity { expression: format!("({} {sign} {})", self.expression, other.expression).into(), state }
    }
}

/// Rules B and D, for a sum and a difference alike.
fn rule_b(x: &State, y: &State, nonnegative: bool) -> Option<State> {
    let [c1, c2] = x.magnitude.common(&y.magnitude)?;
    let error = rules::sum(&c1, &x.error, &c2, &y.error);
    let inherited = Some(rules::inherited(&c1, &x.error, &c2, &y.error));
    let magnitude = total(x, y, &c1, &c2);
    Some(State { magnitude, nonnegative, error, relative: false, power_of_two: false, inherited })
}

fn total(x: &State, y: &State, c1: &Rational, c2: &Rational) -> Magnitude {
    let epsilon_quarters = x.magnitude.epsilon_quarters.min(y.magnitude.epsilon_quarters);
    Magnitude { c: Rational::from(c1 + c2), length_quarters: x.magnitude.length_quarters, epsilon_quarters }
}

impl Add for Quantity {
    type Output = Quantity;

    /// Rule C if it fits, else B.
    fn add(self, other: Quantity) -> Quantity {
        self.binary('+', other, |x, y, _| {
            let nonnegative = x.nonnegative && y.nonnegative;
            if !(nonnegative && x.relative && y.relative) {
                return rule_b(x, y, nonnegative);
            }
            let [c1, c2] = x.magnitude.common(&y.magnitude)?;
            let error = rules::sum_of_same_sign(&x.error, &y.error);
            let magnitude = total(x, y, &c1, &c2);
            Some(State { magnitude, nonnegative, error, relative: true, power_of_two: false, inherited: None })
        })
    }
}

impl Sub for Quantity {
    type Output = Quantity;

    /// Rule E if it fits, else D.
    fn sub(self, other: Quantity) -> Quantity {
        self.binary('-', other, |x, y, _| {
            let state = rule_b(x, y, false)?;
            let exact = x.error.is_none() && y.error.is_none();
            let relative = State { error: rules::exact_difference(), relative: true, inherited: None, ..state.clone() };
            Some(if exact { relative } else { state })
        })
    }
}

impl Mul for Quantity {
    type Output = Quantity;

    /// Rule F, without a rounding error if a factor is a power of two.
    fn mul(self, other: Quantity) -> Quantity {
        self.binary('*', other, |x, y, same| {
            Some(State {
                magnitude: x.magnitude.product(&y.magnitude),
                nonnegative: same || (x.nonnegative && y.nonnegative),
                error: match (x.power_of_two, y.power_of_two) {
                    (true, _) => y.error.clone(),
                    (_, true) => x.error.clone(),
                    _ => rules::product(&x.error, &y.error),
                },
                relative: x.relative && y.relative,
                power_of_two: x.power_of_two && y.power_of_two,
                inherited: None,
            })
        })
    }
}

impl Div for Quantity {
    type Output = Quantity;

    /// Rule G, with its c = 1.
    fn div(self, other: Quantity) -> Quantity {
        self.binary('/', other, |x, y, _| {
            if !(x.relative && y.relative) {
                return None;
            }
            Some(State {
                magnitude: Magnitude {
                    c: 1.into(),
                    length_quarters: x.magnitude.length_quarters - y.magnitude.length_quarters,
                    epsilon_quarters: x.magnitude.epsilon_quarters - y.magnitude.epsilon_quarters,
                },
                nonnegative: x.nonnegative && y.nonnegative,
                error: rules::quotient(&x.error, &y.error)?,
                relative: true,
                power_of_two: false,
                inherited: None,
            })
        })
    }
}

impl Neg for Quantity {
    type Output = Quantity;

    /// Rule A.
    fn neg(self) -> Quantity {
        let state = self.state.map(|state| State { nonnegative: false, ..state });
        Quantity { expression: format!("-{}", self.expression).into(), state }
    }
}

impl Ring for Quantity {
    /// Rule I.
    fn abs(self) -> Quantity {
        let state = self.state.map(|state| State { nonnegative: true, ..state });
        Quantity { expression: format!("|{}|", self.expression).into(), state }
    }
}

impl Field for Quantity {
    fn one() -> Quantity {
        Quantity::constant(1)
    }
}

impl Root for Quantity {
    /// Rule H.
    fn sqrt(self) -> Quantity {
        let state = self.state.filter(|state| state.nonnegative && state.relative).and_then(|state| {
            let magnitude = state.magnitude.root()?;
            let error = rules::root(&state.error)?;
            Some(State { magnitude, nonnegative: true, error, relative: true, power_of_two: false, inherited: None })
        });
        Quantity { expression: format!("√{}", self.expression).into(), state }
    }
}
