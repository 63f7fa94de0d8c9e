//! Results that snap rounding brings back to doubles after each step.
//!
//! Edges and crossings of both operands are rounded to pixels; then the rounded operands are combined, whose chains
//! meet only in pixels. Iterated snap rounding leaves no vertex nearer to a foreign edge than half a pixel. So a result
//! stays unchanged where nothing new comes near, and only the edges within reach of the next operand's box are snapped
//! again.

use std::collections::{BTreeSet, HashMap};
use std::time::Instant;

use predicament_overlay::algorithm::overlay::{Edge, Method as Search, Polygon, Region, Rule, arrange, combine};
use predicament_overlay::algorithm::snap::{Drawing, Method as Snapping, SnapError, Snapped, snap};
use predicament_predicates::{Construction, Plane, Scene, SceneError, Vertex};
use predicament_tasks::Contestant;

use super::cascade::{Loop, Operand};
use super::current::{Pair, Points};
use super::rounded::{Made, each, in_session, place};
use super::step::{End, Then};
use super::whole::origins;

/// The extent: low x and y, high x and y.
type Extent = [f64; 4];

const NOTHING: Extent = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];

fn joined(all: Extent, [x, y]: [f64; 2]) -> Extent {
    [all[0].min(x), all[1].min(y), all[2].max(x), all[3].max(y)]
}

fn meets(a: &Extent, b: &Extent) -> bool {
    a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3]
}

fn inflated(extent: Extent, by: f64) -> Extent {
    [extent[0] - by, extent[1] - by, extent[2] + by, extent[3] + by]
}

/// Does the steps, with 2^`bits` pixels per largest coordinate.
pub(super) fn run(
    backend: &dyn Contestant,
    bits: u32,
    start: &Loop,
    steps: &[Operand],
    then: &mut Then<'_>,
) -> Result<(), End> {
    // All coordinates are below 4.
    let exponent = 2 - i32::try_from(bits).unwrap_or(50);
    let pixel = 2.0_f64.powi(exponent);
    // The initial operand is not on pixels yet.
    let mut is_first = true;
    each(start, steps, then, |pair, step, _| {
        let clock = Instant::now();
        let near = Near::of(pair, pixel, std::mem::take(&mut is_first));
        let mut constructed = 0;
        let chains = in_session(backend, &pair.scene, &mut |session| {
            let edges: Vec<Edge> = near.segments.iter().map(|&[a, b]| Edge::whole(a, b)).collect();
            arrange(session, &edges, Search::Grid)?;
            constructed = session.scene().constructions().len();
            Ok(near.snapped(session.scene(), exponent)?)
        })?;
        let next = near.operands(pair, &chains, exponent)?;
        in_session(backend, &next.scene, &mut |session| {
            let result = combine(session, &next.first, &next.second, step.operation, Search::Grid)?;
            let session = &*session;
            let loops = |region: &Region| {
                region.loops().map(|one| origins(one).iter().map(|v| place(session, *v)).collect()).collect()
            };
            Ok(Made {
                regions: result.regions.iter().map(loops).collect(),
                elapsed: clock.elapsed(),
                // Chains meet in vertices: a vertex constructed now should not exist.
                constructed: constructed + session.scene().constructions().len(),
                broken: result.broken,
                turned: None,
            })
        })
    })
}

/// The snapped segments, and the points whose pixels are hot.
struct Near {
    /// The segments, with the lower end first; ascending, each once.
    segments: Vec<[Vertex; 2]>,
    places: HashMap<[Vertex; 2], usize>,
    points: Vec<Vertex>,
}

fn sorted([a, b]: [Vertex; 2]) -> [Vertex; 2] {
    if a < b { [a, b] } else { [b, a] }
}

impl Near {
    fn of(pair: &Pair, pixel: f64, all: bool) -> Near {
        let at = |v: Vertex| pair.scene.point2(Plane::Xy, v);
        let second = || pair.second.loops.iter().flatten();
        let reached = inflated(second().fold(NOTHING, |all, edge| joined(all, at(edge.from))), 2.0 * pixel);
        let extent = |edge: &Edge| joined(joined(NOTHING, at(edge.from)), at(edge.to));
        let first = || pair.first.iter().flat_map(Region::loops).flatten();
        let is_near = |edge: &&Edge| all || meets(&extent(edge), &reached);
        let chosen = first().filter(is_near).chain(second());
        let segments: BTreeSet<[Vertex; 2]> = chosen.map(|edge| sorted([edge.from, edge.to])).collect();
        let segments: Vec<[Vertex; 2]> = segments.into_iter().collect();
        // A point that a snapped segment may approach is hot, whether or not a segment ends there.
        let around = segments.as_flattened().iter().fold(NOTHING, |all, &v| joined(all, at(v)));
        let around = inflated(around, 2.0 * pixel);
        let is_around = |v: &Vertex| {
            let [x, y] = at(*v);
            meets(&[x, y, x, y], &around)
        };
        let points: BTreeSet<Vertex> = first().chain(second()).map(|edge| edge.from).filter(is_around).collect();
        let places = segments.iter().copied().zip(0..).collect();
        Near { segments, places, points: points.into_iter().collect() }
    }

    /// The pixels and chains of the segments.
    fn snapped(&self, scene: &Scene, exponent: i32) -> Result<Snapped, SnapError> {
        let number = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
        let point: HashMap<Vertex, u32> = self.points.iter().copied().zip(0..).collect();
        let crossings: Vec<[u32; 2]> = scene
            .constructions()
            .iter()
            .filter_map(|construction| match construction {
                Construction::Ssi(pair) => {
                    let [s, t] = pair.map(|ends| self.places.get(&sorted(ends)));
                    Some([number(*s?), number(*t?)])
                }
                _ => None,
            })
            .collect();
        let points: Vec<[f64; 2]> = self.points.iter().map(|&v| scene.point2(Plane::Xy, v)).collect();
        let segments: Vec<[u32; 2]> = self.segments.iter().map(|ends| ends.map(|v| point[&v])).collect();
        let drawing = Drawing { points: &points, segments: &segments, crossings: &crossings, touching: &[] };
        snap(drawing, exponent, Snapping::Iterated)
    }

    /// The operands after snap rounding.
    fn operands(&self, pair: &Pair, chains: &Snapped, exponent: i32) -> Result<Pair, SceneError> {
        let mut points = Points::default();
        let centres: Vec<Vertex> =
            (0..).zip(&chains.pixels).map(|(pixel, _)| points.vertex(chains.centre(pixel, exponent))).collect();
        let mut chain = |one: &Vec<Edge>| -> Vec<Edge> {
            let mut edges = Vec::with_capacity(one.len());
            for edge in one {
                let ends = [edge.from, edge.to];
                let Some(&at) = self.places.get(&sorted(ends)) else {
                    let [from, to] = ends.map(|v| points.vertex(pair.scene.point2(Plane::Xy, v)));
                    edges.push(Edge::whole(from, to));
                    continue;
                };
                let stops = chains.chains[at].windows(2).map(|pair| [pair[0], pair[1]].map(|at| centres[at as usize]));
                if sorted(ends) == ends {
                    edges.extend(stops.filter(|[from, to]| from != to).map(|[from, to]| Edge::whole(from, to)));
                } else {
                    edges.extend(stops.rev().filter(|[from, to]| from != to).map(|[from, to]| Edge::whole(to, from)));
                }
            }
            edges
        };
        let mut first = Vec::with_capacity(pair.first.len());
        for region in &pair.first {
            let mut loops = region.loops().map(&mut chain).filter(|one| !one.is_empty());
            let Some(outer) = loops.next() else { continue };
            first.push(Region { outer, holes: loops.collect() });
        }
        let second = Polygon { loops: pair.second.loops.iter().map(&mut chain).collect(), rule: Rule::NonZero };
        Ok(Pair { scene: points.scene()?, first, second })
    }
}
