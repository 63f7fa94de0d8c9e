//! The second truth: answers compared with the numbers that were written, beside the comparison with their doubles.
//!
//! A backend gets doubles and promises something about doubles. Its user may mean the decimals that were typed. Both
//! comparisons are of the same answers; the classes of a run are about the doubles alone.

use predicament_corpus::LoadedScene;

use crate::{Asked, Budget, Case, Class, Outcome, Stop, Task, Watch};

/// The number of answers that agree with each truth.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Agreement {
    /// The number of compared answers; 1 for a task that is judged as a whole.
    pub answers: u64,
    /// Answers that are right about the doubles.
    pub doubles: u64,
    /// Answers that are right about what was written.
    pub written: u64,
    /// Answers that are zero as written: ties of signs. Other tasks have none.
    pub ties: u64,
    /// Ties as written that were answered by zero.
    pub ties_found: u64,
}

/// The scene as it was written, with the truth about it; `None` if the suite does not ask for it.
///
/// For signs the scene is the given one, with other truths; for other tasks it is the scene times a power of ten.
pub(crate) fn as_written<'a, T: Task>(
    task: &T,
    loaded: &'a LoadedScene,
    watch: &Watch,
) -> Result<Option<Case<'a, T>>, Stop> {
    let Some(written) = &loaded.written else { return Ok(None) };
    let loaded = loaded.similar.as_deref().unwrap_or(loaded);
    let content: &T::Content = loaded.content().expect("the content of a scene of this task");
    let truth = task.truth_as_written(&loaded.scene, content, written, watch)?;
    Ok(Some(Case::new(loaded, content, truth)))
}

/// The comparison of [`Task::agreement`] for tasks without signs: the judge's texts of single answers, or its verdict
/// on the whole.
pub(crate) fn by_judge<T: Task>(
    task: &T,
    case: &Case<'_, T>,
    asked: &Asked<'_>,
    answer: &T::Answer,
    own: &Outcome,
) -> Result<Agreement, Stop> {
    let mut outcome = Outcome::default();
    let budget = Budget { answers: true, findings_per_class: 0, ..asked.budget };
    task.judge(case, &Asked { budget, ..*asked }, answer, &mut outcome)?;
    Ok(if outcome.answers.is_empty() {
        Agreement::of_wholes(own, &outcome)
    } else {
        let written = outcome.answers.iter().filter(|line| line.answer == line.exact).count() as u64;
        let (answers, doubles) = (outcome.answers.len() as u64, own.counts.get(Class::Agree));
        Agreement { answers, doubles, written, ..Agreement::default() }
    })
}

impl Agreement {
    /// The agreement of a whole answer, from its outcomes about the doubles and about the decimals.
    ///
    /// Coordinates that are off by rounding are right.
    #[must_use]
    pub fn of_wholes(own: &Outcome, written: &Outcome) -> Agreement {
        let right = |outcome: &Outcome| u64::from(outcome.counts.findings() == outcome.counts.get(Class::Rounded));
        Agreement { answers: 1, doubles: right(own), written: right(written), ..Agreement::default() }
    }
}

impl std::fmt::Display for Agreement {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Agreement { answers, doubles, written, .. } = self;
        write!(f, "right about the doubles: {doubles} of {answers}; about the decimals: {written} of {answers}")
    }
}
