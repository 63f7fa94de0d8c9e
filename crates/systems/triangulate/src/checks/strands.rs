//! Crossings of loops at a place.
//!
//! A strand is a passage of a loop through a place: at a corner, or in the middle of an edge. It separates the
//! directions around the place: those on its left, where the inside of its loop is, and the others. Two strands cross
//! if the second leaves into one of these parts and arrives from the other. Vertices at one place count as one vertex.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::nesting::edges;
use super::plane::Points;
use super::touches::Touches;

/// A strand: the points in whose directions it leaves and arrives.
type Strand = [usize; 2];

/// A point at the first place, in order, at which two strands cross. No edge may overlap another one, except an edge of
/// two loops with the inside on both sides.
pub(super) fn crossing(points: &Points, loops: &[Vec<usize>], touches: &Touches) -> Option<usize> {
    let first = points.first_at_each_place();
    let mut at: BTreeMap<usize, Vec<Strand>> = BTreeMap::new();
    for one in loops {
        let mut corners = one.clone();
        corners.dedup_by_key(|corner| first[*corner]);
        while corners.len() > 1 && first[corners[0]] == first[corners[corners.len() - 1]] {
            corners.pop();
        }
        for (&before, [corner, after]) in corners.iter().cycle().skip(corners.len() - 1).zip(edges(&corners)) {
            at.entry(first[corner]).or_default().push([after, before]);
        }
    }
    let mut middles: Vec<(usize, [usize; 2])> = touches.on_edges.iter().map(|&(v, edge)| (first[v], edge)).collect();
    middles.sort_unstable();
    middles.dedup();
    for (place, [a, b]) in middles {
        at.entry(place).or_default().push([b, a]);
    }
    let crosses = |place: usize, strands: &[Strand]| {
        let pairs = strands.iter().enumerate().flat_map(|(i, &s)| strands[i + 1..].iter().map(move |&t| (s, t)));
        pairs.into_iter().any(|(s, t)| do_cross(points, place, s, t))
    };
    at.into_iter().find(|(place, strands)| crosses(*place, strands)).map(|(place, _)| place)
}

/// True if the strands cross at a place. If one leaves where the other arrives, their left sides must be apart.
fn do_cross(points: &Points, place: usize, [from, to]: Strand, [leaves, arrives]: Strand) -> bool {
    let order = |a: usize, b: usize| points.order_around(place, from, a, b);
    // Just after the edge that leaves, and just before the edge that arrives, counterclockwise.
    let leaves_inside = order(leaves, to).is_lt();
    let arrives_inside = order(from, arrives).is_lt() && order(arrives, to).is_le();
    leaves_inside != arrives_inside
}

impl Points {
    /// The order of two directions by their angles from a first one, counterclockwise: from zero to less than a turn.
    pub(super) fn order_around(&self, place: usize, from: usize, a: usize, b: usize) -> Ordering {
        let class = |far: usize| match (self.side(place, from, far), self.along(place, from, far).cmp0()) {
            (Ordering::Equal, Ordering::Greater) => 0,
            (Ordering::Greater, _) => 1,
            (Ordering::Equal, _) => 2,
            (Ordering::Less, _) => 3,
        };
        class(a).cmp(&class(b)).then_with(|| self.side(place, a, b).reverse())
    }
}
