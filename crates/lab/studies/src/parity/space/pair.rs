//! A pair of closed surfaces, and its reductions.

use std::collections::BTreeMap;

use predicament_contacts::checks::pairs::is_embedded;
use predicament_contacts::task::Complexes;
use predicament_exact::Exact;
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Backend, Off, Scene, Vertex};
use predicament_tasks::{AnswerError, Contestant};

use super::examine::{Broken, Examined, examine};
use crate::shrink::{Shrink, Shrunk, length, shorter, shrink};

/// A surface: triangles over a list of points.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Surface {
    /// The points.
    pub points: Vec<[f64; 3]>,
    /// The triangles, by the indices of their points.
    pub triangles: Vec<[usize; 3]>,
}

impl Surface {
    /// The surface with one point moved onto another.
    ///
    /// Triangles that have both points are removed, and two triangles that became equal cancel each other. A closed
    /// surface stays closed.
    fn contracted(&self, from: usize, onto: usize) -> Surface {
        let mut counts: BTreeMap<[usize; 3], usize> = BTreeMap::new();
        for triangle in &self.triangles {
            let mut moved = triangle.map(|at| if at == from { onto } else { at });
            moved.sort_unstable();
            if moved[0] != moved[1] && moved[1] != moved[2] {
                *counts.entry(moved).or_default() += 1;
            }
        }
        let left = counts.into_iter().filter(|(_, count)| !count.is_multiple_of(2)).map(|(triangle, _)| triangle);
        Surface { points: self.points.clone(), triangles: left.collect() }.tidied()
    }

    /// The surface without unused points.
    fn tidied(self) -> Surface {
        let mut places = BTreeMap::new();
        let mut points = Vec::new();
        let triangles = self.triangles.iter().map(|triangle| {
            triangle.map(|at| {
                *places.entry(at).or_insert_with(|| {
                    points.push(self.points[at]);
                    points.len() - 1
                })
            })
        });
        let triangles = triangles.collect();
        Surface { points, triangles }
    }

    /// The edges, each once.
    fn edges(&self) -> Vec<[usize; 2]> {
        let sides = |&[a, b, c]: &[usize; 3]| [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]);
        let mut edges: Vec<[usize; 2]> = self.triangles.iter().flat_map(sides).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }
}

/// Two closed surfaces.
#[derive(Clone, PartialEq, Debug)]
pub struct SurfacePair {
    /// The first and the second surface.
    pub surfaces: [Surface; 2],
}

impl SurfacePair {
    /// The points as a scene, the first surface's first, and each surface as a complex of its triangles.
    ///
    /// The scene has the lengths of both meshes and marks the vertices of the second.
    ///
    /// # Panics
    /// If a coordinate is not finite, or a triangle names a missing point or a point twice.
    #[must_use]
    pub fn scene(&self) -> (Scene, Complexes) {
        let [a, b] = &self.surfaces;
        let scene = Scene::from_points3(&[&a.points[..], &b.points].concat()).expect("coordinates are finite");
        let complex = |surface: &Surface, from: usize| {
            let triangles =
                surface.triangles.iter().map(|triangle| triangle.map(|at| Vertex::input(from + at))).collect();
            Complex::new(&scene, &Simplices { triangles, ..Simplices::default() }).expect("triangles of the scene")
        };
        let complexes = Complexes { a: complex(a, 0), b: complex(b, a.points.len()) };
        complexes.in_scene(scene)
    }

    /// Returns true if no surface crosses or touches itself, decided exactly.
    #[must_use]
    pub fn is_embedded(&self) -> bool {
        let (scene, complexes) = self.scene();
        let exact = Exact.prepare(&scene, Off).expect("input vertices only");
        complexes.both().into_iter().all(|complex| is_embedded(&exact, complex))
    }

    fn with(&self, which: usize, surface: Surface) -> SurfacePair {
        let mut pair = self.clone();
        pair.surfaces[which] = surface;
        pair
    }

    fn each(&self, change: impl Fn([f64; 3]) -> [f64; 3]) -> SurfacePair {
        let mut pair = self.clone();
        pair.surfaces.iter_mut().flat_map(|surface| &mut surface.points).for_each(|point| *point = change(*point));
        pair
    }

    fn coordinates(&self) -> impl Iterator<Item = f64> {
        self.surfaces.iter().flat_map(|surface| surface.points.iter().flatten().copied())
    }
}

/// The measure is fewer triangles first, then shorter coordinates, then smaller ones.
impl Shrink for SurfacePair {
    type Size = (usize, u32, u64);

    fn size(&self) -> (usize, u32, u64) {
        let sum: f64 = self.coordinates().map(f64::abs).sum();
        // For nonnegative doubles the order of bits is the order of values.
        let triangles = self.surfaces.iter().map(|surface| surface.triangles.len()).sum();
        (triangles, self.coordinates().map(length).sum(), sum.to_bits())
    }

    fn reductions(&self) -> Vec<SurfacePair> {
        let mut smaller = Vec::new();
        for (which, surface) in self.surfaces.iter().enumerate() {
            for [a, b] in surface.edges() {
                smaller.extend([[a, b], [b, a]].map(|[from, onto]| self.with(which, surface.contracted(from, onto))));
            }
        }
        smaller.retain(|pair| pair.surfaces.iter().all(|surface| surface.triangles.len() >= 4));
        // With another origin and another unit.
        for &origin in self.surfaces.iter().flat_map(|surface| &surface.points) {
            smaller.push(self.each(|p| [0, 1, 2].map(|axis| p[axis] - origin[axis])));
            for axis in 0..3 {
                let mut along = [0.0; 3];
                along[axis] = origin[axis];
                smaller.push(self.each(|p| [0, 1, 2].map(|axis| p[axis] - along[axis])));
            }
        }
        for exponent in [-8, -4, -2, -1, 1, 2, 4, 8] {
            smaller.push(self.each(|p| p.map(|x| x * 2.0_f64.powi(exponent))));
        }
        for (which, surface) in self.surfaces.iter().enumerate() {
            for (at, point) in surface.points.iter().enumerate() {
                for axis in 0..3 {
                    let x = point[axis];
                    let near = self.surfaces.iter().flat_map(|surface| &surface.points).map(|point| point[axis]);
                    for y in shorter(x).into_iter().chain(near).chain([x - x.signum(), x / 2.0]) {
                        let mut pair = self.clone();
                        pair.surfaces[which].points[at][axis] = y;
                        smaller.push(pair);
                    }
                }
            }
        }
        smaller.retain(|pair| pair.coordinates().all(f64::is_finite));
        smaller
    }
}

/// Shrinks a pair for which this backend's registrations are broken in all of these ways.
///
/// It keeps this property, both surfaces embedded, and the exact contacts consistent. It tries at most `limit` pairs.
#[must_use]
pub fn shrink_broken(
    [backend, exact]: [&dyn Contestant; 2],
    pair: SurfacePair,
    ways: &[Broken],
    limit: u64,
) -> Shrunk<SurfacePair> {
    let all = |examined: Result<Examined, AnswerError>, broken: bool| {
        examined.is_ok_and(|examined| ways.iter().all(|&way| (examined.count(way) > 0) == broken))
    };
    let shows = |pair: &SurfacePair| {
        all(examine(backend, pair), true) && pair.is_embedded() && all(examine(exact, pair), false)
    };
    shrink(pair, limit, shows)
}
