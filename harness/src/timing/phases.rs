//! The parts of algorithms, which `bench` times one by one; the rows of `phases.csv`.

use std::sync::atomic::Ordering::Relaxed;
use std::time::{Duration, Instant};

use predicament_corpus::LoadedScene;
use predicament_oracle::caught;
use predicament_records::{PhaseRow, PlannedScene, RunWriter, TableSpec};
use predicament_tasks::{AnyTask, Phase};

use super::{Runner, Samples};
use crate::exit::Failure;
use crate::interrupt;
use crate::tool::Tool;

/// The tables of a bench folder: those of a run, and that of phases.
pub fn tables(tool: &Tool) -> Vec<TableSpec> {
    let mut tables = crate::planning::tables(tool);
    tables.push(TableSpec::of::<PhaseRow>());
    tables
}

/// A group of phases that are timed together.
struct Part<'a> {
    /// The backend's name; empty for phases that call no predicate.
    backend: String,
    threads: usize,
    once: Box<dyn FnMut() -> Vec<Phase> + 'a>,
    passes: u32,
    /// Nanoseconds per unit of each phase, sample by sample.
    known: Vec<Vec<f64>>,
}

/// Times the phases of a scene, if its task has any, and writes their rows. Phases that call no predicate are timed
/// with each number of threads, the others with each runner; they take turns. Returns false if interrupted.
pub fn take(
    samples: &Samples,
    scene: &PlannedScene,
    (loaded, task): (&LoadedScene, &dyn AnyTask),
    (runners, threads): (&mut [Runner<'_>], &[usize]),
    writer: &mut RunWriter,
    remarks: &mut Vec<String>,
) -> Result<bool, Failure> {
    let mut parts = Vec::new();
    for &threads in threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.map_err(|error| Failure::usage(format!("--threads: {error}")))?;
        let once = Box::new(move || pool.install(|| task.building_phases(loaded)));
        parts.push(Part { backend: String::new(), threads, once, passes: 1, known: Vec::new() });
    }
    for Runner { name, threads, watch, .. } in runners {
        let once = Box::new(|| watch.phases());
        parts.push(Part { backend: name.clone(), threads: *threads, once, passes: 1, known: Vec::new() });
    }
    // One pass to warm up, to size the samples, and to see which parts have phases.
    parts.retain_mut(|part| {
        let start = Instant::now();
        match caught(|| (part.once)()) {
            Ok(phases) => {
                let wall = start.elapsed().max(Duration::from_nanos(1));
                part.passes = u32::try_from(samples.least.as_nanos() / wall.as_nanos() + 1).unwrap_or(u32::MAX);
                part.known = vec![Vec::new(); phases.len()];
                !phases.is_empty()
            }
            Err(why) => {
                let on = if part.backend.is_empty() { String::new() } else { format!(" on {}", part.backend) };
                remarks.push(format!("phases not timed: {}/{}{on}: {why}", scene.suite, scene.scene));
                false
            }
        }
    });
    let size = task.size_of(loaded) as u64;
    for sample in 0..samples.most {
        let is_open = |part: &&mut Part<'_>| !part.known.iter().all(|known| samples.is_known(known));
        let mut rows = Vec::new();
        for part in parts.iter_mut().filter(is_open) {
            if interrupt::flag().load(Relaxed) {
                return Ok(false);
            }
            for (at, phase) in part.times().into_iter().enumerate() {
                // Counts of units and passes are far below 2^53, so the conversion is exact.
                #[allow(clippy::cast_precision_loss)]
                let units = phase.count as f64 * f64::from(part.passes);
                let ns_per_unit = phase.elapsed.max(Duration::from_nanos(1)).as_secs_f64() * 1e9 / units;
                part.known[at].push(ns_per_unit);
                let [suite, name, scene_id, task] = scene.labels();
                rows.push(PhaseRow {
                    suite,
                    scene: name,
                    scene_id,
                    task,
                    size,
                    backend: part.backend.clone(),
                    threads: part.threads as u64,
                    phase: phase.name.to_owned(),
                    unit: phase.unit.to_owned(),
                    count: phase.count as u64,
                    bytes: phase.bytes.map(|bytes| bytes as u64),
                    sample,
                    ns_per_unit,
                });
            }
        }
        writer.write(&rows).map_err(Failure::usage)?;
    }
    Ok(true)
}

impl Part<'_> {
    /// The phases of one sample, with the times of all passes added up.
    fn times(&mut self) -> Vec<Phase> {
        let mut all = (self.once)();
        for _ in 1..self.passes {
            for (sum, phase) in all.iter_mut().zip((self.once)()) {
                sum.elapsed += phase.elapsed;
            }
        }
        all
    }
}
