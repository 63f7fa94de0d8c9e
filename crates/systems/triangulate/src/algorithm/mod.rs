//! Triangles of polygons with holes, by ear clipping and by a plane sweep.
//!
//! A polygon is a set of loops of vertices, seen in a coordinate plane. The inside is on the left of every loop: outer
//! loops are counterclockwise, holes clockwise, and islands in holes are outer loops again. Loops that come in any
//! orientation are turned by [`oriented`] first, which finds how they nest. A polygon in space is seen in a coordinate plane
//! that [`projection`] chooses.
//!
//! Vertices may be constructed ones: only `compare` and `orient2d` are asked. Coordinates of input vertices serve to put
//! them in order before signs do, and to find vertices near an ear.
//!
//! # What is allowed
//! * Loops may touch in vertices, themselves or others, whether the vertex is the same or another one at the same place. The
//!   links between corners at one place are changed so that each walk follows one part of the inside.
//! * Two loops may have an edge in common, one on each side of it.
//! * A vertex may be on an edge of another loop, or of the same.
//! * Vertices may be repeated in a row, and be in line.
//! * Loops must not cross.
//!
//! # What is made
//! Each triangle is counterclockwise, as the loops are. A loop's edge is the side of one triangle, in the loop's
//! direction; any other side of a triangle is that of another one in the other direction. So there are n + 2h − 2c triangles for n
//! vertices, h holes and c outer loops, and two fewer for each loop more that passes through one vertex from inside another.
//!
//! # Zero
//! Order along the sweep: by the first coordinate, then by the second; what is still equal is at one place. So no edge is
//! vertical. Three vertices in line make no ear and are not cut off from a chain. A triangle has no area only
//! * at an edge whose ends are at one place, and where loops touch in different vertices at one place: an edge without
//!   length is a side of it;
//! * where a vertex is on an edge: the edge and that vertex make the triangle.
//!
//! A corner on an edge's line is on the side on which its neighbours are. Sessions that never say zero take the same way; for
//! them a loop that touches another one may cross it, and what comes then is said by `broken`, or by the triangles.
//!
//! # Wrong signs
//! Each loop of the program is bounded by a number that follows from the input. The sweep makes triangles with the right
//! sides whatever it is told, but they may overlap. The first rule that signs break is named by
//! [`Triangulation::broken`].

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

/// The number that names nothing.
const NONE: u32 = u32::MAX;

/// How a polygon is triangulated.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Method {
    /// Ears are cut off one after the other, holes joined by auxiliary edges first: quadratic at worst.
    Ears,
    /// Monotone chains are cut up during a plane sweep: n·log n.
    #[default]
    Monotone,
}

/// Triangles of a polygon.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Triangulation {
    /// By the vertices of the loops, counterclockwise in the plane as it is seen.
    pub triangles: Vec<[Vertex; 3]>,
    /// The first rule that the signs, or the loops, have broken.
    pub broken: Option<Contradiction>,
}

/// Where triangles go.
#[derive(Default)]
struct Output {
    made: Triangulation,
}

impl Output {
    fn triangle(&mut self, triangle: [Vertex; 3]) {
        self.made.triangles.push(triangle);
    }

    /// A triangle without area; where two corners are one vertex, it has no sides either.
    fn flat(&mut self, [a, b, c]: [Vertex; 3]) {
        if a != b && b != c && a != c {
            self.triangle([a, b, c]);
        }
    }

    fn broken(&mut self, rule: Contradiction) {
        self.made.broken.get_or_insert(rule);
    }
}

/// Triangulates what the loops bound in a coordinate plane: `Plane::Xy` of a 2D scene, any of a 3D scene. `reversed` says
/// that what is counterclockwise in the plane is clockwise as seen from outside.
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

/// The corners of all loops, those at one place untangled; none where they cannot be numbered.
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

/// A place in an array as it is stored: there are fewer than 2^32 of anything here.
fn number(place: usize) -> u32 {
    u32::try_from(place).unwrap_or(NONE)
}
