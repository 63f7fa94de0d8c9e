//! The region of the other mesh that contains each vertex.
//!
//! A vertex is in one region, and so are both ends of an edge that passes through nothing: union-find joins vertices
//! along such edges. If an edge passes through a triangle, the triangle decides the regions of its ends. Vertices
//! beyond the other mesh's box are outside. For each remaining set, one point is located.

use std::collections::BTreeMap;
use std::sync::Arc;

use predicament_grid::Bounds;
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_predicates::{Predicates, Vertex};
use rayon::prelude::*;

use super::near::{Near, number, span};
use super::points::Points;
use super::{Contradiction, Extent, Undone};
use predicament_mesh_locate::algorithm::{Location, MeshIndex, Ray, Scratch, locate_all};

/// The region is not known.
const UNKNOWN: u32 = u32::MAX;
/// The number of vertices in one thread's work item.
const PART: usize = 16384;

/// Sets of vertices, by union-find.
pub(super) struct Sets {
    parent: Vec<u32>,
}

impl Sets {
    /// Sets of one number each.
    pub fn new(count: usize) -> Sets {
        Sets { parent: (0..number(count)).collect() }
    }

    /// The representative of a set.
    pub fn find(&mut self, v: u32) -> u32 {
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

    /// Joins two sets; the larger number is the representative.
    pub fn join(&mut self, a: u32, b: u32) {
        let [a, b] = [self.find(a), self.find(b)];
        self.parent[a.min(b) as usize] = a.max(b);
    }

    /// Finds a representative like [`Sets::find`], without path compression.
    fn found(&self, v: u32) -> u32 {
        let mut at = v;
        while self.parent[at as usize] != at {
            at = self.parent[at as usize];
        }
        at
    }
}

/// The region of the other mesh that contains each vertex of a mesh.
pub(super) struct VertexRegions {
    /// The first vertex of the mesh.
    first: usize,
    of: Vec<u32>,
}

impl VertexRegions {
    pub fn of(&self, v: Vertex) -> u32 {
        self.of[v.index() - self.first]
    }
}

/// The input of the sets.
pub(super) struct Known<'a> {
    pub session: &'a dyn Predicates,
    pub meshes: &'a [Arc<MaterialMesh>; 2],
    pub near: [&'a Near; 2],
    pub points: [&'a Points; 2],
    pub bounds: &'a [Bounds<3>; 2],
    pub extent: Extent,
}

/// For each vertex of either mesh, the region of the other mesh that contains it. The two meshes are two parallel
/// tasks.
pub(super) fn regions(known: &Known<'_>) -> Result<[VertexRegions; 2], Undone> {
    let (first, second) = rayon::join(|| known.of_mesh(0), || known.of_mesh(1));
    Ok([first?, second?])
}

impl Known<'_> {
    fn of_mesh(&self, side: usize) -> Result<VertexRegions, Undone> {
        let triangles = self.meshes[side].triangles();
        let [first, last] = span(&self.meshes[side]);
        // Vertices by their numbers from the first one on, then an entry for the outside.
        let (scene, count) = (self.session.scene(), last + 1 - first);
        let at = |v: Vertex| number(v.index() - first);
        let outside = number(count);
        let parent = |v: usize| {
            let p = scene.point3(Vertex::input(first + v));
            let here = Bounds { low: p, high: p };
            if self.bounds[1 - side].is_near(&here, 0.0) { number(v) } else { outside }
        };
        let mut parents: Vec<u32> = (0..count).into_par_iter().with_min_len(PART).map(parent).collect();
        parents.push(outside);
        let mut sets = Sets { parent: parents };
        self.join(side, &mut sets, &at, outside);
        let mut of_root = vec![UNKNOWN; count + 1];
        of_root[outside as usize] = OUTSIDE;
        for (v, region) in self.told(side) {
            let root = sets.find(at(v)) as usize;
            if of_root[root] != UNKNOWN && of_root[root] != region {
                return Err(Undone::Broken(Contradiction::OneRegion));
            }
            of_root[root] = region;
        }
        let mut unknown: BTreeMap<u32, Vertex> = BTreeMap::new();
        for &[v, ..] in triangles {
            let root = sets.find(at(v));
            if of_root[root as usize] == UNKNOWN {
                unknown.entry(root).or_insert(v);
            }
        }
        for (root, region) in self.located(&self.meshes[1 - side], unknown)? {
            of_root[root as usize] = region;
        }
        let of = |v: usize| of_root[sets.found(number(v)) as usize];
        Ok(VertexRegions { first, of: (0..count).into_par_iter().with_min_len(PART).map(of).collect() })
    }

    /// Joins the ends of edges that pass through nothing.
    fn join(&self, side: usize, sets: &mut Sets, at: &impl Fn(Vertex) -> u32, outside: u32) {
        let (near, points) = (self.near[side], self.points[side]);
        let mut at_cut = vec![false; outside as usize];
        for hit in &points.hits {
            near.edges[hit.edge as usize].iter().for_each(|&v| at_cut[at(v) as usize] = true);
        }
        let is_cut = |a: Vertex, b: Vertex| {
            at_cut[at(a) as usize]
                && at_cut[at(b) as usize]
                && near.edge(a, b).is_some_and(|edge| !points.on(edge).is_empty())
        };
        for &[a, b, c] in self.meshes[side].triangles() {
            if [a, b, c].iter().all(|&v| sets.parent[at(v) as usize] == outside) {
                continue;
            }
            for [a, b] in [[a, b], [b, c], [c, a]] {
                if !is_cut(a, b) {
                    sets.join(at(a), at(b));
                }
            }
        }
    }

    /// The regions of the ends of edges that pass through triangles.
    fn told(&self, side: usize) -> Vec<(Vertex, u32)> {
        let (meshes, near, points) = (self.meshes, self.near, self.points);
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
    fn located(&self, mesh: &Arc<MaterialMesh>, unknown: BTreeMap<u32, Vertex>) -> Result<Vec<(u32, u32)>, Undone> {
        if unknown.is_empty() {
            return Ok(Vec::new());
        }
        let queries: Vec<Vertex> = unknown.values().copied().collect();
        let locations = locations(self.session, mesh, &queries, self.extent);
        let region = |(root, location)| match location {
            Location::In(region) => Ok((root, region)),
            Location::On(_) | Location::Contradiction | Location::Undecided => {
                Err(Undone::Broken(Contradiction::VertexRegion))
            }
        };
        unknown.into_keys().zip(locations).map(region).collect()
    }
}

/// The locations of vertices in a mesh.
pub(super) fn locations(
    session: &dyn Predicates,
    mesh: &Arc<MaterialMesh>,
    queries: &[Vertex],
    extent: Extent,
) -> Vec<Location> {
    if queries.is_empty() {
        return Vec::new();
    }
    let index = MeshIndex::new(Arc::clone(mesh), session.scene());
    match extent {
        Extent::Whole => locate_all(&index, session, queries, &|_| true),
        // The cells without triangles have no known region; a ray straight up stays in the column.
        Extent::Columns => {
            let up = |&q: &Vertex| index.question(session, q, Ray::UP, &mut Scratch::default());
            predicament_grid::parallel::all(queries, &up)
        }
    }
}
