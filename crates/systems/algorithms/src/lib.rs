//! The algorithms under test, each generic over
//! [`Predicates`](predicament_predicates::Predicates).
//!
//! An algorithm never names a backend and never looks at a contract: it is
//! written once, as a user would write it, so that differences between answers are
//! the backends'. Raw coordinates serve broad phases only.
//!
//! * [`arrangement`]: two complexes merged where they are in contact.
//! * [`contacts`]: the pairs of simplices of two complexes that meet.
//! * [`crossings`]: all crossings of segments, constructed while it runs.
//! * [`cube_union`]: volume, area and edge length of a union of cubes.
//! * [`delaunay`]: Delaunay triangulations in the plane, with constraints.
//! * [`hull`]: convex hulls in the plane and in space.
//! * [`interval`]: the cell of a line in which a point lies.
//! * [`mesh_locate`]: points in the regions of a mesh, by ray casting through a grid.
//! * [`mod@mesh_overlay`]: two meshes cut where they meet, and Boolean operations on solids.
//! * [`mesh_limit`], [`mesh_rounding`], [`mesh_cascade`]: the results of these as meshes of doubles, step after step.
//! * [`mod@mesh_resolve`]: a mesh that crosses itself, without that.
//! * [`overlay`]: arrangements of segments, and Boolean operations on polygons.
//! * [`polygon_locate`]: points in the regions of a map, by ray casting.
//! * [`mod@slice`]: a mesh split by planes, its parts capped and triangulated.
//! * [`mod@snap`]: segments and their crossings brought back to doubles by snap rounding.
//! * [`sort`]: sorting by signs that may contradict each other.
//! * [`thick`]: vertices and edges with a radius, and what overlaps made to coincide.
//! * [`triangulate`]: triangles of polygons with holes, by ears and by a plane sweep.

pub mod arrangement;
pub mod contacts;
pub mod crossings;
pub mod cube_union;
pub mod delaunay;
pub mod hull;
pub mod interval;
pub mod mesh_cascade;
pub mod mesh_limit;
pub mod mesh_locate;
pub mod mesh_overlay;
pub mod mesh_resolve;
pub mod mesh_rounding;
pub mod overlay;
mod parallel;
pub mod polygon_locate;
pub mod sessions;
pub mod slice;
pub mod snap;
pub mod sort;
mod status;
pub mod thick;
pub mod triangulate;
