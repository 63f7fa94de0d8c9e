//! The judge of other programs' cuts of a mesh by planes: see the [laws](crate::checks::replies).
//!
//! A program gets the triangles of a closed mesh and three points of each plane, and gives the parts as meshes, in any
//! order. Pieces of one part may be in several meshes.

use std::collections::BTreeMap;

use predicament_judge::skin::{Corners, Skin};
use predicament_judge::{nearest, sign};
use predicament_predicates::{Declined, Plane, Question, Scene, Sign, Vertex};
use predicament_tasks::replies::{
    Array, Arrays, Bound, Example, FORM, Form, Mesh, Part, Replies, Reply, SpoiledReply, Unjudged, add_row, note,
};
use predicament_tasks::{Asked, Case, Check, Class, Outcome};

use super::{Cut, Slice, Solid};
use crate::checks::replies::{CROSSING, Cuts, EULER, OFF, OPEN, PART, SIDE, VOLUME};
use crate::truth;

/// The judge.
pub(super) struct Judge;

/// The name of the answer's arrays.
const PARTS: &str = "parts";
/// The numbers of points that are tested, at the two levels.
const WITNESSES: [usize; 2] = [800, 8_000];

const OFF_MEANS: &str = "a program's parts: each vertex is on the mesh or on a plane, up to rounding";
const OPEN_MEANS: &str = "a program's parts: at each edge, as many triangles come as go";
const SIDE_MEANS: &str = "a program's parts: each is on one side of each plane, up to rounding";
const PART_MEANS: &str = "a program's parts: a point of the solid is in one of them, and other points are in none";
const CROSSING_MEANS: &str = "a program's parts: no edge passes through a triangle by more than rounding";
const EULER_MEANS: &str = "a program's parts: their Euler characteristics add up to that of the cut solid";
const VOLUME_MEANS: &str = "a program's parts: their volumes add up to that of the mesh, up to rounding";

impl Replies<Slice> for Judge {
    fn parts(&self) -> &'static [Part] {
        const { &[Part::new(PARTS, Form::Meshes, "the parts of the solid, each the surface of a solid")] }
    }

    fn example(&self) -> Example {
        Example {
            suites: "slices",
            functions: &[
                ("python", include_str!("../engines/slice.py")),
                ("cpp", include_str!("../engines/slice.cpp")),
                ("rust", include_str!("../engines/slice.rs")),
                ("node", include_str!("../engines/slice.mjs")),
            ],
        }
    }

    fn open(&self, scene: &Scene, content: &Solid) -> Result<(), Declined> {
        if !content.is_closed {
            return Err(Declined::scene("the mesh is open, and programs get the surfaces of solids"));
        }
        match triangles(scene, content) {
            Some(_) => Ok(()),
            None => Err(Declined::scene("a face is not a simple polygon, and programs get triangles")),
        }
    }

    /// Adds the triangles of all faces.
    fn more(&self, scene: &Scene, content: &Solid, question: &mut Arrays) {
        let triangles = triangles(scene, content).unwrap_or_default();
        question.add_vertices("triangles", triangles.as_flattened());
    }

    fn judge(
        &self,
        case: &Case<'_, Slice>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let (scene, content) = (case.scene(), case.content);
        if !content.is_closed {
            // Not asked of programs.
            return Ok(());
        }
        let meshes = reply.arrays.meshes(PARTS)?;
        let place = |corners: &[Vertex; 3]| -> Corners { corners.map(|v| scene.point3(v)) };
        let given = triangles(scene, content).unwrap_or_default();
        let planes: Vec<Corners> = content.planes.iter().map(place).collect();
        let cuts = Cuts::new(given.iter().map(place).collect(), &planes);
        let bound = Bound::of(scene, [given.as_flattened(), &[]]);
        let parts: Vec<Skin> = meshes.iter().map(|mesh| Skin::new(mesh.corners())).collect();
        asked.watch.done(0)?;
        let far = bound.class(cuts.farthest(&parts, bound.nearest));
        add_row(case, asked, (PARTS, meshes.iter().map(|mesh| mesh.points.len()).sum()), (&bound, &far), outcome);
        if far.class != Class::Agree {
            note(outcome, far.class, OFF, format!("a vertex is {} off", bound.told(far.distance)), OFF_MEANS);
            if far.class == Class::Topology {
                return Ok(());
            }
        }
        asked.watch.done(0)?;
        let most = WITNESSES[usize::from(asked.budget.thorough)];
        for flaw in cuts.violations(&parts, [far.within, bound.coarsest], most) {
            let (class, told) = bound.violated(flaw.distance);
            let law = self.checks().iter().find(|law| law.name == flaw.check).map_or("", |law| law.means);
            note(outcome, class, flaw.check, format!("{}{told}", flaw.what), law);
        }
        Ok(())
    }

    fn reply_of(&self, scene: &Scene, _: &Solid, answer: &Cut) -> Arrays {
        let mut arrays = Arrays::default();
        let constructions = &answer.sliced.constructions;
        let places: Vec<[f64; 3]> = match (&answer.rounded, truth::constructed(scene, constructions)) {
            (Some(rounded), _) => rounded.clone(),
            (None, Ok(exact)) => exact.iter().map(|point| [0, 1, 2].map(|axis: usize| nearest(&point[axis]))).collect(),
            (None, Err(_)) => return arrays,
        };
        let place = |v: Vertex| v.construction().map_or_else(|| scene.point3(v), |at| places[at - answer.before]);
        let mesh = |part: &crate::algorithm::Part| {
            let mut numbers: BTreeMap<Vertex, u32> = part.triangles.as_flattened().iter().map(|&v| (v, 0)).collect();
            (0..).zip(numbers.values_mut()).for_each(|(at, number)| *number = at);
            Mesh {
                points: numbers.keys().map(|&v| place(v)).collect(),
                triangles: part.triangles.iter().map(|triangle| triangle.map(|v| numbers[&v])).collect(),
            }
        };
        arrays.add_meshes(PARTS, &answer.sliced.parts.iter().map(mesh).collect::<Vec<_>>());
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::topology(OFF, OFF_MEANS),
                Check::rounded(OFF, OFF_MEANS),
                Check::topology(OPEN, OPEN_MEANS),
                Check::topology(SIDE, SIDE_MEANS),
                Check::rounded(SIDE, SIDE_MEANS),
                Check::topology(PART, PART_MEANS),
                Check::rounded(PART, PART_MEANS),
                Check::topology(CROSSING, CROSSING_MEANS),
                Check::topology(VOLUME, VOLUME_MEANS),
                Check::rounded(VOLUME, VOLUME_MEANS),
                Check::topology(EULER, EULER_MEANS),
            ]
        }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Slice>> {
        vec![
            SpoiledReply {
                name: "slice-reply-loses-a-part",
                what: "the last part is missing",
                backend: "exact",
                caught_by: &[(Class::Topology, PART), (Class::Topology, VOLUME)],
                spoil: |_, _, arrays| change(arrays, |parts| drop(parts.pop())),
            },
            SpoiledReply {
                name: "slice-reply-loses-the-smallest-part",
                what: "the part with the fewest triangles is missing",
                backend: "exact",
                caught_by: &[(Class::Topology, PART)],
                spoil: |_, _, arrays| {
                    change(arrays, |parts| {
                        let smallest = (0..parts.len()).min_by_key(|&at| parts[at].triangles.len());
                        smallest.into_iter().for_each(|at| drop(parts.remove(at)));
                    });
                },
            },
            SpoiledReply {
                name: "slice-reply-is-not-cut",
                what: "the only part is the whole mesh",
                backend: "exact",
                caught_by: &[(Class::Topology, SIDE)],
                spoil: |scene, content, arrays| {
                    let number = |v: Vertex| u32::try_from(v.index()).unwrap_or(u32::MAX);
                    let triangles = triangles(scene, content).unwrap_or_default();
                    let points = scene.vertices().map(|v| scene.point3(v)).collect();
                    let whole = Mesh { points, triangles: triangles.iter().map(|one| one.map(number)).collect() };
                    change(arrays, |parts| *parts = vec![whole]);
                },
            },
            SpoiledReply {
                name: "slice-reply-is-in-singles",
                what: "all vertices are rounded to single precision",
                backend: "exact",
                caught_by: &[(Class::Rounded, OFF)],
                spoil: |_, _, arrays| each(arrays, |x| f64::from(single(x))),
            },
            SpoiledReply {
                name: "slice-reply-slides-a-vertex",
                what: "a vertex of each part is moved along an edge, by 2^-26 of the edge",
                backend: "exact",
                caught_by: &[(Class::Rounded, PART), (Class::Rounded, VOLUME)],
                spoil: |_, _, arrays| {
                    change(arrays, |parts| {
                        for part in parts {
                            let Some(&[from, to, _]) = part.triangles.last() else { continue };
                            let [p, q] = [from, to].map(|v| part.points[v as usize]);
                            part.points[from as usize] =
                                [0, 1, 2].map(|i: usize| p[i] + (q[i] - p[i]) * 2.0_f64.powi(-26));
                        }
                    });
                },
            },
            SpoiledReply {
                name: "slice-reply-swells",
                what: "each vertex of each part is moved away from a neighbour, by 2^-26 of the edge",
                backend: "exact",
                caught_by: &[(Class::Rounded, SIDE)],
                spoil: |_, _, arrays| {
                    change(arrays, |parts| {
                        for part in parts {
                            let before = part.points.clone();
                            for &[from, to, _] in &part.triangles {
                                let [p, q] = [from, to].map(|v| before[v as usize]);
                                part.points[from as usize] =
                                    [0, 1, 2].map(|i: usize| p[i] - (q[i] - p[i]) * 2.0_f64.powi(-26));
                            }
                        }
                    });
                },
            },
            SpoiledReply {
                name: "slice-reply-grows",
                what: "all vertices are twice as far from the origin, and farther",
                backend: "exact",
                caught_by: &[(Class::Topology, OFF)],
                spoil: |_, _, arrays| each(arrays, |x| 2.0 * x + 1.0),
            },
            SpoiledReply {
                name: "slice-reply-loses-a-triangle",
                what: "the last triangle of each part is missing",
                backend: "exact",
                caught_by: &[(Class::Topology, OPEN)],
                spoil: |_, _, arrays| {
                    change(arrays, |parts| {
                        parts
                            .iter_mut()
                            .for_each(|part| part.triangles.truncate(part.triangles.len().saturating_sub(1)))
                    });
                },
            },
            SpoiledReply {
                name: "slice-reply-has-a-cavity",
                what: "the first part has a needle of air, from one of its triangles to another",
                backend: "exact",
                caught_by: &[(Class::Topology, EULER)],
                spoil: |_, _, arrays| change(arrays, |parts| parts.first_mut().into_iter().for_each(pierce)),
            },
            SpoiledReply {
                name: "slice-reply-exchanges-vertices",
                what: "in each part, two vertices have exchanged their places",
                backend: "exact",
                caught_by: &[(Class::Topology, CROSSING)],
                spoil: |_, _, arrays| {
                    change(arrays, |parts| {
                        for part in parts.iter_mut().filter(|part| part.points.len() > 4) {
                            let last = part.points.len() - 1;
                            part.points.swap(0, last);
                        }
                    });
                },
            },
            SpoiledReply {
                name: "slice-reply-has-a-vertex-too-many",
                what: "a corner is the vertex after the last one",
                backend: "exact",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(ids)) = arrays.get_mut("parts.triangles")
                        && let Some(id) = ids.first_mut()
                    {
                        *id = u32::MAX;
                    }
                },
            },
        ]
    }
}

/// All faces as triangles, by cutting ears with exact signs; `None` if a face has no ear.
fn triangles(scene: &Scene, content: &Solid) -> Option<Vec<[Vertex; 3]>> {
    let mut all = Vec::new();
    for (face, &support) in content.faces.iter().zip(&content.supports) {
        let mut ring: Vec<Vertex> = face.iter().map(|&corner| Vertex::input(corner as usize)).collect();
        let turn = |plane: Plane, corners: [Vertex; 3]| sign(scene, Question::Orient2d(plane), &corners);
        let planes = [Plane::Xy, Plane::Yz, Plane::Zx];
        let plane = planes.into_iter().find(|&plane| turn(plane, support) != Sign::Zero)?;
        let way = turn(plane, support);
        while ring.len() > 3 {
            let count = ring.len();
            let ear = (0..count).find(|&at| {
                let [a, b, c] = [(at + count - 1) % count, at, (at + 1) % count].map(|at| ring[at]);
                let is_in = |v: Vertex| {
                    [[a, b, v], [b, c, v], [c, a, v]].into_iter().all(|t| turn(plane, t) * way != Sign::Negative)
                };
                turn(plane, [a, b, c]) == way && !ring.iter().any(|&v| ![a, b, c].contains(&v) && is_in(v))
            })?;
            all.push([ring[(ear + count - 1) % count], ring[ear], ring[(ear + 1) % count]]);
            ring.remove(ear);
        }
        all.push(<[Vertex; 3]>::try_from(ring).ok()?);
    }
    Some(all)
}

/// Adds a thin tetrahedron that is turned inwards, with three corners in the first triangle and one in the last one.
fn pierce(part: &mut Mesh) {
    let [Some(&foot), Some(&head)] = [part.triangles.first(), part.triangles.last()] else { return };
    let place = |corners: [u32; 3], weights: [f64; 3]| {
        let [p, q, r] = corners.map(|v| part.points[v as usize]);
        [0, 1, 2].map(|i: usize| p[i] * weights[0] + q[i] * weights[1] + r[i] * weights[2])
    };
    let thin = 2.0_f64.powi(-16);
    let feet = [[0.25, 0.25, 0.5], [0.25 + thin, 0.25 - thin, 0.5], [0.25 + thin, 0.25, 0.5 - thin]];
    let corners: Vec<[f64; 3]> =
        feet.into_iter().map(|weights| place(foot, weights)).chain([place(head, [0.25, 0.5, 0.25])]).collect();
    let number = |at: usize| u32::try_from(part.points.len() + at).unwrap_or(u32::MAX);
    let [a, b, c, d] = [0, 1, 2, 3].map(number);
    let faces = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]].map(|face| face.map(|at: usize| corners[at]));
    let is_inwards = Skin::new(faces.to_vec()).six().cmp0().is_lt();
    let turned = |[a, b, c]: [u32; 3]| if is_inwards { [a, b, c] } else { [a, c, b] };
    part.triangles.extend([[a, b, c], [a, d, b], [b, d, c], [c, d, a]].map(turned));
    part.points.extend(corners);
}

/// Changes the list of parts.
fn change(arrays: &mut Arrays, change: impl FnOnce(&mut Vec<Mesh>)) {
    if let Ok(mut parts) = arrays.meshes(PARTS) {
        change(&mut parts);
        arrays.remove(PARTS);
        arrays.add_meshes(PARTS, &parts);
    }
}

/// Changes all coordinates.
fn each(arrays: &mut Arrays, change: impl Fn(f64) -> f64) {
    if let Some(Array::Numbers(numbers)) = arrays.get_mut("parts.vertices") {
        numbers.iter_mut().for_each(|x| *x = change(*x));
    }
}

/// The nearest single.
#[allow(clippy::cast_possible_truncation)] // the rounding is the fault
fn single(x: f64) -> f32 {
    x as f32
}
