//! Triangulation of polygons with holes, by ear clipping and by a plane sweep.
//!
//! A polygon is a set of loops of vertices, seen in a coordinate plane. The inside is on the left of every loop: outer
//! loops are counterclockwise, holes clockwise, and islands in holes are outer loops again. [`oriented`] turns loops of
//! any orientation; it finds how the loops nest. [`projection`] chooses the coordinate plane for a polygon in space.
//!
//! Vertices may be constructed: the only predicates are `compare` and `orient2d`. Coordinates of input vertices serve
//! to sort them before signs do, and to find vertices near an ear.
//!
//! # What is allowed
//! * Loops may touch in vertices: another loop or themselves, in the same vertex or in different vertices at one
//!   position. The links between corners at one position change so that each walk follows one part of the inside.
//! * Two loops may have an edge in common, one on each side of it.
//! * A vertex may be on an edge of another loop, or of the same loop.
//! * Vertices may be repeated in a row, and be in line.
//! * Loops must not cross.
//!
//! # What is made
//! Each triangle is counterclockwise, as the loops are. A loop's edge is the side of one triangle, in the loop's
//! direction. Any other side of a triangle is also a side of another triangle, in the other direction. So there are n +
//! 2h − 2c triangles for n vertices, h holes and c outer loops, and two fewer for each further loop that passes through
//! one vertex from inside another loop.
//!
//! # Zero
//! The order along the sweep is by the first coordinate, then by the second; vertices that are still equal are at one
//! position. So no edge is vertical. Three vertices in line are not an ear, and the sweep does not cut them off a
//! chain. A triangle has no area in two cases only:
//! * at an edge whose ends are at one position, and where loops touch in different vertices at one position: an edge
//!   without length is a side of the triangle;
//! * where a vertex is on an edge: the edge and that vertex make the triangle.
//!
//! A corner on an edge's line counts as on the side of its neighbours. Sessions that never return zero run the same
//! code. Under such a session, a loop that touches another loop may cross it; then `broken`, or the triangles, show it.
//!
//! # Wrong signs
//! A number that follows from the input bounds each loop of the program. The sweep makes triangles with the right sides
//! whatever the signs are, but the triangles may overlap. [`Triangulation::broken`] names the first rule that signs
//! break.

mod contradiction;
mod corners;
mod ears;
mod few;
mod nesting;
mod projection;
mod reflex;
mod sweep;
mod view;

use predicament_predicates::{Plane, Predicates, Vertex};

pub use contradiction::Contradiction;
pub use few::{MOST, triangulate_few};
pub use nesting::oriented;
pub use projection::projection;

use corners::Corners;
use view::View;

/// The index that refers to nothing.
const NONE: u32 = u32::MAX;

/// The method of triangulation.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Method {
    /// Ear clipping, after auxiliary edges have joined the holes: quadratic at worst.
    Ears,
    /// A plane sweep that cuts up monotone chains: n·log n.
    #[default]
    Monotone,
}

/// The triangles of a polygon.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Triangulation {
    /// The triangles as vertices of the loops, counterclockwise in the plane as it is seen.
    pub triangles: Vec<[Vertex; 3]>,
    /// The first rule that the signs or the loops break.
    pub broken: Option<Contradiction>,
}

/// The triangles and the first broken rule, while an algorithm runs.
#[derive(Default)]
struct Output {
    made: Triangulation,
}

impl Output {
    fn triangle(&mut self, triangle: [Vertex; 3]) {
        self.made.triangles.push(triangle);
    }

    /// Adds a triangle without area; if two of its corners are one vertex, it has no sides either.
    fn flat(&mut self, [a, b, c]: [Vertex; 3]) {
        if a != b && b != c && a != c {
            self.triangle([a, b, c]);
        }
    }

    fn broken(&mut self, rule: Contradiction) {
        self.made.broken.get_or_insert(rule);
    }
}

/// Triangulates the region that the loops bound in a coordinate plane: `Plane::Xy` of a 2D scene, any plane of a 3D
/// scene. `reversed` means that counterclockwise in the plane is clockwise as seen from outside.
///
/// The inside is on the left of every loop, as seen from outside. The triangles have the loops' direction.
pub fn triangulate<P: Predicates + ?Sized>(
    session: &P,
    plane: Plane,
    reversed: bool,
    loops: &[Vec<Vertex>],
    method: Method,
) -> Triangulation {
    let mut out = Output::default();
    let view = View::new(session, plane, reversed);
    let Some(corners) = corners(&view, loops, &mut out) else { return out.made };
    out.made.triangles.reserve(corners.vertex.len());
    match method {
        Method::Monotone => sweep::triangulate(&view, &corners, &mut out),
        Method::Ears => ears::triangulate(&view, &corners, &mut out),
    }
    out.made
}

/// The corners of all loops, untangled at each position; `None` if there are too many to number.
fn corners<P: Predicates + ?Sized>(view: &View<'_, P>, loops: &[Vec<Vertex>], out: &mut Output) -> Option<Corners> {
    let is_short = |one: &Vec<Vertex>| one.len() < 3;
    if loops.iter().any(is_short) {
        out.broken(Contradiction::Loop);
    }
    if loops.iter().map(Vec::len).sum::<usize>() >= NONE as usize / 4 {
        out.broken(Contradiction::TooMany);
        return None;
    }
    let mut corners = if loops.iter().any(is_short) {
        let long: Vec<Vec<Vertex>> = loops.iter().filter(|one| !is_short(one)).cloned().collect();
        Corners::new(view, &long)
    } else {
        Corners::new(view, loops)
    };
    if corners.has_repeats() {
        corners.join_repeats(out);
        corners.untangle(view, out);
    }
    Some(corners)
}

/// An index as it is stored: all counts here are below 2^32.
fn number(place: usize) -> u32 {
    u32::try_from(place).unwrap_or(NONE)
}
