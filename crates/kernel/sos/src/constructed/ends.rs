//! Ties of points whose ends are degenerate themselves.
//!
//! A constructed point is a combination of input vertices, its *ends*: of the two vertices of its line, or of the three
//! of one of its planes. The determinant D of a question is linear in each point. It is a sum over all choices of one
//! end of each point: D = Σ wₜ·Dₜ, where wₜ is the product of the chosen ends' weights, and Dₜ the determinant of the
//! chosen ends. On a face along the axes, every Dₜ is zero without a move.
//!
//! Let M be the largest monomial with a nonzero coefficient in some Dₜ. The monomials of wₜ are at most one, the
//! largest monomial of all. A product of two monomials is at most either of them. So no monomial of D is larger than M,
//! and a product is M only if its factors are one and M: the coefficient of M in D is Σ wₜ(0)·Dₜ[M], with the weights
//! of the given scene. If it is not zero, M decides. Nothing has to be proved to be zero, and nothing is expanded: the
//! coefficients of Dₜ are minors of input vertices.
//!
//! M has each vertex once at most. The sum over all ends is again a determinant of rows: for each way to give the
//! vertices of M rows of which they are ends, the row is the vertex' weight times the unit vector of its axis. The
//! other rows are those of the points. (If a vertex of M is an end of two rows, a choice that takes it twice
//! contributes its two terms with opposite signs, and is zero.)
//!
//! # Weights
//! | the point of | ends | weights |
//! |---|---|---|
//! | the line p, q; F is zero on the other line or the plane | p, q | F(q), −F(p) |
//! | a share p/q of a, c | a, c | p, q − p |
//! | the plane a, b, c; F and G are zero on the next two planes | a, b, c | F(b)·G(c) − F(c)·G(b), … in cycles |
//!
//! These weights add up to the row's weight, if normals are those of [`row`](super::row). The sum does not depend on
//! which of three planes is the first in their cycle.

use predicament_arithmetic::dyadic::{
    Number, Space,
    Take::{Minus, Plus},
};
use predicament_predicates::{Axis, Construction, Question, Scene, Sign, Vertex};
use smallvec::{SmallVec, smallvec};

use super::factors::inputs::minor;
use super::first::{Known, Point, columns, sign_of_sum};
use super::place::Place;
use super::row::{Row, Rows, Vector, capacity, cross, dot, minus, point};

/// Tries to find the sign of a determinant from the determinants of its points' ends.
///
/// # Panics
/// If the scene lacks a vertex, or the question is about circles or spheres.
pub(super) fn decide<const N: usize>(scene: &Scene, rows: &Rows, question: Question, args: [Vertex; N]) -> Known {
    let meets = args.map(|v| v.construction().map(|index| rows.of(scene, index)));
    let columns = columns(scene.dimension().count(), question);
    let places: [Place; N] = std::array::from_fn(|at| meets[at].map_or(Place::Input(args[at]), |row| row.place));
    let all = places.each_ref().map(Way::all);
    for choice in 0..all.iter().map(SmallVec::len).product() {
        let mut left = choice;
        let ways: [Way; N] = std::array::from_fn(|at| {
            let digit = left % all[at].len();
            left /= all[at].len();
            all[at][digit]
        });
        let sum = Sum { scene, columns, ways };
        let Some(factors) = sum.largest() else { return Known::Identity };
        if factors.is_empty() {
            continue;
        }
        let sign = sum.coefficient(&factors, &places, &meets, rows.shift(scene));
        if !sign.is_zero() {
            return Known::Broken(sign, factors.len());
        }
    }
    Known::Open
}

/// A way to write a point as a combination of input vertices.
#[derive(Clone, Copy)]
enum Way {
    Vertex([Vertex; 1]),
    /// The point of a line or a segment, by the ends of that.
    OfLine([Vertex; 2]),
    /// The point of three planes, by the vertices of the first one.
    OfPlane([[Vertex; 3]; 3]),
}

impl Way {
    fn all(place: &Place) -> SmallVec<[Way; 3]> {
        match *place {
            Place::Input(v) => smallvec![Way::Vertex([v])],
            Place::Meet(Construction::Ssi([ends, _])) => smallvec![Way::OfLine(ends)],
            Place::Meet(Construction::Lpi { line: ends, .. } | Construction::Ratio { ends, .. }) => {
                smallvec![Way::OfLine(ends)]
            }
            Place::Meet(Construction::Tpi([a, b, c])) => {
                smallvec![Way::OfPlane([a, b, c]), Way::OfPlane([b, c, a]), Way::OfPlane([c, a, b])]
            }
        }
    }

    fn ends(&self) -> &[Vertex] {
        match self {
            Way::Vertex(end) => end,
            Way::OfLine(ends) => ends,
            Way::OfPlane([ends, ..]) => ends,
        }
    }
}

/// The weight of an end of a plane where it meets two others, in the scene as it is.
///
/// The row's weight has the sign `of_row`. It is of degree 6, and takes 2 · (6 + 3) + 4 · (3 + 1) + 1 sums.
fn weight<'a>(scene: &Scene, shift: i32, planes: [[Vertex; 3]; 3], end: usize, of_row: Sign) -> Weight<'a> {
    let mut held = [0; 2 * 9 * 3];
    let held = &mut Space::new(&mut held);
    let points = planes.map(|plane| plane.map(|v| point::<3>(held, scene, v, shift)));
    let mut limbs: SmallVec<[u64; 256]> = smallvec![0; capacity(points.as_flattened(), (6, 35))];
    let space = &mut Space::new(&mut limbs);
    let [own, planes @ ..] = points;
    let [next, last] = [own[(end + 1) % 3], own[(end + 2) % 3]];
    let [f, g] = planes.map(|plane| {
        let normal = normal(space, plane);
        [next, last].map(|x| {
            let way = minus(space, x, plane[1]);
            dot(space, normal, way)
        })
    });
    let Number { limbs, low, negative } = Number::sum(space, [(f[0], g[1], Plus), (f[1], g[0], Minus)]);
    Weight::Made { limbs: SmallVec::from_slice(limbs), low, negative: negative != (of_row == Sign::Negative) }
}

/// The normal (c − b) × (a − b).
fn normal<'a>(space: &mut Space<'a>, [a, b, c]: [Vector<'a, 3>; 3]) -> Vector<'a, 3> {
    let sides = [minus(space, c, b), minus(space, a, b)];
    cross(space, sides[0], sides[1])
}

/// The weight of an end, for a row with a positive weight.
enum Weight<'a> {
    Known(Number<'a>),
    Made { limbs: SmallVec<[u64; 6]>, low: i32, negative: bool },
}

impl Weight<'_> {
    fn number(&self) -> Number<'_> {
        match self {
            Weight::Known(number) => *number,
            Weight::Made { limbs, low, negative } => Number { limbs, low: *low, negative: *negative },
        }
    }
}

/// The determinant of a question as a sum over the ends of its points.
struct Sum<'q, const N: usize> {
    scene: &'q Scene,
    /// The columns by axis; the last one is the weight.
    columns: [usize; N],
    ways: [Way; N],
}

/// Infinitesimals: vertices and axes, each vertex once.
type Factors = SmallVec<[(Vertex, usize); 3]>;

impl<const N: usize> Sum<'_, N> {
    /// The largest monomial of all choices of ends; empty for one.
    ///
    /// `None` if the determinant is zero for each choice, wherever the vertices are.
    fn largest(&self) -> Option<Factors> {
        let mut axes: SmallVec<[Axis; 3]> = SmallVec::new();
        axes.extend(
            [Axis::X, Axis::Y, Axis::Z].into_iter().filter(|axis| self.columns[..N - 1].contains(&axis.index())),
        );
        let mut all: SmallVec<[Vertex; 12]> = self.ways.iter().flat_map(Way::ends).copied().collect();
        all.sort_unstable();
        all.dedup();
        let mut largest: Option<u64> = None;
        for choice in 0..self.ways.iter().map(|way| way.ends().len()).product() {
            let mut left: usize = choice;
            let mut ends: [Vertex; N] = std::array::from_fn(|at| {
                let all = self.ways[at].ends();
                let digit = left % all.len();
                left /= all.len();
                all[digit]
            });
            ends.sort_unstable();
            if ends.windows(2).any(|pair| pair[0] == pair[1]) {
                continue;
            }
            let ranks = ends.map(|v| all.binary_search(&v).expect("an end"));
            for monomial in monomials(N) {
                let bits = monomial.among(N - 1, &ranks, &axes);
                if largest.is_some_and(|largest| bits >= largest) {
                    break;
                }
                let rows: SmallVec<[Vertex; 4]> = still(monomial.rows, &ends);
                let columns: SmallVec<[Axis; 3]> = still(monomial.columns, &axes);
                if !minor(self.scene, &columns, &rows).is_zero() {
                    largest = Some(bits);
                    break;
                }
            }
            if largest == Some(0) {
                break;
            }
        }
        let largest = largest?;
        let bits = (0..u64::BITS as usize).filter(|bit| largest >> bit & 1 == 1);
        Some(bits.map(|bit| (all[bit / 3], bit % 3)).collect())
    }

    /// The sign of the coefficient of a monomial, if no choice of ends has a larger one.
    fn coefficient(&self, factors: &Factors, places: &[Place; N], meets: &[Option<&Row>; N], shift: i32) -> Sign {
        let mut held = [[0; 2 * 3]; N];
        let mut rows = [[Number::ZERO; N]; N];
        let mut spans = [[0; 2]; N];
        for (at, held) in held.iter_mut().enumerate() {
            let point = Point::new(held, self.scene, &places[at], meets[at], shift, self.columns);
            let point = point.expect("a constructed vertex has a row");
            (rows[at], spans[at]) = (point.vector(0), point.span());
        }
        let mut weights: SmallVec<[(usize, usize, Weight); 4]> = SmallVec::new();
        for (factor, (v, _)) in factors.iter().enumerate() {
            for (at, way) in self.ways.iter().enumerate() {
                let Some(end) = way.ends().iter().position(|end| end == v) else { continue };
                let weight = match (way, meets[at]) {
                    (Way::OfLine(_), Some(row)) => Weight::Known(row.end(end)),
                    (Way::OfPlane(planes), Some(row)) => weight(self.scene, shift, *planes, end, row.weight),
                    _ => Weight::Known(Number::ONE),
                };
                let number = weight.number();
                if !number.is_zero() {
                    let [low, top] = spans[at];
                    spans[at] = [low.min(number.low), top.max(number.top())];
                    weights.push((factor, at, weight));
                }
            }
        }
        let mut terms: SmallVec<[[[Number; N]; N]; 4]> = SmallVec::new();
        self.give(factors, &weights, &mut [false; N], &mut rows, &mut terms);
        let span = spans.iter().map(|[low, top]| usize::try_from(top - low).unwrap_or(0)).sum();
        sign_of_sum(&terms, span)
    }

    /// Enumerates all ways to give the vertices of a monomial rows of which they are ends.
    fn give<'w>(
        &self,
        factors: &[(Vertex, usize)],
        weights: &'w [(usize, usize, Weight<'w>)],
        given: &mut [bool; N],
        rows: &mut [[Number<'w>; N]; N],
        terms: &mut SmallVec<[[[Number<'w>; N]; N]; 4]>,
    ) {
        let Some((&(_, axis), before)) = factors.split_last() else {
            terms.push(*rows);
            return;
        };
        for (_, at, weight) in weights.iter().filter(|(factor, ..)| *factor == before.len()) {
            if !given[*at] {
                let still = rows[*at];
                rows[*at] = self.columns.map(|column| if column == axis { weight.number() } else { Number::ZERO });
                given[*at] = true;
                self.give(before, weights, given, rows, terms);
                (rows[*at], given[*at]) = (still, false);
            }
        }
    }
}

/// The elements of a set that is a bit mask of places.
fn still<const M: usize, T: Copy>(set: u8, all: &[T]) -> SmallVec<[T; M]>
where
    [T; M]: smallvec::Array<Item = T>,
{
    all.iter().enumerate().filter(|(at, _)| set >> at & 1 == 1).map(|(_, one)| *one).collect()
}

/// A product of infinitesimals of different rows and columns, with the minor that is its coefficient.
#[derive(Clone, Copy)]
struct Monomial {
    /// A bit for each infinitesimal: row after row, and column after column.
    bits: u16,
    /// The rows that are left, as a bit mask.
    rows: u8,
    /// The columns that are left, as a bit mask.
    columns: u8,
}

impl Monomial {
    const ONE: Monomial = Monomial { bits: 0, rows: 0, columns: 0 };

    /// The same monomial, with three bits for each of all vertices, of which the rows have these ranks.
    fn among(&self, width: usize, ranks: &[usize], axes: &[Axis]) -> u64 {
        let (mut left, mut among) = (usize::from(self.bits), 0);
        while left != 0 {
            let bit = left.trailing_zeros() as usize;
            among |= 1 << (3 * ranks[bit / width] + axes[bit % width].index());
            left &= left - 1;
        }
        among
    }
}

/// The monomials of a determinant of this many rows, the largest first.
///
/// The larger of two has no infinitesimal that is as small as the smallest one in which they differ: its bits are the
/// smaller number.
fn monomials(rows: usize) -> &'static [Monomial] {
    static OF_TWO: [Monomial; 3] = ascending(2);
    static OF_THREE: [Monomial; 13] = ascending(3);
    static OF_FOUR: [Monomial; 73] = ascending(4);
    match rows {
        2 => &OF_TWO,
        3 => &OF_THREE,
        _ => &OF_FOUR,
    }
}

const fn ascending<const COUNT: usize>(rows: usize) -> [Monomial; COUNT] {
    let width = rows - 1;
    let mut all = [Monomial::ONE; COUNT];
    let (mut count, mut bits) = (0, 0_u16);
    while bits < 1 << (rows * width) {
        let (mut rows_left, mut columns_left) = ((1_u8 << rows) - 1, (1_u8 << width) - 1);
        let (mut at, mut once) = (0, true);
        while at < rows * width {
            if bits >> at & 1 == 1 {
                once &= rows_left >> (at / width) & 1 == 1 && columns_left >> (at % width) & 1 == 1;
                rows_left &= !(1 << (at / width));
                columns_left &= !(1 << (at % width));
            }
            at += 1;
        }
        if once {
            all[count] = Monomial { bits, rows: rows_left, columns: columns_left };
            count += 1;
        }
        bits += 1;
    }
    assert!(count == COUNT, "all monomials, and no others");
    all
}

#[cfg(test)]
mod tests;
