//! A triangle cut by the other mesh: its segments, its faces, and their triangulation.

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::arcs::{Divided, Segment};
use super::known::Known;
use super::meet::Hit;
use super::near::{Near, number};
use super::points::Points;
use super::regions::VertexRegions;
use super::{Contradiction, Piece, radial};
use predicament_triangulate::algorithm::{MOST, Method, triangulate, triangulate_few};

/// A mesh and the cuts that the other mesh makes in it.
pub(super) struct Cutting<'a> {
    pub session: &'a dyn Predicates,
    pub mesh: &'a MaterialMesh,
    pub near: &'a Near,
    /// The points on the edges of this mesh.
    pub own: &'a Points,
    pub other: &'a MaterialMesh,
    pub other_near: &'a Near,
    /// The points on the edges of the other mesh.
    pub others: &'a Points,
    /// The regions of the other mesh that contain this mesh's vertices.
    pub regions: &'a VertexRegions,
}

/// An end of a segment.
struct End {
    /// The other triangle.
    with: u32,
    node: u32,
    /// The regions on the left of the segment as it leaves the node, seen from the front, and on its right.
    sides: [u32; 2],
}

impl Cutting<'_> {
    /// True if anything passes through a near triangle, or through its edges.
    pub fn is_cut(&self, place: u32) -> bool {
        self.near.edges_of[place as usize].iter().any(|&edge| !self.own.on(edge).is_empty())
            || !self.others.within(place).is_empty()
    }

    /// The pieces of a near triangle.
    ///
    /// # Errors
    /// The invariant that fails.
    pub fn pieces(&self, place: u32) -> Result<Vec<Piece>, Contradiction> {
        let of = self.near.triangles[place as usize];
        let corners = self.mesh.triangles()[of as usize];
        let divided = self.divided(place)?;
        let mut walks = divided.walks()?;
        // A face with holes has several walks. The walks of one region are faces and holes together.
        let has_holes = walks.iter().any(|walk| !walk.is_at_border);
        if has_holes {
            walks.sort_by_key(|walk| walk.region);
        }
        let faces = walks.chunk_by(|a, b| has_holes && a.region == b.region);
        let mut pieces = Vec::with_capacity(2 * walks.len());
        let mut fill = None;
        for face in faces {
            let region = face[0].region;
            if let [walk] = face
                && let [a, b, c] = walk.vertices[..]
            {
                pieces.push(Piece { triangle: [a, b, c], of, region });
                continue;
            }
            let (plane, known) = match &fill {
                Some(fill) => fill,
                None => fill.insert((projection(self.session, corners)?, self.known(place, &divided))),
            };
            let add = |triangle: [Vertex; 3]| Piece { triangle, of, region };
            if let [walk] = face {
                let in_line = |a: Vertex, b: Vertex, c: Vertex| known.are_in_line(a, b, c);
                let is_outer = |v: Vertex| known.is_at_border(v);
                let session: &dyn Predicates = known;
                if let Some(made) = triangulate_few(session, plane.0, plane.1, &walk.vertices, in_line, is_outer) {
                    pieces.extend(made.into_iter().map(add));
                    continue;
                }
            }
            let loops: Vec<Vec<Vertex>> = face.iter().map(|walk| walk.vertices.clone()).collect();
            let method = if loops.len() == 1 && loops[0].len() <= MOST { Method::Ears } else { Method::Monotone };
            let made = triangulate(known as &dyn Predicates, plane.0, plane.1, &loops, method);
            if let Some(broken) = made.broken {
                return Err(broken.into());
            }
            pieces.extend(made.triangles.into_iter().map(add));
        }
        Ok(pieces)
    }

    /// The lines of a triangle's nodes: its edges, and the intersections with planes of the other mesh.
    fn known(&self, place: u32, divided: &Divided) -> Known<'_> {
        let mut lines = divided.lines.clone();
        lines.resize(divided.vertices.len(), 0);
        let mut with: Vec<u32> = divided.ends.iter().map(|&(with, _)| with).collect();
        with.dedup();
        // Triangles at an edge that passes through here are in one plane if the far corner of one is in the plane of
        // the other.
        let mut plane: Vec<usize> = (0..with.len()).collect();
        let find = |plane: &[usize], mut at: usize| {
            while plane[at] != at {
                at = plane[at];
            }
            at
        };
        for at in self.others.within(place) {
            let edge = self.others.hits[at].edge;
            let mut uses = self.other_near.uses(edge).map(|(with, _)| with);
            let mut before = uses.next();
            for next in uses {
                let Some(other) = before.replace(next) else { break };
                let [a, b, c] = self.corners_of_other(other);
                let [i, j] = [other, next].map(|other| with.partition_point(|&with| with < other));
                if self.session.orient3d(a, b, c, self.apex(next, edge)).is_zero() {
                    let [i, j] = [find(&plane, i), find(&plane, j)];
                    plane[i.max(j)] = i.min(j);
                }
            }
        }
        for &(other, node) in &divided.ends {
            let line = 3 + find(&plane, with.partition_point(|&with| with < other));
            if line < 64 {
                lines[node as usize] |= 1 << line;
            }
        }
        let corners = self.mesh.triangles()[self.near.triangles[place as usize] as usize];
        let planes = with.iter().map(|&other| self.corners_of_other(other)).collect();
        Known::new(self.session, corners, divided.vertices.iter().copied().zip(lines), planes)
    }

    fn corners_of_other(&self, place: u32) -> [Vertex; 3] {
        self.other.triangles()[self.other_near.triangles[place as usize] as usize]
    }

    /// The corner of a triangle of the other mesh that is not on a given edge of it.
    fn apex(&self, place: u32, edge: u32) -> Vertex {
        let ends = self.other_near.edges[edge as usize];
        let corners = self.corners_of_other(place);
        corners.into_iter().find(|v| !ends.contains(v)).unwrap_or(corners[0])
    }

    /// Collects the nodes and segments that divide a triangle.
    fn divided(&self, place: u32) -> Result<Divided, Contradiction> {
        let mut divided = Divided::default();
        let mut ends = Vec::new();
        self.go_around(place, &mut divided, &mut ends);
        divided.around = divided.vertices.len();
        let within = self.others.within(place);
        for at in within.clone() {
            self.point_inside(self.others.hits[at], self.others.vertices[at], &mut divided, &mut ends);
        }
        ends.sort_by_key(|end| end.with);
        divided.ends = ends.iter().map(|end| (end.with, end.node)).collect();
        let mut of_node: Vec<Vec<(u32, u32)>> = vec![Vec::new(); divided.vertices.len() - divided.around];
        for pair in ends.chunk_by(|a, b| a.with == b.with) {
            let [from, to] = pair else { return Err(Contradiction::Segment) };
            if from.sides != [to.sides[1], to.sides[0]] {
                return Err(Contradiction::Segment);
            }
            let place = 2 * number(divided.segments.len());
            for (node, end) in [(from.node, place), (to.node, place + 1)] {
                if let Some(there) = (node as usize).checked_sub(divided.around) {
                    of_node[there].push((from.with, end));
                }
            }
            let [left, right] = from.sides;
            divided.segments.push(Segment { nodes: [from.node, to.node], left, right });
        }
        for (mut there, at) in of_node.into_iter().zip(within) {
            if there.len() < 2 {
                return Err(Contradiction::Chain);
            }
            if there.len() > 2 {
                self.sort_around(self.others.hits[at], &mut there);
            }
            divided.inside.push(there.into_iter().map(|(_, end)| end).collect());
        }
        Ok(divided)
    }

    /// Adds the nodes around a triangle, and the ends of segments there.
    fn go_around(&self, place: u32, divided: &mut Divided, ends: &mut Vec<End>) {
        let of = self.near.triangles[place as usize];
        let corners = self.mesh.triangles()[of as usize];
        for (corner, &edge) in self.near.edges_of[place as usize].iter().enumerate() {
            divided.vertices.push(corners[corner]);
            divided.regions.push(self.regions.of(corners[corner]));
            divided.lines.push(1 << corner | 1 << ((corner + 2) % 3));
            let is_forward = self.near.edges[edge as usize][0] == corners[corner];
            let on = self.own.on(edge);
            let mut add = |at: u32| {
                let hit = self.own.hits[at as usize];
                let is_from_behind = hit.is_first_behind == is_forward;
                let [front, behind] = self.other.sides()[self.other_near.triangles[hit.triangle as usize] as usize];
                // A segment leaves the border with the region before it on its left.
                let sides = if is_from_behind { [behind, front] } else { [front, behind] };
                ends.push(End { with: hit.triangle, node: number(divided.vertices.len()), sides });
                divided.vertices.push(self.own.vertices[at as usize]);
                divided.regions.push(sides[1]);
                divided.lines.push(1 << corner);
            };
            if is_forward {
                on.iter().copied().for_each(&mut add);
            } else {
                on.iter().rev().copied().for_each(&mut add);
            }
        }
    }

    /// Adds a point where an edge of the other mesh passes through: a segment for each triangle at that edge ends
    /// there.
    fn point_inside(&self, hit: Hit, vertex: Vertex, divided: &mut Divided, ends: &mut Vec<End>) {
        let node = number(divided.vertices.len());
        divided.vertices.push(vertex);
        let [first, _] = self.other_near.edges[hit.edge as usize];
        for (with, corner) in self.other_near.uses(hit.edge) {
            let of = self.other_near.triangles[with as usize] as usize;
            let is_forward = self.other.triangles()[of][corner] == first;
            let is_from_behind = hit.is_first_behind == is_forward;
            let [front, behind] = self.other.sides()[of];
            // If the other triangle's own edge comes from the front of this triangle, the other triangle has the region
            // in front of this one on the left of the segment. Seen from the front of this triangle, the region behind
            // the other is then on the left.
            let sides = if is_from_behind { [front, behind] } else { [behind, front] };
            ends.push(End { with, node, sides });
        }
    }

    /// Sorts the ends of segments at an inner point around the edge that passes there, counterclockwise as seen from
    /// the front.
    fn sort_around(&self, hit: Hit, there: &mut Vec<(u32, u32)>) {
        let [u, v] = self.other_near.edges[hit.edge as usize];
        let axis = if hit.is_first_behind { [v, u] } else { [u, v] };
        let mut around: Vec<(Vertex, (u32, u32))> =
            there.iter().map(|&end| (self.apex(end.0, hit.edge), end)).collect();
        radial::sort(self.session, axis, &mut around);
        *there = around.into_iter().map(|(_, end)| end).collect();
    }
}

/// The coordinate plane in which a triangle has the largest area, and true if it is clockwise there.
pub(super) fn projection(session: &dyn Predicates, triangle: [Vertex; 3]) -> Result<(Plane, bool), Contradiction> {
    let [a, b, c] = triangle;
    let [from, to, third] = triangle.map(|v| session.scene().point3(v));
    let area = |i: usize, j: usize| {
        let difference = |p: [f64; 3], k: usize| p[k] / 2.0 - from[k] / 2.0;
        (difference(to, i) * difference(third, j) - difference(to, j) * difference(third, i)).abs()
    };
    let mut planes = [(Plane::Xy, area(0, 1)), (Plane::Yz, area(1, 2)), (Plane::Zx, area(2, 0))];
    planes.sort_by(|a, b| b.1.total_cmp(&a.1));
    let seen = planes.into_iter().map(|(plane, _)| (plane, session.orient2d(plane, a, b, c)));
    let turned = seen.filter(|(_, sign)| !sign.is_zero()).map(|(plane, sign)| (plane, sign == Sign::Negative));
    turned.into_iter().next().ok_or(Contradiction::NoArea)
}
