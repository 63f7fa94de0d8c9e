//! Checks of drawings rounded to pixels, by their definition in rationals; nothing of the algorithm is used.
//!
//! The check finds the pixels that a segment meets by the range of its parameter t within each: the intersection of
//! intervals, some of them open at an end. The algorithm uses corners and sides of lines instead.
//!
//! A segment is compared with all hot pixels in its box. Edges of chains are compared with all edges whose ranges along
//! x overlap.

use rug::Rational;

mod lattice;

use lattice::{cross, distance2_at_least};

/// A pixel as its centre, in units of pixels.
pub type Pixel = [i64; 2];

/// A drawing and its rounded form.
#[derive(Clone, Copy, Debug)]
pub struct Rounded<'r> {
    /// Coordinates of the points.
    pub points: &'r [[f64; 2]],
    /// Segments by the indices of their ends.
    pub segments: &'r [[u32; 2]],
    /// Pairs of segments that cross in one point.
    pub crossings: &'r [[u32; 2]],
    /// The binary logarithm of a pixel's side.
    pub exponent: i32,
    /// For each segment the pixels of its chain.
    pub chains: &'r [Vec<Pixel>],
    /// The stride of segments that are compared with all hot pixels.
    pub step: usize,
}

/// The guarantees of a rounding method, besides chains that lead from end to end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Promise {
    /// Each chain has the pixels of its ends and crossings, and may cross others.
    Rounded,
    /// Each chain has the hot pixels that its segment meets, and no others; chains do not cross.
    Snapped,
    /// No edge of a chain meets a hot pixel in which it does not end; chains do not cross.
    Iterated,
}

/// A violated property of rounded drawings, with the indices of the segments that show it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Flaw {
    /// A chain does not begin and end in the pixels of its segment's ends.
    Ends(usize),
    /// A chain passes through a pixel that is not hot.
    NotHot(usize),
    /// A chain lacks a hot pixel that its segment meets.
    Missing(usize),
    /// A chain has a pixel that its segment does not meet.
    Strange(usize),
    /// A chain goes backwards along an axis, though its segment goes one way.
    Backwards(usize),
    /// Edges of the chains of two segments cross, or a vertex of one is inside an edge of the other.
    Crossing(usize, usize),
    /// An edge of a chain meets a hot pixel in which it does not end.
    Near(usize),
}

impl Flaw {
    /// The violated property, in words.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Flaw::Ends(_) => "ends",
            Flaw::NotHot(_) => "hot pixels only",
            Flaw::Missing(_) => "all hot pixels",
            Flaw::Strange(_) => "own hot pixels only",
            Flaw::Backwards(_) => "one way",
            Flaw::Crossing(..) => "no new crossing",
            Flaw::Near(_) => "no vertex near an edge",
        }
    }
}

type Point = [Rational; 2];

/// All flaws of a rounded drawing, by the guarantees of its method.
///
/// # Panics
/// If a pair of segments is parallel, or an index is out of range.
#[must_use]
pub fn flaws(rounded: Rounded<'_>, promise: Promise) -> Vec<Flaw> {
    let scale = |x: f64| Rational::from_f64(x).expect("finite") >> rounded.exponent;
    let points: Vec<Point> = rounded.points.iter().map(|point| point.map(scale)).collect();
    let segment = |at: u32| rounded.segments[at as usize].map(|v| &points[v as usize]);
    let mut hot: Vec<Pixel> = points.iter().map(pixel).collect();
    hot.extend(rounded.crossings.iter().map(|&[s, t]| pixel(&meeting(segment(s), segment(t)))));
    hot.sort_unstable();
    hot.dedup();
    let mut flaws = Vec::new();
    for (at, chain) in rounded.chains.iter().enumerate() {
        let [a, b] = rounded.segments[at].map(|v| &points[v as usize]);
        if chain.first() != Some(&pixel(a)) || chain.last() != Some(&pixel(b)) {
            flaws.push(Flaw::Ends(at));
        }
        if chain.iter().any(|pixel| hot.binary_search(pixel).is_err()) {
            flaws.push(Flaw::NotHot(at));
        }
        let ways = [0, 1].map(|axis| b[axis] >= a[axis]);
        let is_backwards = |edge: &[Pixel]| {
            (0..2).any(|axis| edge[0][axis] != edge[1][axis] && (edge[0][axis] < edge[1][axis]) != ways[axis])
        };
        if chain.windows(2).any(is_backwards) {
            flaws.push(Flaw::Backwards(at));
        }
        if at % rounded.step.max(1) != 0 {
            continue;
        }
        match promise {
            Promise::Rounded => {}
            Promise::Snapped => {
                let around = [pixel(a), pixel(b)];
                let met: Vec<Pixel> = boxed(&hot, around).filter(|&pixel| meets([a, b], pixel)).collect();
                if met.iter().any(|pixel| !chain.contains(pixel)) {
                    flaws.push(Flaw::Missing(at));
                }
                if chain.iter().any(|pixel| !met.contains(pixel)) {
                    flaws.push(Flaw::Strange(at));
                }
            }
            Promise::Iterated => {
                let is_near = |edge: &[Pixel]| {
                    let ends = [edge[0], edge[1]];
                    let line = ends.map(|pixel| pixel.map(Rational::from));
                    // The edge meets only the pixels of its ends, and all other centres are half a pixel away.
                    let mut others = boxed(&hot, ends).filter(|pixel| !ends.contains(pixel));
                    others.any(|pixel| meets([&line[0], &line[1]], pixel) || !distance2_at_least(ends, pixel, [1, 4]))
                };
                if chain.windows(2).any(is_near) {
                    flaws.push(Flaw::Near(at));
                }
            }
        }
    }
    if promise != Promise::Rounded {
        flaws.extend(crossed(rounded.chains).map(|[first, second]| Flaw::Crossing(first, second)));
    }
    flaws
}

/// The number of pairs of chain edges that cross, or in which one edge passes over an end of the other. An edge of
/// several chains counts once.
#[must_use]
pub fn new_crossings(chains: &[Vec<Pixel>]) -> usize {
    crossed(chains).count()
}

/// The pairs of edges that cross, as the first chains that contain them.
pub(crate) fn crossed(chains: &[Vec<Pixel>]) -> impl Iterator<Item = [usize; 2]> {
    let of_chain = |(at, chain): (usize, &Vec<Pixel>)| {
        let edge = move |edge: &[Pixel]| ([edge[0].min(edge[1]), edge[0].max(edge[1])], at);
        chain.windows(2).map(edge).collect::<Vec<_>>()
    };
    let mut edges: Vec<([Pixel; 2], usize)> = chains.iter().enumerate().flat_map(of_chain).collect();
    edges.sort_unstable();
    edges.dedup_by_key(|(edge, _)| *edge);
    let count = edges.len();
    (0..count).flat_map(move |first| {
        let (e, of) = edges[first];
        // Edges that begin before it ends; the list is in the order of left ends.
        let later = edges[first + 1..].iter().take_while(|(f, _)| f[0][0] <= e[1][0]);
        later.filter(|(f, _)| cross(e, *f)).map(|&(_, other)| [of, other]).collect::<Vec<_>>()
    })
}

/// The hot pixels in the box of two pixels.
fn boxed(hot: &[Pixel], [a, b]: [Pixel; 2]) -> impl Iterator<Item = Pixel> {
    let [low, high] = [[a[0].min(b[0]), a[1].min(b[1])], [a[0].max(b[0]), a[1].max(b[1])]];
    let from = hot.partition_point(|pixel| pixel[0] < low[0]);
    let columns = hot[from..].iter().take_while(move |pixel| pixel[0] <= high[0]);
    columns.copied().filter(move |pixel| (low[1]..=high[1]).contains(&pixel[1]))
}

/// The pixel of a point; its upper ends do not belong to it.
fn pixel(point: &Point) -> Pixel {
    [0, 1].map(|axis| {
        let (_, low) = (point[axis].clone() + Rational::from((1, 2))).fract_floor(rug::Integer::new());
        low.to_i64().expect("coordinates below 2^63")
    })
}

/// The intersection of two segments' lines.
pub(crate) fn meeting([a, b]: [&Point; 2], [c, d]: [&Point; 2]) -> Point {
    let [ab, cd, ac] = [[a, b], [c, d], [a, c]].map(|[p, q]| [0, 1].map(|axis| Rational::from(&q[axis] - &p[axis])));
    let turn = |p: &Point, q: &Point| Rational::from(&p[0] * &q[1]) - Rational::from(&p[1] * &q[0]);
    let t = turn(&ac, &cd) / turn(&ab, &cd);
    [0, 1].map(|axis| a[axis].clone() + Rational::from(&t * &ab[axis]))
}

/// True if a + t(b − a) is in the pixel for some t from 0 to 1.
fn meets([a, b]: [&Point; 2], pixel: Pixel) -> bool {
    // The first t and the last, each with true if it is excluded.
    let mut from = (Rational::new(), false);
    let mut to = (Rational::from(1), false);
    for axis in 0..2 {
        let half = Rational::from((1, 2));
        let [low, high] = [Rational::from(pixel[axis]) - &half, Rational::from(pixel[axis]) + &half];
        let along = Rational::from(&b[axis] - &a[axis]);
        if along.cmp0().is_eq() {
            if a[axis] < low || a[axis] >= high {
                return false;
            }
            continue;
        }
        let [low, high] = [low, high].map(|end| (end - &a[axis]) / &along);
        // Downwards, the upper end comes first, and is excluded.
        let rises = along.cmp0().is_gt();
        let (first, last) = if rises { ((low, false), (high, true)) } else { ((high, true), (low, false)) };
        if first.0 > from.0 || (first.0 == from.0 && first.1) {
            from = first;
        }
        if last.0 < to.0 || (last.0 == to.0 && last.1) {
            to = last;
        }
    }
    from.0 < to.0 || (from.0 == to.0 && !from.1 && !to.1)
}

#[cfg(test)]
mod tests;
