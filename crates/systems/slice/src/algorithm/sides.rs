//! The third and the fourth step: the sides are disconnected, and caps cover the loops in the plane.

use std::collections::BTreeMap;

use predicament_mesh::half_edge::{Face, HalfEdge, MeshVertex};
use predicament_predicates::Sign;

use super::cutter::{Cap, Cutter};
use super::{Contradiction, Halt};

impl Cutter<'_> {
    /// Finds the sides of faces that touch the plane, and divides their caps.
    pub(super) fn put_on_sides(&mut self, place: usize, touched: &[Face]) -> Result<(), Halt> {
        for &f in touched {
            let mut found = Sign::Zero;
            for v in self.mesh.vertex_loop(self.mesh.half_edge_of_face(f)) {
                let sign = self.sign(v);
                if sign * found == Sign::Negative {
                    return Err(Halt::Broken(Contradiction::OneSide));
                }
                if !sign.is_zero() {
                    found = sign;
                }
            }
            let side = if found.is_zero() { self.side_in_plane(place, f) } else { found };
            self.set_side(f, side);
        }
        let mut caps: Vec<usize> = touched.iter().filter_map(|&f| self.cap_of(f)).collect();
        caps.sort_unstable();
        caps.dedup();
        touched.iter().for_each(|&f| self.mesh.set_face_marker(f, 1));
        for cap in caps {
            self.divide_cap(cap);
        }
        touched.iter().for_each(|&f| self.mesh.set_face_marker(f, 0));
        Ok(())
    }

    fn set_side(&mut self, f: Face, side: Sign) {
        if self.sides.len() <= f.index() {
            self.sides.resize(f.index() + 1, Sign::Zero);
        }
        self.sides[f.index()] = side;
    }

    /// The side of a face in the plane: the side of the solid, opposite to the direction that the face looks.
    fn side_in_plane(&self, place: usize, f: Face) -> Sign {
        let plane = self.planes[place];
        let Some((projection, plane_turns)) = self.seen(plane) else { return Sign::Positive };
        let [a, b, c] = self.support(f);
        let face_turns = self.session.orient2d(projection, a, b, c) == Sign::Negative;
        // The plane faces its negative side, so a face with the same direction belongs to the positive side.
        if face_turns == plane_turns { Sign::Positive } else { Sign::Negative }
    }

    /// Moves the faces of a cap on the negative side to a new cap, if there are faces on both sides. Faces that touch
    /// the plane have a marker.
    fn divide_cap(&mut self, cap: usize) {
        let side = |f: &Face| match self.mesh.face_marker(*f) {
            0 => self.sign(self.mesh.end(self.mesh.half_edge_of_face(*f))),
            _ => self.sides[f.index()],
        };
        let faces = &self.caps[cap].faces;
        let (negative, others): (Vec<Face>, Vec<Face>) = faces.iter().partition(|&f| side(f) == Sign::Negative);
        if negative.is_empty() || others.is_empty() {
            return;
        }
        let Cap { plane, positive, .. } = self.caps[cap];
        self.caps[cap].faces = others;
        self.add_cap(Cap { plane, positive, faces: negative });
    }

    /// Adds a cap, and stores its index in its faces.
    fn add_cap(&mut self, cap: Cap) {
        let surface = u32::try_from(self.supports.len() + self.caps.len()).expect("fewer caps than half-edges");
        for &f in &cap.faces {
            self.mesh.set_face_user_data(f, surface);
        }
        self.caps.push(cap);
    }

    /// Cuts the mesh open along edges between faces of both sides, and covers the loops.
    pub(super) fn separate(&mut self, place: usize, touched: &[Face]) -> Result<(), Halt> {
        let mut edges = Vec::new();
        for &f in touched.iter().filter(|f| self.sides[f.index()] == Sign::Positive) {
            for h in self.mesh.loop_of(self.mesh.half_edge_of_face(f)) {
                let in_plane = [self.mesh.start(h), self.mesh.end(h)].iter().all(|&v| self.sign(v).is_zero());
                let beyond = self.mesh.face(self.mesh.opposite(h));
                if in_plane && beyond.is_some_and(|g| self.sides[g.index()] == Sign::Negative) {
                    edges.push(h);
                }
            }
        }
        let beside = self.mesh.cut_along(&edges)?;
        // A vertex of an open mesh may be divided into more fans than the edges of the cut have ends there.
        let new: Vec<MeshVertex> = self.mesh.vertices().skip(self.known_vertices()).collect();
        self.see_new_vertices(&new);
        self.cover(place, &beside)
    }

    /// Covers the boundary loops that consist of new half-edges only.
    fn cover(&mut self, place: usize, beside: &[[HalfEdge; 2]]) -> Result<(), Halt> {
        for &h in beside.as_flattened() {
            self.mesh.set_marker(h, 1);
        }
        let mut found: BTreeMap<(u32, bool), Vec<Face>> = BTreeMap::new();
        for (&h, positive) in beside.iter().flat_map(|pair| pair.iter().zip([true, false])) {
            if self.mesh.marker(h) != 1 {
                continue;
            }
            let around: Vec<HalfEdge> = self.mesh.loop_of(h).collect();
            // Loops that contain edges of an older boundary are covered after the last plane.
            let is_new = around.iter().all(|&h| self.mesh.marker(h) == 1);
            around.iter().for_each(|&h| self.mesh.set_marker(h, 0));
            if is_new {
                let f = self.mesh.cover_boundary_loop(h)?;
                self.set_side(f, if positive { Sign::Positive } else { Sign::Negative });
                let part = self.mesh.vertex_user_data(self.mesh.end(h));
                found.entry((part, positive)).or_default().push(f);
            }
        }
        for ((_, positive), faces) in found {
            self.add_cap(Cap { plane: place, positive, faces });
        }
        Ok(())
    }

    /// Divides the parts that have vertices on both sides of the current plane.
    pub(super) fn divide_parts(&mut self) {
        // For each old part, the parts that it becomes: the first side seen keeps the number.
        let mut children: Vec<[Option<u32>; 2]> = vec![[None; 2]; self.parts];
        let vertices: Vec<MeshVertex> = self.mesh.vertices().collect();
        for v in vertices {
            let side = match self.sign(v) {
                Sign::Zero => match self.mesh.ring(v).find_map(|h| self.mesh.face(h)) {
                    Some(f) => self.sides[f.index()],
                    None => continue,
                },
                sign => sign,
            };
            let part = self.mesh.vertex_user_data(v);
            let child = &mut children[part as usize];
            let side = usize::from(side == Sign::Positive);
            let number = match *child {
                [None, None] => part,
                _ => child[side].unwrap_or_else(|| {
                    self.parts += 1;
                    u32::try_from(self.parts - 1).expect("fewer parts than vertices")
                }),
            };
            child[side] = Some(number);
            self.mesh.set_vertex_user_data(v, number);
        }
    }
}
