//! Removing faces, moving faces into another mesh, covering boundary loops.
//!
//! Removed half-edges leave the rings of their vertices; the others keep their order in the rings. This order alone
//! determines the boundary links: the next of a half-edge is the opposite of its successor in the ring.

use std::collections::HashMap;

use super::{Face, HalfEdge, HalfEdgeMesh, MeshVertex, OperationError};

/// The face value of half-edges that are about to be removed.
const DOOMED: Face = Face(u32::MAX - 1);

impl HalfEdgeMesh {
    /// Removes faces, and the edges and vertices that lose their last face.
    ///
    /// Edges that had no faces before stay. The time is proportional to the rings of the vertices.
    ///
    /// # Errors
    /// [`OperationError::NoSuchFace`], [`OperationError::ListedTwice`].
    pub fn remove_faces(&mut self, faces: &[Face]) -> Result<(), OperationError> {
        self.listed_once(faces)?;
        let mut opened: Vec<HalfEdge> = Vec::new();
        for &f in faces {
            opened.extend(self.loop_of(self.half_edge_of_face(f)));
            self.delete_face(f);
        }
        for &h in &opened {
            self.set_face(h, None);
        }
        let mut doomed = Vec::new();
        let mut touched = Vec::new();
        for &h in &opened {
            let pair = [h, self.opposite(h)];
            if pair.iter().all(|&h| self.is_boundary(h)) {
                doomed.extend(pair);
                touched.extend(pair.map(|h| self.end(h)));
                pair.iter().for_each(|&h| self.set_face(h, Some(DOOMED)));
            }
        }
        touched.sort_unstable();
        touched.dedup();
        let mut kept = Vec::new();
        for v in touched {
            kept.clear();
            kept.extend(self.ring(v).filter(|&h| self.face(h) != Some(DOOMED)));
            let Some(&first) = kept.first() else {
                self.delete_vertex(v);
                continue;
            };
            self.vertex_half_edge[v.index()] = first;
            for (at, &h) in kept.iter().enumerate() {
                let follows = kept[(at + 1) % kept.len()];
                self.set_next(h, self.opposite(follows));
            }
        }
        doomed.into_iter().for_each(|h| self.delete_half_edge(h));
        Ok(())
    }

    /// Moves faces into another mesh, where they form a separate part with their own copies of the edges and vertices;
    /// returns their handles there, in the same order. Markers and user data are moved too. This mesh keeps what
    /// [`remove_faces`](HalfEdgeMesh::remove_faces) would keep.
    ///
    /// # Errors
    /// [`OperationError::NoSuchFace`], [`OperationError::ListedTwice`]; [`OperationError::Full`] if the other mesh has
    /// too few free handles.
    pub fn unhook_faces(&mut self, faces: &[Face], into: &mut HalfEdgeMesh) -> Result<Vec<Face>, OperationError> {
        self.listed_once(faces)?;
        let around = || faces.iter().flat_map(|&f| self.loop_of(self.half_edge_of_face(f)));
        let corners = around().count();
        into.room(2 * corners, faces.len(), corners)?;
        // The maps are only looked up, never iterated: their order cannot reach the output.
        let mut half_edges: HashMap<HalfEdge, HalfEdge> = HashMap::new();
        let mut vertices: HashMap<MeshVertex, MeshVertex> = HashMap::new();
        let mut new_faces: HashMap<Face, Face> = HashMap::new();
        let mut copied = Vec::new();
        for h in around() {
            for h in [h, self.opposite(h)] {
                half_edges.entry(h).or_insert_with(|| {
                    let v = self.end(h);
                    let end = *vertices.entry(v).or_insert_with(|| {
                        let end = into.new_vertex(self.scene_vertex(v), HalfEdge::NONE);
                        into.set_vertex_marker(end, self.vertex_marker(v));
                        into.set_vertex_user_data(end, self.vertex_user_data(v));
                        end
                    });
                    let copy = into.new_half_edge(end);
                    into.vertex_half_edge[end.index()] = copy;
                    into.set_marker(copy, self.marker(h));
                    into.set_user_data(copy, self.user_data(h));
                    copied.push((h, copy));
                    copy
                });
            }
        }
        let mut moved = Vec::with_capacity(faces.len());
        for &f in faces {
            let copy = into.new_face(half_edges[&self.half_edge_of_face(f)]);
            into.set_face_marker(copy, self.face_marker(f));
            into.set_face_user_data(copy, self.face_user_data(f));
            new_faces.insert(f, copy);
            moved.push(copy);
        }
        for (h, copy) in copied {
            let face = self.face(h).and_then(|f| new_faces.get(&f).copied());
            into.set_face(copy, face);
            into.opposite[copy.index()] = half_edges[&self.opposite(h)];
            // The next copied half-edge in the ring; at the latest this half-edge itself.
            let mut out = self.next(h);
            for _ in 0..self.end.len() {
                if half_edges.contains_key(&out) {
                    break;
                }
                out = self.next(self.opposite(out));
            }
            let next = *half_edges.get(&out).ok_or(OperationError::Broken(h))?;
            into.set_next(copy, next);
        }
        self.remove_faces(faces)?;
        Ok(moved)
    }

    /// Covers a boundary loop with a new face. The inverse is [`open_face`](HalfEdgeMesh::open_face).
    ///
    /// # Errors
    /// [`OperationError::NotOnBoundary`], [`OperationError::TooFewHalfEdges`], [`OperationError::Full`].
    pub fn cover_boundary_loop(&mut self, h: HalfEdge) -> Result<Face, OperationError> {
        self.known_half_edge(h)?;
        if !self.is_boundary(h) {
            return Err(OperationError::NotOnBoundary(h));
        }
        if self.loop_of(h).nth(2).is_none() {
            return Err(OperationError::TooFewHalfEdges(h));
        }
        self.room(0, 1, 0)?;
        let f = self.new_face(h);
        self.fill_loop(h, Some(f));
        Ok(f)
    }

    /// Removes a face and keeps all its edges: its loop becomes a boundary loop; one of its half-edges is returned.
    ///
    /// # Errors
    /// [`OperationError::NoSuchFace`].
    pub fn open_face(&mut self, f: Face) -> Result<HalfEdge, OperationError> {
        self.known_face(f)?;
        let h = self.half_edge_of_face(f);
        self.fill_loop(h, None);
        self.delete_face(f);
        Ok(h)
    }

    /// Refuses faces that do not exist, and lists with repetitions.
    fn listed_once(&self, faces: &[Face]) -> Result<(), OperationError> {
        let mut sorted = faces.to_vec();
        sorted.sort_unstable();
        for &f in faces {
            self.known_face(f)?;
        }
        match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => Err(OperationError::ListedTwice(pair[0])),
            None => Ok(()),
        }
    }
}
