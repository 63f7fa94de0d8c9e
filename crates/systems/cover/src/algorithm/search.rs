//! The search of one loop: covers by ascending area, until one has no crossing.
//!
//! A node of the search is the set of all triangulations that have some triangles and lack others. Dynamic programming
//! finds its triangulation of least area. If two triangles of it cross, the node is divided: the triangulations without
//! the first one, and those with the first and without the second one. No triangulation is in both, so each is tried at
//! most once. Nodes wait by the area of their triangulation, and equal areas by age.
//!
//! Triangles that cannot be in a cover are excluded from all nodes: triangles without area, with an edge that the
//! surface has, or across the surface.

use std::collections::{BTreeMap, BTreeSet};

use predicament_predicates::{Plane, Predicates, Vertex};

use super::area::Areas;
use super::{Surface, cross, most_covers};
use crate::answer::Reason;

/// A triangle by the places of its corners on the loop, ascending.
type Corners = [usize; 3];

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

/// A set of triangulations, with one of least area.
struct Node {
    with: Vec<Corners>,
    without: Vec<Corners>,
    least: Vec<Corners>,
}

/// The search of one loop.
pub(super) struct Search<'a> {
    session: &'a dyn Predicates,
    surface: &'a Surface,
    around: &'a [Vertex],
    areas: Areas,
    /// True at `place` of a triangle that is in no cover.
    is_excluded: Vec<bool>,
    /// The triangles that do not meet the surface.
    passed: BTreeSet<Corners>,
    /// The pairs of triangles of which it is known whether they cross.
    pairs: BTreeMap<[Corners; 2], bool>,
    /// The nodes by area and age.
    open: BTreeMap<(u64, usize), Node>,
    age: usize,
}

/// True if the edge from place i to place k crosses an edge of a triangle, as edges of a convex polygon. Triangles
/// whose edges do not cross are equal, or one is beyond an edge of the other.
fn cuts([i, k]: [usize; 2], [a, b, c]: Corners) -> bool {
    let is_between = |at: usize| i < at && at < k;
    let is_beyond = |at: usize| at < i || k < at;
    [[a, b], [b, c], [a, c]].into_iter().any(|[u, v]| is_between(u) && is_beyond(v) || is_beyond(u) && is_between(v))
}

impl<'a> Search<'a> {
    pub(super) fn new(session: &'a dyn Predicates, surface: &'a Surface, around: &'a [Vertex]) -> Search<'a> {
        let n = around.len();
        let areas = Areas::new(session.scene(), around);
        let (is_excluded, passed, pairs) = (vec![false; n * n * n], BTreeSet::new(), BTreeMap::new());
        let mut search =
            Search { session, surface, around, areas, is_excluded, passed, pairs, open: BTreeMap::new(), age: 0 };
        for (a, c) in (0..n).flat_map(|c| (0..c).map(move |a| (a, c))) {
            for b in a + 1..c {
                let is_diagonal = |from: usize, to: usize| to - from > 1 && to - from < n - 1;
                let is_used =
                    |[from, to]: [usize; 2]| is_diagonal(from, to) && surface.has_edge([around[from], around[to]]);
                if [[a, b], [b, c], [a, c]].into_iter().any(is_used) || search.is_flat([a, b, c]) {
                    search.exclude([a, b, c]);
                }
            }
        }
        search
    }

    /// The triangles of the cover.
    ///
    /// # Errors
    /// The reason why there is none.
    pub(super) fn run(mut self) -> Result<Vec<[Vertex; 3]>, Reason> {
        self.add(Vec::new(), Vec::new());
        for _ in 0..most_covers(self.around.len()) {
            let Some((_, node)) = self.open.pop_first() else { return Err(Reason::Crosses) };
            if self.exclude_those_that_meet(&node.least) {
                self.add(node.with, node.without);
            } else if let Some([first, second]) = self.crossing(&node.least) {
                let also = |all: &[Corners], one: Corners| [all, &[one]].concat();
                self.add(node.with.clone(), also(&node.without, first));
                self.add(also(&node.with, first), also(&node.without, second));
            } else {
                return Ok(node.least.into_iter().map(|corners| self.vertices(corners)).collect());
            }
        }
        Err(Reason::Search)
    }

    fn vertices(&self, corners: Corners) -> [Vertex; 3] {
        corners.map(|at| self.around[at])
    }

    fn place(&self, [a, b, c]: Corners) -> usize {
        let n = self.around.len();
        (a * n + b) * n + c
    }

    fn exclude(&mut self, corners: Corners) {
        let place = self.place(corners);
        self.is_excluded[place] = true;
    }

    fn is_flat(&self, corners: Corners) -> bool {
        let [a, b, c] = self.vertices(corners);
        PLANES.into_iter().all(|plane| self.session.orient2d(plane, a, b, c).is_zero())
    }

    /// Excludes the triangles that meet the surface; returns true if there is one.
    fn exclude_those_that_meet(&mut self, cover: &[Corners]) -> bool {
        let mut has_one = false;
        for &corners in cover {
            if self.passed.contains(&corners) {
                continue;
            }
            if self.is_excluded[self.place(corners)] || self.surface.meets(self.session, self.vertices(corners)) {
                self.exclude(corners);
                has_one = true;
            } else {
                self.passed.insert(corners);
            }
        }
        has_one
    }

    /// The first two triangles of a cover that cross.
    fn crossing(&mut self, cover: &[Corners]) -> Option<[Corners; 2]> {
        let pairs = cover.iter().enumerate().flat_map(|(at, &first)| cover[at + 1..].iter().map(move |&u| [first, u]));
        for pair in pairs {
            let [first, second] = pair.map(|corners| self.vertices(corners));
            let session = self.session;
            if *self.pairs.entry(pair).or_insert_with(|| cross(session, first, second)) {
                return Some(pair);
            }
        }
        None
    }

    /// Adds the node of all triangulations with and without these triangles, if there is one.
    fn add(&mut self, with: Vec<Corners>, without: Vec<Corners>) {
        let Some((area, least)) = self.least(&with, &without) else { return };
        self.open.insert((area.to_bits(), self.age), Node { with, without, least });
        self.age += 1;
    }

    /// A triangulation of least area with and without these triangles. Of equal ones, each edge has the triangle with
    /// the smallest apex.
    fn least(&self, with: &[Corners], without: &[Corners]) -> Option<(f64, Vec<Corners>)> {
        let n = self.around.len();
        let without: BTreeSet<Corners> = without.iter().copied().collect();
        // For each edge from i to k, the least area beyond it and the apex of its triangle.
        let mut best = vec![(f64::INFINITY, 0); n * n];
        (1..n).for_each(|k| best[(k - 1) * n + k].0 = 0.0);
        for width in 2..n {
            for i in 0..n - width {
                let k = i + width;
                if with.iter().any(|&other| cuts([i, k], other)) {
                    continue;
                }
                for j in i + 1..k {
                    let corners = [i, j, k];
                    let beyond = best[i * n + j].0 + best[j * n + k].0;
                    let may_be = beyond.is_finite() && !self.is_excluded[self.place(corners)];
                    if !may_be {
                        continue;
                    }
                    let area = beyond + self.areas.twice(corners);
                    if area < best[i * n + k].0 && !without.contains(&corners) {
                        best[i * n + k] = (area, j);
                    }
                }
            }
        }
        let area = best[n - 1].0;
        if !area.is_finite() {
            return None;
        }
        let (mut cover, mut edges) = (Vec::with_capacity(n - 2), vec![[0, n - 1]]);
        while let Some([i, k]) = edges.pop() {
            if k - i > 1 {
                let j = best[i * n + k].1;
                cover.push([i, j, k]);
                edges.extend([[i, j], [j, k]]);
            }
        }
        cover.sort_unstable();
        Some((area, cover))
    }
}
