//! Checks of the unperturbed results, before rounding and after, decided in rationals.
//!
//! A limit has no sheets, no triangles without area and no two vertices at one position, so more laws apply to it than
//! to the perturbed result. As sums of oriented triangles both are one surface (`chains.rs`). So their volumes are the
//! same, too.

use std::collections::{BTreeMap, BTreeSet};

use predicament_judge::rational;
use predicament_judge::solids::Boundary;
use predicament_overlay::answer::Operation;
use predicament_predicates::{Construction, Vertex};
use predicament_slice::checks::{Check, Flaw};

use super::chains::Chain;
use super::surface::flaws;
use super::{Laws, Point, Violations, note};
use crate::truth;

/// A result of an operation without the perturbation.
#[derive(Clone, Copy, Debug)]
pub struct Settled<'a> {
    /// The limit.
    pub limit: &'a [[Vertex; 3]],
    /// The vertices of the limit in doubles.
    pub points: &'a [[f64; 3]],
    /// The triangles, as indices of points.
    pub triangles: &'a [[u32; 3]],
    /// For each point, the vertex of the limit that it rounds.
    pub vertices: &'a [Vertex],
    /// True if rounding has left no crossing.
    pub is_whole: bool,
}

/// Results without the perturbation, and the positions of all vertices.
pub struct Settlement<'a> {
    laws: &'a Laws<'a>,
    /// The results in the order of [`Operation::ALL`].
    settled: [Settled<'a>; 4],
    /// The positions of constructed vertices, from the answer's first construction on.
    constructed: Vec<Point>,
    /// The surfaces by operation: of the limit and in doubles.
    surfaces: Vec<[Surface; 2]>,
    boundaries: Vec<[Boundary; 2]>,
}

/// The surfaces of results: equal values have equal flaws.
#[derive(PartialEq)]
pub struct OfSurfaces {
    constructed: Vec<Point>,
    before: usize,
    results: [OfSurface; 4],
}

/// The corners of a limit, the bits of coordinates, the triangles in doubles, their vertices, and true if rounding has
/// left no crossing.
type OfSurface = (Vec<Vertex>, Vec<u64>, Vec<[u32; 3]>, Vec<Vertex>, bool);

/// A result as a list of triangles over points.
#[derive(PartialEq)]
struct Surface {
    points: Vec<Point>,
    triangles: Vec<[u32; 3]>,
}

impl Surface {
    fn corners(&self, triangle: [u32; 3]) -> [&Point; 3] {
        triangle.map(|v| &self.points[v as usize])
    }

    /// The largest coordinate, rounded; at least the smallest normal double.
    fn reach(&self) -> f64 {
        let all = self.points.iter().flatten().map(|x| x.to_f64().abs());
        all.fold(f64::MIN_POSITIVE, f64::max)
    }

    /// The flaws of the surface; `crossed` triangles are compared with their neighbours.
    fn flaws(&self, crossed: usize) -> Vec<Flaw> {
        flaws(self.points.clone(), &self.triangles, crossed)
    }

    /// The surface, prepared for winding number queries.
    fn boundary(&self) -> Boundary {
        Boundary::new(self.points.clone(), self.triangles.clone())
    }
}

impl<'a> Settlement<'a> {
    /// Collects the results, if all of their vertices are points.
    #[must_use]
    pub fn new(
        laws: &'a Laws<'a>,
        constructions: &[Construction],
        settled: [Settled<'a>; 4],
    ) -> Option<Settlement<'a>> {
        let constructed = truth::constructed(laws.scene, constructions).ok()?;
        let mut settlement = Settlement { laws, settled, constructed, surfaces: Vec::new(), boundaries: Vec::new() };
        settlement.surfaces = settled.iter().map(|result| [settlement.limit(result), in_doubles(result)]).collect();
        settlement.boundaries = settlement.surfaces.iter().map(|both| both.each_ref().map(Surface::boundary)).collect();
        Some(settlement)
    }

    /// The results by operation.
    fn by_operation(&self) -> impl Iterator<Item = (Operation, &Settled<'a>)> {
        Operation::ALL.into_iter().zip(&self.settled)
    }

    fn point(&self, v: Vertex) -> &Point {
        let before = self.laws.before;
        v.construction().map_or_else(|| &self.laws.points[v.index()], |index| &self.constructed[index - before])
    }

    fn limit(&self, result: &Settled<'_>) -> Surface {
        let vertices: BTreeSet<Vertex> = result.limit.iter().flatten().copied().collect();
        let places: BTreeMap<Vertex, u32> = vertices.iter().copied().zip(0..).collect();
        Surface {
            points: vertices.iter().map(|&v| self.point(v).clone()).collect(),
            triangles: result.limit.iter().map(|triangle| triangle.map(|v| places[&v])).collect(),
        }
    }

    /// All that [`surfaces`](Settlement::surfaces) reads, besides the scene.
    #[must_use]
    pub fn of_surfaces(&self) -> OfSurfaces {
        let of = |result: &Settled<'_>| {
            let bits = result.points.as_flattened().iter().map(|x| x.to_bits()).collect();
            let [limit, vertices] = [result.limit.as_flattened(), result.vertices].map(<[Vertex]>::to_vec);
            (limit, bits, result.triangles.to_vec(), vertices, result.is_whole)
        };
        OfSurfaces {
            constructed: self.constructed.clone(),
            before: self.laws.before,
            results: self.settled.each_ref().map(of),
        }
    }

    /// Checks the surfaces alone; `crossed` triangles are compared with their neighbours.
    #[must_use]
    pub fn surfaces(&self, crossed: usize) -> Violations {
        let found = &mut Violations::new();
        for ((operation, result), [limit, doubles]) in self.by_operation().zip(&self.surfaces) {
            let name = operation.name();
            let of_limit = limit.flaws(crossed);
            whole(limit, &format!("{name}, limit"), &of_limit, crossed, found);
            self.apart(operation, result, found);
            let of_doubles = match (result.is_whole, doubles == limit) {
                (false, _) => doubles.flaws(0),
                (true, true) => of_limit,
                (true, false) => doubles.flaws(crossed),
            };
            let crossed = if result.is_whole { crossed } else { 0 };
            whole(doubles, &format!("{name}, in doubles"), &of_doubles, crossed, found);
            self.beside(operation, result, found);
        }
        if self.laws.is_twice() && !self.settled[2].limit.is_empty() {
            let got = format!("{} triangles of the difference", self.settled[2].limit.len());
            note(found, "limit of a mesh with itself", got, "a mesh less itself is empty");
        }
        std::mem::take(found)
    }

    /// Checks that no two vertices of a limit coincide, except those of a given mesh.
    fn apart(&self, operation: Operation, result: &Settled<'_>, found: &mut Violations) {
        let vertices: BTreeSet<Vertex> = result.limit.iter().flatten().copied().collect();
        let mut by_place: BTreeMap<&Point, Vertex> = BTreeMap::new();
        let second = self.laws.scene.second_mesh();
        let mesh = |v: Vertex| second.map(|second| second[v.index()]);
        for v in vertices {
            let Some(other) = by_place.insert(self.point(v), v) else { continue };
            if v.is_constructed() || other.is_constructed() || mesh(v) != mesh(other) {
                let got = format!("{}: {other} and {v} are at the same place", operation.name());
                note(found, "vertices of a limit", got, "two vertices are not at the same place");
                return;
            }
        }
    }

    /// Checks that each limit is the same surface as the perturbed result.
    pub fn planes(&self, found: &mut Violations) {
        for (((operation, _), [limit, _]), solid) in self.by_operation().zip(&self.surfaces).zip(self.laws.solids) {
            let mut left = Chain::default();
            limit.triangles.iter().for_each(|&triangle| left.add(limit.corners(triangle), 1));
            solid.iter().for_each(|&triangle| left.add(self.laws.corners(triangle), -1));
            if let Some(at) = left.rest() {
                let got = format!("{}: they differ near {at:?}", operation.name());
                note(
                    found,
                    "areas of a limit",
                    got,
                    "a limit covers the same areas in each plane as the perturbed result",
                );
            }
        }
    }

    /// Checks that each vertex in doubles is within one ulp of its exact position.
    fn beside(&self, operation: Operation, result: &Settled<'_>, found: &mut Violations) {
        let Settled { points, vertices, .. } = *result;
        let is_near = |(point, &v): (&[f64; 3], &Vertex)| {
            point.iter().zip(self.point(v)).all(|(&x, place)| {
                let around = [x.next_down(), x.next_up()];
                // (A position beyond all doubles becomes the largest double.)
                let [low, high] = around.map(|x| if x.is_finite() { x } else { x.signum() * f64::MAX });
                &rational(low) <= place && place <= &rational(high)
            })
        };
        let far = points.iter().zip(vertices).find(|&pair| !is_near(pair));
        if let Some((point, v)) = far {
            let got = format!("{}: {v} is at {point:?}", operation.name());
            note(found, "place of a rounded vertex", got, "each coordinate is within one ulp of the exact coordinate");
        }
        if points.len() != vertices.len() {
            let got = format!("{}: {} of {}", operation.name(), vertices.len(), points.len());
            note(found, "place of a rounded vertex", got, "each vertex has a known source");
        }
    }

    /// Checks a point in space against the limits and the results in doubles; returns the first surface with a winding
    /// number that contradicts the operation.
    pub fn probed(&self, probe: [f64; 3], inside: [bool; 2]) -> Option<(&'static str, Operation, i64)> {
        for (((operation, result), [limit, doubles]), [of_limit, of_doubles]) in
            self.by_operation().zip(&self.surfaces).zip(&self.boundaries)
        {
            let wanted = i64::from(operation.holds(inside));
            if let Some(winding) = of_limit.winding(probe).filter(|winding| *winding != wanted) {
                return Some(("the limit", operation, winding));
            }
            // A surface that crosses itself has arbitrary winding numbers, and rounding moves each vertex by an ulp in
            // each coordinate: a point nearer than that may change sides.
            let reach = limit.reach().max(doubles.reach()) * 2.0_f64.powi(-50);
            let is_known = result.is_whole && !of_limit.is_near(probe, reach);
            if is_known && let Some(winding) = of_doubles.winding(probe).filter(|winding| *winding != wanted) {
                return Some(("the result in doubles", operation, winding));
            }
        }
        None
    }
}

fn in_doubles(result: &Settled<'_>) -> Surface {
    Surface {
        points: result.points.iter().map(|point| point.map(rational)).collect(),
        triangles: result.triangles.to_vec(),
    }
}

/// Checks that a surface is closed, each triangle has an area, none occurs twice, and none passes through another one.
fn whole(surface: &Surface, of: &str, flaws: &[Flaw], crossed: usize, found: &mut Violations) {
    let mut seen = BTreeSet::new();
    for &triangle in &surface.triangles {
        let mut sorted = triangle;
        sorted.sort_unstable();
        if crossed > 0 && !seen.insert(sorted) {
            note(found, "sheet", format!("{of}: {sorted:?} occurs twice"), "each triangle occurs only once");
            break;
        }
    }
    for flaw in flaws {
        let check = match flaw.check {
            Check::Closed => "settled result not closed",
            Check::SelfIntersection => "settled result crosses itself",
            check => check.name(),
        };
        note(found, check, format!("{of}: {} times, first: {}", flaw.count, flaw.what), flaw.check.law());
    }
}
