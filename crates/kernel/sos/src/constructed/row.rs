//! Homogeneous rows of constructed vertices, and their derivatives by the first vertex that defines them.
//!
//! A row is a polynomial in the input vertices behind it. It is linear in a vertex that occurs once: a change of that
//! vertex by one along an axis adds a vector, the derivative. [`Row`] holds the unperturbed row, with positive weight,
//! and its derivatives by the coordinates of the vertex with the smallest index, all exactly. It is computed once, for
//! the first tie that needs it.
//!
//! Let e be the unit vector of an axis. Put the first vertex first in its line or plane (this changes a factor of the
//! row):
//!
//! | first in | row | derivative |
//! |---|---|---|
//! | the line p, q; F(x) = n·(x − b) for the other line or the plane | (p·F(q) − q·F(p), F(q) − F(p)) | (e·F(q) − q·n·e, −n·e) |
//! | the plane a, b, c of a line p, q; G(x) = (x − b) × (c − b) | the same | (p·G(q)·e − q·G(p)·e, G(q)·e − G(p)·e) |
//! | the ends a, c; a has the share p/q, and c the rest | (p·a + (q − p)·c, q) | (p·e, 0) |
//! | the plane a, b, c of three; its n and d = n·b, those of the next two m, n', M = m × n', K = d'·m − d_m·n' | (d·M + n × K, n·M) | the same with n = (c − b) × e |
//!
//! The normal of a plane a, b, c is (c − b) × (a − b), so that F(x) = det(c − b, a − b, x − b). If two of three planes
//! have the first vertex, their derivatives add up to the coefficient of its coordinate, and there are higher powers.
//!
//! # Space
//! Coordinates are scaled by one power of two for the whole scene, to less than 2^58. Differences are below 2^59,
//! normals below 2^119, F and d below 2^180, G below 2^119, M below 2^239, K below 2^299. Rows and weights of three
//! planes are below 2^420 and 2^360, their derivatives below 2^360 and 2^300; those of a line and a plane are below
//! 2^240 and 2^181: degree k is below 2^(61·k). With coordinates that are multiples of 2^(64·l), l ≤ 0, it is a
//! multiple of 2^(64·k·l). [`Number::sum`] takes up to three bits more for its terms and a sign, so k·(61 − 64·l) + 4
//! bits are enough for each sum.
//!
//! | | degree | sums |
//! |---|---|---|
//! | a share of a segment | 2: one, and whole numbers up to 2^53 | one for each axis |
//! | two lines | 3 | 2 + 4 + 2 + 3 differences, distances and the row, 2 · 2 for derivatives (a weight takes none) |
//! | a line and a plane | 4 | 6 + 3 + 6 + 2 + 4 for the plane and the row, 6 + 3 · 4 for derivatives at most |
//! | three planes | 7 | 30 for the planes, 4 for the row; for each plane with the first vertex 6 + 3 · 5; 12 to add two of them up |

use std::sync::OnceLock;

use predicament_arithmetic::{
    ExponentRange,
    dyadic::{
        Number, Space,
        Take::{Minus, Plus},
    },
};
use predicament_predicates::{Construction, Dimension, Scene, Share, Sign, Vertex};
use smallvec::{SmallVec, smallvec};

use super::place::Place;

/// The bit length of the scene's largest coordinate after scaling.
const TOP: i32 = 58;
/// The degree, and the maximum number of sums for a row and its derivatives: those of the table, added up.
const SHARE: (i32, usize) = (2, 3);
const TWO_LINES: (i32, usize) = (3, 15);
const LINE_AND_PLANE: (i32, usize) = (4, 39);
const THREE_PLANES: (i32, usize) = (7, 88);

/// Limbs for the computation; on the stack for coordinates of one limb, except for three planes.
type Limbs = SmallVec<[u64; 256]>;

pub(super) type Vector<'a, const D: usize> = [Number<'a>; D];

/// The location of a stored number's limbs.
#[derive(Clone, Copy, Default)]
struct Entry {
    start: usize,
    length: usize,
    low: i32,
    negative: bool,
}

/// The row of a constructed vertex.
pub(super) struct Row {
    /// The vertex's simplest definition.
    pub(super) place: Place,
    /// The input vertices behind it, each once, ascending.
    pub(super) inputs: SmallVec<[Vertex; 9]>,
    /// The sign of the weight by definition, which a row with a positive weight has lost.
    pub(super) weight: Sign,
    /// True if the row is linear in the first of these vertices.
    pub(super) is_linear: bool,
    /// The number of coordinates.
    dimension: usize,
    /// The row and its derivatives: coordinates and weight of each; empty if the place is an input vertex.
    entries: Vec<Entry>,
    /// The weights of the ends of its line or segment; zeros for three planes.
    ends: [Entry; 2],
    limbs: Vec<u64>,
    /// The exponents [l, t]: entries and ends are multiples of 2^(64·l) and below 2^(64·t) in magnitude.
    pub(super) span: [i32; 2],
}

/// The rows of a session's constructed vertices, each computed for the first tie that needs it.
pub(super) struct Rows {
    shift: OnceLock<i32>,
    rows: Vec<OnceLock<Box<Row>>>,
}

impl Rows {
    pub(super) fn new(scene: &Scene) -> Rows {
        let mut rows = Rows { shift: OnceLock::new(), rows: Vec::new() };
        rows.grow(scene);
        rows
    }

    /// Adds slots for new vertices of the scene.
    pub(super) fn grow(&mut self, scene: &Scene) {
        self.rows.resize_with(scene.constructions().len(), OnceLock::new);
    }

    /// The exponent of the scale of coordinates, which is fixed because input vertices are never added.
    pub(super) fn shift(&self, scene: &Scene) -> i32 {
        *self.shift.get_or_init(|| ExponentRange::of(scene.coordinates()).map_or(0, |range| TOP - range.highest))
    }

    /// The row of a constructed vertex.
    ///
    /// # Panics
    /// If the scene has no such vertex, or its lines and planes do not meet in a point.
    pub(super) fn of(&self, scene: &Scene, index: usize) -> &Row {
        self.rows[index].get_or_init(|| Box::new(Row::new(scene, self.shift(scene), Vertex::constructed(index))))
    }
}

impl Row {
    fn new(scene: &Scene, shift: i32, v: Vertex) -> Row {
        let place = Place::simple(scene, v);
        let mut inputs = place.vertices();
        inputs.sort_unstable();
        let is_linear = inputs.get(1).is_none_or(|second| *second != inputs[0]);
        inputs.dedup();
        let dimension = scene.dimension().count();
        let (weight, span) = (Sign::Positive, [0, 0]);
        let (entries, ends, limbs) = (Vec::new(), [Entry::default(); 2], Vec::new());
        let mut row = Row { place, inputs, weight, is_linear, dimension, entries, ends, limbs, span };
        let Place::Meet(construction) = place else { return row };
        let mut held = [0; 2 * 9 * 3];
        let held = &mut Space::new(&mut held);
        match construction {
            Construction::Ssi(lines) => {
                let [[p, q], [a, b]] = lines.map(|line| line.map(|v| point::<2>(held, scene, v, shift)));
                let mut limbs: Limbs = smallvec![0; capacity(&[p, q, a, b], TWO_LINES)];
                let space = &mut Space::new(&mut limbs);
                let [x, y] = minus(space, b, a);
                let (moved, ends) = line_moves::<2, 3>(space, [p, q], [negative(y), x], a);
                row.hold(moved, ends);
            }
            Construction::Lpi { line, plane } => {
                let [p, q] = line.map(|v| point::<3>(held, scene, v, shift));
                let [a, b, c] = plane.map(|v| point::<3>(held, scene, v, shift));
                let mut limbs: Limbs = smallvec![0; capacity(&[p, q, a, b, c], LINE_AND_PLANE)];
                let space = &mut Space::new(&mut limbs);
                let sides = [minus(space, c, b), minus(space, a, b)];
                let normal = cross(space, sides[0], sides[1]);
                let (moved, ends) = if line[0] < plane[0] {
                    line_moves::<3, 4>(space, [p, q], normal, b)
                } else {
                    plane_moves(space, [p, q], normal, [b, sides[0]])
                };
                row.hold(moved, ends);
            }
            Construction::Tpi(planes) => {
                let first = row.inputs[0];
                let points = planes.map(|plane| plane.map(|v| point::<3>(held, scene, v, shift)));
                let mut limbs: Limbs = smallvec![0; capacity(points.as_flattened(), THREE_PLANES)];
                let space = &mut Space::new(&mut limbs);
                row.hold(three_planes(space, points, planes.map(|plane| plane[0] == first)), [Number::ZERO; 2]);
            }
            Construction::Ratio { ends, share } => match scene.dimension() {
                Dimension::Two => {
                    let ends = ends.map(|v| point::<2>(held, scene, v, shift));
                    let mut limbs: Limbs = smallvec![0; capacity(&ends, SHARE)];
                    let parts = Parts::of(share);
                    let [p, rest, q] = parts.numbers();
                    row.hold(shared::<2, 3>(&mut Space::new(&mut limbs), ends, [p, rest, q]), [p, rest]);
                }
                Dimension::Three => {
                    let ends = ends.map(|v| point::<3>(held, scene, v, shift));
                    let mut limbs: Limbs = smallvec![0; capacity(&ends, SHARE)];
                    let parts = Parts::of(share);
                    let [p, rest, q] = parts.numbers();
                    row.hold(shared::<3, 4>(&mut Space::new(&mut limbs), ends, [p, rest, q]), [p, rest]);
                }
            },
        }
        row
    }

    /// Stores a row and its derivatives, coordinates and weights, and the weights of its ends.
    fn hold<const D: usize, const V: usize>(
        &mut self,
        (vectors, weights): ([Vector<D>; V], [Number; V]),
        ends: [Number; 2],
    ) {
        assert!(!weights[0].is_zero(), "lines and planes that meet in no point");
        self.weight = Sign::from(weights[0].cmp0());
        let numbers = || vectors.iter().zip(&weights).flat_map(|(vector, weight)| vector.iter().chain([weight]));
        self.entries.reserve_exact(V * (D + 1));
        self.limbs.reserve_exact(numbers().chain(&ends).map(|number| number.limbs.len()).sum());
        let (mut low, mut top) = (i32::MAX, i32::MIN);
        let mut held = |number: &Number| {
            let (start, length) = (self.limbs.len(), number.limbs.len());
            self.limbs.extend_from_slice(number.limbs);
            if !number.is_zero() {
                (low, top) = (low.min(number.low), top.max(number.top()));
            }
            Entry { start, length, low: number.low, negative: number.negative != weights[0].negative }
        };
        self.entries.extend(numbers().map(&mut held));
        self.ends = ends.each_ref().map(held);
        self.span = [low, top];
    }

    fn number(&self, Entry { start, length, low, negative }: Entry) -> Number<'_> {
        Number { limbs: &self.limbs[start..start + length], low, negative }
    }

    /// The weight of an end of its line or segment: the row is the sum of both ends times their weights.
    pub(super) fn end(&self, at: usize) -> Number<'_> {
        self.number(self.ends[at])
    }

    /// Some columns of the row for 0, or of its derivative for 1, 2…; the last column is the weight.
    ///
    /// The derivatives are by coordinates 0, 1… of its first vertex.
    pub(super) fn vector<const N: usize>(&self, which: usize, columns: [usize; N]) -> [Number<'_>; N] {
        let entries = &self.entries[which * (self.dimension + 1)..][..=self.dimension];
        columns.map(|column| self.number(entries[column]))
    }
}

/// The coordinates of an input vertex, scaled; two limbs each.
pub(super) fn point<'a, const D: usize>(space: &mut Space<'a>, scene: &Scene, v: Vertex, shift: i32) -> Vector<'a, D> {
    let point = scene.point(v);
    std::array::from_fn(|axis| Number::scaled(space, point[axis], shift))
}

/// The limbs for this many sums, of this degree at most.
pub(super) fn capacity<const D: usize>(points: &[Vector<D>], (degree, sums): (i32, usize)) -> usize {
    let low = points.as_flattened().iter().map(|x| x.low).min().unwrap_or(0).min(0);
    sums * usize::try_from(degree * (61 - 64 * low) + 4).unwrap_or(0).div_ceil(64)
}

/// A row with derivatives, coordinates and weights, and the weights of its ends.
type Moved<'a, const D: usize, const V: usize> = (([Vector<'a, D>; V], [Number<'a>; V]), [Number<'a>; 2]);

/// The point where the line p, q meets the line or plane with this normal through b, with derivatives by p.
fn line_moves<'a, const D: usize, const V: usize>(
    space: &mut Space<'a>,
    [p, q]: [Vector<'a, D>; 2],
    normal: Vector<'a, D>,
    b: Vector<'a, D>,
) -> Moved<'a, D, V> {
    const { assert!(V == D + 1, "a row, and a derivative for each axis") };
    let [at_p, at_q] = [p, q].map(|x| {
        let way = minus(space, x, b);
        dot(space, normal, way)
    });
    let (mut vectors, mut weights) = ([[Number::ZERO; D]; V], [Number::ZERO; V]);
    (vectors[0], weights[0]) = between(space, [p, q], [at_p, at_q]);
    for axis in 0..D {
        let by = normal[axis];
        vectors[axis + 1] = std::array::from_fn(|i| {
            let own = if i == axis { at_q } else { Number::ZERO };
            Number::sum(space, [(own, Number::ONE, Plus), (q[i], by, Minus)])
        });
        weights[axis + 1] = negative(by);
    }
    ((vectors, weights), [at_q, negative(at_p)])
}

/// The point where the line p, q meets the plane a, b, c, with derivatives by a.
///
/// The normal, b and c − b of the plane are given.
fn plane_moves<'a>(
    space: &mut Space<'a>,
    [p, q]: [Vector<'a, 3>; 2],
    normal: Vector<'a, 3>,
    [b, side]: [Vector<'a, 3>; 2],
) -> Moved<'a, 3, 4> {
    let ways = [p, q].map(|x| minus(space, x, b));
    let [at_p, at_q] = ways.map(|way| dot(space, normal, way));
    let [by_p, by_q] = ways.map(|way| cross(space, way, side));
    let (mut vectors, mut weights) = ([[Number::ZERO; 3]; 4], [Number::ZERO; 4]);
    (vectors[0], weights[0]) = between(space, [p, q], [at_p, at_q]);
    for axis in 0..3 {
        (vectors[axis + 1], weights[axis + 1]) = between(space, [p, q], [by_p[axis], by_q[axis]]);
    }
    ((vectors, weights), [at_q, negative(at_p)])
}

/// The coordinates p·v − q·u, and the weight v − u.
fn between<'a, const D: usize>(
    space: &mut Space<'a>,
    [p, q]: [Vector<'a, D>; 2],
    [u, v]: [Number<'a>; 2],
) -> (Vector<'a, D>, Number<'a>) {
    let coordinates = std::array::from_fn(|i| Number::sum(space, [(p[i], v, Plus), (q[i], u, Minus)]));
    (coordinates, Number::sum(space, [(v, Number::ONE, Plus), (u, Number::ONE, Minus)]))
}

/// The point where three planes meet, with derivatives by the first vertex of the marked planes.
fn three_planes<'a>(
    space: &mut Space<'a>,
    planes: [[Vector<'a, 3>; 3]; 3],
    moves: [bool; 3],
) -> ([Vector<'a, 3>; 4], [Number<'a>; 4]) {
    let sides = planes.map(|[_, b, c]| minus(space, c, b));
    let (mut normals, mut offsets) = ([[Number::ZERO; 3]; 3], [Number::ZERO; 3]);
    for (at, [a, b, _]) in planes.into_iter().enumerate() {
        let other = minus(space, a, b);
        normals[at] = cross(space, sides[at], other);
        offsets[at] = dot(space, normals[at], b);
    }
    let (mut vectors, mut weights) = ([[Number::ZERO; 3]; 4], [Number::ZERO; 4]);
    let mut is_first = true;
    for at in (0..3).filter(|&at| moves[at]) {
        let [m, n] = [(at + 1) % 3, (at + 2) % 3];
        let line = cross(space, normals[m], normals[n]);
        let kept: Vector<3> = std::array::from_fn(|i| {
            Number::sum(space, [(offsets[n], normals[m][i], Plus), (offsets[m], normals[n][i], Minus)])
        });
        // With the plane's own normal and offset, or with their derivatives.
        let meet = |space: &mut Space<'a>, normal: Vector<'a, 3>, offset: Number<'a>| -> (Vector<'a, 3>, Number<'a>) {
            let coordinates = [[1, 2], [2, 0], [0, 1]].into_iter().enumerate().map(|(i, [j, k])| {
                Number::sum(space, [(offset, line[i], Plus), (normal[j], kept[k], Plus), (normal[k], kept[j], Minus)])
            });
            let coordinates: SmallVec<[Number; 3]> = coordinates.collect();
            ([coordinates[0], coordinates[1], coordinates[2]], dot(space, normal, line))
        };
        if is_first {
            (vectors[0], weights[0]) = meet(space, normals[at], offsets[at]);
        }
        for axis in 0..3 {
            let normal = cross_axis(sides[at], axis);
            let offset = dot(space, normal, planes[at][1]);
            let (vector, weight) = meet(space, normal, offset);
            if is_first {
                (vectors[axis + 1], weights[axis + 1]) = (vector, weight);
            } else {
                vectors[axis + 1] = std::array::from_fn(|i| plus(space, vectors[axis + 1][i], vector[i]));
                weights[axis + 1] = plus(space, weights[axis + 1], weight);
            }
        }
        is_first = false;
    }
    (vectors, weights)
}

/// The whole numbers p, q − p and q of a share p/q: magnitudes, and true for a negative number.
struct Parts([([u64; 1], bool); 3]);

impl Parts {
    fn of(share: Share) -> Parts {
        let ([p, q], [rest, _]) = (share.fraction(), share.rest().fraction());
        Parts([p, rest, q].map(|x| ([x.unsigned_abs()], x < 0)))
    }

    fn numbers(&self) -> [Number<'_>; 3] {
        self.0.each_ref().map(|(limbs, negative)| match limbs {
            [0] => Number::ZERO,
            limbs => Number { limbs, low: 0, negative: *negative },
        })
    }
}

/// The point p·a + (q − p)·c with weight q, with derivatives by a, which is the first vertex in canonical form.
fn shared<'a, const D: usize, const V: usize>(
    space: &mut Space<'a>,
    [a, c]: [Vector<'a, D>; 2],
    [p, rest, q]: [Number<'a>; 3],
) -> ([Vector<'a, D>; V], [Number<'a>; V]) {
    const { assert!(V == D + 1, "a row, and a derivative for each axis") };
    let (mut vectors, mut weights) = ([[Number::ZERO; D]; V], [Number::ZERO; V]);
    vectors[0] = std::array::from_fn(|i| Number::sum(space, [(a[i], p, Plus), (c[i], rest, Plus)]));
    weights[0] = q;
    for axis in 0..D {
        vectors[axis + 1][axis] = p;
    }
    (vectors, weights)
}

fn negative(x: Number) -> Number {
    Number { negative: !x.negative, ..x }
}

fn plus<'a>(space: &mut Space<'a>, x: Number<'a>, y: Number<'a>) -> Number<'a> {
    Number::sum(space, [(x, Number::ONE, Plus), (y, Number::ONE, Plus)])
}

pub(super) fn minus<'a, const D: usize>(space: &mut Space<'a>, p: Vector<'a, D>, q: Vector<'a, D>) -> Vector<'a, D> {
    std::array::from_fn(|i| Number::sum(space, [(p[i], Number::ONE, Plus), (q[i], Number::ONE, Minus)]))
}

pub(super) fn cross<'a>(space: &mut Space<'a>, p: Vector<'a, 3>, q: Vector<'a, 3>) -> Vector<'a, 3> {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| Number::sum(space, [(p[i], q[j], Plus), (p[j], q[i], Minus)]))
}

/// The product with the unit vector of an axis.
fn cross_axis(p: Vector<3>, axis: usize) -> Vector<3> {
    let mut product = [Number::ZERO; 3];
    let [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
    product[next] = p[last];
    product[last] = negative(p[next]);
    product
}

pub(super) fn dot<'a, const D: usize>(space: &mut Space<'a>, p: Vector<'a, D>, q: Vector<'a, D>) -> Number<'a> {
    let mut terms = [(Number::ZERO, Number::ZERO, Plus); 3];
    for (term, (x, y)) in terms.iter_mut().zip(p.into_iter().zip(q)) {
        *term = (x, y, Plus);
    }
    Number::sum(space, terms)
}

#[cfg(test)]
mod tests;
