//! The regions of pieces, and of points in space: a sample of both against the judge of points in meshes.

use predicament_judge::solids::{Boundary, Materials, Place};
use predicament_mesh::OUTSIDE;
use predicament_overlay::answer::Operation;
use predicament_predicates::{Scene, Vertex};
use rug::Rational;

use super::settled::Settlement;
use super::{Laws, Violations, name, note};

/// Directions of rays, one after the other until a ray misses all edges.
fn directions() -> impl Iterator<Item = [i32; 3]> {
    (0..64).map(|k| [83 - 37 * k, 31 + 41 * (k % 7) - 5 * k, 17 + 23 * (k % 5) + 3 * k])
}

/// Returns true if a point may be said to be in a region: on a triangle, in the region of either side.
fn is_of(place: &Place, region: u32, sides: &[[u32; 2]]) -> bool {
    match place {
        Place::In(found) => *found == region,
        Place::On(triangles) => triangles.iter().any(|&at| sides[at as usize].contains(&region)),
        Place::Windings(around) => around.iter().any(|(found, _)| *found == region),
    }
}

impl Laws<'_> {
    /// Checks that the middle of each sampled piece is in the region stated for the piece; on the other mesh, either
    /// side is right.
    pub fn located(&self, budget: usize, found: &mut Violations) {
        let regions = self.regions;
        let mut wrong = 0;
        for mesh in 0..2 {
            let other = &self.meshes[1 - mesh];
            let materials = Materials::new(self.scene, other.triangles(), other.sides());
            let judge = materials.in_integers();
            let own: Vec<usize> =
                (0..regions.triangles.len()).filter(|&at| usize::from(regions.sources[at].mesh) == mesh).collect();
            let many = (budget / other.triangles().len()).clamp(4, own.len().max(4));
            for &at in own.iter().step_by(own.len().div_ceil(many).max(1)) {
                let corners = self.corners(regions.triangles[at]);
                let middle = [0, 1, 2].map(|axis: usize| {
                    let sum: Rational = corners.iter().map(|corner| &corner[axis]).sum();
                    sum / 3
                });
                let said = regions.pairs[regions.sides[at][0] as usize][1 - mesh];
                let place = directions().find_map(|direction| judge.winding(&middle, direction));
                let is_right = place.as_ref().is_some_and(|place| is_of(place, said, other.sides()));
                if !is_right {
                    wrong += 1;
                    if wrong == 1 {
                        let of = name(regions.sources[at]);
                        let got = format!(
                            "a piece of {of} is reported in region {said} of the other mesh, but is in {place:?}"
                        );
                        note(found, "region of a piece", got, "a piece is in the region of its centroid");
                    }
                }
            }
        }
    }

    /// Checks that points in space are in a result if and only if the operation says so for their locations. Each point
    /// is located in both meshes, and in the surface of each result, with a perturbation and without, and in doubles.
    /// Points on any of these surfaces are left out.
    pub fn probed(&self, probes: &[[f64; 3]], settlement: Option<&Settlement<'_>>, found: &mut Violations) {
        let count = self.scene.len();
        let given = self.scene.vertices().map(|v| self.scene.point3(v));
        let points: Vec<[f64; 3]> = given.chain(probes.iter().copied()).collect();
        let Ok(scene) = Scene::from_points3(&points) else { return };
        let meshes = self.meshes.each_ref().map(|mesh| Materials::new(&scene, mesh.triangles(), mesh.sides()));
        let perturbed = Operation::ALL.into_iter().zip(self.solids).map(|(operation, solid)| {
            let triangles = solid.iter().map(|&triangle| self.places(triangle)).collect();
            (operation, Boundary::new(self.points.clone(), triangles))
        });
        let results: Vec<_> = perturbed.collect();
        for (at, &probe) in probes.iter().enumerate() {
            let places = meshes.each_ref().map(|mesh| mesh.locate(Vertex::input(count + at)));
            let [Place::In(first), Place::In(second)] = places else { continue };
            let inside = [first, second].map(|region| region != OUTSIDE);
            let of_perturbed = results.iter().find_map(|(operation, result)| {
                let winding = result.winding(probe)?;
                let is_wrong = winding != i64::from(operation.holds(inside));
                is_wrong.then_some(("the surface", *operation, winding))
            });
            let wrong = of_perturbed.or_else(|| settlement?.probed(probe, inside));
            if let Some((what, operation, winding)) = wrong {
                let [x, y, z] = probe;
                let got = format!(
                    "{what} of the {} goes {winding} times around ({x}, {y}, {z}), which is in region {first} of the \
                     first mesh and in region {second} of the second",
                    operation.name()
                );
                let law = "the surface of a result goes once around its points, and not around any other point";
                note(found, "point in a result", got, law);
                return;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_outcome_has_its_wrong_regions() {
        let sides = [[0, 1], [2, 0], [3, 4]];
        assert!(is_of(&Place::In(2), 2, &sides) && !is_of(&Place::In(2), 0, &sides));
        let on = Place::On(vec![0, 1]);
        assert!([0, 1, 2].iter().all(|&region| is_of(&on, region, &sides)));
        assert!([3, 4].iter().all(|&region| !is_of(&on, region, &sides)));
        let around = Place::Windings(vec![(1, 2), (3, -1)]);
        assert!(is_of(&around, 3, &sides) && !is_of(&around, 0, &sides));
    }

    #[test]
    fn no_two_of_the_directions_are_parallel() {
        let all: Vec<[i32; 3]> = directions().collect();
        let is_parallel = |[a, b, c]: [i32; 3], [x, y, z]: [i32; 3]| a * y == b * x && b * z == c * y && a * z == c * x;
        for (at, &direction) in all.iter().enumerate() {
            assert!(direction != [0; 3] && all[..at].iter().all(|&other| !is_parallel(direction, other)), "{at}");
        }
    }
}
