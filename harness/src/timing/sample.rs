//! Chooses a sample of scenes that takes about a given time: one scene per family, from each task in turn.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::path::PathBuf;
use std::time::Duration;

use predicament_records::Costs;

use crate::exit::Failure;
use crate::select::Planned;

/// The typical number of samples of a scene until a backend's median is known.
const SAMPLES: u64 = 6;
/// The typical number of interfaces of a backend: single queries and batches.
const INTERFACES: u64 = 2;

/// A limit on the time of a bench.
pub struct Limit<'r> {
    /// The approximate time of the bench.
    pub time: Duration,
    /// The run that has judged the scenes, which knows their costs.
    pub run: &'r PathBuf,
    /// The names of the backends.
    pub backends: &'r [String],
    /// The minimum time of a sample, in milliseconds.
    pub sample_ms: u64,
}

/// The scenes of a sample, in the given order, and a line that says what was left out.
pub fn sample(mut scenes: Vec<Planned>, limit: &Limit<'_>) -> Result<(Vec<Planned>, String), Failure> {
    let costs = Costs::read(std::slice::from_ref(limit.run)).map_err(Failure::usage)?;
    let least = limit.backends.len() as u64 * INTERFACES * SAMPLES * limit.sample_ms * 1000;
    // A bench asks for each answer more often than a run, in several ways.
    let cost = |planned: &Planned| 2 * costs.of(&planned.plan, limit.backends).0.unwrap_or(0).max(least);
    // For each task: the cheapest scene of each family, cheapest families first.
    let mut tasks: BTreeMap<&str, BTreeMap<&str, (u64, usize)>> = BTreeMap::new();
    for (at, planned) in scenes.iter().enumerate() {
        let families = tasks.entry(&planned.plan.task).or_default();
        let one = families.entry(&planned.plan.family).or_insert((u64::MAX, at));
        *one = (*one).min((cost(planned), at));
    }
    let all: usize = tasks.values().map(BTreeMap::len).sum();
    let mut queues: VecDeque<VecDeque<(u64, usize)>> = tasks
        .into_values()
        .map(|families| {
            let mut families: Vec<(u64, usize)> = families.into_values().collect();
            families.sort_unstable();
            families.into()
        })
        .collect();
    let most = u64::try_from(limit.time.as_micros()).unwrap_or(u64::MAX);
    let (mut spent, mut chosen) = (0_u64, BTreeSet::new());
    while let Some(mut queue) = queues.pop_front() {
        let Some((cost, at)) = queue.pop_front() else { continue };
        if !chosen.is_empty() && spent.saturating_add(cost) > most {
            // The remaining families of this task cost as much or more.
            continue;
        }
        spent += cost;
        chosen.insert(at);
        queues.push_back(queue);
    }
    let (families, of) = (chosen.len(), scenes.len());
    let mut at = 0..;
    scenes.retain(|_| at.next().is_some_and(|at| chosen.contains(&at)));
    let line = format!(
        "a sample: one scene of each of {families} of {all} families ({families} of {of} scenes), for about {} s; without --seconds \
         all are timed",
        limit.time.as_secs()
    );
    Ok((scenes, line))
}
