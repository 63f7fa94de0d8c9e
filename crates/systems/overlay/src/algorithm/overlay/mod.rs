//! Arrangements of segments in the plane, and the Boolean operations on polygons that use them.
//!
//! # Steps
//! 1. Edges are grouped by the *input segments* that they are on. All later steps use input segments, each once.
//! 2. Pairs that meet where edges reach are found, by a [grid](predicament_grid::Raster) or by Bentley and Ottmann's
//!    sweep: the [`Method`].
//! 3. Crossings are constructed, in the order of the segments. Each is defined by two input segments, whatever was
//!    constructed before: coordinates do not grow from one overlay to the next.
//! 4. The vertices on each segment are sorted along it. Vertices at one position become one node: many segments through
//!    one point have one node there, if the session says that the points are equal.
//! 5. The order around nodes makes cycles, and rays from the leftmost nodes of components make faces of them.
//! 6. Winding numbers propagate from face to face, by the number of times that each operand passes the edge between
//!    them. The faces inside a result make its regions.
//!
//! # What is allowed
//! Everything: segments may be repeated, overlap, touch and cross in any number in one point, be vertical or have no
//! length; loops may cross themselves. A session that never returns zero sees only repeated vertices. For it, touching
//! segments cross or do not, vertices at one position are apart, and k segments through a point cross k·(k − 1)/2
//! times.
//!
//! # Memory
//! Memory is linear in segments and crossings. Segments through one point are entries of that point, not pairs, if the
//! session sees that it is one point. More than 2^24 crossings are refused.
//!
//! # Threads
//! Large scenes use all threads. Each thread works on cells, segments, nodes or loops of its own, and their lists are
//! joined in order: results do not depend on the number of threads. One thread groups edges, constructs crossings, cuts
//! segments at nodes, numbers cycles, and passes winding numbers on.
//!
//! # Wrong signs
//! Each loop of the program ends after a number of steps that follows from the input. `broken` names the first rule
//! that signs break.

mod along;
mod cells;
mod chains;
mod contradiction;
mod far;
mod groups;
mod heap;
mod lonely;
mod meet;
mod nest;
mod partial;
mod polygon;
mod reach;
mod result;
mod sides;
mod supports;
mod sweep;
mod view;

use predicament_grid::Raster;
use predicament_mesh::Subdivision;
use predicament_predicates::{Predicates, Refused, Scene, Vertex};

pub use crate::answer::Operation;
pub use chains::Piece;
pub use contradiction::Contradiction;
pub use polygon::{Edge, Polygon, Region, Rule};
pub use result::Regions;
pub use sides::{Known, Lines};

use along::OnSegments;
use chains::Chains;
use far::Run;
use meet::Meetings;
use nest::Pieces;
use reach::Reach;
use supports::{Label, Supports};

/// The index that refers to nothing.
const NONE: u32 = u32::MAX;

/// The method to find segments that meet.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Method {
    /// A grid: segments in one cell are compared.
    #[default]
    Grid,
    /// A sweep: a line moves over the plane from left to right, and neighbours on it are compared (Bentley and Ottmann
    /// 1979).
    Sweep,
}

/// An arrangement of segments: nodes, the pieces between them, and faces.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Arrangement {
    /// The vertex of each node: input vertices by index, then constructed ones by definition. For vertices at one
    /// position it is the first of these.
    pub vertices: Vec<Vertex>,
    /// The segments as pairs of ends, the lower id first; ascending, each once.
    pub segments: Vec<[Vertex; 2]>,
    /// The nodes on each segment in order, segment after segment.
    along: Vec<u32>,
    first: Vec<u32>,
    /// The parts of segments between consecutive nodes, in the order of the segments.
    pub pieces: Vec<Piece>,
    /// The runs; the last pieces stand for them, in the same order.
    runs: Vec<Run>,
    /// The subdivision whose edges are the pieces.
    pub subdivision: Subdivision,
    /// The first rule that signs break.
    pub broken: Option<Contradiction>,
}

impl Arrangement {
    /// The nodes on a segment, in the order from its lower vertex to the other.
    #[must_use]
    pub fn chain(&self, segment: usize) -> &[u32] {
        &self.along[self.first[segment] as usize..self.first[segment + 1] as usize]
    }
}

/// The arrangement of two polygons' edges, with their winding numbers in each face.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Overlay {
    /// The arrangement.
    pub arrangement: Arrangement,
    /// The winding numbers of each face, for each operand; 0 and 1 if its rule is even-odd.
    pub windings: Vec<[i32; 2]>,
    rules: [Rule; 2],
}

impl Overlay {
    /// The regions of the result of an operation.
    #[must_use]
    pub fn regions(&self, operation: Operation) -> Regions {
        self.beside(operation, None)
    }

    /// The regions of a result that has other regions in a scene besides.
    fn beside(&self, operation: Operation, apart: Option<(&Scene, &[Region])>) -> Regions {
        self.arrangement.extraction(&self.windings, self.rules, apart).regions(operation)
    }
}

/// Computes the arrangement of edges.
///
/// # Errors
/// [`Refused`] if the session does not construct a crossing, or if there are too many.
///
/// # Panics
/// If the support of an edge is not an input segment of a 2D scene, or there are 2^30 edges or more.
pub fn arrange(session: &mut dyn Predicates, edges: &[Edge], method: Method) -> Result<Arrangement, Refused> {
    let edges: Vec<(Edge, usize)> = edges.iter().map(|&edge| (edge, 0)).collect();
    let supports = Supports::new(&*session, &edges, |_| false);
    arranged(session, supports, Vec::new(), method)
}

/// Constructs the crossings that [`arrange`] constructs, and nothing else.
///
/// # Errors
/// As [`arrange`].
///
/// # Panics
/// As [`arrange`].
pub fn cross(session: &mut dyn Predicates, edges: &[Edge], method: Method) -> Result<(), Refused> {
    let edges: Vec<(Edge, usize)> = edges.iter().map(|&edge| (edge, 0)).collect();
    let supports = Supports::new(&*session, &edges, |_| false);
    let (reach, _, meetings, _) = met(session, &supports, method)?;
    OnSegments::new(session, &supports, &reach, meetings).map(|_| ())
}

/// Computes the overlay of two polygons.
///
/// Edges that a polygon passes equally often in both directions cancel before anything is compared: to dissolve a map
/// costs only as much as its outer borders.
///
/// # Errors
/// As [`arrange`].
///
/// # Panics
/// As [`arrange`].
pub fn overlay(session: &mut dyn Predicates, operands: [&Polygon; 2], method: Method) -> Result<Overlay, Refused> {
    let rules = operands.map(|polygon| polygon.rule);
    let mut edges: Vec<(Edge, usize)> =
        Vec::with_capacity(operands.iter().flat_map(|polygon| &polygon.loops).map(Vec::len).sum());
    for (operand, polygon) in operands.into_iter().enumerate() {
        edges.extend(polygon.loops.iter().flatten().map(|&edge| (edge, operand)));
    }
    let supports = supported(&*session, &edges, rules);
    drop(edges);
    overlaid(session, supports, Vec::new(), rules, method)
}

/// The result of an operation on two polygons: the same as by [`overlay`], but edges that meet nothing are copied.
///
/// # Errors
/// As [`arrange`].
///
/// # Panics
/// As [`arrange`].
pub fn operate(
    session: &mut dyn Predicates,
    operands: [&Polygon; 2],
    operation: Operation,
    method: Method,
) -> Result<Regions, Refused> {
    let rules = operands.map(|polygon| polygon.rule);
    let divided = lonely::divide(&*session, operands);
    let made = match divided.map(|(edges, runs)| (supported(&*session, &edges, rules), runs)) {
        // Without the edges that cancel, the leftmost vertex of a component may be inside a run.
        Some((supports, runs)) if supports.are_all => overlaid(session, supports, runs, rules, method)?,
        _ => overlay(session, operands, method)?,
    };
    let mut result = made.regions(operation);
    result.broken = made.arrangement.broken.or(result.broken);
    Ok(result)
}

/// The result of an operation on an earlier result and a polygon: the same as by [`overlay`], but without comparing
/// edges of the first operand that are off the box of the second.
///
/// The part of the first operand outside that box does not change. This requires that its edges meet in vertices only,
/// as those of results do.
///
/// # Errors
/// As [`arrange`].
///
/// # Panics
/// As [`arrange`].
pub fn combine(
    session: &mut dyn Predicates,
    first: &[Region],
    second: &Polygon,
    operation: Operation,
    method: Method,
) -> Result<Regions, Refused> {
    combine_next(session, &mut Known::default(), first, second, operation, method)
}

/// As [`combine`], for several operations in one session: positions stay known from one to the next.
///
/// # Errors
/// As [`arrange`].
///
/// # Panics
/// As [`arrange`].
pub fn combine_next(
    session: &mut dyn Predicates,
    known: &mut Known,
    first: &[Region],
    second: &Polygon,
    operation: Operation,
    method: Method,
) -> Result<Regions, Refused> {
    let far::Split { near, runs, apart } = far::split(&*session, known, first, second);
    let edges = near.into_iter().map(|edge| (edge, 0));
    let edges: Vec<(Edge, usize)> = edges.chain(second.loops.iter().flatten().map(|&edge| (edge, 1))).collect();
    let rules = [Rule::NonZero, second.rule];
    let supports = supported(&*session, &edges, rules);
    drop(edges);
    let made = overlaid(session, supports, runs, rules, method)?;
    let apart = if operation.holds([true, false]) { apart } else { Vec::new() };
    let mut result = made.beside(operation, Some((session.scene(), &apart)));
    result.broken = made.arrangement.broken.or(result.broken);
    result.regions.extend(apart);
    result.regions.sort_unstable();
    Ok(result)
}

/// Groups edges, each of one of two operands, without those that cancel.
fn supported(session: &dyn Predicates, edges: &[(Edge, usize)], rules: [Rule; 2]) -> Supports {
    let is_idle = |label: Label| {
        (0..2).all(|operand| match rules[operand] {
            Rule::EvenOdd => label[operand] % 2 == 0,
            Rule::NonZero => label[operand] == 0,
        })
    };
    Supports::new(session, edges, is_idle)
}

/// Overlays edges of two operands, and runs of them.
fn overlaid(
    session: &mut dyn Predicates,
    supports: Supports,
    runs: Vec<Run>,
    rules: [Rule; 2],
    method: Method,
) -> Result<Overlay, Refused> {
    let mut arrangement = arranged(session, supports, runs, method)?;
    let (windings, agree) = result::windings(&arrangement.subdivision, &arrangement.pieces, rules);
    if !agree {
        arrangement.broken.get_or_insert(Contradiction::Windings);
    }
    Ok(Overlay { arrangement, windings, rules })
}

fn arranged(
    session: &mut dyn Predicates,
    supports: Supports,
    runs: Vec<Run>,
    method: Method,
) -> Result<Arrangement, Refused> {
    let (reach, raster, meetings, mut broken) = met(session, &supports, method)?;
    let chains = Chains::new(session, &supports, &reach, meetings, runs)?;
    broken = broken.or(chains.broken);
    let pieces = Pieces::new(&*session, &supports, &chains);
    let subdivision = pieces.subdivision();
    let nestings = pieces.nestings(&subdivision, raster, &reach);
    let (subdivision, all_known) = subdivision.with_faces(&nestings);
    if !all_known {
        broken.get_or_insert(Contradiction::Component);
    }
    let Chains { nodes, first, along, pieces, runs, .. } = chains;
    Ok(Arrangement { vertices: nodes, segments: supports.ends, along, first, pieces, runs, subdivision, broken })
}

/// The parts of segments, the grid if there is one, what meets, and the first rule that signs break.
fn met(
    session: &mut dyn Predicates,
    supports: &Supports,
    method: Method,
) -> Result<(Reach, Option<Raster>, Meetings, Option<Contradiction>), Refused> {
    let reach = Reach::new(&*session, supports);
    match method {
        Method::Grid => {
            let raster = Raster::new(&reach.raw);
            let meetings = cells::meetings(session, &raster, &reach, &supports.ends)?;
            Ok((reach, Some(raster), meetings, None))
        }
        Method::Sweep => {
            let (meetings, broken) = sweep::meetings(session, &supports.ends)?;
            Ok((reach, None, meetings, broken))
        }
    }
}

/// An index as it is stored: all counts here are below 2^32.
#[inline]
fn number(place: usize) -> u32 {
    u32::try_from(place).expect("fewer than 2^32 of anything")
}
