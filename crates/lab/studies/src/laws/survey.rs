//! The survey of a backend on all scenes, on all threads.
//!
//! Every scene has a separate random stream, and results are combined in the order of the scenes, so nothing depends on
//! the number of threads.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use predicament_corpus::Random;
use predicament_exact::Exact;
use predicament_laws::axioms::{Law, Zeros};
use predicament_predicates::{Backend, Broken, Dimension, Off, Predicates, Question, Scene, Vertex};
use predicament_tasks::{Contestant, Stop, Watch};
use rayon::prelude::*;

use super::check::Sessions;
use super::family::place;
use super::{Check, Example, Family, Row, checks};

/// The number of tuples and the seed of a survey.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Survey {
    /// The number of random tuples for a backend that has all predicates; rounded up to whole scenes.
    pub tuples: u64,
    /// The seed of all scenes.
    pub seed: u64,
}

/// The number of exhausted scenes, in the plane and in space: each has the same points in another order.
const EXHAUSTED: [(Dimension, u64); 2] = [(Dimension::Two, 8), (Dimension::Three, 4)];
/// The number of tuples per law in a random scene.
const SHARE: usize = 24;

/// One scene with its tuples.
#[derive(Clone, Copy)]
struct Job {
    family: Family,
    dimension: Dimension,
    number: u64,
}

impl Survey {
    /// The number of tuples for a backend with all predicates, to show progress.
    #[must_use]
    pub fn total(&self) -> u64 {
        let exhausted = |(dimension, orders): (Dimension, u64)| {
            let (scene, _) = Family::Exhaustive.scene(dimension, 0, self.seed);
            let all = checks(dimension);
            let tuples = all.iter().map(|check| check.tuples(reach(check, &scene)).len() as u64);
            orders * tuples.sum::<u64>()
        };
        EXHAUSTED.into_iter().map(exhausted).sum::<u64>() + self.rounds() * per_round()
    }

    /// The number of rounds, each with every family once in each dimension.
    fn rounds(&self) -> u64 {
        self.tuples.div_ceil(per_round())
    }

    fn job(&self, at: u64) -> Job {
        let mut at = at;
        for (dimension, orders) in EXHAUSTED {
            if at < orders {
                return Job { family: Family::Exhaustive, dimension, number: at };
            }
            at -= orders;
        }
        let families = Family::RANDOM.len() as u64;
        let dimension = if at.is_multiple_of(2) { Dimension::Two } else { Dimension::Three };
        let family = Family::RANDOM[usize::try_from(at / 2 % families).unwrap_or_default()];
        Job { family, dimension, number: at / 2 / families }
    }

    fn jobs(&self) -> u64 {
        let exhausted: u64 = EXHAUSTED.iter().map(|(_, orders)| orders).sum();
        exhausted + self.rounds() * 2 * Family::RANDOM.len() as u64
    }
}

fn per_round() -> u64 {
    let laws = checks(Dimension::Two).len() + checks(Dimension::Three).len();
    (laws * SHARE * Family::RANDOM.len()) as u64
}

/// Checks every law on a backend: one row for each law and its predicates, by law.
///
/// # Errors
/// [`Stop`] if the watch says so; it counts tuples.
pub fn survey(contestant: &dyn Contestant, survey: Survey, watch: &Watch) -> Result<Vec<Row>, Stop> {
    let all = EXHAUSTED.map(|(dimension, _)| checks(dimension));
    let empty = empty_rows(&all);
    let jobs = (0..survey.jobs()).into_par_iter().map(|at| {
        let job = survey.job(at);
        let checks = &all[job.dimension.count() - 2];
        let (rows, tuples) = try_scene(contestant, survey, job, checks);
        watch.done(tuples).map(|()| rows)
    });
    jobs.try_fold(
        || empty.clone(),
        |mut sum, rows| {
            add(&mut sum, rows?);
            Ok(sum)
        },
    )
    .try_reduce(
        || empty.clone(),
        |mut sum, later| {
            add(&mut sum, later);
            Ok(sum)
        },
    )
}

/// A row for each law and subject, by law.
fn empty_rows(checks: &[Vec<Check>]) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for check in checks.iter().flatten() {
        let row = Row::empty(check.law(), check.subject());
        if !rows.iter().any(|other| other.law == row.law && other.subject == row.subject) {
            rows.push(row);
        }
    }
    rows.sort_by_key(|row| row.law);
    rows
}

fn add(sum: &mut [Row], rows: Vec<Row>) {
    for row in rows {
        if let Some(same) = sum.iter_mut().find(|other| other.law == row.law && other.subject == row.subject) {
            same.add(row);
        }
    }
}

/// The number of a scene's vertices on which a law may be checked.
///
/// For the law about later vertices these are the first part.
fn reach(check: &Check, scene: &Scene) -> usize {
    if check.law() == Law::LaterVertices { first_part(scene) } else { scene.len() }
}

fn first_part(scene: &Scene) -> usize {
    scene.len() * 2 / 3
}

/// The counts of one scene, and the number of tuples that were checked or skipped.
fn try_scene(contestant: &dyn Contestant, survey: Survey, job: Job, checks: &[Check]) -> (Vec<Row>, u64) {
    let (scene, mut random) = job.family.scene(job.dimension, job.number, survey.seed);
    // Drawn in any case, so that all backends have the same tuples.
    let drawn: Vec<Vec<Vec<Vertex>>> = checks.iter().map(|check| tuples(check, job, &scene, &mut random)).collect();
    let all: usize = drawn.iter().map(Vec::len).sum();
    let coordinates = scene.coordinates()[..first_part(&scene) * job.dimension.count()].to_vec();
    let first = Scene::new(job.dimension, coordinates).expect("points of a scene");
    let zeros = Zeros::promised(|kind| contestant.contract(kind));
    let judge = contestant.tie_judge();
    let is_identity = |question: Question, args: &[Vertex]| {
        judge.is_some_and(|perturbed| perturbed(&scene, question, args).is_zero())
    };
    let Ok(reference) = Exact.prepare(&scene, Off) else { return (Vec::new(), all as u64) };
    let mut rows = Vec::new();
    let mut look = |session: &dyn Predicates, fewer: Option<&dyn Predicates>| {
        let on = Sessions { session, fewer, reference: &reference, zeros, is_identity: &is_identity };
        for (check, tuples) in checks.iter().zip(&drawn) {
            let supported = check.kinds().into_iter().all(|kind| session.supports(kind).is_ok());
            if supported && check.is_promised(zeros) {
                rows.push(try_tuples(check, job, &scene, &on, tuples));
            }
        }
    };
    // A declined scene adds no tuples to its rows.
    let prepared = catch_unwind(AssertUnwindSafe(|| {
        let _ = contestant.with_session(&scene, &mut |session| {
            if contestant.with_session(&first, &mut |fewer| look(session, Some(fewer))).is_err() {
                look(session, None);
            }
        });
    }));
    if let Err(payload) = prepared {
        rows.push(Row {
            panics: 1,
            first: Some(Example::of_panic(job.family, &scene, &[], &message(payload.as_ref()))),
            ..Row::empty(checks[0].law(), checks[0].subject())
        });
    }
    (rows, all as u64)
}

fn try_tuples(check: &Check, job: Job, scene: &Scene, on: &Sessions<'_>, tuples: &[Vec<Vertex>]) -> Row {
    let mut row = Row::empty(check.law(), check.subject());
    let batches: Vec<Vec<Vertex>> =
        if check.in_batches() { tuples.chunks(SHARE).map(<[_]>::concat).collect() } else { Vec::new() };
    row.tuples = tuples.len() as u64;
    for tuple in if check.in_batches() { &batches } else { tuples } {
        match catch_unwind(AssertUnwindSafe(|| check.look(on, tuple))) {
            Ok(None) => {}
            Ok(Some(violation)) => {
                if row.violations == 0 {
                    row.first = Some(Example::of_violation(job.family, scene, &violation));
                }
                row.violations += 1;
            }
            Err(payload) => {
                row.panics += 1;
                let example = || Example::of_panic(job.family, scene, tuple, &message(payload.as_ref()));
                row.first = row.first.take().or_else(|| Some(example()));
            }
        }
    }
    row
}

fn tuples(check: &Check, job: Job, scene: &Scene, random: &mut Random) -> Vec<Vec<Vertex>> {
    let reach = reach(check, scene);
    if job.family == Family::Exhaustive {
        return check.tuples(reach);
    }
    let mut vertices: Vec<Vertex> = (0..reach).map(Vertex::input).collect();
    let mut draw = || {
        for at in 0..check.vertices() {
            vertices.swap(at, at + place(random, reach - at));
        }
        vertices[..check.vertices()].to_vec()
    };
    (0..SHARE).map(|_| draw()).collect()
}

/// The message of a panic, or the reason why a session broke off.
fn message(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    let text = text.or_else(|| payload.downcast_ref::<String>().cloned());
    let text = text.or_else(|| payload.downcast_ref::<Broken>().map(ToString::to_string));
    text.unwrap_or_else(|| "no message".to_owned())
}
