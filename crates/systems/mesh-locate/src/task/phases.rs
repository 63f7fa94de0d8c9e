//! The timed phases of locating: reading, checking and the grid, which use no predicate, then labels and queries.

use crate::algorithm::{MeshIndex, locate_labelled};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Predicates, Scene, Vertex};

use super::content::ProbedMesh;
use predicament_tasks::Phase;

/// The phases that use no predicate.
pub(super) fn building(scene: &Scene, content: &ProbedMesh) -> Vec<Phase> {
    let mesh = &content.mesh;
    let (triangles, sides) = (mesh.triangles(), mesh.sides());
    let timed = |name: &'static str| (name, "triangle", triangles.len());
    let mut phases = Vec::new();
    if let Some(file) = content.file() {
        let (name, unit, count) = timed("reading");
        let (reading, read) = Phase::timed(name, unit, count, || file.read());
        // The file could be read before; `bench` reports it if it is gone.
        read.unwrap_or_else(|why| panic!("{why}"));
        phases.push(reading);
    }
    // Copies for the checks: over the mesh's own vertices, as in the file.
    let first = triangles.as_flattened().iter().map(|v| v.index()).min().unwrap_or(0);
    let own = |v: Vertex| Vertex::input(v.index() - first);
    let vertices = triangles.as_flattened().iter().map(|v| v.index() - first + 1).max().unwrap_or(0);
    let tetrahedra: Vec<[Vertex; 4]> = content.tetrahedra.iter().map(|corners| corners.map(own)).collect();
    let copy: Vec<[Vertex; 3]> = triangles.iter().map(|corners| corners.map(own)).collect();
    let (name, unit, count) = timed("checking");
    let sides_of = sides.to_vec();
    let (checking, checked) = Phase::timed(name, unit, count, || {
        if tetrahedra.is_empty() {
            MaterialMesh::new(vertices, copy, sides_of)
        } else {
            MaterialMesh::of_tetrahedra(vertices, &tetrahedra)
        }
    });
    checked.unwrap_or_else(|why| panic!("checked before, and refused now: {why}"));
    phases.push(checking.with_bytes(size_of_val(triangles) + size_of_val(sides)));
    let (name, unit, count) = timed("grid");
    let (grid, index) = Phase::timed(name, unit, count, || MeshIndex::new(mesh.clone(), scene));
    phases.push(grid.with_bytes(index.bytes()));
    phases
}

/// The phases that query a session.
pub(super) fn asking<P: Predicates>(session: &P, content: &ProbedMesh) -> Vec<Phase> {
    let (index, probes) = (content.mesh_index(session.scene()), content.vertices());
    if probes.is_empty() {
        return Vec::new();
    }
    let triangles = content.mesh.triangles().len();
    let (labelling, labels) = Phase::timed("labels", "triangle", triangles, || index.labels(session, &probes));
    let (queries, _) =
        Phase::timed("queries", "query", probes.len(), || locate_labelled(index, session, &labels, &probes, &|_| true));
    vec![labelling.with_bytes(labels.bytes()), queries]
}
