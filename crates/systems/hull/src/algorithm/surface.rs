//! The triangulated surface of a hull under insertion, with its conflict graph: the vertices outside of each triangle.
//!
//! Each vertex that is not yet known to be inside has a seat at one triangle that it is outside of. When triangles are
//! replaced, their vertices either get a seat at a new triangle or are inside. Proof: take the segment from a vertex
//! outside of a replaced triangle to a point of that triangle, which is inside the new hull. The segment enters the new
//! hull through a new triangle.

use super::Contradiction;
use predicament_predicates::{Predicates, Sign, Vertex};

use super::scratch::{NONE, Scratch};

/// The minimum number of vertices for which a batch is cheaper than single queries.
const FEW: usize = 4;

/// A triangle: its corners counterclockwise as seen from outside, and its neighbours across the edges that begin at
/// each corner.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    corners: [Vertex; 3],
    near: [u32; 3],
}

/// A closed surface of triangles.
pub(super) struct Surface<'s> {
    session: &'s dyn Predicates,
    scratch: &'s mut Scratch,
    triangles: Vec<Triangle>,
    /// The vertices with a seat at each triangle.
    outside: Vec<Vec<Vertex>>,
    /// The last step that looked at each triangle, times two, plus one if the triangle was visible then.
    seen: Vec<u32>,
    step: u32,
    free: Vec<u32>,
    // Kept from step to step to reuse the memory.
    visible: Vec<u32>,
    horizon: Vec<Horizon>,
    pending: Vec<Vertex>,
    signs: Vec<Sign>,
    made: Vec<u32>,
}

/// An edge between a visible and an invisible triangle, in the direction of the visible one.
#[derive(Clone, Copy, Debug)]
struct Horizon {
    from: Vertex,
    to: Vertex,
    beyond: u32,
    /// The index of the edge in that triangle.
    edge: usize,
}

impl<'s> Surface<'s> {
    /// The tetrahedron of four vertices, the last of which is below the plane of the others, with the remaining
    /// vertices outside of it.
    pub fn tetrahedron(
        session: &'s dyn Predicates,
        scratch: &'s mut Scratch,
        [a, b, c, d]: [Vertex; 4],
        vertices: &[Vertex],
    ) -> Surface<'s> {
        let corners = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]];
        // Across ab, bc, ca; then across the edges that begin at each corner of the sides.
        let near = [[1, 2, 3], [3, 2, 0], [1, 3, 0], [2, 1, 0]];
        let triangles = corners.into_iter().zip(near).map(|(corners, near)| Triangle { corners, near }).collect();
        let pending = vertices.iter().copied().filter(|v| ![a, b, c, d].contains(v)).collect();
        let mut surface = Surface {
            session,
            scratch,
            triangles,
            outside: vec![Vec::new(); 4],
            seen: vec![0; 4],
            step: 1,
            free: Vec::new(),
            visible: Vec::new(),
            horizon: Vec::new(),
            pending,
            signs: Vec::new(),
            made: vec![0, 1, 2, 3],
        };
        surface.seat();
        surface
    }

    /// True if the vertex is known to be outside.
    pub fn is_outside(&self, v: Vertex) -> bool {
        self.scratch.seat[v.index()] != NONE
    }

    /// The triangles by their corners, and their neighbours as indices of the same list.
    pub fn triangles(&self) -> (Vec<[Vertex; 3]>, Vec<[u32; 3]>) {
        let mut places = vec![0; self.triangles.len()];
        self.free.iter().for_each(|&at| places[at as usize] = NONE);
        let mut next = 0;
        for place in &mut places {
            if *place != NONE {
                *place = next;
                next += 1;
            }
        }
        let alive = self.triangles.iter().zip(&places).filter(|&(_, &place)| place != NONE);
        alive.map(|(triangle, _)| (triangle.corners, triangle.near.map(|near| places[near as usize]))).unzip()
    }

    /// Inserts a vertex that is outside: replaces the triangles that it sees by triangles that join it to their
    /// horizon.
    ///
    /// # Errors
    /// If an invariant does not hold; the error names it. The surface is then unchanged.
    pub fn insert(&mut self, v: Vertex) -> Result<(), Contradiction> {
        let first = self.scratch.seat[v.index()];
        if first == NONE {
            return Ok(());
        }
        self.look(v, first);
        self.check_horizon()?;
        self.pending.clear();
        for &at in &self.visible {
            self.pending.append(&mut self.outside[at as usize]);
        }
        self.pending.retain(|&w| w != v);
        self.scratch.seat[v.index()] = NONE;
        self.replace(v);
        self.seat();
        Ok(())
    }

    /// Finds the triangles that the vertex sees, starting from one of them, and their horizon.
    fn look(&mut self, v: Vertex, first: u32) {
        let Surface { session, triangles, seen, visible, horizon, .. } = self;
        self.step += 1;
        let [hidden, clear] = [2 * self.step, 2 * self.step + 1];
        visible.clear();
        horizon.clear();
        visible.push(first);
        seen[first as usize] = clear;
        let mut next = 0;
        while let Some(&at) = visible.get(next) {
            next += 1;
            let Triangle { corners, near } = triangles[at as usize];
            for (edge, &beyond) in near.iter().enumerate() {
                let other = &triangles[beyond as usize];
                let state = &mut seen[beyond as usize];
                if *state < hidden {
                    let [a, b, c] = other.corners;
                    let is_visible = session.orient3d(a, b, c, v) == Sign::Negative;
                    *state = if is_visible { clear } else { hidden };
                    if is_visible {
                        visible.push(beyond);
                    }
                }
                if *state == hidden {
                    let [from, to] = [corners[edge], corners[(edge + 1) % 3]];
                    // The edge begins at the end of this one.
                    let edge = other.corners.iter().position(|&corner| corner == to).unwrap_or(0);
                    horizon.push(Horizon { from, to, beyond, edge });
                }
            }
        }
    }

    /// Orders the horizon; an error if it is not a single loop.
    fn check_horizon(&mut self) -> Result<(), Contradiction> {
        let Surface { scratch, horizon, .. } = self;
        let spoke = &mut scratch.spoke;
        if horizon.is_empty() {
            return Err(Contradiction::Sees);
        }
        let mut is_simple = true;
        for (edge, at) in horizon.iter().zip(0..) {
            is_simple &= std::mem::replace(&mut spoke[edge.from.index()], at) == NONE;
        }
        let mut at = 0;
        let mut length = 0;
        while is_simple {
            let Some(edge) = horizon.get(at as usize) else {
                is_simple = false;
                break;
            };
            at = spoke[edge.to.index()];
            length += 1;
            if at == 0 || length > horizon.len() {
                break;
            }
        }
        let is_loop = is_simple && length == horizon.len() && length >= 3;
        horizon.iter().for_each(|edge| spoke[edge.from.index()] = NONE);
        if is_loop { Ok(()) } else { Err(Contradiction::Horizon) }
    }

    /// Replaces the visible triangles by triangles that join the vertex to the horizon.
    fn replace(&mut self, v: Vertex) {
        let Surface { triangles, outside, seen, free, visible, horizon, made, scratch, .. } = self;
        made.clear();
        free.extend(visible.iter());
        for edge in horizon.iter() {
            let triangle = Triangle { corners: [edge.from, edge.to, v], near: [edge.beyond, NONE, NONE] };
            let at = match free.pop() {
                Some(at) => {
                    triangles[at as usize] = triangle;
                    at
                }
                None => {
                    triangles.push(triangle);
                    outside.push(Vec::new());
                    seen.push(0);
                    u32::try_from(triangles.len() - 1).unwrap_or(NONE)
                }
            };
            triangles[edge.beyond as usize].near[edge.edge] = at;
            scratch.spoke[edge.from.index()] = at;
            made.push(at);
        }
        for (edge, &at) in horizon.iter().zip(made.iter()) {
            let after = scratch.spoke[edge.to.index()];
            triangles[at as usize].near[1] = after;
            triangles[after as usize].near[2] = at;
        }
        horizon.iter().for_each(|edge| scratch.spoke[edge.from.index()] = NONE);
    }

    /// Seats each pending vertex at the first new triangle that it is outside of; a vertex without a seat is inside.
    fn seat(&mut self) {
        let Surface { session, triangles, outside, pending, signs, made, scratch, .. } = self;
        for &at in made.iter() {
            if pending.is_empty() {
                return;
            }
            let [a, b, c] = triangles[at as usize].corners;
            signs.clear();
            if pending.len() < FEW {
                signs.extend(pending.iter().map(|&v| session.orient3d(a, b, c, v)));
            } else {
                signs.resize(pending.len(), Sign::Zero);
                session.orient3d_plane([a, b, c], pending, signs);
            }
            let seated = &mut outside[at as usize];
            let mut left = 0;
            for place in 0..pending.len() {
                let v = pending[place];
                if signs[place] == Sign::Negative {
                    scratch.seat[v.index()] = at;
                    seated.push(v);
                } else {
                    pending[left] = v;
                    left += 1;
                }
            }
            pending.truncate(left);
        }
        pending.iter().for_each(|v| scratch.seat[v.index()] = NONE);
        pending.clear();
    }
}
