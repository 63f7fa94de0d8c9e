//! The judge of other programs' distances.
//!
//! A program gives the distance of two objects in doubles: zero if they have a common point.
//!
//! # The error in a distance
//! Let every vertex of both objects be displaced by at most δ. Then every point of an object is displaced by at most δ,
//! since it is a convex combination of vertices, and the distance of the objects changes by at most 2δ. So half of the
//! error is the distance by which rounding would have to displace vertices, and has the classes of all distances
//! ([`Bound`]): as good as doubles allow, rounded, or wrong. The distance of another pair of features is wrong unless
//! that pair is nearest up to this bound.

use predicament_judge::rational;
use predicament_predicates::Scene;
use predicament_tasks::replies::{
    Array, Arrays, Bound, Example, FORM, Form, Part, Replies, Reply, SpoiledReply, Unjudged, add_row, note,
};
use predicament_tasks::{Asked, Case, Check, Class, Outcome};
use rug::Rational;

use super::{Distance, TwoObjects};
use crate::answer::Nearest;
use crate::truth::{measured, root};

/// The judge.
pub(super) struct Judge;

/// The name of the answer's number.
const NAME: &str = "distance";
const WRONG: &str = "wrong distance";
const MEANS: &str = "a program's distance is that of the objects, up to rounding";
const CONTACT: &str = "wrong contact";
const CONTACT_MEANS: &str = "a program's distance is zero if the objects have a common point, up to rounding";

/// The squared distance of the pair that an answer names; zero for objects that have a common point.
pub(super) fn squared(scene: &Scene, answer: &Nearest) -> Rational {
    let pair = answer.pairs.first().filter(|_| !answer.kind.is_zero());
    pair.and_then(|pair| measured(scene, pair)).map(|solved| solved.squared).unwrap_or_default()
}

/// The difference of a distance from the root of a squared distance, as a double.
///
/// It is (d² − s) / (d + √s): the numerator is exact, so nothing cancels.
fn error(distance: f64, squared: &Rational) -> f64 {
    let distance = rational(distance);
    let difference = (Rational::from(&distance * &distance) - squared).abs();
    if difference == 0 {
        return 0.0;
    }
    let sum = distance + rational(root(squared).min(f64::MAX));
    (difference / sum).to_f64()
}

impl Replies<Distance> for Judge {
    fn parts(&self) -> &'static [Part] {
        const { &[Part::new(NAME, Form::Number, "the distance of the objects; zero if they have a common point")] }
    }

    fn example(&self) -> Example {
        Example {
            suites: "distances",
            functions: &[
                ("python", include_str!("../engines/distance.py")),
                ("cpp", include_str!("../engines/distance.cpp")),
                ("rust", include_str!("../engines/distance.rs")),
                ("node", include_str!("../engines/distance.mjs")),
            ],
        }
    }

    fn judge(
        &self,
        case: &Case<'_, Distance>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        asked.watch.done(0)?;
        let distance = reply.arrays.number(NAME)?;
        let objects = case.content.objects().map(|object| object.vertices());
        let bound = Bound::of(case.scene(), [&objects[0], &objects[1]]);
        let truth = &case.truth;
        let half = error(distance.abs(), &truth.squared) / 2.0;
        let far = bound.class(if distance < 0.0 { f64::INFINITY } else { half });
        add_row(case, asked, (NAME, 1), (&bound, &far), outcome);
        if far.class != Class::Agree {
            let (check, means) = if truth.kind.is_zero() { (CONTACT, CONTACT_MEANS) } else { (WRONG, MEANS) };
            let wanted = root(&truth.squared);
            let got = format!("{distance:?}, expected {wanted:?}: as if vertices were {} off", bound.told(half));
            note(outcome, far.class, check, got, means);
        }
        Ok(())
    }

    fn reply_of(&self, scene: &Scene, _: &TwoObjects, answer: &Nearest) -> Arrays {
        let mut arrays = Arrays::default();
        arrays.add(NAME, Array::Numbers(vec![root(&squared(scene, answer))]));
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::topology(WRONG, MEANS),
                Check::rounded(WRONG, MEANS),
                Check::topology(CONTACT, CONTACT_MEANS),
                Check::rounded(CONTACT, CONTACT_MEANS),
            ]
        }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Distance>> {
        vec![
            SpoiledReply {
                name: "distance-reply-adds-a-thousandth",
                what: "distances are larger by a thousandth",
                backend: "exact",
                caught_by: &[(Class::Topology, WRONG)],
                spoil: |_, _, arrays| set(arrays, |x| x * 1.001),
            },
            SpoiledReply {
                name: "distance-reply-is-in-singles",
                what: "distances are off by 2^-26 of their size, as in single precision",
                backend: "exact",
                caught_by: &[(Class::Rounded, WRONG)],
                spoil: |_, _, arrays| set(arrays, |x| x * (1.0 + 2.0_f64.powi(-26))),
            },
            SpoiledReply {
                name: "distance-reply-has-no-contacts",
                what: "objects that have a common point are at distance 1",
                backend: "exact",
                caught_by: &[(Class::Topology, CONTACT)],
                spoil: |_, _, arrays| set(arrays, |x| if x == 0.0 { 1.0 } else { x }),
            },
            SpoiledReply {
                name: "distance-reply-nearly-touches",
                what: "objects that have a common point are at distance 2^-30",
                backend: "exact",
                caught_by: &[(Class::Rounded, CONTACT)],
                spoil: |_, _, arrays| set(arrays, |x| if x == 0.0 { 2.0_f64.powi(-30) } else { x }),
            },
            SpoiledReply {
                name: "distance-reply-is-a-nan",
                what: "the distance is NaN",
                backend: "exact",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| set(arrays, |_| f64::NAN),
            },
        ]
    }
}

fn set(arrays: &mut Arrays, change: impl Fn(f64) -> f64) {
    if let Some(Array::Numbers(numbers)) = arrays.get_mut(NAME) {
        numbers.iter_mut().for_each(|number| *number = change(*number));
    }
}
