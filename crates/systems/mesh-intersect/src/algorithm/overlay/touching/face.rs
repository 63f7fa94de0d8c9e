//! A triangle, divided by the points and segments of the other mesh in it.

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::found::Simplex;
use super::marks::{Mark, Marks};
use super::triangle::{Triangle, Triangles};
use crate::algorithm::overlay::along::longest;
use crate::algorithm::overlay::cut::projection;
use crate::algorithm::overlay::known::Known;
use crate::algorithm::overlay::near::number;
use crate::algorithm::overlay::{Contradiction, Undone, radial};
use crate::algorithm::planar::Points;

/// The place of a part of a triangle in the other mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Place {
    /// In a region.
    Region(u32),
    /// In a near triangle of the other mesh.
    Shared(u32),
    /// Not decided by the border of the part.
    Unknown,
}

/// A part of a triangle, as triangles.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub triangles: Vec<[Vertex; 3]>,
    pub place: Place,
    /// Its corners that are not on the other mesh.
    pub off: Vec<Vertex>,
    /// The edges at the border of the triangle that are off the other mesh, with both ends on it.
    pub open: Vec<[Vertex; 2]>,
}

/// A mesh that is divided, and the other mesh.
pub(super) struct Dividing<'a> {
    pub session: &'a dyn Predicates,
    /// The index of the mesh.
    pub mesh: usize,
    pub own: &'a Triangles<'a>,
    pub marks: &'a Marks,
    pub other: &'a Triangles<'a>,
    pub other_mesh: &'a MaterialMesh,
    /// For each input vertex, true if it is on the other mesh; by representatives.
    pub is_on_other: &'a (dyn Fn(Vertex) -> bool + Sync),
}

impl Dividing<'_> {
    /// True if a triangle meets the other mesh.
    pub fn is_touched(&self, place: u32) -> bool {
        let triangle = self.own.at(place);
        triangle.corners.iter().any(|&v| (self.is_on_other)(v))
            || triangle.edges.iter().any(|&edge| !self.marks.on_edge(edge).is_empty())
            || !self.marks.in_triangle(place).is_empty()
            || !self.marks.across_triangle(place).is_empty()
    }

    /// The parts of a triangle.
    pub fn parts(&self, place: u32) -> Result<Vec<Part>, Undone> {
        let triangle = self.own.at(place);
        let (plane, is_clockwise) = projection(self.session, triangle.corners)?;
        let (nodes, lines) = self.nodes(&triangle);
        let marks = self.marks.across_triangle(place);
        let node = |v: Vertex| nodes.iter().position(|&other| other == v).map(number);
        let mut edges = Vec::with_capacity(marks.len());
        for mark in marks {
            let [Some(a), Some(b)] = mark.ends.map(node) else { return Err(Contradiction::Segment.into()) };
            edges.push([a, b]);
        }
        let mut triangles = if nodes.len() == 3 {
            vec![[0, 1, 2]]
        } else {
            let known = nodes.iter().copied().zip(lines);
            let known = Known::new(self.session, triangle.corners, known, Vec::new());
            let points = Points { session: &known, plane, vertices: &nodes };
            points.triangulated(&edges).map_err(|broken| Undone::Broken(broken.into()))?
        };
        if is_clockwise && nodes.len() > 3 {
            triangles.iter_mut().for_each(|corners| corners.swap(1, 2));
        }
        self.grouped(&triangle, (plane, is_clockwise), &nodes, &triangles)
    }

    /// The corners of a triangle, then the points on its edges, then those inside; with the edges of the triangle
    /// through each, a bit for each.
    fn nodes(&self, triangle: &Triangle) -> (Vec<Vertex>, Vec<u64>) {
        let mut nodes = triangle.corners.to_vec();
        let mut lines: Vec<u64> = vec![0b101, 0b011, 0b110];
        for (edge, line) in triangle.edges.into_iter().zip([1, 2, 4]) {
            let on = self.marks.on_edge(edge);
            nodes.extend(on);
            lines.resize(nodes.len(), line);
        }
        nodes.extend(self.marks.in_triangle(triangle.place));
        lines.resize(nodes.len(), 0);
        (nodes, lines)
    }

    /// Joins triangles across edges that are not on the other mesh.
    fn grouped(
        &self,
        triangle: &Triangle,
        view: (Plane, bool),
        nodes: &[Vertex],
        triangles: &[[u32; 3]],
    ) -> Result<Vec<Part>, Undone> {
        let across = self.marks.across_triangle(triangle.place);
        let along: Vec<Mark> = triangle.edges.iter().flat_map(|&edge| self.marks.along_edge(edge)).copied().collect();
        let marked = |marks: &[Mark], [a, b]: [Vertex; 2]| -> Option<Mark> {
            marks.iter().copied().find(|mark| mark.ends == [a, b] || mark.ends == [b, a])
        };
        let mut sides: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * triangles.len());
        for (&[a, b, c], at) in triangles.iter().zip(0..) {
            sides.extend([[a, b], [b, c], [c, a]].map(|[a, b]| ([a.min(b), a.max(b)], at)));
        }
        sides.sort_unstable();
        let mut leaders: Vec<u32> = (0..number(triangles.len())).collect();
        let leader = |leaders: &[u32], mut at: u32| {
            while leaders[at as usize] != at {
                at = leaders[at as usize];
            }
            at
        };
        // Edges of one triangle alone are at the border.
        let mut border = Vec::new();
        for side in sides.chunk_by(|a, b| a.0 == b.0) {
            let ends = side[0].0.map(|at| nodes[at as usize]);
            match *side {
                [(_, at)] => border.push((ends, at)),
                [(_, first), (_, second)] if marked(across, ends).is_none() => {
                    let [first, second] = [leader(&leaders, first), leader(&leaders, second)];
                    leaders[first.max(second) as usize] = first.min(second);
                }
                _ => {}
            }
        }
        let mut parts: Vec<Part> = Vec::new();
        let mut part_of: Vec<usize> = vec![usize::MAX; triangles.len()];
        for at in 0..triangles.len() {
            let first = leader(&leaders, number(at)) as usize;
            if first == at {
                part_of[at] = parts.len();
                parts.push(Part { triangles: Vec::new(), place: Place::Unknown, off: Vec::new(), open: Vec::new() });
            }
            part_of[at] = part_of[first];
            let part = &mut parts[part_of[at]];
            let corners = triangles[at].map(|node| nodes[node as usize]);
            part.triangles.push(corners);
            part.off.extend(corners.iter().filter(|&&v| !v.is_constructed() && !self.is_on(triangle, v)));
            let [a, b, c] = corners;
            for ends in [[a, b], [b, c], [c, a]] {
                let place = if let Some(mark) = marked(across, ends) {
                    self.beside(triangle, view, ends, mark)
                } else if let Some(mark) = marked(&along, ends) {
                    self.beside_border(triangle, mark)
                } else {
                    continue;
                };
                if part.place != Place::Unknown && part.place != place {
                    return Err(Contradiction::Region.into());
                }
                part.place = place;
            }
        }
        for (ends, at) in border {
            let is_off = |v: Vertex| !v.is_constructed() && !self.is_on(triangle, v);
            if marked(&along, ends).is_none() && !ends.into_iter().any(is_off) {
                let [a, b] = ends;
                parts[part_of[at as usize]].open.push([a.min(b), a.max(b)]);
            }
        }
        Ok(parts)
    }

    /// True if an input vertex among the nodes of a triangle is on the other mesh. A node that is not a corner is.
    fn is_on(&self, triangle: &Triangle, v: Vertex) -> bool {
        !triangle.corners.contains(&v) || (self.is_on_other)(v)
    }

    /// The place on the left of a segment inside a triangle, as seen from the triangle's front.
    fn beside(&self, triangle: &Triangle, view: (Plane, bool), [from, to]: [Vertex; 2], mark: Mark) -> Place {
        match mark.with {
            Simplex::Triangle(other) => {
                let is_ahead = mark.ends == [from, to];
                // The first mesh's triangle has the part behind the other on the left of its direction.
                let is_behind = is_ahead == (self.mesh == 0);
                let [front, behind] = self.sides(other);
                Place::Region(if is_behind { behind } else { front })
            }
            Simplex::Edge(edge) => {
                let ends = self.other.near.edges[edge as usize];
                let (axis, is_up) = longest(self.session, ends);
                let is_ahead = (self.session.compare(axis, from, to) == Sign::Negative) == is_up;
                // A corner on the left of the segment.
                let (plane, is_clockwise) = view;
                let left = if is_ahead == is_clockwise { Sign::Negative } else { Sign::Positive };
                let turn = |v: Vertex| {
                    if ends.contains(&v) { Sign::Zero } else { self.session.orient2d(plane, ends[0], ends[1], v) }
                };
                let corner = triangle.corners.into_iter().find(|&v| turn(v) == left);
                corner.map_or(Place::Unknown, |corner| self.around(edge, corner))
            }
            Simplex::Vertex(_) => Place::Unknown,
        }
    }

    /// The place of a triangle beside a segment along one of its edges.
    fn beside_border(&self, triangle: &Triangle, mark: Mark) -> Place {
        let at_edge =
            |&edge: &usize| self.marks.along_edge(triangle.edges[edge]).iter().any(|other| other.ends == mark.ends);
        let Some(edge) = (0..3).find(at_edge) else { return Place::Unknown };
        let apex = triangle.corners[(edge + 2) % 3];
        match mark.with {
            Simplex::Triangle(other) => {
                let [a, b, c] = self.other.corners[other as usize];
                let side = if [a, b, c].contains(&apex) { Sign::Zero } else { self.session.orient3d(a, b, c, apex) };
                let [front, behind] = self.sides(other);
                match side {
                    Sign::Positive => Place::Region(behind),
                    Sign::Negative => Place::Region(front),
                    Sign::Zero => Place::Shared(other),
                }
            }
            Simplex::Edge(edge) => self.around(edge, apex),
            Simplex::Vertex(_) => Place::Unknown,
        }
    }

    /// The place of a half-plane that ends at an edge of the other mesh, with a vertex in it.
    fn around(&self, edge: u32, v: Vertex) -> Place {
        let axis = self.other.near.edges[edge as usize];
        // Triangles at the edge, with the corner that is not on it.
        let mut all: Vec<(Vertex, Option<(u32, usize)>)> = vec![(v, None)];
        for (triangle, corner) in self.other.near.uses(edge) {
            all.push((self.other.corners[triangle as usize][(corner + 2) % 3], Some((triangle, corner))));
        }
        let is_along = |w: Vertex| w == v || radial::is_along(self.session, axis, v, w);
        if let Some((_, Some((triangle, _)))) = all[1..].iter().find(|(w, _)| is_along(*w)) {
            return Place::Shared(*triangle);
        }
        radial::sort(self.session, axis, &mut all);
        let Some((_, Some((triangle, corner)))) = all.get(1).copied() else { return Place::Unknown };
        // The half-plane is next to this triangle, on its clockwise side.
        let is_forward = self.other.corners[triangle as usize][corner] == axis[0];
        let [front, behind] = self.sides(triangle);
        Place::Region(if is_forward { front } else { behind })
    }

    /// The regions in front of a near triangle of the other mesh, and behind it.
    fn sides(&self, triangle: u32) -> [u32; 2] {
        self.other_mesh.sides()[self.other.near.triangles[triangle as usize] as usize]
    }
}
