//! Right answers with planted faults: they test the checks that no backend's fault reaches.

use crate::algorithm::overlay::Contradiction;
use predicament_mesh::OUTSIDE;
use predicament_predicates::Declined;

use super::{MeshIntersect, OfMesh, Overlaid, Unsettled};
use predicament_tasks::rounding::{far, one_place, spoiled};
use predicament_tasks::{Class, Spoiled};

pub(super) fn all() -> Vec<Spoiled<MeshIntersect>> {
    vec![
        Spoiled::new(
            "mesh-intersect-loses-points",
            "all constructed vertices are rounded to NaN",
            "exact",
            &[(Class::Topology, "vertex not finite")],
            |_, _, answer: &mut Overlaid| answer.rounded = Some(vec![[f64::NAN; 3]; answer.constructions.len()]),
        ),
        Spoiled::new(
            "mesh-intersect-rounds-vertices",
            "constructed vertices are rounded, the first to doubles an ulp beside the nearest",
            "sos",
            &[
                (Class::Rounded, "piece not in its face"),
                (Class::Rounded, "face area"),
                (Class::Rounded, "volume"),
                (Class::Rounded, "volumes of results"),
                (Class::Rounded, "areas of results"),
                (Class::Rounded, "a mesh with itself"),
                (Class::Rounded, "meshes exchanged"),
                (Class::Rounded, "difference by complement"),
            ],
            |scene, _, answer: &mut Overlaid| answer.rounded = spoiled(scene, &answer.constructions, one_place),
        ),
        Spoiled::new(
            "mesh-intersect-drags-a-vertex",
            "constructed vertices are rounded, the first to doubles a thousandth beside the nearest",
            "sos",
            &[
                (Class::Topology, "piece not in its face"),
                (Class::Topology, "face area"),
                (Class::Topology, "volume"),
                (Class::Topology, "volumes of results"),
                (Class::Topology, "areas of results"),
                (Class::Topology, "a mesh with itself"),
                (Class::Topology, "meshes exchanged"),
                (Class::Topology, "difference by complement"),
            ],
            |scene, _, answer: &mut Overlaid| answer.rounded = spoiled(scene, &answer.constructions, far),
        ),
        Spoiled::new(
            "mesh-intersect-other-triangles",
            "each piece is reported as part of the triangle before or behind its own",
            "exact",
            &[(Class::Topology, "piece not in its face")],
            |_, _, answer: &mut Overlaid| {
                for OfMesh { triangle, .. } in &mut answer.regions.sources {
                    *triangle = if *triangle > 0 { *triangle - 1 } else { 1 };
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-turns-a-piece",
            "the first piece is turned over",
            "exact",
            &[(Class::Topology, "piece orientation")],
            |_, _, answer: &mut Overlaid| {
                if let Some(triangle) = answer.regions.triangles.first_mut() {
                    triangle.swap(1, 2);
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-adds-a-needle",
            "a piece with two corners is added",
            "exact",
            &[(Class::Topology, "triangle without area")],
            |_, _, answer: &mut Overlaid| {
                let regions = &mut answer.regions;
                if let (Some(&[a, b, _]), Some(&source), Some(&sides)) =
                    (regions.triangles.first(), regions.sources.first(), regions.sides.first())
                {
                    regions.triangles.push([a, b, b]);
                    regions.sources.push(source);
                    regions.sides.push(sides);
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-moves-a-corner",
            "the first corner of the first piece is replaced by the first corner of the last piece",
            "exact",
            &[(Class::Topology, "self-intersection")],
            |_, _, answer: &mut Overlaid| {
                let triangles = &mut answer.regions.triangles;
                if let (Some(&[first, ..]), Some(&[last, ..])) = (triangles.first(), triangles.last()) {
                    triangles.iter_mut().flatten().filter(|v| **v == first).for_each(|v| *v = last);
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-has-no-limit",
            "the results are reported to have no limit",
            "sos:per-mesh",
            &[(Class::Topology, "limit")],
            |_, _, answer: &mut Overlaid| {
                answer.settled = Some(Err(Unsettled::Declined(Declined::scene("there is none"))))
            },
        ),
        Spoiled::new(
            "mesh-intersect-loses-a-piece",
            "the first piece is lost",
            "exact",
            &[(Class::Topology, "region not closed")],
            |_, _, answer: &mut Overlaid| {
                let regions = &mut answer.regions;
                if !regions.triangles.is_empty() {
                    regions.triangles.remove(0);
                    regions.sides.remove(0);
                    regions.sources.remove(0);
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-exchanges-sides",
            "the regions in front of and behind each piece are exchanged",
            "exact",
            &[(Class::Topology, "sides of a piece")],
            |_, _, answer: &mut Overlaid| answer.regions.sides.iter_mut().for_each(|sides| sides.reverse()),
        ),
        Spoiled::new(
            "mesh-intersect-other-regions",
            "pieces of the first mesh inside the second are reported outside, and the reverse",
            "exact",
            &[(Class::Topology, "region of a piece")],
            |_, _, answer: &mut Overlaid| {
                let regions = &mut answer.regions;
                let count = u32::try_from(regions.pairs.len()).unwrap_or(0);
                // Each pair again, with the other region of the second mesh.
                let others: Vec<[u32; 2]> =
                    regions.pairs.iter().map(|&[own, other]| [own, u32::from(other == OUTSIDE)]).collect();
                regions.pairs.extend(others);
                for (sides, _) in regions.sides.iter_mut().zip(&regions.sources).filter(|(_, of)| of.mesh == 0) {
                    sides.iter_mut().for_each(|side| *side += count);
                }
            },
        ),
        Spoiled::new(
            "mesh-intersect-gives-up",
            "two triangles are reported to meet in more than one segment",
            "exact",
            &[(Class::Topology, "two triangles meet in one segment")],
            |_, _, answer: &mut Overlaid| answer.broken = Some(Contradiction::Segment),
        ),
    ]
}
