//! Checks of the parts of a mesh split by planes, decided in rationals.
//!
//! The checks do not know how the parts were made. They get points, triangles, the given faces and planes, and for each
//! triangle its claimed origin. Each [`Check`] is a law for the parts. Together the laws say that the parts are solids,
//! that they are on their sides, and that nothing was lost.
//!
//! # Volumes
//! Six times the volume of a solid is the sum of the determinants of its triangles. A sum of many rationals without
//! common factors has as many digits as all of them together. So the difference of all parts and the whole is summed
//! face by face and plane by plane: for correct parts each of these sums is zero.

mod closed;
mod crossing;
mod euler;
mod exact;
mod flat;
pub mod given;
mod homogeneous;
mod pieces;
pub mod replies;
mod rounded;
mod volume;

use crossing::Near;
use exact::Point;

pub use homogeneous::Rows;

/// The claimed origin of a triangle.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Piece {
    /// A given face.
    Face(usize),
    /// A given plane.
    Cap(usize),
    /// The cover of a loop: neither a face nor a plane.
    Cover,
}

/// The triangles of one part, as indices of points.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Part {
    /// The triangles, counterclockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The origin of each triangle.
    pub pieces: Vec<Piece>,
    /// Loops that were left open, in the direction in which a cover would go around them.
    pub open: Vec<Vec<u32>>,
}

/// A mesh, planes, and the parts that they make.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Slices {
    /// All points: those of the mesh and the constructed ones.
    pub points: Vec<Point>,
    /// The faces of the mesh, counterclockwise as seen from outside.
    pub faces: Vec<Vec<u32>>,
    /// The planes, as three points each.
    pub planes: Vec<[u32; 3]>,
    /// The parts.
    pub parts: Vec<Part>,
}

/// Options of the checks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Expected {
    /// True if the mesh was closed: then the parts must be closed without covers, and their volumes must add up.
    pub is_closed: bool,
    /// True if each triangle must have an area, and must not lie on another. Backends that break ties make triangles
    /// with an area, and parts with a volume, in the perturbed scene only.
    pub has_areas: bool,
    /// True if triangles of a part without a common edge may lie on each other, looking in opposite directions: two
    /// solids of the given mesh may stand on each other.
    pub may_stand: bool,
    /// The maximum number of triangles that are compared with their neighbours; they are spread evenly.
    pub triangles_crossed: usize,
}

/// A law for the parts.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Check {
    /// Each side of a triangle is a side of another triangle of the part, in the other direction.
    Closed,
    /// No part has points on both sides of a plane.
    Side,
    /// Caps are in their planes.
    CapInPlane,
    /// Caps face away from their part.
    CapOrientation,
    /// Pieces of a face are in its plane.
    PieceInFace,
    /// Pieces of a face have its direction.
    PieceOrientation,
    /// The areas of the pieces of a face add up to its area.
    FaceArea,
    /// The volumes of the parts add up to the volume of the mesh.
    Volume,
    /// Triangles have an area.
    Degenerate,
    /// No edge of a part passes through another triangle of the part; covers are left out.
    SelfIntersection,
}

impl Check {
    /// All checks.
    pub const ALL: [Check; 10] = [
        Check::Closed,
        Check::Side,
        Check::CapInPlane,
        Check::CapOrientation,
        Check::PieceInFace,
        Check::PieceOrientation,
        Check::FaceArea,
        Check::Volume,
        Check::Degenerate,
        Check::SelfIntersection,
    ];

    /// The name in findings.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Check::Closed => "part not closed",
            Check::Side => "wrong side",
            Check::CapInPlane => "cap not in its plane",
            Check::CapOrientation => "cap orientation",
            Check::PieceInFace => "piece not in its face",
            Check::PieceOrientation => "piece orientation",
            Check::FaceArea => "face area",
            Check::Volume => "volume",
            Check::Degenerate => "triangle without area",
            Check::SelfIntersection => "self-intersection",
        }
    }

    /// True if the check is about lengths, areas or volumes, so that rounding of vertices alone can violate it. All
    /// other checks are about orientation and topology.
    #[must_use]
    pub const fn is_metric(self) -> bool {
        matches!(self, Check::Side | Check::CapInPlane | Check::PieceInFace | Check::FaceArea | Check::Volume)
    }

    /// The law in a few words.
    #[must_use]
    pub const fn law(self) -> &'static str {
        match self {
            Check::Closed => "each side of a triangle is a side of another triangle, in the opposite direction",
            Check::Side => "a part is on one side of each plane",
            Check::CapInPlane => "caps are in their planes",
            Check::CapOrientation => "caps face away from their part",
            Check::PieceInFace => "the pieces of a face are in its plane",
            Check::PieceOrientation => "the pieces of a face have its orientation",
            Check::FaceArea => "the areas of the pieces of a face add up to its area",
            Check::Volume => "the volumes of the parts add up to the volume of the mesh",
            Check::Degenerate => "each triangle has an area",
            Check::SelfIntersection => "the edges of a part do not pass through its triangles",
        }
    }
}

/// A violation of a law.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Flaw {
    /// The law.
    pub check: Check,
    /// The number of violations.
    pub count: u64,
    /// The points of the first violation.
    pub points: Vec<u32>,
    /// The first violation, in words.
    pub what: String,
}

/// Flaws by check: all are counted, and the first of each check is kept.
#[derive(Default)]
struct Flaws(Vec<Flaw>);

impl Flaws {
    fn add(&mut self, check: Check, points: &[u32], what: impl FnOnce() -> String) {
        match self.0.iter_mut().find(|flaw| flaw.check == check) {
            Some(flaw) => flaw.count += 1,
            None => self.0.push(Flaw { check, count: 1, points: points.to_vec(), what: what() }),
        }
    }
}

impl Slices {
    /// All violated laws, at most one entry for each law.
    ///
    /// # Panics
    /// If an index of a point, a face or a plane is out of range.
    #[must_use]
    pub fn flaws(&self, expected: Expected) -> Vec<Flaw> {
        let (near, mut flaws) = (Near::of(&self.points), Flaws::default());
        self.closed(expected, &mut flaws);
        self.sides(&near, &mut flaws);
        self.faces(&near, expected, &mut flaws);
        if expected.is_closed {
            self.volumes(&near, &mut flaws);
        }
        self.crossings(&near, expected, &mut flaws);
        flaws.0.sort_by_key(|flaw| flaw.check);
        flaws.0
    }

    /// The violated laws about pieces of faces, and about triangles that pass through each other, at most one entry for
    /// each law. It serves for parts that do not come from planes.
    ///
    /// # Panics
    /// As [`Slices::flaws`].
    #[must_use]
    pub fn flaws_of_pieces(&self, expected: Expected) -> Vec<Flaw> {
        let (near, mut flaws) = (Near::of(&self.points), Flaws::default());
        self.faces(&near, expected, &mut flaws);
        self.crossings(&near, expected, &mut flaws);
        flaws.0.sort_by_key(|flaw| flaw.check);
        flaws.0
    }

    /// The violated laws about closed surfaces, at most one entry for each law: each part is closed, each triangle has
    /// an area, and no triangle passes through another triangle, lies on it or has a corner inside it. The options of
    /// `expected` about faces are ignored.
    ///
    /// # Panics
    /// As [`Slices::flaws`].
    #[must_use]
    pub fn flaws_of_surface(&self, expected: Expected) -> Vec<Flaw> {
        let (near, mut flaws) = (Near::of(&self.points), Flaws::default());
        self.closed(expected, &mut flaws);
        let triangles = self.parts.iter().flat_map(|part| &part.triangles);
        triangles.for_each(|&triangle| near.needs_area(triangle, &mut flaws));
        if expected.triangles_crossed > 0 {
            self.crossings(&near, expected, &mut flaws);
        }
        flaws.0.sort_by_key(|flaw| flaw.check);
        flaws.0
    }

    /// The number of triangles in all parts.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.parts.iter().map(|part| part.triangles.len()).sum()
    }

    fn points<const N: usize>(&self, places: [u32; N]) -> [&Point; N] {
        places.map(|place| &self.points[place as usize])
    }
}
