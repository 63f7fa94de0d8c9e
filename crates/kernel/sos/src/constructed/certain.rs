//! A proof that a determinant is zero wherever some coordinates are.
//!
//! Its rows are the homogeneous coordinates of places, or some of those coordinates.
//!
//! Homogeneous coordinates make everything multilinear: a plane is linear in each of its vertices, a point of three
//! planes in each plane, the determinant in each point. So nothing has to be expanded. A vertex that is free to move
//! and occurs once stands for the space that its homogeneous coordinates span. Planes and points are then spaces too,
//! each spanned by the images of its parts' spanning vectors. The determinant is zero exactly if it is zero for all of
//! these.
//!
//! The determinant is a polynomial of degree k in a vertex that occurs k times. If it is zero even with each occurrence
//! moving independently, it is zero. If not, the vertex takes as many positions as such a polynomial needs to be zero
//! everywhere. This loops over all such vertices, and takes long if many occur often, but it ends, and then it has
//! proved the answer. If all vertices are free, some of them are fixed: omitted columns are equivalent to rows of unit
//! vectors, and with these the determinant is zero or nonzero in all projective frames alike. (Not with a share of a
//! segment: its row, p·w·a + (q − p)·v·c of rows (a, v) and (c, w), is bilinear like the others, but a projection
//! changes ratios of lengths.)
//!
//! Coefficients of powers of infinitesimals are [`Series`]; spaces are modules over them.

use predicament_predicates::{Construction, Share, Vertex};
use smallvec::SmallVec;

use super::place::Place;
use super::series::{Cut, Series, difference, sum};
use crate::integer::Integer;

/// The coordinates of an exterior product, by sets of places of one size, in ascending order of bit masks.
///
/// A blade with sets of one place is a point or a plane.
type Blade = Vec<Series<Integer>>;

/// Blades that span a space.
type Spanning = Vec<Blade>;

/// A square matrix: each place has as many homogeneous coordinates as there are places.
#[derive(Clone)]
pub(super) struct Matrix {
    pub(super) places: SmallVec<[Place; 4]>,
    /// The columns by axis; the last one is the weight.
    pub(super) columns: SmallVec<[usize; 4]>,
}

/// A determinant with some free coordinates.
pub(super) struct Free<'q> {
    pub(super) cut: &'q Cut,
    pub(super) dimension: usize,
    pub(super) matrix: Matrix,
    /// The input vertices, ascending.
    pub(super) inputs: &'q [Vertex],
    /// The coordinates of vertices, vertex after vertex; used where they are not free.
    pub(super) coordinates: Vec<Series<Integer>>,
    /// The number of free coordinates, from the first one on.
    pub(super) active: usize,
}

impl Free<'_> {
    /// Returns true if the determinant is zero wherever the free coordinates are.
    pub(super) fn is_zero(&self) -> bool {
        let mut occurring = vec![0; self.inputs.len()];
        for v in self.matrix.places.iter().flat_map(Place::vertices) {
            occurring[self.number(v)] += 1;
        }
        let mut fixed: Vec<Option<Blade>> = vec![None; self.inputs.len()];
        let mut often: Vec<usize> =
            (0..self.inputs.len()).filter(|&at| occurring[at] > 1 && self.free_axes(at) > 0).collect();
        often.sort_by_key(|&at| std::cmp::Reverse(occurring[at]));
        let is_projective = !self.matrix.places.iter().any(Place::is_affine);
        if is_projective && self.active == self.coordinates.len() && self.cut.is_constant() {
            let mut all: Vec<usize> = (0..self.inputs.len()).collect();
            all.sort_by_key(|&at| std::cmp::Reverse(occurring[at]));
            for (&at, point) in all.iter().zip(self.frame()) {
                fixed[at] = Some(point);
            }
            often.retain(|&at| fixed[at].is_none());
        }
        self.is_zero_for_all(&often, &occurring, &mut fixed)
    }

    /// Returns true if the determinant is zero for these vertices in all positions that matter.
    fn is_zero_for_all(&self, often: &[usize], occurring: &[usize], fixed: &mut Vec<Option<Blade>>) -> bool {
        if self.is_zero_by_occurrence(fixed) {
            return true;
        }
        let Some((&at, rest)) = often.split_first() else { return false };
        for offsets in simplex(self.free_axes(at), occurring[at]) {
            let mut point = self.point(at);
            for (x, offset) in point.iter_mut().zip(offsets) {
                *x = self.cut.constant(Integer::from(i64::from(offset)));
            }
            fixed[at] = Some(point);
            if !self.is_zero_for_all(rest, occurring, fixed) {
                return false;
            }
        }
        fixed[at] = None;
        true
    }

    /// Returns true if the determinant is zero with each occurrence of a free vertex moving independently.
    fn is_zero_by_occurrence(&self, fixed: &[Option<Blade>]) -> bool {
        let Matrix { places, columns } = &self.matrix;
        let row = |place: &Place| {
            let chosen = |row: Blade| columns.iter().map(|&column| row[column].clone()).collect();
            self.span(self.row(place, fixed).into_iter().map(chosen))
        };
        self.wedges(places.iter().map(row).collect(), columns.len()).is_empty()
    }

    fn number(&self, v: Vertex) -> usize {
        self.inputs.binary_search(&v).expect("a vertex of the question")
    }

    /// The number of free axes of a vertex.
    fn free_axes(&self, at: usize) -> usize {
        self.active.saturating_sub(at * self.dimension).min(self.dimension)
    }

    /// The points that complete the omitted columns to a projective frame.
    ///
    /// They are the other unit vectors, and the sum of all.
    fn frame(&self) -> impl Iterator<Item = Blade> + '_ {
        let ones = vec![self.cut.constant(Integer::ONE); self.dimension + 1];
        self.matrix.columns.iter().map(|&column| self.unit(column, self.dimension + 1)).chain([ones])
    }

    /// A unit vector.
    fn unit(&self, at: usize, len: usize) -> Blade {
        (0..len).map(|i| self.cut.constant(Integer::from(i64::from(i == at)))).collect()
    }

    /// The homogeneous coordinates of an input vertex.
    fn point(&self, at: usize) -> Blade {
        let mut point = self.coordinates[at * self.dimension..][..self.dimension].to_vec();
        point.push(self.cut.constant(Integer::ONE));
        point
    }

    /// The span of an input vertex.
    fn vertex(&self, v: Vertex, fixed: &[Option<Blade>]) -> Spanning {
        let at = self.number(v);
        if let Some(point) = &fixed[at] {
            return vec![point.clone()];
        }
        let free = self.free_axes(at);
        let mut point = self.point(at);
        point[..free].fill(self.cut.constant(Integer::ZERO));
        let mut spanning: Spanning = (0..free).map(|axis| self.unit(axis, self.dimension + 1)).collect();
        spanning.push(point);
        spanning
    }

    /// The span of the homogeneous coordinates of a place.
    fn row(&self, place: &Place, fixed: &[Option<Blade>]) -> Spanning {
        let all = self.dimension + 1;
        let flat = |vertices: &[Vertex]| {
            let points = vertices.iter().map(|&v| self.vertex(v, fixed)).collect();
            self.wedges(points, all).into_iter().map(dual).collect::<Spanning>()
        };
        match place {
            Place::Input(v) => self.vertex(*v, fixed),
            Place::Meet(Construction::Ssi(lines)) => {
                self.wedges(lines.iter().map(|line| flat(line)).collect(), all).into_iter().map(dual).collect()
            }
            Place::Meet(Construction::Tpi(planes)) => {
                self.wedges(planes.iter().map(|plane| flat(plane)).collect(), all).into_iter().map(dual).collect()
            }
            Place::Meet(Construction::Lpi { line, plane }) => {
                let line = self.wedges(line.iter().map(|&v| self.vertex(v, fixed)).collect(), all);
                let plane = flat(plane);
                let pairs = line.iter().flat_map(|line| plane.iter().map(move |plane| (line, plane)));
                self.span(pairs.map(|(line, plane)| self.cross(line, plane)))
            }
            Place::Meet(Construction::Ratio { ends: [a, c], share }) => {
                let (a, c) = (self.vertex(*a, fixed), self.vertex(*c, fixed));
                let pairs = a.iter().flat_map(|a| c.iter().map(move |c| [a, c]));
                self.span(pairs.map(|ends| self.shared(ends, *share)))
            }
        }
    }

    /// The span of the exterior products of spaces.
    fn wedges(&self, factors: Vec<Spanning>, all: usize) -> Spanning {
        let mut factors = factors.into_iter().enumerate();
        let (_, first) = factors.next().expect("a product has factors");
        factors.fold(first, |product, (size, factor)| {
            let pairs = product.iter().flat_map(|a| factor.iter().map(move |b| (a, b)));
            self.span(pairs.map(|(a, b)| self.wedge(a, b, all, size)))
        })
    }

    /// The exterior product of a product of `size` vectors and one more.
    fn wedge(&self, product: &Blade, vector: &Blade, all: usize, size: usize) -> Blade {
        let smaller: SmallVec<[usize; 6]> = sets(all, size).collect();
        let entry = |set: usize| {
            let mut entry = self.cut.constant(Integer::ZERO);
            for at in (0..all).filter(|at| set >> at & 1 == 1) {
                let without = smaller.iter().position(|&other| other == set ^ 1 << at).expect("a set of that size");
                if is_zero(&product[without]) || is_zero(&vector[at]) {
                    continue;
                }
                let term = self.cut.times(&product[without], &vector[at]);
                let above = (set >> at >> 1).count_ones();
                entry = if above.is_multiple_of(2) { sum(entry, &term) } else { difference(entry, &term) };
            }
            entry
        };
        sets(all, size + 1).map(entry).collect()
    }

    /// The point that divides the segment of two homogeneous rows, bilinear in these.
    ///
    /// For rows (a, v) and (c, w), and a share p/q, it is (p·w·a + (q − p)·v·c, q·v·w).
    fn shared(&self, [a, c]: [&Blade; 2], share: Share) -> Blade {
        let ([p, _], [rest, _]) = (share.fraction(), share.rest().fraction());
        let [p, rest] = [p, rest].map(|x| self.cut.constant(Integer::from(x)));
        let [v, w] = [&a[self.dimension], &c[self.dimension]];
        let [of_a, of_c] = [self.cut.times(&p, w), self.cut.times(&rest, v)];
        a.iter().zip(c).map(|(a, c)| sum(self.cut.times(a, &of_a), &self.cut.times(c, &of_c))).collect()
    }

    /// The point of a line, given as a product of two vectors, on a plane.
    fn cross(&self, line: &Blade, plane: &Blade) -> Blade {
        let all = self.dimension + 1;
        let pairs: SmallVec<[usize; 6]> = sets(all, 2).collect();
        let mut point: Blade = vec![self.cut.constant(Integer::ZERO); all];
        for (pair, l) in pairs.iter().zip(line).filter(|(_, l)| !is_zero(l)) {
            let (i, j) = (pair.trailing_zeros() as usize, pair.ilog2() as usize);
            let [at_i, at_j] = [i, j].map(|at| self.cut.times(&plane[at], l));
            point[j] = sum(std::mem::take(&mut point[j]), &at_i);
            point[i] = difference(std::mem::take(&mut point[i]), &at_j);
        }
        point
    }

    /// A smaller set of blades with the same span.
    fn span(&self, blades: impl IntoIterator<Item = Blade>) -> Spanning {
        let mut spanning = Spanning::new();
        let mut rows: Vec<Vec<Integer>> = Vec::new();
        for blade in blades.into_iter().filter(|blade| !blade.iter().all(is_zero)) {
            let len = blade.len();
            if !insert(&mut rows, blade.iter().flatten().cloned().collect()) {
                continue;
            }
            for monomial in self.cut.monomials().skip(1) {
                insert(&mut rows, blade.iter().flat_map(|x| self.cut.times(x, &monomial)).collect());
            }
            spanning.push(blade);
            if rows.len() == rows[0].len() {
                // The whole space.
                return (0..len).map(|at| self.unit(at, len)).collect();
            }
        }
        spanning
    }
}

fn is_zero(x: &Series<Integer>) -> bool {
    x.iter().all(Integer::is_zero)
}

/// All sets of `size` of the first places, in ascending order of bit masks.
fn sets(all: usize, size: usize) -> impl Iterator<Item = usize> {
    (0..1_usize << all).filter(move |set| set.count_ones() as usize == size)
}

/// The vector orthogonal to a product of one vector less than there are places.
fn dual(product: Blade) -> Blade {
    // In descending order of the omitted place.
    let negative = |x: Series<Integer>| x.into_iter().map(|x| -x).collect();
    product.into_iter().rev().enumerate().map(|(at, x)| if at % 2 == 1 { negative(x) } else { x }).collect()
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

/// Adds a row to rows in echelon form, unless it depends on them.
fn insert(rows: &mut Vec<Vec<Integer>>, mut row: Vec<Integer>) -> bool {
    for other in rows.iter() {
        let pivot = other.iter().position(|x| !x.is_zero()).expect("no row is zero");
        if row[pivot].is_zero() {
            continue;
        }
        let factor = -row[pivot].clone();
        for (x, y) in row.iter_mut().zip(other) {
            let mut combined = &*x * &other[pivot];
            combined.add_product(&factor, y);
            *x = combined;
        }
    }
    let common = row.iter().fold(Integer::ZERO, |common, x| common.gcd(x));
    if common.is_zero() {
        return false;
    }
    row.iter_mut().for_each(|x| *x = x.div_exact(&common));
    rows.push(row);
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_points_of_a_simplex_are_all_with_a_sum_up_to_the_most() {
        assert_eq!(simplex(2, 2), [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [2, 0]]);
        assert_eq!(simplex(0, 5), [Vec::<u32>::new()]);
        // A binomial coefficient: the choices of three of eight.
        let points = simplex(3, 5);
        assert_eq!(points.len(), 56);
        assert!(points.is_sorted() && points.iter().all(|point| point.iter().sum::<u32>() <= 5));
    }

    #[test]
    fn sets_are_all_of_their_size() {
        assert_eq!(sets(4, 2).collect::<Vec<_>>(), [0b0011, 0b0101, 0b0110, 0b1001, 0b1010, 0b1100]);
        assert_eq!(sets(3, 0).collect::<Vec<_>>(), [0]);
    }
}
