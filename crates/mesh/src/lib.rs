//! Shapes made of a scene's vertices. They hold connectivity only: a shape
//! says *which* vertices, the [`Scene`](predicament_predicates::Scene) says where.

mod complex;
mod faces;
mod polygon;

pub use complex::{Complex, ComplexError, Simplex, Simplices};
pub use faces::Faces;
pub use polygon::{MapError, PolygonMap, Region, Ring};
