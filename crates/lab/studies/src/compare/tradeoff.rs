//! Errors against time, as data of a plot: a point for each backend, and a curve for backends that differ in one
//! parameter.

use super::Measure;
use super::standing::{InputKey, REFERENCE, Ratio, Share, Standing, backends, inputs_of, key, ratio};
use crate::{Error, File};
use predicament_report::{Point, tradeoff};

/// The time and the errors of a backend.
#[derive(Clone, PartialEq, Debug)]
pub struct Tradeoff<'m> {
    /// The backend's name, with its parameters.
    pub backend: &'m str,
    /// The ratio of its time to the reference's; `None` without a pair.
    pub time: Option<Ratio>,
    /// The share of wrong answers, of its answers to single queries.
    pub answers: Share,
    /// The share of scenes with a broken law, of the scenes that it answered in tasks with laws.
    pub scenes: Share,
    /// The share of scenes that it has not done, of the scenes that it was asked.
    pub not_done: Share,
    /// The parameter of its curve; `None` for a single point.
    pub knob: Option<&'m str>,
}

/// The parameters of our backends that make curves: the common prefixes of backend names that differ in nothing else.
/// Those of engines end with `=`.
const KNOBS: [&str; 2] = ["epsilon:", "exact:stages="];

/// The parameter in a backend's name, if it is one that makes curves.
pub(super) fn knob_of(backend: &str) -> Option<&str> {
    let parameter = backend.starts_with("engine:").then(|| backend.rfind('=')).flatten();
    let known = KNOBS.into_iter().find(|knob| backend.starts_with(knob)).map(str::len);
    Some(&backend[..parameter.map(|at| at + 1).or(known)?])
}

/// The inputs on which all of these backends, and the reference, answered a scene and have a time.
fn common<'m>(measures: &'m [Measure], members: &[&str]) -> Vec<InputKey<'m>> {
    let has = |input: &InputKey<'_>, backend: &str, measure: &str, is: &dyn Fn(&Measure) -> bool| {
        measures.iter().any(|row| row.backend == backend && row.measure == measure && key(row) == *input && is(row))
    };
    let is_timed = |input: &InputKey<'_>, backend: &str| has(input, backend, "time", &|_| true);
    let is_answered = |input: &InputKey<'_>, backend: &str| has(input, backend, "not done", &|row| row.value < 1.0);
    let is_common = |input: &InputKey<'_>| {
        let all = members.iter().all(|backend| is_timed(input, backend) && is_answered(input, backend));
        all && is_timed(input, REFERENCE)
    };
    inputs_of(measures).into_iter().map(|(input, _)| input).filter(is_common).collect()
}

/// The points of all backends, in order of appearance.
///
/// The members of a curve are compared over the inputs that all of them answered.
#[must_use]
pub fn tradeoffs(measures: &[Measure]) -> Vec<Tradeoff<'_>> {
    let all = backends(measures);
    let members = |knob: &str| -> Vec<&str> { all.iter().copied().filter(|name| name.starts_with(knob)).collect() };
    let of = |&backend| {
        // A parameter with only one value makes no curve.
        let knob = knob_of(backend).filter(|knob| members(knob).len() > 1);
        let common = knob.map(|knob| common(measures, &members(knob)));
        let standing = match &common {
            Some(common) => Standing::of(measures, backend, |input| common.contains(input)),
            None => Standing::of(measures, backend, |_| true),
        };
        let time = match &common {
            Some(common) => ratio(measures, backend, common),
            None => standing.time,
        };
        let not_done = Share { count: standing.scenes.not_done, of: standing.scenes.asked };
        Tradeoff { backend, time, answers: standing.answers, scenes: standing.laws, not_done, knob }
    };
    all.iter().map(of).collect()
}

/// A plot: its name, its title, the unit and scale of its vertical axis, and its value.
type Panel = (&'static str, &'static str, &'static str, f64, fn(&Tradeoff<'_>) -> Share);

/// Two plots of errors over time: of answers, and of whole scenes.
pub(super) fn plots(measures: &[Measure]) -> Result<Vec<File>, Error> {
    let all = tradeoffs(measures);
    let panels: [Panel; 2] = [
        ("answers", "Single answers", "wrong answers in 10^6", 1e6, |of| of.answers),
        ("scenes", "Whole scenes", "scenes in 1000 with a broken law", 1e3, |of| of.scenes),
    ];
    let mut files = Vec::new();
    for (name, title, y, per, get) in panels {
        let point = |of: &Tradeoff<'_>| Point {
            backend: of.backend.to_owned(),
            time: of.time.map(|time| time.value),
            errors: [get(of).count, get(of).of],
            not_done: [of.not_done.count, of.not_done.of],
            is_marked: name == "answers" && of.scenes.count > 0,
            curve: of.knob.map(|knob| knob.trim_end_matches([':', '=']).to_owned()),
            before: None,
        };
        let points = all.iter().map(point).collect();
        let x = format!("time / {REFERENCE}");
        let plot = predicament_report::Tradeoff { title: title.into(), x, y: y.into(), per, points };
        files.extend(File::plot(format!("error-time-{name}"), tradeoff(&plot).map_err(Error::format)?));
    }
    Ok(files)
}
