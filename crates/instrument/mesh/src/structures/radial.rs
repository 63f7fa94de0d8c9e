//! Radial edges: K. Weiler, "Topological structures for geometric modeling", 1986. Any number of faces may meet at an
//! edge, so solids that touch along an edge or in a vertex are one structure.

use std::collections::BTreeMap;

use predicament_predicates::Vertex;

use super::Contradiction;
use crate::half_edge::{IndexedFaces, Link, Links};

/// The part of space between two faces that are next to each other around an edge.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wedge {
    /// Behind the faces. Solids that touch at an edge become surfaces apart.
    Inside,
    /// In front of the faces. Cavities that touch at an edge become surfaces apart.
    Outside,
}

/// Faces of any number at each edge, and their order around it.
///
/// A face has two sides, and each side uses its edges: the front uses the edge that starts at its corner c as 2c, and
/// the back uses the same edge in the other direction as 2c + 1. So the *mate* of a use is the other of the two.
/// Corners are numbered in the order of [`IndexedFaces::corners`].
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RadialEdges {
    /// The scene's vertex of each vertex.
    pub vertices: Vec<Vertex>,
    /// The faces, counterclockwise as seen from the front.
    pub faces: IndexedFaces,
    /// The use of the same edge by the side of a face that each use sees across a wedge of space.
    pub radial: Vec<u32>,
}

/// The corner after each one in its face.
fn next_corners(faces: &IndexedFaces) -> Vec<u32> {
    let mut next = Vec::with_capacity(faces.corners().len());
    for face in faces.iter() {
        let first = next.len();
        let corner = |at: usize| u32::try_from(first + at % face.len()).unwrap_or(u32::MAX);
        next.extend((1..=face.len()).map(corner));
    }
    next
}

impl RadialEdges {
    /// The radial edges of these faces.
    ///
    /// `around` gets the ends a < b of an edge of more than two faces, and the corners at which the faces' own edges
    /// between a and b begin. It sorts these corners counterclockwise around the edge, as seen from b.
    ///
    /// # Panics
    /// If there are 2^31 corners.
    pub fn new(
        vertices: Vec<Vertex>,
        faces: IndexedFaces,
        mut around: impl FnMut([u32; 2], &mut [u32]),
    ) -> RadialEdges {
        let (corners, next) = (faces.corners(), next_corners(&faces));
        let mut edges: BTreeMap<[u32; 2], Vec<u32>> = BTreeMap::new();
        for (c, &start) in (0_u32..).zip(corners) {
            let end = corners[next[c as usize] as usize];
            edges.entry([start.min(end), start.max(end)]).or_default().push(c);
        }
        let mut radial = vec![0; 2 * corners.len()];
        for ([low, high], mut at) in edges {
            if at.len() > 2 {
                around([low, high], &mut at);
            }
            // From `low` to `high`, the front of a face that starts at `low` looks at the next face.
            let is_back = |c: u32| u32::from(corners[c as usize] != low);
            for (i, &c) in at.iter().enumerate() {
                let after = at[(i + 1) % at.len()];
                let (sees, seen) = (2 * c + is_back(c), 2 * after + 1 - is_back(after));
                radial[sees as usize] = seen;
                radial[seen as usize] = sees;
            }
        }
        RadialEdges { vertices, faces, radial }
    }

    /// The surfaces on which two faces are neighbours if they see each other across such a wedge. A vertex of several
    /// surfaces, or of several fans of one, becomes several vertices with the same vertex of the scene.
    ///
    /// The half-edges of faces are in the order of corners, at even numbers where the edge was met first.
    /// [`HalfEdgeMesh::from_links`](crate::HalfEdgeMesh::from_links) refuses surfaces that two edges with the same ends
    /// hold together: those that touch along an edge, if they are joined there.
    ///
    /// # Errors
    /// The first use of an edge that sees the other side of its neighbour: faces that are turned against each other.
    ///
    /// # Panics
    /// If the faces have a corner that is no vertex.
    pub fn surfaces(&self, across: Wedge) -> Result<Links, Contradiction> {
        let (corners, next) = (self.faces.corners(), next_corners(&self.faces));
        let side = u32::from(across == Wedge::Inside);
        // The corner of the half-edge opposite to that of each corner; its own where there is none.
        let mut opposite = Vec::with_capacity(corners.len());
        for c in (0_u32..).take(corners.len()) {
            let seen = self.radial[(2 * c + side) as usize];
            let is_single = seen == (2 * c + 1 - side);
            if !is_single && seen & 1 != side {
                return Err(Contradiction::Turned(2 * c + side));
            }
            opposite.push(if is_single { c } else { seen / 2 });
        }
        // Half-edges in pairs.
        const NONE: u32 = u32::MAX;
        let mut place = vec![NONE; corners.len()];
        let mut count = 0;
        for c in 0..corners.len() {
            if place[c] == NONE {
                place[c] = count;
                let other = opposite[c] as usize;
                if other != c {
                    place[other] = count + 1;
                }
                count += 2;
            }
        }
        let mut half_edges = vec![Link { end: NONE, next: NONE, face: None }; count as usize];
        for (face, range) in (0..).zip(ranges(&self.faces)) {
            for c in range {
                half_edges[place[c] as usize] = Link { end: NONE, next: place[next[c] as usize], face: Some(face) };
            }
        }
        close(&mut half_edges);
        // Each ring is a vertex.
        let mut scene_vertices = Vec::new();
        for c in 0..corners.len() {
            let into = place[c] as usize;
            if half_edges[into].end != NONE {
                continue;
            }
            let vertex = u32::try_from(scene_vertices.len()).unwrap_or(NONE);
            scene_vertices.push(self.vertices[corners[next[c] as usize] as usize]);
            let mut h = into;
            while half_edges[h].end == NONE {
                half_edges[h].end = vertex;
                h = half_edges[h].next as usize ^ 1;
            }
        }
        Ok(Links { vertices: scene_vertices, half_edges, faces: self.faces.len() })
    }
}

/// The corners of each face.
fn ranges(faces: &IndexedFaces) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
    let mut end = 0;
    faces.iter().map(move |face| {
        let start = end;
        end += face.len();
        start..end
    })
}

/// Links the half-edges without a face to loops, each through the gap at its end.
fn close(half_edges: &mut [Link]) {
    let mut previous = vec![u32::MAX; half_edges.len()];
    for (h, link) in (0..).zip(half_edges.iter()) {
        if link.face.is_some() {
            previous[link.next as usize] = h;
        }
    }
    for h in 0..half_edges.len() {
        if half_edges[h].face.is_none() {
            // Backwards through the fan, from the face beside h to its other border.
            let mut at = h ^ 1;
            while half_edges[at].face.is_some() {
                at = previous[at] as usize ^ 1;
            }
            half_edges[h].next = u32::try_from(at).unwrap_or(u32::MAX);
        }
    }
}
