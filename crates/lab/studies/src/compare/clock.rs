//! The cost of an answer: time, measured in turns, and memory.

use std::time::Duration;

use predicament_corpus::LoadedScene;
use predicament_predicates::Counts;
use predicament_records::approximately;
use predicament_tasks::{Contestant, How, Purpose, Solver, Watch};

use super::memory::peak;
use crate::Error;

/// The least duration of a sample: it repeats the pass until this time is over.
const LEAST: Duration = Duration::from_millis(2);

/// The time and memory of a backend on one scene.
#[derive(Clone, PartialEq, Default, Debug)]
pub(crate) struct Taken {
    /// Nanoseconds per unit that the scene counts, sample by sample; empty if the backend declines.
    pub nanoseconds: Vec<f64>,
    /// The peak memory while it prepared and answered, in bytes.
    pub bytes: Option<u64>,
    /// The number of points that it constructed for its answer; `None` if it declines.
    pub constructed: Option<u64>,
}

/// Times backends on one scene, in turns, on one thread.
pub(crate) fn taken(
    scene: &LoadedScene,
    backends: &[&dyn Contestant],
    samples: u32,
    watch: &Watch<'_>,
) -> Result<Vec<Taken>, Error> {
    let content = scene.content.as_ref();
    let count = approximately(content.count().max(1) as u64);
    let mut taken: Vec<Taken> = Vec::new();
    let mut stopwatches = Vec::new();
    for backend in backends {
        let solver = backend.solver(scene.task);
        let mut bytes = None;
        let mut stopwatch = None;
        if let Some(solver) = solver {
            // The first interface asks single queries if the scene has queries. A program in another language is
            // queried in batches.
            let first = || {
                let all = solver.interfaces(content).into_iter();
                let mut prepared = all.filter_map(|by| solver.stopwatch(&scene.scene, content, 1, by).transpose());
                prepared.next()?.ok()
            };
            bytes = peak(|| {
                stopwatch = first();
                // A backend may fail in the middle; then it is not timed.
                let warm = |stopwatch: &mut Box<dyn predicament_tasks::Stopwatch + '_>| stopwatch.pass();
                let first = stopwatch.as_mut().map(|stopwatch| predicament_tasks::caught(|| warm(stopwatch)));
                if !matches!(first, Some(Ok(_))) {
                    stopwatch = None;
                }
            });
        }
        let answers = solver.filter(|_| stopwatch.is_some());
        taken.push(Taken {
            nanoseconds: Vec::new(),
            bytes: bytes.filter(|_| stopwatch.is_some()),
            constructed: answers.and_then(|solver| constructed(solver, scene, watch)),
        });
        stopwatches.push(stopwatch);
        watch.done(0)?;
    }
    let mut passes = vec![1_u32; stopwatches.len()];
    for sample in 0..=samples {
        for ((stopwatch, taken), passes) in stopwatches.iter_mut().zip(&mut taken).zip(&mut passes) {
            let Some(stopwatch) = stopwatch else { continue };
            let elapsed = stopwatch.passes(*passes);
            if sample == 0 {
                // The first pass determines the number of passes in a sample.
                let once = elapsed.max(Duration::from_nanos(1));
                *passes = u32::try_from(LEAST.as_nanos() / once.as_nanos() + 1).unwrap_or(u32::MAX);
            } else {
                taken.nanoseconds.push(elapsed.as_secs_f64() * 1e9 / f64::from(*passes) / count);
            }
        }
        watch.done(0)?;
    }
    Ok(taken)
}

/// The number of points that a backend constructs for its answer to a scene.
fn constructed(solver: &dyn Solver, scene: &LoadedScene, watch: &Watch<'_>) -> Option<u64> {
    let how = How { purpose: Purpose::Use, watch };
    let mut points = None;
    solver
        .solve(&scene.scene, scene.content.as_ref(), &Counts::new(), &how, &mut |session, _| {
            points = Some(session.scene().constructions().len() as u64);
            Ok(())
        })
        .ok()?;
    points
}
