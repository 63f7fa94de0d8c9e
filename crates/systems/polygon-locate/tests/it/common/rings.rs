//! Generators of highly degenerate rings and points.

use proptest::prelude::*;

/// Rings of any kind: self-crossing, overlapping, collinear, with repeated points.
pub fn rings(vertices: usize) -> impl Strategy<Value = Vec<Vec<Vec<usize>>>> {
    let ring = prop::collection::vec(0..vertices, 3..8).prop_filter_map("a loop edge", |mut ring| {
        ring.dedup();
        while ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        (ring.len() >= 3).then_some(ring)
    });
    prop::collection::vec(prop::collection::vec(ring, 1..3), 1..5)
}

pub fn grid_points() -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop::collection::vec(prop::array::uniform2((0..7_i32).prop_map(f64::from)), 24)
}

/// Neighbours of 0.1, 0.3 …: coordinates whose products are not exact.
pub fn ulp_points() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let coordinate =
        (0..4_i32, 0..3_u64).prop_map(|(at, ulps)| f64::from_bits((0.1 + 0.2 * f64::from(at)).to_bits() + ulps));
    prop::collection::vec(prop::array::uniform2(coordinate), 24)
}
