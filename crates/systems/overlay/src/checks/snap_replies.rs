//! Checks of drawings that other programs have rounded to a grid: nothing new crosses, and nothing is lost.
//!
//! A program need not do snap rounding as Hobby defines it. These laws hold for every rounding whose result can stand
//! for the drawing:
//!
//! * `off the grid`: each vertex of a chain is a point of the grid.
//! * `ends of chains`: a chain begins and ends in a grid point nearest to the end of its segment along each axis (of
//!   two that are equally near, in either), the same one for all segments that end in the point.
//! * `far from its segment`: each vertex of a chain is within a distance of its segment.
//! * `way back`: a chain never goes back along its segment.
//! * `chains cross`: chains meet only in common vertices.
//! * `lost common vertex`: the chains of segments that cross have a common vertex within that distance of the crossing.
//!
//! # Why these are enough
//! A chain is connected, and within a distance of its segment at its vertices. It is so between them, too, since the
//! points within a distance of a segment are a convex set. Its projection on the segment's line leads from end to end,
//! so each point of the segment has a point of the chain beside it: both are near each other everywhere. Chains that do
//! not cross make a map with vertices on the grid, in which all segments that crossed are joined near their crossing.
//!
//! Snap rounding breaks none of these laws. Its chains have all hot pixels that their segments meet, so the distance is
//! that from the middle of a pixel to its corner, and the pixel of a crossing is hot.

use std::collections::{BTreeMap, BTreeSet};

use rug::Rational;

use super::snap::{Pixel, crossed, meeting};

/// The names of the checks.
pub const GRID: &str = "off the grid";
/// The check of ends.
pub const ENDS: &str = "ends of chains";
/// The check of distances.
pub const FAR: &str = "far from its segment";
/// The check of the direction.
pub const BACK: &str = "way back";
/// The check of crossings.
pub const CROSS: &str = "chains cross";
/// The check of vertices at crossings.
pub const LOST: &str = "lost common vertex";

/// Half the square of a grid's step: the square of the distance from a point of the grid to a corner of its pixel.
pub const HALF: f64 = 0.5;

type Point = [Rational; 2];

/// Segments, and the chains of a program, in steps of the grid.
pub struct Drawing {
    /// The ends of each segment.
    segments: Vec<[Point; 2]>,
    chains: Vec<Vec<Pixel>>,
}

/// The number of the first segment that shows a violation, the violated law, and the place in words.
pub type Violation = (usize, &'static str, String);

impl Drawing {
    /// Segments with coordinates in steps of the grid, and their chains. Repeated vertices of a chain are one.
    ///
    /// # Panics
    /// If there is not a chain for each segment, or a coordinate is not finite.
    #[must_use]
    pub fn new(segments: &[[[f64; 2]; 2]], mut chains: Vec<Vec<Pixel>>) -> Drawing {
        assert_eq!(segments.len(), chains.len(), "a chain for each segment");
        let exact = |x: f64| Rational::from_f64(x).expect("finite");
        chains.iter_mut().for_each(Vec::dedup);
        Drawing { segments: segments.iter().map(|ends| ends.map(|p| p.map(exact))).collect(), chains }
    }

    /// The square of the largest distance of a chain's vertex from its segment, and the segment.
    #[must_use]
    pub fn farthest(&self) -> (usize, Rational) {
        let of = |(at, chain): (usize, &Vec<Pixel>)| {
            let squares = chain.iter().map(|pixel| square_of_distance(&self.segments[at], pixel));
            (at, squares.max().unwrap_or_default())
        };
        let all = self.chains.iter().enumerate().map(of);
        all.fold((0, Rational::new()), |most, one| if one.1 > most.1 { one } else { most })
    }

    /// The violations of all laws but the first and that of distances, the first of each segment and law. `crossings`
    /// are the pairs of segments that cross.
    #[must_use]
    pub fn violations(&self, crossings: &[[u32; 2]], farthest: &Rational) -> Vec<Violation> {
        let mut found = self.ends();
        for (at, chain) in self.chains.iter().enumerate() {
            let [a, b] = &self.segments[at];
            let is_back = |edge: &[Pixel]| {
                let along =
                    |axis: usize| Rational::from(&b[axis] - &a[axis]) * Rational::from(edge[1][axis] - edge[0][axis]);
                (along(0) + along(1)).cmp0().is_lt()
            };
            if let Some(edge) = chain.windows(2).find(|edge| is_back(edge)) {
                found.push((at, BACK, format!("from {:?} to {:?}", edge[0], edge[1])));
            }
        }
        found
            .extend(crossed(&self.chains).map(|[at, other]| (at, CROSS, format!("with the chain of segment {other}"))));
        let vertices: Vec<BTreeSet<Pixel>> = self.chains.iter().map(|chain| chain.iter().copied().collect()).collect();
        let most = farthest.clone().max(Rational::from((1, 2)));
        for pair in crossings {
            let [s, t] = pair.map(|at| at as usize);
            let [[a, b], [c, d]] = [s, t].map(|at| &self.segments[at]);
            let at = meeting([a, b], [c, d]);
            let mut common = vertices[s].intersection(&vertices[t]);
            if !common.any(|pixel| square(&at, pixel) <= most) {
                let near = [0, 1].map(|axis: usize| at[axis].to_f64());
                found.push((s, LOST, format!("with the chain of segment {t}, near {near:?} steps")));
            }
        }
        found
    }

    fn ends(&self) -> Vec<Violation> {
        let mut found = Vec::new();
        let mut known: BTreeMap<&Point, Pixel> = BTreeMap::new();
        for (at, (ends, chain)) in self.segments.iter().zip(&self.chains).enumerate() {
            for (end, place) in ends.iter().zip([chain.first(), chain.last()]) {
                let Some(&place) = place else {
                    found.push((at, ENDS, "the chain is empty".to_owned()));
                    continue;
                };
                let is_near = (0..2).all(|axis| {
                    let off = (&end[axis] - Rational::from(place[axis])).abs();
                    off <= Rational::from((1, 2))
                });
                let first = *known.entry(end).or_insert(place);
                if !is_near {
                    found.push((at, ENDS, format!("the chain ends in {place:?}, which is not nearest")));
                } else if first != place {
                    found.push((at, ENDS, format!("one point is in {first:?} and in {place:?}")));
                }
            }
        }
        found
    }
}

/// The square of the distance of two points.
fn square(point: &Point, pixel: &Pixel) -> Rational {
    (0..2).map(|axis| (&point[axis] - Rational::from(pixel[axis])).square()).sum()
}

/// The square of the distance of a grid point from a segment.
fn square_of_distance([a, b]: &[Point; 2], pixel: &Pixel) -> Rational {
    let along = [0, 1].map(|axis: usize| Rational::from(&b[axis] - &a[axis]));
    let to = [0, 1].map(|axis: usize| Rational::from(pixel[axis]) - &a[axis]);
    let dot = |u: &Point, v: &Point| Rational::from(&u[0] * &v[0]) + Rational::from(&u[1] * &v[1]);
    let length = dot(&along, &along);
    if length.is_zero() {
        return dot(&to, &to);
    }
    let part = (dot(&along, &to) / length).clamp(&0, &1);
    let off = [0, 1].map(|axis: usize| Rational::from(&to[axis] - &Rational::from(&along[axis] * &part)));
    dot(&off, &off)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn laws(segments: &[[[f64; 2]; 2]], chains: &[&[Pixel]], crossings: &[[u32; 2]]) -> Vec<&'static str> {
        let drawing = Drawing::new(segments, chains.iter().map(|chain| chain.to_vec()).collect());
        let (_, square) = drawing.farthest();
        drawing.violations(crossings, &square).into_iter().map(|(_, check, _)| check).collect()
    }

    #[test]
    fn an_end_between_grid_points_may_go_to_either_but_not_to_both() {
        let two = [[[0.5, 0.0], [4.0, 0.0]], [[0.5, 0.0], [0.0, 4.0]]];
        assert!(laws(&two, &[&[[0, 0], [4, 0]], &[[0, 0], [0, 4]]], &[]).is_empty());
        assert!(laws(&two, &[&[[1, 0], [4, 0]], &[[1, 0], [0, 4]]], &[]).is_empty());
        assert_eq!(laws(&two, &[&[[1, 0], [4, 0]], &[[0, 0], [0, 4]]], &[]), [ENDS], "torn");
        assert_eq!(laws(&two, &[&[[2, 0], [4, 0]], &[[2, 0], [0, 4]]], &[]), [ENDS; 2], "not the nearest");
    }

    #[test]
    fn segments_that_cross_need_a_common_vertex_near_the_crossing() {
        let two = [[[0.0, 0.0], [4.0, 4.0]], [[0.0, 4.0], [4.0, 0.25]]];
        let right: [&[Pixel]; 2] = [&[[0, 0], [2, 2], [4, 4]], &[[0, 4], [2, 2], [4, 0]]];
        assert!(laws(&two, &right, &[[0, 1]]).is_empty());
        let straight: [&[Pixel]; 2] = [&[[0, 0], [4, 4]], &[[0, 4], [4, 0]]];
        assert_eq!(laws(&two, &straight, &[[0, 1]]), [CROSS, LOST]);
        let one: [&[Pixel]; 2] = [&[[0, 0], [2, 2], [4, 4]], &[[0, 4], [4, 0]]];
        assert_eq!(laws(&two, &one, &[[0, 1]]), [CROSS, CROSS, LOST], "a vertex in the middle of an edge");
    }

    #[test]
    fn the_distance_of_a_chain_is_that_of_its_farthest_vertex() {
        let far = |chain: &[Pixel]| Drawing::new(&[[[0.0, 0.0], [4.0, 0.0]]], vec![chain.to_vec()]).farthest().1;
        assert_eq!(far(&[[0, 0], [4, 0]]), 0);
        assert_eq!(far(&[[0, 0], [2, 1], [4, 0]]), 1);
        assert_eq!(far(&[[0, 0], [5, 1], [4, 0]]), 2);
    }
}
