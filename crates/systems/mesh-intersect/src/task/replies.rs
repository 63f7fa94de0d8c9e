//! The judge of other programs' Boolean operations on solids.

use std::collections::BTreeMap;

use predicament_judge::skin::Skin;
use predicament_judge::skin::shells::Shells;
use predicament_judge::{nearest, sign};
use predicament_mesh::OUTSIDE;
use predicament_overlay::answer::Operation;
use predicament_predicates::{Declined, Plane, Question, Scene, Vertex};
use predicament_tasks::replies::{
    Array, Arrays, Bound, Example, FORM, Form, Malformed, Mesh, Part, Replies, Reply, SpoiledReply, Unjudged, add_row,
    note,
};
use predicament_tasks::{Asked, Case, Check, Class, Outcome};

use super::{MeshIntersect, Overlaid, TwoMeshes};
use crate::checks::replies::{CROSSING, OFF, OPEN, SOLID, Solids, VOLUME};
use crate::checks::shells::{COMPONENTS, EULER, Wanted};

/// The judge.
pub(super) struct Judge;

/// The numbers of points beside each surface, at the two levels.
const WITNESSES: [usize; 2] = [400, 4_000];

const OFF_MEANS: &str = "a program's result: each vertex is on a surface of an operand, up to rounding";
const OPEN_MEANS: &str = "a program's result: at each edge, as many triangles come as go";
const SOLID_MEANS: &str = "a program's result: it goes once around the points of the operation, and not around others";
const CROSSING_MEANS: &str = "a program's result: no edge passes through a triangle by more than rounding";
const VOLUME_MEANS: &str = "a program's results: their volumes add up to those of the operands, up to rounding";

const COMPONENTS_MEANS: &str = "a program's union: it has one part for all parts of the operands that meet";
const EULER_MEANS: &str =
    "a program's results: the Euler characteristics of union and intersection add up to the operands'";

/// The largest number of triangles of both operands for which components and Euler characteristics are judged.
const MOST_TRIANGLES: usize = 20_000;

impl Replies<MeshIntersect> for Judge {
    fn parts(&self) -> &'static [Part] {
        const {
            &[
                Part::optional("union", Form::Mesh, "the surface of the points in either solid or both"),
                Part::optional("intersection", Form::Mesh, "the surface of the points in both"),
                Part::optional(
                    "difference",
                    Form::Mesh,
                    "the surface of the points in the first, but not in the second",
                ),
                Part::optional("symmetric-difference", Form::Mesh, "the surface of the points in exactly one"),
            ]
        }
    }

    fn example(&self) -> Example {
        Example {
            suites: "intersections",
            functions: &[
                ("python", include_str!("../engines/mesh_intersect.py")),
                ("cpp", include_str!("../engines/mesh_intersect.cpp")),
                ("rust", include_str!("../engines/mesh_intersect.rs")),
                ("node", include_str!("../engines/mesh_intersect.mjs")),
            ],
        }
    }

    /// Declines meshes of several materials, and surfaces that are not closed manifolds.
    fn open(&self, scene: &Scene, content: &TwoMeshes) -> Result<(), Declined> {
        let is_plain = |sides: &[u32; 2]| *sides == [OUTSIDE, 1];
        if content.meshes.iter().any(|mesh| !mesh.sides().iter().all(is_plain)) {
            return Err(Declined::scene("a mesh has several regions, and programs get the surfaces of solids"));
        }
        let [first, second] = &content.meshes;
        // Without `check = false`, a scene of invalid meshes is marked as invalid input, and programs should refuse it.
        if content.is_as_it_is && super::flaw::is_refused(scene, [first, second]) {
            return Err(Declined::scene("an operand is not the surface of a solid"));
        }
        let flaw = content.meshes.iter().find_map(|mesh| not_manifold(scene, mesh.triangles()));
        flaw.map_or(Ok(()), |why| Err(Declined::scene(format!("an operand {why}, which libraries exclude"))))
    }

    fn judge(
        &self,
        case: &Case<'_, MeshIntersect>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let scene = case.scene();
        let given = |triangle: &[Vertex; 3]| triangle.map(|v| scene.point3(v));
        let skin = |at: usize| Skin::new(case.content.meshes[at].triangles().iter().map(given).collect());
        let solids = Solids::new([skin(0), skin(1)]);
        let corners = case.content.meshes.each_ref().map(|mesh| mesh.triangles().as_flattened());
        let bound = Bound::of(scene, corners);
        let mut results: [Option<Mesh>; 4] = Default::default();
        for (result, operation) in results.iter_mut().zip(Operation::ALL) {
            let name = operation.name();
            if reply.arrays.get(&format!("{name}.triangles")).is_some() {
                *result = Some(reply.arrays.mesh(name)?);
            }
        }
        if results.iter().all(Option::is_none) {
            let names = Operation::ALL.map(Operation::name).join("`, `");
            return Err(Malformed(format!("none of `{names}`; the answer has {}", reply.arrays.names())).into());
        }
        let most = WITNESSES[usize::from(asked.budget.thorough)];
        let mut known = None;
        let mut skins: [Option<(Skin, f64)>; 4] = Default::default();
        for ((operation, mesh), place) in Operation::ALL.into_iter().zip(results).zip(&mut skins) {
            let Some(mesh) = mesh else { continue };
            asked.watch.done(0)?;
            let name = operation.name();
            let used = used(&mesh);
            let far = bound.class(solids.farthest(&used, bound.nearest));
            add_row(case, asked, (name, used.len()), (&bound, &far), outcome);
            if far.class != Class::Agree {
                let got = format!("{name}: a vertex is {} off", bound.told(far.distance));
                note(outcome, far.class, OFF, got, OFF_MEANS);
                if far.class == Class::Topology {
                    continue;
                }
            }
            if known.as_ref().is_none_or(|(within, _)| *within != far.within) {
                known = Some((far.within, solids.points([far.within, bound.coarsest], most)));
            }
            let Some((within, witnesses)) = &known else { continue };
            let skin = Skin::new(mesh.corners());
            for flaw in solids.violations(operation, &skin, [*within, bound.coarsest], witnesses, most) {
                let (class, told) = bound.violated(flaw.distance);
                note(outcome, class, flaw.check, format!("{name}: {}{told}", flaw.what), means(flaw.check));
            }
            *place = Some((skin, *within));
        }
        let skins = skins.each_ref().map(|result| result.as_ref().map(|(skin, within)| (skin, *within)));
        for flaw in solids.volumes(skins) {
            let (class, told) = bound.violated(flaw.distance);
            note(outcome, class, flaw.check, format!("{}{told}", flaw.what), means(flaw.check));
        }
        shells(&solids, skins, outcome);
        Ok(())
    }

    fn reply_of(&self, scene: &Scene, _: &TwoMeshes, answer: &Overlaid) -> Arrays {
        let mut arrays = Arrays::default();
        let mut exact = scene.clone();
        if answer.constructions.iter().any(|definition| exact.construct(*definition).is_err()) {
            return arrays;
        }
        let points = predicament_judge::Points::of(&exact);
        let place = |v: Vertex| match points.point(v) {
            Some(point) => [0, 1, 2].map(|axis: usize| nearest(&point[axis])),
            None => [f64::NAN; 3],
        };
        for (operation, triangles) in Operation::ALL.into_iter().zip(&answer.solids) {
            let mut numbers = BTreeMap::new();
            for v in triangles.as_flattened() {
                let next = u32::try_from(numbers.len()).unwrap_or(u32::MAX);
                numbers.entry(*v).or_insert(next);
            }
            let mut order: Vec<(u32, Vertex)> = numbers.iter().map(|(&v, &at)| (at, v)).collect();
            order.sort_unstable();
            let mesh = Mesh {
                points: order.into_iter().map(|(_, v)| place(v)).collect(),
                triangles: triangles.iter().map(|triangle| triangle.map(|v| numbers[&v])).collect(),
            };
            arrays.add_mesh(operation.name(), &mesh);
        }
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::topology(OFF, OFF_MEANS),
                Check::rounded(OFF, OFF_MEANS),
                Check::topology(OPEN, OPEN_MEANS),
                Check::topology(SOLID, SOLID_MEANS),
                Check::rounded(SOLID, SOLID_MEANS),
                Check::topology(CROSSING, CROSSING_MEANS),
                Check::topology(VOLUME, VOLUME_MEANS),
                Check::rounded(VOLUME, VOLUME_MEANS),
                Check::topology(COMPONENTS, COMPONENTS_MEANS),
                Check::topology(EULER, EULER_MEANS),
            ]
        }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<MeshIntersect>> {
        vec![
            SpoiledReply {
                name: "mesh-intersect-reply-has-a-vertex-too-many",
                what: "a corner of the union is the vertex after the last one",
                backend: BACKEND,
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(ids)) = arrays.get_mut("union.triangles")
                        && let Some(id) = ids.first_mut()
                    {
                        *id = u32::MAX;
                    }
                },
            },
            SpoiledReply {
                name: "mesh-intersect-reply-is-in-singles",
                what: "the union's vertices are rounded to single precision",
                backend: BACKEND,
                caught_by: &[(Class::Rounded, OFF)],
                spoil: |_, _, arrays| each(arrays, "union", |x| f64::from(single(x))),
            },
            SpoiledReply {
                name: "mesh-intersect-reply-slides-a-vertex",
                what: "the union's first vertex is moved along an edge, by 2^-26 of the edge",
                backend: BACKEND,
                caught_by: &[(Class::Rounded, SOLID), (Class::Rounded, VOLUME)],
                spoil: |_, _, arrays| {
                    if let Ok(mut mesh) = arrays.mesh("union")
                        && let Some(&[from, to, _]) = mesh.triangles.first()
                    {
                        let [p, q] = [from, to].map(|v| mesh.points[v as usize]);
                        mesh.points[from as usize] = [0, 1, 2].map(|i: usize| p[i] + (q[i] - p[i]) * 2.0_f64.powi(-26));
                        arrays.remove("union");
                        arrays.add_mesh("union", &mesh);
                    }
                },
            },
            SpoiledReply {
                name: "mesh-intersect-reply-grows",
                what: "the union's vertices are twice as far from the origin",
                backend: BACKEND,
                caught_by: &[(Class::Topology, OFF)],
                spoil: |_, _, arrays| each(arrays, "union", |x| 2.0 * x + 1.0),
            },
            SpoiledReply {
                name: "mesh-intersect-reply-loses-a-triangle",
                what: "the last triangle of the union is missing",
                backend: BACKEND,
                caught_by: &[(Class::Topology, OPEN)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(ids)) = arrays.get_mut("union.triangles") {
                        ids.truncate(ids.len().saturating_sub(3));
                    }
                },
            },
            SpoiledReply {
                name: "mesh-intersect-reply-exchanges-results",
                what: "the union stands for the intersection",
                backend: BACKEND,
                caught_by: &[(Class::Topology, SOLID), (Class::Topology, VOLUME)],
                spoil: |_, _, arrays| {
                    if let Ok(mesh) = arrays.mesh("union") {
                        arrays.remove("intersection");
                        arrays.add_mesh("intersection", &mesh);
                    }
                },
            },
            SpoiledReply {
                name: "mesh-intersect-reply-adds-a-part",
                what: "the union has a tetrahedron more, between the middles of four triangles",
                backend: BACKEND,
                caught_by: &[(Class::Topology, COMPONENTS), (Class::Topology, EULER)],
                spoil: |scene, content, arrays| {
                    if let Ok(mut mesh) = arrays.mesh("union") {
                        let triangles = content.meshes[0].triangles();
                        let middle = |quarter: usize| {
                            let corners = triangles[quarter * (triangles.len() - 1) / 3].map(|v| scene.point3(v));
                            [0, 1, 2].map(|i: usize| corners.iter().map(|p| p[i] / 3.0).sum::<f64>())
                        };
                        let places = [0, 1, 2, 3].map(middle);
                        let first = u32::try_from(mesh.points.len()).unwrap_or(u32::MAX);
                        mesh.points.extend(places);
                        let [a, b, c, d] = [0, 1, 2, 3].map(|at| first + at);
                        let faces = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]];
                        let corners: Vec<_> = faces.iter().map(|face| face.map(|v| mesh.points[v as usize])).collect();
                        let is_turned = Skin::new(corners).six().cmp0().is_lt();
                        let turned = |[a, b, c]: [u32; 3]| if is_turned { [a, c, b] } else { [a, b, c] };
                        mesh.triangles.extend(faces.map(turned));
                        arrays.remove("union");
                        arrays.add_mesh("union", &mesh);
                    }
                },
            },
            SpoiledReply {
                name: "mesh-intersect-reply-is-not-cut",
                what: "the union is both operands, one beside the other",
                backend: BACKEND,
                caught_by: &[(Class::Topology, CROSSING)],
                spoil: |scene, content, arrays| {
                    let both = content.meshes.iter().flat_map(|mesh| mesh.triangles());
                    let number = |v: Vertex| u32::try_from(v.index()).unwrap_or(u32::MAX);
                    let mesh = Mesh {
                        points: scene.vertices().map(|v| scene.point3(v)).collect(),
                        triangles: both.map(|triangle| triangle.map(number)).collect(),
                    };
                    *arrays = Arrays::default();
                    arrays.add_mesh("union", &mesh);
                },
            },
        ]
    }
}

/// Judges the components of the union, and the Euler characteristics of union and intersection.
fn shells(solids: &Solids, results: [Option<(&Skin, f64)>; 4], outcome: &mut Outcome) {
    let [Some((union, within)), both, ..] = results else { return };
    let within = both.map_or(within, |(_, of_both)| within.max(of_both));
    if solids.operands().iter().map(|skin| skin.triangles().len()).sum::<usize>() > MOST_TRIANGLES {
        return;
    }
    let Some(wanted) = Wanted::of(solids.operands(), within) else { return };
    let of = |skin: &Skin| Shells::of(skin.triangles(), 2.0 * within);
    let union = of(union);
    if union.solids() != wanted.components {
        let got = format!("the union has {} parts, expected {}", union.solids(), wanted.components);
        note(outcome, Class::Topology, COMPONENTS, got, COMPONENTS_MEANS);
    }
    let Some((both, _)) = both else { return };
    let euler = union.euler() + of(both).euler();
    if euler != wanted.euler {
        let got = format!("they add up to {euler}, expected {}", wanted.euler);
        note(outcome, Class::Topology, EULER, got, EULER_MEANS);
    }
}

/// The backend whose answers are spoiled: it answers all scenes.
const BACKEND: &str = "sos:per-mesh";

/// The reason why a mesh is not a manifold, as libraries require; `None` if it is one.
///
/// Points at one place are one point. Each edge has one triangle on either side, in opposite directions, and each
/// triangle has an area. (Solids that share an edge or that are folded flat are legal scenes of the task.)
fn not_manifold(scene: &Scene, triangles: &[[Vertex; 3]]) -> Option<&'static str> {
    let key = |v: Vertex| scene.point3(v).map(|x| (x + 0.0).to_bits());
    let mut edges: BTreeMap<[[u64; 3]; 2], [u32; 2]> = BTreeMap::new();
    for triangle in triangles {
        let planes = [Plane::Xy, Plane::Yz, Plane::Zx];
        if planes.into_iter().all(|plane| sign(scene, Question::Orient2d(plane), triangle).is_zero()) {
            return Some("has a triangle without area");
        }
        let [a, b, c] = triangle.map(key);
        for [p, q] in [[a, b], [b, c], [c, a]] {
            edges.entry([p.min(q), p.max(q)]).or_default()[usize::from(p < q)] += 1;
        }
    }
    edges.values().any(|uses| *uses != [1, 1]).then_some("has an edge with other than two triangles")
}

/// The law behind a check.
fn means(check: &str) -> &'static str {
    let laws = [
        (OPEN, OPEN_MEANS),
        (SOLID, SOLID_MEANS),
        (CROSSING, CROSSING_MEANS),
        (VOLUME, VOLUME_MEANS),
        (OFF, OFF_MEANS),
    ];
    laws.into_iter().find(|(name, _)| *name == check).map_or("", |(_, means)| means)
}

/// The vertices that triangles use.
fn used(mesh: &Mesh) -> Vec<[f64; 3]> {
    let mut is_used = vec![false; mesh.points.len()];
    mesh.triangles.iter().flatten().for_each(|&v| is_used[v as usize] = true);
    mesh.points.iter().zip(is_used).filter(|(_, is_used)| *is_used).map(|(point, _)| *point).collect()
}

/// Changes all coordinates of a part.
fn each(arrays: &mut Arrays, part: &str, change: impl Fn(f64) -> f64) {
    if let Some(Array::Numbers(numbers)) = arrays.get_mut(&format!("{part}.vertices")) {
        numbers.iter_mut().for_each(|x| *x = change(*x));
    }
}

/// The nearest single.
#[allow(clippy::cast_possible_truncation)] // the rounding is the fault
fn single(x: f64) -> f32 {
    x as f32
}
