//! Where to look on a map: at its vertices, on its edges, next to them.
//!
//! Random points almost never meet a degeneracy. Points on vertices, on edges
//! and one double above and below a vertex always do: there a ray or a
//! comparison has to decide between neighbours.
//!
//! Under Simulation of Simplicity a vertex moves further the smaller its
//! number is. Were all probes numbered after the map, every one would move
//! less than what it touches, and ties would always be broken in the same
//! simple way; so they are numbered before and after the map in turn.

use std::collections::BTreeSet;

use predicament_mesh::PolygonMap;
use predicament_predicates::{Dimension, Scene, Vertex};

use crate::generate::Random;
use crate::suite::Probing;
use crate::{Level, Probe, ProbeKind, Work};

/// The scene of a map: the probes in even places (the first is in place 0),
/// the map's vertices, the probes in odd places.
pub(crate) fn with_probes(points: Vec<[f64; 2]>, map: PolygonMap, probing: Probing, level: Level) -> (Scene, Work) {
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
    let mut rng = Random::new("probes", "polygon-locate", probing.seed);
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
    (scene, Work::Locate { map: map.shifted(leading), probes })
}

/// Points with places to probe: the even places first, then the points, then
/// the odd places; and the vertex of each place. The points move up by half
/// the number of places, rounded up.
pub(crate) fn numbered<P: Copy>(points: Vec<P>, places: &[P]) -> (Vec<P>, Vec<Vertex>) {
    let behind = places.len().div_ceil(2) + points.len();
    let number = |at: usize| at / 2 + if at.is_multiple_of(2) { 0 } else { behind };
    let vertices = (0..places.len()).map(|at| Vertex::input(number(at))).collect();
    let every_other = |from: usize| places.iter().skip(from).step_by(2).copied();
    (every_other(0).chain(points).chain(every_other(1)).collect(), vertices)
}

/// Each edge once, whichever side it is seen from.
fn edges(map: &PolygonMap) -> BTreeSet<[Vertex; 2]> {
    map.edges().map(|(_, [a, b])| [a.min(b), a.max(b)]).collect()
}

/// The mean of two doubles where it is a double.
pub(crate) fn exact_midpoint(a: f64, b: f64) -> Option<f64> {
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
