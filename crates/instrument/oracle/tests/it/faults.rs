//! Planted faults that only some ways of judging detect.

use predicament_judge::TieJudge;
use predicament_predicates::{Question, Sign};
use predicament_tasks::signs::{SignQueries, Signs};
use predicament_tasks::{Budget, Class};

use crate::common::{checks, judged_by_name, load};

/// A tie: the query, its answers in a batch and alone, and the correct sign.
struct Tie {
    query: usize,
    given: Sign,
    alone: Sign,
    right: Sign,
}

/// All broken ties of a scene, in order.
fn ties(scene: &str, backend: &str) -> Vec<Tie> {
    let (loaded, contestant) = (load(scene), predicament_bundle::backend(backend).unwrap());
    let content: &SignQueries = loaded.content().unwrap();
    let queries = &content.queries;
    let given = contestant.answer(&Signs::of(queries.kind()), &loaded.scene, content).unwrap().0;
    let exact = predicament_bundle::backend("exact").unwrap();
    let exact = exact.answer(&Signs::of(queries.kind()), &loaded.scene, content).unwrap().0;
    let perturbed: &TieJudge = contestant.tie_judge().unwrap();
    let question: Question = queries.question();
    let mut ties = Vec::new();
    contestant
        .with_session(&loaded.scene, &mut |session| {
            ties = (0..queries.len())
                .filter(|&query| exact[query].is_zero())
                .map(|query| Tie {
                    query,
                    given: given[query],
                    alone: question.ask(session, queries.args(query)),
                    right: perturbed(&loaded.scene, question, queries.args(query)),
                })
                .collect();
        })
        .unwrap();
    ties
}

/// Answers are judged as given in the batch; single calls would show nothing.
#[test]
fn batches_that_break_ties_the_other_way_are_caught() {
    for scene in ["grid-4x4-orient2d", "grid-orient3d"] {
        let ties = ties(scene, "fault:sos-batch-flipped");
        assert!(
            !ties.is_empty() && ties.iter().all(|tie| tie.alone == tie.right && tie.given == -tie.right),
            "{scene}"
        );
        let outcome = judged_by_name(&load(scene), "fault:sos-batch-flipped");
        assert!(checks(&outcome).contains(&(Class::SignFlip, "perturbed sign")), "{scene}: {:?}", checks(&outcome));
    }
}

/// The number of queries in a chunk. An earlier sample took the first ties of each chunk.
const CHUNK: usize = 4096;

#[test]
fn a_term_that_is_wrong_about_late_ties_only_is_caught() {
    for scene in ["degen-insphere", "degen-orient2d-dimension-3-plane-yz"] {
        let ties = ties(scene, "fault:sos-late-swapped-term");
        let first = |tie: &&Tie| {
            ties.iter().filter(|t| t.query < tie.query && t.query / CHUNK == tie.query / CHUNK).count()
                < Budget::QUICK.ties
        };
        assert!(ties.iter().filter(first).all(|tie| tie.given == tie.right), "{scene}: the first ties are right");
        assert!(ties.iter().any(|tie| tie.given != tie.right), "{scene}: others are not");
        let outcome = judged_by_name(&load(scene), "fault:sos-late-swapped-term");
        assert!(checks(&outcome).contains(&(Class::SignFlip, "perturbed sign")), "{scene}: {:?}", checks(&outcome));
    }
}

#[test]
fn an_answer_that_changes_when_it_is_asked_again_is_unstable() {
    let outcome = judged_by_name(&load("grid-4x4-orient2d"), "fault:unsteady-again");
    let unstable: Vec<_> = outcome.findings.iter().filter(|finding| finding.class == Class::Unstable).collect();
    assert!(!unstable.is_empty() && outcome.counts.get(Class::Unstable) >= unstable.len() as u64);
    for finding in unstable {
        let both: Vec<String> = finding.got.chars().map(String::from).collect();
        assert!(finding.check == "repeat" && both.len() == 2 && both[0] != both[1], "{finding:?}");
        assert_eq!(both[0], finding.truth, "the first answer is right, and only the second is not");
    }
    assert_eq!(outcome.counts.get(Class::SignFlip), 0);
}
