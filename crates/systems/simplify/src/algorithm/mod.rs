//! Simplification by edge collapse (Garland and Heckbert 1997: *Surface simplification using quadric error metrics*).
//!
//! The edge with the smallest error collapses first. One of its ends moves into the other end, so that all vertices
//! stay vertices of the input. Three things decide about an edge:
//!
//! * its *error*, in doubles (`quadric.rs`). The error only orders the edges. Ties go to smaller vertices, so the
//!   result depends on the mesh and on the signs alone;
//! * the *link condition*: [`HalfEdgeMesh::collapse_edge`] refuses edges whose collapse changes the topology;
//! * the *faces* around the vertex that moves (`facing.rs`): by the predicate [`same_facing`] none may turn over.
//!
//! An edge that is refused is tried again after a collapse beside it.
//!
//! [`same_facing`]: crate::answer::same_facing

mod facing;
mod quadric;
mod queue;
mod reach;

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{HalfEdge, MeshVertex};
use predicament_predicates::{Predicates, Vertex};

use crate::answer::{Simplified, Step};
use quadric::{Errors, Quadric};
use queue::Queue;
use reach::Reach;

/// The number of decisions between two calls of the progress function.
const CHUNK: usize = 1024;

/// The state of a simplification.
struct State<'s, P: ?Sized> {
    session: &'s P,
    mesh: HalfEdgeMesh,
    errors: Errors,
    quadrics: Vec<Quadric>,
    reach: Reach<'s>,
    queue: Queue,
    steps: Vec<Step>,
}

/// Collapses edges of a mesh of triangles until at most `target` triangles are left, or no edge can be collapsed.
/// `go_on` is called with the number of decisions now and then.
///
/// # Errors
/// The error of `go_on`.
///
/// # Panics
/// If the mesh has vertices that the session's scene lacks.
pub fn simplify<P: Predicates + ?Sized, E>(
    session: &P,
    mesh: HalfEdgeMesh,
    target: usize,
    go_on: &mut dyn FnMut(u64) -> Result<(), E>,
) -> Result<Simplified, E> {
    let errors = Errors::new(session.scene());
    let quadrics = errors.quadrics(&mesh);
    let queue = Queue::new(&mesh);
    let reach = Reach::new(session.scene(), &mesh);
    let mut state = State { session, mesh, errors, quadrics, reach, queue, steps: Vec::new() };
    let all: Vec<HalfEdge> = state.mesh.half_edges().collect();
    all.into_iter().for_each(|h| state.push(h));
    let mut seen = 0;
    while state.mesh.face_count() > target
        && let Some(h) = state.queue.pop()
    {
        if state.mesh.has_half_edge(h) {
            state.try_edge(h);
        }
        seen += 1;
        if seen == CHUNK {
            go_on(CHUNK as u64)?;
            seen = 0;
        }
    }
    Ok(state.finish())
}

impl<P: Predicates + ?Sized> State<'_, P> {
    /// Puts an edge into the queue, by its present error.
    fn push(&mut self, h: HalfEdge) {
        let ends = [self.mesh.start(h), self.mesh.end(h)];
        let quadrics = ends.map(|v| &self.quadrics[v.index()]);
        let error = self.errors.of(quadrics, ends.map(|v| self.mesh.scene_vertex(v)));
        self.queue.push(h, error, ends);
    }

    /// Collapses an edge, or leaves it until something beside it changes.
    fn try_edge(&mut self, h: HalfEdge) {
        let [gone, kept] = [self.mesh.start(h), self.mesh.end(h)];
        let scene = [gone, kept].map(|v| self.mesh.scene_vertex(v));
        if let Some((base, sign)) = facing::turned(self.session, &self.mesh, gone, kept) {
            let [gone, kept] = scene;
            self.steps.push(Step::Refusal { gone, kept, base, sign });
            self.queue.refuse(h);
            return;
        }
        if self.mesh.collapse_edge(h).is_err() {
            self.queue.refuse(h);
            return;
        }
        let removed = self.quadrics[gone.index()].clone();
        self.quadrics[kept.index()].add(&removed);
        self.reach.join(gone, kept, scene);
        self.steps.push(Step::Collapse { gone: scene[0], kept: scene[1] });
        self.renew(kept);
    }

    /// Puts the edges of a vertex into the queue again, and the refused edges of its neighbours.
    fn renew(&mut self, kept: MeshVertex) {
        let ring: Vec<HalfEdge> = self.mesh.ring(kept).collect();
        for &h in &ring {
            for half in [h, self.mesh.opposite(h)] {
                self.push(half);
            }
        }
        for &h in &ring {
            let around = self.mesh.ring(self.mesh.start(h)).flat_map(|h| [h, self.mesh.opposite(h)]);
            let refused: Vec<HalfEdge> = around.filter(|&half| self.queue.is_refused(half)).collect();
            refused.into_iter().for_each(|half| self.push(half));
        }
    }

    fn finish(self) -> Simplified {
        let State { mesh, reach, steps, .. } = self;
        let corner = |v: MeshVertex| mesh.scene_vertex(v);
        let triangle = |face| {
            let mut corners = mesh.loop_of(mesh.half_edge_of_face(face)).map(|h| corner(mesh.start(h)));
            [(); 3].map(|()| corners.next().unwrap_or(Vertex::input(0)))
        };
        Simplified { steps, triangles: mesh.faces().map(triangle).collect(), reach: reach.largest() }
    }
}
