//! Simulation of Simplicity on the points that bytes encode: each sign equals the judge's, and each tie is broken as
//! explicit infinitesimals break it.

use predicament_judge as judge;
use predicament_predicates::{Backend, Off, PredicateKind, QuerySet, Sign, Vertex};
use predicament_sos::{Scheme, Sos, infinitesimal};

/// The schemes that the first byte chooses from.
const SCHEMES: [Scheme; 2] = [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke];

/// Runs one fuzz case; the first byte chooses the predicate and the scheme.
///
/// # Panics
/// If a sign differs from the judge's, alone or in a batch: the message has the points bit by bit.
pub fn check(bytes: &[u8]) {
    if let Some(wrong) = first_wrong(bytes, |scheme| Sos { scheme }) {
        panic!("{wrong}");
    }
}

/// The predicate and the scheme that a first byte chooses.
#[must_use]
pub fn chosen(head: u8) -> (PredicateKind, usize) {
    let kind = PredicateKind::ALL[usize::from(head) % PredicateKind::ALL.len()];
    (kind, usize::from(head) / PredicateKind::ALL.len() % SCHEMES.len())
}

/// The first wrong sign, in words.
fn first_wrong<B: Backend>(bytes: &[u8], backend: impl Fn(Scheme) -> B) -> Option<String> {
    let (&head, bytes) = bytes.split_first()?;
    let (kind, scheme) = chosen(head);
    let scheme = SCHEMES[scheme];
    let (scene, questions) = crate::case(kind, bytes);
    let backend = backend(scheme);
    let session = backend.prepare(&scene, Off).ok()?;
    questions.into_iter().find_map(|question| {
        let vertices: Vec<Vertex> = scene.vertices().collect();
        let queries = QuerySet::new(question, vertices.windows(kind.arity()).flatten().copied().collect());
        let mut batch = vec![Sign::Zero; queries.len()];
        queries.ask_batch(&session, 0..queries.len(), &mut batch);
        batch.into_iter().enumerate().find_map(|(query, in_batch)| {
            let args = queries.args(query);
            let alone = question.ask(&session, args);
            let truth = match judge::sign(&scene, question, args) {
                Sign::Zero => infinitesimal::judge(scheme, &scene, question, args),
                sign => sign,
            };
            ([alone, in_batch] != [truth, truth]).then(|| {
                let (asked, bits) = (question.query(args), crate::bits(&scene));
                format!(
                    "{asked} is {truth} under {scheme:?}; alone {alone}, in a batch {in_batch}; all coordinates: {bits}"
                )
            })
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::bytes;

    #[test]
    fn ties_are_broken_as_infinitesimals_break_them_and_a_planted_fault_is_caught() {
        for run in 0..2000 {
            check(&bytes(run));
        }
        // The other scheme breaks ties differently.
        let swapped = |scheme| Sos {
            scheme: if scheme == Scheme::PerCoordinate { Scheme::EdelsbrunnerMucke } else { Scheme::PerCoordinate },
        };
        assert!((0..2000).any(|run| first_wrong(&bytes(run), swapped).is_some()));
    }
}
