//! The measurements after a step, in rationals.

use predicament_judge::rational;
use predicament_judge::solids::{Materials, Place};
use predicament_mesh::OUTSIDE;
use predicament_mesh_intersect::algorithm::cascade::{Closed, Step};
use predicament_predicates::{Scene, Vertex};
use predicament_slice::checks::{Check, Expected, Part, Piece, Slices};
use rug::Rational;

use super::cascade::{Cells, Operand};

/// The number of triangles that are compared with their neighbours after a step.
const CROSSED: usize = 400;
/// Directions of rays, one of which misses all edges.
const DIRECTIONS: [[i32; 3]; 4] = [[83, 31, 17], [-29, 71, 43], [13, -47, 97], [-61, -7, 89]];

/// The state after a step.
#[derive(Clone, PartialEq, Debug)]
pub struct Sample {
    /// The number of steps so far.
    pub step: usize,
    /// The number of triangles of the result.
    pub triangles: usize,
    /// The number of its vertices.
    pub points: usize,
    /// The volume of the result.
    pub volume: Rational,
    /// The area of the result, rounded.
    pub area: f64,
    /// The true volume and area, if they are known.
    pub truth: Option<[usize; 2]>,
    /// The number of triangle sides without an opposite side.
    pub open: usize,
    /// The number of triangles without area.
    pub flat: usize,
    /// The number of edges that pass through triangles, for an even sample of triangles.
    pub crossing: usize,
    /// The number of probes on the wrong side.
    pub wrong: usize,
    /// The sums over all steps so far.
    pub done: Done,
    /// Nanoseconds per step, the mean since the last sample.
    pub nanoseconds: f64,
}

/// Sums over steps.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Done {
    /// The number of points constructed.
    pub constructed: usize,
    /// The number of triangles cleared in limits: without area, cancelled, covered by facing ones, or divided.
    pub cleared: usize,
    /// The number of vertices moved by rounding.
    pub moved: usize,
    /// The number of flaws if all vertices are rounded to the nearest doubles: triangles turned over, folds and
    /// crossings.
    pub flaws: usize,
    /// The number of triangles that were cut to resolve flaws.
    pub cut: usize,
    /// The number of steps whose result was resolved and rounded again.
    pub resolved: usize,
    /// The largest number of passes in one step.
    pub passes: usize,
    /// The largest total move of resolved results in a coordinate.
    pub farthest: f64,
    /// The number of remaining flaws.
    pub left: usize,
}

impl Done {
    pub(super) fn add(&mut self, step: &Step) {
        let Step { constructed, limit, rounding, resolved } = step;
        self.constructed += constructed;
        self.cleared += limit.flat + limit.cancelled + limit.covered + limit.divided;
        self.moved += rounding.moved;
        self.flaws += rounding.turned + rounding.folded + rounding.crossing;
        if let Some(resolved) = resolved {
            self.cut += resolved.cut;
            self.resolved += usize::from(resolved.passes > 0);
            self.passes = self.passes.max(resolved.passes);
            self.farthest += resolved.farthest;
        }
        self.left += step.left();
    }
}

/// A point, and true if it is in the result so far; `None` if it is on an operand.
pub(super) struct Probe {
    pub at: [Rational; 3],
    pub is_in: Option<bool>,
}

impl Probe {
    pub fn apply(&mut self, operand: &Operand) {
        self.is_in = self.is_in.and_then(|is_in| {
            let of_operand = inside(&operand.mesh, std::slice::from_ref(&self.at))[0]?;
            Some(operand.operation.holds([is_in, of_operand]))
        });
    }

    pub fn new(at: [Rational; 3], start: &Closed) -> Probe {
        let is_in = inside(start, std::slice::from_ref(&at))[0];
        Probe { at, is_in }
    }
}

/// For each point, true if it is in a mesh.
///
/// `None` if that is unknown: on the surface, or where the mesh contradicts itself.
fn inside(mesh: &Closed, points: &[[Rational; 3]]) -> Vec<Option<bool>> {
    if mesh.triangles.is_empty() {
        return vec![Some(false); points.len()];
    }
    let Ok(scene) = Scene::from_points3(&mesh.points) else { return vec![None; points.len()] };
    let triangles: Vec<[Vertex; 3]> =
        mesh.triangles.iter().map(|triangle| triangle.map(|v| Vertex::input(v as usize))).collect();
    let sides = vec![[OUTSIDE, 1]; triangles.len()];
    let materials = Materials::new(&scene, &triangles, &sides);
    let judge = materials.in_integers();
    let place = |point: &[Rational; 3]| DIRECTIONS.iter().find_map(|&direction| judge.winding(point, direction));
    let is_in = |point: &[Rational; 3]| match place(point) {
        Some(Place::In(region)) => Some(region != OUTSIDE),
        _ => None,
    };
    points.iter().map(is_in).collect()
}

/// Six times the volume of a mesh, and its area, rounded.
fn extent(mesh: &Closed) -> (Rational, f64) {
    let (mut six, mut area) = (Rational::new(), 0.0);
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|v| mesh.points[v as usize].map(rational));
        let minor = |p: &[Rational; 3], q: &[Rational; 3], i: usize, j: usize| {
            Rational::from(&p[i] * &q[j]) - Rational::from(&p[j] * &q[i])
        };
        let axes = [(1, 2), (2, 0), (0, 1)];
        six += axes.iter().zip(&a).map(|(&(i, j), x)| Rational::from(x * &minor(&b, &c, i, j))).sum::<Rational>();
        let minus = |p: &[Rational; 3]| [0, 1, 2].map(|axis: usize| Rational::from(&p[axis] - &a[axis]));
        let [u, v] = [minus(&b), minus(&c)];
        let square: f64 = axes.iter().map(|&(i, j)| minor(&u, &v, i, j).to_f64().powi(2)).sum();
        area += square.sqrt() / 2.0;
    }
    (six, area)
}

/// Measures a result.
pub(super) fn measured(
    step: usize,
    result: &Closed,
    cells: Option<&Cells>,
    probes: &[Probe],
    done: Done,
    nanoseconds: f64,
) -> Sample {
    let (six, area) = extent(result);
    let slices = Slices {
        points: result.points.iter().map(|point| point.map(rational)).collect(),
        faces: result.triangles.iter().map(|triangle| triangle.to_vec()).collect(),
        planes: Vec::new(),
        parts: vec![Part {
            triangles: result.triangles.clone(),
            pieces: (0..result.triangles.len()).map(Piece::Face).collect(),
            open: Vec::new(),
        }],
    };
    let flaws =
        slices.flaws(Expected { is_closed: true, has_areas: true, may_stand: false, triangles_crossed: CROSSED });
    let count = |check: Check| {
        flaws.iter().find(|flaw| flaw.check == check).map_or(0, |flaw| flaw.count.try_into().unwrap_or(usize::MAX))
    };
    let (points, known): (Vec<_>, Vec<_>) =
        probes.iter().filter_map(|probe| Some((probe.at.clone(), probe.is_in?))).unzip();
    // A point on the surface of a rounded result does not count as wrong.
    let wrong =
        inside(result, &points).into_iter().zip(known).filter(|(found, known)| found.is_some_and(|is| is != *known));
    Sample {
        step,
        triangles: result.triangles.len(),
        points: result.points.len(),
        volume: six / 6,
        area,
        truth: cells.map(|cells| [cells.count(), cells.squares()]),
        open: count(Check::Closed),
        flat: count(Check::Degenerate),
        crossing: count(Check::SelfIntersection),
        wrong: wrong.count(),
        done,
        nanoseconds,
    }
}

impl Sample {
    /// Returns true if volume, area and the number of triangles are the true ones, if known.
    #[must_use]
    pub fn is_true(&self) -> bool {
        #[allow(clippy::cast_precision_loss)] // few squares
        let is_area = |squares: usize| self.area == squares as f64;
        self.truth
            .is_none_or(|[cells, squares]| self.volume == cells && is_area(squares) && self.triangles == 2 * squares)
    }

    /// Returns true if the sample shows no error.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.is_true() && [self.open, self.flat, self.crossing, self.wrong].iter().all(|count| *count == 0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Cascade;
    use super::*;

    #[test]
    fn what_is_wrong_is_seen() {
        let (start, steps) = Cascade::Cubes.steps(3, 1);
        let mut cells = Cells::default();
        cells.apply(&start);
        let at = |x: f64| [x, 0.25, 0.5].map(rational);
        let probes = [Probe::new(at(0.75), &start.mesh), Probe::new(at(5.0), &start.mesh)];
        assert_eq!(probes.each_ref().map(|probe| probe.is_in), [Some(true), Some(false)]);
        let sample = |mesh: &Closed| measured(1, mesh, Some(&cells), &probes, Done::default(), 0.0);
        assert!(sample(&start.mesh).is_clean());
        let mut open = start.mesh.clone();
        open.triangles.pop();
        assert_eq!(sample(&open).open, 3);
        let mut turned = start.mesh.clone();
        turned.triangles.iter_mut().for_each(|triangle| triangle.swap(0, 1));
        assert!(!sample(&turned).is_true());
        let other = &steps[0].mesh;
        assert_eq!((sample(other).wrong, sample(other).is_true()), (1, true), "another cube");
        // Two cubes that cross.
        let mut both = start.mesh.clone();
        let moved = start.mesh.points.iter().map(|&[x, y, z]| [x + 0.375, y + 0.25, z + 0.125]);
        both.points.extend(moved);
        both.triangles.extend(start.mesh.triangles.iter().map(|triangle| triangle.map(|v| v + 8)));
        assert!(sample(&both).crossing > 0);
    }
}
