//! Values of a parameter side by side, and whether one of them can be a default.
//!
//! A value is right on an input if the backend answers each scene there, and none wrongly. A default is a value that is
//! right on every input. There is none if two inputs have no right value in common.

use std::collections::{BTreeMap, BTreeSet};

use predicament_records::geometric_mean;
use predicament_report::{Cell, Point, Table, Tradeoff, tradeoff};

use super::standing::{InputKey, Share, backends, inputs_of, key};
use super::tradeoff::knob_of;
use super::{Measure, ranking, words};
use crate::{Error, File};

/// A parameter of a backend, with the values that were compared.
#[derive(Clone, PartialEq, Debug)]
pub struct Sweep<'m> {
    /// The backend's name up to the value.
    pub knob: &'m str,
    /// The values in order of appearance.
    pub values: Vec<Value<'m>>,
    /// The number of inputs.
    pub inputs: usize,
    /// Whether a value can be the default.
    pub verdict: Verdict<'m>,
}

/// The results of one value of a parameter.
#[derive(Clone, PartialEq, Debug)]
pub struct Value<'m> {
    /// The backend's name, with the value.
    pub backend: &'m str,
    /// The inputs on which it is right.
    pub right: BTreeSet<InputKey<'m>>,
    /// The scenes with a wrong answer or a broken law, of those that it answered.
    pub wrong: Share,
    /// The scenes that it has not done, of those that it was asked.
    pub not_done: Share,
    /// The time over that of the fastest value, the geometric mean of the inputs that all values have a time for.
    pub time: Option<f64>,
}

/// Whether a value can be the default.
#[derive(Clone, PartialEq, Debug)]
pub enum Verdict<'m> {
    /// The fastest of the values that are right on every input; without times the first of them.
    Default(&'m str),
    /// An input on which no value is right.
    NoValue(InputKey<'m>),
    /// Two inputs without a common right value.
    Disjoint([InputKey<'m>; 2]),
    /// No value is right on every input, but any two inputs have one in common.
    Mixed,
}

/// The parameters with at least two values.
#[must_use]
pub fn sweeps(measures: &[Measure]) -> Vec<Sweep<'_>> {
    let mut members: Vec<(&str, Vec<&str>)> = Vec::new();
    for backend in backends(measures) {
        let Some(knob) = knob_of(backend) else { continue };
        match members.iter_mut().find(|(known, _)| *known == knob) {
            Some((_, all)) => all.push(backend),
            None => members.push((knob, vec![backend])),
        }
    }
    members.retain(|(_, all)| all.len() > 1);
    members.into_iter().map(|(knob, all)| sweep(measures, knob, &all)).collect()
}

fn sweep<'m>(measures: &'m [Measure], knob: &'m str, members: &[&'m str]) -> Sweep<'m> {
    let inputs: Vec<InputKey<'m>> = inputs_of(measures).into_iter().map(|(input, _)| input).collect();
    let times: BTreeMap<(&str, InputKey<'m>), f64> =
        measures.iter().filter(|row| row.measure == "time").map(|row| ((&*row.backend, key(row)), row.value)).collect();
    let is_timed = |input: &&InputKey<'m>| members.iter().all(|member| times.contains_key(&(member, **input)));
    let timed: Vec<InputKey<'m>> = inputs.iter().filter(is_timed).copied().collect();
    let mean = |member: &str| geometric_mean(timed.iter().map(|input| times[&(member, *input)]));
    let fastest = members.iter().filter_map(|member| mean(member)).reduce(f64::min);
    let value = |&backend: &&'m str| {
        let mut value = Value {
            backend,
            right: BTreeSet::new(),
            wrong: Share::default(),
            not_done: Share::default(),
            time: mean(backend).zip(fastest).map(|(own, fastest)| own / fastest),
        };
        let (mut asked, mut failed) = (BTreeSet::new(), BTreeSet::new());
        for row in measures.iter().filter(|row| row.backend == backend) {
            let sum = match row.measure.as_str() {
                "not done" => &mut value.not_done,
                "wrong scenes" => &mut value.wrong,
                _ => continue,
            };
            let share = Share::of_row(row);
            sum.add(share);
            asked.insert(key(row));
            if share.count > 0 {
                failed.insert(key(row));
            }
        }
        value.right = asked.difference(&failed).copied().collect();
        value
    };
    let values: Vec<Value<'m>> = members.iter().map(value).collect();
    let verdict = verdict(&inputs, &values);
    Sweep { knob, values, inputs: inputs.len(), verdict }
}

fn verdict<'m>(inputs: &[InputKey<'m>], values: &[Value<'m>]) -> Verdict<'m> {
    let everywhere = values.iter().filter(|value| value.right.len() == inputs.len());
    let time = |value: &&Value<'_>| value.time.unwrap_or(f64::INFINITY);
    // `min_by` returns the first of equal times.
    if let Some(value) = everywhere.min_by(|a, b| time(a).total_cmp(&time(b))) {
        return Verdict::Default(value.backend);
    }
    let right_on = |input: InputKey<'m>| values.iter().filter(move |value| value.right.contains(&input));
    if let Some(none) = inputs.iter().find(|input| right_on(**input).count() == 0) {
        return Verdict::NoValue(*none);
    }
    let pairs = inputs.iter().enumerate().flat_map(|(at, a)| inputs[at + 1..].iter().map(move |b| [*a, *b]));
    let is_disjoint = |[a, b]: &[InputKey<'m>; 2]| right_on(*a).all(|value| !value.right.contains(b));
    pairs.into_iter().find(is_disjoint).map_or(Verdict::Mixed, Verdict::Disjoint)
}

impl Sweep<'_> {
    fn said(&self) -> String {
        let inputs = self.inputs;
        let named = |[task, kind, family]: &InputKey<'_>| format!("{task}, {kind}, {family}");
        match &self.verdict {
            Verdict::Default(backend) => {
                let count = self.values.iter().filter(|value| value.right.len() == inputs).count();
                let is_timed = self.values.iter().any(|value| value.time.is_some());
                let which = if is_timed { "fastest" } else { "first" };
                format!(
                    "`{backend}` can be the default: {count} of {} values are right on all {inputs} inputs, and it is \
                     the {which} of them.",
                    self.values.len()
                )
            }
            Verdict::NoValue(input) => format!("There is no default: no value is right on the input {}.", named(input)),
            Verdict::Disjoint([a, b]) => {
                format!("There is no default: no value is right on both inputs ({}) and ({}).", named(a), named(b))
            }
            Verdict::Mixed => format!("There is no default: no value is right on all {inputs} inputs."),
        }
    }
}

/// A table and a sentence for each parameter; empty without one.
pub(crate) fn page(measures: &[Measure]) -> String {
    let mut page = String::new();
    for sweep in sweeps(measures) {
        let mut table =
            Table::new("").words(["value"]).numbers(["right inputs", "wrong scenes", "not done", "time / fastest"]);
        for value in &sweep.values {
            table.push(vec![
                Cell::code(value.backend),
                Cell::from(format!("{} of {}", value.right.len(), sweep.inputs)),
                Cell::from(words::counted(value.wrong)).detail(words::percents(value.wrong)),
                Cell::from(words::counted(value.not_done)),
                Cell::from(value.time.map_or("–".to_owned(), words::times)),
            ]);
        }
        page += &format!("\n{}\n\n{}\n", ranking::markdown(table), sweep.said());
    }
    if page.is_empty() {
        page
    } else {
        format!(
            "\n## Values of parameters\n\nA value is right on an input if it answers each scene there, and none wrongly. A default is right on every input.\n{page}"
        )
    }
}

/// A plot of wrong scenes over time, with a curve for each parameter; empty without one.
pub(crate) fn plot(name: &str, measures: &[Measure]) -> Result<Vec<File>, Error> {
    let sweeps = sweeps(measures);
    if sweeps.is_empty() {
        return Ok(Vec::new());
    }
    let point = |sweep: &Sweep<'_>, value: &Value<'_>| Point {
        backend: value.backend.to_owned(),
        time: value.time,
        errors: [value.wrong.count, value.wrong.of],
        not_done: [value.not_done.count, value.not_done.of],
        is_marked: false,
        curve: Some(sweep.knob.trim_end_matches([':', '=']).to_owned()),
        before: None,
    };
    let points = sweeps.iter().flat_map(|sweep| sweep.values.iter().map(|value| point(sweep, value))).collect();
    let [title, x, y] = ["Values of parameters", "time / fastest value", "wrong scenes in 1000"].map(str::to_owned);
    let plot = Tradeoff { title, x, y, per: 1e3, points };
    Ok(File::plot(name, tradeoff(&plot).map_err(Error::format)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::measure::About;

    /// Measures of backends `b:e=0`, `b:e=1`, …: a row for each input, `true` where a value is right.
    fn measures(rows: &[&[bool]]) -> Vec<Measure> {
        let mut all = Vec::new();
        for (input, values) in rows.iter().enumerate() {
            for (value, is_right) in (0_u8..).zip(*values) {
                let (family, backend) = (input.to_string(), format!("engine:b:e={value}"));
                let about = About { task: "overlay2d", kind: "near", family: &family, backend: &backend };
                all.push(about.share("not done", "of scenes asked", 1.0, 0, 4));
                all.push(about.share("wrong scenes", "per 1000 scenes answered", 1e3, u64::from(!is_right), 4));
                all.extend(about.median("time", "ns", &[10.0 - f64::from(value)]));
            }
        }
        all
    }

    fn verdict_of(rows: &[&[bool]]) -> String {
        format!("{:?}", sweeps(&measures(rows))[0].verdict)
    }

    #[test]
    fn the_fastest_value_that_is_right_everywhere_is_the_default() {
        assert_eq!(verdict_of(&[&[true, true, false], &[true, true, true]]), "Default(\"engine:b:e=1\")");
        let measures = measures(&[&[true, true, false], &[true, true, true]]);
        let sweep = &sweeps(&measures)[0];
        assert_eq!((sweep.inputs, sweep.knob, sweep.values.len()), (2, "engine:b:e=", 3));
        assert_eq!(
            (sweep.values[2].right.len(), sweep.values[2].wrong, sweep.values[2].time),
            (1, Share { count: 1, of: 8 }, Some(1.0))
        );
        assert!(page(&measures).contains("2 of 3 values are right on all 2 inputs"), "{}", page(&measures));
    }

    #[test]
    fn without_a_default_there_is_a_proof() {
        assert!(verdict_of(&[&[true, true], &[false, false]]).starts_with("NoValue([\"overlay2d\", \"near\", \"1\"])"));
        assert!(
            verdict_of(&[&[true, true], &[true, false], &[false, true]])
                .starts_with("Disjoint([[\"overlay2d\", \"near\", \"1\"]")
        );
        assert_eq!(verdict_of(&[&[true, true, false], &[true, false, true], &[false, true, true]]), "Mixed");
        assert!(sweeps(&measures(&[&[true]])).is_empty(), "one value is no sweep");
    }
}
