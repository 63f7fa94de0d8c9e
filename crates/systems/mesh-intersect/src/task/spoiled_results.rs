//! Results with planted faults: the overlay is right, and its limits or roundings are damaged afterwards.

use predicament_mesh::OUTSIDE;
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Construction, Vertex};

use super::settled::Settled;
use super::{MeshIntersect, Overlaid, TwoMeshes};
use predicament_tasks::{Class, Spoiled};

/// The results without the perturbation, for damage.
fn settled(answer: &mut Overlaid) -> Option<&mut Settled> {
    answer.settled.as_mut()?.as_mut().ok()
}

pub(super) fn all() -> Vec<Spoiled<MeshIntersect>> {
    vec![
        Spoiled::new(
            "mesh-intersect-loses-a-triangle",
            "the union lacks its first triangle",
            "sos",
            &[
                (Class::Topology, "result not closed"),
                (Class::Topology, "volumes of results"),
                (Class::Topology, "areas of results"),
                (Class::Topology, "a mesh with itself"),
            ],
            |_, _, answer: &mut Overlaid| {
                answer.solids[0] = answer.solids[0].split_off(usize::from(!answer.solids[0].is_empty()));
                answer.sources[0] = answer.sources[0].split_off(usize::from(!answer.sources[0].is_empty()));
            },
        ),
        Spoiled::new(
            "mesh-intersect-loses-a-contact-face",
            "the last triangle of the last face of contact is lost",
            "exact",
            &[(Class::Topology, "faces of contact")],
            |_, _, answer: &mut Overlaid| {
                answer.contacts.faces.last_mut().and_then(|face| face.triangles.pop());
            },
        ),
        Spoiled::new(
            "mesh-intersect-widens-a-contact-face",
            "the first triangle of each face of contact is replaced by the triangle of the first mesh",
            "exact",
            &[(Class::Topology, "faces of contact")],
            |_, content: &TwoMeshes, answer: &mut Overlaid| {
                for face in &mut answer.contacts.faces {
                    face.triangles[0] = content.meshes[0].triangles()[face.of[0] as usize];
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-loses-a-contact-segment",
            "the first segment of contact is lost",
            "exact",
            &[(Class::Topology, "segments of contact")],
            |_, _, answer: &mut Overlaid| {
                let segments = &mut answer.contacts.segments;
                segments.drain(..segments.len().min(1));
            },
        ),
        Spoiled::new(
            "mesh-intersect-loses-a-contact-point",
            "the last point of contact is lost",
            "exact",
            &[(Class::Topology, "points of contact")],
            |_, _, answer: &mut Overlaid| {
                answer.contacts.points.pop();
            },
        ),
        Spoiled::new(
            "mesh-intersect-invents-a-contact",
            "the first two vertices of the first mesh are listed as a point and a segment of contact",
            "exact",
            &[(Class::Topology, "points of contact"), (Class::Topology, "segments of contact")],
            |_, content: &TwoMeshes, answer: &mut Overlaid| {
                let [a, b, _] = content.meshes[0].triangles()[0];
                answer.contacts.points.push(a);
                answer.contacts.segments.push([a, b]);
            },
        ),
        Spoiled::new(
            "mesh-intersect-joins-points",
            "the first constructed vertex is replaced by the last",
            "exact",
            &[
                (Class::Topology, "curve not closed"),
                (Class::Topology, "corner of a result"),
                (Class::Topology, "Euler characteristic"),
            ],
            |_, _, answer: &mut Overlaid| {
                let [first, last] = [0, answer.constructions.len().saturating_sub(1)];
                let [first, last] = [first, last].map(|at| Vertex::constructed(answer.before + at));
                let triangles = answer.solids.iter_mut().flatten().chain(&mut answer.regions.triangles);
                triangles.flatten().filter(|v| **v == last).for_each(|v| *v = first);
            },
        ),
        Spoiled::new(
            "mesh-intersect-adds-a-flap",
            "a triangle of the intersection is repeated, once as it is and once turned over",
            "exact",
            &[(Class::Topology, "edge of a result")],
            |_, _, answer: &mut Overlaid| {
                if let (Some(&[a, b, c]), Some(&source)) = (answer.solids[1].first(), answer.sources[1].first()) {
                    answer.solids[1].extend([[a, b, c], [a, c, b]]);
                    answer.sources[1].extend([source; 2]);
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-repeats-pieces",
            "the first and the last piece are repeated, once as they are and once with their sides exchanged",
            "exact",
            &[
                (Class::Topology, "edge of a piece"),
                (Class::Topology, "segment of a curve"),
                (Class::Topology, "face area"),
            ],
            |_, _, answer: &mut Overlaid| {
                let regions = &mut answer.regions;
                for at in [0, regions.triangles.len().saturating_sub(1)] {
                    let Some(&[front, behind]) = regions.sides.get(at) else { return };
                    regions.triangles.extend([regions.triangles[at]; 2]);
                    regions.sources.extend([regions.sources[at]; 2]);
                    regions.sides.extend([[front, behind], [behind, front]]);
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-takes-the-other-difference",
            "the difference is the second mesh less the first",
            "exact",
            &[(Class::Topology, "difference by complement"), (Class::Topology, "point in a result")],
            |_, _, answer: &mut Overlaid| {
                let regions = &answer.regions;
                answer.solids[2].clear();
                answer.sources[2].clear();
                for ((&[a, b, c], sides), &source) in regions.triangles.iter().zip(&regions.sides).zip(&regions.sources)
                {
                    let is_inside = sides.map(|side| {
                        let [first, second] = regions.pairs[side as usize].map(|region| region != OUTSIDE);
                        Operation::Difference.holds([second, first])
                    });
                    match is_inside {
                        [false, true] => answer.solids[2].push([a, b, c]),
                        [true, false] => answer.solids[2].push([a, c, b]),
                        _ => continue,
                    }
                    answer.sources[2].push(source);
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-turns-a-limit-over",
            "the limit of the union is inside out",
            "exact",
            &[(Class::Topology, "areas of a limit"), (Class::Topology, "point in a result")],
            |_, _, answer: &mut Overlaid| {
                if let Some(settled) = settled(answer) {
                    settled.results[0].solid.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-takes-the-unions-limit",
            "the limit of the difference is replaced by the limit of the union",
            "sos:per-mesh",
            &[(Class::Topology, "limit of a mesh with itself"), (Class::Topology, "areas of a limit")],
            |_, _, answer: &mut Overlaid| {
                if let Some(settled) = settled(answer) {
                    settled.results[2] = settled.results[0].clone();
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-moves-a-vertex",
            "the first vertex of the union in doubles is two ulps up",
            "exact",
            &[(Class::Topology, "place of a rounded vertex")],
            |_, _, answer: &mut Overlaid| {
                if let Some(point) =
                    settled(answer).and_then(|settled| settled.results[0].rounded.closed.points.first_mut())
                {
                    point[2] = point[2].next_up().next_up();
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-loses-a-rounded-triangle",
            "the union in doubles lacks its last triangle",
            "exact",
            &[(Class::Topology, "settled result not closed")],
            |_, _, answer: &mut Overlaid| {
                if let Some(settled) = settled(answer) {
                    settled.results[0].rounded.closed.triangles.pop();
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-merges-places",
            "the limit of the union has the corner of its last triangle in place of the corner of its first",
            "exact",
            &[(Class::Topology, "areas of a limit")],
            |_, _, answer: &mut Overlaid| {
                let Some(settled) = settled(answer) else { return };
                let triangles = &mut settled.results[0].solid.triangles;
                let (Some(&[first, ..]), Some(&last)) = (triangles.first(), triangles.last()) else { return };
                let [.., other] = last;
                triangles.iter_mut().flatten().filter(|v| **v == first).for_each(|v| *v = other);
                // (A triangle with a vertex twice has no area now.)
                triangles.retain(|[a, b, c]| a != b && b != c && c != a);
            },
        ),
        Spoiled::new(
            "mesh-intersect-passes-through",
            "the first vertex of the union in doubles is moved beyond its farthest vertex",
            "exact",
            &[(Class::Topology, "settled result crosses itself"), (Class::Topology, "place of a rounded vertex")],
            |_, _, answer: &mut Overlaid| {
                let Some(settled) = settled(answer) else { return };
                let points = &mut settled.results[0].rounded.closed.points;
                let Some(&first) = points.first() else { return };
                let far = |p: &[f64; 3]| (0..3).map(|axis| (p[axis] - first[axis]).abs()).fold(0.0, f64::max);
                if let Some(&farthest) = points.iter().max_by(|p, q| far(p).total_cmp(&far(q))) {
                    // (Not in line with anything.)
                    let step = [1.25, 1.125, 1.375];
                    points[0] = [0, 1, 2].map(|axis| first[axis] + step[axis] * (farthest[axis] - first[axis]));
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-adds-a-sheet",
            "a triangle of the union in doubles is repeated, once as it is and once turned over",
            "exact",
            &[(Class::Topology, "sheet")],
            |_, _, answer: &mut Overlaid| {
                if let Some(settled) = settled(answer)
                    && let Some(&[a, b, c]) = settled.results[0].rounded.closed.triangles.first()
                {
                    settled.results[0].rounded.closed.triangles.extend([[a, b, c], [a, c, b]]);
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-loses-a-place",
            "the line of the first constructed vertex is replaced by a line in its plane",
            "exact",
            &[(Class::Topology, "vertex of a limit")],
            |_, _, answer: &mut Overlaid| {
                if let Some(settled) = settled(answer)
                    && let Some(Construction::Lpi { line, plane: [a, b, _] }) = settled.constructions.first_mut()
                {
                    *line = [*a, *b];
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-forgets-to-turn",
            "the first triangle of the difference is turned over",
            "exact",
            &[(Class::Topology, "operation")],
            |_, _, answer: &mut Overlaid| {
                if let Some(triangle) = answer.solids[2].first_mut() {
                    triangle.swap(1, 2);
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-splits-a-vertex",
            "the limit of the union has a second vertex at the place of a constructed vertex",
            "exact",
            &[(Class::Topology, "vertices of a limit")],
            |_, _, answer: &mut Overlaid| {
                let before = answer.before;
                let Some(settled) = settled(answer) else { return };
                let mut all = settled.results[0].solid.triangles.iter_mut().flatten();
                let Some((v, index)) = all.find_map(|v| v.construction().map(|index| (v, index))) else { return };
                *v = Vertex::constructed(before + settled.constructions.len());
                settled.constructions.push(settled.constructions[index - before]);
            },
        ),
    ]
}
