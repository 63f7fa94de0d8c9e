//! Connectivity: complexes and polygonal maps over a scene's vertices. Coordinates stay in
//! the [`Scene`](predicament_predicates::Scene).

mod complex;
mod faces;
mod polygon;

pub use complex::{Complex, ComplexError, Simplex, Simplices};
pub use faces::Faces;
pub use polygon::{MapError, PolygonMap, Region, Ring};
