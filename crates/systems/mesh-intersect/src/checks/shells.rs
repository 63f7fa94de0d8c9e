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
//! # Closing
//! A program's mesh may have vertices that are one in truth, and sheets without a volume between them. Vertices of a
//! result that are within twice its distance δ of each other are one vertex here; triangles with a vertex twice, and
//! pairs of opposite triangles, are left out; and a shell whose volume is at most that of a layer of thickness 2δ on
//! its surface does not count.

use std::collections::BTreeMap;

use predicament_judge::boxes::{Boxes, extent};
use predicament_judge::skin::{Corners, Skin, area};

/// The check of components.
pub const COMPONENTS: &str = "components of the union";
/// The check of Euler characteristics.
pub const EULER: &str = "Euler characteristics";

/// A margin is this many times the distance of a result.
const MARGIN: f64 = 64.0;

/// A connected part of a surface.
struct Shell {
    corners: Vec<Corners>,
    /// The vertices less the edges, plus the triangles.
    euler: i64,
    volume: f64,
}

/// The parts of a surface.
pub struct Shells(Vec<Shell>);

impl Shells {
    /// The parts of a surface that are not thin, with vertices within a distance of each other as one.
    #[must_use]
    pub fn of(triangles: &[Corners], near: f64) -> Shells {
        let (vertices, mut triangles) = joined(triangles, near);
        cancel(&mut triangles);
        let mut group = Groups::new(vertices.len());
        triangles.iter().for_each(|&[a, b, c]| {
            group.join(a, b);
            group.join(b, c);
        });
        let mut all: BTreeMap<usize, Vec<[usize; 3]>> = BTreeMap::new();
        for triangle in triangles {
            all.entry(group.of(triangle[0])).or_default().push(triangle);
        }
        let shells = all.into_values().map(|triangles| {
            let mut edges: Vec<[usize; 2]> = triangles
                .iter()
                .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
                .map(|[p, q]| [p.min(q), p.max(q)])
                .collect();
            edges.sort_unstable();
            edges.dedup();
            let mut used: Vec<usize> = triangles.as_flattened().to_vec();
            used.sort_unstable();
            used.dedup();
            let count = |length: usize| i64::try_from(length).unwrap_or(i64::MAX);
            let euler = count(used.len()) - count(edges.len()) + count(triangles.len());
            let corners: Vec<Corners> = triangles.iter().map(|triangle| triangle.map(|v| vertices[v])).collect();
            let volume = Skin::new(corners.clone()).six().to_f64() / 6.0;
            Shell { corners, euler, volume }
        });
        let is_thick = |shell: &Shell| shell.volume.abs() > near * shell.corners.iter().map(area).sum::<f64>();
        Shells(shells.filter(is_thick).collect())
    }

    /// The sum of the Euler characteristics of all parts.
    #[must_use]
    pub fn euler(&self) -> i64 {
        self.0.iter().map(|shell| shell.euler).sum()
    }

    /// The number of parts of the solid: those of the surface that are not around a cavity.
    #[must_use]
    pub fn solids(&self) -> usize {
        self.0.iter().filter(|shell| shell.volume > 0.0).count()
    }
}

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
        if shells.iter().flat_map(|shells| &shells.0).any(|shell| shell.volume < 0.0) {
            return None;
        }
        let counts = shells.each_ref().map(|shells| shells.0.len());
        let mut group = Groups::new(counts[0] + counts[1]);
        let skin = |shell: &Shell| Skin::new(shell.corners.clone());
        let skins = shells.each_ref().map(|shells| shells.0.iter().map(skin).collect::<Vec<Skin>>());
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

/// Vertices that are not near each other, and the triangles by these.
fn joined(triangles: &[Corners], near: f64) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let mut places: Vec<[f64; 3]> = triangles.as_flattened().iter().map(|p| p.map(|x| x + 0.0)).collect();
    places.sort_by(|p, q| p.partial_cmp(q).unwrap_or(std::cmp::Ordering::Equal));
    places.dedup();
    let mut group = Groups::new(places.len());
    if near > 0.0 {
        let index = Boxes::new(places.iter().map(|&p| [p, p]).collect());
        let mut found = Vec::new();
        for (at, p) in places.iter().enumerate() {
            index.near(&[*p, *p], near, &mut found);
            found.iter().for_each(|&other| group.join(at, other as usize));
        }
    }
    let place = |p: &[f64; 3]| {
        let p = p.map(|x| x + 0.0);
        places.binary_search_by(|q| q.partial_cmp(&p).unwrap_or(std::cmp::Ordering::Equal)).unwrap_or(0)
    };
    let all: Vec<[usize; 3]> =
        triangles.iter().map(|corners| [0, 1, 2].map(|at: usize| group.of(place(&corners[at])))).collect();
    (places, all)
}

/// Removes triangles with a vertex twice, and pairs of opposite triangles.
fn cancel(triangles: &mut Vec<[usize; 3]>) {
    triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    let mut uses: BTreeMap<[usize; 3], i64> = BTreeMap::new();
    for &[a, b, c] in triangles.iter() {
        let mut sorted = [a, b, c];
        sorted.sort_unstable();
        let is_even =
            [sorted, [sorted[1], sorted[2], sorted[0]], [sorted[2], sorted[0], sorted[1]]].contains(&[a, b, c]);
        *uses.entry(sorted).or_default() += if is_even { 1 } else { -1 };
    }
    *triangles = uses
        .into_iter()
        .flat_map(|([a, b, c], uses)| {
            let triangle = if uses > 0 { [a, b, c] } else { [a, c, b] };
            std::iter::repeat_n(triangle, usize::try_from(uses.unsigned_abs()).unwrap_or(0))
        })
        .collect();
}

/// Classes of items.
struct Groups(Vec<usize>);

impl Groups {
    fn new(count: usize) -> Groups {
        Groups((0..count).collect())
    }

    fn of(&mut self, mut at: usize) -> usize {
        while self.0[at] != at {
            self.0[at] = self.0[self.0[at]];
            at = self.0[at];
        }
        at
    }

    fn join(&mut self, one: usize, other: usize) {
        let [one, other] = [self.of(one), self.of(other)];
        let (least, most) = (one.min(other), one.max(other));
        self.0[most] = least;
    }
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

    #[test]
    fn closing_joins_places_and_forgets_what_is_thin() {
        let of = |triangles: &[Corners]| {
            let shells = Shells::of(triangles, 1e-9);
            (shells.solids(), shells.euler())
        };
        let cube = solid([0.0; 3], [4.0; 3]);
        assert_eq!(of(&cube), (1, 2));
        let mut torn = cube.clone();
        torn[0][0][0] += 1e-12;
        assert_eq!(of(&torn), (1, 2), "a vertex in two places");
        let thin = solid([5.0, 0.0, 0.0], [5.0 + 1e-11, 4.0, 4.0]);
        assert_eq!(of(&[cube.clone(), thin].concat()), (1, 2), "a sheet beside it");
        let thick = solid([5.0, 0.0, 0.0], [5.0 + 1e-6, 4.0, 4.0]);
        assert_eq!(of(&[cube.clone(), thick].concat()), (2, 4), "a part beside it");
        let cavity: Vec<Corners> = solid([1.0; 3], [2.0; 3]).into_iter().map(|[a, b, c]| [a, c, b]).collect();
        assert_eq!(of(&[cube, cavity].concat()), (1, 4), "a cavity is not a part");
    }
}
