//! Spaces of vertices, lines, planes and points, in exterior algebra.
//!
//! Unit vectors and the vertex itself span a vertex that is free to move. The exterior products of vertices' spanning
//! vectors span lines and planes, and those of lines and planes span points. Coefficients of powers of infinitesimals
//! are truncated polynomials; spaces are modules over them.

use predicament_predicates::{Construction, Share, Vertex};
use smallvec::{SmallVec, smallvec};

use super::Moving;
use crate::constructed::place::Place;
use crate::constructed::residue::Residue;
use crate::constructed::series::Coefficient;
use crate::integer::Integer;

/// A coefficient of a spanning vector.
pub(super) trait Entry: Coefficient {
    /// The number m · 2^k.
    fn scaled(parts: (i64, u32)) -> Self;
    /// Subtracts a product.
    fn subtract_product(&mut self, a: &Self, b: &Self);
    /// Divides a row by a common factor; returns false if the row is zero.
    fn simplify(row: &mut [Self]) -> bool;
}

impl Entry for Residue {
    #[inline]
    fn scaled((m, k): (i64, u32)) -> Self {
        Residue::scaled(m, k)
    }

    #[inline]
    fn subtract_product(&mut self, a: &Self, b: &Self) {
        *self = self.minus(a.times(*b));
    }

    fn simplify(row: &mut [Self]) -> bool {
        row.iter().any(|x| !x.is_zero())
    }
}

impl Entry for Integer {
    fn scaled((m, k): (i64, u32)) -> Self {
        Integer::from(m) << k
    }

    fn subtract_product(&mut self, a: &Self, b: &Self) {
        self.add_product(&-a.clone(), b);
    }

    fn simplify(row: &mut [Self]) -> bool {
        let common = row.iter().fold(Integer::ZERO, |common, x| common.gcd(x));
        if common.is_zero() {
            return false;
        }
        row.iter_mut().for_each(|x| *x = x.div_exact(&common));
        true
    }
}

/// The coordinates of an exterior product, by sets of places of one size, in ascending order of bit masks.
///
/// Each coordinate is a series, one after the other. A blade with sets of one place is a point or a plane.
pub(super) type Blade<C> = SmallVec<[C; 8]>;

/// Blades of one length that span a space, one after the other.
pub(super) struct Spanning<C> {
    entries: SmallVec<[C; 16]>,
    /// The length of a blade; one if there is none.
    len: usize,
}

impl<C> Spanning<C> {
    fn none() -> Spanning<C> {
        Spanning { entries: SmallVec::new(), len: 1 }
    }

    /// Returns true if the space is zero.
    pub(super) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    fn blades(&self) -> impl Iterator<Item = &[C]> {
        self.entries.chunks(self.len)
    }

    fn push(&mut self, blade: Blade<C>) {
        self.len = blade.len();
        self.entries.extend(blade);
    }
}

impl<C> FromIterator<Blade<C>> for Spanning<C> {
    fn from_iter<I: IntoIterator<Item = Blade<C>>>(blades: I) -> Spanning<C> {
        let mut spanning = Spanning::none();
        blades.into_iter().for_each(|blade| spanning.push(blade));
        spanning
    }
}

/// The number of sets of each size, of as many places as there are rows.
const COUNTS: [[usize; 5]; 5] = [[1, 0, 0, 0, 0], [1, 1, 0, 0, 0], [1, 2, 1, 0, 0], [1, 3, 3, 1, 0], [1, 4, 6, 4, 1]];

/// The sets of up to four places, by size; those of fewer places come first.
const SETS: [&[usize]; 5] = [
    &[0],
    &[0b0001, 0b0010, 0b0100, 0b1000],
    &[0b0011, 0b0101, 0b0110, 0b1001, 0b1010, 0b1100],
    &[0b0111, 0b1011, 0b1101, 0b1110],
    &[0b1111],
];

/// The place of a set among those of its size.
const RANKS: [usize; 16] = {
    let mut ranks = [0; 16];
    let mut size = 0;
    while size < SETS.len() {
        let mut at = 0;
        while at < SETS[size].len() {
            ranks[SETS[size][at]] = at;
            at += 1;
        }
        size += 1;
    }
    ranks
};

/// The spaces of a determinant's vertices.
pub(super) struct Spaces<'q, C> {
    of: Moving<'q>,
    /// The number of coefficients of a series.
    stride: usize,
    /// The pairs of monomials whose product is stored.
    pairs: SmallVec<[(usize, usize); 8]>,
    /// The homogeneous coordinates of the input vertices, vertex after vertex.
    points: SmallVec<[C; 64]>,
}

impl<'q, C: Entry> Spaces<'q, C> {
    /// The spaces of a determinant with these coordinates.
    pub(super) fn new(of: Moving<'q>, coordinate: impl Fn(usize) -> C) -> Spaces<'q, C> {
        let stride = of.cut.len();
        let pairs = match stride {
            1 => smallvec![(0, 0)],
            _ => {
                let all = (0..stride).flat_map(|i| (0..stride).map(move |j| (i, j)));
                all.filter(|&(i, j)| of.cut.fits(i, j)).collect()
            }
        };
        let mut points: SmallVec<[C; 64]> = SmallVec::new();
        for vertex in 0..of.inputs.len() {
            for axis in 0..=of.dimension {
                let at = points.len();
                points.push(if axis < of.dimension { coordinate(vertex * of.dimension + axis) } else { C::one() });
                points.resize(at + stride, C::zero());
            }
        }
        let mut spaces = Spaces { of, stride, pairs, points };
        for (one, &(infinitesimal, _)) in of.chosen.iter().enumerate() {
            let [vertex, axis] = [infinitesimal / of.dimension, infinitesimal % of.dimension];
            if let Some(place) = of.cut.place(one, 1) {
                spaces.points[(vertex * (of.dimension + 1) + axis) * stride + place] = C::one();
            }
        }
        spaces
    }

    /// The determinants that span all: none if the determinant is zero with each occurrence of a free vertex moving
    /// independently.
    pub(super) fn determinants(&self, fixed: &[Option<Blade<C>>]) -> Spanning<C> {
        let columns = &self.of.matrix.columns;
        let row = |place: &Place| {
            let row = self.row(place, fixed);
            if columns.len() > self.of.dimension {
                return row;
            }
            let chosen = |row: &[C]| columns.iter().flat_map(|&at| self.entry(row, at)).cloned().collect();
            self.span(row.blades().map(chosen))
        };
        self.wedges(self.of.matrix.places.iter().map(row), columns.len())
    }

    /// The points that complete the omitted columns to a projective frame.
    ///
    /// They are the other unit vectors, and the sum of all.
    pub(super) fn frame(&self) -> impl Iterator<Item = Blade<C>> + '_ {
        let all = self.of.dimension + 1;
        let mut ones = self.zeros(all);
        ones.iter_mut().step_by(self.stride).for_each(|x| *x = C::one());
        self.of.matrix.columns.iter().map(move |&column| self.unit(column, all)).chain([ones])
    }

    /// An input vertex with whole numbers for its free coordinates.
    pub(super) fn point_with(&self, at: usize, free: &[u32]) -> Blade<C> {
        let mut point = self.point(at);
        for (x, &n) in point.chunks_mut(self.stride).zip(free) {
            x.fill(C::zero());
            x[0] = C::whole(i64::from(n));
        }
        point
    }

    fn zeros(&self, len: usize) -> Blade<C> {
        let mut zeros = Blade::new();
        zeros.resize(len * self.stride, C::zero());
        zeros
    }

    /// A unit vector.
    fn unit(&self, at: usize, len: usize) -> Blade<C> {
        let mut unit = self.zeros(len);
        unit[at * self.stride] = C::one();
        unit
    }

    /// The coordinate of a blade.
    #[inline]
    fn entry<'x>(&self, blade: &'x [C], at: usize) -> &'x [C] {
        &blade[at * self.stride..][..self.stride]
    }

    /// The homogeneous coordinates of an input vertex.
    fn point(&self, at: usize) -> Blade<C> {
        let all = (self.of.dimension + 1) * self.stride;
        self.points[at * all..][..all].iter().cloned().collect()
    }

    /// The span of an input vertex.
    fn vertex(&self, v: Vertex, fixed: &[Option<Blade<C>>]) -> Spanning<C> {
        let at = self.of.number(v);
        if let Some(Some(point)) = fixed.get(at) {
            return [point.clone()].into_iter().collect();
        }
        let free = self.of.free_axes(at);
        let units = (0..free).map(|axis| self.unit(axis, self.of.dimension + 1));
        units.chain([self.point_with(at, &[0; 3][..free])]).collect()
    }

    /// The span of the homogeneous coordinates of a place.
    fn row(&self, place: &Place, fixed: &[Option<Blade<C>>]) -> Spanning<C> {
        let all = self.of.dimension + 1;
        let product = |vertices: &[Vertex]| self.wedges(vertices.iter().map(|&v| self.vertex(v, fixed)), all);
        let dual = |product: Spanning<C>| product.blades().map(|blade| self.dual(blade)).collect::<Spanning<C>>();
        let flat = |vertices: &[Vertex]| dual(product(vertices));
        match place {
            Place::Input(v) => self.vertex(*v, fixed),
            Place::Meet(Construction::Ssi(lines)) => dual(self.wedges(lines.iter().map(|line| flat(line)), all)),
            Place::Meet(Construction::Tpi(planes)) => dual(self.wedges(planes.iter().map(|plane| flat(plane)), all)),
            Place::Meet(Construction::Lpi { line, plane }) => {
                let (line, plane) = (product(line), flat(plane));
                let pairs = line.blades().flat_map(|line| plane.blades().map(move |plane| (line, plane)));
                self.span(pairs.map(|(line, plane)| self.cross(line, plane)))
            }
            Place::Meet(Construction::Ratio { ends: [a, c], share }) => {
                let (a, c) = (self.vertex(*a, fixed), self.vertex(*c, fixed));
                let pairs = a.blades().flat_map(|a| c.blades().map(move |c| [a, c]));
                self.span(pairs.map(|[a, c]| self.shared([a, c], *share)))
            }
        }
    }

    /// The span of the exterior products of spaces.
    fn wedges(&self, mut factors: impl Iterator<Item = Spanning<C>>, all: usize) -> Spanning<C> {
        let first = factors.next().expect("a product has factors");
        factors.enumerate().fold(first, |product, (at, factor)| {
            let size = at + 1;
            let pairs = product.blades().flat_map(|a| factor.blades().map(move |b| (a, b)));
            self.span(pairs.map(|(a, b)| self.wedge(a, b, all, size)))
        })
    }

    /// The exterior product of a product of `size` vectors and one more.
    fn wedge(&self, product: &[C], vector: &[C], all: usize, size: usize) -> Blade<C> {
        let count = COUNTS[all][size + 1];
        let mut blade = self.zeros(count);
        for (entry, &set) in blade.chunks_mut(self.stride).zip(&SETS[size + 1][..count]) {
            for at in (0..all).filter(|at| set >> at & 1 == 1) {
                let above = (set >> at >> 1).count_ones();
                let without = RANKS[set ^ 1 << at];
                self.add(entry, self.entry(product, without), self.entry(vector, at), above.is_multiple_of(2));
            }
        }
        blade
    }

    /// Adds a product of series, or subtracts it.
    #[inline]
    fn add(&self, entry: &mut [C], a: &[C], b: &[C], plus: bool) {
        for &(i, j) in &self.pairs {
            match (a[i].is_zero() || b[j].is_zero(), plus) {
                (true, _) => {}
                (false, true) => entry[i + j].add_product(&a[i], &b[j]),
                (false, false) => entry[i + j].subtract_product(&a[i], &b[j]),
            }
        }
    }

    /// The vector orthogonal to a product of one vector less than there are places.
    fn dual(&self, product: &[C]) -> Blade<C> {
        // In descending order of the omitted place.
        let mut dual = self.zeros(product.len() / self.stride);
        for (at, (entry, x)) in dual.chunks_mut(self.stride).zip(product.chunks(self.stride).rev()).enumerate() {
            for (entry, x) in entry.iter_mut().zip(x) {
                if at % 2 == 1 { entry.subtract(x) } else { entry.add(x) }
            }
        }
        dual
    }

    /// The point that divides the segment of two homogeneous rows, bilinear in these.
    ///
    /// For rows (a, v) and (c, w), and a share p/q, it is (p·w·a + (q − p)·v·c, q·v·w).
    fn shared(&self, [a, c]: [&[C]; 2], share: Share) -> Blade<C> {
        let ([p, _], [rest, _]) = (share.fraction(), share.rest().fraction());
        let weights = [a, c].map(|row| self.entry(row, self.of.dimension));
        let [mut of_a, mut of_c] = [self.zeros(1), self.zeros(1)];
        for (of, weight, share) in [(&mut of_a, weights[1], p), (&mut of_c, weights[0], rest)] {
            let share = C::whole(share);
            of.iter_mut().zip(weight).for_each(|(of, x)| of.add_product(x, &share));
        }
        let mut point = self.zeros(self.of.dimension + 1);
        for (at, entry) in point.chunks_mut(self.stride).enumerate() {
            self.add(entry, self.entry(a, at), &of_a, true);
            self.add(entry, self.entry(c, at), &of_c, true);
        }
        point
    }

    /// The point of a line, given as a product of two vectors, on a plane.
    fn cross(&self, line: &[C], plane: &[C]) -> Blade<C> {
        let mut point = self.zeros(self.of.dimension + 1);
        for (pair, &set) in SETS[2].iter().enumerate() {
            let (i, j) = (set.trailing_zeros() as usize, set.ilog2() as usize);
            let l = self.entry(line, pair);
            for (to, at, plus) in [(j, i, true), (i, j, false)] {
                let entry = &mut point[to * self.stride..][..self.stride];
                self.add(entry, self.entry(plane, at), l, plus);
            }
        }
        point
    }

    /// A smaller set of blades with the same span.
    fn span(&self, blades: impl IntoIterator<Item = Blade<C>>) -> Spanning<C> {
        let mut blades = blades.into_iter().filter(|blade| blade.iter().any(|x| !x.is_zero()));
        let mut spanning = Spanning::none();
        let (Some(first), second) = (blades.next(), blades.next()) else { return spanning };
        let Some(second) = second else {
            spanning.push(first);
            return spanning;
        };
        let mut rows: SmallVec<[Blade<C>; 8]> = SmallVec::new();
        for blade in [first, second].into_iter().chain(blades) {
            let len = blade.len();
            if !insert(&mut rows, blade.clone()) {
                continue;
            }
            for monomial in 1..self.stride {
                insert(&mut rows, self.times(&blade, monomial));
            }
            spanning.push(blade);
            if rows.len() == len {
                // The whole space.
                let len = len / self.stride;
                return (0..len).map(|at| self.unit(at, len)).collect();
            }
        }
        spanning
    }

    /// The product of a blade and a monomial.
    fn times(&self, blade: &Blade<C>, monomial: usize) -> Blade<C> {
        let mut product = self.zeros(blade.len() / self.stride);
        for (entry, x) in product.chunks_mut(self.stride).zip(blade.chunks(self.stride)) {
            for &(i, _) in self.pairs.iter().filter(|(_, j)| *j == monomial) {
                entry[i + monomial] = x[i].clone();
            }
        }
        product
    }
}

/// Adds a row to rows in echelon form, unless it depends on them.
fn insert<C: Entry>(rows: &mut SmallVec<[Blade<C>; 8]>, mut row: Blade<C>) -> bool {
    for other in rows.iter() {
        let pivot = other.iter().position(|x| !x.is_zero()).expect("no row is zero");
        if row[pivot].is_zero() {
            continue;
        }
        let factor = row[pivot].clone();
        for (x, y) in row.iter_mut().zip(other) {
            let mut combined = C::zero();
            combined.add_product(x, &other[pivot]);
            combined.subtract_product(&factor, y);
            *x = combined;
        }
    }
    let is_independent = C::simplify(&mut row);
    if is_independent {
        rows.push(row);
    }
    is_independent
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_all_of_their_size() {
        for all in 0..=4 {
            for size in 0..=all {
                let sets: Vec<usize> = (0..1_usize << all).filter(|set| set.count_ones() as usize == size).collect();
                assert_eq!(sets, SETS[size][..COUNTS[all][size]], "{size} of {all}");
                assert!(sets.iter().enumerate().all(|(rank, &set)| RANKS[set] == rank));
            }
        }
    }
}
