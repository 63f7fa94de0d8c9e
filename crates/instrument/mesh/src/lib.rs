//! Connectivity: complexes, polygonal maps, half-edge meshes and subdivisions of the plane over a scene's vertices.
//!
//! Coordinates stay in the [`Scene`](predicament_predicates::Scene).

mod complex;
mod faces;
pub mod half_edge;
mod length;
mod materials;
mod polygon;
pub mod structures;
mod subdivision;

pub use complex::{Complex, ComplexError, Simplex, Simplices};
pub use faces::{FaceFinder, Faces};
pub use half_edge::HalfEdgeMesh;
pub use materials::{MaterialError, MaterialMesh, OUTSIDE};
pub use polygon::{MapError, PolygonMap, Region, Ring};
pub use subdivision::{Nesting, Sort, Subdivision};
