//! Finds which of many boxes are near a given box, to skip pairs that cannot meet.
//!
//! # Definition
//! Two closed boxes are **near** if along every axis the gap between them, rounded to a double, is at most the reach.
//! Rounding is monotonic, so a gap that is truly at most the reach is also computed as at most the reach. With reach
//! zero the rule is exact: boxes that touch are near.
//!
//! # How
//! The boxes form a binary tree. Each node splits its boxes in half across the axis along which their centers extend
//! furthest. A node whose bounding box is not near the query is skipped. (The algorithms under test use grids.)

use std::ops::Range;

/// A closed axis-aligned box: its lowest and its highest coordinates.
pub type Extent<const D: usize> = [[f64; D]; 2];

/// The largest number of boxes in a leaf of the tree; a leaf's boxes are compared one by one.
const FEW: usize = 8;

/// A search tree over boxes, which are identified by their indices 0, 1, 2 …
#[derive(Clone, Debug)]
pub struct Boxes<const D: usize> {
    boxes: Vec<Extent<D>>,
    /// The indices of the boxes, grouped by tree node.
    order: Vec<u32>,
    halves: Vec<Half<D>>,
}

/// A node of the tree: a subset of the boxes.
#[derive(Clone, Debug)]
struct Half<const D: usize> {
    /// The bounding box of the node's boxes.
    all: Extent<D>,
    places: Range<usize>,
    /// The index of the second child, or `None` for a leaf. The first child follows its parent directly.
    second: Option<usize>,
}

/// The bounding box of the points; for zero points a box that is near nothing.
#[must_use]
pub fn extent<const D: usize>(points: impl IntoIterator<Item = [f64; D]>) -> Extent<D> {
    let nothing = [[f64::INFINITY; D], [f64::NEG_INFINITY; D]];
    points.into_iter().fold(nothing, |all, point| union(all, [point, point]))
}

fn union<const D: usize>([low, high]: Extent<D>, other: Extent<D>) -> Extent<D> {
    let [other_low, other_high] = other;
    [
        std::array::from_fn(|axis| low[axis].min(other_low[axis])),
        std::array::from_fn(|axis| high[axis].max(other_high[axis])),
    ]
}

/// True if two boxes are near, as [the module](self) defines it.
#[must_use]
pub fn are_near<const D: usize>([a_low, a_high]: &Extent<D>, [b_low, b_high]: &Extent<D>, reach: f64) -> bool {
    (0..D).all(|axis| a_low[axis] - b_high[axis] <= reach && b_low[axis] - a_high[axis] <= reach)
}

impl<const D: usize> Boxes<D> {
    /// Builds the search tree over the boxes.
    ///
    /// # Panics
    /// If there are 2^32 boxes.
    #[must_use]
    pub fn new(boxes: Vec<Extent<D>>) -> Boxes<D> {
        let count = u32::try_from(boxes.len()).expect("fewer than 2^32 boxes");
        let mut all = Boxes { boxes, order: (0..count).collect(), halves: Vec::new() };
        if count > 0 {
            all.halve(0..all.order.len());
        }
        all
    }

    /// All boxes, by index.
    #[must_use]
    pub fn all(&self) -> &[Extent<D>] {
        &self.boxes
    }

    /// Writes to `found` the indices of the boxes that are near `one`, ascending.
    pub fn near(&self, one: &Extent<D>, reach: f64, found: &mut Vec<u32>) {
        found.clear();
        self.each_near(one, reach, |place| found.push(place));
        found.sort_unstable();
    }

    /// Calls a function with the index of each box that is near `one`, in any order.
    pub fn each_near(&self, one: &Extent<D>, reach: f64, mut call: impl FnMut(u32)) {
        let mut next: Vec<usize> = if self.halves.is_empty() { Vec::new() } else { vec![0] };
        while let Some(at) = next.pop() {
            let half = &self.halves[at];
            if !are_near(&half.all, one, reach) {
                continue;
            }
            match half.second {
                Some(second) => next.extend([at + 1, second]),
                None => {
                    let places = self.order[half.places.clone()].iter().copied();
                    places.filter(|&place| are_near(&self.boxes[place as usize], one, reach)).for_each(&mut call);
                }
            }
        }
    }

    /// Adds the node with these positions in the order, and its children; returns the node's index.
    fn halve(&mut self, places: Range<usize>) -> usize {
        let at = self.halves.len();
        let boxes = || self.order[places.clone()].iter().map(|&place| self.boxes[place as usize]);
        let all = boxes().reduce(union).expect("a half holds boxes");
        // Each term is halved before the addition, so that the sum cannot overflow.
        let middle = |[low, high]: Extent<D>| -> [f64; D] { std::array::from_fn(|i| low[i] / 2.0 + high[i] / 2.0) };
        let [low, high] = extent(boxes().map(middle));
        let width = |axis: usize| high[axis] / 2.0 - low[axis] / 2.0;
        let axis = (0..D).max_by(|&a, &b| width(a).total_cmp(&width(b))).expect("a dimension");
        self.halves.push(Half { all, places: places.clone(), second: None });
        if places.len() > FEW {
            let along = |&place: &u32| middle(self.boxes[place as usize])[axis];
            let half = places.len() / 2;
            self.order[places.clone()]
                .select_nth_unstable_by(half, |a, b| along(a).total_cmp(&along(b)).then(a.cmp(b)));
            let between = places.start + half;
            self.halve(places.start..between);
            let second = self.halve(between..places.end);
            self.halves[at].second = Some(second);
        }
        at
    }
}
