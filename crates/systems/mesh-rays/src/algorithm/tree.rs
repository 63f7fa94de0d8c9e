//! The triangles whose boxes a query may meet: a tree of boxes.
//!
//! The tests use raw coordinates only. A box is left out if a comparison of doubles shows that it is beside the query,
//! or if its projection is beside the projected line by more than the rounding error of the test. So a triangle that
//! the query meets is never left out, also under a perturbation by infinitesimals.

use predicament_grid::Bounds;
use predicament_predicates::{Scene, Vertex};

use crate::answer::Extent;

/// The number of triangles in a leaf.
const LEAF: usize = 4;

/// A tree of boxes of triangles.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    /// The nodes; the root is the first.
    nodes: Vec<Node>,
    /// The triangles, leaf by leaf.
    order: Vec<u32>,
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

impl Tree {
    /// The tree over the triangles of a scene.
    ///
    /// # Panics
    /// If there are 2^32 triangles.
    pub(super) fn new(scene: &Scene, triangles: &[[Vertex; 3]]) -> Tree {
        let boxes: Vec<Bounds<3>> =
            triangles.iter().map(|corners| Bounds::of(corners.map(|v| scene.point3(v)))).collect();
        let count = u32::try_from(boxes.len()).expect("a mesh has fewer than 2^32 triangles");
        let mut tree = Tree { nodes: Vec::new(), order: (0..count).collect() };
        if count > 0 {
            tree.build(&boxes, 0, boxes.len());
        }
        tree
    }

    /// Builds the node of a range, and returns its index.
    fn build(&mut self, boxes: &[Bounds<3>], from: usize, to: usize) -> usize {
        let range = &mut self.order[from..to];
        let bounds = range.iter().fold(Bounds::NOTHING, |all, &at| all.union(&boxes[at as usize]));
        let here = self.nodes.len();
        self.nodes.push(Node { bounds, content: Content::Leaf(from, to) });
        if to - from <= LEAF {
            return here;
        }
        // Halves, so that overflow does not hide which side is the longest.
        let side = |axis: usize| bounds.high[axis] / 2.0 - bounds.low[axis] / 2.0;
        let axis = (0..3).max_by(|&i, &j| side(i).total_cmp(&side(j))).unwrap_or(0);
        let middle = |at: u32| {
            let bounds = &boxes[at as usize];
            bounds.low[axis] / 2.0 + bounds.high[axis] / 2.0
        };
        let half = range.len() / 2;
        range.select_nth_unstable_by(half, |&i, &j| middle(i).total_cmp(&middle(j)).then(i.cmp(&j)));
        let children = [self.build(boxes, from, from + half), self.build(boxes, from + half, to)];
        self.nodes[here].content = Content::Inner(children);
        here
    }

    /// The triangles whose boxes, enlarged by `reach`, the query may meet; ascending.
    pub(super) fn near(&self, beam: &Beam, reach: f64) -> Vec<u32> {
        let mut found = Vec::new();
        let mut left: Vec<usize> = (!self.nodes.is_empty()).then_some(0).into_iter().collect();
        while let Some(at) = left.pop() {
            let Node { bounds, content } = &self.nodes[at];
            if !beam.may_meet(&enlarged(bounds, reach)) {
                continue;
            }
            match *content {
                Content::Inner(children) => left.extend(children),
                Content::Leaf(from, to) => found.extend_from_slice(&self.order[from..to]),
            }
        }
        found.sort_unstable();
        found
    }
}

/// The box with each side moved outward by more than `reach` and the rounding error of the sum.
fn enlarged(bounds: &Bounds<3>, reach: f64) -> Bounds<3> {
    if reach == 0.0 {
        return *bounds;
    }
    let by = reach.next_up();
    Bounds { low: bounds.low.map(|low| (low - by).next_down()), high: bounds.high.map(|high| (high + by).next_up()) }
}

/// A query in raw coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beam {
    pub(super) from: [f64; 3],
    pub(super) to: [f64; 3],
    pub(super) extent: Extent,
}

impl Beam {
    /// True unless the box is certainly beside the query.
    fn may_meet(&self, bounds: &Bounds<3>) -> bool {
        (0..3).all(|axis| self.may_meet_slab(bounds.low[axis], bounds.high[axis], axis))
            && [[0, 1], [1, 2], [2, 0]].into_iter().all(|axes| self.may_meet_shadow(bounds, axes))
    }

    /// Compares doubles along one axis, which is exact.
    fn may_meet_slab(&self, low: f64, high: f64, axis: usize) -> bool {
        let (p, q) = (self.from[axis], self.to[axis]);
        let [first, last] = match self.extent {
            _ if p == q => [p, p],
            Extent::Line => return true,
            Extent::Ray if p < q => [p, f64::INFINITY],
            Extent::Ray => [f64::NEG_INFINITY, p],
            Extent::Segment => [p.min(q), p.max(q)],
        };
        low <= last && first <= high
    }

    /// True unless all corners of the projected box are on one side of the projected line. Each corner's determinant
    /// has an error of less than eight units in the last place of the sum of its terms, and one more for underflow.
    fn may_meet_shadow(&self, bounds: &Bounds<3>, [i, j]: [usize; 2]) -> bool {
        const ERROR: f64 = 16.0 * f64::EPSILON;
        let along = [self.to[i] - self.from[i], self.to[j] - self.from[j]];
        let side = |x: f64, y: f64| {
            let terms = [along[0] * (y - self.from[j]), along[1] * (x - self.from[i])];
            let error = ERROR * (terms[0].abs() + terms[1].abs()) + f64::MIN_POSITIVE;
            let determinant = terms[0] - terms[1];
            // A NaN, or an infinite error, decides nothing.
            i8::from(determinant > error) - i8::from(determinant < -error)
        };
        let sides = [bounds.low[i], bounds.high[i]].map(|x| [bounds.low[j], bounds.high[j]].map(|y| side(x, y)));
        let sides = sides.as_flattened();
        !(sides.iter().all(|&side| side > 0) || sides.iter().all(|&side| side < 0))
    }
}
