//! Locates many points in parallel, with the same answers for any number of threads.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};

use predicament_predicates::{Plane, Predicates, Scene, Sign, Vertex};
use rayon::prelude::*;

use super::special::Point;
use super::{LocateIndex, Location, Scratch};

/// The number of queries between two calls of the progress hook.
pub const CHUNK: usize = 4096;

/// The answers to many queries, in their order, in two flat arrays.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Locations {
    inside: Lists,
    boundary: Lists,
    asked: usize,
}

/// Lists of regions, one after another.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
struct Lists {
    /// The place where each list ends.
    ends: Vec<usize>,
    items: Vec<u32>,
}

impl Lists {
    const EMPTY: Lists = Lists { ends: Vec::new(), items: Vec::new() };

    fn push(&mut self, list: &[u32]) {
        self.items.extend_from_slice(list);
        self.ends.push(self.items.len());
    }

    /// Makes room for all these lists at once.
    fn reserve<'a>(&mut self, lists: impl Iterator<Item = &'a Lists>) {
        let [ends, items] =
            lists.fold([0, 0], |[ends, items], list| [ends + list.ends.len(), items + list.items.len()]);
        self.ends.reserve_exact(ends);
        self.items.reserve_exact(items);
    }

    fn append(&mut self, other: &Lists) {
        let base = self.items.len();
        self.ends.extend(other.ends.iter().map(|end| base + end));
        self.items.extend_from_slice(&other.items);
    }

    fn get(&self, at: usize) -> &[u32] {
        let start = if at == 0 { 0 } else { self.ends[at - 1] };
        &self.items[start..self.ends[at]]
    }
}

impl Locations {
    fn none(asked: usize) -> Locations {
        Locations { inside: Lists::EMPTY, boundary: Lists::EMPTY, asked }
    }

    /// These answers: the regions that each query is inside of, and those whose boundary it is on, both ascending.
    #[must_use]
    pub fn of(answers: impl Iterator<Item = (Vec<u32>, Vec<u32>)>) -> Locations {
        let mut all = Locations::none(0);
        for (inside, boundary) in answers {
            all.inside.push(&inside);
            all.boundary.push(&boundary);
            all.asked += 1;
        }
        all
    }

    /// How many queries are answered: the first so many.
    #[must_use]
    pub fn len(&self) -> usize {
        self.inside.ends.len()
    }

    /// Whether no query is answered.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether all queries are answered, and not only those up to an early stop.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.len() == self.asked
    }

    /// The regions that query `at` is inside of, ascending.
    ///
    /// # Panics
    /// If the query is not answered.
    #[must_use]
    pub fn inside(&self, at: usize) -> &[u32] {
        self.inside.get(at)
    }

    /// The regions whose boundary query `at` is on, ascending.
    ///
    /// # Panics
    /// If the query is not answered.
    #[must_use]
    pub fn boundary(&self, at: usize) -> &[u32] {
        self.boundary.get(at)
    }

    /// The answers in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Location<'_>> + '_ {
        (0..self.len()).map(|at| Location { inside: self.inside(at), boundary: self.boundary(at) })
    }
}

/// Locates every vertex of `queries`, on all threads of the current rayon pool.
///
/// `progress` is called after each chunk of [`CHUNK`] queries with the number
/// of queries done so far; as soon as it returns false no further chunk is
/// begun, and the result holds the answered queries before the first gap.
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

/// [`locate_all`] by [`LocateIndex::question`]: every edge in the way is asked
/// about, so that a session that is wrong about one can't hide it.
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

/// [`locate_all`] by [`LocateIndex::locate_specially`]: the same work around
/// the paper's own test.
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

/// The locations of a chunk of queries, unless it is too late for them.
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
        let mut part = Locations::none(chunk.len());
        part.inside.ends.reserve_exact(chunk.len());
        part.boundary.ends.reserve_exact(chunk.len());
        for &q in chunk {
            let location = locate(index, q, scratch);
            part.inside.push(location.inside);
            part.boundary.push(location.boundary);
        }
        let so_far = done.fetch_add(chunk.len(), Relaxed) + chunk.len();
        if !progress(so_far) {
            stopped.store(true, Relaxed);
        }
        Some(part)
    };
    let parts: Vec<Option<Locations>> = queries.par_chunks(CHUNK).map_init(Scratch::new, part).collect();

    let mut all = Locations::none(queries.len());
    all.inside.reserve(parts.iter().map_while(Option::as_ref).map(|part| &part.inside));
    all.boundary.reserve(parts.iter().map_while(Option::as_ref).map(|part| &part.boundary));
    for part in parts.iter().map_while(Option::as_ref) {
        all.inside.append(&part.inside);
        all.boundary.append(&part.boundary);
    }
    all
}
