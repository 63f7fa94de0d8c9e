//! Triangles, cut where others meet them.
//!
//! Triangles of one plane that meet are cut together, so their common part is cut in one way. In their plane the edges
//! of all of them, and the traces of the triangles of other planes that meet one of them, are arranged
//! ([`mod@predicament_overlay::algorithm::overlay`]) and triangulated ([`crate::algorithm::planar`]).
//!
//! A trace may extend beyond the triangle that it cuts, and cross others there. This has no effect: parts outside are
//! left out. Inside, each point of a trace is a point of both triangles, so both are cut at the same points.

use std::collections::BTreeMap;

use predicament_predicates::{Construction, Plane, Predicates, Sign, Vertex};

use super::faces::{Face, side, turn};
use crate::algorithm::limit::Places;
use crate::algorithm::limit::plane::{InPlane, Line};
use crate::algorithm::limit::sheets::view;
use crate::algorithm::overlay::{SurfaceContradiction, Undone};
use crate::algorithm::planar::Points;
use predicament_overlay::algorithm::overlay::{Edge, Method, arrange};

/// Groups of triangles that meet others.
#[derive(Default)]
pub(super) struct Groups {
    /// Indices of triangles of one plane, and of the triangles of other planes that meet one of them; all ascending.
    pub all: Vec<[Vec<u32>; 2]>,
}

impl Groups {
    /// Groups the triangles that meet in pairs; each pair comes with true if it is in one plane.
    pub fn of(pairs: &[([u32; 2], bool)]) -> Groups {
        let mut leaders: BTreeMap<u32, u32> = pairs.iter().flat_map(|(pair, _)| *pair).map(|at| (at, at)).collect();
        let leader = |leaders: &BTreeMap<u32, u32>, mut at: u32| {
            while leaders[&at] != at {
                at = leaders[&at];
            }
            at
        };
        let joined = pairs.iter().filter(|(_, is_coplanar)| *is_coplanar);
        for (pair, _) in joined {
            let [first, second] = pair.map(|at| leader(&leaders, at));
            leaders.insert(first.max(second), first.min(second));
        }
        let mut groups: BTreeMap<u32, [Vec<u32>; 2]> = BTreeMap::new();
        let of: BTreeMap<u32, u32> = leaders.keys().map(|&at| (at, leader(&leaders, at))).collect();
        for (&at, &leader) in &of {
            groups.entry(leader).or_default()[0].push(at);
        }
        for &([first, second], _) in pairs.iter().filter(|(_, is_coplanar)| !is_coplanar) {
            groups.entry(of[&first]).or_default()[1].push(second);
            groups.entry(of[&second]).or_default()[1].push(first);
        }
        let mut all: Vec<[Vec<u32>; 2]> = groups.into_values().collect();
        for [_, others] in &mut all {
            others.sort_unstable();
            others.dedup();
        }
        Groups { all }
    }
}

/// Cuts the triangles of a group; returns the pieces.
pub(super) fn cut(
    session: &mut dyn Predicates,
    places: &mut Places,
    faces: &[Face],
    [members, others]: &[Vec<u32>; 2],
) -> Result<Vec<Face>, Undone> {
    let corners = |&at: &u32| faces[at as usize].corners;
    let own = corners(&members[0]);
    let (plane, _) = view(session, places, own)?;
    let other_corners = others.iter().flat_map(corners);
    let all_corners = faces.iter().flat_map(|face| face.corners);
    let apart = other_corners.chain(all_corners).find(|&v| !side(session, own, v).is_zero());
    // The whole mesh is in one plane.
    let Some(apart) = apart else { return Ok(Vec::new()) };
    let mut segments = Segments::default();
    for [a, b, c] in members.iter().map(corners) {
        [[a, b], [b, c], [c, a]].into_iter().for_each(|ends| segments.add(ends, Line::Edge(ends)));
    }
    let traces: Vec<Trace> = others.iter().map(|at| Trace::of(session, own, corners(at))).collect();
    let crossings = traces.iter().flat_map(|trace| &trace.crossings);
    let definitions: Vec<Construction> = crossings.map(|&line| Construction::Lpi { line, plane: own }).collect();
    let mut constructed = session.construct(&definitions)?.into_iter();
    let mut points = Vec::new();
    for Trace { at, crossings, line } in traces {
        let ends: Vec<Vertex> = at.into_iter().chain(constructed.by_ref().take(crossings.len())).collect();
        match ends[..] {
            [a, b] => segments.add([a, b], line),
            [v] => points.push(v),
            _ => {}
        }
    }
    points.into_iter().for_each(|v| segments.point(v));
    places.extend(session.scene())?;
    let mut flat = InPlane::new(session, places, plane, segments.vertices, (own, apart))
        .ok_or(Undone::Broken(SurfaceContradiction::Plane.into()))?;
    let edges: Vec<Edge> = segments.ends.iter().map(|&[a, b]| Edge::whole(a, b)).collect();
    segments.lines.into_iter().for_each(|(ends, line)| flat.on_line(ends, line));
    let made = arrange(&mut flat, &edges, Method::Grid)?;
    if let Some(rule) = made.broken {
        return Err(Undone::Broken(rule.into()));
    }
    let nodes: Vec<Vertex> = made.vertices.iter().map(|&v| flat.vertex(v)).collect();
    let session = flat.space();
    let members: Vec<Member> = members.iter().map(|at| Member::of(session, plane, faces[*at as usize])).collect();
    let within = |&v: &Vertex| -> Vec<usize> {
        (0..members.len()).filter(|&member| members[member].holds(session, plane, v)).collect()
    };
    // Keeps the nodes that are in triangles of the group.
    let (kept, within): (Vec<usize>, Vec<Vec<usize>>) =
        nodes.iter().map(within).enumerate().filter(|(_, within)| !within.is_empty()).unzip();
    let vertices: Vec<Vertex> = kept.iter().map(|&node| nodes[node]).collect();
    let common = |of: &[u32]| -> Vec<usize> {
        let [first, others @ ..] = of else { return Vec::new() };
        let is_common = |member: &&usize| others.iter().all(|&at| within[at as usize].contains(member));
        within[*first as usize].iter().filter(is_common).copied().collect()
    };
    let place = |node: u32| kept.binary_search(&(node as usize)).ok().and_then(|at| u32::try_from(at).ok());
    let ends = made.pieces.iter().filter_map(|piece| Some([place(piece.ends[0])?, place(piece.ends[1])?]));
    let pieces: Vec<[u32; 2]> = ends.filter(|ends| !common(ends).is_empty()).collect();
    let points = Points { session, plane, vertices: &vertices };
    let triangles = points.triangulated(&pieces).map_err(|broken| Undone::Broken(broken.into()))?;
    let face = |triangle: [u32; 3]| {
        let times: i32 = common(&triangle).into_iter().map(|member| members[member].times).sum();
        let [a, b, c] = triangle.map(|at| vertices[at as usize]);
        let corners = if times < 0 { [a, c, b] } else { [a, b, c] };
        (times != 0).then_some(Face { corners, times: times.abs() })
    };
    let parts = triangles.into_iter().filter_map(face).collect();
    places.extend(session.scene())?;
    Ok(parts)
}

/// A triangle as seen in a coordinate plane.
struct Member {
    /// The corners, counterclockwise there.
    corners: [Vertex; 3],
    /// The number of times that the surface passes it in that orientation.
    times: i32,
}

impl Member {
    fn of(session: &dyn Predicates, plane: Plane, Face { corners: [a, b, c], times }: Face) -> Member {
        match turn(session, plane, [a, b, c]) {
            Sign::Negative => Member { corners: [a, c, b], times: -times },
            _ => Member { corners: [a, b, c], times },
        }
    }

    /// True if a vertex of its plane is in it, or on its border.
    fn holds(&self, session: &dyn Predicates, plane: Plane, v: Vertex) -> bool {
        let [a, b, c] = self.corners;
        [[a, b], [b, c], [c, a]].into_iter().all(|[p, q]| turn(session, plane, [p, q, v]) != Sign::Negative)
    }
}

/// Segments in a plane, by vertices of a planar scene.
#[derive(Default)]
struct Segments {
    /// The vertices in space; a point without segments occurs twice.
    vertices: Vec<Vertex>,
    of: BTreeMap<Vertex, Vertex>,
    ends: Vec<[Vertex; 2]>,
    lines: Vec<([Vertex; 2], Line)>,
}

impl Segments {
    fn vertex(&mut self, v: Vertex) -> Vertex {
        let next = Vertex::input(self.vertices.len());
        let known = *self.of.entry(v).or_insert(next);
        if known == next {
            self.vertices.push(v);
        }
        known
    }

    fn add(&mut self, ends: [Vertex; 2], line: Line) {
        let ends = ends.map(|v| self.vertex(v));
        self.ends.push(ends);
        self.lines.push((ends, line));
    }

    /// Adds a point that may be on no segment, as a segment without length.
    fn point(&mut self, v: Vertex) {
        let first = self.vertex(v);
        let second = Vertex::input(self.vertices.len());
        self.vertices.push(v);
        self.ends.push([first, second]);
    }
}

/// The intersection of a triangle with the plane of another: a segment, a point, or nothing.
struct Trace {
    /// Its corners in the plane.
    at: Vec<Vertex>,
    /// Its edges that cross the plane.
    crossings: Vec<[Vertex; 2]>,
    line: Line,
}

impl Trace {
    fn of(session: &dyn Predicates, plane: [Vertex; 3], triangle: [Vertex; 3]) -> Trace {
        let sides = triangle.map(|v| side(session, plane, v));
        let at: Vec<Vertex> = (0..3).filter(|&i| sides[i].is_zero()).map(|i| triangle[i]).collect();
        let crosses = |&[i, j]: &[usize; 2]| !sides[i].is_zero() && sides[i] == -sides[j];
        let crossings = [[0, 1], [1, 2], [2, 0]].into_iter().filter(crosses);
        let crossings = crossings.map(|edge| edge.map(|i| triangle[i])).collect();
        let line = match at[..] {
            [a, b] => Line::Edge([a, b]),
            _ => Line::Cut(triangle),
        };
        Trace { at, crossings, line }
    }
}
