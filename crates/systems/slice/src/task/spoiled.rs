//! Right answers with planted faults: they test the checks that no backend's fault reaches.

use crate::algorithm::{Contradiction, Source};
use predicament_predicates::Construction;

use super::{Cut, Slice, Solid};
use predicament_tasks::rounding::{far, one_place, spoiled};
use predicament_tasks::{Class, Spoiled};

pub(super) fn all() -> Vec<Spoiled<Slice>> {
    vec![
        Spoiled::new(
            "slice-caps-of-faces",
            "pieces of faces are reported as caps of the first plane",
            "exact",
            &[(Class::Topology, "cap not in its plane")],
            |_, _, answer: &mut Cut| {
                for source in answer.sliced.parts.iter_mut().flat_map(|part| &mut part.sources) {
                    *source = Source::Cap(0);
                }
            },
        ),
        Spoiled::new(
            "slice-other-faces",
            "each piece is reported as part of the face before or behind its own",
            "exact",
            &[(Class::Topology, "piece not in its face")],
            |_, content: &Solid, answer: &mut Cut| {
                for source in answer.sliced.parts.iter_mut().flat_map(|part| &mut part.sources) {
                    if let Source::Face(face) = source {
                        *face = if *face > 0 { *face - 1 } else { u32::from(content.faces.len() > 1) };
                    }
                }
            },
        ),
        Spoiled::new(
            "slice-loses-a-piece",
            "the first piece of a face is lost",
            "exact",
            &[(Class::Topology, "face area"), (Class::Topology, "part not closed")],
            |_, _, answer: &mut Cut| {
                for part in answer.sliced.parts.iter_mut().take(1) {
                    if let Some(at) = part.sources.iter().position(|source| matches!(source, Source::Face(_))) {
                        part.triangles.remove(at);
                        part.sources.remove(at);
                    }
                }
            },
        ),
        Spoiled::new(
            "slice-adds-a-needle",
            "a piece with two corners is added",
            "exact",
            &[(Class::Topology, "triangle without area")],
            |_, _, answer: &mut Cut| {
                for part in answer.sliced.parts.iter_mut().take(1) {
                    if let (Some(&[a, b, _]), Some(&source)) = (part.triangles.first(), part.sources.first()) {
                        part.triangles.push([a, b, b]);
                        part.sources.push(source);
                    }
                }
            },
        ),
        Spoiled::new(
            "slice-moves-a-corner",
            "in each part, the first corner of the first piece is replaced by the first corner of the last piece",
            "exact",
            &[(Class::Topology, "self-intersection")],
            |_, _, answer: &mut Cut| {
                for part in &mut answer.sliced.parts {
                    let ends = (part.triangles.first().copied(), part.triangles.last().copied());
                    if let (Some([first, ..]), Some([last, ..])) = ends {
                        part.triangles.iter_mut().flatten().filter(|v| **v == first).for_each(|v| *v = last);
                    }
                }
            },
        ),
        Spoiled::new(
            "slice-loses-a-point",
            "the line of the first constructed vertex is replaced by a line in its plane",
            "exact",
            &[(Class::Topology, "vertex not finite")],
            |_, _, answer: &mut Cut| {
                if let Some(Construction::Lpi { line, plane: [a, b, _] }) = answer.sliced.constructions.first_mut() {
                    *line = [*a, *b];
                }
            },
        ),
        Spoiled::new(
            "slice-rounds-vertices",
            "constructed vertices are rounded, the first to doubles an ulp beside the nearest",
            "exact",
            &[
                (Class::Rounded, "wrong side"),
                (Class::Rounded, "cap not in its plane"),
                (Class::Rounded, "piece not in its face"),
                (Class::Rounded, "face area"),
                (Class::Rounded, "volume"),
            ],
            |scene, _, answer: &mut Cut| answer.rounded = spoiled(scene, &answer.sliced.constructions, one_place),
        ),
        Spoiled::new(
            "slice-moves-a-vertex",
            "constructed vertices are rounded, the first to doubles a thousandth beside the nearest",
            "exact",
            &[
                (Class::Topology, "wrong side"),
                (Class::Topology, "cap not in its plane"),
                (Class::Topology, "piece not in its face"),
                (Class::Topology, "face area"),
                (Class::Topology, "volume"),
            ],
            |scene, _, answer: &mut Cut| answer.rounded = spoiled(scene, &answer.sliced.constructions, far),
        ),
        Spoiled::new(
            "slice-gives-up",
            "cutting stops at the first plane",
            "exact",
            &[(Class::Topology, "a face has an even number of crossings")],
            |_, _, answer: &mut Cut| answer.sliced.broken = Some((Contradiction::Crossings, Some(0))),
        ),
        Spoiled::new(
            "slice-turns-caps",
            "caps face into their part",
            "exact",
            &[(Class::Topology, "cap orientation")],
            |_, _, answer: &mut Cut| {
                for part in &mut answer.sliced.parts {
                    let pieces = part.triangles.iter_mut().zip(&part.sources);
                    for (triangle, _) in pieces.filter(|(_, source)| matches!(source, Source::Cap(_))) {
                        triangle.swap(1, 2);
                    }
                }
            },
        ),
    ]
}
