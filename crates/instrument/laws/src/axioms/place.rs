//! The law of place: an answer depends on its vertices, not on its place in a batch or on other vertices.
//!
//! Batches go through other code than single calls do, four queries at a time
//! with a rest at the end; and a perturbation that depends on how many vertices
//! there are is not one perturbation. Neither may show.

use predicament_predicates::{Predicates, QuerySet, Question, Sign, Vertex};

use super::{Answer, Law, Violation};

/// Asks each query alone, and all in batches in which it stands elsewhere,
/// beside others: in order, without the first, and backwards. Turns are also
/// asked of one line with the last vertices of all queries, sides of one plane.
///
/// The violation has the query twice, alone first.
pub fn independence_of_place<P: Predicates + ?Sized>(session: &P, queries: &QuerySet) -> Option<Violation> {
    let question = queries.question();
    let alone: Vec<Sign> = (0..queries.len()).map(|query| question.ask(session, queries.args(query))).collect();
    let batch = |queries: &QuerySet, from: usize| {
        let mut out = vec![Sign::Zero; queries.len() - from];
        queries.ask_batch(session, from..queries.len(), &mut out);
        out
    };
    let arity = question.kind().arity();
    let backwards = QuerySet::new(question, queries.flat().chunks(arity).rev().flatten().copied().collect());
    let mut reversed = batch(&backwards, 0);
    reversed.reverse();
    let second = 1.min(queries.len());
    let tries = [(0, batch(queries, 0)), (second, batch(queries, second)), (0, reversed)];
    for (from, answers) in tries {
        if let Some(at) = (0..answers.len()).find(|&at| answers[at] != alone[from + at]) {
            return Some(violation(Law::Place, question, queries.args(from + at), [alone[from + at], answers[at]]));
        }
    }
    if queries.is_empty() { None } else { beside_one_base(session, question, queries) }
}

/// The first query's line or plane with many points.
fn beside_one_base<P: Predicates + ?Sized>(session: &P, question: Question, queries: &QuerySet) -> Option<Violation> {
    let last: Vec<Vertex> = (0..queries.len()).filter_map(|query| queries.args(query).last().copied()).collect();
    let mut out = vec![Sign::Zero; last.len()];
    let base = match (question, queries.args(0)) {
        (Question::Orient2d(plane), &[a, b, _]) => {
            session.orient2d_line(plane, [a, b], &last, &mut out);
            vec![a, b]
        }
        (Question::Orient3d, &[a, b, c, _]) => {
            session.orient3d_plane([a, b, c], &last, &mut out);
            vec![a, b, c]
        }
        _ => return None,
    };
    last.iter().zip(out).find_map(|(&v, beside)| {
        let args = [base.as_slice(), &[v]].concat();
        let alone = question.ask(session, &args);
        (alone != beside).then(|| violation(Law::Place, question, &args, [alone, beside]))
    })
}

/// Asks a session of a scene's first vertices what that of the whole scene is
/// asked. What comes after must not change an answer: a scene grows at its end.
///
/// (A tolerance is made for the extent of the scene, so a session whose zero is
/// a band does not promise this.) The violation has the query twice, with the
/// answer of the session of fewer vertices first.
pub fn independence_of_later_vertices<P: Predicates + ?Sized, Q: Predicates + ?Sized>(
    fewer: &P,
    all: &Q,
    question: Question,
    args: &[Vertex],
) -> Option<Violation> {
    let signs = [question.ask(fewer, args), question.ask(all, args)];
    (signs[0] != signs[1]).then(|| violation(Law::LaterVertices, question, args, signs))
}

/// Asks both sessions several queries, each session in one batch: [`independence_of_later_vertices`] of each.
pub fn independence_of_later_vertices_of_all<P: Predicates + ?Sized, Q: Predicates + ?Sized>(
    fewer: &P,
    all: &Q,
    question: Question,
    queries: &[&[Vertex]],
) -> Vec<Option<Violation>> {
    let flat = queries.concat();
    let mut signs = [vec![Sign::Zero; queries.len()], vec![Sign::Zero; queries.len()]];
    question.ask_batch(fewer, &flat, &mut signs[0]);
    question.ask_batch(all, &flat, &mut signs[1]);
    let [of_fewer, of_all] = signs;
    let signs = of_fewer.into_iter().zip(of_all).map(<[Sign; 2]>::from);
    let look = |(args, signs): (&&[Vertex], [Sign; 2])| {
        (signs[0] != signs[1]).then(|| violation(Law::LaterVertices, question, args, signs))
    };
    queries.iter().zip(signs).map(look).collect()
}

fn violation(law: Law, question: Question, args: &[Vertex], signs: [Sign; 2]) -> Violation {
    Violation { law, answers: signs.map(|sign| Answer { question, args: args.to_vec(), sign }).into() }
}
