//! Ordinary points: uniform, and on a grid of integers.

use predicament_predicates::PredicateKind;

use super::native;
use crate::Random;
use crate::bits::integer;

/// Points uniform in the unit square or cube.
pub fn uniform(kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
    out.extend((0..kind.arity() * native(kind)).map(|_| rng.unit()));
}

/// Points with small integer coordinates.
pub fn grid(kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
    out.extend((0..kind.arity() * native(kind)).map(|_| integer(rng.integer(0, 15))));
}
