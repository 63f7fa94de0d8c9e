//! Volumes and areas, summed in rationals triangle by triangle.
//!
//! Most pieces of a sum occur in it with both orientations, equally often: the union and the intersection together have
//! every piece of an uncut triangle once, and so does the mesh. So pieces are counted first, by the positions of their
//! corners. Equal corners have equal measures, and a turned piece has the opposite one, so the sum of all measures is
//! that of the pieces whose counts are not zero. Only these are measured.

use std::collections::{BTreeMap, HashMap};

use crate::answer::Source;
use predicament_mesh::OUTSIDE;
use predicament_overlay::answer::Operation;
use predicament_predicates::Vertex;
use predicament_slice::checks::Rows;
use rug::Rational;

use super::chains::ascending;
use super::{Laws, Point, Violations, name, note};

/// Three components of twice an area's normal, and six times the volume between the triangle and the origin.
pub type Measure = [Rational; 4];

/// A sum for each source triangle.
pub type Sums = BTreeMap<Source, Measure>;

/// Pieces by source, with the number of times that each counts: those that are turned over count negatively. The key is
/// the numbers of the corners in ascending order.
#[derive(Clone, Default, Debug)]
pub struct Parts(BTreeMap<(Source, [u32; 3]), i32>);

impl Parts {
    fn add(&mut self, source: Source, corners: [u32; 3]) {
        let (piece, is_turned) = ascending(corners);
        *self.0.entry((source, piece)).or_default() += if is_turned { -1 } else { 1 };
    }

    /// The same pieces with other sources.
    #[must_use]
    pub fn with_sources(self, new: impl Fn(Source) -> Source) -> Parts {
        let mut parts = Parts::default();
        for ((source, piece), times) in self.0 {
            *parts.0.entry((new(source), piece)).or_default() += times;
        }
        parts
    }
}

/// The corners of pieces: corners at one position have one number, also in different lists of points.
pub struct Corners<'p> {
    rows: Rows<'p>,
    /// The numbers of the points of each list.
    numbers: Vec<Vec<u32>>,
}

impl<'p> Corners<'p> {
    /// Numbers the points of these lists.
    ///
    /// # Panics
    /// If there are 2^32 of them.
    #[must_use]
    pub fn of(lists: &[&'p [Point]]) -> Corners<'p> {
        let (mut known, mut points): (HashMap<&Point, u32>, Vec<&Point>) = (HashMap::new(), Vec::new());
        let mut number = |point: &'p Point| {
            *known.entry(point).or_insert_with(|| {
                points.push(point);
                u32::try_from(points.len() - 1).expect("fewer than 2^32 points")
            })
        };
        let numbers = lists.iter().map(|list| list.iter().map(&mut number).collect()).collect();
        Corners { rows: Rows::of(points), numbers }
    }

    /// The numbers of the points of a list.
    ///
    /// # Panics
    /// If there is no such list.
    #[must_use]
    pub fn numbers(&self, list: usize) -> &[u32] {
        &self.numbers[list]
    }

    /// The measures of each source in a sum of pieces with coefficients, without zeros.
    #[must_use]
    pub fn left(&self, terms: &[(&Parts, i32)]) -> Sums {
        let mut counts: BTreeMap<(Source, [u32; 3]), i32> = BTreeMap::new();
        for (parts, coefficient) in terms {
            parts.0.iter().for_each(|(&key, times)| *counts.entry(key).or_default() += coefficient * times);
        }
        let mut left = Sums::new();
        for ((source, piece), times) in counts.into_iter().filter(|(_, times)| *times != 0) {
            let measure = self.rows.measure(piece);
            let sum = left.entry(source).or_default();
            sum.iter_mut().zip(measure).for_each(|(sum, x)| *sum += x * times);
        }
        left.retain(|_, measure| measure.iter().any(|x| !x.is_zero()));
        left
    }
}

/// Sets of triangles in one plane, joined by common parts. A part of two triangles has one of them as its source, so
/// measures are compared set by set.
#[derive(Clone, Default, Debug)]
pub struct Together {
    leaders: BTreeMap<Source, Source>,
}

impl Together {
    fn leader(&self, mut source: Source) -> Source {
        while let Some(&next) = self.leaders.get(&source) {
            source = next;
        }
        source
    }

    /// The pieces of each set, by the first triangle of it.
    #[must_use]
    pub fn merged(&self, parts: Parts) -> Parts {
        if self.leaders.is_empty() { parts } else { parts.with_sources(|source| self.leader(source)) }
    }
}

/// The names of both meshes.
const MESHES: [&str; 2] = ["first", "second"];

impl Laws<'_> {
    /// The triangles of both meshes that have parts in common.
    #[must_use]
    pub fn together(&self) -> Together {
        let mut together = Together::default();
        let alone = self.regions.triangles.len().saturating_sub(self.regions.also.len());
        for (&first, &second) in self.regions.sources[alone..].iter().zip(&self.regions.also) {
            let [first, second] = [first, Source { mesh: 1, triangle: second }].map(|source| together.leader(source));
            if first != second {
                together.leaders.insert(first.max(second), first.min(second));
            }
        }
        together
    }

    /// The normal of a triangle, twice as long as its area.
    pub(super) fn normal(&self, triangle: [Vertex; 3]) -> [Rational; 3] {
        let [a, b, c] = self.corners(triangle);
        let side = |p: &Point| [0, 1, 2].map(|i: usize| Rational::from(&p[i] - &a[i]));
        let [u, v] = [side(b), side(c)];
        let minor = |i: usize, j: usize| Rational::from(&u[i] * &v[j]) - Rational::from(&u[j] * &v[i]);
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    }

    /// The pieces of each result, with the result's orientation; `numbers` are those of the points.
    #[must_use]
    pub fn of_results(&self, numbers: &[u32]) -> [Parts; 4] {
        [0, 1, 2, 3].map(|at| {
            let mut parts = Parts::default();
            for (&triangle, &source) in self.solids[at].iter().zip(&self.sources[at]) {
                parts.add(source, self.places(triangle).map(|place| numbers[place as usize]));
            }
            parts
        })
    }

    /// The triangles in the surface of a mesh's inside, oriented with the inside behind them; `numbers` are those of
    /// the points.
    #[must_use]
    pub fn of_mesh(&self, mesh: usize, numbers: &[u32]) -> Parts {
        let of = &self.meshes[mesh];
        let mut parts = Parts::default();
        for ((&triangle, sides), at) in of.triangles().iter().zip(of.sides()).zip(0..) {
            let source = Source { mesh: u8::from(mesh == 1), triangle: at };
            let [a, b, c] = self.places(triangle).map(|place| numbers[place as usize]);
            match sides.map(|region| region != OUTSIDE) {
                [false, true] => parts.add(source, [a, b, c]),
                [true, false] => parts.add(source, [a, c, b]),
                _ => {}
            }
        }
        parts
    }

    /// Checks the volumes of the results, from their surfaces: those of the union and the intersection add up to those
    /// of the meshes, and so on. The same holds for areas, triangle by triangle: a part of a triangle is in the surface
    /// of the union, or in that of the intersection.
    pub fn results(&self, found: &mut Violations) {
        let together = self.together();
        let corners = Corners::of(&[&self.points]);
        let merged = |parts: Parts| together.merged(parts);
        let [union, intersection, difference, exclusive] = self.of_results(corners.numbers(0)).map(merged);
        let [first, second] = [0, 1].map(|mesh| merged(self.of_mesh(mesh, corners.numbers(0))));
        let laws: [(&str, Vec<(&Parts, i32)>); 3] = [
            (
                "union and intersection together equal both meshes together",
                vec![(&union, 1), (&intersection, 1), (&first, -1), (&second, -1)],
            ),
            (
                "difference and intersection together equal the first mesh",
                vec![(&difference, 1), (&intersection, 1), (&first, -1)],
            ),
            (
                "the symmetric difference equals the union less the intersection",
                vec![(&exclusive, 1), (&union, -1), (&intersection, 1)],
            ),
        ];
        for (law, terms) in laws {
            let left = corners.left(&terms);
            let areas: Vec<&Source> = left
                .iter()
                .filter(|(_, left)| left[..3].iter().any(|x| !x.is_zero()))
                .map(|(source, _)| source)
                .collect();
            if let Some(source) = areas.first() {
                let got = format!("{} triangles, first {}: its parts differ", areas.len(), name(**source));
                note(found, "areas of results", got, law);
            }
            let volume: Rational = left.values().map(|measure| &measure[3]).sum();
            if !volume.is_zero() {
                let got = format!("volumes are {:e} off", volume.to_f64() / 6.0);
                note(found, "volumes of results", got, law);
            }
        }
        if self.is_twice() {
            self.of_itself(&corners, [union, intersection, difference, exclusive], first, found);
        }
    }

    /// True if the second mesh equals the first.
    pub fn is_twice(&self) -> bool {
        let [first, second] = &self.meshes;
        let at = |v: Vertex| self.scene.point3(v);
        first.sides() == second.sides()
            && first.triangles().iter().zip(second.triangles()).all(|(a, b)| a.map(at) == b.map(at))
    }

    /// Checks for a mesh with itself that both meshes have the whole volume, and that the part of one alone has none.
    fn of_itself(&self, corners: &Corners<'_>, results: [Parts; 4], mesh: Parts, found: &mut Violations) {
        // Both copies of a triangle together, so that the difference is small.
        let as_first = |parts: Parts| parts.with_sources(|source| Source { mesh: 0, ..source });
        let mesh = as_first(mesh);
        for ((operation, parts), times) in Operation::ALL.into_iter().zip(results).zip([1, 1, 0, 0]) {
            let left = corners.left(&[(&as_first(parts), 1), (&mesh, -times)]);
            let volume: Rational = left.values().map(|measure| &measure[3]).sum();
            if !volume.is_zero() {
                let got = format!("the volume of the {} is {:e} off", operation.name(), volume.to_f64() / 6.0);
                note(
                    found,
                    "a mesh with itself",
                    got,
                    "union and intersection equal the mesh; differences have no volume",
                );
            }
        }
    }

    /// Checks that the volume of a region of a mesh equals the volume of all its parts.
    pub fn volumes(&self, found: &mut Violations) {
        let rows = Rows::of(&self.points);
        let six = |triangle: [Vertex; 3]| rows.volume(self.places(triangle));
        for (mesh, name) in MESHES.into_iter().enumerate() {
            // For each region: its boundary in the overlay, less that in the mesh, triangle by triangle.
            let mut missing: BTreeMap<(u32, Source), Rational> = BTreeMap::new();
            let regions = self.regions;
            for ((&triangle, sides), &source) in regions.triangles.iter().zip(&regions.sides).zip(&regions.sources) {
                let [front, behind] = sides.map(|side| regions.pairs[side as usize][mesh]);
                if front != behind {
                    let volume = six(triangle);
                    *missing.entry((behind, source)).or_default() += &volume;
                    *missing.entry((front, source)).or_default() -= &volume;
                }
            }
            let of = &self.meshes[mesh];
            for ((&triangle, &[front, behind]), at) in of.triangles().iter().zip(of.sides()).zip(0..) {
                if front != behind {
                    let source = Source { mesh: u8::from(mesh == 1), triangle: at };
                    let volume = six(triangle);
                    *missing.entry((behind, source)).or_default() -= &volume;
                    *missing.entry((front, source)).or_default() += &volume;
                }
            }
            let mut by_region: BTreeMap<u32, Rational> = BTreeMap::new();
            for ((region, _), volume) in missing.into_iter().filter(|(_, volume)| !volume.is_zero()) {
                *by_region.entry(region).or_default() += volume;
            }
            if let Some((region, volume)) = by_region.iter().find(|(_, volume)| !volume.is_zero()) {
                let got = format!(
                    "the parts of region {region} of the {name} mesh have {:e} more volume than the region",
                    volume.to_f64() / 6.0
                );
                note(found, "volume", got, "the volumes of a region's parts add up to its volume");
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use predicament_mesh::MaterialMesh;
    use predicament_predicates::Scene;

    use super::*;
    use crate::answer::Regions;

    /// A face of a tetrahedron in three results, turned over in one of them.
    #[test]
    fn each_result_has_the_measures_of_its_own_triangles() {
        let scene =
            Scene::from_points3(&[[1.0, 0.0, 0.5], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0], [0.0; 3]]).expect("finite");
        let [a, b, c, d] = [0, 1, 2, 3].map(Vertex::input);
        let faces = vec![[a, b, c], [b, a, d], [c, b, d], [a, c, d]];
        let mesh = Arc::new(MaterialMesh::new(4, faces, vec![[0, 1]; 4]).expect("a tetrahedron"));
        let (source, regions) = (Source { mesh: 0, triangle: 0 }, Regions::default());
        let laws = Laws {
            scene: &scene,
            meshes: &[mesh.clone(), mesh],
            regions: &regions,
            solids: &[vec![[a, b, c]], vec![[c, b, a]], vec![[b, c, a]], Vec::new()],
            sources: &[vec![source], vec![source], vec![source], Vec::new()],
            constructions: &[],
            before: 0,
            points: crate::truth::given(&scene),
        };
        let [x, y, z] = laws.normal([a, b, c]);
        let measure = [x, y, z, Rational::from(6)];
        let turned = measure.each_ref().map(|x| Rational::from(-x));
        let corners = Corners::of(&[&laws.points]);
        let of = |measure: &Measure| Sums::from([(source, measure.clone())]);
        let results = laws.of_results(corners.numbers(0)).map(|parts| corners.left(&[(&parts, 1)]));
        assert_eq!(results, [of(&measure), of(&turned), of(&measure), Sums::new()]);
        assert_eq!(corners.left(&[(&laws.of_mesh(0, corners.numbers(0)), 1)])[&source], measure);
    }

    /// Triangles between points of a small grid, some of them at one position: whatever cancels, the sums are those of
    /// all pieces.
    #[test]
    fn pieces_that_cancel_have_no_measure_together() {
        let mut state = 13_u64;
        let mut next = |bound: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            u32::try_from(state >> 33).expect("31 bits") % bound
        };
        let lists: [Vec<Point>; 2] =
            [(); 2].map(|()| (0..9).map(|_| [0, 1, 2].map(|_| Rational::from((next(2), 3)))).collect());
        let corners = Corners::of(&[&lists[0], &lists[1]]);
        let (mut cancelled, mut left) = (0, 0);
        for _ in 0..300 {
            let mut plain = Sums::new();
            let mut parts = [(); 2].map(|()| Parts::default());
            for _ in 0..next(9) {
                let source = Source { mesh: 0, triangle: next(2) };
                let list = next(2) as usize;
                let triangle = [next(9), next(9), next(9)];
                let measure = Rows::of(&lists[list]).measure(triangle);
                let numbered = triangle.map(|place| corners.numbers(list)[place as usize]);
                let coefficient = if next(2) == 0 { 1 } else { -2 };
                parts[usize::from(coefficient < 0)].add(source, numbered);
                let sum = plain.entry(source).or_default();
                sum.iter_mut().zip(measure).for_each(|(sum, x)| *sum += x * coefficient);
            }
            plain.retain(|_, measure| measure.iter().any(|x| !x.is_zero()));
            let [once, twice] = &parts;
            assert_eq!(corners.left(&[(once, 1), (twice, -2)]), plain);
            cancelled += usize::from(plain.is_empty());
            left += usize::from(!plain.is_empty());
        }
        assert!(cancelled > 20 && left > 100, "{cancelled} {left}");
    }
}
