//! Results that snap rounding brings back to doubles after each step.
//!
//! Edges and crossings of both operands are rounded to pixels; then the rounded operands are combined, whose chains
//! meet only in pixels.
//!
//! # Which edges are snapped
//! Iterated snap rounding leaves no edge that meets a hot pixel of another vertex. So an edge of a result changes only
//! if it meets a new hot pixel, or if it is an edge of the next operand. New hot pixels are those of the operand's
//! corners and of crossings with its edges. So edges farther than two pixels from the operand's edges stay as they are.
//!
//! Hot pixels that are farther from a snapped segment than its chain ever goes do not change the chain. The chain is
//! not known before, so pixels within [`FAR`] are hot, and then the largest distance of a chain from its segment is
//! measured. If that is too far, all pixels are hot, and all edges are snapped.

use std::time::Instant;

use predicament_overlay::algorithm::overlay::{Edge, Lines, Method as Search, combine, cross};
use predicament_overlay::algorithm::snap::{Drawing, Method as Snapping, Snapped, snap};
use predicament_predicates::{Construction, Scene, Vertex};
use predicament_tasks::Contestant;

use super::cascade::{Loop, Operand};
use super::current::{Current, Numbering, Places, Ring};
use super::rounded::{Made, each, in_session};
use super::step::{End, Then};

/// The distance to which hot pixels are taken into account, in pixels along each axis.
const FAR: f64 = 64.0;
/// The distance from a chain within which pixels may change it: more than a pixel's diagonal.
const REACH: f64 = 2.0;

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
    within(FAR, backend, exponent, start, steps, then)
}

/// Does the steps, with hot pixels to a distance.
fn within(
    distance: f64,
    backend: &dyn Contestant,
    exponent: i32,
    start: &Loop,
    steps: &[Operand],
    then: &mut Then<'_>,
) -> Result<(), End> {
    // The initial operand is not on pixels yet.
    let mut far = f64::INFINITY;
    each(start, steps, then, |current, step, _| {
        let clock = Instant::now();
        let operand = current.ring(&step.corners);
        let mut near = Near::of(current, &operand, far, exponent);
        let (mut chains, mut constructed) = near.snapped(backend, current)?;
        if far.is_finite() && near.drift(current, &chains) > far - REACH {
            near = Near::of(current, &operand, f64::INFINITY, exponent);
            (chains, constructed) = near.snapped(backend, current)?;
        }
        far = distance;
        let operand = near.replace(current, &operand, &chains);
        let pair = current.pair(&operand)?;
        in_session(backend, &pair.scene, &mut |session| {
            let result = combine(session, &pair.first, &pair.second, step.operation, Search::Grid)?;
            let session = &*session;
            Ok(Made {
                regions: Places::new(&pair, session).rings(&mut current.points, &result.regions),
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
    /// The exponent of a pixel's side.
    exponent: i32,
    /// For each edge of the result so far, loop after loop, true if it is snapped.
    is_near: Vec<bool>,
    /// The ends of segments, in the order of their vertices; then other points.
    points: Numbering,
    /// The number of ends.
    ends: usize,
    /// The segments, with the lower end first; ascending, each once.
    segments: Vec<[Vertex; 2]>,
}

fn sorted([a, b]: [Vertex; 2]) -> [Vertex; 2] {
    if a < b { [a, b] } else { [b, a] }
}

/// The pairs of consecutive points of a loop.
fn pairs(ring: &Ring) -> impl Iterator<Item = [u32; 2]> {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&from, &to)| [from, to])
}

impl Near {
    /// Finds the segments and points within a distance, in pixels.
    fn of(current: &Current, operand: &Ring, far: f64, exponent: i32) -> Near {
        let all = &current.points.points;
        let at = |point: u32| all[point as usize];
        let far = far * 2.0_f64.powi(exponent);
        let mut points = Numbering::below(all.len());
        let mut segments: Vec<[Vertex; 2]> = Vec::new();
        let rings = || current.regions.iter().flatten();
        let held = current.held();
        let mut passed: Ring = Vec::with_capacity(held);
        rings().for_each(|ring| passed.extend_from_slice(ring));
        let corners: Vec<[f64; 2]> = passed.iter().map(|&point| at(point)).collect();
        let mut is_near: Vec<bool> = Vec::with_capacity(held);
        let lines = Lines::around(&pairs(operand).map(|ends| ends.map(at)).collect::<Vec<_>>(), far);
        let mut start = 0;
        for ring in rings() {
            let end = start + ring.len();
            lines.near_edges(&corners[start..end], &mut is_near);
            start = end;
            let own = &is_near[end - ring.len()..];
            // Vertices are numbered in the order of the loops.
            let mut before = own.last() == Some(&true);
            for (&point, &is_near) in ring.iter().zip(own) {
                if before || is_near {
                    points.vertex(point);
                }
                before = is_near;
            }
            for place in (0..ring.len()).filter(|&place| own[place]) {
                let ends = [ring[place], ring[if place + 1 == ring.len() { 0 } else { place + 1 }]];
                segments.push(sorted(ends.map(|point| points.vertex(point))));
            }
        }
        // A point that a snapped edge may approach is hot, whether or not an edge ends there. A point near an edge of
        // the operand is the end of an edge near that edge.
        let ends = |[a, b]: &[Vertex; 2]| [a, b].map(|v| at(points.points[v.index()]));
        let lines = Lines::around(&segments.iter().map(ends).collect::<Vec<_>>(), far);
        let mut hot = Vec::new();
        lines.near_points(&corners, &mut hot);
        segments.extend(pairs(operand).map(|ends| sorted(ends.map(|point| points.vertex(point)))));
        segments.retain(|[a, b]| a != b);
        segments.sort_unstable();
        segments.dedup();
        let ends = points.points.len();
        hot.into_iter().for_each(|place| {
            points.vertex(passed[place]);
        });
        Near { exponent, is_near, points, ends, segments }
    }

    /// The chains of the segments, and the number of crossings.
    fn snapped(&self, backend: &dyn Contestant, current: &Current) -> Result<(Snapped, usize), End> {
        let scene = current.scene(&self.points.points[..self.ends])?;
        in_session(backend, &scene, &mut |session| {
            let edges: Vec<Edge> = self.segments.iter().map(|&[a, b]| Edge::whole(a, b)).collect();
            cross(session, &edges, Search::Grid)?;
            let scene = session.scene();
            let chains =
                self.draw(current, &self.crossings(scene), |drawing| snap(drawing, self.exponent, Snapping::Iterated))?;
            Ok((chains, scene.constructions().len()))
        })
    }

    /// The pairs of segments that cross.
    fn crossings(&self, scene: &Scene) -> Vec<[u32; 2]> {
        let place = |ends: [Vertex; 2]| {
            let at = self.segments.binary_search(&sorted(ends)).ok()?;
            u32::try_from(at).ok()
        };
        let crossing = |construction: &Construction| match construction {
            Construction::Ssi([s, t]) => Some([place(*s)?, place(*t)?]),
            _ => None,
        };
        scene.constructions().iter().filter_map(crossing).collect()
    }

    /// Passes the drawing of the segments on.
    fn draw<T>(&self, current: &Current, crossings: &[[u32; 2]], then: impl FnOnce(Drawing<'_>) -> T) -> T {
        let points: Vec<[f64; 2]> =
            self.points.points.iter().map(|&point| current.points.points[point as usize]).collect();
        let number = |v: Vertex| u32::try_from(v.index()).unwrap_or(u32::MAX);
        let segments: Vec<[u32; 2]> = self.segments.iter().map(|ends| ends.map(number)).collect();
        then(Drawing { points: &points, segments: &segments, crossings, touching: &[] })
    }

    /// The largest distance of a chain from its segment, in pixels.
    fn drift(&self, current: &Current, chains: &Snapped) -> f64 {
        self.draw(current, &[], |drawing| chains.drift(drawing, self.exponent))
    }

    /// Replaces the snapped edges of the result by their chains; returns the chains of the operand.
    fn replace(&mut self, current: &mut Current, operand: &Ring, chains: &Snapped) -> Ring {
        let mut centres = vec![u32::MAX; chains.pixels.len()];
        let all = &mut current.points;
        let (numbering, segments) = (&mut self.points, &self.segments);
        let mut append = |[from, to]: [u32; 2], ring: &mut Ring| {
            let ends = [from, to].map(|point| numbering.vertex(point));
            let Ok(at) = segments.binary_search(&sorted(ends)) else { return };
            let chain = &chains.chains[at];
            let mut add = |pixel: &u32| {
                let centre = &mut centres[*pixel as usize];
                if *centre == u32::MAX {
                    *centre = all.index(chains.centre(*pixel, self.exponent));
                }
                ring.push(*centre);
            };
            // Without the last one, where the next edge begins.
            if ends[0] < ends[1] {
                chain[..chain.len() - 1].iter().for_each(&mut add);
            } else {
                chain[1..].iter().rev().for_each(&mut add);
            }
        };
        let mut left = self.is_near.as_slice();
        for ring in current.regions.iter_mut().flatten() {
            let (is_near, others) = left.split_at(ring.len());
            left = others;
            let mut next = Ring::with_capacity(ring.len() + 16);
            let mut done = 0;
            while let Some(far) = is_near[done..].iter().position(|is_near| *is_near) {
                let at = done + far;
                next.extend_from_slice(&ring[done..at]);
                append([ring[at], ring[if at + 1 == ring.len() { 0 } else { at + 1 }]], &mut next);
                done = at + 1;
            }
            next.extend_from_slice(&ring[done..]);
            *ring = next;
        }
        let mut chained = Ring::new();
        pairs(operand).for_each(|ends| append(ends, &mut chained));
        chained
    }
}

#[cfg(test)]
mod tests {
    use predicament_exact::Exact;
    use predicament_overlay::algorithm::overlay::Operation;
    use predicament_tasks::Entry;

    use super::*;
    use crate::cascades::Cascade;

    /// The loops after each step, independent of the order in which they are stored.
    fn results(start: &Loop, steps: &[Operand], distance: f64, exponent: i32) -> Vec<Vec<Vec<Vec<String>>>> {
        let mut results = Vec::new();
        let mut note = |stepped: crate::cascades::step::Stepped<'_>| {
            let mut regions = (stepped.shape)().regions;
            for region in &mut regions {
                for one in region.iter_mut() {
                    let least = (0..one.len()).min_by_key(|&at| one[at].clone()).unwrap_or(0);
                    one.rotate_left(least);
                }
                region[1..].sort();
            }
            regions.sort();
            let texts = |one: &Vec<[rug::Rational; 2]>| one.iter().map(|corner| format!("{corner:?}")).collect();
            results.push(regions.iter().map(|region| region.iter().map(texts).collect()).collect());
            Ok(())
        };
        let mut then = Then { samples: &[], note: &mut note };
        let end = within(distance, &Entry::new(Exact), exponent, start, steps, &mut then);
        assert!(end.is_ok() && results.len() == steps.len());
        results
    }

    #[test]
    fn what_is_far_does_not_change() {
        for cascade in Cascade::ALL {
            let (start, steps) = cascade.steps(24, 1);
            // Pixels of all sizes: with large ones nearly everything is near.
            for exponent in [-38, -12, -6] {
                let all = results(&start, &steps, f64::INFINITY, exponent);
                assert_eq!(results(&start, &steps, FAR, exponent), all, "{cascade:?}, pixels of 2^{exponent}");
            }
        }
    }

    /// A comb whose teeth end half a pixel or more above a long edge. Posts cross the edge and bend it a little, and
    /// then it meets pixels of teeth that are far from the posts.
    #[test]
    fn what_a_bent_edge_approaches_is_hot() {
        let mut start: Loop = vec![[0.0, 0.0], [1000.0, 7.0], [1000.0, 60.0]];
        for tooth in (1..100).rev() {
            let x = 10.0 * f64::from(tooth);
            start.extend([[x, (0.007 * x + 0.51).floor() + 1.0], [x - 5.0, 50.0]]);
        }
        start.push([0.0, 60.0]);
        let post = |x: f64| Operand {
            operation: Operation::Union,
            corners: vec![[x, -20.0], [x + 3.0, -20.0], [x + 3.0, 9.0], [x, 9.0]],
        };
        let steps: Vec<Operand> = [2000.0, 73.0, 645.0, 359.0].into_iter().map(post).collect();
        let all = results(&start, &steps, f64::INFINITY, 0);
        assert_eq!(results(&start, &steps, FAR, 0), all);
    }

    /// A notch whose bottom is a row of vertices above a long edge, less than half a pixel higher one by one. A post
    /// bends the edge into the first of their pixels. Each bend leads into the next pixel, 15 pixels from the edge in
    /// the end.
    #[test]
    fn a_chain_that_goes_far_is_found() {
        let mut start: Loop = vec![[0.0, 0.0], [4096.0, 1001.0], [4096.0, 1200.0], [3160.0, 1200.0]];
        start.extend((0..30).map(|vertex| [3159.0 - 2.0 * f64::from(vertex), 773.0]));
        start.push([0.0, 1200.0]);
        let post = |x: f64| Operand {
            operation: Operation::Union,
            corners: vec![[x, 700.0], [x + 3.0, 700.0], [x + 3.0, 790.0], [x, 790.0]],
        };
        let steps: Vec<Operand> = [5000.0, 3161.0].into_iter().map(post).collect();
        let all = results(&start, &steps, f64::INFINITY, 0);
        assert_eq!(results(&start, &steps, 8.0, 0), all);
    }
}
