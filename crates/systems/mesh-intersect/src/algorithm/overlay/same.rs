//! Shared triangles of both meshes: pairs that certainly do not pass through each other are set aside.
//!
//! The case is a mesh overlaid with itself, or with a part cut from it. Each edge is then tied with all triangles
//! around it, and hardly any of them meet once one of the meshes has moved. This module finds shared triangles by their
//! coordinates, and sets them aside if that can be decided without a tie.
//!
//! # What is set aside
//! Let S be the surface of one mesh, and S + δ the same surface in the other, δ = (ε, ε², ε³) or its opposite.
//!
//! - *Around a vertex.* Seen along x, the triangles around it all turn the same way and go around it once: they are a
//!   graph over a polygon of the yz plane. Its x differs by at most some L times the distance in that plane; moved by δ
//!   it is above itself by at least ε − L(ε² + ε³), and does not meet itself. Two triangles that have a corner in
//!   common are both around that corner.
//! - *Elsewhere.* An edge and a triangle that are apart are apart after a small enough move. A triangle is set aside
//!   only if it is apart from all other such triangles that it has no corner in common with: a plane across an axis or
//!   a diagonal separates them, or a line in a coordinate plane, by the signs of determinants in doubles that exceed
//!   their rounding errors.
//!
//! Hence an edge of a triangle that is set aside in one mesh does not pass through a triangle that is set aside in the
//! other. All other pairs are tested. The surface is closed, so that the triangles around a vertex are loops; a loop
//! whose triangles turn the same way crosses a ray as often as it goes around.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use predicament_grid::Bounds;
use predicament_grid::two_level::{Sizes, TwoLevel};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Plane, Predicates, Scene, Sign, Vertex};

use super::meet::do_meet;
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
/// The maximum number of triangles of a cell; in cells with more, none is set aside.
const MOST: usize = 512;

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
    for (&at, is_apart) in candidates.iter().zip(apart(scene, meshes[0], &candidates)) {
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

/// For each of these triangles, true if it is certainly apart from all others without a common corner.
fn apart(scene: &Scene, mesh: &MaterialMesh, of: &[u32]) -> Vec<bool> {
    let corners = |at: u32| mesh.triangles()[of[at as usize] as usize];
    let box_of = |&at: &u32| Bounds::of(mesh.triangles()[at as usize].map(|v| scene.point3(v)));
    let boxes = predicament_grid::parallel::all(of, &box_of);
    let grid = TwoLevel::new(&boxes, Sizes::of(&boxes));
    let meets: Vec<AtomicBool> = of.iter().map(|_| AtomicBool::new(false)).collect();
    let meet = |at: u32| meets[at as usize].store(true, Relaxed);
    let part = |part: usize| {
        let mut here = Vec::new();
        for slot in part * PART..grid.slots().min((part + 1) * PART) {
            let list = grid.list(slot);
            if list.len() > MOST {
                list.iter().copied().for_each(meet);
                continue;
            }
            // Boxes and corners of one cell are copied together, for all pairs. Nearly all pairs whose boxes meet
            // have a corner in common: both tests are done without a branch, which would be mispredicted.
            here.clear();
            here.extend(list.iter().map(|&at| (at, boxes[at as usize], corners(at))));
            for (place, (at, bounds, own)) in here.iter().enumerate() {
                for (other, others, theirs) in &here[place + 1..] {
                    if (do_meet(bounds, others) & !have_common_corner(own, theirs))
                        && !are_apart([own, theirs].map(|triangle| triangle.map(|v| scene.point3(v))))
                    {
                        meet(*at);
                        meet(*other);
                    }
                }
            }
        }
    };
    predicament_grid::parallel::each(grid.slots().div_ceil(PART), &part);
    meets.into_iter().map(|meets| !meets.into_inner()).collect()
}

/// True if two triangles have a corner in common.
#[inline]
fn have_common_corner(a: &[Vertex; 3], b: &[Vertex; 3]) -> bool {
    a.iter().fold(false, |found, v| found | (*v == b[0]) | (*v == b[1]) | (*v == b[2]))
}

/// The extent of a triangle along the diagonals of the coordinate planes.
///
/// Rounded sums are monotone: of two different rounded sums, the smaller one belongs to the smaller exact sum.
struct Diagonals {
    low: [f64; 6],
    high: [f64; 6],
}

impl Diagonals {
    fn of(triangle: [[f64; 3]; 3]) -> Diagonals {
        let [a, b, c] = triangle.map(|[x, y, z]| [x + y, x - y, y + z, y - z, z + x, z - x]);
        let (mut low, mut high) = (a, a);
        for i in 0..6 {
            low[i] = low[i].min(b[i]).min(c[i]);
            high[i] = high[i].max(b[i]).max(c[i]);
        }
        Diagonals { low, high }
    }

    /// True if no diagonal certainly separates the two.
    #[inline]
    fn do_meet(&self, other: &Diagonals) -> bool {
        (0..6).all(|i| (self.low[i] <= other.high[i]) & (other.low[i] <= self.high[i]))
    }
}

/// True if a plane across a diagonal, or a line in a coordinate plane, certainly separates two triangles.
fn are_apart([t, s]: [[[f64; 3]; 3]; 2]) -> bool {
    !Diagonals::of(t).do_meet(&Diagonals::of(s)) || planes(t).into_iter().any(|plane| are_separated(plane, t, s))
}

/// The two axes of each coordinate plane; first the plane in which a triangle has about the largest area.
fn planes(t: [[f64; 3]; 3]) -> [[usize; 2]; 3] {
    let area = |[i, j]: [usize; 2]| {
        ((t[1][i] - t[0][i]) * (t[2][j] - t[0][j]) - (t[1][j] - t[0][j]) * (t[2][i] - t[0][i])).abs()
    };
    let mut planes = [[0, 1], [1, 2], [2, 0]];
    planes.sort_by(|&a, &b| area(b).total_cmp(&area(a)));
    planes
}

/// True if a line along an edge of one of two triangles certainly has the other strictly beyond it in a coordinate
/// plane.
fn are_separated([i, j]: [usize; 2], t: [[f64; 3]; 3], s: [[f64; 3]; 3]) -> bool {
    let flat = |t: [[f64; 3]; 3]| t.map(|p| [p[i], p[j]]);
    let [t, s] = [flat(t), flat(s)];
    let is_beyond = |t: [[f64; 2]; 3], s: [[f64; 2]; 3], edge: usize| {
        let [a, b, c] = [t[edge], t[(edge + 1) % 3], t[(edge + 2) % 3]];
        match turn(a, b, c) {
            Some(true) => s.iter().all(|&p| turn(a, b, p) == Some(false)),
            Some(false) => s.iter().all(|&p| turn(a, b, p) == Some(true)),
            None => false,
        }
    };
    (0..3).any(|edge| is_beyond(t, s, edge) || is_beyond(s, t, edge))
}

/// The turn of a, b, c: true for counterclockwise, false for clockwise, `None` if rounding could decide.
///
/// Let u = 2^-53. The determinant of rounded differences has an error of less than 4 u times the sum of its products'
/// magnitudes (Shewchuk, *Adaptive precision floating-point arithmetic*, 1997, section 4.3), if that sum is far from
/// underflow; it is not if it overflows.
#[inline]
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<bool> {
    /// The relative error bound 4 u.
    const ERROR: f64 = 2.0 * f64::EPSILON;
    /// The least sum of magnitudes for that bound: products that underflow have an error of at most 2^-1074, which is
    /// negligible beside 4 u times 2^-900.
    const LEAST: f64 = 1e-270;
    let left = (a[0] - c[0]) * (b[1] - c[1]);
    let right = (a[1] - c[1]) * (b[0] - c[0]);
    let (determinant, sum) = (left - right, left.abs() + right.abs());
    (sum > LEAST && determinant.abs() > ERROR * sum && sum < f64::INFINITY).then_some(determinant > 0.0)
}
