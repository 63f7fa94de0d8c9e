//! Which region of a multi-material mesh a point is in: PinMesh (Franklin and Magalhães, section 4.4; Magalhães, Andrade,
//! Franklin and Li, *PinMesh: fast and exact 3D point location queries using a uniform grid*, 2016).
//!
//! A point in a cell of the grid that lists no triangle is in the region of all cells around that list none, which is found once
//! ([`MeshIndex::labels`]). From other points a ray goes straight up, to the nearest triangle above: the region is that below this triangle.
//! Only `compare`, `orient2d` and `orient3d` are asked, and nothing is divided:
//! * the ray meets a triangle iff three `orient2d` in the plane across the ray agree, and `orient3d` says that the point is
//!   below;
//! * of two triangles that it meets the nearer is found at a vertex of the part that their projections share: a corner of the
//!   one over the other (`orient3d`), or a crossing of two edges (`orient3d` of the four ends). See `nearer.rs`. Where neither is
//!   nearer, as of two faces of a sheet without thickness, the sum below decides.
//!
//! # Zeros
//! Zeros of exact sessions are ties, and perturbed sessions have none:
//! * a point with a zero `orient3d`, whose projection is in that of the triangle, borders included, is **on** the triangle;
//! * else, where `orient2d` is zero, the ray is taken at (ε, ε²) beside the point, in the plane across the ray: the signs of ε and ε²
//!   are differences of coordinates, which `compare` tells. So the ray passes beside all vertices and edges, and vertical
//!   triangles are never met;
//! * under Simulation of Simplicity no zero comes up for a point that is a vertex of its own, and the answer is that of the perturbed scene.
//!
//! # Zeros within a band
//! A session with a [reach](predicament_predicates::Predicates::reach) answers zero within a band, where the true sign is not known. No zero is
//! broken there, edge by edge: signs that were chosen so need not be those of any ray. Every triangle along the ray is asked about, and
//! * a point is **on** a triangle if its box, drawn out by the reach, holds the point, and all four signs allow it;
//! * a triangle is passed or missed where signs that are not zero, and boxes, say so;
//! * if another triangle may be passed or not, the ray does not decide. Then the next of the six rays along the axes is asked.
//!
//! A point that no ray decides about is [`Location::Undecided`].
//!
//! # Meshes that contradict themselves
//! [`MeshIndex::question`] follows the ray to its end and adds up what it passes: at each triangle one of the region before, less
//! one of the region behind. What is left has to be one region, once. Where surfaces cross, or signs contradict each
//! other, it can be another sum: [`Location::Contradiction`]. It needs no order, no labels, and goes along all axes.
//!
//! ```
//! # use predicament_mesh_locate::algorithm::{Location, MeshIndex, locate_all};
//! # use predicament_exact::Exact;
//! # use predicament_mesh::MaterialMesh;
//! # use predicament_predicates::{Backend, Off, Scene, Vertex};
//! let scene = Scene::from_points3(&[[0., 0., 0.], [4., 0., 0.], [0., 4., 0.], [0., 0., 4.], [1., 1., 1.], [2., 1., 0.]])?;
//! let corners = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|triangle| triangle.map(Vertex::input));
//! let index = MeshIndex::new(MaterialMesh::of_closed(4, corners.to_vec())?, &scene);
//! let session = Exact.prepare(&scene, Off)?;
//! let answers = locate_all(&index, &session, &[4, 5].map(Vertex::input), &|_| true);
//! assert_eq!(answers, [Location::In(1), Location::On(0)]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod all;
mod index;
mod nearer;
mod single;
mod stab;

pub use all::{CHUNK, locate_all, locate_labelled, question_all};
pub use index::{Labels, MeshIndex};
pub use predicament_grid::two_level::Ray;
pub use single::Scratch;

/// Where a point is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Location {
    /// In this region.
    In(u32),
    /// On this triangle, the first of those that it is on.
    On(u32),
    /// In no region, or in several.
    Contradiction,
    /// Not known: a zero within the session's band decides along every ray.
    Undecided,
}
