//! The judge of other programs' segments that are rounded to a grid: see the [laws](crate::checks::snap_replies).
//!
//! Programs get the side of a pixel and the segments, and are not told of our methods. Each chain is a list of points
//! of the grid in doubles, which may be off by a few units in the last place.

use predicament_predicates::{Declined, Plane, Query, Scene, Vertex};
use predicament_tasks::replies::{
    Array, Arrays, Bound, Example, FORM, Far, Form, Malformed, NEAREST, Part, Replies, Reply, SpoiledReply, Unjudged,
    add_row,
};
use predicament_tasks::{Asked, Case, Check, Class, Finding, Outcome};

use super::{Chains, Drawn, Snap2d};
use crate::algorithm::snap::Method;
use crate::checks::snap::Pixel;
use crate::checks::snap_replies::{BACK, CROSS, Drawing, ENDS, FAR, GRID, HALF, LOST};

/// The judge.
pub(super) struct Judge;

/// The name of the answer's array.
const CHAINS: &str = "chains";
/// The largest distance of a chain from its segment that counts as rounded, in sides of pixels.
const MOST: f64 = 4.0;
/// The largest distance of a coordinate from the grid, in sides of pixels, however coarse doubles are there.
const OFF_GRID: f64 = 1.0 / 64.0;

const GRID_MEANS: &str = "a program's chain: each vertex is a point of the grid, up to rounding";
const ENDS_MEANS: &str =
    "a program's chain: it ends in grid points nearest to the ends of its segment, one for each point";
const FAR_MEANS: &str = "a program's chain: each vertex is within half the diagonal of a pixel of its segment";
const BACK_MEANS: &str = "a program's chain: it never goes back along its segment";
const CROSS_MEANS: &str = "a program's chains: they meet in common vertices only";
const LOST_MEANS: &str = "a program's chains: those of segments that cross have a common vertex near the crossing";

impl Replies<Snap2d> for Judge {
    fn parts(&self) -> &'static [Part] {
        const { &[Part::new(CHAINS, Form::Lines, "for each segment its rounded polyline, from the first end to the second")] }
    }

    fn example(&self) -> Example {
        Example {
            suites: "snaps",
            functions: &[
                ("python", include_str!("../../engines/snap2d.py")),
                ("cpp", include_str!("../../engines/snap2d.cpp")),
                ("rust", include_str!("../../engines/snap2d.rs")),
                ("node", include_str!("../../engines/snap2d.mjs")),
            ],
        }
    }

    /// Declines scenes that are about another method of ours: to a program they are the same as those of `snap`.
    fn open(&self, _: &Scene, content: &Drawn) -> Result<(), Declined> {
        match content.method {
            Method::Snap => Ok(()),
            Method::Naive | Method::Iterated => {
                Err(Declined::scene("the scene is about a method of ours; programs get scenes of the method snap"))
            }
        }
    }

    fn judge(
        &self,
        case: &Case<'_, Snap2d>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let (scene, content) = (case.scene(), case.content);
        if content.method != Method::Snap {
            // Not asked of programs.
            return Ok(());
        }
        let lines = reply.arrays.lines(CHAINS)?;
        let count = content.segments.len();
        if lines.len() != count || lines.iter().any(|line| line.is_empty()) {
            let what = format!("`{CHAINS}` has {} lines for {count} segments, or an empty line", lines.len());
            return Err(Malformed(what).into());
        }
        let most = asked.budget.findings_per_class;
        let note = |outcome: &mut Outcome, at: usize, (class, check): (Class, &str), got: String| {
            outcome.note(class, most, || {
                let query = Query::of_task("snap2d", &content.segments[at]);
                Finding::plain(class, check, vec![query], got, means(check).to_owned())
            });
        };
        let bound = Bound::of(scene, [&[], &[]]);
        // Exact: the reader refuses points for which a coordinate in sides of pixels is not a double.
        let side = 2.0_f64.powi(content.pixel);
        let allowed = (f64::from(NEAREST) * bound.unit / side).min(OFF_GRID);
        let mut chains = Vec::with_capacity(count);
        for (at, line) in lines.iter().enumerate() {
            match line.iter().map(|&point| pixel(point.map(|x| x / side), allowed)).collect::<Result<Vec<_>, _>>() {
                Ok(chain) => chains.push(chain),
                Err(point) => {
                    note(outcome, at, (Class::Topology, GRID), format!("{point:?} steps"));
                    return Ok(());
                }
            }
        }
        let place = |v: Vertex| scene.point2(Plane::Xy, v).map(|x| x / side);
        let segments: Vec<[[f64; 2]; 2]> = content.segments.iter().map(|ends| ends.map(place)).collect();
        let drawing = Drawing::new(&segments, chains);
        let (at, square) = drawing.farthest();
        let steps = square.to_f64().sqrt();
        let class = match steps {
            _ if square <= HALF => Class::Agree,
            _ if steps <= MOST => Class::Rounded,
            _ => Class::Topology,
        };
        let far = Far { distance: steps * side, class, within: steps * side };
        add_row(case, asked, (CHAINS, lines.iter().map(|line| line.len()).sum()), (&bound, &far), outcome);
        if class != Class::Agree {
            note(outcome, at, (class, FAR), format!("a vertex is {steps:.3} sides of a pixel off"));
        }
        asked.watch.done(0)?;
        for (at, check, what) in drawing.violations(&case.truth.crossings, &square) {
            note(outcome, at, (Class::Topology, check), what);
        }
        Ok(())
    }

    fn reply_of(&self, _: &Scene, content: &Drawn, answer: &Chains) -> Arrays {
        let line = |chain: &Vec<u32>| chain.iter().map(|&at| answer.snapped.centre(at, content.pixel)).collect();
        let lines: Vec<Vec<[f64; 2]>> = answer.snapped.chains.iter().map(line).collect();
        let mut arrays = Arrays::default();
        arrays.add_lines(CHAINS, &lines);
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::topology(GRID, GRID_MEANS),
                Check::topology(ENDS, ENDS_MEANS),
                Check::topology(FAR, FAR_MEANS),
                Check::rounded(FAR, FAR_MEANS),
                Check::topology(BACK, BACK_MEANS),
                Check::topology(CROSS, CROSS_MEANS),
                Check::topology(LOST, LOST_MEANS),
            ]
        }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Snap2d>> {
        vec![
            SpoiledReply {
                name: "snap2d-reply-is-beside-the-grid",
                what: "all chains are moved by a quarter of a pixel",
                backend: "exact",
                caught_by: &[(Class::Topology, GRID)],
                spoil: |_, content, arrays| {
                    let quarter = 2.0_f64.powi(content.pixel) / 4.0;
                    each(arrays, |line| line.iter_mut().flatten().for_each(|x| *x += quarter));
                },
            },
            SpoiledReply {
                name: "snap2d-reply-ends-in-the-next-pixel",
                what: "all chains are moved by a pixel along x",
                backend: "exact",
                caught_by: &[(Class::Topology, ENDS)],
                spoil: |_, content, arrays| {
                    let side = 2.0_f64.powi(content.pixel);
                    each(arrays, |line| line.iter_mut().for_each(|point| point[0] += side));
                },
            },
            SpoiledReply {
                name: "snap2d-reply-drifts",
                what: "the vertices between the ends of all chains are moved by a pixel along y",
                backend: "exact",
                caught_by: &[(Class::Rounded, FAR)],
                spoil: |_, content, arrays| inner(arrays, 2.0_f64.powi(content.pixel)),
            },
            SpoiledReply {
                name: "snap2d-reply-drifts-far",
                what: "the vertices between the ends of all chains are moved by a hundred pixels along y",
                backend: "exact",
                caught_by: &[(Class::Topology, FAR)],
                spoil: |_, content, arrays| inner(arrays, 100.0 * 2.0_f64.powi(content.pixel)),
            },
            SpoiledReply {
                name: "snap2d-reply-goes-back",
                what: "each chain goes to its last vertex, back to the first, and to the last again",
                backend: "exact",
                caught_by: &[(Class::Topology, BACK)],
                spoil: |_, _, arrays| {
                    each(arrays, |line| {
                        let ends = line.first().copied().zip(line.last().copied());
                        line.extend(ends.into_iter().flat_map(|(first, last)| [first, last]));
                    });
                },
            },
            SpoiledReply {
                name: "snap2d-reply-goes-straight",
                what: "each chain leads from its first vertex straight to its last",
                backend: "exact",
                caught_by: &[(Class::Topology, CROSS), (Class::Topology, LOST)],
                spoil: |_, _, arrays| {
                    each(arrays, |line| {
                        if line.len() > 2 {
                            line.drain(1..line.len() - 1);
                        }
                    });
                },
            },
            SpoiledReply {
                name: "snap2d-reply-is-half-an-answer",
                what: "the second half of the coordinates is missing",
                backend: "exact",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Numbers(numbers)) = arrays.get_mut(CHAINS) {
                        numbers.truncate(numbers.len() / 4 * 2);
                    }
                },
            },
        ]
    }
}

/// The grid point of a point in sides of pixels, or the point if it is too far from the grid.
fn pixel(point: [f64; 2], allowed: f64) -> Result<Pixel, [f64; 2]> {
    let is_near = |x: f64| (x - x.round()).abs() <= allowed && x.abs() < 2.0_f64.powi(52);
    if !point.into_iter().all(is_near) {
        return Err(point);
    }
    #[allow(clippy::cast_possible_truncation)] // a whole number below 2^52
    Ok(point.map(|x| x.round() as i64))
}

/// The law behind a check.
fn means(check: &str) -> &'static str {
    let all = Judge.checks();
    all.iter().find(|law| law.name == check).map_or("", |law| law.means)
}

fn each(arrays: &mut Arrays, mut change: impl FnMut(&mut Vec<[f64; 2]>)) {
    let Ok(lines) = arrays.lines(CHAINS) else { return };
    let mut lines: Vec<Vec<[f64; 2]>> = lines.into_iter().map(<[[f64; 2]]>::to_vec).collect();
    lines.iter_mut().for_each(&mut change);
    arrays.remove(CHAINS);
    arrays.add_lines(CHAINS, &lines);
}

/// Moves the vertices between the ends of all chains along y.
fn inner(arrays: &mut Arrays, by: f64) {
    each(arrays, |line| {
        if let [_, between @ .., _] = line.as_mut_slice() {
            between.iter_mut().for_each(|point| point[1] += by);
        }
    });
}
