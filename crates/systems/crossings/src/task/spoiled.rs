//! Right answers with planted faults, which prove that the checks find faults that no backend has.

use predicament_predicates::Scene;

use super::{Crossed, Crossings, Segments};
use crate::truth;
use predicament_tasks::{Class, Spoiled};

pub(super) fn all() -> Vec<Spoiled<Crossings>> {
    vec![
        Spoiled::new(
            "crossings-touch",
            "the first two segments with an end on the line of the other are reported to cross",
            "exact",
            &[(Class::MissedZero, "crossings")],
            |scene: &Scene, content: &Segments, answer: &mut Crossed| {
                let count = content.0.len();
                let pairs = (0..count).flat_map(|i| (0..count).map(move |j| [i, j])).filter(|[i, j]| i != j);
                let touching = pairs.into_iter().find_map(|[i, j]| {
                    let number = u32::try_from(j).ok()?;
                    let is_new = answer.0[i].iter().flatten().all(|other| *other != number);
                    (is_new && truth::touches(scene, content.0[i], content.0[j])).then_some((i, number))
                });
                if let Some((i, number)) = touching {
                    answer.0[i].push(vec![number]);
                }
            },
        ),
        Spoiled::new(
            "crossings-lose-the-last",
            "the last crossing of each segment is lost",
            "exact",
            &[(Class::SignFlip, "crossings")],
            |_, _, answer: &mut Crossed| {
                for along in &mut answer.0 {
                    along.pop();
                }
            },
        ),
        Spoiled::new(
            "crossings-at-one-place",
            "all crossings of a segment are at one place",
            "exact",
            &[(Class::Overreach, "order")],
            |_, _, answer: &mut Crossed| {
                for along in answer.0.iter_mut().filter(|along| along.len() > 1) {
                    let mut all = along.concat();
                    all.sort_unstable();
                    *along = vec![all];
                }
            },
        ),
        Spoiled::new(
            "crossings-lose-the-last-perturbed",
            "if ties are broken, the last crossing of each segment is lost",
            "sos",
            &[(Class::SignFlip, "perturbed crossings")],
            |_, _, answer: &mut Crossed| {
                for along in &mut answer.0 {
                    along.pop();
                }
            },
        ),
        Spoiled::new(
            "crossings-told-apart",
            "crossings at one place are reported as different",
            "exact",
            &[(Class::MissedZero, "order")],
            |_, _, answer: &mut Crossed| {
                for along in &mut answer.0 {
                    *along = along.iter().flatten().map(|&other| vec![other]).collect();
                }
            },
        ),
        Spoiled::new(
            "crossings-go-back",
            "the crossings of each segment are in reverse order",
            "exact",
            &[(Class::SignFlip, "order")],
            |_, _, answer: &mut Crossed| answer.0.iter_mut().for_each(|along| along.reverse()),
        ),
    ]
}
