//! The class of every single answer, for pictures; judging a scene only counts classes and keeps a few findings.

use predicament_laws::published;
use predicament_predicates::{Scene, Sign};
use rayon::prelude::*;

use super::class::{Given, class};
use super::{SignQueries, Signs};
use crate::{AnswerError, Class, Contestant, Refusal};

/// The answers of a backend to all queries, in order, each with its class under the backend's promise.
///
/// These are the classes with which judging starts: a broken tie is legal here, on either side, and answers are not
/// compared with each other.
///
/// # Errors
/// [`AnswerError`] if the backend declines.
pub fn classes(
    backend: &dyn Contestant,
    scene: &Scene,
    content: &SignQueries,
    truth: &[Sign],
) -> Result<Vec<(Sign, Class)>, AnswerError> {
    let queries = &content.queries;
    let answers = backend.answer(&Signs::of(queries.kind()), scene, content)?.0;
    let contract = backend.contract(queries.kind());
    let mut classes = Vec::new();
    let asked = backend.with_session(scene, &mut |session| {
        let band = published::band(&*session, queries.question());
        let given = Given {
            scene,
            queries,
            truth,
            answers: &answers,
            session: &*session,
            contract,
            band,
            unstable: Vec::new(),
        };
        let of = |query| (given.answers[query], class(&given, backend.tie_judge(), query));
        classes = (0..queries.len()).into_par_iter().map(of).collect();
    });
    asked.map_err(|why| AnswerError::Refused(Refusal { check: "prepare", why }))?;
    Ok(classes)
}
