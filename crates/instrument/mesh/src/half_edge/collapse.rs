//! Collapsing an edge to a vertex, and the inverse: splitting a vertex in two.
//!
//! The collapse of an edge moves its start into its end. A triangle beside the edge becomes an edge; a larger face, or
//! a boundary, loses the edge. The *link condition* says when the surface stays what it was: the two ends have no
//! common neighbours but the corners of the triangles beside the edge (Dey, Edelsbrunner, Guha, Nekhayev 1999:
//! *Topology preserving edge contraction*). The error names the vertex, edge or faces that would break it.

use predicament_predicates::Vertex;

use super::{Face, HalfEdge, HalfEdgeMesh, MeshVertex, OperationError};

/// One side of an edge: the place where the collapse closes it, and where [`split_vertex`](HalfEdgeMesh::split_vertex)
/// opens it. The half-edge ends at the vertex.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// The new edge is inserted into the loop of this half-edge, behind it. The loop can be a boundary.
    Corner(HalfEdge),
    /// The edge of this half-edge becomes a triangle.
    Edge(HalfEdge),
}

impl Side {
    /// The half-edge.
    #[must_use]
    pub fn half_edge(self) -> HalfEdge {
        match self {
            Side::Corner(h) | Side::Edge(h) => h,
        }
    }
}

/// The result of a collapse: the arguments of its inverse.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Collapsed {
    /// The vertex that is left: the former end of the edge.
    pub vertex: MeshVertex,
    /// The left and the right side of the edge, as seen along it.
    pub sides: [Side; 2],
}

/// A triangle beside an edge: the half-edges that follow the edge's, and the opposite ones.
#[derive(Clone, Copy)]
struct Triangle {
    face: Face,
    /// From the end of the edge's half-edge to the apex, and on to its start.
    inner: [HalfEdge; 2],
    /// The opposites of these.
    outer: [HalfEdge; 2],
    apex: MeshVertex,
}

impl HalfEdgeMesh {
    /// Collapses an edge: its start is removed, and all edges of it go to its end. Returns the arguments of the
    /// inverse, [`split_vertex`](HalfEdgeMesh::split_vertex). A triangle beside the edge loses its face, and its other
    /// two edges become one: the half-edges outside the triangle stay, with their markers and user data.
    ///
    /// The numbers of parts and of boundary loops, and the genus, stay the same. The time is proportional to the rings
    /// of both vertices.
    ///
    /// # Errors
    /// * [`OperationError::OnBoundary`] for an edge without faces;
    /// * [`OperationError::OneFace`] for an edge with the same face on both sides;
    /// * [`OperationError::EdgeExists`] if both ends have a common neighbour that is not across from the edge in a
    ///   triangle;
    /// * [`OperationError::OneVertex`] if two triangles beside the edge have the same corner across from it;
    /// * [`OperationError::OneEdge`] if that corner would have one edge left;
    /// * [`OperationError::NoFace`] if an edge would have no face left;
    /// * [`OperationError::Pinched`] if boundaries would meet in the vertex that did not meet before;
    /// * [`OperationError::SameVertices`] if two triangles would have the same vertices: the mesh is a tetrahedron.
    pub fn collapse_edge(&mut self, edge: HalfEdge) -> Result<Collapsed, OperationError> {
        self.known_half_edge(edge)?;
        let back = self.opposite(edge);
        let both = [edge, back];
        match both.map(|h| self.face(h)) {
            [None, None] => return Err(OperationError::OnBoundary(edge)),
            [Some(left), Some(right)] if left == right => return Err(OperationError::OneFace(edge)),
            _ => {}
        }
        let [gone, kept] = [self.start(edge), self.end(edge)];
        let triangles = both.map(|h| self.triangle_at(h));
        self.link_condition([gone, kept], triangles)?;
        let ring: Vec<HalfEdge> = self.ring(gone).collect();
        let gaps = [gone, kept].map(|v| self.gaps(v));
        let closed = both.iter().filter(|&&h| self.is_boundary(h)).count();
        if gaps[0] + gaps[1] - closed > gaps[0].max(gaps[1]).max(1) {
            return Err(OperationError::Pinched(kept));
        }
        let [Some(before_edge), Some(before_back)] = both.map(|h| self.previous(h)) else {
            return Err(OperationError::Broken(edge));
        };
        for h in ring {
            self.end[h.index()] = kept;
        }
        let mut sides = [Side::Corner(before_edge), Side::Corner(before_back)];
        for ((h, before), (triangle, side)) in
            [(edge, before_edge), (back, before_back)].into_iter().zip(triangles.into_iter().zip(&mut sides))
        {
            match triangle {
                None => {
                    let after = self.next(h);
                    self.set_next(before, after);
                    self.anchor_face(self.face(h), h, before);
                }
                Some(Triangle { face, inner, outer, apex }) => {
                    // Of the two outer half-edges, the first one ends where the edge's half-edge ended.
                    self.set_opposite(outer[0], outer[1]);
                    self.anchor_vertex(apex, inner[0], outer[1]);
                    self.delete_face(face);
                    *side = Side::Edge(outer[0]);
                }
            }
        }
        self.vertex_half_edge[kept.index()] = sides[0].half_edge();
        for Triangle { inner, .. } in triangles.into_iter().flatten() {
            inner.into_iter().for_each(|h| self.delete_half_edge(h));
        }
        both.into_iter().for_each(|h| self.delete_half_edge(h));
        self.delete_vertex(gone);
        Ok(Collapsed { vertex: kept, sides })
    }

    /// Splits a vertex: a new vertex takes over a part of its edges, and a new edge joins both. Returns the half-edge
    /// from the new vertex to the old one.
    ///
    /// The two sides are those on the left and on the right of the returned half-edge. The new vertex takes the edges
    /// of the ring from the right side to the left side. An edge that becomes a triangle is taken on the right, and its
    /// copy is new on the left.
    ///
    /// The inverse is [`collapse_edge`](HalfEdgeMesh::collapse_edge) of the returned half-edge. What it would refuse is
    /// refused here.
    ///
    /// # Errors
    /// * [`OperationError::TwoVertices`] if the half-edges end at two vertices;
    /// * [`OperationError::OneVertex`] if both sides are one edge;
    /// * [`OperationError::OnBoundary`], [`OperationError::OneLoop`] if both sides are corners of boundaries, or of one
    ///   face;
    /// * [`OperationError::OneEdge`], [`OperationError::NoFace`], [`OperationError::Pinched`],
    ///   [`OperationError::SameVertices`] as for the inverse; [`OperationError::Full`].
    pub fn split_vertex(&mut self, sides: [Side; 2], scene_vertex: Vertex) -> Result<HalfEdge, OperationError> {
        let [left, right] = sides.map(Side::half_edge);
        self.known_half_edge(left)?;
        self.known_half_edge(right)?;
        let v = self.end(left);
        if self.end(right) != v {
            return Err(OperationError::TwoVertices(left, right));
        }
        match sides {
            [Side::Corner(_), Side::Corner(_)] => match [left, right].map(|h| self.face(h)) {
                [None, None] => return Err(OperationError::OnBoundary(left)),
                [one, other] if one == other => return Err(OperationError::OneLoop(left, right)),
                _ => {}
            },
            [Side::Edge(_), Side::Edge(_)] if left == right => return Err(OperationError::OneVertex(self.start(left))),
            _ => {}
        }
        for side in sides {
            let Side::Edge(h) = side else { continue };
            if self.is_boundary(h) && self.is_boundary(self.opposite(h)) {
                return Err(OperationError::NoFace(h));
            }
            if self.degree(self.start(h)) == 1 {
                return Err(OperationError::OneEdge(self.start(h)));
            }
        }
        let opened = sides.iter().filter(|side| matches!(side, Side::Edge(_))).count();
        self.room(2 + 2 * opened, opened, 1)?;
        let moved = self.moved(sides);
        self.split_condition(v, &moved, sides)?;
        let anchored = self.half_edge_of_vertex(v).is_some_and(|h| moved.contains(&h));
        let new = self.new_vertex(scene_vertex, HalfEdge::NONE);
        let both = self.new_edge(new, v);
        let [edge, back] = both;
        for &h in &moved {
            self.end[h.index()] = new;
        }
        for ((h, side), start) in both.into_iter().zip(sides).zip([new, v]) {
            match side {
                Side::Corner(before) => {
                    let after = self.next(before);
                    self.set_next(before, h);
                    self.set_next(h, after);
                    self.set_face(h, self.face(before));
                }
                Side::Edge(outer) => self.open_edge(h, outer, start),
            }
        }
        self.vertex_half_edge[new.index()] = back;
        if anchored {
            self.vertex_half_edge[v.index()] = edge;
        }
        Ok(edge)
    }

    /// Opens an edge into a triangle beside the half-edge `h`, which starts at `start`. `outer` ends where `h` ends.
    fn open_edge(&mut self, h: HalfEdge, outer: HalfEdge, start: MeshVertex) {
        let other = self.opposite(outer);
        let apex = self.end(other);
        let [to_apex, from_apex] = [apex, start].map(|end| self.new_half_edge(end));
        self.set_opposite(to_apex, outer);
        self.set_opposite(from_apex, other);
        let face = self.new_face(h);
        for (one, next) in [(h, to_apex), (to_apex, from_apex), (from_apex, h)] {
            self.set_next(one, next);
            self.set_face(one, Some(face));
        }
    }

    /// The half-edges of the ring that a new vertex takes over.
    fn moved(&self, [left, right]: [Side; 2]) -> Vec<HalfEdge> {
        let first = match right {
            Side::Edge(h) => h,
            Side::Corner(h) => self.opposite(self.next(h)),
        };
        let mut moved = Vec::new();
        let mut h = first;
        for _ in 0..self.end.len() {
            if left == Side::Edge(h) {
                break;
            }
            moved.push(h);
            if left == Side::Corner(h) {
                break;
            }
            h = self.opposite(self.next(h));
        }
        moved
    }

    /// Refuses a split whose inverse would be refused.
    fn split_condition(&self, v: MeshVertex, moved: &[HalfEdge], sides: [Side; 2]) -> Result<(), OperationError> {
        let is_open = |side: Side| matches!(side, Side::Corner(h) if self.is_boundary(h));
        let all = self.gaps(v);
        let taken = moved.iter().filter(|&&h| self.is_boundary(h)).count();
        // The new edge's half-edges end at either vertex.
        let gaps = [taken + usize::from(is_open(sides[1])), all - taken + usize::from(is_open(sides[0]))];
        if all > gaps[0].max(gaps[1]).max(1) {
            return Err(OperationError::Pinched(v));
        }
        let [left, right] = sides.map(Side::half_edge);
        let faces = [left, right].map(|h| self.face(h).filter(|_| self.is_triangle(h)));
        match (sides, faces) {
            ([Side::Edge(_), Side::Edge(_)], [Some(one), Some(other)]) if self.degree(v) == 2 => {
                Err(OperationError::SameVertices(one, other))
            }
            _ => Ok(()),
        }
    }

    /// Refuses an edge whose collapse changes the surface.
    fn link_condition(
        &self,
        [gone, kept]: [MeshVertex; 2],
        triangles: [Option<Triangle>; 2],
    ) -> Result<(), OperationError> {
        if let [Some(left), Some(right)] = triangles
            && left.apex == right.apex
        {
            return Err(OperationError::OneVertex(left.apex));
        }
        let apexes = triangles.map(|triangle| triangle.map(|triangle| triangle.apex));
        for neighbour in self.ring(gone).map(|h| self.start(h)) {
            if neighbour != kept
                && !apexes.contains(&Some(neighbour))
                && let Some(other) = self.find(neighbour, kept)
            {
                return Err(OperationError::EdgeExists(other));
            }
        }
        for triangle in triangles.into_iter().flatten() {
            if self.degree(triangle.apex) == 2 {
                return Err(OperationError::OneEdge(triangle.apex));
            }
            if triangle.outer.iter().all(|&h| self.is_boundary(h)) {
                return Err(OperationError::NoFace(triangle.outer[0]));
            }
        }
        if let [Some(left), Some(_)] = triangles
            && [gone, kept].iter().all(|&v| self.degree(v) == 3)
        {
            // The third face at either vertex.
            let thirds = left.outer.map(|h| self.face(h).filter(|_| self.is_triangle(h)));
            if let [Some(one), Some(other)] = thirds {
                return Err(OperationError::SameVertices(one, other));
            }
        }
        Ok(())
    }

    fn is_triangle(&self, h: HalfEdge) -> bool {
        self.next(self.next(self.next(h))) == h
    }

    fn triangle_at(&self, h: HalfEdge) -> Option<Triangle> {
        let face = self.face(h).filter(|_| self.is_triangle(h))?;
        let to_apex = self.next(h);
        let inner = [to_apex, self.next(to_apex)];
        Some(Triangle { face, inner, outer: inner.map(|h| self.opposite(h)), apex: self.end(to_apex) })
    }
}
