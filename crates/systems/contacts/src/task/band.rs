//! The judgement of backends with a band, by exact distances.
//!
//! Every registered pair is judged, and every pair that is near enough to be registered. The class depends on the
//! violation of the guarantee:
//!
//! | verdict | degenerate pairs | pairs of full dimension | check |
//! |---|---|---|---|
//! | registered beyond T₊, or without a crossing | `overreach` | `sign_flip` | `band` |
//! | not registered up to T₋, or in spite of a crossing | `missed_zero` | `sign_flip` | `band` |
//! | a guarded quantity below its bound: a sub-pair was missed | `missed_zero` | `missed_zero` | `unguarded` |
//! | a weight not in [0, 1] | `inconsistent` | `inconsistent` | `weights` |
//! | a weight that is not a number | `nan` | `nan` | `weights` |
//! | registered although a sub-pair is | `inconsistent` | `inconsistent` | `unasked` |
//! | registered although not near | `overreach` | `overreach` | `unasked` |
//! | registered although a test of its algorithm had to fail | `overreach` | `overreach` | `reading` |
//! | not registered although all tests had to pass | `missed_zero` | `missed_zero` | `reading` |
//!
//! The last two verdicts also apply to pairs that have ended: a sample of them is queried separately. The tolerances
//! are those that the paper publishes, for the lengths in the scene, and not those that the backend claims.
//!
//! A backend without bands for contacts is judged by exact contacts, the only possible promise.

use std::collections::{BTreeMap, BTreeSet};

use crate::algorithm::pairs::Contacts;
use crate::checks::audit::{Finding, Verdict, audit};
use predicament_mesh::Complex;
use predicament_predicates::Predicates;

use super::pairs::{Pairs, is_degenerate};
use crate::truth::Pair;
use predicament_tasks::Class;

/// The pairs that break the guarantee.
pub(crate) fn broken<S: Predicates + ?Sized>(
    session: &S,
    [a, b]: [&Complex; 2],
    contacts: &Contacts,
    got: &Pairs,
) -> BTreeMap<Pair, (Class, &'static str)> {
    let findings = audit(session, a, b, contacts).findings;
    if findings.is_empty() {
        return BTreeMap::new();
    }
    let dimension = session.scene().dimension();
    let without_numbers: BTreeSet<Pair> = contacts
        .registered
        .iter()
        .filter(|contact| contact.on_a.iter().chain(&contact.on_b).any(|weight| weight.is_nan()))
        .map(|contact| [contact.a, contact.b])
        .collect();
    let class = |finding: Finding| {
        let pair = [finding.a, finding.b];
        let degenerate = is_degenerate(dimension, pair);
        let class = match finding.verdict {
            Verdict::Overreach if degenerate => (Class::Overreach, "band"),
            Verdict::Missed if degenerate => (Class::MissedZero, "band"),
            Verdict::Overreach | Verdict::Missed => (Class::SignFlip, "band"),
            Verdict::Unguarded => (Class::MissedZero, "unguarded"),
            Verdict::BadWeight if without_numbers.contains(&pair) => (Class::Nan, "weights"),
            Verdict::BadWeight => (Class::Inconsistent, "weights"),
            Verdict::Unasked if got.ended_by(pair).is_some() => (Class::Inconsistent, "unasked"),
            Verdict::Unasked => (Class::Overreach, "unasked"),
            Verdict::Misread if finding.registered => (Class::Overreach, "reading"),
            Verdict::Misread => (Class::MissedZero, "reading"),
            Verdict::Agree | Verdict::InBand => return None,
        };
        Some((pair, class))
    };
    findings.into_iter().filter_map(class).collect()
}
