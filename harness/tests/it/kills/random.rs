//! Kills at random moments.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Child;
use std::time::{Duration, Instant};

use predicament_corpus::Random;

use super::driver::{Bench, PARTS, Shape, children, merging, signal, size, start, with_out};

/// The process that is ended, with the signal.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Kind {
    /// A run in one process.
    Run(&'static str),
    /// A run that starts workers, together with its workers, as a batch system does.
    Group(&'static str),
    /// A worker of a run.
    Worker(&'static str),
    /// A part of a run.
    Part(&'static str),
    /// A run, and `run --resume` of it.
    Resume(&'static str),
    /// A merge.
    Merge(&'static str),
}

/// The kinds, in turn. The first six start no workers, because worker processes take most of the time.
const KINDS: [Kind; 12] = [
    Kind::Run("KILL"),
    Kind::Merge("KILL"),
    Kind::Resume("KILL"),
    Kind::Part("KILL"),
    Kind::Run("TERM"),
    Kind::Part("INT"),
    Kind::Worker("KILL"),
    Kind::Group("TERM"),
    Kind::Group("KILL"),
    Kind::Worker("TERM"),
    Kind::Run("INT"),
    Kind::Resume("TERM"),
];

/// The number of cases: every kind a few times, or a few kinds.
fn cases() -> u64 {
    if predicament_effort::whole() { 100 } else { 6 }
}

/// The moment of the kill: when the files have this many bytes or after this time, whichever is first.
#[derive(Clone, Copy, Debug)]
struct Moment {
    bytes: u64,
    time: Duration,
}

impl Moment {
    /// A random moment while `all` bytes are written. Usually it is a number of bytes, so that it does not depend on
    /// the machine's load; one time in six it is a time, which may be before the first byte.
    fn of(random: &mut Random, all: u64, time: Duration) -> Moment {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
        let bytes = (all as f64 * random.unit()) as u64;
        let early = random.one_in(6);
        let time = time.mul_f64(random.unit());
        if early { Moment { bytes: u64::MAX, time } } else { Moment { bytes, time: Duration::MAX } }
    }

    fn has_come(self, folder: &Path, begun: Instant) -> bool {
        begun.elapsed() >= self.time || self.bytes < u64::MAX && size(folder) > self.bytes
    }
}

pub fn seed() -> u64 {
    let word = std::env::var("PREDICAMENT_SEED").ok();
    word.map_or(1, |word| word.parse().unwrap_or_else(|_| panic!("PREDICAMENT_SEED is `{word}`, which is no number")))
}

/// Ends a process, or a process that it started, at the moment, and waits for its end; `None` if it ended before.
fn end(
    mut child: Child,
    moment: Moment,
    folder: &Path,
    signalled: impl Fn(u32) -> Option<(&'static str, i64)>,
) -> Option<()> {
    let begun = Instant::now();
    let mut sent = None;
    while child.try_wait().unwrap().is_none() {
        if sent.is_none()
            && moment.has_come(folder, begun)
            && let Some((name, process)) = signalled(child.id())
        {
            signal(name, process);
            sent = Some(());
        }
        std::thread::sleep(Duration::from_micros(200));
    }
    sent
}

#[test]
#[cfg(target_os = "linux")]
fn what_is_killed_at_a_random_moment_is_gone_on_with() {
    let apart: &[Shape] = if predicament_effort::whole() { &[Shape::Apart] } else { &[] };
    let (bench, seed) = (Bench::with_parts(apart), seed());
    println!("seed {seed}");
    let mut counts: BTreeMap<(Kind, &str, &str), u32> = BTreeMap::new();
    let mut killed = 0;
    for case in 0..cases() {
        let kind = KINDS[usize::try_from(case).unwrap() % KINDS.len()];
        let mut random = Random::new("kills", "random", seed.wrapping_mul(1000) + case);
        let out = bench.place(&format!("case {case}"));
        let mut moment = |shape: Shape| Moment::of(&mut random, bench.size(shape), bench.time(shape));
        let itself = |name: &'static str| move |id: u32| Some((name, i64::from(id)));
        let fresh = |shape: Shape| start(&with_out(shape.words(), &out));
        let (shape, sent, at) = match kind {
            Kind::Run(name) => {
                let (shape, at) = (Shape::Plain, moment(Shape::Plain));
                (shape, end(fresh(shape), at, &out, itself(name)), at)
            }
            Kind::Part(name) => {
                let shape = Shape::Part(1 + u32::try_from(case).unwrap() % PARTS);
                let at = moment(shape);
                (shape, end(fresh(shape), at, &out, itself(name)), at)
            }
            Kind::Group(name) => {
                let (shape, at) = (Shape::Apart, moment(Shape::Apart));
                (shape, end(fresh(shape), at, &out, |id| Some((name, -i64::from(id)))), at)
            }
            Kind::Worker(name) => {
                let (shape, at) = (Shape::Apart, moment(Shape::Apart));
                let worker = |id| children(id).first().map(|&worker| (name, i64::from(worker)));
                (shape, end(fresh(shape), at, &out, worker), at)
            }
            Kind::Resume(name) => {
                let (shape, first) = (Shape::Plain, moment(Shape::Plain));
                end(fresh(shape), first, &out, itself("KILL"));
                let at = moment(shape);
                let words = ["run", "--quiet", "--resume", &out.display().to_string()].map(str::to_owned);
                (shape, end(start(&words), at, &out, itself(name)), at)
            }
            Kind::Merge(name) => {
                let at = moment(Shape::Plain);
                (Shape::Plain, end(start(&bench.merge(&out)), at, &merging(&out), itself(name)), at)
            }
        };
        let about = format!("case {case} of seed {seed}: {kind:?} at {at:?}");
        let (was, became) = match kind {
            Kind::Merge(_) => bench.settle_merge(&out, &about),
            _ => bench.settle(shape, &out, &about),
        };
        let sent = if sent.is_some() { "killed" } else { "over before" };
        killed += u32::from(sent == "killed");
        println!("{about}: {sent}; left: {was}; {became}");
        *counts.entry((kind, was, became)).or_default() += 1;
        remove(&out);
    }
    for ((kind, was, became), count) in counts {
        println!("{count:>4}  {kind:?}  left: {was}  {became}");
    }
    println!("{killed} of {} were killed before their end", cases());
    assert!(killed > 0, "every run was over before it was to be killed");
    super::syscalls::kill_merges(&bench, seed);
}

fn remove(out: &Path) {
    let _ = std::fs::remove_dir_all(out);
}
