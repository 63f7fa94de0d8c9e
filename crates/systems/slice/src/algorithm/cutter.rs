//! The mesh between two planes, and the first step: the sides of vertices, and the splitting of edges.

use std::collections::BTreeMap;

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{Face, HalfEdge, MeshVertex};
use predicament_predicates::{Axis, Construction, Plane, Predicates, Sign, Vertex};

use super::Halt;
use super::lines::{Lines, OWN_ENDS};
use super::planar::Planar;
use super::projection::{normal, seen};

/// The covered loops of one part in one plane, on one side of it.
pub(super) struct Cap {
    /// The plane's index in the list.
    pub(super) plane: usize,
    /// True if the part is on the plane's positive side.
    pub(super) positive: bool,
    /// One face for each loop, including loops around holes.
    pub(super) faces: Vec<Face>,
}

/// A mesh that planes cut one after the other.
///
/// The user data of a face is the face of the input that it is a piece of, or a cap (numbered after all faces). The
/// user data of a half-edge is its line; that of a vertex is its part.
pub(super) struct Cutter<'a> {
    pub(super) session: &'a mut dyn Predicates,
    pub(super) mesh: HalfEdgeMesh,
    /// For each face, three vertices of its plane.
    pub(super) supports: Vec<[Vertex; 3]>,
    /// For each face, the face of the input that it is a piece of.
    pub(super) faces: Vec<u32>,
    pub(super) planes: &'a [[Vertex; 3]],
    pub(super) lines: Lines,
    pub(super) caps: Vec<Cap>,
    /// For each mesh vertex, the scene's vertex.
    points: Vec<Vertex>,
    /// For each mesh vertex, its side of the current plane.
    signs: Vec<Sign>,
    /// The side of each face that touches the current plane; undefined for other faces.
    pub(super) sides: Vec<Sign>,
    /// The number of parts, including parts that later planes cut completely into other parts.
    pub(super) parts: usize,
    pub(super) faces_split: u64,
    /// True if a plane has passed through a vertex that was there before it.
    pub(super) met_vertices: bool,
    /// The names of vertices that edges without length join to others: the first one at the point.
    names: BTreeMap<Vertex, Vertex>,
}

impl<'a> Cutter<'a> {
    pub(super) fn new(session: &'a mut dyn Predicates, planar: Planar, planes: &'a [[Vertex; 3]]) -> Cutter<'a> {
        let Planar { mut mesh, supports, faces: of } = planar;
        let faces: Vec<Face> = mesh.faces().collect();
        for (face, at) in faces.into_iter().zip(0..) {
            mesh.set_face_user_data(face, at);
        }
        let mut cutter = Cutter {
            session,
            mesh,
            supports,
            faces: of,
            planes,
            lines: Lines::default(),
            caps: Vec::new(),
            points: Vec::new(),
            signs: Vec::new(),
            sides: Vec::new(),
            parts: 1,
            faces_split: 0,
            met_vertices: false,
            names: BTreeMap::new(),
        };
        let vertices: Vec<MeshVertex> = cutter.mesh.vertices().collect();
        cutter.see_new_vertices(&vertices);
        cutter
    }

    /// Splits all parts by the plane with this index.
    pub(super) fn cut(&mut self, place: usize) -> Result<(), Halt> {
        let plane = self.planes[place];
        self.session.orient3d_plane(plane, &self.points, &mut self.signs);
        self.met_vertices |= self.signs.contains(&Sign::Zero);
        self.split_edges(plane)?;
        let on_plane: Vec<MeshVertex> = self.mesh.vertices().filter(|&v| self.sign(v).is_zero()).collect();
        if on_plane.is_empty() {
            self.divide_parts();
            return Ok(());
        }
        let touched = self.split_faces(place, &on_plane)?;
        self.put_on_sides(place, &touched)?;
        self.separate(place, &touched)?;
        self.divide_parts();
        Ok(())
    }

    /// The side of a vertex on the current plane.
    #[inline]
    pub(super) fn sign(&self, v: MeshVertex) -> Sign {
        self.signs[v.index()]
    }

    /// Lists vertices that were added to the mesh, by ascending handles; they are on the current plane.
    pub(super) fn see_new_vertices(&mut self, new: &[MeshVertex]) {
        for &v in new {
            // Vertices are never removed, so handles count up.
            assert_eq!(v.index(), self.points.len());
            self.points.push(self.mesh.scene_vertex(v));
            self.signs.push(Sign::Zero);
        }
    }

    /// The name of a vertex in the parts.
    pub(super) fn name(&self, v: MeshVertex) -> Vertex {
        let v = self.mesh.scene_vertex(v);
        self.names.get(&v).copied().unwrap_or(v)
    }

    /// Gives the ends of an edge one name if it has no length.
    pub(super) fn see_length(&mut self, ends: [MeshVertex; 2]) {
        let [u, v] = ends.map(|end| self.name(end));
        if u == v || [Axis::X, Axis::Y, Axis::Z].iter().any(|&axis| !self.session.compare(axis, u, v).is_zero()) {
            return;
        }
        let (first, other) = (u.min(v), u.max(v));
        self.names.values_mut().filter(|name| **name == other).for_each(|name| *name = first);
        self.names.insert(other, first);
    }

    /// The number of vertices listed.
    pub(super) fn known_vertices(&self) -> usize {
        self.points.len()
    }

    /// One half-edge of each edge with ends on both sides.
    fn crossing_edges(&self) -> Vec<HalfEdge> {
        let mesh = &self.mesh;
        // Goes along the loops, whose half-edges are adjacent in memory.
        let crossing = mesh.half_edges().filter_map(|h| {
            let next = mesh.next(h);
            let [a, b] = [h, next].map(|h| self.sign(mesh.end(h)));
            (a != b && !a.is_zero() && !b.is_zero() && next < mesh.opposite(next)).then_some(next)
        });
        crossing.collect()
    }

    /// Splits the edges with ends on both sides; one call constructs all their points.
    fn split_edges(&mut self, plane: [Vertex; 3]) -> Result<(), Halt> {
        let edges = self.crossing_edges();
        let definitions: Vec<Construction> =
            edges.iter().map(|&h| self.lines.definition(&self.mesh, h, plane)).collect();
        let vertices = self.session.construct(&definitions)?;
        for (h, vertex) in edges.into_iter().zip(vertices) {
            self.split_edge(h, vertex)?;
        }
        Ok(())
    }

    /// Splits an edge; both halves keep its line.
    fn split_edge(&mut self, h: HalfEdge, vertex: Vertex) -> Result<(), Halt> {
        let line = match (self.mesh.user_data(h), self.lines.of(&self.mesh, h)) {
            (OWN_ENDS, line) => self.lines.add(line),
            (place, _) => place,
        };
        let part = self.mesh.vertex_user_data(self.mesh.start(h));
        let v = self.mesh.split_edge(h, vertex)?;
        for half in [h, self.mesh.next(h)] {
            let opposite = self.mesh.opposite(half);
            self.mesh.set_user_data(half, line);
            self.mesh.set_user_data(opposite, line);
        }
        self.mesh.set_vertex_user_data(v, part);
        self.see_new_vertices(&[v]);
        Ok(())
    }

    /// The cap that a face belongs to; `None` for a piece of a face of the input.
    pub(super) fn cap_of(&self, f: Face) -> Option<usize> {
        (self.mesh.face_user_data(f) as usize).checked_sub(self.supports.len())
    }

    /// Three vertices of a face's plane, which turn as the face does.
    pub(super) fn support(&self, f: Face) -> [Vertex; 3] {
        let Some(cap) = self.cap_of(f) else { return self.supports[self.mesh.face_user_data(f) as usize] };
        let Cap { plane, positive, .. } = self.caps[cap];
        let [a, b, c] = self.planes[plane];
        // On the positive side the three are seen clockwise, and a cap faces away from its part.
        if positive { [a, b, c] } else { [a, c, b] }
    }

    /// Calls [`seen`] with the session.
    pub(super) fn seen(&self, support: [Vertex; 3]) -> Option<(Plane, bool)> {
        seen(&*self.session, support)
    }

    /// Calls [`normal`] with the session's scene.
    pub(super) fn normal(&self, plane: [Vertex; 3]) -> [f64; 3] {
        normal(self.session.scene(), plane)
    }
}
