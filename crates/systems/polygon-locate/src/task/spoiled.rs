//! Right answers with planted faults: they test the checks that no backend's fault reaches.

use crate::algorithm::Locations;
use predicament_judge::locate::Borders;
use predicament_predicates::{Scene, Vertex};

use super::{Located, MapWithProbes, PolygonLocate};
use predicament_tasks::{Class, Spoiled};

/// The regions that contain a point, and the regions whose boundary contains it.
type Found = (Vec<u32>, Vec<u32>);

pub(super) fn all() -> Vec<Spoiled<PolygonLocate>> {
    vec![
        Spoiled::new(
            "polygon-locate-loses-points",
            "a point in one region is reported in no region",
            "exact",
            &[(Class::Topology, "gap")],
            |_, _, answer: &mut Located| {
                each(answer, |_, (inside, _)| {
                    if inside.len() == 1 {
                        inside.clear()
                    }
                })
            },
        ),
        Spoiled::new(
            "polygon-locate-takes-the-other-side",
            "a point on the border of two regions is reported in the other of these",
            "sos",
            &[(Class::Topology, "shortcut")],
            |scene: &Scene, content: &MapWithProbes, answer: &mut Located| {
                let borders = borders(scene, content);
                let probes = content.vertices();
                each(answer, |at, (inside, boundary)| {
                    let exact = borders.locate(probes[at]);
                    if let ([here], [first, second], []) = (&inside[..], &exact.boundary[..], &exact.inside[..]) {
                        *inside = vec![if here == first { *second } else { *first }];
                        boundary.clear();
                    }
                });
            },
        ),
        Spoiled::new(
            "polygon-locate-takes-a-border",
            "a point on boundaries is reported on no boundary",
            "exact",
            &[(Class::MissedZero, "exact location")],
            |_, _, answer: &mut Located| each(answer, |_, (_, boundary)| boundary.clear()),
        ),
        Spoiled::new(
            "polygon-locate-adds-regions",
            "a point on boundaries is reported in all regions whose boundary it is not on",
            "exact",
            &[(Class::Overreach, "exact location")],
            |_, content: &MapWithProbes, answer: &mut Located| {
                let count = u32::try_from(content.map.regions().len()).unwrap_or(0);
                each(answer, |_, (inside, boundary)| {
                    if !boundary.is_empty() {
                        *inside = (0..count).filter(|region| !boundary.contains(region)).collect();
                    }
                });
            },
        ),
        Spoiled::new(
            "polygon-locate-next-region",
            "a point in one region is reported in the next",
            "exact",
            &[(Class::Topology, "misplaced")],
            |_, content: &MapWithProbes, answer: &mut Located| {
                let count = u32::try_from(content.map.regions().len()).unwrap_or(1);
                each(answer, |_, (inside, _)| {
                    if let [region] = &mut inside[..] {
                        *region = (*region + 1) % count;
                    }
                });
            },
        ),
        Spoiled::new(
            "polygon-locate-misses-a-border",
            "a point on the border of several regions is reported in the first of these and on no border",
            "exact",
            &[(Class::MissedZero, "missed-boundary")],
            |_, _, answer: &mut Located| {
                each(answer, |_, (inside, boundary)| {
                    if boundary.len() > 1 && inside.is_empty() {
                        *inside = vec![boundary[0]];
                        boundary.clear();
                    }
                });
            },
        ),
    ]
}

fn borders<'s>(scene: &'s Scene, content: &MapWithProbes) -> Borders<'s> {
    let regions = content.map.regions().iter();
    let rings = regions.map(|region| region.rings.iter().map(|ring| ring.vertices().to_vec()).collect());
    Borders::new(scene, &rings.collect::<Vec<Vec<Vec<Vertex>>>>())
}

/// Replaces each answer.
fn each(answer: &mut Located, with: impl Fn(usize, &mut Found)) {
    let spoiled = answer.0.iter().enumerate().map(|(at, location)| {
        let mut found = (location.inside.to_vec(), location.boundary.to_vec());
        with(at, &mut found);
        found
    });
    answer.0 = Locations::of(spoiled);
}
