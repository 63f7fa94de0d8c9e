//! The fourth step for loops that are not in any of the planes, and the fifth step: triangulation of everything.

use std::collections::BTreeMap;

use predicament_mesh::half_edge::{Face, HalfEdge};
use predicament_predicates::Vertex;

use super::cutter::Cutter;
use super::flat::{Flat, divide};
use super::{Contradiction, Part, Sliced, Source};
use predicament_triangulate::algorithm::{Method, projection, triangulate, triangulate_few};

/// The parts while triangles are added.
#[derive(Default)]
struct Parts {
    /// The parts by number; parts without faces are removed at the end.
    parts: Vec<Part>,
    /// The triangles without area, by part.
    flats: BTreeMap<u32, Vec<Flat>>,
    broken: Option<Contradiction>,
}

impl Parts {
    /// Adds triangles of one source to a part. A triangle with a vertex twice is dropped: its three edges cancel each
    /// other. Loops that pass a vertex twice have such triangles.
    fn push(&mut self, part: u32, source: Source, triangles: impl IntoIterator<Item = [Vertex; 3]>) {
        let part = &mut self.parts[part as usize];
        part.triangles.extend(triangles.into_iter().filter(|[a, b, c]| a != b && b != c && c != a));
        part.sources.resize(part.triangles.len(), source);
    }
}

impl Cutter<'_> {
    /// Triangulates the parts; `before` is the number of constructions in the scene before slicing.
    pub(super) fn output(mut self, before: usize) -> Sliced {
        let mut out = Parts { parts: vec![Part::default(); self.parts], ..Parts::default() };
        let faces: Vec<Face> = self.mesh.faces().collect();
        let mut caps: BTreeMap<(usize, u32), Vec<Vec<Vertex>>> = BTreeMap::new();
        for f in faces {
            let first = self.mesh.half_edge_of_face(f);
            let part = self.mesh.vertex_user_data(self.mesh.end(first));
            if let Some(cap) = self.cap_of(f) {
                caps.entry((cap, part)).or_default().push(self.vertices(first));
                continue;
            }
            let source = Source::Face(self.faces[self.mesh.face_user_data(f) as usize]);
            let mut around = self.mesh.loop_of(first);
            if let (Some(a), Some(b), Some(c), None) = (around.next(), around.next(), around.next(), around.next()) {
                let [a, b, c] = [a, b, c].map(|h| self.vertex(h));
                out.push(part, source, [[a, b, c]]);
                continue;
            }
            drop(around);
            let support = self.support(f);
            let around = self.vertices(first);
            self.triangulate(&mut out, part, source, support, &[around]);
        }
        for ((cap, part), loops) in caps {
            let support = self.support(self.caps[cap].faces[0]);
            let plane = u32::try_from(self.caps[cap].plane).expect("a plane's place in a list of vertices");
            self.triangulate(&mut out, part, Source::Cap(plane), support, &loops);
        }
        self.cover_open(&mut out);
        for (part, flats) in out.flats {
            divide(&mut out.parts[part as usize], flats);
        }
        out.parts.retain(|part| !part.triangles.is_empty());
        Sliced {
            parts: out.parts,
            constructions: self.session.scene().constructions()[before..].to_vec(),
            faces_split: self.faces_split,
            broken: out.broken.map(|what| (what, None)),
        }
    }

    /// Triangulates loops in the plane of a support.
    fn triangulate(&self, out: &mut Parts, part: u32, source: Source, support: [Vertex; 3], loops: &[Vec<Vertex>]) {
        let Some((plane, reversed)) = self.seen(support) else {
            out.broken.get_or_insert(Contradiction::NoArea);
            return;
        };
        // A short loop needs turns alone: an order of constructed vertices costs more, most of all where it is a tie.
        let few = match loops {
            [around] => triangulate_few(&*self.session, plane, reversed, around, |_, _, _| false, |_| false),
            _ => None,
        };
        let mut triangles = few.unwrap_or_else(|| {
            let made = triangulate(&*self.session, plane, reversed, loops, Method::Monotone);
            if let Some(what) = made.broken {
                out.broken.get_or_insert(what.into());
            }
            made.triangles
        });
        // Only loops of caps touch themselves and each other, and only if an edge or a vertex is on another cap.
        if self.met_vertices && matches!(source, Source::Cap(_)) {
            triangles.retain(|&triangle| {
                let flat = Flat::of(&*self.session, plane, triangle, source);
                flat.map(|flat| out.flats.entry(part).or_default().push(flat)).is_none()
            });
        }
        out.push(part, source, triangles);
    }

    /// Covers the loops that are still open.
    fn cover_open(&mut self, out: &mut Parts) {
        let firsts: Vec<HalfEdge> = self.mesh.boundary_loops(1).collect();
        for first in firsts {
            let part = self.mesh.vertex_user_data(self.mesh.end(first));
            let around: Vec<Vertex> = self.mesh.vertex_loop(first).map(|v| self.name(v)).collect();
            let loops = std::slice::from_ref(&around);
            let made = projection(&*self.session, loops)
                .map(|(plane, reversed)| triangulate(&*self.session, plane, reversed, loops, Method::Monotone));
            match made {
                Some(made) if made.broken.is_none() => out.push(part, Source::Cover, made.triangles),
                // The loop is not simple from any side, or not for this session.
                _ => out.parts[part as usize].open.push(around),
            }
        }
    }

    /// The vertices of a loop.
    fn vertices(&self, first: HalfEdge) -> Vec<Vertex> {
        self.mesh.loop_of(first).map(|h| self.vertex(h)).collect()
    }

    fn vertex(&self, h: HalfEdge) -> Vertex {
        self.name(self.mesh.end(h))
    }
}
