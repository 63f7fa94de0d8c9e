//! The judge of other programs' measures of unions of cubes.
//!
//! A program gives the volume and the area in doubles, and the length of the edges if it likes. Where cubes touch,
//! there may be a wall between them or not: the area may be that of the union of closed cubes, that of the union of
//! open ones, or between the two.
//!
//! # The error in a distance
//! Let every face of the union be displaced by at most δ. Then the volume changes by at most Aδ for an area A, up to
//! squares of δ, the area by at most 2Eδ for edges of length E, and the length of the edges by at most 2δ for each
//! edge. An edge is at most as long as the edge c of a cube, or it consists of pieces that are, so there are at least
//! E / c of them. The judge divides the error of each measure by that factor. The quotient is the distance by which
//! faces are displaced in a union with that measure, and has the classes of all distances ([`Bound`]).

use predicament_judge::boxes::{Boxes, are_near};
use predicament_judge::{nearest, rational};
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::replies::{
    Array, Arrays, Bound, Example, FORM, Form, Part, Replies, Reply, SpoiledReply, Unjudged, add_row, note,
};
use predicament_tasks::{Asked, Case, Check, Class, Outcome};
use rug::Rational;

use super::{CubeUnion, Cubes, Union};
use crate::checks::Measures;
use crate::truth::{closed_and_open, in_units};

/// The judge.
pub(super) struct Judge;

/// The names of the answer's numbers, which are also the names of the checks.
const NAMES: [&str; 3] = ["volume", "area", "edge_length"];
const MEANS: [&str; 3] = [
    "a program's volume is that of the union, up to rounding",
    "a program's area is that of the union of closed cubes, of open ones, or between these, up to rounding",
    "a program's length of edges is that of the union, up to rounding, unless cubes touch or share planes",
];
/// The name of the check of each number.
const CHECKS: [&str; 3] = ["wrong volume", "wrong area", "wrong edge length"];

/// The judged measures of cubes that meet and have faces in one plane.
const TIED: &str = "volume and area; the length of edges depends on how faces in one plane are seen";

impl Replies<CubeUnion> for Judge {
    fn parts(&self) -> &'static [Part] {
        const {
            &[
                Part::new("volume", Form::Number, "the volume of the union"),
                Part::new("area", Form::Number, "the area of its surface"),
                Part::optional("edge_length", Form::Number, "the length of its edges"),
            ]
        }
    }

    fn example(&self) -> Example {
        Example {
            suites: "cubes",
            functions: &[
                ("python", include_str!("../engines/cube_union.py")),
                ("cpp", include_str!("../engines/cube_union.cpp")),
                ("rust", include_str!("../engines/cube_union.rs")),
                ("node", include_str!("../engines/cube_union.mjs")),
            ],
        }
    }

    fn judge(
        &self,
        case: &Case<'_, CubeUnion>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let scene = case.scene();
        let (both, exponent) = closed_and_open(scene);
        asked.watch.done(0)?;
        let [closed, open] = both.map(|measures| in_units(&measures, exponent));
        let corners = [0, 1].map(Vertex::input);
        let cube: &[Vertex] = if scene.is_empty() { &[] } else { &corners };
        let bound = Bound::of(scene, [cube, cube]);
        let edge = cube.first().map_or_else(Rational::new, |&low| {
            let [low, high] = [low, corners[1]].map(|v| rational(scene.point3(v)[0]));
            high - low
        });
        for (at, name) in NAMES.into_iter().enumerate() {
            if at == 2 && reply.arrays.get(name).is_none() {
                continue;
            }
            if at == 2 && are_tied(scene, case.content) {
                outcome.sampled = Some(TIED.to_owned());
                continue;
            }
            let number = reply.arrays.number(name)?;
            let found = rational(number);
            let [least, most] = [&closed[at], &open[at]];
            let off = Rational::from(least - &found).max(Rational::from(&found - most)).max(Rational::new());
            let factor = match at {
                0 => closed[1].clone(),
                1 => Rational::from(2 * &closed[2]),
                _ if edge.is_zero() => Rational::new(),
                _ => Rational::from(2 * &closed[2]) / &edge,
            };
            let distance = match (off.is_zero(), factor.is_zero()) {
                (true, _) => 0.0,
                (false, true) => f64::INFINITY,
                (false, false) => (off / factor).to_f64(),
            };
            let far = bound.class(distance);
            add_row(case, asked, (name, 1), (&bound, &far), outcome);
            if far.class != Class::Agree {
                let wanted = if least == most {
                    format!("{:?}", nearest(least))
                } else {
                    format!("{:?} to {:?}", nearest(least), nearest(most))
                };
                let got = format!("{number:?}, expected {wanted}: as if faces were {} off", bound.told(distance));
                note(outcome, far.class, CHECKS[at], got, MEANS[at]);
            }
        }
        Ok(())
    }

    fn reply_of(&self, _: &Scene, _: &Cubes, answer: &Union) -> Arrays {
        let mut arrays = Arrays::default();
        for (name, measure) in NAMES.into_iter().zip(measures(answer)) {
            arrays.add(name, Array::Numbers(vec![measure]));
        }
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::topology(CHECKS[0], MEANS[0]),
                Check::rounded(CHECKS[0], MEANS[0]),
                Check::topology(CHECKS[1], MEANS[1]),
                Check::rounded(CHECKS[1], MEANS[1]),
                Check::topology(CHECKS[2], MEANS[2]),
                Check::rounded(CHECKS[2], MEANS[2]),
            ]
        }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<CubeUnion>> {
        vec![
            SpoiledReply {
                name: "cube-union-reply-adds-a-thousandth",
                what: "all measures are larger by a thousandth",
                backend: "sos",
                caught_by: &[(Class::Topology, CHECKS[0]), (Class::Topology, CHECKS[1]), (Class::Topology, CHECKS[2])],
                spoil: |_, _, arrays| each(arrays, |x| x * 1.001),
            },
            SpoiledReply {
                name: "cube-union-reply-is-in-singles",
                what: "all measures are off by 2^-26 of their size, as in single precision",
                backend: "sos",
                caught_by: &[(Class::Rounded, CHECKS[0]), (Class::Rounded, CHECKS[1]), (Class::Rounded, CHECKS[2])],
                spoil: |_, _, arrays| each(arrays, |x| x * (1.0 + 2.0_f64.powi(-26))),
            },
            SpoiledReply {
                name: "cube-union-reply-adds-up-cubes",
                what: "the volume is that of all cubes, one by one",
                backend: "sos",
                caught_by: &[(Class::Topology, CHECKS[0])],
                spoil: |scene, content, arrays| {
                    let edge = scene.coordinates().get(3).copied().unwrap_or(0.0) - scene.coordinates()[0];
                    let count = f64::from(u32::try_from(content.cubes).unwrap_or(u32::MAX));
                    set(arrays, "volume", count * edge * edge * edge);
                },
            },
            SpoiledReply {
                name: "cube-union-reply-has-no-area",
                what: "the area is NaN",
                backend: "sos",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| set(arrays, "area", f64::NAN),
            },
        ]
    }
}

/// Volume, area and length of edges in the nearest doubles.
pub(super) fn measures(union: &Union) -> [f64; 3] {
    let Union { mass, exponent } = union;
    let measures = Measures { volume: mass.volume, area: mass.area, edge_length: mass.edge_length };
    in_units(&measures, *exponent).map(|measure| nearest(&measure))
}

/// True if two cubes that meet have faces in one plane: then the length of edges depends on the view of such faces.
fn are_tied(scene: &Scene, content: &Cubes) -> bool {
    let cube = |at: usize| [2 * at, 2 * at + 1].map(|corner| scene.point3(Vertex::input(corner)));
    let all: Vec<[[f64; 3]; 2]> = (0..content.cubes).map(cube).collect();
    let index = Boxes::new(all.clone());
    let mut near = Vec::new();
    all.iter().enumerate().any(|(at, one)| {
        index.near(one, 0.0, &mut near);
        let mut others = near.iter().map(|&other| other as usize).filter(|&other| other > at);
        others.any(|other| {
            let other = &all[other];
            let shares = |axis: usize| one.iter().any(|p| other.iter().any(|q| p[axis] == q[axis]));
            are_near(one, other, 0.0) && (0..3).any(shares)
        })
    })
}

fn each(arrays: &mut Arrays, change: impl Fn(f64) -> f64) {
    for name in NAMES {
        if let Ok(number) = arrays.number(name) {
            set(arrays, name, change(number));
        }
    }
}

fn set(arrays: &mut Arrays, name: &str, number: f64) {
    if let Some(Array::Numbers(numbers)) = arrays.get_mut(name) {
        *numbers = vec![number];
    }
}
