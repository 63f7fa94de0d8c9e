//! The law of place: an answer depends on its vertices, not on its place in a batch or on other vertices.
//!
//! Batches use other code than single calls: four queries at a time with a remainder at the end. A perturbation that
//! depends on the number of vertices is not one perturbation. Neither may change an answer.

use predicament_predicates::{Predicates, QuerySet, Question, Sign, Vertex};

use super::{Answer, Law, Violation};

/// Checks that each query has the same answer alone and in batches, at other places and beside other queries: in order,
/// without the first query, and backwards. Turns are also tested beside one line, with the last vertices of all
/// queries; sides beside one plane.
///
/// The violation has the query twice, with the answer of the single call first.
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

/// Checks the first query's line or plane with many points.
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

/// Checks that a session of a scene's first vertices answers as the session of the whole scene. Later vertices must not
/// change an answer: a scene grows at its end.
///
/// (Tolerances depend on the extent of the scene, so a session whose zero is a band does not promise this.) The
/// violation has the query twice, with the answer of the session of fewer vertices first.
pub fn independence_of_later_vertices<P: Predicates + ?Sized, Q: Predicates + ?Sized>(
    fewer: &P,
    all: &Q,
    question: Question,
    args: &[Vertex],
) -> Option<Violation> {
    let signs = [question.ask(fewer, args), question.ask(all, args)];
    (signs[0] != signs[1]).then(|| violation(Law::LaterVertices, question, args, signs))
}

/// Checks [`independence_of_later_vertices`] of several queries, with one batch per session.
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
