//! Variants and the whole in turns on one scene.

use std::time::Duration;

use predicament_corpus::LoadedScene;
use predicament_records::{Interface, Spread};
use predicament_tasks::{AnswerError, Contestant, Stopwatch, Watch, caught};

use super::Row;
use super::row::whole_of;
use crate::Error;
use crate::compare::Input;

/// The least duration of a sample: it repeats the pass until this time is over.
const LEAST: Duration = Duration::from_millis(2);

/// A backend on the scene, ready to be timed.
struct Ready<'a> {
    name: String,
    /// The stopwatch, or the class of the failure.
    stopwatch: Result<Box<dyn Stopwatch + 'a>, &'static str>,
    passes: u32,
    /// The nanoseconds of each sample.
    taken: Vec<f64>,
}

/// The rows of all variants on the scene of an input, by each interface.
///
/// `wholes` has the backends with all devices.
pub(super) fn rows(
    input: &Input,
    loaded: &LoadedScene,
    variants: &[&dyn Contestant],
    wholes: &[Box<dyn Contestant>],
    samples: u32,
    watch: &Watch<'_>,
) -> Result<Vec<Row>, Error> {
    let content = loaded.content.as_ref();
    let all = || wholes.iter().map(AsRef::as_ref).chain(variants.iter().copied());
    let interfaces = |backend: &dyn Contestant| {
        backend.solver(loaded.task).map_or_else(Vec::new, |solver| solver.interfaces(content))
    };
    let mut rows = Vec::new();
    for at in 0..all().map(|backend| interfaces(backend).len()).max().unwrap_or(0) {
        let mut ready: Vec<Ready<'_>> =
            all().map(|backend| Ready::new(backend, loaded, interfaces(backend).get(at).copied())).collect();
        for sample in 0..=samples {
            // Each sample begins with another backend, so that none always follows the same one.
            let count = ready.len();
            for turn in 0..count {
                ready[(turn + sample as usize) % count].sample(sample == 0);
            }
            watch.done(0)?;
        }
        let (whole, variants) = ready.split_at(wholes.len());
        // A batch may be a loop: the variant without batches has one.
        let by = interfaces(wholes[0].as_ref())[at];
        rows.extend(variants.iter().map(|variant| row(input, loaded, by, whole, variant)));
    }
    Ok(rows)
}

impl<'a> Ready<'a> {
    /// The backend after one pass, which finds out whether it answers.
    fn new(backend: &'a dyn Contestant, loaded: &'a LoadedScene, by: Option<Interface>) -> Ready<'a> {
        let solver = backend.solver(loaded.task).zip(by);
        let started = solver.map(|(solver, by)| {
            caught(|| {
                let mut stopwatch = solver.stopwatch(&loaded.scene, loaded.content.as_ref(), 1, by)?;
                stopwatch.as_mut().map(|stopwatch| stopwatch.pass());
                Ok::<_, AnswerError>(stopwatch)
            })
        });
        let stopwatch = match started {
            Some(Ok(Ok(Some(stopwatch)))) => Ok(stopwatch),
            Some(Err(broken)) => Err(broken.class.name()),
            _ => Err("declined"),
        };
        Ready { name: backend.name(), stopwatch, passes: 1, taken: Vec::new() }
    }

    /// Takes a sample; the first one determines the number of passes of all others.
    fn sample(&mut self, is_first: bool) {
        let Ok(stopwatch) = &mut self.stopwatch else { return };
        let elapsed = stopwatch.passes(self.passes);
        if is_first {
            let once = elapsed.max(Duration::from_nanos(1));
            self.passes = u32::try_from(LEAST.as_nanos() / once.as_nanos() + 1).unwrap_or(u32::MAX);
        } else {
            self.taken.push(elapsed.as_secs_f64() * 1e9 / f64::from(self.passes));
        }
    }

    fn digest(&self) -> Option<u64> {
        self.stopwatch.as_ref().ok().map(|stopwatch| stopwatch.digest())
    }
}

/// The row of a variant beside the whole of its backend.
fn row(input: &Input, loaded: &LoadedScene, by: Interface, wholes: &[Ready<'_>], variant: &Ready<'_>) -> Row {
    let name = whole_of(&variant.name);
    let whole = wholes.iter().find(|whole| whole.name == name);
    let answers = match (variant.stopwatch.as_ref(), whole.and_then(Ready::digest)) {
        (Err(class), _) => class,
        (Ok(_), None) => "declined",
        (Ok(stopwatch), Some(digest)) => {
            if stopwatch.digest() == digest {
                "equal"
            } else {
                "unequal"
            }
        }
    };
    let whole_taken = whole.map_or(&[][..], |whole| &whole.taken[..]);
    let mut ratios: Vec<f64> = variant.taken.iter().zip(whole_taken).map(|(variant, whole)| variant / whole).collect();
    ratios.sort_unstable_by(f64::total_cmp);
    let count = predicament_records::approximately(loaded.content.count().max(1) as u64);
    let median = |of: &[f64]| Spread::of(of.iter().copied()).map_or(f64::NAN, |spread| spread.median);
    // A quartile is the median of a half.
    let half = ratios.len().div_ceil(2);
    Row {
        task: input.task.name().to_owned(),
        kind: input.of.kind.name().to_owned(),
        family: input.of.family.to_owned(),
        interface: by.name().to_owned(),
        backend: variant.name.clone(),
        whole: name,
        answers: answers.to_owned(),
        whole_ns: median(whole_taken) / count,
        ratio: median(&ratios),
        low: median(&ratios[..half]),
        high: median(&ratios[ratios.len() - half..]),
        samples: ratios.len(),
    }
}
