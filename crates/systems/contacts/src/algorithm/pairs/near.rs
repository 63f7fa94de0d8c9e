//! The broad phase: the pairs that are near enough for a query.
//!
//! The boxes of two near simplices are inside those of two maximal simplices, which are near each other too. So one
//! search finds the pairs of maximal simplices, and all other pairs are derived from them. Two surfaces meet along
//! curves, so most simplices are in no such pair and are skipped.
//!
//! # Each pair once
//! A simplex can be a face of many maximal simplices. Its owner is the first of these that has a near maximal simplex.
//! A pair is derived from the pair of its owners. That pair was found, as every pair of maximal simplices that contains
//! the pair is found.
//!
//! # Memory
//! If a piece of work has more pairs of maximal simplices than a few for each, the pairs are not kept. Instead, the
//! owned simplices are searched again for each level, and memory holds only what is near one simplex.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use predicament_grid::{Bounds, BoxIndex};
use predicament_mesh::{Complex, FaceFinder, Simplex};
use predicament_predicates::{Scene, Vertex};
use rayon::prelude::*;

/// The number of maximal simplices in a piece of work.
const PIECE: usize = 512;

/// The maximum number of pairs of maximal simplices that a piece keeps.
const MOST_KEPT: usize = 32 * PIECE;

/// Pairs of two ranks by their indices; pairs with the same first simplex are consecutive.
type Candidates = Vec<[u32; 2]>;

/// The pairs of two complexes whose boxes are within reach of each other.
pub(super) struct Near<'a, const D: usize> {
    scene: &'a Scene,
    complexes: [&'a Complex; 2],
    reach: f64,
    /// The boxes of the second complex' maximal simplices.
    index: BoxIndex<D>,
    owned: [Owned; 2],
    pieces: Vec<Piece>,
}

/// The pairs for a piece of the first complex' maximal simplices, if they are kept.
struct Piece {
    maximal: Option<Pairs>,
    /// The pairs of all levels but the last, by ranks.
    below: [[Candidates; 3]; 3],
}

/// Pairs of maximal simplices by their indices among the maximal simplices.
#[derive(Default)]
struct Pairs {
    /// The maximal simplices of the first complex with near ones, ascending, each with the end of its pairs.
    firsts: Vec<(u32, u32)>,
    /// The maximal simplices of the second complex, ascending for each of the first.
    seconds: Vec<u32>,
}

impl<'a, const D: usize> Near<'a, D> {
    /// Searches all pairs; `keeps` says whether pieces with few pairs keep them.
    pub(super) fn new(scene: &'a Scene, complexes: [&'a Complex; 2], reach: f64, keeps: bool) -> Near<'a, D> {
        let boxes = complexes[1].maximal().par_iter().with_min_len(PIECE);
        let index = BoxIndex::new(boxes.map(|&t| bounds(scene, complexes[1].vertices_of(t))).collect());
        let owned = [Owned::default(), Owned::default()];
        let mut near = Near { scene, complexes, reach, index, owned, pieces: Vec::new() };
        let touched = complexes.map(|complex| complex.maximal().iter().map(|_| AtomicBool::new(false)).collect());
        near.pieces = near.find(&touched, if keeps { MOST_KEPT } else { 0 });
        let [a, b] = touched;
        let (a, b) = rayon::join(|| Owned::new(complexes[0], a), || Owned::new(complexes[1], b));
        near.owned = [a, b];
        let mut pieces = std::mem::take(&mut near.pieces);
        pieces.par_iter_mut().for_each(|Piece { maximal, below }| {
            let last = u8::try_from(D).expect("two or three");
            if let Some(pairs) = maximal {
                near.take(
                    pairs,
                    0..last,
                    |rank| 0..last - rank,
                    |[i, j], pair| {
                        below[i as usize][j as usize].push(pair);
                    },
                );
            }
        });
        near.pieces = pieces;
        near
    }

    /// The number of pieces of work.
    pub(super) fn pieces(&self) -> usize {
        self.pieces.len()
    }

    /// Visits the pairs of these ranks in a piece; one call has all pairs of one simplex of the first complex.
    pub(super) fn each(&self, piece: usize, [rank_a, rank_b]: [u8; 2], visit: &mut dyn FnMut(&[[u32; 2]])) {
        let Piece { maximal, below } = &self.pieces[piece];
        let Some(pairs) = maximal else { return self.again(piece, [rank_a, rank_b], visit) };
        let mut by_first = |pairs: &[[u32; 2]]| pairs.chunk_by(|one, other| one[0] == other[0]).for_each(&mut *visit);
        if usize::from(rank_a + rank_b) < D {
            return by_first(&below[rank_a as usize][rank_b as usize]);
        }
        let mut found = Vec::with_capacity(pairs.seconds.len());
        self.take(pairs, rank_a..rank_a + 1, |_| rank_b..rank_b + 1, |_, pair| found.push(pair));
        by_first(&found);
    }

    /// Searches all pairs of maximal simplices, and marks the simplices that are in a pair.
    fn find(&self, touched: &[Vec<AtomicBool>; 2], most: usize) -> Vec<Piece> {
        let touch = |side: usize, place: u32| {
            // many threads find the same simplices: a set mark is not written again
            let is_touched = &touched[side][place as usize];
            if !is_touched.load(Ordering::Relaxed) {
                is_touched.store(true, Ordering::Relaxed);
            }
        };
        let find = |piece: usize| Piece { maximal: self.search(piece, most, touch), below: Default::default() };
        (0..touched[0].len().div_ceil(PIECE)).into_par_iter().map(find).collect()
    }

    /// The pairs of a piece of the first complex' maximal simplices; calls `touch` for both members. `None` if there
    /// are more pairs than `most`.
    fn search(&self, piece: usize, most: usize, touch: impl Fn(usize, u32)) -> Option<Pairs> {
        let mut pairs = Some(Pairs::default());
        let mut found = Vec::new();
        for place in self.places(piece) {
            let around = bounds(self.scene, self.complexes[0].vertices_of(self.complexes[0].maximal()[place]));
            self.index.near(&around, self.reach, &mut found);
            if found.is_empty() {
                continue;
            }
            touch(0, number(place));
            found.iter().for_each(|&second| touch(1, second));
            pairs = pairs.filter(|pairs| pairs.seconds.len() + found.len() <= most);
            if let Some(pairs) = &mut pairs {
                pairs.seconds.extend(&found);
                pairs.firsts.push((number(place), number(pairs.seconds.len())));
            }
        }
        pairs
    }

    /// Visits the pairs of these ranks in a piece that has not kept its pairs. The boxes of owned simplices are
    /// smaller, so they have fewer near simplices.
    fn again(&self, piece: usize, [rank_a, rank_b]: [u8; 2], visit: &mut dyn FnMut(&[[u32; 2]])) {
        let (mut found, mut seconds) = (Candidates::new(), Vec::new());
        for first in self.places(piece).map(number) {
            for &s in self.owned[0].of(first, rank_a) {
                let around = self.bounds(0, rank_a, s);
                self.index.near(&around, self.reach, &mut seconds);
                let is_maximal = self.complexes[0].maximal()[first as usize].rank == rank_a;
                found.clear();
                self.with(&around, is_maximal, &seconds, rank_b, |t| found.push([s, t]));
                if !found.is_empty() {
                    visit(&found);
                }
            }
        }
    }

    fn places(&self, piece: usize) -> Range<usize> {
        piece * PIECE..self.complexes[0].maximal().len().min((piece + 1) * PIECE)
    }

    /// Derives the pairs of these ranks from pairs of maximal simplices: calls `taken` with their ranks and indices.
    /// `second_ranks` gives the ranks of the second complex for each of the first.
    #[inline]
    fn take(
        &self,
        pairs: &Pairs,
        first_ranks: Range<u8>,
        second_ranks: impl Fn(u8) -> Range<u8>,
        mut taken: impl FnMut([u8; 2], [u32; 2]),
    ) {
        let mut start = 0;
        for &(first, end) in &pairs.firsts {
            let seconds = &pairs.seconds[start as usize..end as usize];
            start = end;
            for rank_a in first_ranks.clone() {
                for &s in self.owned[0].of(first, rank_a) {
                    let around = self.bounds(0, rank_a, s);
                    let is_maximal = self.complexes[0].maximal()[first as usize].rank == rank_a;
                    for rank_b in second_ranks(rank_a) {
                        self.with(&around, is_maximal, seconds, rank_b, |t| taken([rank_a, rank_b], [s, t]));
                    }
                }
            }
        }
    }

    /// Calls `taken` for the simplices of one rank that these maximal simplices of the second complex own and that are
    /// near a box. If the box is that of a maximal simplex, maximal simplices are known to be near it.
    #[inline]
    fn with(&self, around: &Bounds<D>, is_maximal: bool, seconds: &[u32], rank: u8, mut taken: impl FnMut(u32)) {
        for &second in seconds {
            let is_known = is_maximal && self.complexes[1].maximal()[second as usize].rank == rank;
            for &t in self.owned[1].of(second, rank) {
                if is_known || around.is_near(&self.bounds(1, rank, t), self.reach) {
                    taken(t);
                }
            }
        }
    }

    #[inline]
    fn bounds(&self, side: usize, rank: u8, index: u32) -> Bounds<D> {
        bounds(self.scene, self.complexes[side].vertices_of(Simplex { rank, index }))
    }
}

/// The simplices that each maximal simplex in a pair owns.
#[derive(Default)]
struct Owned {
    /// The range of each maximal simplex, by its index among the maximal ones.
    heads: Vec<Head>,
    /// The indices of the owned simplices: for each owner in ascending order of ranks, and of indices.
    places: Vec<u32>,
}

/// The start of a maximal simplex' range, and the number of its owned simplices up to each rank.
#[derive(Clone, Copy, Default)]
struct Head {
    start: u32,
    ends: [u8; 4],
}

impl Owned {
    fn new(complex: &Complex, touched: Vec<AtomicBool>) -> Owned {
        let faces = FaceFinder::new(complex);
        let counts = [complex.vertices().len(), complex.edges().len(), complex.triangles().len()];
        // A simplex that is not a face of another is maximal, and owns itself.
        let highest = complex.maximal().last().map_or(0, |maximal| usize::from(maximal.rank));
        let mut is_owned: Vec<Vec<bool>> = counts[..highest].iter().map(|&count| vec![false; count]).collect();
        let mut owned = Owned { heads: vec![Head::default(); touched.len()], places: Vec::new() };
        for ((touched, head), &maximal) in touched.into_iter().zip(&mut owned.heads).zip(complex.maximal()) {
            if !touched.into_inner() {
                continue;
            }
            head.start = number(owned.places.len());
            faces.each(maximal, |face| {
                let is_new = face.rank == maximal.rank
                    || !std::mem::replace(&mut is_owned[face.rank as usize][face.index as usize], true);
                if is_new {
                    owned.places.push(face.index);
                    head.ends[face.rank as usize..].iter_mut().for_each(|end| *end += 1);
                }
            });
        }
        owned
    }

    /// The simplices of a rank that a maximal simplex owns.
    #[inline]
    fn of(&self, maximal: u32, rank: u8) -> &[u32] {
        let Head { start, ends } = self.heads[maximal as usize];
        let from = if rank == 0 { 0 } else { ends[rank as usize - 1] };
        &self.places[start as usize + usize::from(from)..start as usize + usize::from(ends[rank as usize])]
    }
}

#[inline(always)]
fn bounds<const D: usize>(scene: &Scene, vertices: &[Vertex]) -> Bounds<D> {
    let points: &[[f64; D]] = scene.coordinates().as_chunks().0;
    let first = points[vertices[0].index()];
    vertices[1..].iter().fold(Bounds { low: first, high: first }, |all, &v| {
        let point = points[v.index()];
        all.union(&Bounds { low: point, high: point })
    })
}

fn number(count: usize) -> u32 {
    u32::try_from(count).expect("fewer than 2^32 simplices")
}

#[cfg(test)]
mod tests {
    use super::*;
    use predicament_mesh::Simplices;

    #[test]
    fn pairs_are_the_same_whether_they_are_kept_or_searched_again() {
        let scene = Scene::from_points2(&[[0., 0.], [2., 2.], [0., 2.], [2., 0.], [9., 9.], [8., 9.]]).unwrap();
        let of = |edges: &[[usize; 2]]| Simplices {
            edges: edges.iter().map(|edge| edge.map(Vertex::input)).collect(),
            ..Simplices::default()
        };
        let complexes = [of(&[[0, 1], [4, 5]]), of(&[[2, 3]])].map(|given| Complex::new(&scene, &given).unwrap());
        let near = |keeps| Near::<2>::new(&scene, [&complexes[0], &complexes[1]], 0.0, keeps);
        let (kept, again) = (near(true), near(false));
        assert!(kept.pieces[0].maximal.is_some() && again.pieces[0].maximal.is_none());
        for ranks in [[0, 0], [0, 1], [1, 0], [1, 1]] {
            let [mut first, mut second] = [Vec::new(), Vec::new()];
            kept.each(0, ranks, &mut |pairs| first.extend_from_slice(pairs));
            again.each(0, ranks, &mut |pairs| second.extend_from_slice(pairs));
            assert_eq!(first, second, "{ranks:?}");
            assert!(ranks != [1, 1] || first == [[0, 0]], "the edges that cross: {first:?}");
        }
    }
}
