//! An element of a PLY file with its relevant properties.

use ply_rs_bw::ply::{ElementDef, Property, PropertyAccess, PropertyAccessResult};

use crate::CorpusError;

/// An element of any kind: the values of its relevant properties.
pub(super) struct Element {
    /// The values of `x`, `y` and `z`; NaN if missing.
    pub(super) at: [f64; 3],
    /// The list `vertex_indices`, also called `vertex_index`; `None` if an index is negative.
    pub(super) corners: Option<Vec<u32>>,
}

/// The axis of a vertex property that is a coordinate.
pub(super) fn axis(name: &str) -> Option<usize> {
    ["x", "y", "z"].iter().position(|axis| *axis == name)
}

/// True if a property of a face is the list of its vertices.
pub(super) fn is_corners(name: &str) -> bool {
    matches!(name, "vertex_indices" | "vertex_index")
}

impl PropertyAccess for Element {
    fn new() -> Element {
        Element { at: [f64::NAN; 3], corners: None }
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if is_corners(name) {
            self.corners = property.to_u32_list();
            return PropertyAccessResult::Set;
        }
        let Some(axis) = axis(name) else { return PropertyAccessResult::Ignored };
        self.at[axis] = match property {
            Property::Char(x) => x.into(),
            Property::UChar(x) => x.into(),
            Property::Short(x) => x.into(),
            Property::UShort(x) => x.into(),
            Property::Int(x) => x.into(),
            Property::UInt(x) => x.into(),
            Property::Float(x) => x.into(),
            Property::Double(x) => x,
            _ => return PropertyAccessResult::Ignored,
        };
        PropertyAccessResult::Set
    }
}

/// The error for a file that ends before, or in, an element.
pub(super) fn ended(file: &str, kind: &ElementDef, index: usize) -> CorpusError {
    let message = format!("the file ends after {index} of its {} elements `{}`", kind.count, kind.name);
    CorpusError::file(file, message, "correct the counts or add what is missing")
}
