//! Two multi-material meshes overlaid: 3D-EPUG-Overlay (Franklin and Magalhães, section 4.5; Magalhães, *Exact and parallel
//! intersection of 3D triangular meshes*, 2017).
//!
//! # Steps
//! 1. Triangles that may meet the other mesh are found by a bit for each cell of a fine grid (`near.rs`, [`predicament_grid::shared`]);
//!    of a large part that both meshes have, most are set aside where one of them moves as a whole (`same.rs`).
//! 2. Edges of either mesh that pass through triangles of the other are found by `orient3d` of input vertices (`meet.rs`).
//! 3. Their points are constructed in one call, in the order of the triangles, and sorted along their edges by `compare` (`points.rs`).
//! 4. The region of the other mesh that each vertex is in follows from these, along edges that pass through nothing; what
//!    is left is located (`regions.rs`, [`predicament_mesh_locate::algorithm`]).
//! 5. Two triangles meet in a segment. Segments divide a triangle into faces; which, follows from what is beside what
//!    (`arcs.rs`), and from the order of triangles around an edge where more than two share it (`radial.rs`). Faces are triangulated in the
//!    coordinate plane in which the triangle is largest (`cut.rs`, [`mod@predicament_triangulate::algorithm`]).
//! 6. [`MeshOverlay::solid`] takes the surface of a Boolean operation, [`MeshOverlay::regions`] all of it.
//!
//! # Zeros
//! All this is for meshes between which nothing is degenerate, as under Simulation of Simplicity; in the paper one mesh moves by (ε, ε²,
//! ε³), which is `sos:per-mesh` here. A session that says zero where an edge and a triangle touch can have that refused, with the edge and
//! the triangle ([`Zeros::Refused`]), or taken for positive ([`Zeros::Positive`]), which is what programs do that compare with `>=`.
//! A session that registers contacts has its own way ([`mesh_overlay_registered`]).
//! Nothing is asked about two vertices, edges or triangles of one mesh but the order of triangles around an edge, and the plane that a triangle
//! is seen in: each mesh may have coplanar triangles.
//!
//! # What is taken
//! Meshes that do not cross themselves, are not inside out, and whose triangles have an area. Others may break an invariant, which is named
//! ([`Undone::Broken`]), or have a result with the faults of the mesh.
//!
//! # Wrong signs
//! Each loop of the program ends after a number of steps that follows from the input.
//!
//! ```
//! # use std::sync::Arc;
//! # use predicament_mesh_intersect::algorithm::overlay::{Zeros, mesh_overlay};
//! # use predicament_overlay::algorithm::overlay::Operation;
//! # use predicament_exact::Exact;
//! # use predicament_mesh::MaterialMesh;
//! # use predicament_predicates::{Backend, Off, Scene, Vertex};
//! let corners = [[0., 0., 0.], [4., 0., 0.], [0., 4., 0.], [0., 0., 4.]];
//! let moved = corners.map(|[x, y, z]| [x + 0.5, y + 0.25, z + 0.125]);
//! let scene = Scene::from_points3(&[corners, moved].concat())?;
//! let triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|triangle| triangle.map(Vertex::input));
//! let first = Arc::new(MaterialMesh::of_closed(4, triangles.to_vec())?);
//! let second = Arc::new(MaterialMesh::clone(&first).shifted(4));
//! let mut session = Exact.prepare(&scene, Off)?;
//! let overlay = mesh_overlay(&mut session, [first, second], Zeros::Refused)?;
//! // The part of both is a smaller tetrahedron: one face of the first, three of the second, two of them cut off.
//! assert_eq!(overlay.solid(Operation::Intersection).triangles.len(), 4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arcs;
mod contradiction;
mod cut;
mod known;
mod meet;
mod near;
mod points;
mod radial;
mod regions;
mod registered;
mod result;
mod same;

use std::num::NonZero;
use std::sync::Arc;

use predicament_grid::Bounds;
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Construction, Predicates, Refused, Vertex};

pub use crate::answer::{Regions, Source};
pub use contradiction::{Contradiction, SurfaceContradiction};
pub use registered::{Registered, mesh_overlay_registered};
pub use result::Solid;

use self::cut::Cutting;
use self::meet::{Hit, Question};
use self::near::Near;
pub(crate) use self::near::number;
use self::points::Points;
use self::regions::Known;

/// What a zero between the two meshes is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Zeros {
    /// Where an edge and a triangle touch, there is no result.
    Refused,
    /// Positive.
    Positive,
}

/// An edge of one mesh that touches a triangle of the other: with an end, with a border, or along a part.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Touch {
    /// The mesh of the edge: 0 for the first.
    pub mesh: u8,
    /// The ends of the edge.
    pub edge: [Vertex; 2],
    /// The place of the triangle in the other mesh.
    pub triangle: u32,
}

/// Why there is no overlay.
#[derive(Clone, PartialEq, Debug)]
pub enum Undone {
    /// An edge and a triangle touch.
    Touch(Touch),
    /// Two simplices that are less than an edge and a triangle are registered as in contact: the vertices of the first mesh's, and of the second's.
    Contact([Vec<Vertex>; 2]),
    /// The session does not construct a point.
    Refused(Refused),
    /// Signs contradict each other: the first rule that does not hold.
    Broken(Contradiction),
}

impl From<Refused> for Undone {
    fn from(why: Refused) -> Undone {
        Undone::Refused(why)
    }
}

impl std::fmt::Display for Undone {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Undone::Touch(Touch { mesh, edge: [a, b], triangle }) => write!(
                f,
                "the edge of vertices {a} and {b} of the {} mesh touches triangle {triangle} of the other",
                ["first", "second"][usize::from(*mesh)]
            ),
            Undone::Contact(simplices) => {
                let [first, second] = simplices.each_ref().map(|simplex| {
                    let kind = ["vertex", "edge", "triangle"].get(simplex.len().wrapping_sub(1)).unwrap_or(&"simplex");
                    let vertices: Vec<String> = simplex.iter().map(Vertex::to_string).collect();
                    format!("{kind} {}", vertices.join(" "))
                });
                write!(f, "{first} of the first mesh is within the tolerance of {second} of the second")
            }
            Undone::Refused(why) => why.fmt(f),
            Undone::Broken(broken) => broken.fmt(f),
        }
    }
}

impl std::error::Error for Undone {}

/// A part of a triangle that is in one region of the other mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Piece {
    /// Turned as the triangle is.
    pub triangle: [Vertex; 3],
    /// The place of the triangle in its mesh.
    pub of: u32,
    /// The region of the other mesh.
    pub region: u32,
}

/// Two meshes, cut where they meet.
#[derive(Clone, Debug)]
pub struct MeshOverlay {
    meshes: [Arc<MaterialMesh>; 2],
    /// For each triangle of either mesh one more than the region of the other that it is in; none where it is cut.
    whole: [Vec<Option<NonZero<u32>>>; 2],
    /// The pieces of triangles that are cut, in their order.
    pieces: [Vec<Piece>; 2],
    constructions: Vec<Construction>,
}

impl MeshOverlay {
    /// The meshes.
    #[must_use]
    pub fn meshes(&self) -> &[Arc<MaterialMesh>; 2] {
        &self.meshes
    }

    /// The pieces of the triangles of the first mesh, 0, or the second, 1, that the other one cuts, in their order.
    ///
    /// # Panics
    /// If there is no such mesh.
    #[must_use]
    pub fn pieces(&self, mesh: usize) -> &[Piece] {
        &self.pieces[mesh]
    }

    /// How much memory it takes besides the meshes, in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let whole: usize = self.whole.iter().map(|whole| size_of_val(&whole[..])).sum();
        let pieces: usize = self.pieces.iter().map(|pieces| size_of_val(&pieces[..])).sum();
        whole + pieces + size_of_val(&self.constructions[..])
    }

    /// What the overlay was the first to construct in the session, in the order of the vertices: all of its points in a new session.
    #[must_use]
    pub fn constructions(&self) -> &[Construction] {
        &self.constructions
    }
}

/// Overlays two meshes, over vertices of their own in one scene.
///
/// # Errors
/// [`Undone`] where a session that says zero has that refused, does not construct a point, or has signs that break an invariant.
pub fn mesh_overlay(
    session: &mut dyn Predicates,
    meshes: [Arc<MaterialMesh>; 2],
    zeros: Zeros,
) -> Result<MeshOverlay, Undone> {
    run(session, meshes, zeros, Extent::Whole, &mut |_| {})
}

/// What an overlay does, in this order.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Step {
    /// Triangles that may meet the other mesh are found.
    Near,
    /// Edges that pass through triangles are found.
    Passages,
    /// Their points are constructed, and sorted.
    Points,
    /// The region of each vertex is found.
    Regions,
    /// Triangles are cut.
    Faces,
}

/// [`mesh_overlay`], which says when each step is done.
///
/// # Errors
/// As [`mesh_overlay`].
pub fn mesh_overlay_by_steps(
    session: &mut dyn Predicates,
    meshes: [Arc<MaterialMesh>; 2],
    zeros: Zeros,
    done: &mut dyn FnMut(Step),
) -> Result<MeshOverlay, Undone> {
    run(session, meshes, zeros, Extent::Whole, done)
}

/// How much of two meshes there is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Extent {
    /// All of both.
    Whole,
    /// Of each all triangles above and below the box of the other one, and those that meet it, at least.
    Columns,
}

/// [`mesh_overlay`] of parts of two closed meshes ([`Extent::Columns`]).
pub(crate) fn overlay_of_columns(
    session: &mut dyn Predicates,
    meshes: [Arc<MaterialMesh>; 2],
    zeros: Zeros,
) -> Result<MeshOverlay, Undone> {
    run(session, meshes, zeros, Extent::Columns, &mut |_| {})
}

/// An overlay of the whole of two meshes, or of columns.
fn run(
    session: &mut dyn Predicates,
    meshes: [Arc<MaterialMesh>; 2],
    zeros: Zeros,
    extent: Extent,
    done: &mut dyn FnMut(Step),
) -> Result<MeshOverlay, Undone> {
    let before = session.scene().constructions().len();
    let both = [&*meshes[0], &*meshes[1]];
    let asked = if extent == Extent::Whole { same::asked_about(session, both) } else { None };
    let (near, bounds) = Near::of(session.scene(), both, asked);
    done(Step::Near);
    let near = [&near[0], &near[1]];
    let hits = |mesh: u8| {
        let [own, other] = [usize::from(mesh), usize::from(1 - mesh)];
        let session = &*session;
        Question { session, mesh, edges: near[own], of: both[other], triangles: near[other], zeros }.hits()
    };
    let hits = [hits(0).map_err(Undone::Touch)?, hits(1).map_err(Undone::Touch)?];
    done(Step::Passages);
    finish(session, &meshes, before, (near, &bounds), hits, extent, done)
}

/// The steps after it is known what passes through what.
fn finish(
    session: &mut dyn Predicates,
    meshes: &[Arc<MaterialMesh>; 2],
    before: usize,
    (near, bounds): ([&Near; 2], &[Bounds<3>; 2]),
    [first, second]: [Vec<Hit>; 2],
    extent: Extent,
    done: &mut dyn FnMut(Step),
) -> Result<MeshOverlay, Undone> {
    let both = [&*meshes[0], &*meshes[1]];
    let vertices = points::construct(session, [&first, &second], near, both)?;
    let session = &*session;
    let points =
        [Points::new(session, near[0], first, &vertices[0]), Points::new(session, near[1], second, &vertices[1])];
    done(Step::Points);
    let points = [&points[0], &points[1]];
    let regions = regions::regions(&Known { session, meshes, near, points, bounds, extent })?;
    done(Step::Regions);
    let mut whole = [0, 1].map(|own: usize| {
        let region = |&[v, ..]: &[Vertex; 3]| NonZero::new(regions[own].of(v).wrapping_add(1));
        predicament_grid::parallel::all(both[own].triangles(), &region)
    });
    let mut pieces = [Vec::new(), Vec::new()];
    for own in 0..2 {
        let cutting = Cutting {
            session,
            mesh: both[own],
            near: near[own],
            own: points[own],
            other: both[1 - own],
            other_near: near[1 - own],
            others: points[1 - own],
            regions: &regions[own],
        };
        let count = number(near[own].triangles.len());
        let cut: Vec<u32> = (0..count).filter(|&place| cutting.is_cut(place)).collect();
        for part in predicament_grid::parallel::each(cut.len(), &|at| cutting.pieces(cut[at])) {
            pieces[own].extend(part.map_err(Undone::Broken)?);
        }
        cut.iter().for_each(|&place| whole[own][near[own].triangles[place as usize] as usize] = None);
    }
    let constructions = session.scene().constructions()[before..].to_vec();
    done(Step::Faces);
    Ok(MeshOverlay { meshes: meshes.clone(), whole, pieces, constructions })
}
