//! A pair of polygons, and its reductions.

use predicament_contacts::checks::pairs::{Seat, is_embedded};
use predicament_exact::Exact;
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Backend, Off, Scene, Vertex};
use predicament_tasks::{AnswerError, Contestant};

use super::examine::{Examined, examine};
use crate::shrink::{Shrink, Shrunk, length, shorter, shrink, without_each};

type Polygon = Vec<[f64; 2]>;

/// Two closed polygons by their corners.
#[derive(Clone, PartialEq, Debug)]
pub struct PolygonPair {
    /// The first and the second polygon.
    pub polygons: [Polygon; 2],
}

impl PolygonPair {
    /// The corners as a scene with both polygons' primitive lengths, and each polygon as a complex of its edges.
    ///
    /// The first polygon's corners come first.
    ///
    /// # Panics
    /// If a coordinate is not finite, or a polygon has fewer than three corners.
    #[must_use]
    pub fn scene(&self) -> (Scene, [Complex; 2]) {
        let [a, b] = &self.polygons;
        assert!(a.len() >= 3 && b.len() >= 3, "a polygon has three corners or more");
        let scene = Scene::from_points2(&[&a[..], b].concat()).expect("coordinates are finite");
        let complexes = [(0, a.len()), (a.len(), b.len())].map(|(from, n)| {
            let edges = (0..n).map(|i| [from + i, from + (i + 1) % n].map(Vertex::input)).collect();
            let given = Simplices { edges, ..Simplices::default() };
            Complex::new(&scene, &given).expect("corners of a polygon are different points of the scene")
        });
        let lengths = complexes.each_ref().map(|complex| complex.primitive_length(&scene));
        (scene.with_primitive_lengths(lengths), complexes)
    }

    /// Returns true if both polygons are simple, decided exactly.
    #[must_use]
    pub fn is_simple(&self) -> bool {
        let (scene, complexes) = self.scene();
        let exact = Exact.prepare(&scene, Off).expect("input vertices only");
        complexes.iter().all(|complex| is_embedded(&exact, complex))
    }

    fn with(&self, which: usize, polygon: Polygon) -> PolygonPair {
        let mut pair = self.clone();
        pair.polygons[which] = polygon;
        pair
    }

    fn each(&self, change: impl Fn([f64; 2]) -> [f64; 2]) -> PolygonPair {
        PolygonPair { polygons: self.polygons.clone().map(|polygon| polygon.into_iter().map(&change).collect()) }
    }
}

/// The measure is fewer corners first, then shorter coordinates, then smaller ones.
impl Shrink for PolygonPair {
    type Size = (usize, u32, u64);

    fn size(&self) -> (usize, u32, u64) {
        let coordinates = || self.polygons.iter().flatten().flatten();
        let sum: f64 = coordinates().map(|x| x.abs()).sum();
        // For nonnegative doubles the order of bits is the order of values.
        (self.polygons.iter().map(Vec::len).sum(), coordinates().map(|&x| length(x)).sum(), sum.to_bits())
    }

    fn reductions(&self) -> Vec<PolygonPair> {
        let mut smaller = Vec::new();
        for which in 0..2 {
            let polygon = &self.polygons[which];
            if polygon.len() > 3 {
                smaller.extend(without_each(polygon).map(|fewer| self.with(which, fewer)));
            }
        }
        // With another origin and another unit.
        for &[x, y] in self.polygons.iter().flatten() {
            smaller.push(self.each(|p| [p[0] - x, p[1] - y]));
            smaller.push(self.each(|p| [p[0] - x, p[1]]));
            smaller.push(self.each(|p| [p[0], p[1] - y]));
        }
        for exponent in [-8, -4, -2, -1, 1, 2, 4, 8] {
            smaller.push(self.each(|p| p.map(|x| x * 2.0_f64.powi(exponent))));
        }
        for which in 0..2 {
            for at in 0..self.polygons[which].len() {
                for axis in 0..2 {
                    let x = self.polygons[which][at][axis];
                    let near = self.polygons.iter().flatten().map(|point| point[axis]);
                    let steps = [x - x.signum(), x / 2.0];
                    for y in shorter(x).into_iter().chain(near).chain(steps) {
                        let mut pair = self.clone();
                        pair.polygons[which][at][axis] = y;
                        smaller.push(pair);
                    }
                }
            }
        }
        smaller.retain(|pair| pair.polygons.iter().flatten().flatten().all(|x| x.is_finite()));
        smaller
    }
}

/// Shrinks a pair for which this backend's registrations give an odd number of crossings under all of these rules.
///
/// It keeps this property, both polygons simple, and the exact count even. It tries at most `limit` pairs.
#[must_use]
pub fn shrink_odd(
    [backend, exact]: [&dyn Contestant; 2],
    pair: PolygonPair,
    seats: &[Seat],
    limit: u64,
) -> Shrunk<PolygonPair> {
    let all = |examined: Result<Examined, AnswerError>, odd: bool| {
        examined.is_ok_and(|examined| seats.iter().all(|&seat| examined.crossings(seat).is_odd() == odd))
    };
    let shows =
        |pair: &PolygonPair| pair.is_simple() && all(examine(backend, pair), true) && all(examine(exact, pair), false);
    shrink(pair, limit, shows)
}
