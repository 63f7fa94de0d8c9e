//! The Euler characteristic of the parts of a solid, without cutting it.
//!
//! # The law
//! Let planes cut a closed solid S, and let a part be the points of S in one closed cell between the planes. A point of
//! S that is on j planes is in 2^j cells, if at most three planes meet in a point and at most two in a line. The Euler
//! characteristic χ is additive, and 2^j is the number of subsets of the j planes. So the characteristics of all parts
//! add up to χ(S), the χ of S on each plane, that on each line of two planes, and that at each point of three planes:
//!
//! * the boundary of a solid has twice its χ;
//! * on a plane, S is a region between closed curves: an outer curve counts 1, and the curve around a hole −1;
//! * on a line, S is a number of segments: one for two crossings of the surface;
//! * a point in S counts 1.
//!
//! A part that is lost, a cavity, and a handle or a tunnel change the sum. A part and a handle too many together do
//! not.
//!
//! # When it is judged
//! The sum is judged where rounding cannot change it: the surface is a manifold, and all vertices of the true parts are
//! farther than a margin from each other and from planes that they are not on. The program's parts are taken with
//! vertices that are within 2δ of each other as one vertex, and as they are; with shells that are thinner than 2δ, and
//! without them. One of these readings must have the right sum. Pieces of one part that touch are not judged: their
//! common face is not a boundary of the part.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use predicament_judge::boxes::Boxes;
use predicament_judge::skin::shells::{Groups, Shell, Shells};
use predicament_judge::skin::{Corners, Skin};
use predicament_judge::{nearest, rational};
use rug::Rational;

use super::exact::{Plane, Point, dot, minus, volume};

/// A margin is this many times the distance of an answer.
const MARGIN: f64 = 64.0;
/// The largest numbers of triangles and of planes for which the sum is judged.
const MOST: [usize; 2] = [2_000, 12];

/// A solid by its vertices, without points twice.
struct Surface {
    places: Vec<Point>,
    triangles: Vec<[usize; 3]>,
}

/// The curve of a surface on a plane: each point is on an edge, given by its ends.
struct Section {
    points: BTreeMap<[usize; 2], Point>,
    /// The pieces of the curve, counterclockwise around the solid.
    pieces: Vec<[[usize; 2]; 2]>,
}

/// The sum of the Euler characteristics of the surfaces of all parts; `None` if the law is not judged.
pub(super) fn wanted(mesh: &Skin, planes: &[Plane], within: f64) -> Option<i64> {
    let margin = MARGIN * within;
    let [most_triangles, most_planes] = MOST;
    if mesh.triangles().len() > most_triangles || planes.len() > most_planes {
        return None;
    }
    let surface = Surface::of(mesh.triangles())?;
    let is_far = |p: &Point, from: &[usize]| {
        planes.iter().enumerate().all(|(at, plane)| from.contains(&at) || plane.distance(p) > margin)
    };
    let mut vertices: Vec<Point> = surface.places.clone();
    // Of the solid, then of what is on one, two and three planes.
    let mut doubled = surface.euler();
    let sections: Vec<Section> = planes.iter().map(|plane| surface.section(plane)).collect::<Option<_>>()?;
    if !surface.places.iter().all(|p| is_far(p, &[])) {
        return None;
    }
    for (i, section) in sections.iter().enumerate() {
        doubled += 2 * section.euler(&planes[i])?;
        if !section.points.values().all(|p| is_far(p, &[i])) {
            return None;
        }
        vertices.extend(section.points.values().cloned());
        for j in i + 1..planes.len() {
            let crossings = section.crossings(&planes[j]);
            if !crossings.iter().all(|p| is_far(p, &[i, j])) || crossings.len() % 2 == 1 {
                return None;
            }
            // Twice the number of segments between the crossings.
            doubled += i64::try_from(crossings.len()).ok()?;
            vertices.extend(crossings);
            for k in j + 1..planes.len() {
                let Some(p) = common([&planes[i], &planes[j], &planes[k]]) else { continue };
                let place = [0, 1, 2].map(|axis: usize| nearest(&p[axis]));
                if place.iter().any(|x| !x.is_finite()) {
                    continue;
                }
                if mesh.distance(place, margin) <= margin {
                    return None;
                }
                if mesh.winding(place)? > 0 {
                    if !is_far(&p, &[i, j, k]) {
                        return None;
                    }
                    doubled += 2;
                    vertices.push(p);
                }
            }
        }
    }
    let places: Vec<[f64; 3]> = vertices.iter().map(|p| [0, 1, 2].map(|axis: usize| nearest(&p[axis]))).collect();
    are_apart(&places, margin).then_some(doubled)
}

/// The sum of the Euler characteristics of the surfaces of a program's parts, closest to the wanted one; `None` if
/// pieces of one part touch.
pub(super) fn found(parts: &[Skin], planes: &[Plane], within: f64, wanted: i64) -> Option<i64> {
    let mut cells: BTreeMap<Vec<Ordering>, Vec<Corners>> = BTreeMap::new();
    for part in parts.iter().filter(|part| !part.triangles().is_empty()) {
        cells.entry(planes.iter().map(|plane| side(part, plane)).collect()).or_default().extend(part.triangles());
    }
    let near = 2.0 * within;
    let mut sums = [0; 4];
    for triangles in cells.values() {
        let shells = Shells::of(triangles, near);
        if do_touch(&shells, near) {
            return None;
        }
        let as_they_are = Shells::of(triangles, 0.0);
        let all = |shells: &Shells| shells.all().iter().map(|shell| shell.euler).sum::<i64>();
        let readings = [shells.euler(), all(&shells), as_they_are.euler(), all(&as_they_are)];
        sums.iter_mut().zip(readings).for_each(|(sum, reading)| *sum += reading);
    }
    sums.into_iter().min_by_key(|sum| sum.abs_diff(wanted))
}

/// The side of a plane on which a part is: that of its farthest vertex.
fn side(part: &Skin, plane: &Plane) -> Ordering {
    let heights = part.triangles().as_flattened().iter().map(|p| plane.height(&p.map(rational)));
    let farthest = heights.max_by(|p, q| p.cmp_abs(q));
    farthest.map_or(Ordering::Equal, |height| height.cmp0())
}

/// True if two surfaces of solids touch.
fn do_touch(shells: &Shells, near: f64) -> bool {
    let solids: Vec<&Shell> = shells.thick().filter(|shell| shell.volume > 0.0).collect();
    let skins: Vec<Skin> = solids.iter().map(|shell| Skin::new(shell.corners.clone())).collect();
    let is_on = |p: &[f64; 3], skin: &Skin| skin.is_near(*p, near) && skin.distance(*p, near) <= near;
    solids.iter().enumerate().any(|(at, shell)| {
        let others = skins.iter().enumerate().filter(|(other, _)| *other != at);
        others.into_iter().any(|(_, skin)| shell.corners.as_flattened().iter().any(|p| is_on(p, skin)))
    })
}

/// True if all points are farther than a distance from each other.
fn are_apart(places: &[[f64; 3]], margin: f64) -> bool {
    let index = Boxes::new(places.iter().map(|&p| [p, p]).collect());
    let mut near = Vec::new();
    places.iter().all(|&p| {
        index.near(&[p, p], margin, &mut near);
        near.len() == 1
    })
}

/// The common point of three planes, if there is exactly one.
fn common(planes: [&Plane; 3]) -> Option<Point> {
    let normals = planes.map(|plane| plane.normal.clone());
    let [a, b, c] = &normals;
    let determinant = volume([a, b, c]);
    if determinant.is_zero() {
        return None;
    }
    // The right sides of normal · p = offset, and Cramer's rule.
    let offsets: Vec<Rational> = planes.iter().map(|plane| dot(&plane.normal, plane.point())).collect();
    Some([0, 1, 2].map(|axis: usize| {
        let mut replaced = normals.clone();
        replaced.iter_mut().zip(&offsets).for_each(|(normal, offset)| normal[axis] = offset.clone());
        let [a, b, c] = &replaced;
        volume([a, b, c]) / &determinant
    }))
}

impl Surface {
    /// A surface, or `None` if it is not a manifold: at each edge two triangles meet, in opposite directions, and the
    /// triangles around a vertex are one fan.
    fn of(triangles: &[Corners]) -> Option<Surface> {
        let key = |p: [f64; 3]| p.map(|x| x + 0.0);
        let mut places: Vec<[f64; 3]> = triangles.as_flattened().iter().map(|&p| key(p)).collect();
        places.sort_by(|p, q| p.partial_cmp(q).unwrap_or(Ordering::Equal));
        places.dedup();
        let number =
            |p: [f64; 3]| places.binary_search_by(|q| q.partial_cmp(&key(p)).unwrap_or(Ordering::Equal)).unwrap_or(0);
        let triangles: Vec<[usize; 3]> = triangles.iter().map(|corners| corners.map(number)).collect();
        let mut sides: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        for (at, &[a, b, c]) in triangles.iter().enumerate() {
            for (corner, edge) in [[a, b], [b, c], [c, a]].into_iter().enumerate() {
                if edge[0] == edge[1] || sides.insert(edge, 3 * at + corner).is_some() {
                    return None;
                }
            }
        }
        // Corners at one vertex are of one fan if their triangles have an edge in common.
        let mut fans = Groups::new(3 * triangles.len());
        let next = |corner: usize| corner - corner % 3 + (corner + 1) % 3;
        for (&[a, b], &corner) in &sides {
            let &opposite = sides.get(&[b, a])?;
            fans.join(corner, next(opposite));
        }
        let mut of_vertex: BTreeMap<usize, usize> = BTreeMap::new();
        for corner in 0..3 * triangles.len() {
            let fan = fans.of(corner);
            if *of_vertex.entry(triangles[corner / 3][corner % 3]).or_insert(fan) != fan {
                return None;
            }
        }
        Some(Surface { places: places.into_iter().map(|p| p.map(rational)).collect(), triangles })
    }

    /// The Euler characteristic of the surface: two triangles meet at each edge.
    fn euler(&self) -> i64 {
        let count = |length: usize| i64::try_from(length).unwrap_or(i64::MAX);
        count(self.places.len()) - count(self.triangles.len() * 3 / 2) + count(self.triangles.len())
    }

    /// The curve on a plane, or `None` if a vertex is on it.
    fn section(&self, plane: &Plane) -> Option<Section> {
        let heights: Vec<Rational> = self.places.iter().map(|p| plane.height(p)).collect();
        if heights.iter().any(Rational::is_zero) {
            return None;
        }
        let mut section = Section { points: BTreeMap::new(), pieces: Vec::new() };
        for &[a, b, c] in &self.triangles {
            let mut ends = [None; 2];
            for [p, q] in [[a, b], [b, c], [c, a]] {
                let [low, high] = [p.min(q), p.max(q)];
                if heights[p].is_positive() != heights[q].is_positive() {
                    // A piece goes from the edge on which the triangle goes down to the one on which it goes up.
                    ends[usize::from(heights[q].is_positive())] = Some([low, high]);
                    section.points.entry([low, high]).or_insert_with(|| {
                        let part = &heights[low] / Rational::from(&heights[low] - &heights[high]);
                        between(&self.places[low], &self.places[high], &part)
                    });
                }
            }
            if let [Some(from), Some(to)] = ends {
                section.pieces.push([from, to]);
            }
        }
        Some(section)
    }
}

impl Section {
    /// The Euler characteristic of the region inside of the curve; `None` if a part of the curve has no area.
    fn euler(&self, plane: &Plane) -> Option<i64> {
        let next: BTreeMap<[usize; 2], [usize; 2]> = self.pieces.iter().map(|[from, to]| (*from, *to)).collect();
        let mut left = next.clone();
        let mut sum = 0;
        while let Some((&first, _)) = left.first_key_value() {
            let (origin, mut at) = (&self.points[&first], first);
            let mut area = Rational::new();
            while let Some(to) = left.remove(&at) {
                let [p, q] = [&self.points[&at], &self.points[&to]].map(|p| minus(p, origin));
                area += volume([&p, &q, &plane.normal]);
                at = to;
            }
            sum += match area.cmp0() {
                Ordering::Greater => 1,
                Ordering::Less => -1,
                Ordering::Equal => return None,
            };
        }
        Some(sum)
    }

    /// The points where the curve crosses another plane.
    fn crossings(&self, plane: &Plane) -> Vec<Point> {
        let heights: BTreeMap<[usize; 2], Rational> =
            self.points.iter().map(|(edge, p)| (*edge, plane.height(p))).collect();
        let crossing = |[from, to]: &[[usize; 2]; 2]| {
            let [low, high] = [&heights[from], &heights[to]];
            (low.is_positive() != high.is_positive()).then(|| {
                let part = low / Rational::from(low - high);
                between(&self.points[from], &self.points[to], &part)
            })
        };
        self.pieces.iter().filter_map(crossing).collect()
    }
}

/// The point at a part of the way from p to q.
fn between(p: &Point, q: &Point, part: &Rational) -> Point {
    [0, 1, 2].map(|axis: usize| &p[axis] + part * Rational::from(&q[axis] - &p[axis]))
}
