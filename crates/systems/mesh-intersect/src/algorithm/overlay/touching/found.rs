//! The points and segments in which two meshes meet, by the simplices that meet there.
//!
//! A mesh that does not touch itself has each of its points in the relative interior of one simplex: a vertex, an edge
//! or a triangle. So a point of both meshes belongs to one pair of simplices, and a pair whose relative interiors meet
//! in a single point is the name of that point: no two names are one point. The same holds for open segments.

use predicament_predicates::Vertex;

/// A simplex of a mesh.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Simplex {
    /// A vertex, by its representative.
    Vertex(Vertex),
    /// An edge, by its index among the near edges.
    Edge(u32),
    /// A triangle, by its index among the near triangles.
    Triangle(u32),
}

/// A simplex of the first mesh and one of the second.
pub(super) type Pair = [Simplex; 2];

/// An open segment in which the relative interiors of two simplices meet.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Segment {
    /// The simplices: edges or triangles.
    pub of: Pair,
    /// Its ends. For two triangles, the second end is ahead of the first along the product of the normals of the first
    /// mesh's triangle and of the second's; otherwise ends are ascending.
    pub ends: [Pair; 2],
}

/// Points and segments of both meshes.
#[derive(Clone, Default, Debug)]
pub(super) struct Found {
    /// Points: pairs with a vertex, an edge that crosses a triangle, or two edges that cross.
    pub points: Vec<Pair>,
    /// Segments.
    pub segments: Vec<Segment>,
}

impl Found {
    /// Adds the segment between two points, or the point if these are one.
    pub fn add(&mut self, of: Pair, ends: [Pair; 2]) {
        self.points.push(ends[0]);
        if ends[0] != ends[1] {
            self.points.push(ends[1]);
            let is_directed = matches!(of, [Simplex::Triangle(_), Simplex::Triangle(_)]);
            let ends = if is_directed || ends[0] < ends[1] { ends } else { [ends[1], ends[0]] };
            self.segments.push(Segment { of, ends });
        }
    }

    /// Joins lists; sorts them and removes repetitions.
    pub fn joined(parts: Vec<Found>) -> Found {
        let mut all = Found::default();
        for part in parts {
            all.points.extend(part.points);
            all.segments.extend(part.segments);
        }
        all.points.sort_unstable();
        all.points.dedup();
        all.segments.sort_unstable();
        all.segments.dedup();
        all
    }
}
