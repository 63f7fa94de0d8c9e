//! The filter of constructed vertices whose bound is linear in the slacks (`exact::constructed::tight`).
//!
//! Let d be the computed differences and D the true ones, with |d − D| ≤ u·m. Let v be |d|, V the sum of the
//! determinant's terms in the v, and A = (V(v + u·m) − V(v))/u. Then
//!
//! * det(d) is within u·A of det(D), as every term is;
//! * the formula for the error is A, which `Linear::is_the_error` compares as polynomials;
//! * x + y, with fl(x + y) the value, is within e·V of det(d), and the computed V and A have relative errors: Gappa
//!   bounds these along the formula's operations;
//! * a product that underflows loses η times factors of its term, each at most an m: `Linear::underflow` finds a term
//!   of V(v + u·m) for each.
//!
//! Beyond the bound ρ·(k·V + A)·u, with ρ the room for roundings, x + y exceeds e·V + u·A. Gappa proves this for V and
//! for A apart.

use predicament_arithmetic::bound::UNIT_ROUNDOFF;
use predicament_exact::constructed::filter::Approximate;
use predicament_exact::constructed::tight::{self, Bounded, ROOM, TURN, VOLUME};

use crate::chain::{Chain, ETA, is_input, magnitude, permanent};
use crate::filters::{Proved, dyadic, least};
use crate::gappa::{Gappa, Number};
use crate::overflow::dominated;
use crate::polynomial::Polynomial;
use crate::rules::{Claim, Rules};
use crate::trace::{Node, Traced};
use crate::underflow::{over_three, over_three_slacks, with_slacks};

/// The name of the kind in tables.
const KIND: &str = "constructed, linear";
/// The symbol of u in formulas.
const UNIT: &str = "u";
/// A power of two: u³.
const CUBE: i32 = -159;

/// A filter whose bound is linear in the slacks.
pub struct Linear {
    /// The name of the predicate.
    pub name: &'static str,
    /// The constant k of the bound.
    roundings: f64,
    formula: Bounded<Traced>,
}

/// The filters for turns and volumes.
#[must_use]
pub fn filters() -> [Linear; 2] {
    let near = |x: Traced| Approximate::near(x, Traced::input(format!("slack of {}", x.text(1))));
    let unit = Traced::input(UNIT);
    let flat = ["a", "b", "c"].map(|name| Traced::point::<2>(name).map(near));
    let solid = ["a", "b", "c", "d"].map(|name| Traced::point::<3>(name).map(near));
    [
        Linear { name: "orient2d", roundings: TURN, formula: tight::turn(flat, unit) },
        Linear { name: "orient3d", roundings: VOLUME, formula: tight::volume(solid, unit) },
    ]
}

/// The facts about a formula that do not depend on its constants.
struct Needed {
    /// |x + y − det(d)| over V.
    error: Number,
    /// The relative errors of the computed V and A.
    relative: [Number; 2],
    /// The sum of the coefficients of all losses by underflow.
    terms: i64,
}

impl Linear {
    /// Proves everything about the formula that does not depend on constants.
    fn needed(&self, gappa: &Gappa) -> Result<Needed, String> {
        let Bounded { value, size, .. } = self.formula;
        self.bound_is_a_sum()?;
        self.is_the_error()?;
        dominated(value, size)?;
        let rules = Rules { gappa, precision: 53 };
        let mut chain = Chain::new(&rules, Claim::given());
        let error = chain.before_last_sum(value)?.error;
        let relative = [chain.claim(size)?.error, chain.claim(self.formula.error)?.error];
        Ok(Needed { error, relative, terms: self.underflow()? })
    }

    /// Checks that the bound is a product of a sum: k times the size, and the error.
    fn bound_is_a_sum(&self) -> Result<(), String> {
        let Bounded { size, error, .. } = self.formula;
        let [room, roundings] = ["room", "k"].map(Traced::input);
        let expected = room * (roundings * size + error);
        if self.formula.bound(room, roundings) == expected {
            return Ok(());
        }
        Err(format!("{}: the bound is not room * (k * size + error)", self.name))
    }

    /// Checks that the formula for the error is (V(v + u·m) − V(v))/u.
    fn is_the_error(&self) -> Result<(), String> {
        let unit = Polynomial::symbol(UNIT);
        let moved = |d: Traced| magnitude(d).plus(&with_slacks(d).times(&unit), 1);
        let of = |z: Traced, atom: &dyn Fn(Traced) -> Polynomial| {
            let [_, whole] = permanent(z, atom).split(ETA);
            whole
        };
        let whole = of(self.formula.value, &magnitude);
        let needed = of(self.formula.value, &moved).plus(&whole, -1);
        if of(self.formula.size, &magnitude) != whole {
            return Err(format!("{}: the size is not the permanent of the value", self.name));
        }
        if of(self.formula.error, &magnitude).times(&unit) != needed {
            return Err(format!("{}: the error is not that of the differences", self.name));
        }
        Ok(())
    }

    /// Checks that each loss is η times a part of a term, with every factor at most an m; returns the sum of their
    /// coefficients.
    fn underflow(&self) -> Result<i64, String> {
        let [lost, whole] = of_m(self.formula.value).split(ETA);
        let mut terms = 0;
        let [of_size, of_error] = [self.formula.size, self.formula.error].map(|z| of_m(z).split(ETA));
        for lost in [&lost, &of_size[0], &of_error[0]] {
            for monomial in lost.0.keys() {
                let factors: Vec<&String> =
                    monomial.iter().filter(|name| ![ETA, UNIT].contains(&name.as_str())).collect();
                let is_part = |term: &Vec<String>| {
                    let mut of = term.iter();
                    term.len() <= 3 && factors.iter().all(|name| of.any(|known| known == *name))
                };
                if !whole.0.keys().any(is_part) {
                    return Err(format!("{}: no term of the bound has the factors of {monomial:?}", self.name));
                }
            }
            terms += lost.weight();
        }
        Ok(terms)
    }

    /// Proves the room for roundings in the code, and finds the least; refuses a k that is one less.
    ///
    /// # Errors
    /// The goals whose result is wrong: those that are not proved, and those that are proved and must not be.
    pub fn prove(&self, gappa: &Gappa) -> Result<Proved, String> {
        let needed = self.needed(gappa).map_err(|error| format!("{}: {error}", self.name))?;
        // A loss by underflow over u·A, as a power of two: A has u² times three factors, or u times two.
        let lost = over_three_slacks() - CUBE;
        let script = |room| self.script(&needed, [room, self.roundings], lost);
        if !gappa.proves(&script(ROOM)) {
            return Err(format!("the room for roundings is not proved\n{}", script(ROOM)));
        }
        if gappa.proves(&self.script(&needed, [ROOM, self.roundings - 1.0], lost)) {
            return Err(format!("{}: a bound with a rounding less is proved", self.name));
        }
        // (Slacks of 2^-300 suffice for the filter with one permanent.)
        if gappa.proves(&self.script(&needed, [ROOM, self.roundings], over_three(-299) - CUBE)) {
            return Err(format!("{}: a bound is proved that pays for no underflow", self.name));
        }
        let least = least(ROOM, |room| gappa.proves(&script(room)));
        let below = script(least.next_down());
        Ok(Proved { name: self.name, kind: KIND, constant: ROOM * UNIT_ROUNDOFF, least: least * UNIT_ROUNDOFF, below })
    }

    /// The script that proves the room for roundings with this k; underflow loses at most 2 to the power `lost` a term.
    fn script(&self, needed: &Needed, constants: [f64; 2], lost: i32) -> String {
        let Needed { error, relative: [size, slack], terms } = needed;
        let [room, k] = constants.map(dyadic);
        let (u, lost) = ("1b-53", format!("{terms}b{lost}"));
        // Three roundings of k·V, and two of A. A loss of each part is one of u·A.
        format!(
            "# {}, constructed, linear in the slacks: a sign is certain beyond the bound\nR = {room};\n{{ R * {k} * {u} * (1 - \
             {size}) * (1 - {u}) * (1 - {u}) * (1 - {u}) - (1 + {u}) * {error} >= 1b-400\n  /\\ R * (1 - {slack} - 2 * {lost}) * \
             (1 - {u}) * (1 - {u}) - (1 + {u}) * (1 + 2 * {lost}) >= 1b-400 }}\n",
            self.name
        )
    }
}

/// The permanent of a formula, with one symbol for a difference and for its m, which is not smaller.
fn of_m(z: Traced) -> Polynomial {
    let difference = |z: Traced| matches!(z.node(), Node::Sub(x, y) if is_input(x) && is_input(y));
    match z.node() {
        Node::Add(x, _) if matches!(x.node(), Node::Abs(d) if difference(d)) => of_m(x),
        Node::Abs(x) => of_m(x),
        Node::Sub(..) if difference(z) => magnitude(z),
        Node::Add(x, y) | Node::Sub(x, y) => of_m(x).plus(&of_m(y), 1),
        Node::Mul(x, y) => of_m(x).times(&of_m(y)).plus(&Polynomial::symbol(ETA), 1),
        _ => permanent(z, &magnitude),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// These parts of the proofs need no prover.
    #[test]
    fn errors_are_those_of_the_differences_and_other_formulas_are_refused() {
        for mut filter in filters() {
            filter.bound_is_a_sum().and_then(|()| filter.is_the_error()).unwrap_or_else(|why| panic!("{why}"));
            assert!(filter.underflow().is_ok_and(|terms| terms > 2), "{}", filter.name);
            let Bounded { value, size, error } = filter.formula;
            assert!(dominated(value, size).is_ok());
            filter.formula.error = error + size;
            assert!(filter.is_the_error().is_err_and(|why| why.ends_with("the error is not that of the differences")));
            assert!(dominated(value, Traced::input(UNIT)).is_err());
            filter.formula.size = error;
            assert!(
                filter.is_the_error().is_err_and(|why| why.ends_with("the size is not the permanent of the value"))
            );
            filter.formula.error = error * error * error;
            assert!(filter.underflow().is_err_and(|why| why.contains("no term of the bound")));
        }
    }
}
