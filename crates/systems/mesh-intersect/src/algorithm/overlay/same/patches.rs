//! Patches of a mesh that are graphs over the yz plane.
//!
//! Let K be a connected part of a closed surface. Seen along x, the triangles around each of its vertices turn the same
//! way and go around the vertex once. Let the edges at which K ends be loops without a common vertex, whose images in
//! the plane are simple and have no point in common. Then no two points of K have one image:
//!
//! - Angles around a vertex inside K add up to a full turn. The turns along the loops, with K to the left, then add up
//!   to χ = 2 − 2g − p − m full turns, for the genus g and p + m loops (Gauss and Bonnet). A simple loop makes one full
//!   turn: p of them are counterclockwise, m clockwise. So p − m = 2 − 2g − p − m, and p = 1 − g.
//! - The triangles turn the same way, counterclockwise here. So the number of triangles above a point that is on no
//!   edge is the number of its counterclockwise loops less the number of its clockwise ones. As p ≤ 1, it is one at
//!   most.
//! - Two points with one image are not both on loops. The triangles around the one that is not cover its image, and
//!   some triangles at the other cover a part of that too, which would be covered twice.
//!
//! (Volino and Magnenat-Thalmann, *Efficient self-collision detection on smoothly discretized surface animations using
//! geometrical shape regularity*, 1994, skip such parts of cloth, and take the condition about loops for granted.)

use predicament_grid::{Bounds, Columns};
use predicament_mesh::MaterialMesh;
use predicament_predicates::Scene;

use super::super::meet::do_meet;
use super::super::near::number;
use super::super::regions::Sets;
use super::super::table::NONE;
use super::Vertices;
use super::apart::turn;

/// The minimum size of a patch: one in this number of all triangles.
const SHARE: usize = 32;
/// The number of pairs of edges that are tested, for each edge on average, before all patches are given up.
const PAIRS: usize = 64;

/// Large patches, and the triangles that are in none of them.
pub(super) struct Patches {
    /// For each triangle, the number of its patch, or [`NONE`].
    of: Vec<u32>,
    /// The boxes of all patches, and last the box of the triangles without a patch.
    bounds: Vec<Bounds<3>>,
}

impl Patches {
    /// The patches of some triangles of a mesh. At each vertex of theirs, all triangles of the mesh turn the same way
    /// and go around it once.
    pub(super) fn of(
        scene: &Scene,
        mesh: &MaterialMesh,
        vertices: Vertices,
        of: &[u32],
        boxes: &[Bounds<3>],
    ) -> Patches {
        let corners = |at: u32| mesh.triangles()[at as usize].map(|v| number(vertices.place(v)));
        let mut by_vertex = large_parts(vertices.count, of.len() / SHARE, &|| of.iter().map(|&at| corners(at)));
        let edges = boundary(mesh.triangles().len(), of, &corners, &by_vertex);
        let image = |v: u32| {
            let [_, y, z] = scene.point3(vertices.vertex(v as usize));
            [y, z]
        };
        let is_simple = are_simple(&edges, &image, &by_vertex);
        for patch in by_vertex.iter_mut().filter(|patch| **patch != NONE && !is_simple[**patch as usize]) {
            *patch = NONE;
        }
        let none = is_simple.len();
        let mut bounds = vec![Bounds::NOTHING; none + 1];
        let patch_of = |(&at, own): (&u32, &Bounds<3>)| {
            let patch = by_vertex[corners(at)[0] as usize];
            let all = &mut bounds[if patch == NONE { none } else { patch as usize }];
            *all = all.union(own);
            patch
        };
        let of = of.iter().zip(boxes).map(patch_of).collect();
        Patches { of, bounds }
    }

    /// The number of a triangle's patch, or [`NONE`].
    pub(super) fn patch(&self, place: usize) -> u32 {
        self.of[place]
    }

    /// True if a triangle is in no patch, or its box meets that of another patch.
    pub(super) fn is_near_others(&self, place: usize, own: &Bounds<3>) -> bool {
        let patch = self.of[place];
        patch == NONE || self.bounds.iter().zip(0..).any(|(other, at)| at != patch && do_meet(own, other))
    }
}

/// For each vertex, the number of its connected part, or [`NONE`] if that has fewer than `least` triangles.
fn large_parts<I: Iterator<Item = [u32; 3]>>(vertices: usize, least: usize, triangles: &dyn Fn() -> I) -> Vec<u32> {
    let mut sets = Sets::new(vertices);
    for [a, b, c] in triangles() {
        sets.join(a, b);
        sets.join(b, c);
    }
    let mut sizes = vec![0_usize; vertices];
    for [a, ..] in triangles() {
        sizes[sets.find(a) as usize] += 1;
    }
    let mut parts = 0;
    let mut number_of = |size: usize| {
        let is_large = size >= least.max(1);
        parts += u32::from(is_large);
        if is_large { parts - 1 } else { NONE }
    };
    let numbers: Vec<u32> = sizes.into_iter().map(&mut number_of).collect();
    (0..number(vertices)).map(|v| numbers[sets.find(v) as usize]).collect()
}

/// The edges at which patches end: those with one triangle that is in no patch; each from vertex to vertex with its
/// patch on the left.
fn boundary(count: usize, of: &[u32], corners: &dyn Fn(u32) -> [u32; 3], by_vertex: &[u32]) -> Vec<[u32; 2]> {
    let mut within = of.iter().copied().peekable();
    let mut edges: Vec<([u32; 2], bool)> = Vec::new();
    for at in 0..number(count) {
        if within.next_if_eq(&at).is_some() {
            continue;
        }
        let [a, b, c] = corners(at);
        for [u, v] in [[a, b], [b, c], [c, a]] {
            let patch = by_vertex[u as usize];
            if patch != NONE && patch == by_vertex[v as usize] {
                edges.push(([u.min(v), u.max(v)], u < v));
            }
        }
    }
    // An edge that comes twice has both its triangles outside.
    edges.sort_unstable();
    let once = edges.chunk_by(|a, b| a.0 == b.0).filter(|uses| uses.len() == 1);
    once.map(|uses| {
        let ([u, v], is_up) = uses[0];
        if is_up { [v, u] } else { [u, v] }
    })
    .collect()
}

/// For each patch, true if its edges are certainly loops without a common vertex, whose images are simple and have no
/// point in common.
fn are_simple(edges: &[[u32; 2]], image: &dyn Fn(u32) -> [f64; 2], by_vertex: &[u32]) -> Vec<bool> {
    let patches = by_vertex.iter().filter(|patch| **patch != NONE).max().map_or(0, |most| *most as usize + 1);
    let mut is_simple = vec![true; patches];
    let mut is_start = vec![false; by_vertex.len()];
    for &[from, _] in edges {
        if std::mem::replace(&mut is_start[from as usize], true) {
            is_simple[by_vertex[from as usize] as usize] = false;
        }
    }
    let images: Vec<[[f64; 2]; 2]> = edges.iter().map(|edge| edge.map(image)).collect();
    let columns = Columns::new(&images);
    let pairs = (0..columns.count()).flat_map(|column| columns.overlaps(column));
    for (pair, tested) in pairs.zip(0..) {
        if tested > PAIRS * edges.len() {
            return vec![false; patches];
        }
        let [first, second] = pair.map(|edge| edges[edge as usize]);
        let [patch, other] = [first, second].map(|edge| by_vertex[edge[0] as usize]);
        if patch == other
            && !first.iter().any(|v| second.contains(v))
            && !are_apart(pair.map(|edge| images[edge as usize]))
        {
            is_simple[patch as usize] = false;
        }
    }
    is_simple
}

/// True if the line of one of two segments certainly has the other strictly on one side.
fn are_apart([s, t]: [[[f64; 2]; 2]; 2]) -> bool {
    let is_beside =
        |[a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]| turn(a, b, c).is_some_and(|side| turn(a, b, d) == Some(side));
    is_beside(s, t) || is_beside(t, s)
}

#[cfg(test)]
mod tests;
