//! Snap rounding: segments with their crossings, rounded to doubles.
//!
//! If the vertices of an arrangement are rounded one by one, edges may pass over vertices and cross each other where
//! nothing crossed before. Snap rounding rounds the edges with them. The plane is a grid of pixels, squares with sides
//! of a power of two. A pixel that contains an end or a crossing is *hot*. Each segment becomes the chain of the
//! centres of all hot pixels that it meets (Hobby, *Practical segment intersection with finite precision output*,
//! Comput. Geom. 13 (1999)).
//!
//! # What holds
//! * Every point of a segment is within half a pixel of its chain along either axis, and the other way round.
//! * Chains meet in common vertices and edges only: nothing new crosses. Parts in one order may collapse onto one edge,
//!   but never reverse their order. So faces may collapse and vertices may merge; [`Snapped::merged`] counts the merged
//!   vertices.
//! * A chain may pass through the half-open square of another hot pixel, however near to its centre. The method
//!   [`Method::Iterated`] (Halperin and Packer, *Iterated snap rounding*, Comput. Geom. 23 (2002)) repeats the rounding
//!   with the edges of the chains until none does. Then a vertex is half a pixel or more from each edge that does not
//!   end there, but a chain may be farther from its segment. [`Snapped::drift`] measures how far.
//! * Rounding ends: an edge is divided at pixels within its own box, and each part has a smaller box.
//!
//! # Threads
//! Crossings, parts of the tree of pixels, and chains are independent of each other: large drawings use all threads.
//!
//! # Pixels
//! A pixel is half-open: its left and its lower side belong to it. Coordinates are in units of pixels; those from 2^50
//! on are refused. All decisions are exact: doubles with an error bound, otherwise integers.

mod chain;
mod pixel;
mod plane;
mod tree;

use std::ops::Range;

use predicament_grid::parallel;

use pixel::{meets, pixel_of_crossing, pixel_of_point};
use tree::Tree;

pub use pixel::{Pixel, SIDES};
pub(crate) use plane::crossing_estimate;

/// The method of rounding segments.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Method {
    /// Rounds ends and crossings to the centres of their pixels, and nothing else, as programs do that round each
    /// point.
    Naive,
    /// Hobby's snap rounding.
    #[default]
    Snap,
    /// Iterated snap rounding: repeated with the edges of chains, until no edge meets a hot pixel in which it does not
    /// end.
    Iterated,
}

/// The input of rounding: segments between points, and the pairs of segments that cross or touch.
#[derive(Clone, Copy, Debug)]
pub struct Drawing<'d> {
    /// Coordinates of the points.
    pub points: &'d [[f64; 2]],
    /// Segments by the indices of their ends.
    pub segments: &'d [[u32; 2]],
    /// Pairs of segments that cross in one point. (Ends on other segments need not be listed: they are hot as ends.)
    pub crossings: &'d [[u32; 2]],
    /// Segments with points that are on them, possibly including their ends. Only [`Method::Naive`] needs them.
    pub touching: &'d [[u32; 2]],
}

/// A rounded drawing: its hot pixels, and for each segment the chain of pixels that it passes.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Snapped {
    /// The hot pixels, ascending, each once.
    pub pixels: Vec<Pixel>,
    /// The pixel of each point, as an index in `pixels`.
    pub ends: Vec<u32>,
    /// For each segment the pixels on its chain, in order from its first end, as indices in `pixels`.
    pub chains: Vec<Vec<u32>>,
    /// The number of merged points and crossings: their number less that of hot pixels.
    pub merged: usize,
}

/// The reason why a drawing cannot be rounded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SnapError {
    /// A point is not finite, or too far from the origin for pixels of this size.
    Point(u32),
    /// A segment's end is an index out of range.
    Segment(u32),
    /// A pair has a segment index out of range, or two parallel segments.
    Crossing(usize),
}

impl std::fmt::Display for SnapError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            SnapError::Point(at) => write!(f, "point {at} is 2^50 pixels or more from the origin, or not finite"),
            SnapError::Segment(at) => write!(f, "segment {at} ends in a point that does not exist"),
            SnapError::Crossing(at) => write!(f, "crossing {at} is not of two segments that meet in one point"),
        }
    }
}

impl std::error::Error for SnapError {}

/// Rounds a drawing to the centres of pixels with sides of 2^`exponent`: multiples of that.
///
/// The time is n·log n in the number of segments, crossings, and pairs of a segment and a hot pixel that meet.
///
/// # Errors
/// [`SnapError`] if a point is not finite or too far away for pixels of this size, an index is out of range, or the
/// segments of a pair do not meet in one point.
///
/// # Panics
/// If there are 2^32 points or segments.
pub fn snap(drawing: Drawing<'_>, exponent: i32, method: Method) -> Result<Snapped, SnapError> {
    let scaled = scaled(drawing.points, exponent)?;
    let number = |at: usize| u32::try_from(at).expect("fewer than 2^32");
    let segment = |at: u32| -> Option<[[f64; 2]; 2]> {
        let [a, b] = *drawing.segments.get(at as usize)?;
        Some([*scaled.get(a as usize)?, *scaled.get(b as usize)?])
    };
    if let Some(at) = (0..drawing.segments.len()).find(|&at| segment(number(at)).is_none()) {
        return Err(SnapError::Segment(number(at)));
    }
    let of_points: Vec<Pixel> = scaled.iter().map(|&point| pixel_of_point(point)).collect();
    let crossing = |at: usize| {
        let [s, t] = drawing.crossings[at];
        let pair = segment(s).zip(segment(t)).ok_or(SnapError::Crossing(at))?;
        pixel_of_crossing(pair.0, pair.1).ok_or(SnapError::Crossing(at))
    };
    let crossings = |range: Range<usize>| range.map(crossing).collect::<Result<Vec<Pixel>, _>>();
    let of_crossings = parallel::all_joined(parallel::ranges(drawing.crossings.len(), &crossings))?;
    let mut pixels = [of_points.as_slice(), &of_crossings].concat();
    parallel::sort_by_key(&mut pixels, |&pixel| pixel);
    pixels.dedup();
    let place = |pixel: &Pixel| number(pixels.binary_search(pixel).expect("a hot pixel"));
    let places =
        |of: &[Pixel]| parallel::joined(parallel::ranges(of.len(), &|range| of[range].iter().map(place).collect()));
    let ends: Vec<u32> = places(&of_points);
    let merged = of_points.len() + of_crossings.len() - pixels.len();
    let tree = (method != Method::Naive).then(|| Tree::new(&pixels));
    // The pixels of crossings and touches on each segment, which other methods find again.
    let mut known: Vec<Vec<u32>> = Vec::new();
    if method == Method::Naive {
        known.resize(drawing.segments.len(), Vec::new());
        for (pixel, pair) in places(&of_crossings).into_iter().zip(drawing.crossings) {
            pair.iter().for_each(|&s| known[s as usize].push(pixel));
        }
        for &[s, v] in drawing.touching {
            known[s as usize].push(ends[v as usize]);
        }
    }
    let chain = |at: usize| {
        let mut chain = known.get(at).cloned().unwrap_or_default();
        if let Some(tree) = &tree {
            let [a, b] = segment(number(at)).expect("looked at above");
            tree.near([a, b], &mut |pixel| {
                if meets([a, b], pixels[pixel as usize]) {
                    chain.push(pixel);
                }
            });
        }
        chain::sort(&mut chain, drawing.segments[at].map(|v| ends[v as usize]), &pixels);
        match &tree {
            Some(tree) if method == Method::Iterated => chain::iterated(&chain, &pixels, tree),
            _ => chain,
        }
    };
    let chains = |range: Range<usize>| range.map(chain).collect();
    let work = drawing.segments.len() + pixels.len();
    let chains = parallel::joined(parallel::uneven(drawing.segments.len(), work, &chains));
    Ok(Snapped { pixels, ends, chains, merged })
}

impl Snapped {
    /// The centre of the pixel with this index, for sides of 2^`exponent`. It is exact if it is a double: below 2^53
    /// sides, with sides not smaller than the least double.
    #[must_use]
    pub fn centre(&self, pixel: u32, exponent: i32) -> [f64; 2] {
        self.pixels[pixel as usize].map(|i| plane::scale(plane::double(i), exponent))
    }

    /// The edges of all chains, each once, the lower index first.
    #[must_use]
    pub fn edges(&self) -> Vec<[u32; 2]> {
        let of_chain =
            |chain: &Vec<u32>| chain.windows(2).map(|edge| [edge[0].min(edge[1]), edge[0].max(edge[1])]).collect();
        let mut edges: Vec<[u32; 2]> =
            self.chains.iter().flat_map(|chain| -> Vec<[u32; 2]> { of_chain(chain) }).collect();
        edges.retain(|[a, b]| a != b);
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// The largest distance of a vertex of a chain from its segment, in sides of pixels, rounded to a double.
    ///
    /// # Panics
    /// If the drawing is not the one that was rounded.
    #[must_use]
    pub fn drift(&self, drawing: Drawing<'_>, exponent: i32) -> f64 {
        let scaled = scaled(drawing.points, exponent).expect("a drawing that was rounded");
        let of_chain = |(chain, ends): (&Vec<u32>, &[u32; 2])| {
            let segment = ends.map(|v| scaled[v as usize]);
            let far = |&pixel: &u32| plane::distance(self.pixels[pixel as usize].map(plane::double), segment);
            chain.iter().map(far).fold(0.0, f64::max)
        };
        self.chains.iter().zip(drawing.segments).map(of_chain).fold(0.0, f64::max)
    }
}

/// Points in units of pixels.
fn scaled(points: &[[f64; 2]], exponent: i32) -> Result<Vec<[f64; 2]>, SnapError> {
    let scaled = |at: usize| {
        let point = &points[at];
        let scaled = point.map(|x| plane::scale(x, -exponent));
        // If scaling rounds, scaling back gives another value.
        let is_exact = scaled.iter().zip(point).all(|(&u, &x)| u.abs() < SIDES && plane::scale(u, exponent) == x);
        is_exact.then_some(scaled).ok_or(SnapError::Point(u32::try_from(at).expect("fewer than 2^32 points")))
    };
    parallel::all_joined(parallel::ranges(points.len(), &|range| range.map(scaled).collect()))
}
