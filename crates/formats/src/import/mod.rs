//! Importers of meshes and maps.

pub mod mesh;
mod ply;
pub mod topojson;

/// What an importer changed on the way in; never in silence.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ImportNotes {
    /// Points dropped because they repeat the point before them in their ring.
    pub repeated_points: usize,
    /// Rings dropped because fewer than three points were left of them.
    pub degenerate_rings: usize,
    /// Regions dropped because no ring was left of them.
    pub empty_regions: usize,
}

impl ImportNotes {
    /// Adds what another importer changed.
    pub fn add(&mut self, other: &ImportNotes) {
        self.repeated_points += other.repeated_points;
        self.degenerate_rings += other.degenerate_rings;
        self.empty_regions += other.empty_regions;
    }

    /// Whether everything came in as it was.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        *self == ImportNotes::default()
    }
}

impl std::fmt::Display for ImportNotes {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{} repeated points, {} degenerate rings and {} empty regions dropped",
            self.repeated_points, self.degenerate_rings, self.empty_regions
        )
    }
}
