//! The names that programs pass as numbers.

/// A coordinate axis.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum predicament_axis {
    /// The first coordinate.
    PREDICAMENT_X = 0,
    /// The second coordinate.
    PREDICAMENT_Y = 1,
    /// The third coordinate.
    PREDICAMENT_Z = 2,
}

/// The two coordinates that orient2d uses of a point in space. A scene of the plane has PREDICAMENT_XY only.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum predicament_plane {
    /// The coordinates x and y.
    PREDICAMENT_XY = 0,
    /// The coordinates y and z.
    PREDICAMENT_YZ = 1,
    /// The coordinates z and x.
    PREDICAMENT_ZX = 2,
}

/// The meaning of the signs of a scene.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum predicament_backend {
    /// The sign of the real determinant. Zero means exactly zero.
    PREDICAMENT_EXACT = 0,
    /// Simulation of Simplicity: ties are broken consistently, as if each vertex had moved by its own infinitesimal.
    /// A sign about distinct input vertices is never zero. A vertex is identified by its index.
    PREDICAMENT_SOS = 1,
}

/// The bit that the ids of constructed vertices have and the indices of points do not have.
pub const PREDICAMENT_CONSTRUCTED: u32 = 0x8000_0000;
