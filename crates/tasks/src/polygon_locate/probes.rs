//! Where to look on a map: at its vertices, on its edges, next to them.
//!
//! Random points almost never meet a degeneracy. Points on vertices, on edges
//! and one double above and below a vertex always do: there a ray or a
//! comparison has to decide between neighbours.

use std::collections::BTreeSet;

use predicament_corpus::{Level, Parts, Random, numbered};
use predicament_mesh::PolygonMap;
use predicament_predicates::{Dimension, Scene, Vertex};

use super::content::{MapWithProbes, Probe, ProbeKind, Probing};

/// The scene of a map: the probes in even places (the first is in place 0),
/// the map's vertices, the probes in odd places.
pub(super) fn with_probes(points: Vec<[f64; 2]>, map: PolygonMap, probing: Probing, level: Level) -> Parts {
    let stride = probing.stride(level);
    let mut places: Vec<([f64; 2], ProbeKind)> = Vec::new();
    for &[x, y] in points.iter().step_by(stride) {
        places.push(([x, y], ProbeKind::Vertex));
        places.push(([x, y.next_down()], ProbeKind::Below));
        places.push(([x, y.next_up()], ProbeKind::Above));
    }
    for [a, b] in edges(&map).into_iter().step_by(stride) {
        let [a, b] = [points[a.index()], points[b.index()]];
        if let (Some(x), Some(y)) = (exact_midpoint(a[0], b[0]), exact_midpoint(a[1], b[1])) {
            places.push(([x, y], ProbeKind::Midpoint));
        }
    }
    let mut rng = Random::new("probes", "polygon-locate", probing.seed());
    if let Some([low, high]) = bounds(&points) {
        for _ in 0..probing.random(level) {
            let mut uniform = |i: usize| rng.between(low[i], high[i]).clamp(low[i], high[i]);
            places.push(([uniform(0), uniform(1)], ProbeKind::Random));
        }
    }
    // Next to the largest double there is no finite neighbour to probe.
    places.retain(|(place, _)| place.iter().all(|x| x.is_finite()));
    let (all, numbers) = numbered(points, &places.iter().map(|&(place, _)| place).collect::<Vec<_>>());
    let probes = numbers.iter().zip(&places).map(|(&vertex, &(_, kind))| Probe { vertex, kind }).collect();
    let scene = Scene::new(Dimension::Two, all.into_flattened()).expect("finite pairs");
    let leading = places.len().div_ceil(2);
    Parts::new(scene, MapWithProbes::new(map.shifted(leading), probes))
}

/// Each edge once, whichever side it is seen from.
fn edges(map: &PolygonMap) -> BTreeSet<[Vertex; 2]> {
    map.edges().map(|(_, [a, b])| [a.min(b), a.max(b)]).collect()
}

/// The mean of two doubles where it is a double.
fn exact_midpoint(a: f64, b: f64) -> Option<f64> {
    // The error term of Knuth's sum; halving is exact above the subnormals.
    let sum = a + b;
    let b_seen = sum - a;
    let error = (a - (sum - b_seen)) + (b - b_seen);
    let halved = sum * 0.5;
    (sum.is_finite() && error == 0.0 && halved * 2.0 == sum).then_some(halved)
}

fn bounds(points: &[[f64; 2]]) -> Option<[[f64; 2]; 2]> {
    let first = *points.first()?;
    let spread = |[low, high]: [[f64; 2]; 2], p: &[f64; 2]| {
        [std::array::from_fn(|i| low[i].min(p[i])), std::array::from_fn(|i| high[i].max(p[i]))]
    };
    let [low, high] = points.iter().fold([first; 2], spread);
    (0..2).all(|i| (high[i] - low[i]).is_finite()).then_some([low, high])
}
