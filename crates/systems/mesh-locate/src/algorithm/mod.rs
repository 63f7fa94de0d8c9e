//! Location of points in a multi-material mesh: PinMesh (Franklin and Magalhães, section 4.4; Magalhães, Andrade,
//! Franklin and Li, *PinMesh: fast and exact 3D point location queries using a uniform grid*, 2016).
//!
//! Each set of connected grid cells without triangles lies in one region of the mesh, and so do the points in these
//! cells. That region is found once ([`MeshIndex::labels`]). From any other point a ray goes straight up, to the
//! nearest triangle above; the region is the one below this triangle. The only predicates are `compare`, `orient2d` and
//! `orient3d`, and there is no division:
//! * the ray meets a triangle iff three `orient2d` in the plane across the ray agree, and `orient3d` says that the
//!   point is below;
//! * of two triangles that the ray meets, the nearer is found at a vertex of the common part of their projections: a
//!   corner of one over the other (`orient3d`), or a crossing of two edges (`orient3d` of the four ends). See
//!   `nearer.rs`. If neither is nearer, as with two faces of a sheet without thickness, the sum described below
//!   decides.
//!
//! # Zeros
//! Zeros of exact sessions are ties; perturbed sessions have none:
//! * a point is **on** a triangle if `orient3d` is zero and the point's projection is in that of the triangle, borders
//!   included;
//! * otherwise, where `orient2d` is zero, the ray starts at (ε, ε²) beside the point, in the plane across the ray. The
//!   signs of ε and ε² are differences of coordinates, which `compare` decides. So the ray passes beside all vertices
//!   and edges, and never meets vertical triangles;
//! * under Simulation of Simplicity a point with its own vertex never has a zero, and the answer is that of the
//!   perturbed scene.
//!
//! # Zeros within a band
//! A session with a [reach](predicament_predicates::Predicates::reach) answers zero within a band, where the true sign
//! is not known. Such zeros are not broken edge by edge: the chosen signs might not be those of any ray. The session is
//! queried about every triangle along the ray:
//! * a point is **on** a triangle if its box, enlarged by the reach, holds the point, and all four signs allow it;
//! * the ray passes or misses a triangle if nonzero signs, and boxes, say so;
//! * if it may pass or miss another triangle, the ray does not decide. Then the next of the six rays along the axes is
//!   tried.
//!
//! A point that no ray decides is [`Location::Undecided`].
//!
//! # Meshes that contradict themselves
//! [`MeshIndex::question`] follows the ray to its end and sums up what it passes: at each triangle, plus one for the
//! region before, minus one for the region behind. The sum must be one region, once. Where surfaces cross, or signs
//! contradict each other, it can be another sum: [`Location::Contradiction`]. This method needs no order and no labels,
//! and works along all axes.
//!
//! ```
//! # use predicament_mesh_locate::algorithm::{Location, MeshIndex, locate_all};
//! # use predicament_exact::Exact;
//! # use predicament_mesh::MaterialMesh;
//! # use predicament_predicates::{Backend, Off, Scene, Vertex};
//! let tetrahedron = [[0., 0., 0.], [4., 0., 0.], [0., 4., 0.], [0., 0., 4.]];
//! let scene = Scene::from_points3(&[&tetrahedron[..], &[[1., 1., 1.], [2., 1., 0.]]].concat())?;
//! let corners = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|triangle| triangle.map(Vertex::input));
//! let index = MeshIndex::new(MaterialMesh::of_closed(4, corners.to_vec())?, &scene);
//! let session = Exact.prepare(&scene, Off)?;
//! let answers = locate_all(&index, &session, &[4, 5].map(Vertex::input), &|_| true);
//! assert_eq!(answers, [Location::In(1), Location::On(0)]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod all;
mod at_corner;
mod index;
mod nearer;
mod single;
mod stab;

pub use all::{CHUNK, locate_all, locate_labelled, question_all};
pub use index::{Labels, MeshIndex};
pub use predicament_grid::two_level::Ray;
pub use single::Scratch;

/// The location of a point in a mesh.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Location {
    /// The point is in this region.
    In(u32),
    /// The point is on this triangle: the first of the triangles that contain it.
    On(u32),
    /// The point is in no region, or in several.
    Contradiction,
    /// Not known: along every ray the answer depends on a zero within the session's band.
    Undecided,
}
