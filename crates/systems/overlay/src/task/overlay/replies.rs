//! The judge of other programs' Boolean operations on polygons.

use predicament_judge::nearest;
use predicament_predicates::{Declined, Plane, Scene, Vertex};
use predicament_tasks::replies::{
    Array, Arrays, Bound, Example, FORM, Form, Malformed, Part, Replies, Reply, Rings, SpoiledReply, Unjudged, add_row,
    note,
};
use predicament_tasks::{Asked, Case, Check, Class, Outcome};

use super::content::{Layered, Layers};
use super::{Overlaid, Overlay2d};
use crate::algorithm::overlay::{Edge, Operation, Rule};
use crate::checks::replies::{AREA, CROSSING, OFF, OVERLAP, Operands, SET, Violation};

/// The judge.
pub(super) struct Judge;

/// The number of points that are located in each result, at the two levels.
const WITNESSES: [usize; 2] = [1_500, 20_000];
/// The number of edges of a result that are compared with those near them, at the two levels.
const CROSSED: [usize; 2] = [1_000, 20_000];

const OFF_MEANS: &str = "a program's result: each vertex is on an edge of an operand, up to rounding";
const SET_MEANS: &str = "a program's result: a point off all edges is in it if and only if the operation says so";
const OVERLAP_MEANS: &str = "a program's result: a point off all edges is in one of its polygons at most";
const AREA_MEANS: &str = "a program's result: its area is that of the operation, up to rounding";
const CROSSING_MEANS: &str = "a program's result: its edges do not cross by more than rounding";

impl Replies<Overlay2d> for Judge {
    fn parts(&self) -> &'static [Part] {
        const {
            &[
                Part::optional("union", Form::Polygons, "the points in the first operand, the second or both"),
                Part::optional("intersection", Form::Polygons, "the points in both operands"),
                Part::optional("difference", Form::Polygons, "the points in the first operand, but not in the second"),
                Part::optional("symmetric-difference", Form::Polygons, "the points in exactly one operand"),
            ]
        }
    }

    fn example(&self) -> Example {
        Example {
            suites: "overlays",
            functions: &[
                ("python", include_str!("../../engines/overlay2d.py")),
                ("cpp", include_str!("../../engines/overlay2d.cpp")),
                ("rust", include_str!("../../engines/overlay2d.rs")),
                ("node", include_str!("../../engines/overlay2d.mjs")),
            ],
        }
    }

    fn open(&self, _: &Scene, content: &Layered) -> Result<(), Declined> {
        match content.layers {
            Layers::Polygons(..) => Ok(()),
            Layers::Segments(_) => {
                Err(Declined::scene("programs are asked for operations on polygons, not for arrangements"))
            }
        }
    }

    fn judge(
        &self,
        case: &Case<'_, Overlay2d>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let Layers::Polygons(loops, rule) = &case.content.layers else { return Ok(()) };
        let scene = case.scene();
        let given = |one: &Vec<Vertex>| one.iter().map(|&v| scene.point2(Plane::Xy, v)).collect();
        let given_loops = loops.each_ref().map(|loops| loops.iter().map(given).collect::<Vec<Vec<[f64; 2]>>>());
        let inside: fn(i32) -> bool = match rule {
            Rule::EvenOdd => |winding| winding % 2 != 0,
            Rule::NonZero => |winding| winding != 0,
        };
        let operands = Operands::new([&given_loops[0], &given_loops[1]], inside);
        let corners = |at: usize| loops[at].iter().flatten().copied().collect::<Vec<Vertex>>();
        let bound = Bound::of(scene, [&corners(0), &corners(1)]);
        let results = Operation::ALL
            .map(|operation| reply.arrays.get(operation.name()).map(|_| reply.arrays.polygons(operation.name())));
        if results.iter().all(Option::is_none) {
            let names = Operation::ALL.map(Operation::name).join("`, `");
            return Err(Malformed(format!("none of `{names}`; the answer has {}", reply.arrays.names())).into());
        }
        let thorough = usize::from(asked.budget.thorough);
        // Points whose membership is known at a distance: most results share it.
        let mut known = None;
        for (operation, result) in Operation::ALL.into_iter().zip(results) {
            let Some(result) = result.transpose()? else { continue };
            asked.watch.done(0)?;
            let name = operation.name();
            let far = bound.class(operands.farthest(&result, bound.nearest));
            let vertices = result.iter().flatten().map(Vec::len).sum();
            add_row(case, asked, (name, vertices), (&bound, &far), outcome);
            match far.class {
                Class::Agree => {}
                class => {
                    let got = format!("{name}: a vertex is {} off", bound.told(far.distance));
                    note(outcome, class, OFF, got, OFF_MEANS);
                    if class == Class::Topology {
                        continue;
                    }
                }
            }
            let is_known = known.as_ref().is_some_and(|(within, _)| *within == far.within);
            if !is_known {
                known = Some((far.within, operands.witnesses([far.within, bound.coarsest], WITNESSES[thorough])));
            }
            let Some((within, witnesses)) = &known else { continue };
            let at = [*within, bound.coarsest];
            for Violation { check, what, distance } in
                operands.violations(operation, &result, at, witnesses, CROSSED[thorough])
            {
                let laws = [(SET, SET_MEANS), (OVERLAP, OVERLAP_MEANS), (AREA, AREA_MEANS), (CROSSING, CROSSING_MEANS)];
                let law = laws.into_iter().find(|(name, _)| *name == check).map_or("", |(_, means)| means);
                let (class, told) = bound.violated(distance);
                note(outcome, class, check, format!("{name}: {what}{told}"), law);
            }
        }
        Ok(())
    }

    fn reply_of(&self, _: &Scene, _: &Layered, answer: &Overlaid) -> Arrays {
        let mut arrays = Arrays::default();
        let Some(scene) = &answer.scene else { return arrays };
        let points = predicament_judge::Points::of(scene);
        let place = |v: Vertex| -> [f64; 2] {
            match points.point(v) {
                Some(point) => [nearest(&point[0]), nearest(&point[1])],
                None => [f64::NAN; 2],
            }
        };
        let ring = |one: &Vec<Edge>| one.iter().map(|edge| place(edge.from)).collect();
        for (operation, made) in Operation::ALL.into_iter().zip(&answer.regions) {
            let rings: Rings = made.regions.iter().map(|region| region.loops().map(ring).collect()).collect();
            arrays.add_polygons(operation.name(), &rings);
        }
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::topology(OFF, OFF_MEANS),
                Check::rounded(OFF, OFF_MEANS),
                Check::topology(SET, SET_MEANS),
                Check::rounded(SET, SET_MEANS),
                Check::topology(OVERLAP, OVERLAP_MEANS),
                Check::topology(AREA, AREA_MEANS),
                Check::rounded(AREA, AREA_MEANS),
                Check::topology(CROSSING, CROSSING_MEANS),
            ]
        }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Overlay2d>> {
        vec![
            SpoiledReply {
                name: "overlay2d-reply-has-a-nan",
                what: "the first coordinate of the union is NaN",
                backend: "exact",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| first(arrays, |x| *x = f64::NAN),
            },
            SpoiledReply {
                name: "overlay2d-reply-is-rounded-to-a-grid",
                what: "the union's vertices are rounded to 2^-30 of the largest coordinate",
                backend: "exact",
                caught_by: &[(Class::Rounded, OFF)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Numbers(numbers)) = arrays.get_mut("union") {
                        let largest = numbers.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                        let step = 2.0_f64.powi(-30) * 2.0_f64.powf(largest.log2().ceil());
                        numbers.iter_mut().for_each(|x| *x = (*x / step).round() * step);
                    }
                },
            },
            SpoiledReply {
                name: "overlay2d-reply-slides-a-vertex",
                what: "the first vertex of each ring of the union is moved along its edge, by 2^-26 of the edge",
                backend: "exact",
                caught_by: &[(Class::Rounded, SET), (Class::Rounded, AREA)],
                spoil: |_, _, arrays| {
                    if let Ok(mut rings) = arrays.polygons("union") {
                        for ring in rings.iter_mut().flatten().filter(|ring| ring.len() > 2) {
                            let [from, to] = [ring[0], ring[1]];
                            ring[0] = [0, 1].map(|i: usize| from[i] + (to[i] - from[i]) * 2.0_f64.powi(-26));
                        }
                        arrays.remove("union");
                        arrays.add_polygons("union", &rings);
                    }
                },
            },
            SpoiledReply {
                name: "overlay2d-reply-moves-a-vertex",
                what: "the union's first vertex is moved by the width of the scene",
                backend: "exact",
                caught_by: &[(Class::Topology, OFF)],
                spoil: |scene, _, arrays| {
                    let extent = Bound::of(scene, [&[], &[]]).extent;
                    first(arrays, |x| *x += 2.0 * extent);
                },
            },
            SpoiledReply {
                name: "overlay2d-reply-exchanges-results",
                what: "union and intersection are exchanged",
                backend: "exact",
                caught_by: &[(Class::Topology, SET), (Class::Topology, AREA)],
                spoil: |_, _, arrays| exchange(arrays, "union", "intersection"),
            },
            SpoiledReply {
                name: "overlay2d-reply-has-a-polygon-twice",
                what: "the union's polygons are listed twice",
                backend: "exact",
                caught_by: &[(Class::Topology, OVERLAP)],
                spoil: |_, _, arrays| {
                    if let Ok(rings) = arrays.polygons("union") {
                        arrays.remove("union");
                        arrays.add_polygons("union", &[rings.clone(), rings].concat());
                    }
                },
            },
            SpoiledReply {
                name: "overlay2d-reply-crosses-itself",
                what: "two neighbouring vertices of each ring of the union are exchanged",
                backend: "exact",
                caught_by: &[(Class::Topology, CROSSING)],
                spoil: |_, _, arrays| {
                    if let Ok(mut rings) = arrays.polygons("union") {
                        rings.iter_mut().flatten().filter(|ring| ring.len() > 3).for_each(|ring| ring.swap(1, 2));
                        arrays.remove("union");
                        arrays.add_polygons("union", &rings);
                    }
                },
            },
        ]
    }
}

/// Changes the first coordinate of the union.
fn first(arrays: &mut Arrays, change: impl Fn(&mut f64)) {
    if let Some(Array::Numbers(numbers)) = arrays.get_mut("union")
        && let Some(x) = numbers.first_mut()
    {
        change(x);
    }
}

/// Exchanges two parts.
fn exchange(arrays: &mut Arrays, one: &str, other: &str) {
    if let (Ok(first), Ok(second)) = (arrays.polygons(one), arrays.polygons(other)) {
        arrays.remove(one);
        arrays.remove(other);
        arrays.add_polygons(one, &second);
        arrays.add_polygons(other, &first);
    }
}
