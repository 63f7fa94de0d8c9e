//! Checks that parts are closed, and on one side of each plane.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::crossing::Near;
use super::exact::Plane;
use super::{Check, Expected, Flaws, Part, Slices};

/// The sides of the triangles of a part, and the edges along which covers would close open loops.
fn directed(part: &Part) -> impl Iterator<Item = [u32; 2]> + '_ {
    let around = |corners: &'_ [u32]| {
        let corners = corners.to_vec();
        (0..corners.len()).map(move |at| [corners[at], corners[(at + 1) % corners.len()]])
    };
    part.triangles.iter().flat_map(move |t| around(t)).chain(part.open.iter().flat_map(move |l| around(l)))
}

impl Slices {
    /// Checks that each directed edge occurs as often as its reverse.
    pub(super) fn closed(&self, expected: Expected, flaws: &mut Flaws) {
        for (at, part) in self.parts.iter().enumerate() {
            let mut surplus: BTreeMap<[u32; 2], i64> = BTreeMap::new();
            for [a, b] in directed(part) {
                *surplus.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
            }
            for (edge, surplus) in surplus.into_iter().filter(|(_, surplus)| *surplus != 0) {
                let sides = surplus.unsigned_abs();
                flaws.add(Check::Closed, &edge, || {
                    format!("part {at} has an edge with {sides} unpaired side(s) of triangles")
                });
            }
            if let Some(open) = part.open.first().filter(|_| expected.is_closed) {
                flaws.add(Check::Closed, open, || format!("part {at} of a closed mesh has an open loop"));
            }
        }
    }

    /// Checks that no part has points on both sides of a plane; returns the side of each part and plane.
    pub(super) fn sides(&self, near: &Near<'_>, flaws: &mut Flaws) {
        let mut used: Vec<Vec<u32>> = self.parts.iter().map(|part| part.triangles.as_flattened().to_vec()).collect();
        for points in &mut used {
            points.sort_unstable();
            points.dedup();
        }
        // Side by part and plane, for caps.
        let mut sides: BTreeMap<(usize, usize), Ordering> = BTreeMap::new();
        for (place, &corners) in self.planes.iter().enumerate() {
            let plane = near.across(corners);
            // One point can be in several parts.
            let mut known: Vec<Option<Ordering>> = vec![None; self.points.len()];
            for (at, points) in used.iter().enumerate() {
                let mut first: [Option<u32>; 2] = [None; 2];
                for &p in points {
                    let side = *known[p as usize].get_or_insert_with(|| plane.side(p));
                    match side {
                        Ordering::Less => first[0].get_or_insert(p),
                        Ordering::Equal => continue,
                        Ordering::Greater => first[1].get_or_insert(p),
                    };
                }
                let side = match first {
                    [Some(_), None] => Ordering::Less,
                    [None, Some(_)] => Ordering::Greater,
                    [None, None] => Ordering::Equal,
                    [Some(below), Some(above)] => {
                        let plane = Plane::of(self.points(corners));
                        let reach = |on: Ordering| {
                            let there = points.iter().filter(|&&p| known[p as usize] == Some(on));
                            there.map(|&p| plane.distance(&self.points[p as usize])).fold(0.0, f64::max)
                        };
                        let [under, over] = [Ordering::Less, Ordering::Greater].map(reach);
                        flaws.add(Check::Side, &[below, above], || {
                            format!("part {at} is on both sides of plane {place}, by {:e}", under.min(over))
                        });
                        // The side with the larger extent: a point that is rounded to the other side does not turn the
                        // caps.
                        over.total_cmp(&under)
                    }
                };
                sides.insert((at, place), side);
            }
        }
        self.caps(near, &sides, flaws);
    }
}
