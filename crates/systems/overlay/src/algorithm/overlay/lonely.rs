//! Edges of input polygons that meet nothing, found by monotone chains before anything is arranged.
//!
//! A *chain* is a part of a loop in which neither x nor y changes its direction. Its edges meet only in common
//! vertices: the box of each begins where the box before ends. The box of any part of a chain is the box of the part's
//! two ends. So two chains are compared by halving, as JTS and GEOS do, and most parts of smooth borders are never
//! looked at.
//!
//! An edge is *lonely* if its box meets the boxes of no other edges but its neighbours in the loop. Neighbours meet in
//! their common vertex. If they have more in common, an end of one is on the other, so the edge after (or before) them
//! meets it too: one of the two is not lonely, and the other one has no lonely neighbour. The same is true of edges
//! without length, and in a triangle two edges are at the leftmost vertex. Two or more consecutive lonely edges form a
//! [`Run`], whose time is that of a copy.
//!
//! The edges at the leftmost vertex of a loop are not part of a run: nesting finds the face around the loop there. If
//! these edges cancel, the next vertex to the left may be inside a run. The caller then overlays all edges.
//!
//! Boxes are of raw coordinates. Boxes that are apart have a distance, so no perturbation makes their edges meet.

use predicament_predicates::{Plane, Predicates};

use super::far::{Run, Split, keep_both};
use super::polygon::{Edge, Polygon};
use super::reach::Extent;
use super::sides::meets;

/// The minimum number of edges of a chain, on average, for which chains are worth their cost.
const WORTH: usize = 8;
/// The maximum number of boxes compared, per edge.
const STEPS: usize = 8;

/// The edges to arrange, each of one of two operands, and runs of the others.
type Divided = (Vec<(Edge, usize)>, Vec<Run>);

/// Divides the edges of two operands; `None` if too few are lonely, or if an edge is a part of an input segment.
pub(super) fn divide(session: &dyn Predicates, operands: [&Polygon; 2]) -> Option<Divided> {
    let mut loops = Loops::new(session, operands)?;
    let chains = loops.chains()?;
    loops.compare(&chains)?;
    let mut split = Split::default();
    let mut near = Vec::new();
    for (at, &(one, operand)) in loops.all.iter().enumerate() {
        let start = loops.starts[at];
        let points = &loops.points[start..start + one.len()];
        let is_near = &mut loops.is_near[start..start + one.len()];
        let least = points.iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
        (0..one.len()).filter(|&at| points[at][0] == least).for_each(|at| keep_both(at, is_near));
        split.add(one, is_near, operand);
        near.extend(split.near.drain(..).map(|edge| (edge, operand)));
        if 2 * near.len() > loops.points.len() {
            return None;
        }
    }
    Some((near, split.runs))
}

/// The loops of both operands.
struct Loops<'a> {
    /// Each loop with its operand.
    all: Vec<(&'a [Edge], usize)>,
    /// The index of each loop's first point.
    starts: Vec<usize>,
    /// The points of each loop, the first of them again at its end. Edge `i` is between points `i` and `i + 1`; the
    /// point between two loops is not the start of an edge.
    points: Vec<[f64; 2]>,
    is_near: Vec<bool>,
}

/// A chain, or a part of one: its first and its last point.
type Part = [usize; 2];

impl<'a> Loops<'a> {
    fn new(session: &dyn Predicates, operands: [&'a Polygon; 2]) -> Option<Loops<'a>> {
        let scene = session.scene();
        let count = operands.iter().flat_map(|polygon| &polygon.loops).map(|one| one.len() + 1).sum();
        let mut loops = Loops {
            all: Vec::new(),
            starts: Vec::new(),
            points: Vec::with_capacity(count),
            is_near: vec![false; count],
        };
        for (operand, polygon) in operands.into_iter().enumerate() {
            for one in polygon.loops.iter().filter(|one| !one.is_empty()) {
                loops.all.push((one, operand));
                loops.starts.push(loops.points.len());
                for edge in one {
                    if edge.support != [edge.from, edge.to] {
                        return None;
                    }
                    loops.points.push(scene.point2(Plane::Xy, edge.from));
                }
                loops.points.push(scene.point2(Plane::Xy, one[0].from));
            }
        }
        Some(loops)
    }

    /// The chains of all loops; `None` if they are short.
    fn chains(&self) -> Option<Vec<Part>> {
        let most = self.points.len() / WORTH;
        let mut chains: Vec<Part> = Vec::new();
        for (&start, (one, _)) in self.starts.iter().zip(&self.all) {
            let mut from = start;
            let mut way = [0.0; 2];
            for at in start..start + one.len() {
                let step = self.step(at);
                let turns = way[0] * step[0] < 0.0 || way[1] * step[1] < 0.0 || step == [0.0; 2];
                if turns && at > from {
                    chains.push([from, at]);
                    from = at;
                    way = step;
                } else {
                    way = [0, 1].map(|axis| if step[axis] == 0.0 { way[axis] } else { step[axis] });
                }
            }
            chains.push([from, start + one.len()]);
            if chains.len() > most {
                return None;
            }
        }
        Some(chains)
    }

    /// The direction of an edge: the sign of its step in x and in y.
    fn step(&self, at: usize) -> [f64; 2] {
        let [a, b] = [self.points[at], self.points[at + 1]];
        [0, 1].map(|axis| f64::from(i8::from(b[axis] > a[axis]) - i8::from(b[axis] < a[axis])))
    }

    fn extent(&self, [from, to]: Part) -> Extent {
        let [a, b] = [self.points[from], self.points[to]];
        [a[0].min(b[0]), a[1].min(b[1]), a[0].max(b[0]), a[1].max(b[1])]
    }

    /// Finds the edges of different chains whose boxes meet; `None` if that takes too long.
    fn compare(&mut self, chains: &[Part]) -> Option<()> {
        let mut left = STEPS * self.points.len();
        let mut sorted: Vec<(Extent, Part)> = chains.iter().map(|&part| (self.extent(part), part)).collect();
        sorted.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]).then(a.1.cmp(&b.1)));
        let mut open: Vec<(Extent, Part)> = Vec::new();
        let mut stack: Vec<[Part; 2]> = Vec::new();
        for (own, part) in sorted {
            open.retain(|(other, _)| other[2] >= own[0]);
            left = left.checked_sub(open.len())?;
            stack.extend(open.iter().filter(|(other, _)| meets(&own, other)).map(|&(_, other)| [other, part]));
            open.push((own, part));
            while let Some([first, second]) = stack.pop() {
                left = left.checked_sub(1)?;
                let [halves, others] = [&first, &second].map(halves);
                if first[1] - first[0] == 1 && second[1] - second[0] == 1 {
                    self.pair(first[0], second[0]);
                    continue;
                }
                for half in halves {
                    let own = self.extent(half);
                    let near = others.clone().filter(|other| meets(&own, &self.extent(*other)));
                    stack.extend(near.map(|other| [half, other]));
                }
            }
        }
        Some(())
    }

    /// Two edges of different chains whose boxes meet.
    fn pair(&mut self, i: usize, j: usize) {
        let [low, high] = [i.min(j), i.max(j)];
        let place = self.starts.partition_point(|&start| start <= low) - 1;
        let start = self.starts[place];
        let last = start + self.all[place].0.len() - 1;
        if high > low + 1 && [low, high] != [start, last] {
            self.is_near[low] = true;
            self.is_near[high] = true;
        }
    }
}

/// The two halves of a part; an edge is in one.
fn halves(&[from, to]: &Part) -> impl Iterator<Item = Part> + Clone {
    let middle = from.midpoint(to);
    [[from, middle], [middle, to]].into_iter().filter(|[from, to]| from < to)
}
