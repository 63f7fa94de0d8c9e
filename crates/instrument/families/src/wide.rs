//! Queries over the whole range of exponents, where products overflow and underflow.

use predicament_predicates::PredicateKind;

use super::{degenerate, native, near, plain};
use crate::Random;
use crate::bits::{HIGHEST, LOWEST, scale, top_exponent};

/// An ordinary query, scaled as a whole so that its largest coordinate has any exponent of a double. Signs do not
/// change if no bit is lost. Near the bottom of the range bits are lost, and the rounded points are the query.
///
/// # Panics
/// For a predicate from a formula.
pub fn scaled(kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
    scaled_by(rng, out, |ordinary, rng, out| match ordinary {
        Ordinary::Uniform => plain::uniform(kind, rng, out),
        Ordinary::Near { ulps } => near::near(kind, ulps, rng, out),
        Ordinary::Degenerate => degenerate::scaled(kind, rng, out),
    });
}

/// A kind of query before it is scaled.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ordinary {
    /// Uniform in the unit square or cube.
    Uniform,
    /// At most `ulps` ulps off a zero.
    Near {
        /// The number of ulps.
        ulps: i64,
    },
    /// On a zero.
    Degenerate,
}

/// A query from `query`, scaled as in [`scaled`].
pub fn scaled_by(rng: &mut Random, out: &mut Vec<f64>, query: impl FnOnce(Ordinary, &mut Random, &mut Vec<f64>)) {
    let start = out.len();
    let ordinary = match rng.integer(0, 2) {
        0 => Ordinary::Uniform,
        1 => Ordinary::Near { ulps: 4 },
        _ => Ordinary::Degenerate,
    };
    query(ordinary, rng, out);
    let Some(top) = out[start..].iter().filter_map(|&x| top_exponent(x)).max() else {
        return; // all zero: there is nothing to scale
    };
    let shift = rng.integer(LOWEST, HIGHEST) - top;
    for x in &mut out[start..] {
        *x = scale(*x, shift);
    }
}

/// A query whose coordinates all have random exponents. One in four repeats the value that the point before it has on
/// the same axis, so that differences vanish.
pub fn mixed(kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
    let (start, dimension) = (out.len(), native(kind));
    for _ in 0..kind.arity() * dimension {
        let before = out.len().checked_sub(dimension).filter(|&before| before >= start);
        let x = match before {
            Some(before) if rng.one_in(4) => out[before],
            _ => scale(rng.mantissa(), rng.integer(LOWEST, HIGHEST)),
        };
        out.push(x);
    }
}
