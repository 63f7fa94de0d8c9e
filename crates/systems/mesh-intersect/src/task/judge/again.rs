//! Repeated overlays by the same backend: with the meshes exchanged, and a difference as an intersection.
//!
//! # Exchanged
//! The overlay of B and A has the volumes of that of A and B. If nothing touches, it also has the same parts of the
//! same triangles. Otherwise a perturbation that moves the second mesh now moves the other one, and sheets without
//! volume appear and vanish.
//!
//! # Complement
//! A∖B is the intersection of A and the complement of B in a box around both. The complement is given as a mesh: the
//! box, and the surface of B with its sides exchanged, over the same vertices, with the box's vertices after all
//! others. So each perturbation moves A and B as before, and results have the same parts of the same triangles, even
//! with ties.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::answer::Source;
use crate::checks::{Corners, Parts, Violations, name, note};
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_predicates::{PredicateKind, Scene, Vertex, ZeroMeaning};
use rug::Rational;

use super::{Judging, MeshIntersect, TwoMeshes, points};
use crate::task::content::for_both;
use predicament_tasks::typed::FACES;
use predicament_tasks::{Asked, Stop};

/// A scene of two meshes.
struct Other {
    scene: Scene,
    content: TwoMeshes,
}

impl Other {
    fn new(points: &[[f64; 3]], meshes: [MaterialMesh; 2]) -> Option<Other> {
        let [first, second] = &meshes;
        let scene = for_both(Scene::from_points3(points).ok()?, [first, second]);
        Some(Other { scene, content: TwoMeshes { meshes: meshes.map(Arc::new), is_as_it_is: true } })
    }
}

/// A function that compares the pieces of each result with those of another overlay, over these corners.
type Comparison<'l> = dyn Fn(&Corners<'_>, [Parts; 4], [Parts; 4], &mut Violations) + 'l;

impl Judging<'_> {
    /// Overlays the meshes again, and compares the results.
    pub(super) fn again(&self, asked: &Asked<'_>, found: &mut Violations) -> Result<(), Stop> {
        let is_exact = asked.contract(PredicateKind::Orient3d).zero == ZeroMeaning::Exact;
        self.with_exchanged(asked, is_exact, found);
        asked.watch.done(0)?;
        self.with_complement(asked, found);
        asked.watch.done(0)
    }

    /// Passes the pieces of each result, and of each result of another scene, to `compare`, with the corners of both;
    /// `places` maps the other's sources to those here. A finding is recorded if there are no results.
    fn with_results_of(
        &self,
        other: &Other,
        asked: &Asked<'_>,
        check: &'static str,
        places: &dyn Fn(Source) -> Source,
        found: &mut Violations,
        compare: &Comparison<'_>,
    ) {
        let law = "an overlay is possible in both ways, or in neither";
        let answer = match asked.backend.answer(&MeshIntersect, &other.scene, &other.content) {
            Ok(answer) => answer,
            Err(why) => {
                // A box is longer than the meshes, and tolerances grow with lengths.
                if asked.contract(PredicateKind::Orient3d).zero != ZeroMeaning::Band {
                    note(found, check, why.to_string(), law);
                }
                return;
            }
        };
        if let Some(broken) = answer.broken {
            note(found, check, broken.to_string(), law);
            return;
        }
        let Ok(points) = points(&other.scene, &answer, self.place) else {
            note(found, check, "a vertex is not a point".to_owned(), law);
            return;
        };
        let judged = Judging::new(&other.scene, &other.content, &answer, points, self.place);
        let corners = Corners::of(&[&self.laws.points, &judged.laws.points]);
        // Parts of two triangles may have the other one as source.
        let together = self.laws.together();
        let own = self.laws.of_results(corners.numbers(0)).map(|parts| together.merged(parts));
        let results = judged.laws.of_results(corners.numbers(1));
        let results = results.map(|parts| together.merged(parts.with_sources(places)));
        compare(&corners, own, results, found);
    }

    fn with_exchanged(&self, asked: &Asked<'_>, is_exact: bool, found: &mut Violations) {
        const CHECK: &str = "meshes exchanged";
        // The vertices of the second mesh come first.
        let is_of_second = self.laws.scene.second_mesh().unwrap_or_default();
        let is_of_second = |v: Vertex| is_of_second.get(v.index()).copied().unwrap_or_default();
        let (mut order, rest): (Vec<Vertex>, Vec<Vertex>) = self.laws.scene.vertices().partition(|&v| is_of_second(v));
        order.extend(rest);
        let place: BTreeMap<Vertex, Vertex> = order.iter().enumerate().map(|(at, &v)| (v, Vertex::input(at))).collect();
        let points: Vec<[f64; 3]> = order.iter().map(|&v| self.laws.scene.point3(v)).collect();
        let moved = |mesh: &MaterialMesh| {
            let triangles = mesh.triangles().iter().map(|triangle| triangle.map(|v| place[&v])).collect();
            MaterialMesh::new(points.len(), triangles, mesh.sides().to_vec())
        };
        let [first, second] = &self.laws.meshes;
        let (Ok(first), Ok(second)) = (moved(first), moved(second)) else { return };
        let Some(other) = Other::new(&points, [second, first]) else { return };
        let back = |source: Source| Source { mesh: 1 - source.mesh, ..source };
        self.with_results_of(&other, asked, CHECK, &back, found, &|corners, own, results, found| {
            let second = self.laws.together().merged(self.laws.of_mesh(1, corners.numbers(0)));
            // The difference of the second and the first, together with the intersection, is the second.
            let laws: [(&str, Vec<(&Parts, i32)>); 4] = [
                ("the unions are the same", vec![(&own[0], 1), (&results[0], -1)]),
                ("the intersections are the same", vec![(&own[1], 1), (&results[1], -1)]),
                ("B∖A and the intersection together equal B", vec![(&results[2], 1), (&own[1], 1), (&second, -1)]),
                ("the symmetric differences are the same", vec![(&own[3], 1), (&results[3], -1)]),
            ];
            for (law, terms) in laws {
                let left = corners.left(&terms);
                let volume: Rational = left.values().map(|measure| &measure[3]).sum();
                if !volume.is_zero() {
                    note(found, CHECK, format!("volumes are {:e} off", volume.to_f64() / 6.0), law);
                } else if is_exact && let Some((source, _)) = left.first_key_value() {
                    note(found, CHECK, format!("{}: its parts differ", name(*source)), law);
                }
            }
        });
    }

    fn with_complement(&self, asked: &Asked<'_>, found: &mut Violations) {
        const CHECK: &str = "difference by complement";
        let mut points: Vec<[f64; 3]> = self.laws.scene.vertices().map(|v| self.laws.scene.point3(v)).collect();
        let count = points.len();
        let largest = points.as_flattened().iter().fold(1.0_f64, |largest, x| largest.max(x.abs()));
        let half = 2.0 * largest;
        if !half.is_finite() {
            return;
        }
        points
            .extend((0..8).map(|corner: u8| [0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { -half } else { half })));
        let of = &self.laws.meshes[1];
        // The surface of the second mesh, and the indices of its triangles.
        let (mut triangles, mut sides, mut places) = (Vec::new(), Vec::new(), Vec::new());
        for ((triangle, of_triangle), at) in of.triangles().iter().zip(of.sides()).zip(0..) {
            let outside = of_triangle.map(|region| u32::from(region == OUTSIDE));
            if outside[0] != outside[1] {
                triangles.push(*triangle);
                sides.push(outside);
                places.push(at);
            }
        }
        triangles.extend(FACES.map(|triangle| triangle.map(|corner| Vertex::input(count + corner))));
        sides.extend([[OUTSIDE, 1]; FACES.len()]);
        let Ok(complement) = MaterialMesh::new(points.len(), triangles, sides) else { return };
        let first = MaterialMesh::clone(&self.laws.meshes[0]);
        let Some(other) = Other::new(&points, [first, complement]) else { return };
        // Triangles of the box come after the mesh's triangles.
        let beyond = u32::MAX - u32::try_from(FACES.len()).unwrap_or(u32::MAX);
        let back = |source: Source| {
            let at = source.triangle as usize;
            let of_box = || beyond.saturating_add(u32::try_from(at - places.len()).unwrap_or(u32::MAX));
            match source.mesh {
                0 => source,
                _ => Source { triangle: places.get(at).copied().unwrap_or_else(of_box), ..source },
            }
        };
        self.with_results_of(&other, asked, CHECK, &back, found, &|corners, own, results, found| {
            let left = corners.left(&[(&own[2], 1), (&results[1], -1)]);
            if let Some((source, _)) = left.first_key_value() {
                let of = if source.triangle >= beyond { "the box".to_owned() } else { name(*source) };
                let got = format!("{} triangles, first {of}: its parts differ", left.len());
                note(found, CHECK, got, "A∖B equals the intersection of A and the complement of B");
            }
        });
    }
}
