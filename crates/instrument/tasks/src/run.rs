//! One backend on one scene: refusals, panics and timeouts become outcomes.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use predicament_predicates::{Broken, Counts, PredicateKind};

use crate::replies::{self, Reply};
use crate::{AnyCase, AnySpoiled, Asked, Budget, Class, Contestant, Halt, How, Outcome, Purpose, Stop, Watch};

/// Runs one backend on one scene and judges its answers. A panic becomes a finding about the backend, as do refusals
/// and timeouts.
///
/// # Errors
/// [`Stop::Interrupted`]; a timeout is an outcome.
pub fn run(case: &dyn AnyCase, contestant: &dyn Contestant, budget: Budget, watch: &Watch) -> Result<Outcome, Stop> {
    let queries = case.loaded().count() as u64;
    let Some(why) = case.invalid() else {
        return guarded(queries, || judged(case, contestant, budget, watch, queries));
    };
    if !solver(contestant, case).is_program() {
        return Ok(replies::not_asked(queries, &why));
    }
    guarded(queries, || unwanted(case, contestant, watch, queries, &why)).map(replies::refused)
}

/// Puts invalid input to a program.
fn unwanted(
    case: &dyn AnyCase,
    contestant: &dyn Contestant,
    watch: &Watch,
    queries: u64,
    why: &str,
) -> Result<Outcome, Halt> {
    let loaded = case.loaded();
    let mut outcome = Outcome { queries, ..Outcome::default() };
    let how = How { purpose: Purpose::Judge, watch };
    let solver = solver(contestant, case);
    solver.solve(&loaded.scene, loaded.content.as_ref(), &Counts::new(), &how, &mut |_, answer| {
        let reply = answer.downcast_ref::<Reply>().expect("programs answer by replies");
        replies::accepted(reply, why, &mut outcome);
        Ok(())
    })?;
    Ok(outcome)
}

/// Judges the right answer of a backend after spoiling it.
///
/// # Errors
/// [`Stop::Interrupted`]; a timeout is an outcome.
pub fn run_spoiled(
    case: &dyn AnyCase,
    fault: &dyn AnySpoiled,
    contestant: &dyn Contestant,
    budget: Budget,
    watch: &Watch,
) -> Result<Outcome, Stop> {
    let (loaded, queries) = (case.loaded(), case.loaded().count() as u64);
    guarded(queries, || {
        let mut outcome = Outcome { queries, ..Outcome::default() };
        let how = How { purpose: Purpose::Judge, watch };
        let solver = solver(contestant, case);
        solver.solve(&loaded.scene, loaded.content.as_ref(), &Counts::new(), &how, &mut |session, answer| {
            let spoiled = fault.spoil(&loaded.scene, loaded.content.as_ref(), answer);
            case.judge(&Asked { backend: contestant, session, budget, watch }, spoiled.as_ref(), &mut outcome)
        })?;
        Ok(outcome)
    })
}

/// The backend as a solver of the task of a scene.
fn solver<'a>(contestant: &'a dyn Contestant, case: &dyn AnyCase) -> &'a dyn crate::Solver {
    let task = case.task().name();
    contestant
        .solver(task)
        .unwrap_or_else(|| panic!("{} does not have a solver for the task {task}", contestant.name()))
}

/// The result of `work`, or the reason why a backend broke off in it: a panic, or a failed process behind it.
///
/// # Errors
/// [`Broken`], of class [`Class::Panic`] and check `panic` for a panic of its own.
pub fn caught<T>(work: impl FnOnce() -> T) -> Result<T, Broken> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|payload| match payload.downcast::<Broken>() {
        Ok(broken) => *broken,
        Err(payload) => Broken { class: Class::Panic, check: "panic", message: message(payload.as_ref()) },
    })
}

fn guarded(queries: u64, judged: impl FnOnce() -> Result<Outcome, Halt>) -> Result<Outcome, Stop> {
    match caught(judged) {
        Ok(Ok(outcome)) => Ok(outcome),
        Ok(Err(Halt::Refused(refusal))) => Ok(refusal.outcome(queries)),
        Ok(Err(Halt::Stopped(Stop::Timeout))) => {
            Ok(Outcome::of_scene(queries, Class::Timeout, "time limit", "took too long".to_owned()))
        }
        Ok(Err(Halt::Stopped(Stop::Interrupted))) => Err(Stop::Interrupted),
        Err(broken) => Ok(Outcome::of_scene(queries, broken.class, broken.check, broken.message)),
    }
}

fn judged(
    case: &dyn AnyCase,
    contestant: &dyn Contestant,
    budget: Budget,
    watch: &Watch,
    queries: u64,
) -> Result<Outcome, Halt> {
    let (loaded, task) = (case.loaded(), case.task());
    let solver = solver(contestant, case);
    let counts = Counts::new();
    let kinds = task.kinds(&loaded.scene);
    let mut outcome = Outcome { queries, ..Outcome::default() };
    let how = How { purpose: Purpose::Judge, watch };
    solver.solve(&loaded.scene, loaded.content.as_ref(), &counts, &how, &mut |session, answer| {
        // Counted before the judge makes its own queries.
        outcome.stages = stages(contestant, &counts, &kinds);
        case.judge(&Asked { backend: contestant, session, budget, watch }, answer, &mut outcome)
    })?;
    Ok(outcome)
}

/// The number of queries of these kinds that each stage has settled, without stages that settled none.
fn stages(contestant: &dyn Contestant, counts: &Counts, kinds: &[PredicateKind]) -> Vec<(&'static str, u64)> {
    let settled = |stage| kinds.iter().map(|&kind| counts.get(kind, stage)).sum();
    let stages = contestant.stages().iter().enumerate().map(|(stage, &name)| (name, settled(stage)));
    stages.filter(|&(_, settled)| settled > 0).collect()
}

/// The message of a panic, in one line.
fn message(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    let text = text.or_else(|| payload.downcast_ref::<String>().cloned());
    text.unwrap_or_else(|| "no message".to_owned()).replace('\n', " ")
}
