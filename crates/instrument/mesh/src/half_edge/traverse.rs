//! Traversals: loops, rings, faces without repeats, boundary loops. None of them allocates, and each takes at most
//! one step more than there are half-edges, whatever the links say.

use super::{Face, HalfEdge, HalfEdgeMesh, MeshVertex};

impl HalfEdgeMesh {
    /// From a half-edge on by a step, until it comes back or every half-edge could have been seen.
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

    /// The half-edges of the loop, of a face or of a boundary, from this one on.
    pub fn loop_of(&self, h: HalfEdge) -> impl Iterator<Item = HalfEdge> + '_ {
        self.walk(Some(h), |h| self.next(h))
    }

    /// The end vertices of the loop, from that of this half-edge on.
    pub fn vertex_loop(&self, h: HalfEdge) -> impl Iterator<Item = MeshVertex> + '_ {
        self.loop_of(h).map(|h| self.end(h))
    }

    /// The half-edges that end at the vertex, at boundaries too; nothing for a vertex without edges.
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
    /// None only where the links are broken.
    #[must_use]
    pub fn previous(&self, h: HalfEdge) -> Option<HalfEdge> {
        let ring = self.walk(Some(self.opposite(h)), |h| self.opposite(self.next(h)));
        let both = ring.zip(self.loop_of(h));
        both.flat_map(<[HalfEdge; 2]>::from).find(|&before| self.next(before) == h)
    }

    /// The half-edge of the face that ends at the vertex, the first one in its ring.
    #[must_use]
    pub fn half_edge_in_face(&self, f: Face, v: MeshVertex) -> Option<HalfEdge> {
        self.ring(v).find(|&h| self.face(h) == Some(f))
    }

    /// The faces at some vertices, each once: those whose marker is not `marker`, which then get it.
    ///
    /// Faces that have the marker beforehand are left out. Where the iterator is dropped early, the faces that it
    /// gave have the marker.
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

    /// One half-edge of each boundary loop, the one with the smallest handle: of those whose half-edges do not have
    /// the marker `marker`, which then get it.
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
                // Markers end this too: each step marks one half-edge more.
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
