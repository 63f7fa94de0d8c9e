//! A tree of boxes, split at the middle of the longest side, for queries that a grid does not suit: rays, and nearest
//! pairs.

use crate::Bounds;

/// The number of boxes in a leaf.
const LEAF: usize = 4;

/// A tree over boxes in space. It depends on raw coordinates only, not on a backend.
#[derive(Clone, Debug)]
pub struct Tree {
    nodes: Vec<Node>,
    /// The indices of the boxes, leaf by leaf.
    order: Vec<u32>,
}

/// A node of a [`Tree`].
#[derive(Clone, Debug)]
pub struct Node {
    /// The smallest box that holds the boxes below.
    pub bounds: Bounds<3>,
    content: Content,
}

#[derive(Clone, Copy, Debug)]
enum Content {
    /// The two children.
    Inner([usize; 2]),
    /// A range of the order.
    Leaf(usize, usize),
}

/// The things below a node.
#[derive(Clone, Copy, Debug)]
pub enum Below<'t> {
    /// The indices of two nodes.
    Nodes([usize; 2]),
    /// The indices of boxes.
    Boxes(&'t [u32]),
}

impl Tree {
    /// The tree over these boxes.
    ///
    /// # Panics
    /// If there are 2^32 boxes.
    #[must_use]
    pub fn new(boxes: &[Bounds<3>]) -> Tree {
        let count = u32::try_from(boxes.len()).expect("a tree has fewer than 2^32 boxes");
        let mut tree = Tree { nodes: Vec::new(), order: (0..count).collect() };
        if count > 0 {
            tree.build(boxes, 0, boxes.len());
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

    /// The root, node 0; `None` if there is not a box.
    #[must_use]
    pub fn root(&self) -> Option<&Node> {
        self.nodes.first()
    }

    /// A node and the things below it.
    ///
    /// # Panics
    /// If there is no such node.
    #[must_use]
    pub fn node(&self, at: usize) -> (&Node, Below<'_>) {
        let node = &self.nodes[at];
        let below = match node.content {
            Content::Inner(children) => Below::Nodes(children),
            Content::Leaf(from, to) => Below::Boxes(&self.order[from..to]),
        };
        (node, below)
    }

    /// The indices of the boxes in all leaves that a test admits, ascending. The test must admit each box around an
    /// admitted box.
    pub fn admitted(&self, admits: impl Fn(&Bounds<3>) -> bool) -> Vec<u32> {
        let mut found = Vec::new();
        let mut left: Vec<usize> = (!self.nodes.is_empty()).then_some(0).into_iter().collect();
        while let Some(at) = left.pop() {
            let (node, below) = self.node(at);
            if admits(&node.bounds) {
                match below {
                    Below::Nodes(children) => left.extend(children),
                    Below::Boxes(boxes) => found.extend_from_slice(boxes),
                }
            }
        }
        found.sort_unstable();
        found
    }
}
