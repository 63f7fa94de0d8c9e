//! Who is asked about: vertices by identity, axes and projections.

/// A vertex of a scene, by identity.
///
/// Symbolic perturbation moves a vertex by what it *is* (its index in the
/// scene), never by where it stands in an argument list, so a vertex is an
/// opaque id and not a point. Today every id is an input vertex; the ids from
/// 2^31 up are kept free for vertices constructed by a session.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[repr(transparent)]
pub struct Vertex(u32);

impl Vertex {
    /// The number of input vertices that a scene can have.
    pub const MAX_INPUT: usize = 1 << 31;

    /// The input vertex with this index in its scene.
    ///
    /// # Panics
    /// If `index` is not below [`Vertex::MAX_INPUT`].
    #[inline]
    #[must_use]
    pub const fn input(index: usize) -> Vertex {
        assert!(index < Vertex::MAX_INPUT, "a scene holds at most 2^31 input vertices");
        #[allow(clippy::cast_possible_truncation)] // checked above
        Vertex(index as u32)
    }

    /// The index in the scene.
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl std::fmt::Display for Vertex {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.0)
    }
}

/// A coordinate axis.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Axis {
    /// The first coordinate.
    X,
    /// The second coordinate.
    Y,
    /// The third coordinate; only 3D scenes have it.
    Z,
}

impl Axis {
    /// The place of the axis' coordinate in a point: 0, 1 or 2.
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// A coordinate plane: which two coordinates a 2D question is about.
///
/// A 2D scene has [`Plane::Xy`] only. Each name lists the coordinates in the
/// order in which the 2D predicate takes them, so that the three projections
/// of a 3D orientation are the components of its normal vector.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Plane {
    /// (x, y): seen from above.
    Xy,
    /// (y, z).
    Yz,
    /// (z, x).
    Zx,
}

impl Plane {
    /// The two axes, in the order in which the predicate takes them.
    #[inline]
    #[must_use]
    pub const fn axes(self) -> [Axis; 2] {
        match self {
            Plane::Xy => [Axis::X, Axis::Y],
            Plane::Yz => [Axis::Y, Axis::Z],
            Plane::Zx => [Axis::Z, Axis::X],
        }
    }
}
