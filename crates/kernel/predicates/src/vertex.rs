//! The arguments of predicates: vertices by identity, axes and projections.

use alloc::{borrow::ToOwned, string::String};

/// A vertex of a scene, by identity.
///
/// Symbolic perturbation moves a vertex by its identity (its index in the scene), never by its position in an argument
/// list. A vertex is therefore an opaque id and not a point. Ids below 2^31 are input vertices, whose coordinates are
/// in the scene. Ids from 2^31 up are [constructed](crate::Construction) vertices, which have no coordinates.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[repr(transparent)]
pub struct Vertex(u32);

impl Vertex {
    /// The maximum number of input vertices of a scene.
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

    /// The maximum number of constructed vertices of a scene.
    pub const MAX_CONSTRUCTED: usize = 1 << 31;

    /// The vertex of the construction with this index in its scene.
    ///
    /// # Panics
    /// If `index` is not below [`Vertex::MAX_CONSTRUCTED`].
    #[inline]
    #[must_use]
    pub const fn constructed(index: usize) -> Vertex {
        assert!(index < Vertex::MAX_CONSTRUCTED, "a scene holds at most 2^31 constructed vertices");
        #[allow(clippy::cast_possible_truncation)] // checked above
        Vertex(index as u32 | 1 << 31)
    }

    /// The index of the vertex in the scene.
    ///
    /// The index of a constructed vertex is beyond every input vertex, so a look-up of coordinates cannot confuse the
    /// two.
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Returns true if this is a constructed vertex.
    #[inline]
    #[must_use]
    pub const fn is_constructed(self) -> bool {
        self.0 >= 1 << 31
    }

    /// The index of the vertex's construction in its scene; `None` for an input vertex.
    #[inline]
    #[must_use]
    pub const fn construction(self) -> Option<usize> {
        if self.is_constructed() { Some((self.0 & !(1 << 31)) as usize) } else { None }
    }
}

/// Writes the index, with a `c` before it for constructed vertices.
impl core::fmt::Display for Vertex {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self.construction() {
            None => write!(f, "{}", self.0),
            Some(index) => write!(f, "c{index}"),
        }
    }
}

/// The reason why a text is not a vertex.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ParseVertexError(String);

impl core::fmt::Display for ParseVertexError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "`{}` is not a vertex: neither an index nor c and the index of a construction", self.0)
    }
}

impl core::error::Error for ParseVertexError {}

/// Reads what `Display` writes.
impl core::str::FromStr for Vertex {
    type Err = ParseVertexError;

    fn from_str(text: &str) -> Result<Vertex, ParseVertexError> {
        let (digits, most, vertex): (_, _, fn(usize) -> Vertex) = match text.strip_prefix('c') {
            None => (text, Vertex::MAX_INPUT, Vertex::input),
            Some(digits) => (digits, Vertex::MAX_CONSTRUCTED, Vertex::constructed),
        };
        // `parse` would accept a leading sign.
        let plain = digits.bytes().all(|byte| byte.is_ascii_digit());
        let index = digits.parse().ok().filter(|&index| plain && index < most);
        index.map(vertex).ok_or_else(|| ParseVertexError(text.to_owned()))
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
    /// The index of the axis in a point's coordinates: 0, 1 or 2.
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// A coordinate plane: the two coordinates that a 2D predicate uses.
///
/// A 2D scene has [`Plane::Xy`] only. Each name lists the coordinates in the order in which the 2D predicate takes
/// them, so that the three projections of a 3D orientation are the components of its normal vector.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Plane {
    /// The plane (x, y), seen from above.
    Xy,
    /// The plane (y, z).
    Yz,
    /// The plane (z, x).
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn input_and_constructed_vertices_share_no_id() {
        let last = Vertex::input(Vertex::MAX_INPUT - 1);
        let first = Vertex::constructed(0);
        assert!(last < first && !last.is_constructed() && first.is_constructed());
        assert_eq!((last.construction(), first.construction()), (None, Some(0)));
        assert_eq!(first.index(), Vertex::MAX_INPUT);
        let end = Vertex::constructed(Vertex::MAX_CONSTRUCTED - 1);
        assert_eq!(end.construction(), Some(Vertex::MAX_CONSTRUCTED - 1));
        assert_eq!([last, first, end].map(|v| v.to_string()), ["2147483647", "c0", "c2147483647"]);
        for v in [Vertex::input(0), last, first, end] {
            assert_eq!(v.to_string().parse(), Ok(v));
        }
        for text in ["", "c", "-1", "+1", "c+1", "1.0", "C0", "cc0", "2147483648", "c2147483648", " 1"] {
            assert!(text.parse::<Vertex>().unwrap_err().to_string().contains(text), "{text}");
        }
    }
}
