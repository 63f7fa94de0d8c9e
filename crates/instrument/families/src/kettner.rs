//! The neighbourhoods in which Kettner et al. saw naive arithmetic fail, and their equivalents for the other
//! predicates.

use predicament_predicates::PredicateKind;

use crate::Random;
use crate::bits::{integer, power_of_two};

/// A point from the 256 × 256 doubles next to (0.5, 0.5), against points on a line, plane, circle or sphere through
/// (0.5, 0.5) with coordinates up to 130: the differences cancel, the rest is rounding.
///
/// # Panics
/// For a predicate from a formula.
pub fn kettner(kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
    let mut near_half = || 0.5 + integer(rng.integer(0, 255)) * power_of_two(-53);
    let p = [near_half(), near_half(), near_half()];
    let other = [near_half(), near_half()];
    let m = integer(rng.integer(1, 64));
    // The corners of this box lie on one circle or sphere.
    let (low, high) = (0.5, 2.0 * m + 1.5);
    match kind {
        PredicateKind::Compare => {
            out.extend([p[0], p[1]]);
            out.extend(other);
        }
        PredicateKind::Orient2d => {
            out.extend([p[0], p[1], m, m, 2.0 * m, 2.0 * m]);
        }
        PredicateKind::Orient3d => {
            // All on x + y = 2z.
            out.extend([m, m, m]);
            out.extend([2.0 * m, m, 1.5 * m]);
            out.extend([m, 2.0 * m, 1.5 * m]);
            out.extend(p);
        }
        PredicateKind::Incircle => {
            out.extend([high, low, high, high, low, high]);
            out.extend([p[0], p[1]]);
        }
        PredicateKind::Derived(_) => unreachable!("the family is not for formulas"),
        PredicateKind::Insphere => {
            out.extend([high, low, low, low, high, low, low, low, high, high, high, high]);
            out.extend(p);
        }
    }
}
