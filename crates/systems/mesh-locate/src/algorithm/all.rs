//! Locates many points in parallel, with the same answers for any number of threads.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};

use predicament_grid::two_level::Ray;
use predicament_predicates::{Predicates, Vertex};

use super::{Labels, Location, MeshIndex, Scratch};

/// The number of queries between two calls of the progress hook.
pub const CHUNK: usize = 4096;

/// Locates every vertex of `queries`, on all threads of the current rayon pool. It computes labels first, from the
/// queries themselves.
///
/// `progress` is called after each chunk of [`CHUNK`] queries with the number of queries done so far. Once it returns
/// false, no further chunk begins, and the answers are those before the first gap.
///
/// # Panics
/// As [`MeshIndex::locate`].
pub fn locate_all<P: Predicates + ?Sized>(
    index: &MeshIndex,
    session: &P,
    queries: &[Vertex],
    progress: &(dyn Fn(usize) -> bool + Sync),
) -> Vec<Location> {
    let labels = index.labels(session, queries);
    locate_labelled(index, session, &labels, queries, progress)
}

/// Locates like [`locate_all`], with given labels.
///
/// # Panics
/// As [`MeshIndex::locate`], and if the labels belong to another index.
pub fn locate_labelled<P: Predicates + ?Sized>(
    index: &MeshIndex,
    session: &P,
    labels: &Labels,
    queries: &[Vertex],
    progress: &(dyn Fn(usize) -> bool + Sync),
) -> Vec<Location> {
    gather(queries, progress, |q, scratch| index.locate(session, labels, q, scratch))
}

/// Locates like [`locate_all`], but by [`MeshIndex::question_any`]. The session is queried about every triangle in the
/// way, so that a wrong sign cannot stay hidden.
///
/// # Panics
/// As [`MeshIndex::question_any`].
pub fn question_all<P: Predicates + ?Sized>(
    index: &MeshIndex,
    session: &P,
    queries: &[Vertex],
    rays: &[Ray],
    progress: &(dyn Fn(usize) -> bool + Sync),
) -> Vec<Location> {
    gather(queries, progress, |q, scratch| index.question_any(session, q, rays, scratch))
}

fn gather(
    queries: &[Vertex],
    progress: &(dyn Fn(usize) -> bool + Sync),
    locate: impl Fn(Vertex, &mut Scratch) -> Location + Sync,
) -> Vec<Location> {
    let (stopped, done) = (AtomicBool::new(false), AtomicUsize::new(0));
    let parts = predicament_grid::parallel::pieces(queries, CHUNK, &|chunk| {
        if stopped.load(Relaxed) {
            return None;
        }
        let mut scratch = Scratch::new();
        let part: Vec<Location> = chunk.iter().map(|&q| locate(q, &mut scratch)).collect();
        let so_far = done.fetch_add(chunk.len(), Relaxed) + chunk.len();
        if !progress(so_far) {
            stopped.store(true, Relaxed);
        }
        Some(part)
    });
    let mut all = Vec::with_capacity(queries.len());
    parts.iter().map_while(Option::as_ref).for_each(|part| all.extend_from_slice(part));
    all
}
