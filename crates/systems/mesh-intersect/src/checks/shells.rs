//! Components and Euler characteristics of the results of other programs, after closing what is thinner than a
//! distance.
//!
//! * `components of the union`: a part of one solid and a part of the other are in one part of the union if they meet.
//!   The union has as many parts as there are classes of parts of the operands.
//! * `Euler characteristics`: those of union and intersection add up to those of both operands, as for all closed sets:
//!   a point of both operands is counted twice on both sides.
//!
//! Both are laws of sets, so they need no overlay. They are about results that are rounded only if rounding cannot
//! change the answer: no vertex of an operand is near a surface that it does not belong to, and no two edges of
//! different operands are near each other. Then the closest points of two triangles that do not meet are not near
//! either, because these are at a vertex or on two edges. Otherwise, and if an operand has a cavity, the
//! laws say nothing ([`Wanted::of`] is `None`).
//!
//! Results are compared [after closing](predicament_judge::skin::shells) what is thinner than twice their distance δ.

use predicament_judge::boxes::{Boxes, extent};
use predicament_judge::skin::shells::{Groups, Shell, Shells};
use predicament_judge::skin::{Corners, Skin};

/// The check of components.
pub const COMPONENTS: &str = "components of the union";
/// The check of Euler characteristics.
pub const EULER: &str = "Euler characteristics";

/// A margin is this many times the distance of a result.
const MARGIN: f64 = 64.0;

/// The numbers that a union and an intersection must have.
pub struct Wanted {
    /// The number of parts of the union.
    pub components: usize,
    /// The sum of the Euler characteristics of the surfaces of union and intersection.
    pub euler: i64,
}

impl Wanted {
    /// The numbers for two operands; `None` if rounding by a distance can change them, or an operand has a cavity.
    #[must_use]
    pub fn of(operands: [&Skin; 2], within: f64) -> Option<Wanted> {
        let margin = MARGIN * within;
        let [first, second] = operands;
        let is_apart = is_clear(first, margin) && is_clear(second, margin) && are_clear(first, second, margin);
        if !is_apart {
            return None;
        }
        let shells = operands.map(|skin| Shells::of(skin.triangles(), 0.0));
        if shells.iter().flat_map(Shells::thick).any(|shell| shell.volume < 0.0) {
            return None;
        }
        let counts = shells.each_ref().map(|shells| shells.thick().count());
        let mut group = Groups::new(counts[0] + counts[1]);
        let skin = |shell: &Shell| Skin::new(shell.corners.clone());
        let skins = shells.each_ref().map(|shells| shells.thick().map(skin).collect::<Vec<Skin>>());
        for (i, one) in skins[0].iter().enumerate() {
            for (j, other) in skins[1].iter().enumerate() {
                if meet(one, other) || is_in(one, other)? || is_in(other, one)? {
                    group.join(i, counts[0] + j);
                }
            }
        }
        let mut parts: Vec<usize> = (0..counts[0] + counts[1]).map(|at| group.of(at)).collect();
        parts.sort_unstable();
        parts.dedup();
        Some(Wanted { components: parts.len(), euler: shells.iter().map(Shells::euler).sum() })
    }
}

/// True if an edge of one surface passes through a triangle of the other.
fn meet(one: &Skin, other: &Skin) -> bool {
    let both: Vec<Corners> = one.triangles().iter().chain(other.triangles()).copied().collect();
    let count = both.len();
    Skin::new(both).pierced(0.0, count).is_some()
}

/// True if the first vertex of a surface is inside of another one; `None` if this cannot be decided.
fn is_in(one: &Skin, other: &Skin) -> Option<bool> {
    one.triangles().as_flattened().iter().find_map(|&p| other.winding(p)).map(|winding| winding > 0)
}

/// True if no vertex is near a triangle of its own surface that it is not a corner of.
fn is_clear(skin: &Skin, margin: f64) -> bool {
    let triangles = skin.triangles();
    let index = Boxes::new(triangles.iter().map(|&corners| extent(corners)).collect());
    let mut near = Vec::new();
    vertices(triangles).into_iter().all(|p| {
        index.near(&[p, p], margin, &mut near);
        near.iter()
            .map(|&at| triangles[at as usize])
            .all(|corners| corners.contains(&p) || Skin::new(vec![corners]).distance(p, margin) > margin)
    })
}

/// True if no vertex of one surface is near the other, and no edges of both are near each other.
fn are_clear(one: &Skin, other: &Skin, margin: f64) -> bool {
    let is_far = |of: &Skin, from: &Skin| {
        vertices(of.triangles()).into_iter().all(|p| !from.is_near(p, margin) || from.distance(p, margin) > margin)
    };
    if !is_far(one, other) || !is_far(other, one) {
        return false;
    }
    let edges = [one, other].map(|skin| edges(skin.triangles()));
    let index = Boxes::new(edges[1].iter().map(|&ends| extent(ends)).collect());
    let mut near = Vec::new();
    edges[0].iter().all(|&ends| {
        index.near(&extent(ends), margin, &mut near);
        near.iter().all(|&at| gap(ends, edges[1][at as usize]) > margin)
    })
}

fn vertices(triangles: &[Corners]) -> Vec<[f64; 3]> {
    let mut all: Vec<[f64; 3]> = triangles.as_flattened().to_vec();
    all.sort_by(|p, q| p.partial_cmp(q).unwrap_or(std::cmp::Ordering::Equal));
    all.dedup();
    all
}

fn edges(triangles: &[Corners]) -> Vec<[[f64; 3]; 2]> {
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut all: Vec<[[f64; 3]; 2]> = sides.map(|[p, q]| if p < q { [p, q] } else { [q, p] }).collect();
    all.sort_by(|p, q| p.partial_cmp(q).unwrap_or(std::cmp::Ordering::Equal));
    all.dedup();
    all
}

/// The distance of two segments whose ends are not near each other's lines, approximately: far more than its error, or
/// at the inner points of both.
fn gap([a, b]: [[f64; 3]; 2], [c, d]: [[f64; 3]; 2]) -> f64 {
    let less = |p: [f64; 3], q: [f64; 3]| [0, 1, 2].map(|i: usize| p[i] - q[i]);
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let (u, v, w) = (less(b, a), less(d, c), less(a, c));
    let (uu, uv, vv, uw, vw) = (dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w));
    let determinant = uu * vv - uv * uv;
    let s = if determinant > 0.0 { ((uv * vw - vv * uw) / determinant).clamp(0.0, 1.0) } else { 0.0 };
    let t = ((uv * s + vw) / vv).clamp(0.0, 1.0);
    let s = ((uv * t - uw) / uu).clamp(0.0, 1.0);
    let off = [0, 1, 2].map(|i: usize| w[i] + s * u[i] - t * v[i]);
    dot(off, off).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box from one corner to the other, with its triangles turned outwards.
    fn solid(low: [f64; 3], high: [f64; 3]) -> Vec<Corners> {
        let corner =
            |bits: usize| [0, 1, 2].map(|axis: usize| if bits >> axis & 1 == 1 { high[axis] } else { low[axis] });
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]].map(|t| t.map(corner))).collect()
    }

    fn wanted(one: Vec<Corners>, other: Vec<Corners>) -> Option<(usize, i64)> {
        let wanted = Wanted::of([&Skin::new(one), &Skin::new(other)], 1e-12);
        wanted.map(|wanted| (wanted.components, wanted.euler))
    }

    #[test]
    fn parts_that_meet_are_one_part_of_the_union() {
        let cube = || solid([0.0; 3], [4.0; 3]);
        assert_eq!(wanted(cube(), solid([1.0, 1.5, 1.25], [6.0, 7.0, 8.0])), Some((1, 4)), "they cross");
        assert_eq!(
            wanted(cube(), solid([1.0, 1.5, 1.25], [2.0, 3.0, 2.5])),
            Some((1, 4)),
            "one is inside of the other"
        );
        assert_eq!(wanted(cube(), solid([5.0, 1.5, 1.25], [6.0, 7.0, 8.0])), Some((2, 4)), "apart");
        let two = [solid([1.0, 1.5, 1.25], [6.0, 3.0, 2.0]), solid([7.0; 3], [8.0; 3])].concat();
        assert_eq!(wanted(cube(), two), Some((2, 6)), "one of two parts");
        assert_eq!(wanted(cube(), solid([4.0, 1.0, 1.0], [6.0, 3.0, 2.0])), None, "they touch");
        assert_eq!(wanted(cube(), solid([1.0, 1.0, 1.0], [6.0, 3.0, 4.0 + 1e-13])), None, "nearly");
    }
}
