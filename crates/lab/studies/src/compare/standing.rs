//! The results of one backend: its answers over its own inputs, its times over pairs with the reference.
//!
//! * Answers have the backend's own denominator: the scenes that it was asked, the scenes and the queries that it
//!   answered.
//! * A ratio of times is the geometric mean over the inputs that both the backend and [`REFERENCE`] answered.
//! * Ratios leave out inputs whose time barely depends on predicates: see [`BARELY`].
//!
//! No third backend changes any of these numbers.

use predicament_records::{approximately, geometric_mean, wilson};

use super::Measure;

/// The reference backend for times.
pub const REFERENCE: &str = "exact";

/// The measure of an input: the reference's slowdown if it computes each answer twice.
pub const ASKED_TWICE: &str = "asked twice";

/// The reference with every query computed twice, as a backend.
pub(super) const TWICE: &str = "exact:twice";

/// The slowdown below which an input barely depends on predicates.
///
/// It is the ratio of the reference's times with each answer computed twice and once.
pub const BARELY: f64 = 1.1;

/// An input: task, kind, family.
pub type InputKey<'m> = [&'m str; 3];

/// A share as a count and a whole.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Share {
    /// The count.
    pub count: u64,
    /// The whole.
    pub of: u64,
}

impl Share {
    /// The count over the whole; `None` if the whole is zero.
    #[must_use]
    pub fn value(self) -> Option<f64> {
        (self.of > 0).then(|| approximately(self.count) / approximately(self.of))
    }

    /// Wilson's interval at 95 %.
    #[must_use]
    pub fn interval(self) -> [f64; 2] {
        wilson(self.count, self.of)
    }

    pub(super) fn add(&mut self, other: Share) {
        self.count += other.count;
        self.of += other.of;
    }

    /// The count and the whole behind a row.
    pub(crate) fn of_row(row: &Measure) -> Share {
        let per = if row.unit.contains("1000") {
            1e3
        } else if row.unit.contains("10^6") {
            1e6
        } else {
            1.0
        };
        let count = (row.value / per * approximately(row.of)).round();
        // A count, which is at most `of`, after rounding.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let count = (count as u64).min(row.of);
        Share { count, of: row.of }
    }
}

/// A mean of ratios of times to the reference's.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Ratio {
    /// The geometric mean.
    pub value: f64,
    /// The least and the largest ratio of an input.
    pub range: [f64; 2],
    /// The number of inputs behind it: both answered, and the time depends on predicates.
    pub pairs: usize,
    /// The number of inputs that both answered and that are left out, because their time barely depends on predicates.
    pub left_out: usize,
    /// The number of inputs that the backend was asked.
    pub of: usize,
}

/// The scenes that a backend was asked, each in the class of its worst answer.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Scenes {
    /// The number of scenes asked: the sum of the others.
    pub asked: u64,
    /// The number of scenes with nothing wrong or undecided.
    pub right: u64,
    /// The number of scenes with a zero within a band, and nothing wrong.
    pub undecided: u64,
    /// The number of scenes where a check failed only by the rounding of output coordinates.
    pub rounded: u64,
    /// The number of scenes with a wrong answer, or a broken law.
    pub wrong: u64,
    /// The number of scenes declined, broken off, or out of time.
    pub not_done: u64,
}

/// The results of a backend on some inputs.
#[derive(Clone, PartialEq, Debug)]
pub struct Standing<'m> {
    /// The backend's name, with its parameters.
    pub backend: &'m str,
    /// The number of inputs with an answered scene, and of inputs asked.
    pub inputs: [usize; 2],
    /// The backend's scenes by class.
    pub scenes: Scenes,
    /// The share of scenes with a broken law, of the scenes that it answered in tasks with laws.
    pub laws: Share,
    /// The share of wrong answers, of its answers to single queries.
    pub answers: Share,
    /// The share of zeros within its band, of its answers to single queries.
    pub in_band: Share,
    /// The ratio of its time to the reference's; `None` without a pair.
    pub time: Option<Ratio>,
}

impl<'m> Standing<'m> {
    /// The results of a backend on the inputs that `keep` accepts.
    pub fn of(measures: &'m [Measure], backend: &'m str, keep: impl Fn(&InputKey<'m>) -> bool) -> Standing<'m> {
        let own = measures.iter().filter(|row| row.backend == backend && is_input(row) && keep(&key(row)));
        let (mut scenes, mut laws, mut answers, mut in_band) =
            (Scenes::default(), Share::default(), Share::default(), Share::default());
        let (mut asked, mut answered) = (Vec::new(), 0);
        for row in own {
            let share = Share::of_row(row);
            match row.measure.as_str() {
                "not done" => {
                    asked.push(key(row));
                    answered += usize::from(share.count < share.of);
                    scenes.asked += share.of;
                    scenes.not_done += share.count;
                }
                "right" => scenes.right += share.count,
                "undecided" => scenes.undecided += share.count,
                "rounded" => scenes.rounded += share.count,
                "wrong scenes" => scenes.wrong += share.count,
                "topology" => laws.add(share),
                "wrong answers" => answers.add(share),
                "in_band" => in_band.count += share.count,
                _ => {}
            }
        }
        // Without a row there is no such answer.
        in_band.of = answers.of;
        let time = ratio(measures, backend, &asked);
        Standing { backend, inputs: [answered, asked.len()], scenes, laws, answers, in_band, time }
    }
}

/// All backends over all of their inputs, in order of appearance.
#[must_use]
pub fn standings(measures: &[Measure]) -> Vec<Standing<'_>> {
    backends(measures).into_iter().map(|backend| Standing::of(measures, backend, |_| true)).collect()
}

/// The backends of some rows, in order of appearance.
#[must_use]
pub fn backends(measures: &[Measure]) -> Vec<&str> {
    let mut all: Vec<&str> = Vec::new();
    for row in measures.iter().filter(|row| is_input(row)) {
        if !all.contains(&row.backend.as_str()) {
            all.push(&row.backend);
        }
    }
    all
}

/// The inputs of some rows, in order of appearance, each with its number of distinct scenes.
#[must_use]
pub fn inputs_of(measures: &[Measure]) -> Vec<(InputKey<'_>, u64)> {
    let mut all: Vec<(InputKey<'_>, u64)> = Vec::new();
    for row in measures.iter().filter(|row| is_input(row) && row.measure == "not done") {
        if all.iter().all(|(known, _)| *known != key(row)) {
            all.push((key(row), row.of));
        }
    }
    all
}

/// The inputs that ratios of times leave out, each with the reference's slowdown if it computes each answer twice.
#[must_use]
pub fn left_out(measures: &[Measure]) -> Vec<(InputKey<'_>, f64)> {
    let rows = measures.iter().filter(|row| row.measure == ASKED_TWICE && row.value < BARELY);
    rows.map(|row| (key(row), row.value)).collect()
}

/// The ratio of a backend's time on an input to the reference's; `None` if one of them has no time.
#[must_use]
pub fn time_ratio(measures: &[Measure], backend: &str, input: &InputKey<'_>) -> Option<f64> {
    measure_ratio(measures, backend, input, "time")
}

/// The ratio of the times for each constructed point, to the reference's; `None` if one of them constructs nothing.
pub(super) fn point_ratio(measures: &[Measure], backend: &str, input: &InputKey<'_>) -> Option<f64> {
    Some(time_ratio(measures, backend, input)? / measure_ratio(measures, backend, input, "constructed")?)
}

fn measure_ratio(measures: &[Measure], backend: &str, input: &InputKey<'_>, measure: &str) -> Option<f64> {
    let value = |backend: &str| {
        let is = |row: &&Measure| row.backend == backend && row.measure == measure && key(row) == *input;
        measures.iter().find(is).map(|row| row.value)
    };
    Some(value(backend)? / value(REFERENCE)?)
}

/// The mean ratio of a backend over the given inputs that both answered.
pub(super) fn ratio(measures: &[Measure], backend: &str, inputs: &[InputKey<'_>]) -> Option<Ratio> {
    let barely = left_out(measures);
    let is_left_out = |input: &InputKey<'_>| barely.iter().any(|(other, _)| other == input);
    let pairs = inputs.iter().filter_map(|input| Some((input, time_ratio(measures, backend, input)?)));
    let (out, pairs): (Vec<_>, Vec<_>) = pairs.partition(|(input, _)| is_left_out(input));
    let ratios = || pairs.iter().map(|(_, ratio)| *ratio);
    let range = [ratios().fold(f64::INFINITY, f64::min), ratios().fold(0.0, f64::max)];
    let value = geometric_mean(ratios())?;
    Some(Ratio { value, range, pairs: pairs.len(), left_out: out.len(), of: inputs.len() })
}

/// The input of a row.
pub(super) fn key(row: &Measure) -> InputKey<'_> {
    [&row.task, &row.kind, &row.family]
}

/// Returns true if a row is about scenes of a task, and not about sizes of features.
fn is_input(row: &Measure) -> bool {
    row.task != super::measure::FEATURES
}
