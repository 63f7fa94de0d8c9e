//! Handles that identify half-edges, vertices and faces of a mesh.

/// The value of a handle that identifies nothing.
pub(super) const NONE: u32 = u32::MAX;

macro_rules! handle {
    ($(#[$doc:meta])* $name:ident, $letter:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        #[repr(transparent)]
        pub struct $name(pub(super) u32);

        impl $name {
            pub(super) const NONE: $name = $name(NONE);

            /// The index in the mesh's arrays: below 2^32 - 2.
            #[inline]
            #[must_use]
            pub const fn index(self) -> usize {
                self.0 as usize
            }

            /// The handle, or `None` if it identifies nothing.
            #[inline]
            pub(super) const fn some(self) -> Option<$name> {
                if self.0 == NONE { None } else { Some(self) }
            }

            /// The handle of an array index.
            #[inline]
            pub(super) fn at(index: usize) -> $name {
                $name(u32::try_from(index).unwrap_or(NONE))
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                write!(f, concat!($letter, "{}"), self.0)
            }
        }
    };
}

handle!(
    /// A half-edge of a mesh: one side of an edge, directed. Displayed as `h7`.
    HalfEdge,
    "h"
);
handle!(
    /// A vertex of a mesh, which refers to a [`Vertex`](predicament_predicates::Vertex) of the scene. Displayed as
    /// `v7`.
    MeshVertex,
    "v"
);
handle!(
    /// A face of a mesh. Displayed as `f7`.
    Face,
    "f"
);
