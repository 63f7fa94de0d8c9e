//! The second step: faces are split between their vertices on the plane.
//!
//! Take the line where face and plane meet, and its part between two vertices of the face. That part is inside the face
//! if two counts up to there are odd: of the edges that went off to the positive side, and of those that went off to
//! the negative side. If only one count is odd, an edge lies there. A cap is one face of several loops, and these loops
//! can touch: corners in one point are taken in the order in which the line passes them, and may be joined by an edge
//! without length. Where two loops have an edge in common both counts are odd, and nothing is to be split.

use std::collections::BTreeMap;

use predicament_mesh::half_edge::{Face, HalfEdge, MeshVertex, OperationError};
use predicament_predicates::{Axis, Sign, Vertex};

use super::cutter::Cutter;
use super::lines::{Line, OWN_ENDS};
use super::projection::cross;
use super::{Contradiction, Halt};
use predicament_grid::sort::sort_by_sign;

/// A vertex of a face on the plane: the half-edge that ends there, and the sides of the vertices before and after it.
#[derive(Clone, Copy)]
struct Corner {
    at: HalfEdge,
    /// The half-edge that arrives from another point: `at`, or the one before the edges without length that end there.
    first: HalfEdge,
    before: Sign,
    after: Sign,
    /// The number of its edges on the line ahead, less those behind.
    ahead: i32,
}

/// Data that all chords of a face have in common.
struct Split {
    cap: Option<usize>,
    support: [Vertex; 3],
    plane: [Vertex; 3],
    /// The user data of the chords' half-edges, if the chords need an entry in the list of lines.
    line: Option<u32>,
}

impl Cutter<'_> {
    /// Splits the faces at these vertices, and returns all faces that touch the plane afterwards.
    pub(super) fn split_faces(&mut self, place: usize, on_plane: &[MeshVertex]) -> Result<Vec<Face>, Halt> {
        let mesh = &self.mesh;
        let mut touched: Vec<Face> = on_plane.iter().flat_map(|&v| mesh.ring(v).filter_map(|h| mesh.face(h))).collect();
        // Faces of one cap form a group; any other face is a group alone.
        let group = |f: &Face| self.cap_of(*f).map_or((f.index(), 0), |cap| (usize::MAX, cap));
        touched.sort_unstable_by_key(|f| (group(f), *f));
        touched.dedup();
        let groups: Vec<Vec<Face>> = touched.chunk_by(|f, g| group(f) == group(g)).map(<[Face]>::to_vec).collect();
        touched.clear();
        for mut faces in groups {
            self.split_group(place, &mut faces)?;
            touched.append(&mut faces);
        }
        Ok(touched)
    }

    /// Splits a face, or a cap of several loops, and replaces `faces` by the pieces.
    fn split_group(&mut self, place: usize, faces: &mut Vec<Face>) -> Result<(), Halt> {
        let mut corners = Vec::new();
        let (mut below, mut above) = (None, None);
        for &f in &*faces {
            for h in self.mesh.loop_of(self.mesh.half_edge_of_face(f)) {
                match self.sign(self.mesh.end(h)) {
                    Sign::Negative => below = Some(self.mesh.end(h)),
                    Sign::Positive => above = Some(self.mesh.end(h)),
                    Sign::Zero => {
                        let [before, after] = [self.mesh.start(h), self.mesh.end(self.mesh.next(h))];
                        let [before, after] = [before, after].map(|v| self.sign(v));
                        corners.push(Corner { at: h, first: h, before, after, ahead: 0 });
                    }
                }
            }
        }
        let (Some(_), Some(above)) = (below, above) else { return Ok(()) };
        let mut split = Split {
            cap: self.cap_of(faces[0]),
            support: self.support(faces[0]),
            plane: self.planes[place],
            line: None,
        };
        let (ends, up) = self.sort_along(&mut corners, &split, above);
        self.count_ahead(&mut corners, &ends);
        self.faces_split += 1;
        self.join(&corners, &ends, up, &mut split, faces)
    }

    /// Sorts corners along the line. Returns the ends of the groups in one point, and the side that is up: on the left
    /// of the line, as the inside of the face is on the left of its edges. `above` is a vertex on the positive side.
    fn sort_along(&self, corners: &mut [Corner], split: &Split, above: MeshVertex) -> (Vec<usize>, Sign) {
        // Two corners need no order.
        let as_they_are = (1..=corners.len()).collect();
        if corners.len() < 3 {
            return (as_they_are, Sign::Positive);
        }
        let direction = cross(self.normal(split.support), self.normal(split.plane));
        let mut axes = [(Axis::X, direction[0]), (Axis::Y, direction[1]), (Axis::Z, direction[2])];
        axes.sort_by(|p, q| q.1.abs().total_cmp(&p.1.abs()));
        let vertex = |corner: &Corner| self.mesh.scene_vertex(self.mesh.end(corner.at));
        let first = vertex(&corners[0]);
        let tells = |axis| corners.iter().any(|corner| !self.session.compare(axis, vertex(corner), first).is_zero());
        let Some(axis) = axes.into_iter().map(|(axis, _)| axis).find(|&axis| tells(axis)) else {
            return (as_they_are, Sign::Positive);
        };
        sort_by_sign(corners, |a, b| self.session.compare(axis, vertex(&a), vertex(&b)));
        let apart = |at: usize| !self.session.compare(axis, vertex(&corners[at - 1]), vertex(&corners[at])).is_zero();
        let ends = (1..corners.len()).filter(|&at| apart(at)).chain([corners.len()]).collect();
        let up =
            self.turn(split, [vertex(&corners[0]), vertex(&corners[corners.len() - 1])], self.mesh.scene_vertex(above));
        (ends, if up == Sign::Negative { Sign::Negative } else { Sign::Positive })
    }

    /// Counts the edges of each corner that are on the line.
    fn count_ahead(&self, corners: &mut [Corner], ends: &[usize]) {
        if corners.iter().all(|corner| !corner.after.is_zero()) {
            return;
        }
        let group = |at: usize| ends.partition_point(|&end| end <= at);
        let of: BTreeMap<HalfEdge, usize> = corners.iter().map(|corner| corner.at).zip(0..).collect();
        for at in 0..corners.len() {
            if let Some(&next) = of.get(&self.mesh.next(corners[at].at)) {
                let ahead = i32::from(group(at) < group(next)) - i32::from(group(at) > group(next));
                corners[at].ahead += ahead;
                corners[next].ahead -= ahead;
            }
        }
    }

    /// The turn of three vertices, as the face is seen from outside.
    fn turn(&self, split: &Split, [a, b]: [Vertex; 2], c: Vertex) -> Sign {
        let Some((plane, reversed)) = self.seen(split.support) else { return Sign::Zero };
        let turn = self.session.orient2d(plane, a, b, c);
        if reversed { -turn } else { turn }
    }

    /// Joins the corners between which the line is inside; `ends` are the ends of the groups in one point.
    fn join(
        &mut self,
        corners: &[Corner],
        ends: &[usize],
        up: Sign,
        split: &mut Split,
        faces: &mut Vec<Face>,
    ) -> Result<(), Halt> {
        let mut inside = [false; 2];
        // The number of edges on the line from the last corner on.
        let mut edges = 0;
        let mut from: Option<HalfEdge> = None;
        let mut start = 0;
        for &end in ends {
            let mut here = corners[start..end].to_vec();
            start = end;
            self.merge(&mut here);
            let alone = here.len() == 1;
            while !here.is_empty() {
                let corner = here.remove(next_in_point(&here, inside == [true; 2], up));
                let arrived = match from {
                    // A corner in one point with others, which the line does not pass through.
                    Some(_) if !alone && !self.may_open(split, &corner) => continue,
                    Some(from) => Some(self.chord(from, corner.at, split, faces)?),
                    None => None,
                };
                for (inside, side) in inside.iter_mut().zip([Sign::Negative, Sign::Positive]) {
                    *inside ^= (corner.before == side) ^ (corner.after == side);
                }
                edges += corner.ahead;
                from = (inside == [true; 2] && edges == 0).then(|| match arrived {
                    // The chord that arrives divides the corner: the line continues from the half that is open to the
                    // right.
                    Some(chord) if corner.before != up => chord,
                    _ => corner.at,
                });
            }
        }
        if inside == [false; 2] { Ok(()) } else { Err(Halt::Broken(Contradiction::Crossings)) }
    }

    /// Merges corners in one point that edges without length join.
    fn merge(&self, here: &mut Vec<Corner>) {
        let mut at = 0;
        while at < here.len() {
            let next = self.mesh.next(here[at].at);
            match here.iter().position(|other| other.first == next).filter(|&other| other != at) {
                Some(other) => {
                    let Corner { before, first, ahead, .. } = here[at];
                    let ahead = here[other].ahead + ahead;
                    here[other] = Corner { before, first, ahead, ..here[other] };
                    here.remove(at);
                }
                None => at += 1,
            }
        }
    }

    /// True if the line may pass through the inside at a corner; false if the corner touches the line with a convex
    /// angle.
    fn may_open(&self, split: &Split, corner: &Corner) -> bool {
        if corner.before != corner.after {
            return true;
        }
        let [a, b, c] =
            [self.mesh.start(corner.first), self.mesh.end(corner.at), self.mesh.end(self.mesh.next(corner.at))]
                .map(|v| self.mesh.scene_vertex(v));
        self.turn(split, [a, b], c) == Sign::Negative
    }

    /// Adds an edge between two corners, and returns the half-edge in that direction.
    fn chord(
        &mut self,
        from: HalfEdge,
        to: HalfEdge,
        split: &mut Split,
        faces: &mut Vec<Face>,
    ) -> Result<HalfEdge, Halt> {
        let (Some(f), Some(g)) = (self.mesh.face(from), self.mesh.face(to)) else {
            return Err(Halt::Broken(Contradiction::Across));
        };
        if f != g {
            let Some(cap) = split.cap else { return Err(Halt::Broken(Contradiction::Across)) };
            // A hole becomes a part of the loop around it.
            self.mesh.open_face(g)?;
            faces.retain(|&face| face != g);
            self.caps[cap].faces.retain(|&face| face != g);
        }
        let made = if f == g { self.mesh.split_face(from, to) } else { self.mesh.insert_auxiliary_edge(from, to) };
        let [h, back] = match made {
            Ok(h) => [h, self.mesh.opposite(h)],
            Err(OperationError::EdgeExists(edge)) => {
                // The part touches itself along an edge in a cap, and is divided there.
                let (edges, divided) = self.mesh.divide_at_edge(from, to, edge)?;
                self.see_new_vertices(&divided);
                edges
            }
            Err(why) => return Err(why.into()),
        };
        if f == g
            && let Some(new) = self.mesh.face(back)
        {
            self.mesh.set_face_user_data(new, self.mesh.face_user_data(f));
            faces.push(new);
            if let Some(cap) = split.cap {
                self.caps[cap].faces.push(new);
            }
        }
        let ends = [from, to].map(|h| self.mesh.end(h));
        // Only loops of caps touch themselves and each other.
        if self.met_vertices && split.cap.is_some() {
            self.see_length(ends);
        }
        let of_inputs = !ends.iter().any(|&v| self.mesh.scene_vertex(v).is_constructed());
        let line = match split.line {
            _ if of_inputs => OWN_ENDS,
            Some(line) => line,
            None => self.lines.add(Line::Planes([split.support, split.plane])),
        };
        if !of_inputs {
            split.line = Some(line);
        }
        for half in [h, back] {
            self.mesh.set_user_data(half, line);
            self.mesh.set_user_data(self.mesh.opposite(half), line);
        }
        Ok(h)
    }
}

/// The index of the corner that the line passes next, among corners in one point.
///
/// Corners with an edge behind come first. Then the line leaves the inside, if it is there on both sides; otherwise it
/// enters first: the inside may be as narrow as a point between the two corners. Corners that it only touches come
/// later, and corners with an edge ahead after others of their kind.
fn next_in_point(here: &[Corner], is_inside: bool, up: Sign) -> usize {
    let rank = |&at: &usize| {
        let Corner { before, after, ahead, .. } = here[at];
        // Less if the line leaves the inside here, greater if it enters.
        let way = (before * up).cmp(&(after * up));
        (ahead >= 0, if is_inside { way } else { way.reverse() }, ahead)
    };
    (0..here.len()).min_by_key(rank).unwrap_or(0)
}
