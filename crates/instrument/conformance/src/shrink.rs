//! The smallest query that still shows a finding.

use crate::Number;
use crate::query::Query;

/// The maximum number of queries that are tried.
const TRIES: usize = 400;

/// The cost of a query: bits of coordinates, and the distance of their exponents from zero.
fn cost<T: Number>(query: &Query<T>) -> i64 {
    let of = |x: &T| x.bits().map_or(0, |[high, low]| 8 + 8 * (high - low) + high.abs().min(low.abs()));
    query.coordinates.iter().map(of).sum()
}

/// A query of the least cost found for which `shows` is true, starting from one for which it is.
///
/// Each step moves or scales all points exactly, or makes one coordinate simpler.
pub(crate) fn shrink<T: Number>(
    query: &Query<T>,
    dimension: usize,
    mut shows: impl FnMut(&Query<T>) -> bool,
) -> Query<T> {
    let (mut best, mut tries) = (query.clone(), 0);
    loop {
        let before = cost(&best);
        let mut candidates = whole(&best, dimension);
        candidates.extend((0..best.coordinates.len()).flat_map(|at| simpler(&best, at)));
        candidates.retain(|candidate| cost(candidate) < before);
        candidates.sort_by_key(cost);
        let found = candidates.into_iter().find(|candidate| {
            tries += 1;
            tries <= TRIES && shows(candidate)
        });
        match found {
            Some(found) => best = found,
            None => return best,
        }
    }
}

/// The exact images of the query with a point at the origin, or with another power of two.
fn whole<T: Number>(query: &Query<T>, dimension: usize) -> Vec<Query<T>> {
    let mut all = Vec::new();
    for point in query.coordinates.chunks_exact(dimension) {
        all.extend(query.mapped(|(at, x)| x.minus(point[at % dimension])));
    }
    if let Some([high, low]) = query.exponents() {
        let powers = [-high, -low, -i64::midpoint(high, low)].map(|k| i32::try_from(k).unwrap_or(0));
        all.extend(powers.iter().filter_map(|&k| query.times_power(k)));
    }
    all
}

/// The query with one coordinate simpler: zero, a coordinate of another point, or one with fewer bits.
fn simpler<T: Number>(query: &Query<T>, at: usize) -> Vec<Query<T>> {
    let x = query.coordinates[at];
    let Some([high, low]) = x.bits() else { return Vec::new() };
    let bits = u32::try_from(high - low + 1).unwrap_or(53);
    let shorter = [1, bits / 2, bits.saturating_sub(8), bits - 1].into_iter().filter(|&fewer| fewer > 0);
    let values = [T::ZERO].into_iter().chain(shorter.map(|fewer| x.rounded(fewer)));
    values
        .filter(|&value| value != x)
        .filter_map(|value| query.mapped(|(place, &own)| Some(if place == at { value } else { own })))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;

    #[test]
    fn nothing_that_can_be_left_out_is_left() {
        let coordinates = vec![0.1, 3.0, 1e10 / 3.0, 5.0, 7.0 / 3.0, 1e-7];
        let query = Query { way: 0, shapes: vec![Shape::Input; 3], coordinates };
        let differs = |query: &Query<f64>| query.coordinates[2] > query.coordinates[0];
        let small = shrink(&query, 2, differs);
        assert!(differs(&small));
        assert_eq!(small.coordinates.iter().filter(|x| **x != 0.0).count(), 1, "{small:?}");
        assert_eq!(small.coordinates.iter().map(|x| x.abs()).sum::<f64>(), 1.0, "{small:?}");
    }
}
