//! Half-edge meshes as plain arrays: the form that conversions to and from other structures read and write.

use predicament_predicates::Vertex;

use super::{Face, HalfEdge, HalfEdgeMesh, MeshVertex, Violation, handles};

/// The links of a half-edge, by index.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Link {
    /// The vertex that the half-edge ends at.
    pub end: u32,
    /// The next half-edge of the loop.
    pub next: u32,
    /// The face on the left; `None` on a boundary.
    pub face: Option<u32>,
}

/// A half-edge mesh without handles, markers and user data. Half-edges 2e and 2e + 1 are the sides of edge e.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Links {
    /// The scene's vertex of each vertex.
    pub vertices: Vec<Vertex>,
    /// The half-edges, two for each edge.
    pub half_edges: Vec<Link>,
    /// The number of faces.
    pub faces: usize,
}

impl Links {
    /// The vertex that a half-edge starts at.
    ///
    /// # Panics
    /// If there is no such half-edge.
    #[must_use]
    pub fn start(&self, half_edge: u32) -> u32 {
        self.half_edges[(half_edge ^ 1) as usize].end
    }

    /// The half-edge before each one in its loop.
    ///
    /// # Panics
    /// If a half-edge links to one that is not there.
    #[must_use]
    pub fn previous(&self) -> Vec<u32> {
        let mut previous = vec![handles::NONE; self.half_edges.len()];
        for (h, link) in (0..).zip(&self.half_edges) {
            previous[link.next as usize] = h;
        }
        previous
    }
}

impl HalfEdgeMesh {
    /// The links of the mesh. Edges are in the order of their smaller handles, and vertices and faces in the order of
    /// handles.
    #[must_use]
    pub fn to_links(&self) -> Links {
        let mut place = vec![handles::NONE; self.end.len()];
        let mut order = Vec::with_capacity(self.end.len());
        for h in self.half_edges() {
            if place[h.index()] == handles::NONE {
                for side in [h, self.opposite(h)] {
                    place[side.index()] = HalfEdge::at(order.len()).0;
                    order.push(side);
                }
            }
        }
        let mut vertices = vec![handles::NONE; self.vertex_half_edge.len()];
        (0..).zip(self.vertices()).for_each(|(at, v)| vertices[v.index()] = at);
        let mut faces = vec![handles::NONE; self.face_half_edge.len()];
        (0..).zip(self.faces()).for_each(|(at, f)| faces[f.index()] = at);
        let link = |&h: &HalfEdge| Link {
            end: vertices[self.end(h).index()],
            next: place[self.next(h).index()],
            face: self.face(h).map(|f| faces[f.index()]),
        };
        Links {
            vertices: self.vertices().map(|v| self.scene_vertex(v)).collect(),
            half_edges: order.iter().map(link).collect(),
            faces: self.face_count(),
        }
    }

    /// The mesh with these links, which get handles in their order.
    ///
    /// # Errors
    /// The first invariant that the links violate.
    pub fn from_links(links: &Links) -> Result<HalfEdgeMesh, Violation> {
        let count = links.half_edges.len();
        let mut mesh = HalfEdgeMesh {
            end: links.half_edges.iter().map(|link| MeshVertex(link.end)).collect(),
            next: links.half_edges.iter().map(|link| HalfEdge(link.next)).collect(),
            opposite: (0..count).map(|h| HalfEdge::at(h ^ 1)).collect(),
            face: links.half_edges.iter().map(|link| link.face.map_or(Face::NONE, Face)).collect(),
            marker: vec![0; count],
            user_data: vec![0; count],
            face_half_edge: vec![HalfEdge::NONE; links.faces],
            face_marker: vec![0; links.faces],
            face_user_data: vec![0; links.faces],
            vertex_half_edge: vec![HalfEdge::NONE; links.vertices.len()],
            vertex_marker: vec![0; links.vertices.len()],
            vertex_user_data: vec![0; links.vertices.len()],
            scene_vertex: links.vertices.clone(),
            ..HalfEdgeMesh::default()
        };
        for (h, link) in links.half_edges.iter().enumerate().rev() {
            if let Some(first) = mesh.vertex_half_edge.get_mut(link.end as usize) {
                *first = HalfEdge::at(h);
            }
            if let Some(first) = link.face.and_then(|face| mesh.face_half_edge.get_mut(face as usize)) {
                *first = HalfEdge::at(h);
            }
        }
        mesh.validate()?;
        Ok(mesh)
    }
}
