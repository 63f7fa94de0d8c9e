//! Predicates of other crates as backends: Simulation of Simplicity, and signs that claim to be certified.
//!
//! Behind the feature `peers`, as nothing here is needed but to be judged and held against
//! the laws. One file a crate says what its conventions are in ours: orientation,
//! identity (a vertex' index is the key, the place in the list, the number), and what
//! it does not have, which is declined. Nothing is repaired on the way.

mod axiolid;
mod delaunay;
mod geogram;
mod hyperlimit;
mod rgeometry;
mod simplicity;

pub use self::axiolid::Axiolid;
pub use self::delaunay::Delaunay;
pub use self::geogram::Geogram;
pub use self::hyperlimit::Hyperlimit;
pub use self::rgeometry::Rgeometry;
pub use self::simplicity::Simplicity;

use predicament_predicates::{
    Axis, Backend, Contract, Declined, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex, ZeroMeaning,
};

/// A vertex as it is handed to a crate.
#[derive(Clone, Copy, Debug)]
pub struct Point<const D: usize> {
    /// Where it is.
    pub at: [f64; D],
    /// Which one it is.
    pub key: usize,
}

/// A crate's predicates in our conventions. Those that it lacks are never asked.
pub trait Library: Copy + Send + Sync {
    /// The name on the command line.
    fn name(&self) -> &'static str;

    /// What a zero of this predicate means; none for a predicate that the crate lacks.
    fn zero(&self, kind: PredicateKind) -> Option<ZeroMeaning>;

    /// The order of two coordinates.
    fn compare(&self, points: [Point<1>; 2]) -> Sign {
        lacking(self, PredicateKind::Compare, &points)
    }

    /// The turn of three points.
    fn orient2d(&self, points: [Point<2>; 3]) -> Sign {
        lacking(self, PredicateKind::Orient2d, &points)
    }

    /// The side of the fourth of four points.
    fn orient3d(&self, points: [Point<3>; 4]) -> Sign {
        lacking(self, PredicateKind::Orient3d, &points)
    }

    /// The sign of the determinant: a fourth point in the circle of three that turn left.
    fn incircle(&self, points: [Point<2>; 4]) -> Sign {
        lacking(self, PredicateKind::Incircle, &points)
    }

    /// The sign of the determinant: a fifth point in the sphere of four that are positive.
    fn insphere(&self, points: [Point<3>; 5]) -> Sign {
        lacking(self, PredicateKind::Insphere, &points)
    }
}

fn lacking<L: Library, const D: usize>(library: &L, kind: PredicateKind, points: &[Point<D>]) -> Sign {
    panic!("{} has no {kind}; {points:?} should not have been asked about", library.name())
}

/// A crate as a backend.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Wild<L>(pub L);

impl<L: Library> Backend for Wild<L> {
    type Session<'s, T: Tally + 's>
        = Session<'s, L, T>
    where
        Self: 's;

    fn name(&self) -> String {
        self.0.name().to_owned()
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        Contract { zero: self.0.zero(kind).unwrap_or(ZeroMeaning::Exact), proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["crate"]
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, L, T>, Declined> {
        if !scene.constructions().is_empty() {
            return Err(Declined::scene("the crate knows no constructed vertices"));
        }
        Ok(Session { library: self.0, scene, tally })
    }
}

/// A crate's session for a scene; nothing is prepared.
pub struct Session<'s, L, T> {
    library: L,
    scene: &'s Scene,
    tally: T,
}

impl<L: Library, T: Tally> Session<'_, L, T> {
    fn points<const D: usize, const N: usize>(&self, axes: [Axis; D], vertices: [Vertex; N]) -> [Point<D>; N] {
        vertices.map(|v| Point { at: axes.map(|axis| self.scene.coordinate(axis, v)), key: v.index() })
    }

    fn settled(&self, kind: PredicateKind, sign: Sign) -> Sign {
        self.tally.settled(kind, 0);
        sign
    }
}

impl<L: Library, T: Tally> Predicates for Session<'_, L, T> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.scene.has_dimension_for(kind)?;
        let lacks = || Declined::predicate(kind, format!("{} has no such predicate", self.library.name()));
        self.library.zero(kind).map(|_| ()).ok_or_else(lacks)
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.settled(PredicateKind::Compare, self.library.compare(self.points([axis], [a, b])))
    }

    /// In the plane of z and x the crate gets (x, z), as it would if it projected the points
    /// by itself: which coordinate moves further must not depend on the order that we list them in.
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let sign = match plane {
            Plane::Zx => -self.library.orient2d(self.points([Axis::X, Axis::Z], [a, b, c])),
            _ => self.library.orient2d(self.points(plane.axes(), [a, b, c])),
        };
        self.settled(PredicateKind::Orient2d, sign)
    }

    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let points = self.points([Axis::X, Axis::Y, Axis::Z], [a, b, c, d]);
        self.settled(PredicateKind::Orient3d, self.library.orient3d(points))
    }

    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let points = self.points([Axis::X, Axis::Y], [a, b, c, d]);
        self.settled(PredicateKind::Incircle, self.library.incircle(points))
    }

    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        let points = self.points([Axis::X, Axis::Y, Axis::Z], [a, b, c, d, e]);
        self.settled(PredicateKind::Insphere, self.library.insphere(points))
    }
}

/// The points in the order of their keys, and the sign of bringing them there; zero if two are the same.
fn sorted<const D: usize, const N: usize>(mut points: [Point<D>; N]) -> ([Point<D>; N], Sign) {
    let mut parity = Sign::Positive;
    for end in (1..N).rev() {
        for at in 0..end {
            if points[at].key > points[at + 1].key {
                points.swap(at, at + 1);
                parity = -parity;
            }
        }
    }
    let twice = points.windows(2).any(|pair| pair[0].key == pair[1].key);
    (points, if twice { Sign::Zero } else { parity })
}
