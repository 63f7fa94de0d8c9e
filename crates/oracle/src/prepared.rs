//! What every run of a backend begins and ends with.

use predicament_predicates::{Backend, Counts, Declined, PredicateKind, Predicates, Scene, Tally};

use crate::{Class, Outcome};

/// A session for the scene, if the backend takes it and answers what will be asked.
pub(crate) fn session<'s, B: Backend, T: Tally + 's>(
    backend: &'s B,
    scene: &'s Scene,
    tally: T,
    supports: impl FnOnce(&B::Session<'s, T>) -> Result<(), Declined>,
) -> Result<B::Session<'s, T>, Refusal> {
    let session = backend.prepare(scene, tally).map_err(|why| Refusal { check: "prepare", why })?;
    supports(&session).map_err(|why| Refusal { check: "supports", why })?;
    Ok(session)
}

/// [`session`] for these predicates.
pub(crate) fn asking<'s, B: Backend, T: Tally + 's>(
    backend: &'s B,
    scene: &'s Scene,
    tally: T,
    kinds: &[PredicateKind],
) -> Result<B::Session<'s, T>, Refusal> {
    session(backend, scene, tally, |session| kinds.iter().try_for_each(|&kind| session.supports(kind)))
}

/// A backend that says it can't.
pub(crate) struct Refusal {
    check: &'static str,
    why: Declined,
}

impl Refusal {
    /// The outcome of a scene of so many queries.
    pub(crate) fn outcome(self, queries: u64) -> Outcome {
        Outcome::of_scene(queries, Class::Declined, self.check, self.why.to_string())
    }
}

impl From<Refusal> for String {
    fn from(refusal: Refusal) -> String {
        refusal.why.to_string()
    }
}

/// How many queries of these kinds each stage has settled, without those that settled none.
pub(crate) fn stages<B: Backend>(backend: &B, counts: &Counts, kinds: &[PredicateKind]) -> Vec<(&'static str, u64)> {
    let settled = |stage| kinds.iter().map(|&kind| counts.get(kind, stage)).sum();
    let stages = backend.stages().iter().enumerate().map(|(stage, &name)| (name, settled(stage)));
    stages.filter(|&(_, settled)| settled > 0).collect()
}
