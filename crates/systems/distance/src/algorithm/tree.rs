//! A tree of boxes over the edges or triangles of an object, and the pairs of parts that may be nearest.
//!
//! Two trees are searched together, the nearest pair of boxes first. The search ends at boxes that are farther apart
//! than two points that were found. A pair of parts at the distance of the objects is never left out.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use predicament_grid::Bounds;
use predicament_predicates::{Scene, Vertex};

use super::bounds::{above, below};
use crate::answer::Object;

/// The number of parts in a leaf.
const LEAF: usize = 4;

/// A tree over the parts of an object. It depends on raw coordinates only, not on a backend.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// The parts, leaf by leaf.
    order: Vec<u32>,
    /// The boxes of the parts.
    boxes: Vec<Bounds<3>>,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: Bounds<3>,
    content: Content,
}

#[derive(Clone, Copy, Debug)]
enum Content {
    /// The two children.
    Inner([usize; 2]),
    /// A range of the order.
    Leaf(usize, usize),
}

/// The point of a vertex; z is 0 in the plane.
pub(super) fn point(scene: &Scene, v: Vertex) -> [f64; 3] {
    let point = scene.point(v);
    [point[0], point[1], point.get(2).copied().unwrap_or(0.0)]
}

impl Tree {
    /// The tree over the parts of an object.
    ///
    /// # Panics
    /// If there are 2^32 parts, or the scene lacks a vertex.
    pub(super) fn new(scene: &Scene, object: &Object) -> Tree {
        let of_part = |part: &[Vertex]| Bounds::of(part.iter().map(|&v| point(scene, v)));
        let boxes: Vec<Bounds<3>> = object.parts().map(of_part).collect();
        let count = u32::try_from(boxes.len()).expect("an object has fewer than 2^32 parts");
        let mut tree = Tree { nodes: Vec::new(), order: (0..count).collect(), boxes };
        if count > 0 {
            tree.build(0, count as usize);
        }
        tree
    }

    /// Builds the node of a range, and returns its index.
    fn build(&mut self, from: usize, to: usize) -> usize {
        let (boxes, range) = (&self.boxes, &mut self.order[from..to]);
        let bounds = range.iter().fold(Bounds::NOTHING, |all, &at| all.union(&boxes[at as usize]));
        let here = self.nodes.len();
        self.nodes.push(Node { bounds, content: Content::Leaf(from, to) });
        if to - from <= LEAF {
            return here;
        }
        let side = |axis: usize| bounds.high[axis] / 2.0 - bounds.low[axis] / 2.0;
        let axis = (0..3).max_by(|&i, &j| side(i).total_cmp(&side(j))).unwrap_or(0);
        let middle = |at: u32| {
            let bounds = &boxes[at as usize];
            bounds.low[axis] / 2.0 + bounds.high[axis] / 2.0
        };
        let half = range.len() / 2;
        range.select_nth_unstable_by(half, |&i, &j| middle(i).total_cmp(&middle(j)).then(i.cmp(&j)));
        let children = [self.build(from, from + half), self.build(from + half, to)];
        self.nodes[here].content = Content::Inner(children);
        here
    }

    /// The box of everything.
    pub(super) fn bounds(&self) -> Bounds<3> {
        self.nodes.first().map_or(Bounds::NOTHING, |root| root.bounds)
    }
}

/// Two parts, one of each object, that may be at the distance of the objects.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    pub(super) parts: [u32; 2],
    /// True if the boxes meet.
    pub(super) meet: bool,
}

/// The pairs of parts that may be nearest, and a number that is at least the distance of the objects.
pub(super) fn near(scene: &Scene, objects: [&Object; 2], trees: [&Tree; 2]) -> (Vec<Near>, f64) {
    let of_parts = |i: u32, j: u32| {
        let mut points = [[[0.0; 3]; 3]; 2];
        let parts = [objects[0].part(i), objects[1].part(j)];
        for (points, part) in points.iter_mut().zip(parts) {
            points.iter_mut().zip(part).for_each(|(to, &v)| *to = point(scene, v));
        }
        above(&points[0][..parts[0].len()], &points[1][..parts[1].len()])
    };
    let mut least = f64::INFINITY;
    let mut found: Vec<(f64, [u32; 2])> = Vec::new();
    // Bits of doubles that are not negative are in their order.
    let mut open: BinaryHeap<Reverse<(u64, [usize; 2])>> = BinaryHeap::new();
    let bound = |at: [usize; 2]| below(&trees[0].nodes[at[0]].bounds, &trees[1].nodes[at[1]].bounds);
    if trees.iter().all(|tree| !tree.nodes.is_empty()) {
        open.push(Reverse((bound([0, 0]).to_bits(), [0, 0])));
    }
    while let Some(Reverse((bits, at))) = open.pop() {
        if f64::from_bits(bits) > least {
            break;
        }
        let nodes = [&trees[0].nodes[at[0]], &trees[1].nodes[at[1]]];
        let mut push = |at: [usize; 2]| {
            let bound = bound(at);
            if bound <= least {
                open.push(Reverse((bound.to_bits(), at)));
            }
        };
        let extent = |node: &Node| {
            (0..3).map(|axis| node.bounds.high[axis] / 2.0 - node.bounds.low[axis] / 2.0).fold(0.0, f64::max)
        };
        match (nodes[0].content, nodes[1].content) {
            (Content::Leaf(from, to), Content::Leaf(start, end)) => {
                for &i in &trees[0].order[from..to] {
                    for &j in &trees[1].order[start..end] {
                        let bound = below(&trees[0].boxes[i as usize], &trees[1].boxes[j as usize]);
                        if bound <= least {
                            least = least.min(of_parts(i, j));
                            found.push((bound, [i, j]));
                        }
                    }
                }
            }
            (Content::Inner(children), Content::Leaf(..)) => {
                children.into_iter().for_each(|child| push([child, at[1]]))
            }
            (Content::Leaf(..), Content::Inner(children)) => {
                children.into_iter().for_each(|child| push([at[0], child]))
            }
            (Content::Inner(first), Content::Inner(second)) => {
                if extent(nodes[0]) >= extent(nodes[1]) {
                    first.into_iter().for_each(|child| push([child, at[1]]));
                } else {
                    second.into_iter().for_each(|child| push([at[0], child]));
                }
            }
        }
    }
    found.retain(|(bound, _)| *bound <= least);
    (found.into_iter().map(|(bound, parts)| Near { parts, meet: bound == 0.0 }).collect(), least)
}
