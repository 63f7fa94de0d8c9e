//! Importers of meshes, maps and other geometry.

mod features;
mod geojson;
pub mod geometry;
mod imported_mesh;
pub mod mesh;
mod obj;
mod off;
mod places;
mod ply;
mod ply_ascii;
mod ply_element;
mod ply_header;
pub mod points;
mod rings;
mod shared;
mod stl;
pub mod topojson;
mod wkt;

use predicament_mesh::PolygonMap;

use serde_json::Value;

pub use places::Places;
pub use rings::read_polygons;

/// A map and its vertices' coordinates.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ImportedMap {
    /// The coordinates of each vertex.
    pub points: Vec<[f64; 2]>,
    /// The regions.
    pub map: PolygonMap,
    /// Counts of what the reader left out or changed.
    pub notes: ImportNotes,
}

/// A filter that returns true for the regions of a file to read, by number (from 0 in the file's order) and by id.
pub type Keeps<'k> = dyn FnMut(usize, Option<&str>) -> bool + 'k;

/// The text of a name or an id, which may be written as a number.
fn id_text(value: Option<&Value>) -> Option<String> {
    match value {
        Some(Value::String(name)) => Some(name.clone()),
        Some(value @ Value::Number(_)) => Some(value.to_string()),
        _ => None,
    }
}

/// Counts of what a reader left out or changed; reports show them.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ImportNotes {
    /// Coordinates that are the nearest doubles of other decimals, by `round = true`.
    pub rounded: usize,
    /// Third coordinates dropped for flat tasks, and measures (M) dropped in all tasks.
    pub extra_coordinates: usize,
    /// Points dropped because they repeat the point before them in their ring or line.
    pub repeated_points: usize,
    /// Rings dropped because fewer than three points were left.
    pub degenerate_rings: usize,
    /// Faces dropped because two of their corners coincide.
    pub degenerate_faces: usize,
    /// Regions dropped because no ring was left.
    pub empty_regions: usize,
}

impl ImportNotes {
    /// Adds the counts of another importer.
    pub fn add(&mut self, other: &ImportNotes) {
        self.rounded += other.rounded;
        self.extra_coordinates += other.extra_coordinates;
        self.repeated_points += other.repeated_points;
        self.degenerate_rings += other.degenerate_rings;
        self.degenerate_faces += other.degenerate_faces;
        self.empty_regions += other.empty_regions;
    }

    /// True if nothing was left out or changed.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        *self == ImportNotes::default()
    }
}

impl std::fmt::Display for ImportNotes {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let all = [
            (self.rounded, "decimals rounded"),
            (self.extra_coordinates, "third coordinates or measures left out"),
            (self.repeated_points, "repeated points dropped"),
            (self.degenerate_rings, "degenerate rings dropped"),
            (self.degenerate_faces, "degenerate faces dropped"),
            (self.empty_regions, "empty regions dropped"),
        ];
        let some = all.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}"));
        f.write_str(&some.collect::<Vec<_>>().join(", "))
    }
}
