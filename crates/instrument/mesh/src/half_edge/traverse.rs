//! Traversals: loops, rings, faces without repeats, boundary loops.
//!
//! Traversals do not allocate, and each takes at most one step more than there are half-edges, even if links are
//! broken.

use super::{Face, HalfEdge, HalfEdgeMesh, MeshVertex};

impl HalfEdgeMesh {
    /// The half-edges from a start on by a step function, until it returns to the start or has taken a step per
    /// half-edge.
    fn walk<'m>(
        &'m self,
        first: Option<HalfEdge>,
        step: impl Fn(HalfEdge) -> HalfEdge + 'm,
    ) -> impl Iterator<Item = HalfEdge> + 'm {
        let mut left = self.end.len();
        std::iter::successors(first, move |&h| {
            left = left.checked_sub(1)?;
            Some(step(h)).filter(|&next| Some(next) != first)
        })
    }

    /// The half-edges of the loop, of a face or of a boundary, starting with this half-edge.
    pub fn loop_of(&self, h: HalfEdge) -> impl Iterator<Item = HalfEdge> + '_ {
        self.walk(Some(h), |h| self.next(h))
    }

    /// The end vertices of the loop, starting with the end of this half-edge.
    pub fn vertex_loop(&self, h: HalfEdge) -> impl Iterator<Item = MeshVertex> + '_ {
        self.loop_of(h).map(|h| self.end(h))
    }

    /// The half-edges that end at the vertex, also at boundaries; empty for a vertex without edges.
    pub fn ring(&self, v: MeshVertex) -> impl Iterator<Item = HalfEdge> + '_ {
        self.walk(self.half_edge_of_vertex(v), |h| self.opposite(self.next(h)))
    }

    /// The number of edges at the vertex.
    #[must_use]
    pub fn degree(&self, v: MeshVertex) -> usize {
        self.ring(v).count()
    }

    /// The number of gaps between faces around the vertex: 0 inside, 1 on a plain boundary, more where it is pinched.
    #[must_use]
    pub fn gaps(&self, v: MeshVertex) -> usize {
        self.ring(v).filter(|&h| self.is_boundary(h)).count()
    }

    /// The half-edge from one vertex to another; takes as many steps as the smaller of both degrees.
    #[must_use]
    pub fn find(&self, from: MeshVertex, to: MeshVertex) -> Option<HalfEdge> {
        let (mut at_from, mut at_to) = (self.ring(from), self.ring(to));
        loop {
            let into = at_to.next()?;
            if self.start(into) == from {
                return Some(into);
            }
            let back = at_from.next()?;
            if self.start(back) == to {
                return Some(self.opposite(back));
            }
        }
    }

    /// The half-edge before this one in its loop: by the loop or by the ring, whichever is shorter.
    ///
    /// Returns `None` only if links are broken.
    #[must_use]
    pub fn previous(&self, h: HalfEdge) -> Option<HalfEdge> {
        let ring = self.walk(Some(self.opposite(h)), |h| self.opposite(self.next(h)));
        let both = ring.zip(self.loop_of(h));
        both.flat_map(<[HalfEdge; 2]>::from).find(|&before| self.next(before) == h)
    }

    /// The half-edge of the face that ends at the vertex, the first such half-edge in its ring.
    #[must_use]
    pub fn half_edge_in_face(&self, f: Face, v: MeshVertex) -> Option<HalfEdge> {
        self.ring(v).find(|&h| self.face(h) == Some(f))
    }

    /// The faces at some vertices, each once. A face is returned if its marker is not `marker`, and then gets this
    /// marker.
    ///
    /// Faces that already have the marker are left out. If the iterator is dropped early, only the returned faces have
    /// the marker.
    pub fn faces_once<'m, V: Iterator<Item = MeshVertex> + 'm>(
        &'m mut self,
        mut vertices: V,
        marker: u8,
    ) -> impl Iterator<Item = Face> + 'm {
        let mut at: Option<(HalfEdge, HalfEdge, usize)> = None;
        std::iter::from_fn(move || {
            loop {
                let Some((first, current, left)) = at else {
                    let v = vertices.next()?;
                    at = self.half_edge_of_vertex(v).map(|h| (h, h, self.end.len()));
                    continue;
                };
                let next = self.opposite(self.next(current));
                at = (next != first && left > 0).then(|| (first, next, left - 1));
                if let Some(f) = self.face(current)
                    && self.face_marker(f) != marker
                {
                    self.set_face_marker(f, marker);
                    return Some(f);
                }
            }
        })
    }

    /// The half-edge with the smallest handle of each boundary loop. A loop is returned if its half-edges do not have
    /// the marker `marker`, and then gets this marker.
    pub fn boundary_loops(&mut self, marker: u8) -> impl Iterator<Item = HalfEdge> + '_ {
        let mut at = 0;
        std::iter::from_fn(move || {
            while at < self.end.len() {
                let h = HalfEdge::at(at);
                at += 1;
                if !self.has_half_edge(h) || !self.is_boundary(h) || self.marker(h) == marker {
                    continue;
                }
                let mut current = h;
                // Markers also bound this loop: each step marks one half-edge more.
                while self.marker(current) != marker {
                    self.set_marker(current, marker);
                    current = self.next(current);
                }
                return Some(h);
            }
            None
        })
    }
}
