//! Queries at random vertices among many points, as they come from an index, a hash or a queue.
//!
//! In the other families the points of a query are adjacent in memory, and those of the next query follow. Here each
//! vertex has a random address, so the time of a query is that of fetching its points, once these exceed the cache.

use crate::Random;
use predicament_predicates::{PredicateKind, Vertex};

use super::Cloud;

/// The number of points for each query: 10^6 for 200,000.
pub const POINTS: usize = 5;

/// A scene of `n` queries of distinct vertices, with points uniform in [0, 1).
///
/// # Panics
/// If `n` is so large that the points cannot be numbered.
#[must_use]
pub fn scattered(kind: PredicateKind, n: usize, rng: &mut Random) -> Cloud {
    let points = POINTS * n;
    let coordinates = (0..points * super::native(kind)).map(|_| rng.unit()).collect();
    let last = i64::try_from(points).expect("so many points fit into memory") - 1;
    let mut args: Vec<Vertex> = Vec::with_capacity(n * kind.arity());
    for _ in 0..n {
        let start = args.len();
        while args.len() < start + kind.arity() {
            let index = usize::try_from(rng.integer(0, last)).expect("from 0 on");
            if !args[start..].contains(&Vertex::input(index)) {
                args.push(Vertex::input(index));
            }
        }
    }
    Cloud { coordinates, args: Some(args), constructions: Vec::new() }
}
