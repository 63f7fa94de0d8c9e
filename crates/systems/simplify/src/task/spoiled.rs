//! Right answers with planted faults, which prove that the checks find faults that no backend has.

use predicament_predicates::{Scene, Sign, Vertex};
use predicament_tasks::{Class, Spoiled};

use super::checks::{COUNT, DISTANCE, PERTURBED, REFUSED, STEPS, SURFACE, TRIANGLES, TURNED};
use super::{MeshToSimplify, Simplify};
use crate::answer::{Simplified, Step};
use crate::checks::{Facing, Replay, facing};

pub(super) fn all() -> Vec<Spoiled<Simplify>> {
    vec![
        Spoiled::new(
            "simplify-tears-the-surface",
            "one more edge is collapsed, although both of its ends have another common neighbour",
            "exact",
            &[(Class::Topology, STEPS)],
            |scene, content, answer| {
                one_more(scene, content, answer, |replay, edge, _| replay.obstacle(edge).is_some());
            },
        ),
        Spoiled::new(
            "simplify-loses-a-triangle",
            "the last triangle is not listed",
            "exact",
            &[(Class::Topology, TRIANGLES), (Class::Topology, SURFACE)],
            |_, _, answer: &mut Simplified| {
                answer.triangles.pop();
            },
        ),
        Spoiled::new(
            "simplify-gives-up",
            "the last collapse is left out, although the target is not reached without it",
            "exact",
            &[(Class::Topology, COUNT)],
            |scene, content, answer: &mut Simplified| {
                let last = answer.steps.iter().rposition(|step| matches!(step, Step::Collapse { .. }));
                answer.steps.truncate(last.unwrap_or(0));
                answer.triangles = replayed(scene, content, answer).triangles().collect();
            },
        ),
        Spoiled::new(
            "simplify-goes-on",
            "one more edge is collapsed, although the target is reached",
            "exact",
            &[(Class::Topology, COUNT)],
            |scene, content, answer| {
                one_more(scene, content, answer, |replay, edge, worst| {
                    replay.obstacle(edge).is_none() && worst <= Facing::Flat
                });
            },
        ),
        Spoiled::new(
            "simplify-moved-nothing",
            "no vertex is said to have moved",
            "exact",
            &[(Class::Topology, DISTANCE)],
            |_, _, answer: &mut Simplified| answer.reach = 0.0,
        ),
        Spoiled::new(
            "simplify-bounds-nothing",
            "the bound on the distance is infinite",
            "exact",
            &[(Class::Topology, DISTANCE)],
            |_, _, answer: &mut Simplified| answer.reach = f64::INFINITY,
        ),
        Spoiled::new(
            "simplify-turns-a-face",
            "one more edge is collapsed, and a face turns over",
            "exact",
            &[(Class::SignFlip, TURNED)],
            |scene, content, answer| {
                one_more(scene, content, answer, |replay, edge, worst| {
                    replay.obstacle(edge).is_none() && worst == Facing::Turned
                });
            },
        ),
        Spoiled::new(
            "simplify-flattens-a-face",
            "one more edge is collapsed, and a face loses its area",
            "exact",
            &[(Class::MissedZero, TURNED)],
            |scene, content, answer| {
                one_more(scene, content, answer, |replay, edge, worst| {
                    replay.obstacle(edge).is_none() && worst == Facing::Undecided
                });
            },
        ),
        Spoiled::new(
            "simplify-refuses-acute-angles",
            "an edge is refused because of a face whose normals make an acute angle",
            "exact",
            &[(Class::SignFlip, REFUSED)],
            |scene, content, answer| refuse(scene, content, answer, Facing::Same, Sign::Negative),
        ),
        Spoiled::new(
            "simplify-finds-a-right-angle",
            "an edge is refused because of an acute angle, which is found to be a right angle",
            "exact",
            &[(Class::Overreach, REFUSED)],
            |scene, content, answer| refuse(scene, content, answer, Facing::Same, Sign::Zero),
        ),
        Spoiled::new(
            "simplify-refuses-flat-faces",
            "an edge is refused because of a face that has no area before and after",
            "exact",
            &[(Class::MissedZero, REFUSED)],
            |scene, content, answer| refuse(scene, content, answer, Facing::Flat, Sign::Zero),
        ),
        Spoiled::new(
            "simplify-breaks-ties-one-way",
            "all ties of the faces that are left are negative",
            "sos",
            &[(Class::SignFlip, PERTURBED)],
            |scene, content, answer| {
                refuse(scene, content, answer, Facing::Undecided, Sign::Negative);
                refuse(scene, content, answer, Facing::Flat, Sign::Negative);
            },
        ),
        Spoiled::new(
            "simplify-leaves-ties",
            "faces are found without area, although ties are broken",
            "sos",
            &[(Class::Inconsistent, PERTURBED)],
            |scene, content, answer| refuse(scene, content, answer, Facing::Undecided, Sign::Zero),
        ),
    ]
}

/// The mesh after the steps of an answer.
fn replayed(scene: &Scene, content: &MeshToSimplify, answer: &Simplified) -> Replay {
    let mut replay = Replay::new(scene.len(), &content.triangles);
    for step in &answer.steps {
        if let Step::Collapse { gone, kept } = *step {
            replay.collapse(gone, kept);
        }
    }
    replay
}

/// Adds the first collapse of which this is true: of the mesh, the edge, and the worst of its faces.
fn one_more(
    scene: &Scene,
    content: &MeshToSimplify,
    answer: &mut Simplified,
    is_it: impl Fn(&Replay, [Vertex; 2], Facing) -> bool,
) {
    let mut replay = replayed(scene, content, answer);
    let worst = |[gone, kept]: [Vertex; 2]| {
        let faces = replay.moved(gone, kept).map(|[b, c]| facing(scene, [gone, kept, b, c]));
        faces.max().unwrap_or(Facing::Same)
    };
    if let Some([gone, kept]) = replay.edges().into_iter().find(|&edge| is_it(&replay, edge, worst(edge))) {
        replay.collapse(gone, kept);
        answer.steps.push(Step::Collapse { gone, kept });
        answer.triangles = replay.triangles().collect();
    }
}

/// Adds a refusal for each face of which this is the truth, with a sign that the session did not give.
fn refuse(scene: &Scene, content: &MeshToSimplify, answer: &mut Simplified, truth: Facing, claimed: Sign) {
    let replay = replayed(scene, content, answer);
    for [gone, kept] in replay.edges() {
        for base @ [b, c] in replay.moved(gone, kept) {
            if facing(scene, [gone, kept, b, c]) == truth {
                answer.steps.push(Step::Refusal { gone, kept, base, sign: claimed });
            }
        }
    }
}
