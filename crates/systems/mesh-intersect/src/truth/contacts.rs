//! The contacts of two closed solids, from their definition and in rationals: all pairs of triangles are compared.
//!
//! The points of both solids that are not in the closure of the common inside are on both surfaces. So they are in the
//! intersections of pairs of triangles, which are convex: points, segments and polygons. What is there beside a point
//! is constant along a segment between the triangles that cross it, so each segment is cut by all triangles, and each
//! part is decided by its middle.
//!
//! A point is in the closure of the common inside if and only if the border of the common inside has the point. That
//! border consists of parts of triangles. So each triangle at the point is divided there by the planes and the edges of
//! the others; beside a point of each sector, on the side of the solid, a ray decides if the other solid is there, too.

use std::collections::{BTreeMap, BTreeSet};

use predicament_mesh::MaterialMesh;
use rug::Rational;

use super::Point;
use super::faces::{Face, bounds, cross, dot, is_inside, is_null, minus, moved};

/// The contacts of two solids.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Touching {
    /// Faces: two triangles by their indices in either mesh, and the polygon in both.
    pub faces: Vec<([u32; 2], Vec<Point>)>,
    /// Segments outside of all faces, cut where other triangles cross them.
    pub segments: Vec<[Point; 2]>,
    /// Points outside of all faces and segments.
    pub points: BTreeSet<Point>,
}

/// Two solids by their outer faces.
struct Solids {
    faces: [Vec<Face>; 2],
    /// The pairs of faces that touch in an area, by their places in `faces`.
    touching: Vec<[usize; 2]>,
}

/// A line: the axis along which its direction is one, the direction, and its point where that coordinate is zero.
type Line = (usize, Point, Point);

/// The line through two points.
///
/// # Panics
/// If the points are equal.
#[must_use]
pub fn line([a, b]: [&Point; 2]) -> Line {
    let way = minus(b, a);
    let axis = way.iter().position(|x| !x.is_zero()).expect("two points");
    let way = way.each_ref().map(|x| Rational::from(x / &way[axis]));
    let from = moved(a, &way, &Rational::from(-&a[axis]));
    (axis, way, from)
}

/// The contacts of two meshes over these points; `None` if a ray is not in general position.
#[must_use]
pub fn contacts(points: &[Point], meshes: [&MaterialMesh; 2]) -> Option<Touching> {
    let mut solids = Solids { faces: meshes.map(|mesh| Face::all(points, mesh)), touching: Vec::new() };
    let mut touching = Touching::default();
    let (mut segments, mut singles): (BTreeMap<Line, BTreeSet<[Point; 2]>>, _) = (BTreeMap::new(), BTreeSet::new());
    for (i, first) in solids.faces[0].iter().enumerate() {
        for (j, second) in solids.faces[1].iter().enumerate() {
            let common = first.common(second);
            match &common[..] {
                [] => {}
                [p] => drop(singles.insert(p.clone())),
                [a, b] => drop(segments.entry(line([a, b])).or_default().insert([a.clone(), b.clone()])),
                _ => {
                    let is_same_way = dot(&first.normal, &second.normal) > 0;
                    // The solids are on two sides of the plane.
                    if is_same_way == (first.is_inward != second.is_inward) {
                        touching.faces.push(([first.at, second.at], common));
                        solids.touching.push([i, j]);
                    }
                }
            }
        }
    }
    for together in segments.values() {
        for part in solids.parts(together) {
            let middle = [0, 1, 2].map(|i: usize| Rational::from(&part[0][i] + &part[1][i]) / 2);
            if !solids.is_in_face(&middle) && !solids.has_inside(&middle)? {
                touching.segments.push(part);
            }
        }
    }
    for p in singles {
        let is_between = |[a, b]: &[Point; 2]| {
            is_null(&cross(&minus(b, a), &minus(&p, a))) && dot(&minus(a, &p), &minus(b, &p)) <= 0
        };
        let is_covered = solids.is_in_face(&p) || touching.segments.iter().any(is_between);
        if !is_covered && !solids.has_inside(&p)? {
            touching.points.insert(p);
        }
    }
    Some(touching)
}

impl Solids {
    fn all(&self) -> impl Iterator<Item = (usize, &Face)> {
        self.faces.iter().enumerate().flat_map(|(mesh, faces)| faces.iter().map(move |face| (mesh, face)))
    }

    /// True if a point is in a face in which the solids touch.
    fn is_in_face(&self, p: &Point) -> bool {
        self.touching.iter().any(|&[i, j]| self.faces[0][i].contains(p) && self.faces[1][j].contains(p))
    }

    /// The union of segments of one line, cut at their ends and by all triangles.
    fn parts(&self, segments: &BTreeSet<[Point; 2]>) -> Vec<[Point; 2]> {
        let mut cuts: BTreeSet<Point> = segments.iter().flatten().cloned().collect();
        for [a, b] in segments {
            let bounds = bounds(&[a.clone(), b.clone()]);
            for (_, face) in self.all().filter(|(_, face)| face.is_near(&bounds)) {
                let heights = [face.above(a), face.above(b)];
                if heights[0].cmp0() == heights[1].cmp0().reverse() && !heights[0].is_zero() {
                    let part = &heights[0] / Rational::from(&heights[0] - &heights[1]);
                    cuts.insert(moved(a, &minus(b, a), &part));
                }
            }
        }
        let cuts: Vec<Point> = cuts.into_iter().collect();
        let parts = cuts.windows(2).map(|pair| [pair[0].clone(), pair[1].clone()]);
        parts.filter(|[low, high]| segments.iter().any(|[a, b]| a <= low && high <= b)).collect()
    }

    /// True if points inside of both solids are arbitrarily near a point of both surfaces.
    fn has_inside(&self, p: &Point) -> Option<bool> {
        let there: Vec<(usize, &Face)> = self.all().filter(|(_, face)| face.contains(p)).collect();
        for &(mesh, face) in &there {
            for way in sectors(face, p, there.iter().map(|(_, face)| *face)) {
                let Some(q) = self.beside(face, p, &way) else { continue };
                let inward = if face.is_inward { face.normal.clone() } else { face.normal.clone().map(|x| -x) };
                let inside = moved(&q, &inward, &self.free(&q, &inward));
                if is_inside(&self.faces[1 - mesh], &inside)? {
                    return Some(true);
                }
            }
        }
        Some(false)
    }

    /// Half the multiple of a direction at which a ray meets the first plane of a face, apart from those that contain
    /// its start.
    fn free(&self, p: &Point, way: &Point) -> Rational {
        let meets = |(_, face): (usize, &Face)| {
            let (height, slope) = (face.above(p), dot(&face.normal, way));
            (!height.is_zero() && height.cmp0() == slope.cmp0().reverse()).then(|| -height / slope)
        };
        self.all().filter_map(meets).min().unwrap_or_else(|| Rational::from(2)) / 2
    }

    /// A point of a face in a direction from one of its points, before any other plane; `None` if the direction leaves
    /// the face.
    fn beside(&self, face: &Face, p: &Point, way: &Point) -> Option<Point> {
        let mut part = self.free(p, way);
        for edge in face.edges() {
            let (from, slope) = (face.across(edge, p), dot(&cross(&face.normal, &minus(edge[1], edge[0])), way));
            if slope < 0 {
                if from.is_zero() {
                    return None;
                }
                part = part.min(-from / slope / 2);
            }
        }
        Some(moved(p, way, &part))
    }
}

/// A direction inside of each sector around a point of a face, between the planes and edges of these faces.
fn sectors<'a>(face: &Face, p: &Point, others: impl Iterator<Item = &'a Face>) -> Vec<Point> {
    let mut ways: Vec<Point> = Vec::new();
    for other in others {
        let along = cross(&face.normal, &other.normal);
        if !is_null(&along) {
            ways.push(along);
            continue;
        }
        let through = other.edges().into_iter().map(|[a, b]| (minus(b, a), minus(p, a)));
        ways.extend(through.filter(|(edge, from)| is_null(&cross(edge, from))).map(|(edge, _)| edge));
    }
    if ways.is_empty() {
        let [a, b, _] = &face.corners;
        return vec![minus(b, a)];
    }
    ways.extend(ways.clone().into_iter().map(|way| way.map(|x| -x)));
    // The order around the normal, from the first direction.
    let first = ways[0].clone();
    let turn = |a: &Point, b: &Point| dot(&face.normal, &cross(a, b));
    let half = |way: &Point| {
        let turned = turn(&first, way);
        turned < 0 || turned.is_zero() && dot(&first, way) < 0
    };
    ways.sort_by(|a, b| half(a).cmp(&half(b)).then_with(|| turn(a, b).cmp0().reverse()));
    ways.dedup_by(|a, b| turn(a, b).is_zero() && dot(a, b) > 0);
    (0..ways.len())
        .map(|at| {
            let [from, to] = [&ways[at], &ways[(at + 1) % ways.len()]];
            if turn(from, to).is_zero() { cross(&face.normal, from) } else { moved(from, to, &Rational::from(1)) }
        })
        .collect()
}
