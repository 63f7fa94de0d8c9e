//! The parts that planes make of a mesh, decided in rationals.
//!
//! Nothing here knows how the parts were made: there are points, triangles, the faces and planes that were given, and
//! for each triangle what it is said to be a piece of. Each [`Check`] is a law that the parts have to satisfy; together
//! they say that the parts are solids, that they are on their sides, and that nothing was lost.
//!
//! # Volumes
//! Six times the volume of a solid is the sum of the determinants of its triangles. A sum of many
//! rationals without common factors has as many digits as all of them. So the difference of all parts and the whole is
//! summed face by face and plane by plane: where all is well each of these sums is zero.

mod closed;
mod crossing;
mod exact;
mod flat;
mod volume;

use exact::Point;

/// What a triangle is said to be a piece of.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Piece {
    /// A face that was given.
    Face(usize),
    /// A plane that was given.
    Cap(usize),
    /// Neither: the cover of a loop.
    Cover,
}

/// The triangles of one part, by places in the list of points.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Part {
    /// Counterclockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// As many as triangles.
    pub pieces: Vec<Piece>,
    /// Loops that were left open, as a cover would go around them.
    pub open: Vec<Vec<u32>>,
}

/// A mesh, planes, and what they made of it.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Slices {
    /// All points, those of the mesh and those that were constructed.
    pub points: Vec<Point>,
    /// The faces of the mesh, counterclockwise as seen from outside.
    pub faces: Vec<Vec<u32>>,
    /// The planes, three points of each.
    pub planes: Vec<[u32; 3]>,
    /// The parts.
    pub parts: Vec<Part>,
}

/// What is expected.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Expected {
    /// The mesh was closed: the parts have to be, without covers, and their volumes add up.
    pub is_closed: bool,
    /// Each triangle has to have an area, and none lies on another. What breaks ties makes triangles that have an area, and
    /// parts that have a volume, in the perturbed scene only.
    pub has_areas: bool,
    /// How many triangles are held against their neighbours, at most; they are spread evenly.
    pub triangles_crossed: usize,
}

/// A law.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Check {
    /// Each side of a triangle is that of another one of the part, in the other direction.
    Closed,
    /// No part has points on both sides of a plane.
    Side,
    /// Caps are in their planes.
    CapInPlane,
    /// Caps face away from their part.
    CapOrientation,
    /// Pieces of a face are in its plane.
    PieceInFace,
    /// Pieces of a face face where it does.
    PieceOrientation,
    /// The areas of the pieces of a face add up to its area.
    FaceArea,
    /// The volumes of the parts add up to that of the mesh.
    Volume,
    /// Triangles have an area.
    Degenerate,
    /// No edge of a part passes through another of its triangles; covers are left out.
    SelfIntersection,
}

impl Check {
    /// All of them.
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

    /// Whether it is about lengths, areas or volumes, so that vertices that are rounded are enough to violate it. All others are
    /// about how things turn and hang together.
    #[must_use]
    pub const fn is_metric(self) -> bool {
        matches!(self, Check::Side | Check::CapInPlane | Check::PieceInFace | Check::FaceArea | Check::Volume)
    }

    /// What should hold, in a few words.
    #[must_use]
    pub const fn law(self) -> &'static str {
        match self {
            Check::Closed => "each side of a triangle is one of another, in the other direction",
            Check::Side => "a part is on one side of each plane",
            Check::CapInPlane => "caps are in their planes",
            Check::CapOrientation => "caps face away from their part",
            Check::PieceInFace => "pieces of a face are in its plane",
            Check::PieceOrientation => "pieces of a face face where it does",
            Check::FaceArea => "areas of the pieces of a face add up to its area",
            Check::Volume => "volumes of the parts add up to that of the mesh",
            Check::Degenerate => "each triangle has an area",
            Check::SelfIntersection => "no edge of a part passes through one of its triangles",
        }
    }
}

/// What violates a law.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Flaw {
    /// The law.
    pub check: Check,
    /// How often.
    pub count: u64,
    /// The points of the first that does.
    pub points: Vec<u32>,
    /// The first that does, in words.
    pub what: String,
}

/// Flaws by check: all are counted, the first of each is kept.
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
    /// Everything that violates a law, at most one entry a law.
    ///
    /// # Panics
    /// If a place is none of the points', faces' or planes'.
    #[must_use]
    pub fn flaws(&self, expected: Expected) -> Vec<Flaw> {
        let mut flaws = Flaws::default();
        self.closed(expected, &mut flaws);
        self.sides(&mut flaws);
        self.faces(expected, &mut flaws);
        if expected.is_closed {
            self.volumes(&mut flaws);
        }
        self.crossings(expected, &mut flaws);
        flaws.0.sort_by_key(|flaw| flaw.check);
        flaws.0
    }

    /// What violates the laws about pieces of faces, and about triangles that pass through each other, at most one entry a law: for parts that are not
    /// what planes leave.
    ///
    /// # Panics
    /// As [`Slices::flaws`].
    #[must_use]
    pub fn flaws_of_pieces(&self, expected: Expected) -> Vec<Flaw> {
        let mut flaws = Flaws::default();
        self.faces(expected, &mut flaws);
        self.crossings(expected, &mut flaws);
        flaws.0.sort_by_key(|flaw| flaw.check);
        flaws.0
    }

    /// What violates the laws about closed surfaces, at most one entry a law: each part is closed, each triangle has an area, and none passes
    /// through another one, lies on it or has a corner inside of it. What `expected` says of faces is left out.
    ///
    /// # Panics
    /// As [`Slices::flaws`].
    #[must_use]
    pub fn flaws_of_surface(&self, expected: Expected) -> Vec<Flaw> {
        let mut flaws = Flaws::default();
        self.closed(expected, &mut flaws);
        self.parts.iter().flat_map(|part| &part.triangles).for_each(|triangle| self.has_area(triangle, &mut flaws));
        if expected.triangles_crossed > 0 {
            self.crossings(expected, &mut flaws);
        }
        flaws.0.sort_by_key(|flaw| flaw.check);
        flaws.0
    }

    /// How many triangles there are in all parts.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.parts.iter().map(|part| part.triangles.len()).sum()
    }

    fn points<const N: usize>(&self, places: [u32; N]) -> [&Point; N] {
        places.map(|place| &self.points[place as usize])
    }
}
