//! The estimate of crossings, by which scenes are refused before they fill the memory.

use predicament_corpus::Random;
use predicament_crossings::task::content::{short, uniform};
use predicament_crossings::task::memory::{Bytes, estimate};
use predicament_predicates::{Scene, Vertex};

/// The estimated number of crossings beyond one for each segment.
fn further(points: &[[f64; 2]]) -> u64 {
    let segments: Vec<[Vertex; 2]> = (0..points.len() / 2).map(|at| [2 * at, 2 * at + 1].map(Vertex::input)).collect();
    estimate(&Scene::from_points2(points).unwrap(), &segments, Bytes { segment: 0, crossing: 1 })
}

#[test]
fn few_segments_are_counted_and_many_are_sampled() {
    let comb: Vec<[f64; 2]> = (0..20_u32)
        .map(f64::from)
        .flat_map(|at| [[at, -1.0], [at, 20.0], [-1.0, at + 0.5], [20.0, at + 0.5]])
        .collect();
    assert_eq!(further(&comb), 400 - 40);
    // Two segments between four random points of a square cross with probability 25/108.
    let found = further(&uniform(20_000, &mut Random::new("segments", "crossings", 1)));
    assert!((40_000_000..53_000_000).contains(&found), "{found}");
}

#[test]
fn sparse_crossings_of_many_segments_are_not_multiplied() {
    assert_eq!(further(&short(100_000, &mut Random::new("segments", "crossings", 1))), 0);
}
