//! The choice of probes on a map: at its vertices, on its edges, and next to them.
//!
//! Random points almost never meet a degeneracy. Points on vertices, on edges and one double above and below a vertex
//! always do: there a ray or a comparison must decide between neighbours.

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::{Level, Parts, Random, numbered};
use predicament_mesh::PolygonMap;
use predicament_predicates::{Dimension, Scene, Vertex};

use super::content::{MapWithProbes, Probe, ProbeKind, Probing};

/// The scene of a map: the probes of even index (the first has index 0), the map's vertices, the probes of odd index.
pub(super) fn with_probes(
    points: Vec<[f64; 2]>,
    map: PolygonMap,
    given: &[[f64; 2]],
    probing: Probing,
    level: Level,
) -> Parts {
    let mut places: Vec<([f64; 2], ProbeKind)> = Vec::new();
    if !given.is_empty() {
        let known = known(&points, &map);
        let kind = |place: [f64; 2]| known.get(&bits(place)).copied().unwrap_or(ProbeKind::Random);
        places.extend(given.iter().map(|&place| (place, kind(place))));
    }
    let stride = probing.stride(level);
    if stride > 0 {
        places.extend(points.iter().step_by(stride).copied().flat_map(of_vertex));
        let edges = edges(&map).into_iter().step_by(stride);
        places.extend(edges.filter_map(|ends| of_edge(ends.map(|v| points[v.index()]))));
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

/// The probes on a vertex, and next to it.
fn of_vertex([x, y]: [f64; 2]) -> [([f64; 2], ProbeKind); 3] {
    [([x, y], ProbeKind::Vertex), ([x, y.next_down()], ProbeKind::Below), ([x, y.next_up()], ProbeKind::Above)]
}

/// The midpoint of an edge, if it is a pair of doubles.
fn of_edge([a, b]: [[f64; 2]; 2]) -> Option<([f64; 2], ProbeKind)> {
    Some(([exact_midpoint(a[0], b[0])?, exact_midpoint(a[1], b[1])?], ProbeKind::Midpoint))
}

/// The kinds of positions on a map; if a position has two kinds, the first in [`ProbeKind`] counts.
fn known(points: &[[f64; 2]], map: &PolygonMap) -> BTreeMap<[u64; 2], ProbeKind> {
    let of_edges = edges(map).into_iter().filter_map(|ends| of_edge(ends.map(|v| points[v.index()])));
    let mut known = BTreeMap::new();
    for (place, kind) in points.iter().copied().flat_map(of_vertex).chain(of_edges) {
        known.entry(bits(place)).and_modify(|other| *other = kind.min(*other)).or_insert(kind);
    }
    known
}

/// The key of a position for comparison: zero has two signs.
fn bits(place: [f64; 2]) -> [u64; 2] {
    place.map(|x| (x + 0.0).to_bits())
}

/// Each edge once, whichever side it is seen from.
fn edges(map: &PolygonMap) -> BTreeSet<[Vertex; 2]> {
    map.edges().map(|(_, [a, b])| [a.min(b), a.max(b)]).collect()
}

/// The mean of two doubles, if it is a double.
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
