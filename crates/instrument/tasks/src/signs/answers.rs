//! Every answer as a line: its class, and the stage that settles it alone.

use predicament_judge::TieJudge;
use predicament_predicates::{Class, Counts};
use rayon::prelude::*;

use super::given::{Given, class};
use crate::{AnswerLine, Contestant, symbol};

/// The lines of all answers, in query order.
pub(super) fn lines(given: &Given<'_>, ties: Option<&TieJudge>, backend: &dyn Contestant) -> Vec<AnswerLine> {
    let classes: Vec<Class> = (0..given.queries.len()).into_par_iter().map(|query| class(given, ties, query)).collect();
    let stages = stages(given, backend);
    let line = |(query, (class, stage)): (usize, (Class, &'static str))| AnswerLine {
        query,
        args: given.queries.args(query).to_vec(),
        answer: symbol(given.answers[query]),
        exact: symbol(given.truth[query]),
        class,
        stage,
    };
    classes.into_iter().zip(stages).enumerate().map(line).collect()
}

/// The stage of each query, asked alone in the whole scene.
fn stages(given: &Given<'_>, backend: &dyn Contestant) -> Vec<&'static str> {
    let (question, counts) = (given.queries.question(), Counts::new());
    let names = backend.stages();
    let settled = || (0..names.len()).map(|stage| counts.get(question.kind(), stage)).collect::<Vec<u64>>();
    let mut stages = vec![""; given.queries.len()];
    let prepared = backend.with_counted_session(given.scene, &counts, &mut |session| {
        let mut before = settled();
        for (query, stage) in stages.iter_mut().enumerate() {
            question.ask(session, given.queries.args(query));
            let after = settled();
            if let Some(at) = (0..names.len()).find(|&at| before[at] != after[at]) {
                *stage = names[at];
            }
            before = after;
        }
    });
    // A backend that took the scene before takes it again; if not, answers have no stage.
    drop(prepared);
    stages
}
