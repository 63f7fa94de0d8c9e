//! Volumes and areas, summed in rationals triangle by triangle.
//!
//! Most pieces are in two or three results, with either orientation: each is measured once.

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

    /// The sums of each set, by the first triangle of it.
    #[must_use]
    pub fn merged(&self, sums: Sums) -> Sums {
        if self.leaders.is_empty() {
            return sums;
        }
        let mut merged = Sums::new();
        sums.iter().for_each(|(source, measure)| add(&mut merged, self.leader(*source), measure, 1));
        merged
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

    /// The measures of each source triangle in each result, with the result's orientation.
    #[must_use]
    pub fn of_results(&self) -> [Sums; 4] {
        let (rows, mut known) = (Rows::of(&self.points), HashMap::new());
        [0, 1, 2, 3].map(|at| {
            let mut sums = Sums::new();
            for (&triangle, &source) in self.solids[at].iter().zip(&self.sources[at]) {
                let (piece, is_turned) = ascending(self.places(triangle));
                let measure = known.entry(piece).or_insert_with(|| rows.measure(piece));
                add(&mut sums, source, measure, if is_turned { -1 } else { 1 });
            }
            sums
        })
    }

    /// The measures of each triangle in the surface of its mesh's inside, oriented with the inside behind it.
    pub fn of_mesh(&self, mesh: usize) -> Sums {
        let (of, rows) = (&self.meshes[mesh], Rows::of(&self.points));
        let mut sums = Sums::new();
        for ((&triangle, sides), at) in of.triangles().iter().zip(of.sides()).zip(0..) {
            let times = match sides.map(|region| region != OUTSIDE) {
                [false, true] => 1,
                [true, false] => -1,
                _ => continue,
            };
            let measure = rows.measure(self.places(triangle));
            add(&mut sums, Source { mesh: u8::from(mesh == 1), triangle: at }, &measure, times);
        }
        sums
    }

    /// Checks the volumes of the results, from their surfaces: those of the union and the intersection add up to those
    /// of the meshes, and so on. The same holds for areas, triangle by triangle: a part of a triangle is in the surface
    /// of the union, or in that of the intersection.
    pub fn results(&self, found: &mut Violations) {
        let together = self.together();
        let merged = |sums: Sums| together.merged(sums);
        let [union, intersection, difference, exclusive] = self.of_results().map(merged);
        let [first, second] = [0, 1].map(|mesh| merged(self.of_mesh(mesh)));
        let laws: [(&str, Vec<(&Sums, i32)>); 3] = [
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
            let mut left = Sums::new();
            for (sums, times) in terms {
                sums.iter().for_each(|(source, measure)| add(&mut left, *source, measure, times));
            }
            left.retain(|_, measure| measure.iter().any(|x| !x.is_zero()));
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
            self.of_itself([&union, &intersection, &difference, &exclusive], &first, found);
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
    fn of_itself(&self, results: [&Sums; 4], mesh: &Sums, found: &mut Violations) {
        for ((operation, sums), times) in Operation::ALL.into_iter().zip(results).zip([1, 1, 0, 0]) {
            // Both copies of a triangle together, so that the difference is small.
            let mut left = Sums::new();
            let as_first = |source: &Source| Source { mesh: 0, ..*source };
            sums.iter().for_each(|(source, measure)| add(&mut left, as_first(source), measure, 1));
            mesh.iter().for_each(|(source, measure)| add(&mut left, as_first(source), measure, -times));
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

/// Adds a measure `times` times.
pub fn add(sums: &mut Sums, source: Source, measure: &Measure, times: i32) {
    if times == 0 {
        return;
    }
    let sum = sums.entry(source).or_default();
    sum.iter_mut().zip(measure).for_each(|(sum, x)| if times > 0 { *sum += x } else { *sum -= x });
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
        let of = |measure: &Measure| Sums::from([(source, measure.clone())]);
        assert_eq!(laws.of_results(), [of(&measure), of(&turned), of(&measure), Sums::new()]);
        assert_eq!(laws.of_mesh(0)[&source], measure);
    }
}
