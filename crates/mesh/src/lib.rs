//! Shapes made of a scene's vertices. They hold connectivity only: a shape
//! says *which* vertices, the [`Scene`](predicament_predicates::Scene) says where.

mod polygon;

pub use polygon::{MapError, PolygonMap, Region, Ring};
