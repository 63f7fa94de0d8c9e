//! The region of the other mesh that each vertex is in.
//!
//! A vertex is in one region, and so are both ends of an edge that passes through nothing: sets of vertices are joined along such
//! edges. Where an edge passes through a triangle, the triangle tells the regions of its ends; vertices beyond the other mesh's box are outside.
//! One point of each set that neither tells about is located.

use std::collections::BTreeMap;
use std::sync::Arc;

use predicament_grid::Bounds;
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_predicates::{Predicates, Vertex};
use rayon::prelude::*;

use super::Undone;
use super::near::{Near, number};
use super::planted::Wrong;
use super::points::Points;
use crate::mesh_locate::{Location, MeshIndex, locate_all};

/// No region is known.
const UNKNOWN: u32 = u32::MAX;
/// Vertices that one thread takes at a time.
const PART: usize = 16384;
/// The invariant of sets of vertices.
const ONE_REGION: &str = "vertices that no triangle parts are in one region";

/// Vertices in sets.
struct Sets {
    parent: Vec<u32>,
}

impl Sets {
    fn find(&mut self, v: u32) -> u32 {
        let mut at = v;
        loop {
            let up = self.parent[at as usize];
            if up == at {
                return at;
            }
            let above = self.parent[up as usize];
            self.parent[at as usize] = above;
            at = above;
        }
    }

    /// Joins two sets; the larger number stands for both.
    fn join(&mut self, a: u32, b: u32) {
        let [a, b] = [self.find(a), self.find(b)];
        self.parent[a.min(b) as usize] = a.max(b);
    }

    /// [`Sets::find`] without a change.
    fn found(&self, v: u32) -> u32 {
        let mut at = v;
        while self.parent[at as usize] != at {
            at = self.parent[at as usize];
        }
        at
    }
}

/// For each vertex of the scene the region of the other mesh that it is in; of vertices of no triangle any.
pub(super) fn regions(
    session: &dyn Predicates,
    meshes: &[Arc<MaterialMesh>; 2],
    near: [&Near; 2],
    points: [&Points; 2],
    bounds: &[Bounds<3>; 2],
    wrong: Wrong,
) -> Result<Vec<u32>, Undone> {
    let scene = session.scene();
    let outside = number(scene.len());
    let parent = |v: usize| {
        let p = scene.point3(Vertex::input(v));
        let here = Bounds { low: p, high: p };
        if bounds.iter().all(|bounds| bounds.is_near(&here, 0.0)) { number(v) } else { outside }
    };
    let mut parents: Vec<u32> = (0..scene.len()).into_par_iter().with_min_len(PART).map(parent).collect();
    parents.push(outside);
    let mut sets = Sets { parent: parents };
    let mut at_cut = vec![false; scene.len()];
    for side in 0..2 {
        for hit in &points[side].hits {
            near[side].edges[hit.edge as usize].iter().for_each(|v| at_cut[v.index()] = true);
        }
    }
    for side in 0..2 {
        let is_cut = |a: Vertex, b: Vertex| {
            at_cut[a.index()]
                && at_cut[b.index()]
                && near[side].edge(a, b).is_some_and(|edge| !points[side].on(edge).is_empty())
        };
        for &[a, b, c] in meshes[side].triangles() {
            if [a, b, c].iter().all(|v| sets.parent[v.index()] == outside) {
                continue;
            }
            for [a, b] in [[a, b], [b, c], [c, a]] {
                if !is_cut(a, b) {
                    sets.join(number(a.index()), number(b.index()));
                }
            }
        }
    }
    let mut of_root = vec![UNKNOWN; scene.len() + 1];
    of_root[outside as usize] = OUTSIDE;
    for side in 0..2 {
        for (v, region) in known(meshes, near, points, side) {
            let root = sets.find(number(v.index())) as usize;
            if of_root[root] != UNKNOWN && of_root[root] != region {
                return Err(Undone::Broken(ONE_REGION));
            }
            of_root[root] = region;
        }
    }
    for side in 0..2 {
        let mut unknown: BTreeMap<u32, Vertex> = BTreeMap::new();
        for &[v, ..] in meshes[side].triangles() {
            let root = sets.find(number(v.index()));
            if of_root[root as usize] == UNKNOWN {
                unknown.entry(root).or_insert(v);
            }
        }
        for (root, region) in located(session, &meshes[1 - side], unknown, wrong)? {
            of_root[root as usize] = region;
        }
    }
    let of = |v: usize| of_root[sets.found(number(v)) as usize];
    Ok((0..scene.len()).into_par_iter().with_min_len(PART).map(of).collect())
}

/// The regions that the ends of edges are in which pass through triangles.
fn known(meshes: &[Arc<MaterialMesh>; 2], near: [&Near; 2], points: [&Points; 2], side: usize) -> Vec<(Vertex, u32)> {
    let mut known = Vec::new();
    let region = |at: u32, is_first: bool| {
        let hit = points[side].hits[at as usize];
        let [front, behind] = meshes[1 - side].sides()[near[1 - side].triangles[hit.triangle as usize] as usize];
        if hit.is_first_behind == is_first { behind } else { front }
    };
    for (edge, ends) in (0..).zip(&near[side].edges) {
        if let [first, .., last] | [first @ last] = points[side].on(edge) {
            known.extend([(ends[0], region(*first, true)), (ends[1], region(*last, false))]);
        }
    }
    known
}

/// Locates one vertex of each set.
fn located(
    session: &dyn Predicates,
    mesh: &Arc<MaterialMesh>,
    unknown: BTreeMap<u32, Vertex>,
    wrong: Wrong,
) -> Result<Vec<(u32, u32)>, Undone> {
    if unknown.is_empty() {
        return Ok(Vec::new());
    }
    if wrong == Wrong::TakesComponentsForOutside {
        return Ok(unknown.into_keys().map(|root| (root, OUTSIDE)).collect());
    }
    let index = MeshIndex::new(Arc::clone(mesh), session.scene());
    let queries: Vec<Vertex> = unknown.values().copied().collect();
    let locations = locate_all(&index, session, &queries, &|_| true);
    let region = |(root, location)| match location {
        Location::In(region) => Ok((root, region)),
        Location::On(_) | Location::Contradiction => Err(Undone::Broken("a vertex is in one region of the other mesh")),
    };
    unknown.into_keys().zip(locations).map(region).collect()
}
