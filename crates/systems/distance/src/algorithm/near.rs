//! The pairs of parts of two objects that may be nearest.
//!
//! The trees of both objects are searched together, the nearest pair of boxes first. The search ends at boxes that are
//! farther apart than two points that were found. A pair of parts at the distance of the objects is never left out.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use predicament_grid::Bounds;
use predicament_grid::tree::{Below, Node, Tree};
use predicament_predicates::{Scene, Vertex};

use super::bounds::{above, below};
use crate::answer::Object;

/// An object's parts in a tree of boxes.
#[derive(Debug)]
pub(super) struct Parts {
    tree: Tree,
    /// The boxes of the parts.
    boxes: Vec<Bounds<3>>,
}

/// The point of a vertex; z is 0 in the plane.
pub(super) fn point(scene: &Scene, v: Vertex) -> [f64; 3] {
    let point = scene.point(v);
    [point[0], point[1], point.get(2).copied().unwrap_or(0.0)]
}

impl Parts {
    /// The parts of an object.
    ///
    /// # Panics
    /// If there are 2^32 parts, or the scene lacks a vertex.
    pub(super) fn new(scene: &Scene, object: &Object) -> Parts {
        let of_part = |part: &[Vertex]| Bounds::of(part.iter().map(|&v| point(scene, v)));
        let boxes: Vec<Bounds<3>> = object.parts().map(of_part).collect();
        Parts { tree: Tree::new(&boxes), boxes }
    }

    /// The box of everything.
    pub(super) fn bounds(&self) -> Bounds<3> {
        self.tree.root().map_or(Bounds::NOTHING, |root| root.bounds)
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
pub(super) fn near(scene: &Scene, objects: [&Object; 2], all: [&Parts; 2]) -> (Vec<Near>, f64) {
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
    let node = |at: [usize; 2], one: usize| all[one].tree.node(at[one]);
    let bound = |at: [usize; 2]| below(&node(at, 0).0.bounds, &node(at, 1).0.bounds);
    if all.iter().all(|parts| parts.tree.root().is_some()) {
        open.push(Reverse((bound([0, 0]).to_bits(), [0, 0])));
    }
    while let Some(Reverse((bits, at))) = open.pop() {
        if f64::from_bits(bits) > least {
            break;
        }
        let nodes = [node(at, 0), node(at, 1)];
        let mut push = |at: [usize; 2]| {
            let bound = bound(at);
            if bound <= least {
                open.push(Reverse((bound.to_bits(), at)));
            }
        };
        let extent = |(node, _): (&Node, Below<'_>)| {
            (0..3).map(|axis| node.bounds.high[axis] / 2.0 - node.bounds.low[axis] / 2.0).fold(0.0, f64::max)
        };
        match (nodes[0].1, nodes[1].1) {
            (Below::Boxes(first), Below::Boxes(second)) => {
                for &i in first {
                    for &j in second {
                        let bound = below(&all[0].boxes[i as usize], &all[1].boxes[j as usize]);
                        if bound <= least {
                            least = least.min(of_parts(i, j));
                            found.push((bound, [i, j]));
                        }
                    }
                }
            }
            (Below::Nodes(children), Below::Boxes(_)) => children.into_iter().for_each(|child| push([child, at[1]])),
            (Below::Boxes(_), Below::Nodes(children)) => children.into_iter().for_each(|child| push([at[0], child])),
            (Below::Nodes(first), Below::Nodes(second)) => {
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
