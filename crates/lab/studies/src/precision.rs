//! The binary formats of the tolerance backend.

/// The binary format of coordinates.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Precision {
    /// Double precision: `f64`, ε = 2⁻⁵².
    Double,
    /// Single precision: `f32`, ε = 2⁻²³; doubles can represent all its values.
    Single,
}

impl Precision {
    /// Both precisions.
    pub const ALL: [Precision; 2] = [Precision::Double, Precision::Single];

    /// The type's name, such as `f64`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Precision::Double => "f64",
            Precision::Single => "f32",
        }
    }

    /// The precision of the scenes that a backend accepts.
    #[must_use]
    pub fn of_backend(name: &str) -> Precision {
        if name.ends_with(":f32") { Precision::Single } else { Precision::Double }
    }

    /// The tolerance backend of this precision.
    #[must_use]
    pub const fn tolerance(self) -> &'static str {
        match self {
            Precision::Double => "tolerance",
            Precision::Single => "tolerance:f32",
        }
    }
}
