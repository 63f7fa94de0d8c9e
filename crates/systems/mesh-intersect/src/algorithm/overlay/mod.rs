//! Overlay of two multi-material meshes: 3D-EPUG-Overlay (Franklin and Magalhães, section 4.5; Magalhães, *Exact and
//! parallel intersection of 3D triangular meshes*, 2017).
//!
//! # Steps
//! 1. Triangles that may meet the other mesh are found by a bit for each cell of a fine grid (`near.rs`,
//!    [`predicament_grid::shared`]). If both meshes share a large part and one of them moves as a whole, most triangles
//!    of that part are set aside (`same.rs`).
//! 2. Edges of either mesh that pass through triangles of the other are found by `orient3d` of input vertices
//!    (`meet.rs`).
//! 3. Their points are constructed in one call, in the order of the triangles, and sorted along their edges by
//!    `compare` (`points.rs`).
//! 4. The region of the other mesh that contains each vertex follows from these points, along edges that pass through
//!    nothing; remaining vertices are located (`regions.rs`, [`predicament_mesh_locate::algorithm`]).
//! 5. Two triangles meet in a segment. Segments divide a triangle into faces. The faces follow from adjacency
//!    (`arcs.rs`), and from the order of triangles around an edge that more than two share (`radial.rs`). Faces are
//!    triangulated in the coordinate plane in which the triangle has the largest area (`cut.rs`,
//!    [`mod@predicament_triangulate::algorithm`]).
//! 6. [`MeshOverlay::solid`] takes the surface of a Boolean operation, [`MeshOverlay::regions`] all of it.
//!
//! # Zeros
//! The algorithm is for meshes between which nothing is degenerate, as under Simulation of Simplicity; in the paper one
//! mesh moves by (ε, ε², ε³), nearly as under `sos:per-mesh` here. If a session returns zero where an edge and a
//! triangle touch, the overlay goes over to all cases of contact ([`Zeros::Zero`], `touching`), or the zero can count
//! as positive ([`Zeros::Positive`]), as in programs that compare with `>=`. A session that registers contacts has a
//! separate function ([`mesh_overlay_registered`]). Between two vertices, edges or triangles of one mesh, only the
//! order of triangles around an edge and the plane that a triangle is seen in are tested: each mesh may have coplanar
//! triangles.
//!
//! # What is taken
//! Meshes that do not cross themselves, are not inside out, and whose triangles have an area. Other meshes may break an
//! invariant, which is named ([`Undone::Broken`]), or have a result with the faults of the mesh.
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
//! let overlay = mesh_overlay(&mut session, [first, second], Zeros::Zero)?;
//! // The part of both is a smaller tetrahedron: one face of the first, three of the second, two of them cut off.
//! assert_eq!(overlay.solid(Operation::Intersection).triangles.len(), 4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod along;
mod arcs;
mod contradiction;
mod cut;
mod known;
mod manner;
mod meet;
mod near;
mod points;
mod radial;
mod regions;
mod registered;
mod result;
mod same;
mod table;
mod touching;

use std::num::NonZero;
use std::sync::Arc;

use predicament_grid::Bounds;
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Construction, Predicates, Refused, Vertex};

pub use crate::answer::{Contact, Contacts, Regions, Source};
pub use contradiction::{Contradiction, SurfaceContradiction};
pub use manner::mesh_overlay_as_answered;
pub use registered::{Registered, mesh_overlay_registered};
pub use result::Solid;
pub use touching::Shared;

use self::cut::Cutting;
use self::meet::{Hit, Question};
use self::near::Near;
pub(crate) use self::near::number;
use self::points::Points;
use self::regions::Known;

/// The meaning of a zero between the two meshes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Zeros {
    /// A zero is a zero: meshes that touch are overlaid by cases.
    Zero,
    /// A zero counts as positive.
    Positive,
}

/// The reason why there is no overlay.
#[derive(Clone, PartialEq, Debug)]
pub enum Undone {
    /// Two simplices smaller than an edge and a triangle are registered as in contact: the vertices of the first mesh's
    /// simplex, and of the second's.
    Contact([Vec<Vertex>; 2]),
    /// The session does not construct a point.
    Refused(Refused),
    /// Two triangles of one mesh have more in common than whole edges and corners, and zeros mean zero.
    Own {
        /// The index of the mesh.
        mesh: usize,
        /// The indices of the triangles.
        triangles: [u32; 2],
    },
    /// Signs contradict each other: the first rule that fails.
    Broken(Contradiction),
}

impl From<Refused> for Undone {
    fn from(why: Refused) -> Undone {
        Undone::Refused(why)
    }
}

impl From<Contradiction> for Undone {
    fn from(broken: Contradiction) -> Undone {
        Undone::Broken(broken)
    }
}

impl std::fmt::Display for Undone {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Undone::Contact(simplices) => {
                let [first, second] = simplices.each_ref().map(|simplex| {
                    let kind = ["vertex", "edge", "triangle"].get(simplex.len().wrapping_sub(1)).unwrap_or(&"simplex");
                    let vertices: Vec<String> = simplex.iter().map(Vertex::to_string).collect();
                    format!("{kind} {}", vertices.join(" "))
                });
                write!(f, "{first} of the first mesh is within the tolerance of {second} of the second")
            }
            Undone::Refused(why) => why.fmt(f),
            Undone::Own { mesh, triangles: [a, b] } => {
                let mesh = ["first", "second"].get(*mesh).unwrap_or(&"third");
                write!(f, "triangles {a} and {b} of the {mesh} mesh meet otherwise than in whole edges and corners")
            }
            Undone::Broken(broken) => broken.fmt(f),
        }
    }
}

impl std::error::Error for Undone {}

/// A part of a triangle that is in one region of the other mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Piece {
    /// Its vertices, with the triangle's orientation.
    pub triangle: [Vertex; 3],
    /// The index of the triangle in its mesh.
    pub of: u32,
    /// The region of the other mesh.
    pub region: u32,
}

/// Two meshes, cut where they meet.
#[derive(Clone, Debug)]
pub struct MeshOverlay {
    meshes: [Arc<MaterialMesh>; 2],
    /// For each triangle of either mesh, its region of the other mesh plus one; `None` if it is cut.
    whole: [Vec<Option<NonZero<u32>>>; 2],
    /// The pieces of cut triangles, in order.
    pieces: [Vec<Piece>; 2],
    /// The parts of triangles of both meshes, in order.
    shared: Vec<Shared>,
    constructions: Vec<Construction>,
}

impl MeshOverlay {
    /// The meshes.
    #[must_use]
    pub fn meshes(&self) -> &[Arc<MaterialMesh>; 2] {
        &self.meshes
    }

    /// The pieces of cut triangles of the first mesh (0) or the second (1), in order.
    ///
    /// # Panics
    /// If there is no such mesh.
    #[must_use]
    pub fn pieces(&self, mesh: usize) -> &[Piece] {
        &self.pieces[mesh]
    }

    /// The parts of triangles of both meshes that coincide.
    #[must_use]
    pub fn shared(&self) -> &[Shared] {
        &self.shared
    }

    /// The memory of the overlay without the meshes, in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let whole: usize = self.whole.iter().map(|whole| size_of_val(&whole[..])).sum();
        let pieces: usize = self.pieces.iter().map(|pieces| size_of_val(&pieces[..])).sum();
        whole + pieces + size_of_val(&self.shared[..]) + size_of_val(&self.constructions[..])
    }

    /// The overlay's new constructions in the session, in the order of the vertices: all of its points in a new
    /// session.
    #[must_use]
    pub fn constructions(&self) -> &[Construction] {
        &self.constructions
    }
}

/// Overlays two meshes with disjoint vertices in one scene.
///
/// # Errors
/// [`Undone`] if the session does not construct a point, or has signs that break an invariant.
pub fn mesh_overlay(
    session: &mut dyn Predicates,
    meshes: [Arc<MaterialMesh>; 2],
    zeros: Zeros,
) -> Result<MeshOverlay, Undone> {
    run(session, meshes, zeros, Extent::Whole, &mut |_| {})
}

/// The steps of an overlay, in order.
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

/// Overlays like [`mesh_overlay`], and reports the end of each step.
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

/// The part of two meshes that an overlay is given.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Extent {
    /// Both whole meshes.
    Whole,
    /// At least all triangles of each mesh above and below the other's box, and those that meet it.
    Columns,
}

/// Overlays like [`mesh_overlay`], for parts of two closed meshes ([`Extent::Columns`]).
pub(crate) fn overlay_of_columns(
    session: &mut dyn Predicates,
    meshes: [Arc<MaterialMesh>; 2],
    zeros: Zeros,
) -> Result<MeshOverlay, Undone> {
    run(session, meshes, zeros, Extent::Columns, &mut |_| {})
}

/// Overlays whole meshes, or columns.
fn run(
    session: &mut dyn Predicates,
    meshes: [Arc<MaterialMesh>; 2],
    zeros: Zeros,
    extent: Extent,
    done: &mut dyn FnMut(Step),
) -> Result<MeshOverlay, Undone> {
    let before = session.scene().constructions().len();
    let both = [&*meshes[0], &*meshes[1]];
    if zeros == Zeros::Zero && extent == Extent::Whole && same::do_touch(session, both) {
        return touching::overlay(session, &meshes, extent, done);
    }
    let asked = if extent == Extent::Whole { same::asked_about(session, both) } else { None };
    let (near, bounds) = Near::of(session.scene(), both, asked);
    done(Step::Near);
    let near = [&near[0], &near[1]];
    let hits = |mesh: u8| {
        let [own, other] = [usize::from(mesh), usize::from(1 - mesh)];
        let session = &*session;
        Question { session, edges: near[own], of: both[other], triangles: near[other], zeros }.hits()
    };
    let Ok(hits) = hits(0).and_then(|first| Ok([first, hits(1)?])) else {
        return touching::overlay(session, &meshes, extent, done);
    };
    done(Step::Passages);
    finish(session, &meshes, before, (near, &bounds), hits, extent, done)
}

/// Runs the steps after all passages are known.
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
    Ok(MeshOverlay { meshes: meshes.clone(), whole, pieces, shared: Vec::new(), constructions })
}
