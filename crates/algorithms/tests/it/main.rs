//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod common;
mod contacts;
mod contacts_by_signs;
mod contacts_driver;
mod delaunay;
mod delaunay_signs;
mod hull_plane;
mod hull_signs;
mod hull_space;
mod mesh_limit;
mod mesh_locate;
mod mesh_locate_scale;
mod mesh_overlay;
mod mesh_overlay_registered;
mod mesh_overlay_signs;
mod mesh_resolve;
mod mesh_rounding;
mod overlay;
mod overlay_near;
mod polygon_locate;
mod polygon_shapes;
mod polygon_special;
mod slice;
mod sort;
mod thick;
mod triangulate;
