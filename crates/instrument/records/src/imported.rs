//! `imports.csv`: the scenes that were changed when they were read, and the changes.

use crate::{PlannedScene, RowError};

crate::table! {
    /// `imports.csv`: a scene that differs from its files, because numbers were rounded, left out or dropped.
    pub struct ImportRow [Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Default] in "imports.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The task.
        pub task: String,
        /// Coordinates that were rounded from decimals to the nearest doubles.
        pub rounded: u64,
        /// Third coordinates and measures (M values) that were left out.
        pub extra_coordinates: u64,
        /// Points that were dropped because they repeat the point before them.
        pub repeated_points: u64,
        /// Rings that were dropped because they have fewer than three points.
        pub degenerate_rings: u64,
        /// Faces that were dropped because two of their corners coincide.
        pub degenerate_faces: u64,
        /// Regions that were dropped because they have no ring.
        pub empty_regions: u64,
    }

    fn check(&self) -> Result<(), RowError> {
        if self.counts() == [0; 6] { Err(RowError::Contradiction("nothing was changed")) } else { Ok(()) }
    }
}

impl ImportRow {
    /// A row for a scene with all counts 0.
    #[must_use]
    pub fn new(scene: &PlannedScene) -> ImportRow {
        let [suite, scene, scene_id, task] = scene.labels();
        ImportRow { suite, scene, scene_id, task, ..ImportRow::default() }
    }

    /// The counts, in the order of their columns.
    #[must_use]
    pub fn counts(&self) -> [u64; 6] {
        let ImportRow { rounded, extra_coordinates, repeated_points, .. } = *self;
        let ImportRow { degenerate_rings, degenerate_faces, empty_regions, .. } = *self;
        [rounded, extra_coordinates, repeated_points, degenerate_rings, degenerate_faces, empty_regions]
    }
}
