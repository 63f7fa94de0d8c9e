//! The loop of a survey: step by step, reported to the host.

use crate::{Error, Host};

/// The rows of all steps in their order. `name` is the text that the host shows during a step.
///
/// # Errors
/// The first error of `rows`, or [`Error::Stopped`] if the host's watch says so after a step.
pub(crate) fn surveyed<S, R: IntoIterator>(
    host: &dyn Host,
    unit: &str,
    steps: Vec<S>,
    name: impl Fn(&S) -> String,
    mut rows: impl FnMut(S) -> Result<R, Error>,
) -> Result<Vec<R::Item>, Error> {
    host.begin(steps.len() as u64, unit);
    let mut all = Vec::new();
    for step in steps {
        host.turn_to(&name(&step));
        all.extend(rows(step)?);
        host.watch().done(1)?;
    }
    Ok(all)
}
