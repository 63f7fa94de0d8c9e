//! A proof that a determinant is zero wherever some coordinates are.
//!
//! Its rows are the homogeneous coordinates of places, or some of those coordinates.
//!
//! Homogeneous coordinates make everything multilinear: a plane is linear in each of its vertices, a point of three
//! planes in each plane, the determinant in each point. So nothing has to be expanded. A vertex that is free to move
//! and occurs once stands for the space that its homogeneous coordinates span. Planes and points are then spaces too
//! ([`Spaces`]). The determinant is zero exactly if it is zero for all of their spanning vectors.
//!
//! The determinant is a polynomial of degree k in a vertex that occurs k times. If it is zero even with each occurrence
//! moving independently, it is zero. If not, the vertex takes as many positions as such a polynomial needs to be zero
//! everywhere. This loops over all such vertices, and takes long if many occur often, but it ends, and then it has
//! proved the answer. If all vertices are free, some of them are fixed: omitted columns are equivalent to rows of unit
//! vectors, and with these the determinant is zero or nonzero in all projective frames alike. (Not with a share of a
//! segment: its row, p·w·a + (q − p)·v·c of rows (a, v) and (c, w), is bilinear like the others, but a projection
//! changes ratios of lengths.)
//!
//! # Modulo a prime
//! All determinants of the proof are integers of known size ([`bound`]). If it is below the prime of [`Residue`], a
//! determinant is zero exactly if it is zero modulo the prime, and vectors of one limb a coordinate span the spaces
//! modulo the prime. Otherwise the proof is in integers of any length.

mod bound;
mod spaces;

use predicament_predicates::Vertex;
use smallvec::SmallVec;

use super::place::Place;
use super::residue::Residue;
use super::series::Cut;
use crate::integer::Integer;
use spaces::{Blade, Entry, Spaces};

/// A square matrix: each place has as many homogeneous coordinates as there are places.
#[derive(Clone)]
pub(super) struct Matrix {
    pub(super) places: SmallVec<[Place; 4]>,
    /// The columns by axis; the last one is the weight.
    pub(super) columns: SmallVec<[usize; 4]>,
}

/// A determinant of which some coordinates move.
#[derive(Clone, Copy)]
pub(super) struct Moving<'q> {
    pub(super) cut: &'q Cut,
    pub(super) dimension: usize,
    pub(super) matrix: &'q Matrix,
    /// The input vertices, ascending.
    pub(super) inputs: &'q [Vertex],
    /// The infinitesimals that move their coordinates, with the degrees of the cut.
    pub(super) chosen: &'q [(usize, usize)],
    /// The number of free coordinates, from the first one on.
    pub(super) active: usize,
}

impl Moving<'_> {
    /// Returns true if the determinant is zero wherever the free coordinates are.
    ///
    /// The others are multiples of powers of two, vertex after vertex.
    pub(super) fn is_zero(&self, coordinates: &[(i64, u32)]) -> bool {
        if self.bits(coordinates).is_some_and(|bits| bits < Residue::BITS) {
            self.is_zero_over::<Residue>(coordinates)
        } else {
            self.is_zero_over::<Integer>(coordinates)
        }
    }

    fn is_zero_over<C: Entry>(&self, coordinates: &[(i64, u32)]) -> bool {
        let spaces = Spaces::new(*self, |at| C::scaled(coordinates[at]));
        let occurring = self.occurring();
        let mut fixed: SmallVec<[Option<Blade<C>>; 12]> = SmallVec::new();
        fixed.resize(self.inputs.len(), None);
        let mut often: SmallVec<[usize; 12]> =
            (0..self.inputs.len()).filter(|&at| occurring[at] > 1 && self.free_axes(at) > 0).collect();
        often.sort_by_key(|&at| std::cmp::Reverse(occurring[at]));
        let is_projective = !self.matrix.places.iter().any(Place::is_affine);
        if is_projective && self.active == self.inputs.len() * self.dimension && self.cut.is_constant() {
            let mut all: SmallVec<[usize; 12]> = (0..self.inputs.len()).collect();
            all.sort_by_key(|&at| std::cmp::Reverse(occurring[at]));
            for (&at, point) in all.iter().zip(spaces.frame()) {
                fixed[at] = Some(point);
            }
            often.retain(|at| fixed[*at].is_none());
        }
        self.is_zero_for_all(&spaces, &often, &occurring, &mut fixed)
    }

    /// Returns true if the determinant is zero for these vertices in all positions that matter.
    fn is_zero_for_all<C: Entry>(
        &self,
        spaces: &Spaces<'_, C>,
        often: &[usize],
        occurring: &[usize],
        fixed: &mut [Option<Blade<C>>],
    ) -> bool {
        if spaces.determinants(fixed).is_empty() {
            return true;
        }
        let Some((&at, rest)) = often.split_first() else { return false };
        for offsets in simplex(self.free_axes(at), occurring[at]) {
            fixed[at] = Some(spaces.point_with(at, &offsets));
            if !self.is_zero_for_all(spaces, rest, occurring, fixed) {
                return false;
            }
        }
        fixed[at] = None;
        true
    }

    /// The number of occurrences of each input vertex.
    fn occurring(&self) -> SmallVec<[usize; 12]> {
        let mut occurring: SmallVec<[usize; 12]> = SmallVec::new();
        occurring.resize(self.inputs.len(), 0);
        for v in self.matrix.places.iter().flat_map(Place::vertices) {
            occurring[self.number(v)] += 1;
        }
        occurring
    }

    fn number(&self, v: Vertex) -> usize {
        self.inputs.binary_search(&v).expect("a vertex of the question")
    }

    /// The number of free axes of a vertex.
    fn free_axes(&self, at: usize) -> usize {
        self.active.saturating_sub(at * self.dimension).min(self.dimension)
    }
}

/// All tuples of non-negative integers, one per axis, with sum up to `most`.
fn simplex(axes: usize, most: usize) -> Vec<Vec<u32>> {
    let mut points = vec![Vec::new()];
    for _ in 0..axes {
        let longer = |point: Vec<u32>| {
            let left = u32::try_from(most).expect("a degree") - point.iter().sum::<u32>();
            (0..=left).map(move |last| [point.as_slice(), &[last]].concat())
        };
        points = points.into_iter().flat_map(longer).collect();
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_prime_itself_is_not_zero() {
        // The turn of a, b and c is the prime times the x of a.
        let inputs = [0, 1, 2].map(Vertex::input);
        let matrix = Matrix {
            places: inputs.iter().map(|&v| Place::Input(v)).collect(),
            columns: SmallVec::from_slice(&[0, 1, 2]),
        };
        let cut = Cut::default();
        let of = |active| Moving { cut: &cut, dimension: 2, matrix: &matrix, inputs: &inputs, chosen: &[], active };
        let b = ((1 << 61) - 1, 0);
        let coordinates = [(0, 0), (0, 0), (0, 0), b, (0, 0), (0, 0)];
        assert!(of(0).is_zero(&coordinates));
        assert!(!of(1).is_zero(&coordinates) && of(1).is_zero_over::<Residue>(&coordinates));
    }

    #[test]
    fn the_points_of_a_simplex_are_all_with_a_sum_up_to_the_most() {
        assert_eq!(simplex(2, 2), [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [2, 0]]);
        assert_eq!(simplex(0, 5), [Vec::<u32>::new()]);
        // A binomial coefficient: the choices of three of eight.
        let points = simplex(3, 5);
        assert_eq!(points.len(), 56);
        assert!(points.is_sorted() && points.iter().all(|point| point.iter().sum::<u32>() <= 5));
    }
}
