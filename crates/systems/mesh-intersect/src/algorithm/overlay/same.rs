//! Shared triangles of both meshes: pairs that certainly do not pass through each other are set aside.
//!
//! The case is a mesh overlaid with itself, or with a part cut from it. Each edge is then tied with all triangles
//! around it, and hardly any of them meet once one of the meshes has moved. This module finds shared triangles by their
//! coordinates, and sets them aside if that can be decided without a tie.
//!
//! # What is set aside
//! Let S be the surface of one mesh, and S + δ the same surface in the other, δ = η·(ε, ε², ε³) or its opposite.
//!
//! - *Around a vertex.* Seen along x, the triangles around it all turn the same way and go around it once: they are a
//!   graph over a polygon of the yz plane. Its x differs by at most some L times the distance in that plane; moved by δ
//!   it is above itself by at least η·(ε − L(ε² + ε³)), and does not meet itself. Two triangles that have a corner in
//!   common are both around that corner.
//! - *Elsewhere.* An edge and a triangle that are apart are apart after a small enough move. A triangle is set aside
//!   only if it is apart from all other such triangles that it has no corner in common with ([`apart`]). Large parts of
//!   the surface are graphs over the yz plane as a whole ([`patches`]); their triangles are apart from each other.
//!
//! Hence an edge of a triangle that is set aside in one mesh does not pass through a triangle that is set aside in the
//! other. All other pairs are tested. The surface is closed, so that the triangles around a vertex are loops; a loop
//! whose triangles turn the same way crosses a ray as often as it goes around.

mod apart;
mod patches;

use std::sync::OnceLock;

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Plane, Predicates, Scene, Sign, Vertex};

use super::near::{number, span};
use super::table::{NONE, Table, bits};

/// The minimum size of a mesh; smaller meshes are tested in full.
const FEWEST: usize = 4096;
/// The number of sampled vertices before all are compared.
const SAMPLE: usize = 256;
/// The minimum share that must be found, one in this number, of the sample and of all triangles.
const SHARE: usize = 8;
/// The number of vertices or triangles in one thread's work item.
const PART: usize = 4096;

/// The triangles of either mesh that must be tested, ascending: all except those set aside. `None` if setting aside is
/// not worthwhile, or the session is not known to move a mesh as a whole.
pub(super) fn asked_about(session: &dyn Predicates, meshes: [&MaterialMesh; 2]) -> Option<[Vec<u32>; 2]> {
    let is_one_surface = |mesh: &MaterialMesh| mesh.sides().iter().all(|sides| sides == &mesh.sides()[0]);
    let is_large = meshes.iter().all(|mesh| mesh.triangles().len() >= FEWEST);
    if !session.allows("set-aside") || !session.moves_second_mesh() || !is_large || !is_one_surface(meshes[0]) {
        return None;
    }
    let scene = session.scene();
    let [first, second] = meshes.map(Vertices::of);
    if !is_worth_it(scene, first, second) {
        return None;
    }
    let same = same_triangles(meshes, first, second, &same_vertices(scene, first, second));
    let mut is_same = vec![false; meshes[0].triangles().len()];
    same.iter().filter(|&&at| at != NONE).for_each(|&at| is_same[at as usize] = true);
    let clear = clear_vertices(session, meshes[0], first);
    let is_clear = |at: usize| meshes[0].triangles()[at].iter().all(|&v| clear[first.place(v)]);
    let candidates: Vec<u32> = (0..is_same.len()).filter(|&at| is_same[at] && is_clear(at)).map(number).collect();
    if candidates.len() < is_same.len() / SHARE {
        return None;
    }
    let mut aside = vec![false; is_same.len()];
    for (&at, is_apart) in candidates.iter().zip(apart::apart(scene, meshes[0], first, &candidates)) {
        aside[at as usize] = is_apart;
    }
    let asked =
        |count: usize, is_aside: &dyn Fn(usize) -> bool| (0..count).filter(|&at| !is_aside(at)).map(number).collect();
    Some([asked(aside.len(), &|at| aside[at]), asked(same.len(), &|at| same[at] != NONE && aside[same[at] as usize])])
}

/// True if both meshes are large, share many vertices, and a vertex of one at a corner of the other is in the plane of
/// a triangle there: zeros mean zero, and the meshes touch.
pub(super) fn do_touch(session: &dyn Predicates, meshes: [&MaterialMesh; 2]) -> bool {
    if session.moves_second_mesh() || meshes.iter().any(|mesh| mesh.triangles().len() < FEWEST) {
        return false;
    }
    let scene = session.scene();
    let [first, second] = meshes.map(Vertices::of);
    if !is_worth_it(scene, first, second) {
        return false;
    }
    let same = same_vertices(scene, first, second);
    let Some(at) = same.iter().position(|&at| at != NONE) else { return false };
    let (corner, v) = (first.vertex(same[at] as usize), second.vertex(at));
    let triangle = meshes[0].triangles().iter().find(|triangle| triangle.contains(&corner));
    triangle.is_some_and(|&[a, b, c]| session.orient3d(a, b, c, v).is_zero())
}

/// For each triangle of either mesh, the other mesh's triangle with corners at the same positions.
pub(super) fn twins(scene: &Scene, meshes: [&MaterialMesh; 2]) -> [Vec<Option<u32>>; 2] {
    let [first, second] = meshes.map(Vertices::of);
    let same = same_triangles(meshes, first, second, &same_vertices(scene, first, second));
    let mut of_first = vec![None; meshes[0].triangles().len()];
    for (&at, twin) in same.iter().zip(0..).filter(|(at, _)| **at != NONE) {
        of_first[at as usize] = Some(twin);
    }
    [of_first, same.into_iter().map(|at| (at != NONE).then_some(at)).collect()]
}

/// The range of a mesh's vertices, from the first to the last.
#[derive(Clone, Copy)]
struct Vertices {
    first: usize,
    count: usize,
}

impl Vertices {
    fn of(mesh: &MaterialMesh) -> Vertices {
        let [first, last] = span(mesh);
        Vertices { first, count: last + 1 - first }
    }

    fn place(self, v: Vertex) -> usize {
        v.index() - self.first
    }

    fn vertex(self, place: usize) -> Vertex {
        Vertex::input(self.first + place)
    }
}

/// True if enough vertices of a sample of the second mesh coincide with vertices of the first.
fn is_worth_it(scene: &Scene, first: Vertices, second: Vertices) -> bool {
    let place = |of: Vertices, at: usize| bits(scene.point3(of.vertex(at)));
    let sample = |at: usize| place(second, at * (second.count / SAMPLE).max(1));
    let count = SAMPLE.min(second.count);
    let table = Table::of(count, &sample);
    let is_found = |at: usize| {
        let own = place(first, at);
        table.get(own, &|other| sample(other) == own) != NONE
    };
    let part = |part: usize| (part * PART..first.count.min((part + 1) * PART)).filter(|&at| is_found(at)).count();
    let found: usize = predicament_grid::parallel::each(first.count.div_ceil(PART), &part).into_iter().sum();
    found >= count / SHARE
}

/// For each vertex of the second mesh, the index of the first mesh's vertex at its position.
fn same_vertices(scene: &Scene, first: Vertices, second: Vertices) -> Vec<u32> {
    let place = |of: Vertices, at: usize| bits(scene.point3(of.vertex(at)));
    let table = OnceLock::new();
    let find = |part: usize| -> Vec<u32> {
        let find = |at: usize| {
            let own = place(second, at);
            if at < first.count && place(first, at) == own {
                return number(at);
            }
            let table = table.get_or_init(|| Table::of(first.count, &|at| place(first, at)));
            table.get(own, &|other| place(first, other) == own)
        };
        (part * PART..second.count.min((part + 1) * PART)).map(find).collect()
    };
    predicament_grid::parallel::each(second.count.div_ceil(PART), &find).concat()
}

/// For each triangle of the second mesh, the index of a triangle of the first mesh with the same three vertices.
fn same_triangles(meshes: [&MaterialMesh; 2], first: Vertices, second: Vertices, same: &[u32]) -> Vec<u32> {
    let sorted = |mut places: [u32; 3]| {
        places.sort_unstable();
        places.map(u64::from)
    };
    let of_first = |at: usize| sorted(meshes[0].triangles()[at].map(|v| number(first.place(v))));
    let table = OnceLock::new();
    let find = |at: usize| {
        let places = meshes[1].triangles()[at].map(|v| same[second.place(v)]);
        if places.contains(&NONE) {
            return NONE;
        }
        let own = sorted(places);
        if meshes[0].triangles().len() > at && of_first(at) == own {
            return number(at);
        }
        let table = table.get_or_init(|| Table::of(meshes[0].triangles().len(), &of_first));
        table.get(own, &|other| of_first(other) == own)
    };
    let count = meshes[1].triangles().len();
    let part = |part: usize| -> Vec<u32> { (part * PART..count.min((part + 1) * PART)).map(find).collect() };
    predicament_grid::parallel::each(count.div_ceil(PART), &part).concat()
}

/// For each vertex, true if the triangles around it are one graph over the yz plane.
fn clear_vertices(session: &dyn Predicates, mesh: &MaterialMesh, of: Vertices) -> Vec<bool> {
    const UP: u8 = 1;
    const DOWN: u8 = 2;
    const OTHER: u8 = 4;
    /// The increment for a triangle that crosses the ray from the vertex along y: exactly one crossing is required.
    const CROSSING: u8 = 8;
    let turn = |&[a, b, c]: &[Vertex; 3]| session.orient2d(Plane::Yz, a, b, c);
    let turns = predicament_grid::parallel::all(mesh.triangles(), &turn);
    let scene = session.scene();
    let mut seen = vec![0_u8; of.count];
    for (corners, turn) in mesh.triangles().iter().zip(turns) {
        let flag = match turn {
            Sign::Positive => UP,
            Sign::Negative => DOWN,
            Sign::Zero => OTHER,
        };
        let heights = corners.map(|v| scene.point3(v)[2]);
        for (corner, &v) in corners.iter().enumerate() {
            let [from, to] =
                [heights[(corner + 1) % 3], heights[(corner + 2) % 3]].map(|height| height < heights[corner]);
            let crosses = if turn == Sign::Positive { from && !to } else { to && !from };
            let there = &mut seen[of.place(v)];
            if crosses {
                *there = (*there).saturating_add(CROSSING);
            }
            *there |= flag;
        }
    }
    seen.into_iter().map(|seen| seen == UP | CROSSING || seen == DOWN | CROSSING).collect()
}
