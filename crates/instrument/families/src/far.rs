//! Small clusters of points far from the origin.

use predicament_predicates::PredicateKind;

use super::native;
use crate::Random;
use crate::bits::scale;

/// Points of a unit box that lies 2^20 to 2^45 away on every axis: the
/// coordinates share their leading bits, and squares of coordinates (lifts
/// that were not translated first) drown the differences.
pub fn far(kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
    let exponent = rng.integer(20, 44);
    let corner: Vec<f64> = (0..native(kind)).map(|_| scale(rng.mantissa(), exponent)).collect();
    for _ in 0..kind.arity() {
        out.extend(corner.iter().map(|&x| x + rng.unit()));
    }
}
