//! Connectivity: complexes, polygonal maps and half-edge meshes over a scene's vertices. Coordinates stay in
//! the [`Scene`](predicament_predicates::Scene).

mod complex;
mod faces;
pub mod half_edge;
mod polygon;

pub use complex::{Complex, ComplexError, Simplex, Simplices};
pub use faces::Faces;
pub use half_edge::HalfEdgeMesh;
pub use polygon::{MapError, PolygonMap, Region, Ring};
