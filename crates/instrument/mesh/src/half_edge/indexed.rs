//! Faces as lists of vertex indices, in two arrays.

use predicament_predicates::Vertex;

use super::{Face, HalfEdgeMesh, handles};

/// Polygons as indices into a list of vertices, with all corners in one array.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct IndexedFaces {
    corners: Vec<u32>,
    /// The end of each face in `corners`.
    ends: Vec<usize>,
}

impl IndexedFaces {
    /// Appends a face by its corners, counterclockwise as seen from outside.
    pub fn push(&mut self, corners: impl IntoIterator<Item = u32>) {
        self.corners.extend(corners);
        self.ends.push(self.corners.len());
    }

    /// The number of faces.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// True if there are no faces.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The corners of all faces, one face after the other.
    #[must_use]
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// The corners of each face.
    pub fn iter(&self) -> impl Iterator<Item = &[u32]> + Clone + '_ {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.corners[start..end])
    }
}

impl<F: IntoIterator<Item = u32>> FromIterator<F> for IndexedFaces {
    fn from_iter<I: IntoIterator<Item = F>>(faces: I) -> IndexedFaces {
        let mut all = IndexedFaces::default();
        faces.into_iter().for_each(|face| all.push(face));
        all
    }
}

impl HalfEdgeMesh {
    /// The vertices, including those without edges, and the faces as indices into the vertices; both in the order of
    /// handles. A face begins with the vertex where its half-edge starts.
    ///
    /// [`HalfEdgeMesh::new`] rebuilds an equal mesh from these, except for the order of fans at pinched vertices,
    /// markers and user data. Wires are in no face and not listed. It refuses faces that visit a vertex twice, which
    /// auxiliary edges make.
    #[must_use]
    pub fn to_indexed(&self) -> (Vec<Vertex>, IndexedFaces) {
        let mut places = vec![handles::NONE; self.vertex_half_edge.len()];
        let mut vertices = Vec::with_capacity(self.vertex_count());
        for (place, v) in (0..).zip(self.vertices()) {
            places[v.index()] = place;
            vertices.push(self.scene_vertex(v));
        }
        let mut faces = IndexedFaces::default();
        for f in self.faces() {
            faces.push(self.loop_of(self.half_edge_of_face(f)).map(|h| places[self.start(h).index()]));
        }
        (vertices, faces)
    }

    /// The vertices and the triangles as indices into the vertices, as [`to_indexed`](HalfEdgeMesh::to_indexed).
    ///
    /// # Errors
    /// The first face that is not a triangle.
    pub fn to_triangles(&self) -> Result<(Vec<Vertex>, Vec<[u32; 3]>), Face> {
        let (vertices, faces) = self.to_indexed();
        let triangle = |(f, corners): (Face, &[u32])| corners.try_into().map_err(|_| f);
        Ok((vertices, self.faces().zip(faces.iter()).map(triangle).collect::<Result<_, _>>()?))
    }
}
