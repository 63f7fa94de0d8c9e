//! Right answers with planted faults: they test the checks that no backend's fault reaches.

use crate::algorithm::overlay::Contradiction;
use predicament_mesh::Nesting;

use super::{Overlaid, Overlay2d};
use predicament_tasks::rounding::{far, one_place, spoiled};
use predicament_tasks::{Class, Spoiled};

/// The nodes as moved doubles: see [`spoiled`].
fn rounded(answer: &Overlaid, moved: fn(f64) -> f64) -> Option<Vec<[f64; 2]>> {
    let scene = answer.scene.as_ref()?;
    let places = spoiled::<2>(scene, scene.constructions(), moved)?;
    let of = |v: &predicament_predicates::Vertex| v.construction().map_or([0.0; 2], |index| places[index]);
    Some(answer.overlay.arrangement.vertices.iter().map(of).collect())
}

pub(super) fn all() -> Vec<Spoiled<Overlay2d>> {
    vec![
        Spoiled::new(
            "overlay-node-twice",
            "the second node is at the place of the first",
            "exact",
            &[(Class::Topology, "nodes")],
            |_, _, answer: &mut Overlaid| {
                if let [first, second, ..] = &mut answer.overlay.arrangement.vertices[..] {
                    *second = *first;
                }
            },
        ),
        Spoiled::new(
            "overlay-moves-an-edge",
            "the first edge ends in the last node",
            "exact",
            &[(Class::Topology, "edges"), (Class::Topology, "boundary"), (Class::Topology, "euler")],
            |_, _, answer: &mut Overlaid| {
                let arrangement = &mut answer.overlay.arrangement;
                let last = u32::try_from(arrangement.vertices.len().saturating_sub(1)).unwrap_or(0);
                if let Some(piece) = arrangement.pieces.first_mut() {
                    piece.ends[1] = last;
                }
            },
        ),
        Spoiled::new(
            "overlay-turns-a-loop",
            "the first region of the union is turned over",
            "exact",
            &[(Class::Topology, "loop orientation")],
            |_, _, answer: &mut Overlaid| {
                if let Some(region) = answer.regions[0].regions.first_mut() {
                    region.outer.reverse();
                }
            },
        ),
        Spoiled::new(
            "overlay-crosses-a-loop",
            "two vertices of the first region of the union are exchanged",
            "exact",
            &[(Class::Topology, "crossing loops")],
            |_, _, answer: &mut Overlaid| {
                if let Some(region) = answer.regions[0].regions.iter_mut().find(|region| region.outer.len() > 3) {
                    region.outer.swap(1, 2);
                }
            },
        ),
        Spoiled::new(
            "overlay-loses-a-crossing",
            "all crossings are rounded to NaN",
            "exact",
            &[(Class::Topology, "vertex not finite")],
            |_, _, answer: &mut Overlaid| {
                answer.rounded = Some(vec![[f64::NAN; 2]; answer.overlay.arrangement.vertices.len()]);
            },
        ),
        Spoiled::new(
            "overlay-rounds-vertices",
            "crossings are rounded, the first to doubles an ulp beside the nearest",
            "exact",
            &[(Class::Rounded, "node off its segment"), (Class::Rounded, "area")],
            |_, _, answer: &mut Overlaid| answer.rounded = rounded(answer, one_place),
        ),
        Spoiled::new(
            "overlay-moves-a-vertex",
            "crossings are rounded, the first to doubles a thousandth beside the nearest",
            "exact",
            &[(Class::Topology, "node off its segment"), (Class::Topology, "area")],
            |_, _, answer: &mut Overlaid| answer.rounded = rounded(answer, far),
        ),
        Spoiled::new(
            "overlay-gives-up",
            "events are reported not to come from left to right",
            "exact",
            &[(Class::Topology, "events come from left to right")],
            |_, _, answer: &mut Overlaid| answer.overlay.arrangement.broken = Some(Contradiction::Events),
        ),
        Spoiled::new(
            "overlay-loses-a-segment",
            "the last segment is missing",
            "exact",
            &[(Class::Topology, "chain")],
            |_, _, answer: &mut Overlaid| {
                answer.overlay.arrangement.segments.pop();
            },
        ),
        Spoiled::new(
            "overlay-exchanges-nodes",
            "the first node and the last are exchanged",
            "exact",
            &[(Class::Topology, "undiscovered crossing")],
            |_, _, answer: &mut Overlaid| {
                if let [first, .., last] = &mut answer.overlay.arrangement.vertices[..] {
                    std::mem::swap(first, last);
                }
            },
        ),
        Spoiled::new(
            "overlay-nests-outside",
            "components in a face of another component are reported outside of all faces",
            "exact",
            &[(Class::Topology, "nesting")],
            |_, _, answer: &mut Overlaid| {
                let subdivision = &mut answer.overlay.arrangement.subdivision;
                let outside = subdivision.inner().iter().map(|&[_, cycle]| subdivision.cycles()[cycle as usize]);
                let nestings: Vec<Nesting> = outside.map(|outside| Nesting { outside, within: None }).collect();
                (*subdivision, _) = std::mem::take(subdivision).with_faces(&nestings);
            },
        ),
        Spoiled::new(
            "overlay-winds-once-more",
            "the winding number of the last face in the first polygon is one too large",
            "exact",
            &[(Class::Topology, "winding")],
            |_, _, answer: &mut Overlaid| {
                if let Some([first, _]) = answer.overlay.windings.last_mut() {
                    *first += 1;
                }
            },
        ),
        Spoiled::new(
            "overlay-shortcut-loses-a-region",
            "the results by the shortcut have no last region",
            "exact",
            &[(Class::Topology, "shortcut")],
            |_, _, answer: &mut Overlaid| {
                for shortcut in &mut answer.shortcuts {
                    shortcut.short.regions.pop();
                }
            },
        ),
        Spoiled::new(
            "overlay-loses-a-later-union",
            "the union of the union and the third polygon is empty",
            "exact",
            &[(Class::Topology, "membership")],
            |_, _, answer: &mut Overlaid| {
                let later = answer.shortcuts.iter_mut().skip(8).take(1);
                later.for_each(|made| {
                    made.short.regions.clear();
                    made.whole.regions.clear();
                });
            },
        ),
        Spoiled::new(
            "overlay-loses-the-union",
            "the union is empty",
            "exact",
            &[(Class::Topology, "membership")],
            |_, _, answer: &mut Overlaid| answer.regions[0].regions.clear(),
        ),
    ]
}
