//! Parallel location of many points, with the same answers for any number of threads.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};

use predicament_predicates::{Plane, Predicates, Scene, Sign, Vertex};
use rayon::prelude::*;

use super::special::Point;
use super::{LocateIndex, Scratch};
use crate::answer::{Location, Locations};

/// The number of queries between two calls of the progress hook.
pub const CHUNK: usize = 4096;

/// Locates every vertex of `queries`, on all threads of the current rayon pool.
///
/// `progress` is called after each chunk of [`CHUNK`] queries with the number of queries done so far. As soon as it
/// returns false, no further chunk begins, and the result holds the answered queries before the first gap.
///
/// # Panics
/// As [`LocateIndex::locate`].
pub fn locate_all<P: Predicates + ?Sized>(
    index: &LocateIndex,
    session: &P,
    queries: &[Vertex],
    progress: &(dyn Fn(usize) -> bool + Sync),
) -> Locations {
    gather(index, queries, progress, |index, q, scratch| index.locate(session, q, scratch))
}

/// Locates like [`locate_all`], but by [`LocateIndex::question`]. The session is queried about every edge in the way,
/// so that a wrong sign cannot stay hidden.
///
/// # Panics
/// As [`LocateIndex::question`].
pub fn question_all<P: Predicates + ?Sized>(
    index: &LocateIndex,
    session: &P,
    queries: &[Vertex],
    progress: &(dyn Fn(usize) -> bool + Sync),
) -> Locations {
    gather(index, queries, progress, |index, q, scratch| index.question(session, q, scratch))
}

/// Locates like [`locate_all`], but by [`LocateIndex::locate_specially`]: the same work around the paper's own test.
///
/// # Panics
/// If the scene lacks a query.
pub fn locate_all_specially(
    index: &LocateIndex,
    scene: &Scene,
    sign_of_d: &(impl Fn(Point, Point, Point) -> Sign + Sync),
    queries: &[Vertex],
    progress: &(dyn Fn(usize) -> bool + Sync),
) -> Locations {
    gather(index, queries, progress, |index, q, scratch| {
        index.locate_specially(scene.point2(Plane::Xy, q), sign_of_d, scratch)
    })
}

/// A function that locates a chunk of queries; it returns `None` after a stop.
type PartOf<'a> = dyn Fn(&mut Scratch, &[Vertex]) -> Option<Locations> + Sync + 'a;

fn gather(
    index: &LocateIndex,
    queries: &[Vertex],
    progress: &(dyn Fn(usize) -> bool + Sync),
    locate: impl for<'a> Fn(&'a LocateIndex, Vertex, &'a mut Scratch) -> Location<'a> + Sync,
) -> Locations {
    let stopped = AtomicBool::new(false);
    let done = AtomicUsize::new(0);
    // Behind a pointer, so that the parallel loop is compiled once: see `predicament_grid::parallel`.
    let part: &PartOf<'_> = &|scratch, chunk| {
        if stopped.load(Relaxed) {
            return None;
        }
        let mut part = Locations::with_capacity(chunk.len());
        for &q in chunk {
            let location = locate(index, q, scratch);
            part.push(location);
        }
        let so_far = done.fetch_add(chunk.len(), Relaxed) + chunk.len();
        if !progress(so_far) {
            stopped.store(true, Relaxed);
        }
        Some(part)
    };
    let parts: Vec<Option<Locations>> = queries.par_chunks(CHUNK).map_init(Scratch::new, part).collect();

    Locations::joined(queries.len(), || parts.iter().map_while(Option::as_ref))
}
