//! Right answers with planted faults, which prove that the checks find faults that no backend has.

use super::checks::{KIND, NEAREST, TIES};
use super::{Distance, TwoObjects};
use crate::answer::{Feature, Kind, Nearest};
use predicament_tasks::{Class, Spoiled};

pub(super) fn all() -> Vec<Spoiled<Distance>> {
    vec![
        Spoiled::new(
            "distance-miss-contacts",
            "objects that touch are said to be apart",
            "exact",
            &[(Class::MissedZero, KIND)],
            |_, _, answer: &mut Nearest| rename(answer, Kind::Touching, Kind::Apart),
        ),
        Spoiled::new(
            "distance-touch-always",
            "objects that are apart are said to touch",
            "exact",
            &[(Class::Overreach, KIND)],
            |_, _, answer: &mut Nearest| rename(answer, Kind::Apart, Kind::Touching),
        ),
        Spoiled::new(
            "distance-cross-inside",
            "objects of which one is inside the other are said to cross",
            "exact",
            &[(Class::SignFlip, KIND)],
            |_, _, answer: &mut Nearest| rename(answer, Kind::Contained, Kind::Crossing),
        ),
        Spoiled::new(
            "distance-to-the-first-vertex",
            "the first vertices of both objects are said to be nearest",
            "exact",
            &[(Class::SignFlip, NEAREST)],
            |_, content: &TwoObjects, answer: &mut Nearest| {
                let first = content.objects().map(|object| Feature::Vertex(object.part(0)[0]));
                if !answer.pairs.is_empty() && !answer.pairs.contains(&first) {
                    answer.pairs = vec![first];
                }
            },
        ),
        Spoiled::new(
            "distance-lose-ties",
            "of several nearest pairs one is reported",
            "exact",
            &[(Class::MissedZero, TIES)],
            |_, _, answer: &mut Nearest| answer.pairs.truncate(1),
        ),
        Spoiled::new(
            "distance-add-a-tie",
            "beside the nearest pairs, the first vertices of both objects are reported",
            "exact",
            &[(Class::Overreach, TIES)],
            |_, content: &TwoObjects, answer: &mut Nearest| {
                let first = content.objects().map(|object| Feature::Vertex(object.part(0)[0]));
                if !answer.pairs.is_empty() && !answer.pairs.contains(&first) {
                    answer.pairs.push(first);
                }
            },
        ),
    ]
}

fn rename(answer: &mut Nearest, from: Kind, to: Kind) {
    if answer.kind == from {
        answer.kind = to;
    }
}
