//! Crossings of triangles by circuits.
//!
//! A *circuit* is a smallest set of points that are affinely dependent: the coefficients of its dependency are unique
//! up to a factor, and none is zero. The points with positive coefficients and those with negative coefficients are
//! two simplices whose insides have exactly one common point (Radon). Two simplices have only their common face in
//! common if and only if there is no circuit with its positive points among the vertices of one and its negative
//! points among those of the other (De Loera, Rambau and Santos, Triangulations, 2010, section 4.1). So a small list
//! of signs decides all ways to cross and to touch, degenerate or not: two points at one place, three on a line, four
//! in a plane, five in space.

use predicament_predicates::{Axis, Plane, Sign, Vertex};

use super::Signs;

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];
const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

/// True if three vertices are on one line.
#[must_use]
pub fn is_flat(signs: &Signs<'_>, corners: [Vertex; 3]) -> bool {
    PLANES.into_iter().all(|plane| signs.orient2d(plane, corners).is_zero())
}

/// True if two triangles have more in common than their common vertices, or edge.
#[must_use]
pub fn meet(signs: &Signs<'_>, t: [Vertex; 3], u: [Vertex; 3]) -> bool {
    if t.iter().all(|v| u.contains(v)) {
        return true;
    }
    if are_apart(signs, t, u) {
        return false;
    }
    let parts = |corners: [Vertex; 3]| {
        (1..8_u32).map(move |mask| {
            let part = corners.into_iter().enumerate().filter(move |(at, _)| mask >> at & 1 == 1);
            part.map(|(_, v)| v).collect::<Vec<Vertex>>()
        })
    };
    parts(t).any(|s| {
        parts(u).any(|r| s.len() + r.len() <= 5 && !s.iter().any(|v| r.contains(v)) && is_circuit(signs, &s, &r))
    })
}

/// True if the boxes of two triangles are apart. An infinitesimal movement keeps them so.
fn are_apart(signs: &Signs<'_>, t: [Vertex; 3], u: [Vertex; 3]) -> bool {
    AXES.into_iter().any(|axis| {
        let [[low, high], [other_low, other_high]] = [t, u].map(|corners| {
            let along = corners.map(|v| signs.scene().coordinate(axis, v));
            along.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        });
        high < other_low || other_high < low
    })
}

/// True if these vertices are a circuit, with the first part positive and the second part negative, or the reverse.
fn is_circuit(signs: &Signs<'_>, first: &[Vertex], second: &[Vertex]) -> bool {
    let all = [first, second].concat();
    // The coefficient of each point is the determinant of the others, with alternating signs.
    let is_split = |determinants: &[Sign]| {
        let mut wanted = None;
        determinants.iter().enumerate().all(|(at, &sign)| {
            let is_negated = (at % 2 == 1) != (at >= first.len());
            let sign = if is_negated { -sign } else { sign };
            !sign.is_zero() && *wanted.get_or_insert(sign) == sign
        })
    };
    match all[..] {
        [a, b, c, d, e] => is_split(
            &[[b, c, d, e], [a, c, d, e], [a, b, d, e], [a, b, c, e], [a, b, c, d]].map(|rest| signs.orient3d(rest)),
        ),
        [a, b, c, d] => {
            let minors = |plane| [[b, c, d], [a, c, d], [a, b, d], [a, b, c]].map(|rest| signs.orient2d(plane, rest));
            signs.orient3d([a, b, c, d]).is_zero() && split_somewhere(PLANES.map(minors), is_split)
        }
        [a, b, c] => {
            let minors = |axis| [[b, c], [a, c], [a, b]].map(|rest| signs.compare(axis, rest));
            is_flat(signs, [a, b, c]) && split_somewhere(AXES.map(minors), is_split)
        }
        [a, b] => AXES.into_iter().all(|axis| signs.compare(axis, [a, b]).is_zero()),
        _ => false,
    }
}

/// The test of the coefficients in the first projection in which they are not all zero.
fn split_somewhere<const N: usize>(minors: [[Sign; N]; 3], is_split: impl Fn(&[Sign]) -> bool) -> bool {
    let seen = minors.into_iter().find(|all| all.iter().any(|sign| !sign.is_zero()));
    seen.is_some_and(|all| is_split(&all))
}
