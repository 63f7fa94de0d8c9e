//! Boolean operations on closed meshes of doubles, whose results are such meshes again: cascades.
//!
//! Each step is an overlay of the two meshes ([`mod@crate::mesh_overlay`]), one of which moves by an infinitesimal, the limit of its result
//! ([`mod@crate::mesh_limit`]), and the limit rounded to doubles ([`mod@crate::mesh_rounding`]). Where the vertices of a result are
//! doubles, a step is exact: then results are those of the operations on point sets, regularised, whatever was done before.

use std::sync::Arc;

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Backend, Declined, Off, Predicates, Scene, Vertex};

use crate::mesh_limit::{self, limit};
use crate::mesh_overlay::{Undone, Zeros, mesh_overlay};
use crate::mesh_rounding::{self, NotRounded, rounded};
use crate::overlay::Operation;

pub use crate::mesh_rounding::Closed;

/// What a step has done.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Step {
    /// Points that were constructed.
    pub constructed: usize,
    /// What of the perturbed result was without extent.
    pub limit: mesh_limit::Counts,
    /// What rounding has done.
    pub rounding: mesh_rounding::Counts,
}

/// Why there is no result.
#[derive(Clone, PartialEq, Debug)]
pub enum NoStep {
    /// A mesh is not closed: the first, 0, or the second, 1, and why.
    Open(usize, predicament_mesh::MaterialError),
    /// A coordinate is not finite, or there are too many vertices.
    Scene(predicament_predicates::SceneError),
    /// A backend does not take the scene.
    Declined(Declined),
    /// There is no overlay, or no limit of it.
    Undone(Undone),
    /// A result is no mesh of doubles.
    Rounding(NotRounded),
}

impl std::fmt::Display for NoStep {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            NoStep::Open(mesh, why) => write!(f, "the {} mesh: {why}", ["first", "second"][*mesh]),
            NoStep::Scene(why) => why.fmt(f),
            NoStep::Declined(why) => why.fmt(f),
            NoStep::Undone(why) => why.fmt(f),
            NoStep::Rounding(why) => why.fmt(f),
        }
    }
}

impl std::error::Error for NoStep {}

/// The result of an operation on two closed meshes, of which the `perturbed` backend moves the second as a whole; the `exact` one says zero where
/// something is zero. No mesh at all is empty space.
///
/// # Errors
/// [`NoStep`], with the first reason.
pub fn combine<P: Backend, E: Backend>(
    perturbed: &P,
    exact: &E,
    operands: [&Closed; 2],
    operation: Operation,
) -> Result<(Closed, Step), NoStep> {
    if let Some(result) = with_nothing(operands, operation) {
        return Ok((result, Step::default()));
    }
    let scene = scene(operands).map_err(NoStep::Scene)?;
    let meshes = meshes(operands)?;
    let mut session = perturbed.prepare(&scene, Off).map_err(NoStep::Declined)?;
    let overlay = mesh_overlay(&mut session, meshes, Zeros::Refused).map_err(NoStep::Undone)?;
    let mut session = exact.prepare(session.scene(), Off).map_err(NoStep::Declined)?;
    let limit = limit(&mut session, &overlay, overlay.solid(operation)).map_err(NoStep::Undone)?;
    let (result, rounding) = rounded(exact, &session, &limit).map_err(NoStep::Rounding)?;
    Ok((result, Step { constructed: overlay.constructions().len(), limit: limit.counts, rounding }))
}

/// The result where an operand is empty.
fn with_nothing([first, second]: [&Closed; 2], operation: Operation) -> Option<Closed> {
    let keeps = |in_first: bool| operation.holds([in_first, !in_first]);
    let of = |mesh: &Closed, keeps: bool| if keeps { mesh.clone() } else { Closed::default() };
    match [first, second].map(|mesh| mesh.triangles.is_empty()) {
        [false, false] => None,
        [true, _] => Some(of(second, keeps(false))),
        [false, true] => Some(of(first, keeps(true))),
    }
}

/// The points of both meshes, the second of which is the one that moves.
fn scene([first, second]: [&Closed; 2]) -> Result<Scene, predicament_predicates::SceneError> {
    let points = [&first.points[..], &second.points].concat();
    let scene = Scene::from_points3(&points)?;
    Ok(scene.with_second_mesh((first.points.len()..points.len()).map(Vertex::input)))
}

/// Both meshes over the points of one scene.
fn meshes(operands: [&Closed; 2]) -> Result<[Arc<MaterialMesh>; 2], NoStep> {
    let counts = operands.map(|mesh| mesh.points.len());
    let mesh = |at: usize| {
        let before = if at == 0 { 0 } else { counts[0] };
        let vertex = |v: u32| Vertex::input(v as usize + before);
        let triangles = operands[at].triangles.iter().map(|triangle| triangle.map(vertex)).collect();
        MaterialMesh::of_closed(counts[0] + counts[1], triangles).map(Arc::new).map_err(|why| NoStep::Open(at, why))
    };
    Ok([mesh(0)?, mesh(1)?])
}
