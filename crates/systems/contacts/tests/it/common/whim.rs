//! A session that registers random pairs within its reach: it registers sub-pairs of every kind, including
//! geometrically impossible ones.

use std::hash::{DefaultHasher, Hash, Hasher};

use predicament_predicates::{Axis, Declined, Dimension, Plane, Predicates, Scene, Sign, Vertex};

/// A session that answers yes to one of `odds` queries about boxes within reach, and always to a query of a vertex with
/// itself.
pub struct Whim<'s> {
    pub scene: &'s Scene,
    pub reach: f64,
    pub odds: u64,
}

impl Whim<'_> {
    fn fraction(&self, first: &[Vertex], second: &[Vertex]) -> Option<f64> {
        let axes = match self.scene.dimension() {
            Dimension::Two => &[Axis::X, Axis::Y][..],
            Dimension::Three => &[Axis::X, Axis::Y, Axis::Z],
        };
        // coordinates are small integers and the reach half of one: no rounding
        let near = axes.iter().all(|&axis| {
            let ends = |cell: &[Vertex]| {
                let along: Vec<f64> = cell.iter().map(|&v| self.scene.coordinate(axis, v)).collect();
                [along.iter().copied().fold(f64::MAX, f64::min), along.iter().copied().fold(f64::MIN, f64::max)]
            };
            let ([low, high], [other_low, other_high]) = (ends(first), ends(second));
            low - other_high <= self.reach && other_low - high <= self.reach
        });
        let mut hasher = DefaultHasher::new();
        (first, second).hash(&mut hasher);
        let hash = hasher.finish();
        #[allow(clippy::cast_precision_loss)] // any fraction will do
        (near && hash.is_multiple_of(self.odds)).then_some((hash >> 40) as f64 / (1_u64 << 24) as f64)
    }
}

impl Predicates for Whim<'_> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn supports_contacts(&self) -> Result<(), Declined> {
        Ok(())
    }

    fn reach(&self) -> f64 {
        self.reach
    }

    fn compare(&self, _: Axis, _: Vertex, _: Vertex) -> Sign {
        unreachable!("contacts are not by signs")
    }

    fn orient2d(&self, _: Plane, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("contacts are not by signs")
    }

    fn orient3d(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("contacts are not by signs")
    }

    fn incircle(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("contacts are not by signs")
    }

    fn insphere(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("contacts are not by signs")
    }

    fn vertex_vertex(&self, a: Vertex, p: Vertex) -> bool {
        a == p || self.fraction(&[a], &[p]).is_some()
    }

    fn edge_vertex(&self, edge: [Vertex; 2], p: Vertex) -> Option<f64> {
        self.fraction(&edge, &[p])
    }

    fn edge_edge(&self, e: [Vertex; 2], f: [Vertex; 2]) -> Option<[f64; 2]> {
        self.fraction(&e, &f).map(|x| [x, x / 2.0])
    }

    fn triangle_vertex(&self, triangle: [Vertex; 3], p: Vertex) -> Option<[f64; 3]> {
        self.fraction(&triangle, &[p]).map(|x| [x, x / 2.0, x / 4.0])
    }

    fn triangle_edge(&self, triangle: [Vertex; 3], edge: [Vertex; 2]) -> Option<([f64; 3], f64)> {
        self.fraction(&triangle, &edge).map(|x| ([x, x / 2.0, x / 4.0], x / 8.0))
    }

    fn tetrahedron_vertex(&self, tetrahedron: [Vertex; 4], p: Vertex) -> Option<[f64; 4]> {
        self.fraction(&tetrahedron, &[p]).map(|x| [x, x / 2.0, x / 4.0, x / 8.0])
    }
}
