//! Times the judge of other programs' answers beside the solver of `exact`, for each task that is open to programs.
//!
//! ```sh
//! cargo bench -p predicament-benches --bench judging -- 1000 10000 100000
//! ```
//!
//! The scenes are those of each task's first family in general position, with about so many parts. The answer is that
//! of `exact`, with constructed vertices at their nearest doubles: a right answer, on which every law is tested. The
//! truth about a scene is computed once for all backends. The truth, the solver and the judge are each stopped at a
//! limit (30 seconds, or `--limit SECONDS`). The larger scenes of the task are then left out, and the table says so.
//! Each time is that of one run. `--task NAME` times one task alone.

use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use predicament_bundle::{backend, tasks};
use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_predicates::Counts;
use predicament_tasks::replies::Reply;
use predicament_tasks::{AnyTask, Asked, Budget, How, Kind, Outcome, Purpose, Watch, vocabulary};

/// The number of parts of a scene, or of its points where there are more.
fn parts(task: &dyn AnyTask, loaded: &LoadedScene) -> usize {
    task.size_of(loaded).max(loaded.scene.vertices().count())
}

/// The scene of a task's first family in general position with about this number of parts.
fn scene(task: &'static dyn AnyTask, size: usize) -> Option<LoadedScene> {
    let of = task.compared_on().iter().find(|of| of.kind == Kind::General)?;
    let of_size = |n: usize| -> Option<LoadedScene> {
        let table =
            format!("[[generate]]\nfamily = \"{}\"\ntask = \"{}\"\nn = {n}\nseed = 1\n", of.family, task.name());
        let text = format!("title = \"judging\"\n{table}{}\n", of.keys);
        let suite = Suite::parse(&vocabulary(&[task]), "judging", &text, None, &Manifest::default());
        let suite = suite.map_err(|why| eprintln!("{}: {why}", task.name())).ok()?;
        suite.scenes[0].load(Level::Quick, &Cache::new("judging")).map_err(|why| eprintln!("{why}")).ok()
    };
    // The family's unit is not a part in every family: its size is doubled until there are enough parts.
    let (mut low, mut below) = (4, 0);
    loop {
        let high = 2 * low;
        let loaded = of_size(high)?;
        let parts = parts(task, &loaded);
        if parts >= size {
            let n = low + (high - low) * (size - below) / (parts - below).max(1);
            return if n == high { Some(loaded) } else { of_size(n) };
        }
        (low, below) = (high, parts);
    }
}

/// The times of solving, of the truth and of judging, and the verdict.
fn timed(task: &'static dyn AnyTask, loaded: &LoadedScene, limit: Duration) -> Result<([Duration; 3], String), String> {
    let exact = backend("exact").map_err(|why| why.to_string())?;
    task.question(&loaded.scene, loaded.content.as_ref()).map_err(|why| why.to_string())?;
    let (never, quiet) = (AtomicBool::new(false), |_: u64| {});
    let watch = Watch::new(&never, Some(limit), &quiet);
    let start = Instant::now();
    let case = task.case(loaded, &watch).map_err(|_| "the truth takes longer than the limit".to_owned())?;
    let truth = start.elapsed();
    let (mut solving, mut judging, mut outcome) = (Duration::ZERO, Duration::ZERO, Outcome::default());
    let watch = watch.restarted(Some(limit));
    let how = How { purpose: Purpose::Use, watch: &watch };
    let solver = exact.solver(task.name()).ok_or("not solved by exact")?;
    let start = Instant::now();
    let solved = solver.solve(&loaded.scene, loaded.content.as_ref(), &Counts::new(), &how, &mut |session, answer| {
        solving = start.elapsed();
        let arrays = task.as_reply(&loaded.scene, loaded.content.as_ref(), answer).unwrap_or_default();
        let watch = watch.restarted(Some(limit));
        let asked = Asked { backend: exact.as_ref(), session, budget: Budget::QUICK, watch: &watch };
        let start = Instant::now();
        let judged = case.judge(&asked, &Reply { arrays, ..Reply::default() }, &mut outcome);
        judging = start.elapsed();
        judged
    });
    solved.map_err(|_| "solving or judging takes longer than the limit".to_owned())?;
    let verdict = outcome.findings.first().map_or_else(|| "right".to_owned(), |one| one.check.clone());
    Ok(([solving, truth, judging], verdict))
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let mut sizes = Vec::new();
    let mut limit = 30;
    let mut only = None;
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        match argument.as_str() {
            "--limit" => limit = rest.next().and_then(|seconds| seconds.parse().ok()).unwrap_or(limit),
            "--task" => only = rest.next(),
            number => sizes.extend(number.parse::<usize>().ok()),
        }
    }
    if sizes.is_empty() {
        sizes = vec![1_000];
    }
    println!("| task | parts | solve, s | truth, s | judge, s | verdict |\n|---|---:|---:|---:|---:|---|");
    for &task in
        tasks().iter().filter(|task| task.parts_of_replies().is_some() && only.is_none_or(|only| only == task.name()))
    {
        let mut is_slow = false;
        for &size in &sizes {
            let name = task.name();
            if is_slow {
                println!("| {name} | {size} | | | | left out: the scene before took over {limit} s |");
                continue;
            }
            let Some(loaded) = scene(task, size) else {
                println!("| {name} | {size} | | | | there is not a scene of this size |");
                continue;
            };
            let parts = parts(task, &loaded);
            match timed(task, &loaded, Duration::from_secs(limit)) {
                Ok((times, verdict)) => {
                    is_slow = times.iter().any(|&time| time > Duration::from_secs(limit));
                    let [solving, truth, judging] = times.map(|time| time.as_secs_f64());
                    println!("| {name} | {parts} | {solving:.3} | {truth:.3} | {judging:.3} | {verdict} |");
                }
                Err(why) => {
                    is_slow = true;
                    println!("| {name} | {parts} | | | | {why} |");
                }
            }
        }
    }
}
