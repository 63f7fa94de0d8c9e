//! The timed phases of cutting two meshes: checking, the steps of the overlay, a result, its limit and the limit in
//! doubles.

use std::time::{Duration, Instant};

use crate::algorithm::limit::limit;
use crate::algorithm::overlay::{MeshOverlay, Solid, Step, mesh_overlay_as_answered};
use crate::algorithm::rounding::rounded;
use predicament_mesh::MaterialMesh;
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Predicates, Vertex};

use super::content::TwoMeshes;
use super::memory;
use predicament_tasks::Phase;

/// The phase that uses no predicate.
pub(super) fn building(content: &TwoMeshes) -> Vec<Phase> {
    let first = |mesh: &MaterialMesh| mesh.triangles().as_flattened().iter().map(|v| v.index()).min().unwrap_or(0);
    // Copies for the checks, each over its own vertices, as in the file.
    let copies = content.meshes.each_ref().map(|mesh| {
        let before = first(mesh);
        let own = |v: Vertex| Vertex::input(v.index() - before);
        let triangles: Vec<[Vertex; 3]> = mesh.triangles().iter().map(|triangle| triangle.map(own)).collect();
        let vertices = triangles.as_flattened().iter().map(|v| v.index() + 1).max().unwrap_or(0);
        (vertices, triangles, mesh.sides().to_vec())
    });
    let (checking, checked) = Phase::timed("checking", "triangle", content.triangles(), || {
        copies.map(|(vertices, triangles, sides)| MaterialMesh::new(vertices, triangles, sides))
    });
    for checked in checked {
        checked.unwrap_or_else(|why| panic!("checked before, and refused now: {why}"));
    }
    vec![checking]
}

/// The phases that query a session; empty if it does not overlay these meshes.
pub(super) fn asking<P: Predicates>(session: &mut P, content: &TwoMeshes) -> Vec<Phase> {
    if memory::affordable(session.scene(), content).is_err() {
        return Vec::new();
    }
    let count = content.triangles();
    let phase = |name: &'static str, elapsed: Duration| Phase { name, unit: "triangle", count, elapsed, bytes: None };
    let (mut phases, mut clock) = (Vec::new(), Instant::now());
    let mut done = |step| {
        phases.push(phase(name(step), clock.elapsed()));
        clock = Instant::now();
    };
    let overlaid = mesh_overlay_as_answered(session, content.meshes.clone(), &mut done);
    let Ok((overlay, _)) = overlaid else { return Vec::new() };
    if let Some(last) = phases.last_mut() {
        *last = last.with_bytes(overlay.bytes());
    }
    let (result, solid) = Phase::timed("union", "triangle", count, || overlay.solid(Operation::Union));
    phases.push(result.with_bytes(size_of_val(&solid.triangles[..]) + size_of_val(&solid.sources[..])));
    phases.extend(settling(session, &overlay, solid, count));
    phases
}

fn name(step: Step) -> &'static str {
    match step {
        Step::Near => "near",
        Step::Passages => "passages",
        Step::Points => "points",
        Step::Regions => "regions",
        Step::Faces => "faces",
    }
}

/// The limit of the union and its rounding; empty if the session has no limits.
fn settling(session: &dyn Predicates, overlay: &MeshOverlay, solid: Solid, count: usize) -> Vec<Phase> {
    let mut phases = Vec::new();
    let Some(exact) = session.unperturbed() else { return phases };
    let scene = session.scene().clone();
    let clock = Instant::now();
    let mut solid = Some(solid);
    let asked = exact.with_session(&scene, &mut |session| {
        let preparing = clock.elapsed();
        let Some(solid) = solid.take() else { return };
        let (mut limiting, limit) = Phase::timed("limit", "triangle", count, || limit(session, overlay, solid));
        limiting.elapsed += preparing;
        let Ok(limit) = limit else { return };
        phases.push(limiting);
        let (rounding, rounded) = Phase::timed("rounding", "triangle", count, || rounded(exact, session, &limit));
        phases.extend(rounded.is_ok().then_some(rounding));
    });
    // A session that declines has no limits either.
    if asked.is_err() { Vec::new() } else { phases }
}
