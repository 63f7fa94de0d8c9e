//! Builds half-edge meshes from indexed faces, in linear time.
//!
//! Half-edges that may be opposite have the same smaller end. A counting sort groups half-edges by smaller end; within
//! one group, an array indexed by the larger end finds the opposite. The code uses no hash table, and the order of the
//! faces determines every handle.

use predicament_predicates::Vertex;

use super::handles::NONE;
use super::{ConversionError, Face, HalfEdge, HalfEdgeMesh, IndexedFaces, MeshVertex};

/// The mark in the array by larger ends for an edge that has both of its half-edges.
const PAIRED: u32 = NONE - 1;
/// The mark in the array of boundary half-edges by start for a vertex where several start.
const PINCHED: u32 = NONE - 1;
/// The number of rings that are walked alternately.
const RINGS: usize = 16;

impl HalfEdgeMesh {
    /// Builds the mesh of these faces, whose corners are indices into `vertices`. Face i gets the i-th handle, and
    /// vertices likewise. Vertices without faces are kept.
    ///
    /// A vertex whose faces form several fans is accepted if all fans are open. The boundary loops are linked so that
    /// its ring visits the fans one after the other, and [`gaps`](HalfEdgeMesh::gaps) returns the number of fans.
    ///
    /// # Errors
    /// [`ConversionError`] for the first face with a wrong corner; else for the first edge, by its smaller and then its
    /// larger end, with more than two faces or with a flipped face; else for the first vertex with a closed fan and a
    /// further fan.
    pub fn new(vertices: Vec<Vertex>, faces: &IndexedFaces) -> Result<HalfEdgeMesh, ConversionError> {
        let corners = faces.corners();
        let most = (1 << 31) - 2;
        if [corners.len(), vertices.len(), faces.len()].iter().any(|&count| count > most) {
            return Err(ConversionError::TooMany);
        }
        let mut mesh = HalfEdgeMesh { scene_vertex: vertices, ..HalfEdgeMesh::default() };
        let buckets = mesh.begin(faces)?;
        mesh.pair(&buckets, corners).map_err(|edge| mesh.wrong_edge(edge, faces))?;
        mesh.close(corners);
        let half_edges = mesh.end.len();
        mesh.marker = vec![0; half_edges];
        mesh.user_data = vec![0; half_edges];
        mesh.face_marker = vec![0; faces.len()];
        mesh.face_user_data = vec![0; faces.len()];
        mesh.vertex_marker = vec![0; mesh.scene_vertex.len()];
        mesh.vertex_user_data = vec![0; mesh.scene_vertex.len()];
        mesh.single_rings()?;
        Ok(mesh)
    }

    /// Builds the mesh of these faces over the first `points` input vertices of a scene.
    ///
    /// # Errors
    /// As [`HalfEdgeMesh::new`].
    pub fn of_scene<F: AsRef<[Vertex]>>(points: usize, faces: &[F]) -> Result<HalfEdgeMesh, ConversionError> {
        if points > Vertex::MAX_INPUT {
            return Err(ConversionError::TooMany);
        }
        let place = |v: &Vertex| u32::try_from(v.index()).unwrap_or(NONE);
        let faces = faces.iter().map(|face| face.as_ref().iter().map(place)).collect();
        HalfEdgeMesh::new((0..points).map(Vertex::input).collect(), &faces)
    }

    /// Creates the half-edges of all faces, without opposites; returns the start of each smaller end's group.
    fn begin(&mut self, faces: &IndexedFaces) -> Result<Vec<u32>, ConversionError> {
        let (vertices, all) = (self.scene_vertex.len(), faces.corners().len());
        self.end.reserve_exact(all);
        self.next.reserve_exact(all);
        self.face.reserve_exact(all);
        self.face_half_edge.reserve_exact(faces.len());
        self.vertex_half_edge = vec![HalfEdge::NONE; vertices];
        let mut buckets = vec![0; vertices + 1];
        let mut last_face = vec![NONE; vertices];
        for (face, corners) in faces.iter().enumerate() {
            if corners.len() < 3 {
                return Err(ConversionError::TooFewCorners { face, corners: corners.len() });
            }
            let (handle, first) = (Face::at(face), self.end.len());
            self.face_half_edge.push(HalfEdge::at(first));
            for (at, &corner) in corners.iter().enumerate() {
                let Some(last) = last_face.get_mut(corner as usize) else {
                    return Err(ConversionError::NoSuchVertex { face, corner, vertices });
                };
                if std::mem::replace(last, handle.0) == handle.0 {
                    let vertex = self.scene_vertex[corner as usize];
                    return Err(ConversionError::RepeatedVertex { face, vertex });
                }
                let after = if at + 1 == corners.len() { 0 } else { at + 1 };
                let end = corners[after];
                // An invalid corner is reported later, when its own turn comes.
                if let Some(count) = buckets.get_mut(corner.min(end) as usize + 1) {
                    *count += 1;
                }
                if let Some(half_edge) = self.vertex_half_edge.get_mut(end as usize) {
                    *half_edge = HalfEdge::at(first + at);
                }
                self.end.push(MeshVertex(end));
                self.next.push(HalfEdge::at(first + after));
                self.face.push(handle);
            }
        }
        for v in 0..vertices {
            buckets[v + 1] += buckets[v];
        }
        Ok(buckets)
    }

    /// Finds all opposites, or fails with an edge that has more than two half-edges, or two in one direction.
    fn pair(&mut self, buckets: &[u32], corners: &[u32]) -> Result<(), [u32; 2]> {
        let vertices = self.scene_vertex.len();
        self.opposite = vec![HalfEdge::NONE; corners.len()];
        // The larger end, and twice the half-edge, plus one if it goes from the larger to the smaller end.
        let mut sorted = vec![(0, 0); corners.len()];
        let mut places = buckets.to_vec();
        for ((h, &start), &MeshVertex(end)) in (0..).zip(corners).zip(&self.end) {
            let place = &mut places[start.min(end) as usize];
            sorted[*place as usize] = (start.max(end), 2 * h + u32::from(start > end));
            *place += 1;
        }
        let mut found = vec![NONE; vertices];
        for (low, range) in (0..).zip(buckets.windows(2)) {
            let bucket = &sorted[range[0] as usize..range[1] as usize];
            let mut wrong = None;
            for &(high, tag) in bucket {
                let first = &mut found[high as usize];
                if *first == NONE {
                    *first = tag;
                } else if *first == PAIRED || (*first ^ tag) & 1 == 0 {
                    wrong = Some(wrong.map_or(high, |other: u32| other.min(high)));
                } else {
                    let [h, o] = [HalfEdge(*first / 2), HalfEdge(tag / 2)];
                    self.opposite[h.index()] = o;
                    self.opposite[o.index()] = h;
                    *first = PAIRED;
                }
            }
            if let Some(high) = wrong {
                return Err([low, high]);
            }
            for &(high, _) in bucket {
                found[high as usize] = NONE;
            }
        }
        Ok(())
    }

    /// The error of an edge that could not be paired.
    fn wrong_edge(&self, [low, high]: [u32; 2], faces: &IndexedFaces) -> ConversionError {
        let mut here = Vec::new();
        for (face, corners) in faces.iter().enumerate() {
            let ends = corners.iter().skip(1).chain(corners.first());
            for edge in corners.iter().zip(ends).map(|(&start, &end)| [start, end]) {
                if edge == [low, high] || edge == [high, low] {
                    here.push((face, edge));
                }
            }
        }
        match here[..] {
            [(i, edge), (j, _)] => {
                let edge = edge.map(|v| self.scene_vertex[v as usize]);
                ConversionError::FlippedFace { edge, faces: [i, j] }
            }
            _ => {
                let edge = [low, high].map(|v| self.scene_vertex[v as usize]);
                let mut faces = here.iter().map(|&(face, _)| face);
                let faces = [(); 3].map(|()| faces.next().unwrap_or_default());
                ConversionError::ThreeFaces { edge, faces }
            }
        }
    }

    /// Adds boundary half-edges where opposites are missing, and links them.
    fn close(&mut self, corners: &[u32]) {
        let inner = corners.len();
        // The boundary half-edge that starts at each vertex.
        let mut starts = vec![NONE; self.scene_vertex.len()];
        for h in (0..inner).map(HalfEdge::at) {
            if self.opposite[h.index()] != HalfEdge::NONE {
                continue;
            }
            let b = HalfEdge::at(self.end.len());
            self.end.push(MeshVertex(corners[h.index()]));
            self.face.push(Face::NONE);
            self.opposite.push(h);
            self.opposite[h.index()] = b;
            let start = &mut starts[self.end(h).index()];
            *start = if *start == NONE { b.0 } else { PINCHED };
        }
        let boundary = || (inner..self.end.len()).map(HalfEdge::at);
        let mut pinched = Vec::new();
        for b in boundary() {
            self.next.push(HalfEdge(starts[self.end[b.index()].index()]));
            let start = self.end[self.opposite[b.index()].index()];
            if starts[start.index()] == PINCHED {
                pinched.push((start, b));
            }
        }
        pinched.sort_unstable();
        for fans in pinched.chunk_by(|a, b| a.0 == b.0) {
            for (at, &(_, out)) in fans.iter().enumerate() {
                // Walks around the fan, to the boundary half-edge at its other side.
                let mut last = self.opposite(out);
                while !self.is_boundary(last) {
                    last = self.opposite(self.next(last));
                }
                let (_, next) = fans[(at + 1) % fans.len()];
                self.set_next(last, next);
            }
        }
    }

    /// Checks that the half-edges at each vertex form a single ring.
    fn single_rings(&self) -> Result<(), ConversionError> {
        if self.ring_lengths() == self.end.len() {
            return Ok(());
        }
        let mut at_vertex = vec![0; self.scene_vertex.len()];
        self.end.iter().for_each(|v| at_vertex[v.index()] += 1);
        match self.vertices().find(|&v| self.degree(v) != at_vertex[v.index()]) {
            Some(v) => Err(ConversionError::SeveralFans { vertex: self.scene_vertex(v) }),
            None => Ok(()),
        }
    }

    /// The sum of the lengths of all vertices' rings. Several rings are walked alternately: if faces are in random
    /// order, each step waits for memory, and meanwhile steps of the other rings can run.
    fn ring_lengths(&self) -> usize {
        let mut firsts = self.vertex_half_edge.iter().copied().filter(|h| h.some().is_some());
        let mut walks: Vec<[HalfEdge; 2]> = firsts.by_ref().take(RINGS).map(|h| [h, h]).collect();
        let mut steps = 0;
        while !walks.is_empty() {
            steps += walks.len();
            for [first, at] in &mut walks {
                *at = self.opposite(self.next(*at));
                if at == first {
                    let h = firsts.next().unwrap_or(HalfEdge::NONE);
                    [*first, *at] = [h, h];
                }
            }
            walks.retain(|[first, _]| first.some().is_some());
        }
        steps
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_in_turns_are_all_rings() {
        // Strips of all lengths: the last rings end in different rounds.
        for triangles in 0..60_u32 {
            let faces = (0..triangles).map(|at| if at % 2 == 0 { [at, at + 1, at + 2] } else { [at + 1, at, at + 2] });
            let vertices = (0..70).map(Vertex::input).collect();
            let mesh = HalfEdgeMesh::new(vertices, &faces.collect()).unwrap();
            assert_eq!(mesh.ring_lengths(), mesh.end.len());
            assert_eq!(mesh.vertices().map(|v| mesh.degree(v)).sum::<usize>(), mesh.end.len());
        }
    }
}
