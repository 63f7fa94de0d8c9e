//! Turns of points that are at input vertices before the second mesh moves, in floating point.
//!
//! A mesh that is overlaid with itself has only such points: an edge and a triangle of one surface touch where they
//! have a vertex in common. Let a line with direction u and a plane with normal n pass through a vertex P. As the
//! second mesh moves by δ, their common point moves to P + m·δ + s·u·(n·δ)/w, with w = n·u, and m and s as in
//! [`super::fixed`].
//! Each coordinate is linear in δ with the input's constant, and a turn of three such points has degree 2.
//!
//! The constant of the turn is the turn of input vertices, which is exact. The other coefficients are computed in
//! doubles with a bound on their errors. The first one that is not zero decides, if its sign is certain and all before
//! it are certainly zero: these are sums of terms with a factor that is exactly zero. Integers ([`super::fixed`]) take
//! ten times as long; they decide the rest.

use predicament_exact::Session;
use predicament_predicates::{Construction, Dimension, Off, Plane, Predicates, Scene, Sign, Vertex};

use super::fixed::{OF_TURN, factors};

/// The turn of three points, and the deciding power of ε, 0 if no move is needed.
///
/// `None`: a vertex is not at an input vertex, a rounding error could decide, or no power does.
///
/// # Panics
/// If the scene lacks a vertex.
pub(crate) fn orient2d(
    exact: &Session<'_, Off>,
    second: &[bool],
    plane: Plane,
    args: [Vertex; 3],
) -> Option<(Sign, usize)> {
    let scene = exact.scene();
    if scene.dimension() == Dimension::Two {
        return None;
    }
    let [a, b, c] = args.map(|v| Corner::of(scene, second, v));
    let [a, b, c] = [a?, b?, c?];
    let (sign, _) = exact.decide_orient2d(plane, a.at, b.at, c.at);
    if !sign.is_zero() {
        return Some((sign, 0));
    }
    // The first two are at one vertex if any two are: equal coefficients then cancel before they are multiplied.
    let (mut args, mut turned) = ([a, b, c], 0);
    while args[0].position != args[1].position && turned < 2 {
        args.rotate_left(1);
        turned += 1;
    }
    let [a, b, c] = args;
    let axes = plane.axes().map(|axis| axis.index());
    let [p, q, r] = [a.moved(exact, axes)?, b.moved(exact, axes)?, c.moved(exact, axes)?];
    let [[x, y], [z, w]] = [less(&q, &p), less(&r, &p)];
    for &monomial in &OF_TURN[1..] {
        let mut sum = Near::ZERO;
        for [at, other] in factors(monomial) {
            sum = sum.plus(x[at].times(w[other])).minus(y[at].times(z[other]));
        }
        if !sum.is_zero() {
            return Some((sum.sign()?, monomial[1]));
        }
    }
    None
}

/// A vertex that is at an input vertex before the second mesh moves.
struct Corner {
    /// The input vertex.
    at: Vertex,
    position: [f64; 3],
    moves: bool,
    /// The line and the plane, if only one of them moves.
    meet: Option<Meet>,
}

struct Meet {
    /// The other point of the line, and the two others of the plane.
    others: [[f64; 3]; 3],
    /// The three points of the plane.
    corners: [Vertex; 3],
    plane_moves: bool,
}

impl Corner {
    #[inline]
    fn of(scene: &Scene, second: &[bool], v: Vertex) -> Option<Corner> {
        let points = scene.coordinates().as_chunks::<3>().0;
        let place = |v: Vertex| points[v.index()];
        let Some(index) = v.construction() else {
            return Some(Corner { at: v, position: place(v), moves: second[v.index()], meet: None });
        };
        let Construction::Lpi { line, plane } = scene.constructions()[index] else { return None };
        let [ends, corners] = [line.map(place), [place(plane[0]), place(plane[1])]];
        let corners = [corners[0], corners[1], place(plane[2])];
        for (end, position) in ends.into_iter().enumerate() {
            for (corner, other) in corners.into_iter().enumerate() {
                if position == other {
                    let [p, q] = line.map(|v| second[v.index()]);
                    let [a, b, c] = plane.map(|v| second[v.index()]);
                    if p != q || a != b || a != c {
                        return None;
                    }
                    let others = [ends[1 - end], corners[(corner + 1) % 3], corners[(corner + 2) % 3]];
                    let meet = (p != a).then_some(Meet { others, corners: plane, plane_moves: a });
                    return Some(Corner { at: line[end], position, moves: p, meet });
                }
            }
        }
        None
    }

    /// Two coordinates with their derivatives by δ; `None` if the line could be in the plane for all that doubles tell.
    #[inline]
    fn moved(&self, exact: &Session<'_, Off>, axes: [usize; 2]) -> Option<[[Near; 4]; 2]> {
        let mut along = [[Near::ZERO; 4]; 2];
        for (along, axis) in along.iter_mut().zip(axes) {
            along[0] = Near::exact(self.position[axis]);
            along[1 + axis] = if self.moves { Near::exact(1.0) } else { Near::ZERO };
        }
        let Some(Meet { others, corners, plane_moves }) = self.meet else { return Some(along) };
        let [u, v, w] = others.map(|other| {
            std::array::from_fn::<_, 3, _>(|i| Near::exact(other[i]).minus(Near::exact(self.position[i])))
        });
        // A component of the normal that could be zero often is: a silhouette of a surface that was made by a program.
        let minor = |i: usize, j: usize, plane: Plane| {
            let minor = v[i].times(w[j]).minus(v[j].times(w[i]));
            let is_zero = || exact.decide_orient2d(plane, corners[0], corners[1], corners[2]).0.is_zero();
            if minor.sign().is_none() && is_zero() { Near::ZERO } else { minor }
        };
        let normal = [minor(1, 2, Plane::Yz), minor(2, 0, Plane::Zx), minor(0, 1, Plane::Xy)];
        let terms: [Near; 3] = std::array::from_fn(|axis| normal[axis].times(u[axis]));
        let weight = terms[0].plus(terms[1]).plus(terms[2]);
        let inverse = weight.inverse()?;
        for (along, axis) in along.iter_mut().zip(axes) {
            let slope = u[axis].times(inverse);
            for (by, (along, normal)) in along[1..].iter_mut().zip(normal).enumerate() {
                // Of a line or a plane along an axis, the weight is this product alone.
                let is_whole = by == axis && terms[(axis + 1) % 3].is_zero() && terms[(axis + 2) % 3].is_zero();
                let change = if is_whole { Near::exact(1.0) } else { slope.times(normal) };
                *along = if plane_moves { along.plus(change) } else { along.minus(change) };
            }
        }
        Some(along)
    }
}

/// The difference of two points, coefficient by coefficient.
#[inline]
fn less(a: &[[Near; 4]; 2], b: &[[Near; 4]; 2]) -> [[Near; 4]; 2] {
    std::array::from_fn(|axis| std::array::from_fn(|power| a[axis][power].minus(b[axis][power])))
}

/// A number near a real one.
///
/// The distance is at most `error`, which is infinite or NaN if nothing is known. A value and an error of zero are a
/// real zero.
#[derive(Clone, Copy, Debug)]
struct Near {
    value: f64,
    error: f64,
}

/// The rounding unit u of doubles, 2^-53.
const U: f64 = f64::EPSILON / 2.0;
/// A factor for the roundings of an error bound itself: at most six in a row, (1 − u)^6 (1 + 8 u) > 1.
const ROUNDED: f64 = 1.0 + 8.0 * U;
/// The least magnitude of a product for which u bounds its relative error, with room: neither it nor its error is
/// subnormal.
const LEAST: f64 = 1e-280;

impl Near {
    const ZERO: Near = Near { value: 0.0, error: 0.0 };

    #[inline(always)]
    fn exact(value: f64) -> Near {
        Near { value, error: 0.0 }
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        (self.value == 0.0) & (self.error == 0.0)
    }

    /// The sign of the real number, if it is certain.
    #[inline(always)]
    fn sign(self) -> Option<Sign> {
        (self.value.abs() > self.error).then_some(if self.value > 0.0 { Sign::Positive } else { Sign::Negative })
    }

    /// The sum: doubles that cancel make no error, nor do subnormal numbers.
    #[inline(always)]
    fn plus(self, other: Near) -> Near {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        let value = self.value + other.value;
        Near { value, error: (self.error + other.error + value.abs() * U) * ROUNDED }
    }

    #[inline(always)]
    fn minus(self, other: Near) -> Near {
        self.plus(Near { value: -other.value, error: other.error })
    }

    #[inline(always)]
    fn times(self, other: Near) -> Near {
        if self.is_zero() | other.is_zero() {
            return Near::ZERO;
        }
        let value = self.value * other.value;
        if value.abs() < LEAST {
            return Near { value, error: f64::INFINITY };
        }
        let error = self.error * (other.value.abs() + other.error) + self.value.abs() * other.error + value.abs() * U;
        Near { value, error: error * ROUNDED }
    }

    /// The inverse; `None` if the real number could be zero, or the inverse near the ends of the range of doubles.
    #[inline(always)]
    fn inverse(self) -> Option<Near> {
        let size = self.value.abs();
        let value = 1.0 / self.value;
        // |1/x − 1/v| = |x − v| / (|x| |v|), and |x| is at least |v| less the error.
        let error = self.error / (size - self.error) * value.abs();
        let is_certain = (size > 2.0 * self.error) & (size > LEAST) & (value.abs() > LEAST);
        is_certain.then_some(Near { value, error: (error + value.abs() * U) * ROUNDED })
    }
}

#[cfg(test)]
mod tests;
