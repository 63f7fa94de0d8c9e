//! Questions about points of lines and planes of one mesh each, in integers of a fixed size.
//!
//! Where the line through p with direction u meets the plane with normal n through a, the point is p + u·N/w with N = n·(a − p) and
//! w = n·u. As the second mesh moves by δ, it moves by m·δ + s·u·(n·δ)/w, with m = 1 where the line moves and 0 where not, and s the same
//! of the plane, less m. Nothing here is quadratic, so with δ = (ε, ε², ε³) a coordinate times w is the constant w·p + N·u, and three
//! derivatives. A question is a polynomial in ε: of two coordinates with the powers up to 3, of a turn with those up to 6. The first
//! coefficient that is not zero decides.
//!
//! # How many limbs
//! Coordinates are taken from a vertex of the question, in units of a power of two. With these below 2^b and B = b + 1, in magnitude:
//!
//! | what | below |
//! |---|---|
//! | a difference, as u | 2^B |
//! | n | 2^(2B + 1) |
//! | w, N | 2^(3B + 3) |
//! | a derivative: w, and u·n | 2^(3B + 4) |
//! | a coordinate times w | 2^(4B + 4) |
//! | a coordinate times the other's weight, less the same exchanged | 2^(7B + 8) |
//! | a minor of two rows: eight products at most of two coordinates times w | 2^(8B + 11) |
//! | three of these, times a weight | 2^(11B + 16) |
//!
//! With b = 61 that takes 1, 2, 3, 3, 4, 7, 8 and 11 limbs. All of it takes one limb where B is up to 7 in a comparison, up to 4 in
//! a turn; two limbs up to 17 and up to 10.

use predicament_arithmetic::{Fixed, short_rows};
use predicament_predicates::{Axis, Construction, Plane, Scene, Sign, Vertex};

/// The sign and the power of ε that decides, 0 where none has to move; none where it is zero however far the second mesh moves.
/// The outer none stands for other ways to find it.
pub(crate) type Decided = Option<Option<(Sign, usize)>>;

/// The order of two points along an axis.
///
/// # Panics
/// If the scene lacks a vertex.
pub(crate) fn compare(scene: &Scene, second: &[bool], axis: Axis, args: [Vertex; 2]) -> Decided {
    let given = Given::<2>::new::<11>(scene, second, args)?;
    let axes = [axis.index()];
    Some(match given.bits {
        0..=7 => order::<1, 1, 1>(&given.rows::<1, 1, 1, 1>(axes)),
        8..=17 => order::<2, 2, 2>(&given.rows::<2, 2, 2, 1>(axes)),
        _ => order::<3, 4, 7>(&given.rows::<2, 3, 4, 1>(axes)),
    })
}

/// The turn of three points in a coordinate plane.
///
/// # Panics
/// If the scene lacks a vertex.
pub(crate) fn orient2d(scene: &Scene, second: &[bool], plane: Plane, args: [Vertex; 3]) -> Decided {
    let given = Given::<3>::new::<16>(scene, second, args)?;
    let axes = plane.axes().map(Axis::index);
    Some(match given.bits {
        0..=4 => turn::<1, 1, 1, 1>(&given.rows::<1, 1, 1, 2>(axes)),
        5..=10 => turn::<2, 2, 2, 2>(&given.rows::<2, 2, 2, 2>(axes)),
        _ => turn::<3, 4, 8, 11>(&given.rows::<2, 3, 4, 2>(axes)),
    })
}

type Point = [Fixed<1>; 3];

/// The points of a question, by what defines them.
struct Given<const N: usize> {
    defined: [Defined; N],
    /// So many bits have differences of coordinates at most: the B above.
    bits: u32,
}

/// What defines a point.
#[derive(Clone, Copy)]
struct Defined {
    /// Two points of a line and three of a plane; five times the point itself if it is an input vertex.
    points: [Point; 5],
    is_meet: bool,
    /// Whether the line moves, and the plane; an input vertex itself for both.
    moves: [bool; 2],
}

impl<const N: usize> Given<N> {
    /// None where a vertex has another definition, or one with vertices of both meshes, and where coordinates take more bits. S is 5·N + 1.
    #[inline(always)]
    fn new<const S: usize>(scene: &Scene, second: &[bool], args: [Vertex; N]) -> Option<Given<N>> {
        const { assert!(S == 5 * N + 1, "five points each, and the origin") };
        let mut sources = [[args[0]; 5]; N];
        let mut moves = [[false; 2]; N];
        for (at, &v) in args.iter().enumerate() {
            sources[at] = match v.construction().map(|index| &scene.constructions()[index]) {
                None => [v; 5],
                Some(&Construction::Lpi { line: [p, q], plane: [a, b, c] }) => [p, q, a, b, c],
                Some(_) => return None,
            };
            let [p, q, a, b, c] = sources[at].map(|v| second[v.index()]);
            if p != q || a != b || a != c {
                return None;
            }
            moves[at] = [p, a];
        }
        let coordinates = scene.coordinates().as_chunks::<3>().0;
        let mut points = [[0.0; 3]; S];
        for (point, v) in points.iter_mut().zip(sources.as_flattened()) {
            *point = coordinates[v.index()];
        }
        points[S - 1] = points[0];
        let rows = short_rows::<3, S>(points)?;
        let (mut any, mut size) = (0, 0);
        for row in &rows[..S - 1] {
            for x in row {
                let x = x.limbs()[0];
                any |= x;
                size |= x.cast_signed().unsigned_abs();
            }
        }
        // The lowest bit that any of them has is the unit.
        let low = any.trailing_zeros();
        let shifted = |x: Fixed<1>| Fixed::from(x.limbs()[0].cast_signed() >> low);
        let defined = std::array::from_fn(|at| Defined {
            points: std::array::from_fn(|i| rows[5 * at + i].map(shifted)),
            is_meet: args[at].is_constructed(),
            moves: moves[at],
        });
        Some(Given { defined, bits: 65 - size.leading_zeros() - low })
    }

    #[inline(always)]
    fn rows<const B: usize, const C: usize, const D: usize, const K: usize>(
        &self,
        axes: [usize; K],
    ) -> [Row<C, D, K>; N] {
        std::array::from_fn(|at| self.defined[at].row::<B, C, D, K>(axes))
    }
}

/// A weight, and for some axes a coordinate times it: a constant, and derivatives by the three coordinates of δ.
struct Row<const C: usize, const D: usize, const K: usize> {
    weight: Fixed<C>,
    along: [[Fixed<D>; 4]; K],
}

impl Defined {
    #[inline(always)]
    fn row<const B: usize, const C: usize, const D: usize, const K: usize>(&self, axes: [usize; K]) -> Row<C, D, K> {
        let [p, q, a, b, c] = self.points;
        let mut along = [[Fixed::ZERO; 4]; K];
        let [line_moves, plane_moves] = self.moves;
        if !self.is_meet {
            for (k, axis) in axes.into_iter().enumerate() {
                along[k][0] = p[axis].extended();
                if line_moves {
                    along[k][1 + axis] = ONE.extended();
                }
            }
            return Row { weight: ONE.extended(), along };
        }
        let [u, v, w, way] = [minus(q, p), minus(b, a), minus(c, a), minus(a, p)];
        let normal: [Fixed<B>; 3] =
            [(1, 2), (2, 0), (0, 1)].map(|(i, j): (usize, usize)| v[i].times::<1, B>(w[j]).minus(v[j].times(w[i])));
        let dot = |x: Point| -> Fixed<C> {
            let [x, y, z] = [0, 1, 2].map(|axis: usize| normal[axis].times::<1, C>(x[axis]));
            x.plus(y).plus(z)
        };
        let [weight, distance] = [dot(u), dot(way)];
        for (k, axis) in axes.into_iter().enumerate() {
            along[k][0] = weight.times::<1, D>(p[axis]).plus(distance.times::<1, D>(u[axis]));
            if line_moves {
                along[k][1 + axis] = weight.extended();
            }
            if line_moves != plane_moves && !u[axis].is_zero() {
                for (derivative, normal) in along[k][1..].iter_mut().zip(normal) {
                    let change = normal.times::<1, C>(u[axis]).extended();
                    *derivative = if plane_moves { derivative.plus(change) } else { derivative.minus(change) };
                }
            }
        }
        Row { weight, along }
    }
}

const ONE: Fixed<1> = Fixed::from_limbs([1]);

#[inline(always)]
fn minus(a: Point, b: Point) -> Point {
    [a[0].minus(b[0]), a[1].minus(b[1]), a[2].minus(b[2])]
}

#[inline(never)]
fn order<const C: usize, const D: usize, const G: usize>([a, b]: &[Row<C, D, 1>; 2]) -> Option<(Sign, usize)> {
    let power = |power: usize| -> Fixed<G> {
        a.along[0][power].times::<C, G>(b.weight).minus(b.along[0][power].times(a.weight))
    };
    first(4, power).map(|(sign, power)| (sign * sign_of(a.weight) * sign_of(b.weight), power))
}

#[inline(never)]
fn turn<const C: usize, const D: usize, const E: usize, const F: usize>(
    rows: &[Row<C, D, 2>; 3],
) -> Option<(Sign, usize)> {
    let power = |power: usize| -> Fixed<F> {
        let mut sum = Fixed::ZERO;
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            let ([x, y], [z, w]) = (&rows[i].along, &rows[j].along);
            let mut minor: Fixed<E> = Fixed::ZERO;
            for at in power.saturating_sub(3)..=power.min(3) {
                let other = power - at;
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
    first(7, power).map(|(sign, power)| (sign * weights, power))
}

/// The first of so many coefficients that is not zero.
#[inline(always)]
fn first<const L: usize>(count: usize, coefficient: impl Fn(usize) -> Fixed<L>) -> Option<(Sign, usize)> {
    (0..count).find_map(|power| {
        let coefficient = coefficient(power);
        (!coefficient.is_zero()).then(|| (sign_of(coefficient), power))
    })
}

/// The sign of a number that is not zero.
#[inline(always)]
fn sign_of<const L: usize>(x: Fixed<L>) -> Sign {
    if x.is_negative() { Sign::Negative } else { Sign::Positive }
}
