//! Predicates on points of lines and planes of one mesh each, in integers of a fixed size.
//!
//! Where the line through p with direction u meets the plane with normal n through a, the point is p + u·N/w with N =
//! n·(a − p) and w = n·u. As the second mesh moves by δ, the point moves by m·δ + s·u·(n·δ)/w, with m = 1 if the line
//! moves and 0 if not, and s the same of the plane, minus m. Nothing here is quadratic, so a coordinate times w is the
//! constant w·p + N·u, and three derivatives. A question is a polynomial in δ (see [`rigid`](super::rigid)): of two
//! coordinates with the degree 1, of a turn with the degree 2. The first nonzero coefficient decides.
//!
//! # The number of limbs
//! Coordinates are relative to a vertex of the question, in units of a power of two. With these below 2^b and B = b +
//! 1, in magnitude:
//!
//! | value | below | limbs: b = 61 | b = 124 |
//! |---|---|---:|---:|
//! | a difference, as u | 2^B | 1 | 2 |
//! | n | 2^(2B + 1) | 2 | 4 |
//! | w, N | 2^(3B + 3) | 3 | 6 |
//! | a derivative: w, and u·n | 2^(3B + 4) | 3 | 6 |
//! | a coordinate times w | 2^(4B + 4) | 4 | 8 |
//! | a coordinate times the other's weight, less the same exchanged | 2^(7B + 8) | 7 | 14 |
//! | a minor of two rows: eight products at most of two coordinates times w | 2^(8B + 11) | 8 | 16 |
//! | three of these, times a weight | 2^(11B + 16) | 11 | 22 |
//!
//! All of it takes one limb if B is up to 7 in a comparison, up to 4 in a turn; two limbs up to 17 and up to 10.

use predicament_arithmetic::{ExponentRange, Fixed, short_rows, units};
use predicament_predicates::{Axis, Construction, Plane, Scene, Sign, Vertex};

/// The sign and the deciding power of ε, 0 if no move is needed.
///
/// The inner `None`: zero however far the second mesh moves. The outer `None`: this method does not apply.
pub(crate) type Decided = Option<Option<(Sign, usize)>>;

/// The order of two points along an axis.
///
/// # Panics
/// If the scene lacks a vertex.
pub(crate) fn compare(scene: &Scene, second: &[bool], axis: Axis, args: [Vertex; 2]) -> Decided {
    let named = Named::new(scene, second, args)?;
    let axes = [axis.index()];
    let points = named.points::<11>(scene);
    let Some((points, bits)) = short(&points) else {
        return Some(order::<6, 8, 14>(&named.rows::<2, 4, 6, 8, 1>(&long(&points)?, axes)));
    };
    Some(match bits {
        0..=7 => order::<1, 1, 1>(&named.rows::<1, 1, 1, 1, 1>(&points, axes)),
        8..=17 => order::<2, 2, 2>(&named.rows::<1, 2, 2, 2, 1>(&points, axes)),
        _ => order::<3, 4, 7>(&named.rows::<1, 2, 3, 4, 1>(&points, axes)),
    })
}

/// The turn of three points in a coordinate plane.
///
/// # Panics
/// If the scene lacks a vertex.
pub(crate) fn orient2d(scene: &Scene, second: &[bool], plane: Plane, args: [Vertex; 3]) -> Decided {
    let named = Named::new(scene, second, args)?;
    let axes = plane.axes().map(Axis::index);
    let points = named.points::<16>(scene);
    let Some((points, bits)) = short(&points) else {
        return Some(turn::<6, 8, 16, 22>(&named.rows::<2, 4, 6, 8, 2>(&long(&points)?, axes)));
    };
    Some(match bits {
        0..=4 => turn::<1, 1, 1, 1>(&named.rows::<1, 1, 1, 1, 2>(&points, axes)),
        5..=10 => turn::<2, 2, 2, 2>(&named.rows::<1, 2, 2, 2, 2>(&points, axes)),
        _ => turn::<3, 4, 8, 11>(&named.rows::<1, 2, 3, 4, 2>(&points, axes)),
    })
}

/// The points of a question, by the vertices that define them.
struct Named<const N: usize> {
    /// Two vertices of a line and three of a plane; an input vertex is repeated five times.
    vertices: [[Vertex; 5]; N],
    is_meet: [bool; N],
    /// True if the line moves, and the plane; for an input vertex both are that of the vertex.
    moves: [[bool; 2]; N],
}

type Point<const A: usize> = [Fixed<A>; 3];

impl<const N: usize> Named<N> {
    /// The points; `None` if a vertex has another definition, or one with a line or a plane of both meshes.
    #[inline(always)]
    fn new(scene: &Scene, second: &[bool], args: [Vertex; N]) -> Option<Named<N>> {
        let (mut vertices, mut moves) = ([[args[0]; 5]; N], [[false; 2]; N]);
        for (at, &v) in args.iter().enumerate() {
            vertices[at] = match v.construction().map(|index| &scene.constructions()[index]) {
                None => [v; 5],
                Some(&Construction::Lpi { line, plane }) => from_common_vertex(scene, line, plane),
                Some(_) => return None,
            };
            let [p, q, a, b, c] = vertices[at].map(|v| second[v.index()]);
            if p != q || a != b || a != c {
                return None;
            }
            moves[at] = [p, a];
        }
        Some(Named { vertices, is_meet: args.map(Vertex::is_constructed), moves })
    }

    /// The coordinates of these vertices, then again those of the first one, the origin; S is 5·N + 1.
    #[inline(always)]
    fn points<const S: usize>(&self, scene: &Scene) -> [[f64; 3]; S] {
        const { assert!(S == 5 * N + 1, "five points each, and the origin") };
        let coordinates = scene.coordinates().as_chunks::<3>().0;
        let mut points = [[0.0; 3]; S];
        for (point, v) in points.iter_mut().zip(self.vertices.as_flattened()) {
            *point = coordinates[v.index()];
        }
        points[S - 1] = points[0];
        points
    }

    #[inline(always)]
    fn rows<const A: usize, const B: usize, const C: usize, const D: usize, const K: usize>(
        &self,
        points: &[Point<A>],
        axes: [usize; K],
    ) -> [Row<C, D, K>; N] {
        std::array::from_fn(|at| {
            let [p, q, a, b, c] = std::array::from_fn(|i| points[5 * at + i]);
            if self.is_meet[at] {
                Row::meet::<A, B>([p, q], [a, b, c], self.moves[at], axes)
            } else {
                Row::input(p, self.moves[at][0], axes)
            }
        })
    }
}

/// A line and a plane, from a vertex at one position if they have one: half of the products are zero then.
#[inline]
fn from_common_vertex(scene: &Scene, line: [Vertex; 2], plane: [Vertex; 3]) -> [Vertex; 5] {
    let points = scene.coordinates().as_chunks::<3>().0;
    let ([p, q], [a, b, c]) = (line, plane);
    for [p, q] in [[p, q], [q, p]] {
        for [a, b, c] in [[a, b, c], [b, c, a], [c, a, b]] {
            if points[p.index()] == points[a.index()] {
                return [p, q, a, b, c];
            }
        }
    }
    [p, q, a, b, c]
}

/// Differences to the last point in units of some power of two, and B; `None` if they take more than a limb.
#[inline(always)]
fn short<const S: usize>(points: &[[f64; 3]; S]) -> Option<([Point<1>; S], u32)> {
    let mut rows = short_rows::<3, S>(*points)?;
    let (mut any, mut size) = (0, 0);
    for x in rows.as_flattened() {
        let x = x.limbs()[0];
        any |= x;
        size |= x.cast_signed().unsigned_abs();
    }
    // The lowest bit of all of them is the unit.
    let low = any.trailing_zeros();
    for x in rows.as_flattened_mut() {
        *x = Fixed::from(x.limbs()[0].cast_signed() >> low);
    }
    Some((rows, 65 - size.leading_zeros() - low))
}

/// The largest b of the table.
const LONGEST: i32 = 124;

/// Differences to the last point in units of some power of two; `None` if they take more than two limbs.
#[inline(never)]
fn long<const S: usize>(points: &[[f64; 3]; S]) -> Option<[Point<2>; S]> {
    let range = ExponentRange::of(points.as_flattened())?;
    // Coordinates are below 2^(highest − lowest) in these units.
    if range.highest - range.lowest > LONGEST {
        return None;
    }
    let whole = |x: f64| Fixed::from(units(x, range.lowest));
    let origin = points[S - 1].map(whole);
    Some(points.map(|point| minus(point.map(whole), origin)))
}

/// A weight, and for some axes a coordinate times the weight.
///
/// Each coordinate is a constant, and derivatives by the three coordinates of δ.
struct Row<const C: usize, const D: usize, const K: usize> {
    weight: Fixed<C>,
    along: [[Fixed<D>; 4]; K],
}

impl<const C: usize, const D: usize, const K: usize> Row<C, D, K> {
    /// The row of an input vertex.
    #[inline(always)]
    fn input<const A: usize>(p: Point<A>, moves: bool, axes: [usize; K]) -> Row<C, D, K> {
        let mut along = [[Fixed::ZERO; 4]; K];
        for (along, axis) in along.iter_mut().zip(axes) {
            along[0] = p[axis].extended();
            if moves {
                along[1 + axis] = ONE.extended();
            }
        }
        Row { weight: ONE.extended(), along }
    }

    /// The row of the point where a line meets a plane.
    #[inline(always)]
    fn meet<const A: usize, const B: usize>(
        [p, q]: [Point<A>; 2],
        [a, b, c]: [Point<A>; 3],
        [line_moves, plane_moves]: [bool; 2],
        axes: [usize; K],
    ) -> Row<C, D, K> {
        let [u, v, w, way] = [minus(q, p), minus(b, a), minus(c, a), minus(a, p)];
        let minor = |i: usize, j: usize| v[i].times::<A, B>(w[j]).minus(v[j].times(w[i]));
        let normal = [minor(1, 2), minor(2, 0), minor(0, 1)];
        let dot = |x: Point<A>| -> Fixed<C> {
            let [x, y, z] = [0, 1, 2].map(|axis: usize| normal[axis].times::<A, C>(x[axis]));
            x.plus(y).plus(z)
        };
        let [weight, distance] = [dot(u), dot(way)];
        let mut along = [[Fixed::ZERO; 4]; K];
        for (along, axis) in along.iter_mut().zip(axes) {
            along[0] = weight.times::<A, D>(p[axis]).plus(distance.times(u[axis]));
            if line_moves {
                along[1 + axis] = weight.extended();
            }
            if line_moves == plane_moves || u[axis].is_zero() {
                continue;
            }
            for (derivative, normal) in along[1..].iter_mut().zip(normal) {
                let change = normal.times::<A, C>(u[axis]).extended();
                *derivative = if plane_moves { derivative.plus(change) } else { derivative.minus(change) };
            }
        }
        Row { weight, along }
    }
}

const ONE: Fixed<1> = Fixed::from_limbs([1]);

#[inline(always)]
fn minus<const A: usize>(a: Point<A>, b: Point<A>) -> Point<A> {
    [a[0].minus(b[0]), a[1].minus(b[1]), a[2].minus(b[2])]
}

/// The monomials of a turn, the largest first: their degrees in δ, and their powers of ε.
pub(super) const OF_TURN: [[usize; 2]; 9] = [[0, 0], [1, 1], [1, 2], [1, 3], [2, 2], [2, 3], [2, 4], [2, 5], [2, 6]];

/// The powers of two coordinates whose product is a monomial of a turn.
#[inline(always)]
pub(super) fn factors([degree, power]: [usize; 2]) -> impl Iterator<Item = [usize; 2]> {
    let pairs = (power.saturating_sub(3)..=power.min(3)).map(move |at| [at, power - at]);
    pairs.filter(move |pair| pair.iter().filter(|power| **power > 0).count() == degree)
}

#[inline(never)]
fn order<const C: usize, const D: usize, const G: usize>([a, b]: &[Row<C, D, 1>; 2]) -> Option<(Sign, usize)> {
    let power = |power: usize| -> Fixed<G> {
        a.along[0][power].times::<C, G>(b.weight).minus(b.along[0][power].times(a.weight))
    };
    first(0..4, power).map(|(sign, power)| (sign * sign_of(a.weight) * sign_of(b.weight), power))
}

#[inline(never)]
fn turn<const C: usize, const D: usize, const E: usize, const F: usize>(
    rows: &[Row<C, D, 2>; 3],
) -> Option<(Sign, usize)> {
    let coefficient = |monomial: [usize; 2]| -> Fixed<F> {
        let mut sum = Fixed::ZERO;
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            let ([x, y], [z, w]) = (&rows[i].along, &rows[j].along);
            let mut minor: Fixed<E> = Fixed::ZERO;
            for [at, other] in factors(monomial) {
                if !x[at].is_zero() && !w[other].is_zero() {
                    minor = minor.plus(x[at].times::<D, E>(w[other]));
                }
                if !y[at].is_zero() && !z[other].is_zero() {
                    minor = minor.minus(y[at].times::<D, E>(z[other]));
                }
            }
            sum = sum.plus(minor.times::<C, F>(rows[k].weight));
        }
        sum
    };
    let weights = rows.iter().fold(Sign::Positive, |sign, row| sign * sign_of(row.weight));
    first(OF_TURN, coefficient).map(|(sign, [_, power])| (sign * weights, power))
}

/// The sign of the first nonzero coefficient, and its monomial.
#[inline(always)]
fn first<M: Copy, const L: usize>(
    monomials: impl IntoIterator<Item = M>,
    coefficient: impl Fn(M) -> Fixed<L>,
) -> Option<(Sign, M)> {
    monomials.into_iter().find_map(|monomial| {
        let coefficient = coefficient(monomial);
        (!coefficient.is_zero()).then(|| (sign_of(coefficient), monomial))
    })
}

/// The sign of a nonzero number.
#[inline(always)]
fn sign_of<const L: usize>(x: Fixed<L>) -> Sign {
    if x.is_negative() { Sign::Negative } else { Sign::Positive }
}

#[cfg(test)]
mod tests;
