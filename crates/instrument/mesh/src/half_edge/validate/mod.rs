//! Validation of the invariants; each violation has the first handle where it occurs.

#[cfg(test)]
mod tests;

use super::{Face, HalfEdge, HalfEdgeMesh, MeshVertex, handles};

/// An element of a mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Element {
    /// A half-edge.
    HalfEdge(HalfEdge),
    /// A face.
    Face(Face),
    /// A vertex.
    Vertex(MeshVertex),
}

impl std::fmt::Display for Element {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Element::HalfEdge(h) => write!(f, "half-edge {h}"),
            Element::Face(face) => write!(f, "face {face}"),
            Element::Vertex(v) => write!(f, "vertex {v}"),
        }
    }
}

/// A violated invariant of half-edge meshes, and its location.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Violation {
    /// The element is removed but not free for reuse, or free twice, or free and in use.
    Storage(Element),
    /// The element links to an element that the mesh does not have.
    Link(Element, Element),
    /// The half-edge is its own opposite.
    OwnOpposite(HalfEdge),
    /// The opposite of the half-edge's opposite is another half-edge.
    Opposite(HalfEdge),
    /// The half-edge starts where it ends.
    OneVertex(HalfEdge),
    /// The half-edge is its own next.
    OwnNext(HalfEdge),
    /// The next of the half-edge does not start at the half-edge's end.
    Start(HalfEdge),
    /// Two half-edges have the same next.
    SharedNext(HalfEdge, HalfEdge),
    /// The next of the half-edge has another face.
    FaceChanges(HalfEdge),
    /// The half-edge of the face has another face.
    FaceHalfEdge(Face),
    /// The face has fewer than three half-edges.
    TooFewHalfEdges(Face),
    /// The face has a second loop, at this half-edge.
    SecondLoop(Face, HalfEdge),
    /// The half-edge of the vertex ends elsewhere.
    VertexHalfEdge(MeshVertex),
    /// The half-edge ends at the vertex and is not in its ring.
    SecondRing(MeshVertex, HalfEdge),
    /// Two half-edges go from one vertex to the same other vertex.
    SecondEdge(HalfEdge, HalfEdge),
}

impl std::fmt::Display for Violation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        use Violation as V;
        match self {
            V::Storage(element) => write!(f, "{element} is neither in use nor free once"),
            V::Link(from, to) => write!(f, "{from} links to {to}, which the mesh does not have"),
            V::OwnOpposite(h) => write!(f, "half-edge {h} is its own opposite"),
            V::Opposite(h) => write!(f, "half-edge {h} is not the opposite of its opposite"),
            V::OneVertex(h) => write!(f, "half-edge {h} starts where it ends"),
            V::OwnNext(h) => write!(f, "half-edge {h} is its own next"),
            V::Start(h) => write!(f, "the next of half-edge {h} does not start where it ends"),
            V::SharedNext(a, b) => write!(f, "half-edges {a} and {b} have the same next"),
            V::FaceChanges(h) => write!(f, "half-edge {h} and its next are of different faces"),
            V::FaceHalfEdge(face) => write!(f, "the half-edge of face {face} is of another one"),
            V::TooFewHalfEdges(face) => write!(f, "face {face} has fewer than three half-edges"),
            V::SecondLoop(face, h) => write!(f, "half-edge {h} is in a second loop of face {face}"),
            V::VertexHalfEdge(v) => write!(f, "the half-edge of vertex {v} does not end there"),
            V::SecondRing(v, h) => write!(f, "half-edge {h} ends at vertex {v} and is not in its ring"),
            V::SecondEdge(a, b) => write!(f, "half-edges {a} and {b} join the same vertices"),
        }
    }
}

impl HalfEdgeMesh {
    /// Checks all invariants, in linear time.
    ///
    /// # Errors
    /// The first violation, in the order of the [variants](Violation), then of handles.
    pub fn validate(&self) -> Result<(), Violation> {
        self.storage()?;
        self.links()?;
        self.opposites()?;
        self.chains()?;
        self.face_loops()?;
        self.rings()?;
        self.edges_once()
    }

    /// Checks that the free handles are those of removed elements.
    fn storage(&self) -> Result<(), Violation> {
        fn check<T: Copy>(
            used: impl Iterator<Item = bool>,
            free: &[T],
            place: impl Fn(T) -> usize,
            element: impl Fn(usize) -> Element,
        ) -> Result<(), Violation> {
            // Each handle is in use or free, exactly once.
            let mut times: Vec<u8> = used.map(u8::from).collect();
            for &handle in free {
                match times.get_mut(place(handle)) {
                    Some(times) => *times = times.saturating_add(1),
                    None => return Err(Violation::Storage(element(place(handle)))),
                }
            }
            times.iter().position(|&times| times != 1).map_or(Ok(()), |at| Err(Violation::Storage(element(at))))
        }
        let half_edges = (0..self.end.len()).map(|at| self.has_half_edge(HalfEdge::at(at)));
        check(half_edges, &self.free_half_edges, HalfEdge::index, |at| Element::HalfEdge(HalfEdge::at(at)))?;
        let faces = (0..self.face_half_edge.len()).map(|at| self.has_face(Face::at(at)));
        check(faces, &self.free_faces, Face::index, |at| Element::Face(Face::at(at)))?;
        let vertices = (0..self.vertex_half_edge.len()).map(|at| self.has_vertex(MeshVertex::at(at)));
        check(vertices, &self.free_vertices, MeshVertex::index, |at| Element::Vertex(MeshVertex::at(at)))
    }

    /// Checks that all links lead to existing elements.
    fn links(&self) -> Result<(), Violation> {
        let to_half_edge = |from: Element, h: HalfEdge| {
            if self.has_half_edge(h) { Ok(()) } else { Err(Violation::Link(from, Element::HalfEdge(h))) }
        };
        for h in self.half_edges() {
            let from = Element::HalfEdge(h);
            to_half_edge(from, self.next(h))?;
            to_half_edge(from, self.opposite(h))?;
            if !self.has_vertex(self.end(h)) {
                return Err(Violation::Link(from, Element::Vertex(self.end(h))));
            }
            if let Some(f) = self.face(h).filter(|&f| !self.has_face(f)) {
                return Err(Violation::Link(from, Element::Face(f)));
            }
        }
        for f in self.faces() {
            to_half_edge(Element::Face(f), self.half_edge_of_face(f))?;
        }
        let mut anchored = self.vertices().filter_map(|v| Some((v, self.half_edge_of_vertex(v)?)));
        anchored.try_for_each(|(v, h)| to_half_edge(Element::Vertex(v), h))
    }

    fn opposites(&self) -> Result<(), Violation> {
        for h in self.half_edges() {
            let o = self.opposite(h);
            if o == h {
                return Err(Violation::OwnOpposite(h));
            }
            if self.opposite(o) != h {
                return Err(Violation::Opposite(h));
            }
            if self.end(o) == self.end(h) {
                return Err(Violation::OneVertex(h));
            }
        }
        Ok(())
    }

    fn chains(&self) -> Result<(), Violation> {
        for h in self.half_edges() {
            if self.next(h) == h {
                return Err(Violation::OwnNext(h));
            }
        }
        for h in self.half_edges() {
            if self.start(self.next(h)) != self.end(h) {
                return Err(Violation::Start(h));
            }
        }
        let mut before = vec![HalfEdge::NONE; self.end.len()];
        for h in self.half_edges() {
            let first = std::mem::replace(&mut before[self.next(h).index()], h);
            if first != HalfEdge::NONE {
                return Err(Violation::SharedNext(first, h));
            }
        }
        Ok(())
    }

    fn face_loops(&self) -> Result<(), Violation> {
        for h in self.half_edges() {
            if self.face(self.next(h)) != self.face(h) {
                return Err(Violation::FaceChanges(h));
            }
        }
        let mut in_loop = vec![false; self.end.len()];
        for f in self.faces() {
            if self.face(self.half_edge_of_face(f)) != Some(f) {
                return Err(Violation::FaceHalfEdge(f));
            }
            let mut length = 0;
            for h in self.loop_of(self.half_edge_of_face(f)) {
                in_loop[h.index()] = true;
                length += 1;
            }
            if length < 3 {
                return Err(Violation::TooFewHalfEdges(f));
            }
        }
        let mut with_face = self.half_edges().filter_map(|h| Some((self.face(h)?, h)));
        let second = with_face.find(|(_, h)| !in_loop[h.index()]);
        second.map_or(Ok(()), |(f, h)| Err(Violation::SecondLoop(f, h)))
    }

    fn rings(&self) -> Result<(), Violation> {
        let mut in_ring = vec![false; self.end.len()];
        for v in self.vertices() {
            if self.half_edge_of_vertex(v).is_some_and(|h| self.end(h) != v) {
                return Err(Violation::VertexHalfEdge(v));
            }
            for h in self.ring(v) {
                in_ring[h.index()] = true;
            }
        }
        let second = self.half_edges().find(|h| !in_ring[h.index()]);
        second.map_or(Ok(()), |h| Err(Violation::SecondRing(self.end(h), h)))
    }

    fn edges_once(&self) -> Result<(), Violation> {
        let mut from = vec![(handles::NONE, HalfEdge::NONE); self.vertex_half_edge.len()];
        for v in self.vertices() {
            for h in self.ring(v) {
                let (last, first) = std::mem::replace(&mut from[self.start(h).index()], (v.0, h));
                if last == v.0 {
                    return Err(Violation::SecondEdge(first, h));
                }
            }
        }
        Ok(())
    }
}
