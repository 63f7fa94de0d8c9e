//! Takes samples in turns until each median is known well enough.

use std::time::{Duration, Instant};

use predicament_oracle::caught;
use predicament_records::{PlannedScene, RunWriter, ThroughputRow};

use super::Runner;
use crate::exit::{self, Failure};
use crate::interrupt;

/// The options of sampling.
pub struct Samples {
    /// The maximum number of samples.
    pub most: u64,
    /// The minimum time of a sample.
    pub least: Duration,
    /// The required precision of the median, as a fraction of it.
    pub precision: f64,
}

/// The maximum ratio of the waiting time of a sample to its minimum time.
const PATIENCE: u128 = 10;

/// The remark about a backend whose answers are not always the same.
const CHANGED: &str = "answers changed while timed";

/// The number of samples before the first look at the confidence interval. The smallest and the largest of six samples
/// enclose the median with 97 %.
const FIRST_LOOK: usize = 6;

impl Samples {
    /// Times the runners in turns. Returns false if interrupted.
    pub fn take(
        &self,
        scene: &PlannedScene,
        runners: &mut Vec<Runner>,
        writer: &mut RunWriter,
        remarks: &mut Vec<String>,
    ) -> Result<bool, Failure> {
        // Passes to warm up, to size the samples, and to see that the answers are the judged ones.
        runners.retain_mut(|runner| {
            let warm = caught(|| {
                runner.watch.pass();
                let start = Instant::now();
                let pass = runner.watch.pass().max(Duration::from_nanos(1));
                (pass, start.elapsed().max(Duration::from_nanos(1)))
            });
            let (pass, wall) = match warm {
                Ok(warm) => warm,
                Err(broken) => {
                    remarks.push(format!("not timed: {}/{} on {}: {broken}", scene.suite, scene.scene, runner.name));
                    return false;
                }
            };
            // If a pass is timed by its own clock, that time can be much shorter than the waiting time.
            let passes =
                (self.least.as_nanos() / pass.as_nanos()).min(PATIENCE * self.least.as_nanos() / wall.as_nanos());
            runner.passes = u32::try_from(passes + 1).unwrap_or(u32::MAX);
            let same = runner.watch.digest() == runner.judged;
            if !same {
                remarks.push(format!(
                    "not timed: {}/{} on {}: the timed answers are not the judged ones",
                    scene.suite, scene.scene, runner.name
                ));
            }
            same
        });
        for sample in 0..self.most {
            let mut rows = Vec::with_capacity(runners.len());
            // Programs that crashed, or answered differently: the others are timed further.
            let mut broken = Vec::new();
            for (at, runner) in runners.iter_mut().enumerate().filter(|(_, runner)| !self.is_known(&runner.samples)) {
                if interrupt::flag().load(std::sync::atomic::Ordering::Relaxed) {
                    return Ok(false);
                }
                let total = match caught(|| runner.watch.passes(runner.passes)) {
                    Ok(_) if runner.is_program() && runner.watch.digest() != runner.judged => Err(CHANGED.to_owned()),
                    Ok(total) => Ok(total),
                    Err(why) => Err(why.to_string()),
                };
                let total = match total {
                    Ok(total) => total,
                    Err(why) => {
                        let (suite, scene, name) = (&scene.suite, &scene.scene, &runner.name);
                        remarks.push(format!("timed {sample} times only: {suite}/{scene} on {name}: {why}"));
                        broken.push(at);
                        continue;
                    }
                };
                // Counts of queries and passes are far below 2^53, so the conversion is exact.
                #[allow(clippy::cast_precision_loss)]
                let queries = runner.queries as f64 * f64::from(runner.passes);
                // A clock that has not moved shows that the time was less than its step.
                let ns_per_query = total.max(Duration::from_nanos(1)).as_secs_f64() * 1e9 / queries;
                runner.samples.push(ns_per_query);
                rows.push(ThroughputRow {
                    task: scene.task.clone(),
                    family: runner.family.clone(),
                    backend: runner.name.clone(),
                    interface: runner.interface,
                    engine_version: runner.version.clone(),
                    queries: runner.queries,
                    sample,
                    ns_per_query,
                });
            }
            writer.write(&rows).map_err(Failure::usage)?;
            for at in broken.into_iter().rev() {
                runners.remove(at);
            }
        }
        if let Some(runner) = runners.iter().find(|runner| runner.watch.digest() != runner.judged) {
            let message = format!("{}/{} on {}: {CHANGED}", scene.suite, scene.scene, runner.name);
            return Err(Failure { message, code: exit::UNEXPECTED });
        }
        Ok(true)
    }

    /// True if the median is known well enough.
    pub fn is_known(&self, samples: &[f64]) -> bool {
        interval(samples).is_some_and(|[low, high]| high - low <= self.precision * (low + high))
    }
}

/// A confidence interval of the median, of at least 95 %, between two order statistics. It needs no assumption about
/// the distribution. `None` for fewer than six samples.
fn interval(samples: &[f64]) -> Option<[f64; 2]> {
    let n = samples.len();
    if n < FIRST_LOOK {
        return None;
    }
    let mut sorted = samples.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    // The interval misses twice the share of outcomes of n fair coins with at most `below` heads.
    let mut below = 0;
    let (mut term, mut tail) = (0.5_f64.powi(i32::try_from(n).unwrap_or(i32::MAX)), 0.0);
    while below < n / 2 {
        tail += term;
        if 2.0 * tail > 0.05 {
            break;
        }
        below += 1;
        // Counts of samples are exact as doubles.
        #[allow(clippy::cast_precision_loss)]
        let next = (n - below + 1) as f64 / below as f64;
        term *= next;
    }
    let at = below.checked_sub(1)?;
    Some([sorted[at], sorted[n - 1 - at]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_is_that_of_the_binomial_distribution() {
        let samples = |n: u32| (1..=n).rev().map(f64::from).collect::<Vec<_>>();
        assert_eq!(interval(&samples(5)), None);
        // From tables of order statistics: 1 and 6 of 6 (96.9 %), 2 and 10 of 11 (98.8 %), 6 and 15 of 20 (95.9 %).
        assert_eq!(interval(&samples(6)), Some([1.0, 6.0]));
        assert_eq!(interval(&samples(11)), Some([2.0, 10.0]));
        assert_eq!(interval(&samples(20)), Some([6.0, 15.0]));
    }

    #[test]
    fn sampling_stops_when_the_median_is_known() {
        let samples = Samples { most: 11, least: Duration::ZERO, precision: 0.05 };
        assert!(samples.is_known(&[1.0, 1.01, 0.99, 1.0, 1.02, 1.0]));
        assert!(!samples.is_known(&[1.0, 1.01, 0.99, 1.0, 1.02]), "too few to know");
        assert!(!samples.is_known(&[1.0, 1.2, 0.99, 1.0, 1.02, 1.0]), "too far apart");
        assert!(!Samples { precision: 0.0, ..samples }.is_known(&[1.0, 1.0, 1.0, 1.0, 1.0, 1.01]));
    }
}
