//! Triangles of a mesh that are apart from each other.
//!
//! Two triangles are apart if both are of one [patch](super::patches), if a plane across an axis or a diagonal
//! separates them, or a line in a coordinate plane. The signs are those of determinants in doubles that exceed their
//! rounding errors.

use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use predicament_grid::Bounds;
use predicament_grid::two_level::{Sizes, TwoLevel};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Scene, Vertex};

use super::super::meet::do_meet;
use super::super::near::number;
use super::super::table::NONE;
use super::patches::Patches;
use super::{PART, Vertices};

/// The maximum number of triangles of a cell; in cells with more, none is set aside.
const MOST: usize = 512;

/// For each of these triangles, true if it is certainly apart from all others without a common corner.
pub(super) fn apart(scene: &Scene, mesh: &MaterialMesh, vertices: Vertices, of: &[u32]) -> Vec<bool> {
    let box_of = |&at: &u32| Bounds::of(mesh.triangles()[at as usize].map(|v| scene.point3(v)));
    let all_boxes = predicament_grid::parallel::all(of, &box_of);
    let patches = Patches::of(scene, mesh, vertices, of, &all_boxes);
    // Triangles of one patch are apart: those that are away from all other patches need no test.
    let tested: Vec<u32> = (0..of.len()).filter(|&at| patches.is_near_others(at, &all_boxes[at])).map(number).collect();
    let boxes: Vec<Bounds<3>> = tested.iter().map(|&at| all_boxes[at as usize]).collect();
    let grid = TwoLevel::new(&boxes, Sizes::of(&boxes));
    let meets: Vec<AtomicBool> = of.iter().map(|_| AtomicBool::new(false)).collect();
    let meet = |at: u32| meets[at as usize].store(true, Relaxed);
    let part = |part: usize| {
        let mut here = Vec::new();
        for slot in part * PART..grid.slots().min((part + 1) * PART) {
            let list = grid.list(slot);
            if list.len() > MOST {
                list.iter().for_each(|&at| meet(tested[at as usize]));
                continue;
            }
            // Boxes and corners of one cell are copied together, for all pairs. Nearly all pairs whose boxes meet
            // have a corner in common: both tests are done without a branch, which would be mispredicted.
            here.clear();
            here.extend(list.iter().map(|&at| {
                let place = tested[at as usize];
                let corners = mesh.triangles()[of[place as usize] as usize];
                (place, boxes[at as usize], corners, patches.patch(place as usize))
            }));
            for (place, (at, bounds, own, patch)) in here.iter().enumerate() {
                for (other, others, theirs, their_patch) in &here[place + 1..] {
                    let is_one_patch = (patch == their_patch) & (*patch != NONE);
                    if (do_meet(bounds, others) & !have_common_corner(own, theirs) & !is_one_patch)
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
pub(super) fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<bool> {
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
