//! Connected parts of a surface in doubles, after closing what is thinner than a distance.
//!
//! A program's mesh may have vertices that are one in truth, and sheets without a volume between them. Vertices within
//! a distance of each other are one vertex here; triangles with a vertex twice, and pairs of opposite triangles, are
//! left out; and a shell whose volume is at most that of a layer of this thickness on its surface is thin.

use std::collections::BTreeMap;

use super::{Corners, Skin, area};
use crate::boxes::Boxes;

/// A connected part of a surface.
#[derive(Debug)]
pub struct Shell {
    /// Its triangles, with joined vertices.
    pub corners: Vec<Corners>,
    /// The Euler characteristic: the vertices less the edges, plus the triangles.
    pub euler: i64,
    /// The volume inside; negative for a surface around a cavity.
    pub volume: f64,
    /// True if the volume is at most that of a layer on the surface.
    pub is_thin: bool,
}

/// The parts of a surface.
#[derive(Debug)]
pub struct Shells(Vec<Shell>);

impl Shells {
    /// The parts of a surface, with vertices within a distance of each other as one.
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
            let is_thin = volume.abs() <= near * corners.iter().map(area).sum::<f64>();
            Shell { corners, euler, volume, is_thin }
        });
        Shells(shells.collect())
    }

    /// All parts, thin ones as well.
    #[must_use]
    pub fn all(&self) -> &[Shell] {
        &self.0
    }

    /// The parts that are not thin.
    pub fn thick(&self) -> impl Iterator<Item = &Shell> {
        self.0.iter().filter(|shell| !shell.is_thin)
    }

    /// The sum of the Euler characteristics of the parts that are not thin.
    #[must_use]
    pub fn euler(&self) -> i64 {
        self.thick().map(|shell| shell.euler).sum()
    }

    /// The number of parts of the solid: those that are neither thin nor around a cavity.
    #[must_use]
    pub fn solids(&self) -> usize {
        self.thick().filter(|shell| shell.volume > 0.0).count()
    }
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
#[derive(Debug)]
pub struct Groups(Vec<usize>);

impl Groups {
    /// This number of items, each in a class of its own.
    #[must_use]
    pub fn new(count: usize) -> Groups {
        Groups((0..count).collect())
    }

    /// The smallest item of the class of an item.
    pub fn of(&mut self, mut at: usize) -> usize {
        while self.0[at] != at {
            self.0[at] = self.0[self.0[at]];
            at = self.0[at];
        }
        at
    }

    /// Makes one class of the classes of two items.
    pub fn join(&mut self, one: usize, other: usize) {
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
