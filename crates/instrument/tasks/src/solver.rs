//! A backend as a solver of a task: the place where generic code is compiled.
//!
//! Timed hot loops are generic over the session; the command line is not. A [`Solver`] connects the two: one dynamic
//! call per timed scene, none per query. Judging makes a dynamic call per query.

use std::any::Any;
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use predicament_corpus::Content;
use predicament_predicates::{
    Backend, Batches, Broken, Counts, Declined, Off, Predicates, QuerySet, Refused, Scene, Vertex,
};
use predicament_records::Interface;

use crate::{Answer, AnswerError, AnyTask, Class, Outcome, Phase, Rounds, Stop, Task, Watch};

/// The purpose of an answer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Purpose {
    /// Judging: a task may make every query that its shortcuts leave out.
    Judge,
    /// Use: the fastest method, which is the one that is timed.
    Use,
    /// Output to files: with everything that users of the files need.
    Files,
}

/// Options for solving a task.
#[derive(Clone, Copy)]
pub struct How<'a> {
    /// The purpose of the answer.
    pub purpose: Purpose,
    /// The watch that can end the work.
    pub watch: &'a Watch<'a>,
}

/// The reason why there is no answer.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Halt {
    /// The backend declined.
    Refused(Refusal),
    /// The watch stopped it.
    Stopped(Stop),
}

/// A function that takes a session and the answer that it gave.
pub(crate) type Then<'t> = dyn FnMut(&dyn Predicates, &dyn Any) -> Result<(), Stop> + 't;

impl From<Stop> for Halt {
    fn from(stop: Stop) -> Halt {
        Halt::Stopped(stop)
    }
}

impl From<Refused> for Halt {
    fn from(refused: Refused) -> Halt {
        Halt::Refused(Refusal { check: "construct", why: refused.into() })
    }
}

/// A backend's refusal of a scene, a predicate or a construction.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refusal {
    /// The refused step: `prepare`, `supports` or `construct`.
    pub check: &'static str,
    /// Its reason.
    pub why: Declined,
}

impl Refusal {
    /// The outcome of a scene with this number of queries.
    #[must_use]
    pub fn outcome(&self, queries: u64) -> Outcome {
        Outcome::of_scene(queries, Class::Declined, self.check, self.why.to_string())
    }
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.why.fmt(f)
    }
}

/// A backend on a task.
pub trait Solver: Send + Sync {
    /// The task.
    fn task(&self) -> &dyn AnyTask;

    /// Prepares the backend for the scene, solves, and passes session and answer (the task's [`Answer`](Task::Answer))
    /// to `then`.
    ///
    /// # Errors
    /// [`Halt`] if the backend declines or the watch stops the work.
    fn solve(
        &self,
        scene: &Scene,
        content: &dyn Content,
        counts: &Counts,
        how: &How<'_>,
        then: &mut Then<'_>,
    ) -> Result<(), Halt>;

    /// True if another program answers: then it gets scenes that are marked as invalid input, too.
    fn is_program(&self) -> bool {
        false
    }

    /// The interfaces by which the content of a scene is timed: single queries and batches if the scene asks one
    /// predicate, otherwise the answer to the whole scene.
    fn interfaces(&self, content: &dyn Content) -> Vec<Interface>;

    /// Prepares the backend for timed passes by one of these [interfaces](Solver::interfaces), on a number of threads.
    /// Returns `None` for single queries of a session with its own clock: each would be a message to a program in
    /// another language.
    ///
    /// # Errors
    /// [`AnswerError`] if the backend declines.
    fn stopwatch<'a>(
        &'a self,
        scene: &'a Scene,
        content: &'a dyn Content,
        threads: usize,
        interface: Interface,
    ) -> Result<Option<Box<dyn Stopwatch + 'a>>, AnswerError>;
}

/// A prepared session that can be timed repeatedly, so that backends can take turns.
pub trait Stopwatch {
    /// Answers everything once and returns the time, without the preparation of the scene.
    fn pass(&mut self) -> Duration;

    /// The total time of `count` passes. The thread pool is entered once, which takes longer than a pass over a small
    /// scene.
    fn passes(&mut self, count: u32) -> Duration {
        (0..count).map(|_| self.pass()).sum()
    }

    /// Times the parts of one pass, if the task has them: see [`Task::asking`].
    fn phases(&mut self) -> Vec<Phase> {
        Vec::new()
    }

    /// A digest of the last pass's answers: see [`Answer::digest`].
    fn digest(&self) -> u64;
}

/// A backend on a task, as a [`Solver`].
pub struct OnTask<B, T> {
    backend: Arc<B>,
    task: T,
}

impl<B: Backend, T: Task> OnTask<B, T> {
    /// Combines a backend and a task.
    #[must_use]
    pub fn new(backend: &Arc<B>, task: T) -> OnTask<B, T> {
        OnTask { backend: Arc::clone(backend), task }
    }

    /// The session, if it supports the task's predicates.
    fn supported<P: Predicates>(&self, session: Result<P, Declined>) -> Result<P, Refusal> {
        let session = session.map_err(|why| Refusal { check: "prepare", why })?;
        self.task.supported(&session).map_err(|why| Refusal { check: "supports", why })?;
        Ok(session)
    }

    /// A session for timing.
    fn prepare<'s>(&'s self, scene: &'s Scene) -> Result<B::Session<'s, Off>, Refusal> {
        self.supported(self.backend.prepare(scene, Off))
    }

    /// Another session of a scene that was prepared before.
    fn prepared<'s>(&'s self, scene: &'s Scene) -> B::Session<'s, Off> {
        self.prepare(scene).unwrap_or_else(|refusal| panic!("prepared before, and declined now: {refusal}"))
    }

    fn content<'a>(&self, content: &'a dyn Content) -> &'a T::Content {
        let content: &dyn Any = content;
        content.downcast_ref().expect("the content of a scene of this task")
    }
}

impl<B: Backend + 'static, T: Task> Solver for OnTask<B, T> {
    fn task(&self) -> &dyn AnyTask {
        &self.task
    }

    fn solve(
        &self,
        scene: &Scene,
        content: &dyn Content,
        counts: &Counts,
        how: &How<'_>,
        then: &mut Then<'_>,
    ) -> Result<(), Halt> {
        // Judging is not timed: behind a pointer, the task is compiled once for the sessions of all backends that
        // count.
        let mut session = self.supported(self.backend.boxed(scene, Some(counts))).map_err(Halt::Refused)?;
        let mut answer = T::Answer::default();
        self.task.solve(&mut session, self.content(content), how, &mut answer)?;
        then(&*session, &answer).map_err(Halt::Stopped)
    }

    fn interfaces(&self, content: &dyn Content) -> Vec<Interface> {
        match self.task.queries(self.content(content)) {
            None => vec![Interface::Whole],
            Some(queries) => vec![
                Interface::Single,
                match self.backend.batches(queries.kind()) {
                    Batches::Own => Interface::Batch,
                    Batches::Loop => Interface::Loop,
                },
            ],
        }
    }

    fn stopwatch<'a>(
        &'a self,
        scene: &'a Scene,
        content: &'a dyn Content,
        threads: usize,
        interface: Interface,
    ) -> Result<Option<Box<dyn Stopwatch + 'a>>, AnswerError> {
        let session = self.prepare(scene).map_err(AnswerError::Refused)?;
        let has_own_clock = session.own_nanoseconds().is_some();
        // Without a pool, algorithms would use all threads.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.map_err(|error| AnswerError::Threads(error.to_string()))?;
        Ok(match self.task.queries(self.content(content)) {
            Some(_) if has_own_clock && interface == Interface::Single => None,
            Some(queries) => Some(Box::new(Queries {
                session,
                queries,
                interface,
                pool,
                rounds: Rounds::of(queries.len()),
                args: Vec::new(),
            })),
            None if has_own_clock => {
                return Err(AnswerError::OwnClock);
            }
            None => {
                let (session, answer) = (Some(session), T::Answer::default());
                Some(Box::new(Passes { solver: self, session, scene, content, pool, answer }))
            }
        })
    }
}

/// The result of a timed pass.
struct Passed {
    /// True if the pass was completed.
    done: bool,
    /// The session's own clock before and after the pass, if it has one.
    own: Option<[u64; 2]>,
}

/// The time of `count` passes in a thread pool, by the session's own clock if it has one. It is behind a pointer, so
/// that the pool's part is compiled once. An incomplete pass, for example if a backend declines in the middle, throws
/// [`Broken`].
fn timed(pool: &rayon::ThreadPool, count: u32, solve: &mut (dyn FnMut() -> Passed + Send)) -> Duration {
    pool.install(|| {
        let mut total = Duration::ZERO;
        for _ in 0..count {
            let start = Instant::now();
            let passed = solve();
            let elapsed = start.elapsed();
            total += passed.own.map_or(elapsed, |[before, after]| Duration::from_nanos(after - before));
            if !passed.done {
                let message = "the answer was broken off while it was timed".to_owned();
                Broken { class: Class::Declined, check: "time", message }.throw();
            }
        }
        total
    })
}

struct Passes<'a, B: Backend + 'static, T: Task> {
    solver: &'a OnTask<B, T>,
    /// The session; `None` if it contains vertices that the last pass constructed.
    session: Option<B::Session<'a, Off>>,
    scene: &'a Scene,
    content: &'a dyn Content,
    pool: rayon::ThreadPool,
    answer: T::Answer,
}

impl<B: Backend + 'static, T: Task> Stopwatch for Passes<'_, B, T> {
    fn pass(&mut self) -> Duration {
        self.passes(1)
    }

    fn passes(&mut self, count: u32) -> Duration {
        if self.solver.task.constructs() {
            // The next pass would find the last pass's vertices ready.
            return (0..count)
                .map(|_| {
                    let time = self.on_one_session(1);
                    self.session = None;
                    time
                })
                .sum();
        }
        self.on_one_session(count)
    }

    fn phases(&mut self) -> Vec<Phase> {
        let Passes { solver, session, scene, content, pool, .. } = self;
        let content = solver.content(*content);
        let constructs = solver.task.constructs();
        if constructs {
            // The vertices of a pass would be found ready.
            *session = None;
        }
        let session = session.get_or_insert_with(|| solver.prepared(scene));
        // The clock of a session with its own clock does not cover the algorithm's parts.
        let phases = match session.own_nanoseconds() {
            None => pool.install(|| solver.task.asking(session, content)),
            Some(_) => Vec::new(),
        };
        if constructs {
            self.session = None;
        }
        phases
    }

    fn digest(&self) -> u64 {
        self.answer.digest()
    }
}

impl<B: Backend + 'static, T: Task> Passes<'_, B, T> {
    fn on_one_session(&mut self, count: u32) -> Duration {
        let Passes { solver, session, scene, content, pool, answer } = self;
        let content = solver.content(*content);
        let session = session.get_or_insert_with(|| solver.prepared(scene));
        let never = std::sync::atomic::AtomicBool::new(false);
        let quiet = |_: u64| {};
        let watch = Watch::new(&never, None, &quiet);
        let how = How { purpose: Purpose::Use, watch: &watch };
        timed(pool, count, &mut || {
            let before = session.own_nanoseconds();
            let done = solver.task.solve(session, black_box(content), &how, answer);
            black_box(&mut *answer);
            let own = before.zip(session.own_nanoseconds()).map(|(before, after)| [before, after]);
            Passed { done: done.is_ok(), own }
        })
    }
}

/// Queries of one predicate, timed without an algorithm.
struct Queries<'a, P> {
    session: P,
    queries: &'a QuerySet,
    interface: Interface,
    pool: rayon::ThreadPool,
    rounds: Rounds,
    /// The vertices of the queries that are timed together, in the order of the rounds.
    args: Vec<Vertex>,
}

impl<P: Predicates> Stopwatch for Queries<'_, P> {
    fn pass(&mut self) -> Duration {
        self.passes(1)
    }

    fn passes(&mut self, count: u32) -> Duration {
        let Queries { session, queries, interface, pool, rounds, args } = self;
        let session = &*session;
        let question = queries.question();
        pool.install(|| {
            rounds.time(count, |order, out| {
                let asked = match order {
                    None => queries.flat(),
                    Some(order) => {
                        arrange(queries, order, args);
                        &**args
                    }
                };
                let before = session.own_nanoseconds();
                let start = Instant::now();
                match interface {
                    Interface::Single => question.ask_singly(session, black_box(asked), out),
                    Interface::Batch | Interface::Loop | Interface::Whole => {
                        question.ask_batch(session, black_box(asked), out);
                    }
                }
                black_box(&mut *out);
                let elapsed = start.elapsed();
                let own = before.zip(session.own_nanoseconds());
                own.map_or(elapsed, |(before, after)| Duration::from_nanos(after - before))
            })
        })
    }

    fn digest(&self) -> u64 {
        self.rounds.digest()
    }
}

/// Copies the vertices of queries in this order.
fn arrange(queries: &QuerySet, order: &[u32], args: &mut Vec<Vertex>) {
    fn copy<const N: usize>(from: &[Vertex], order: &[u32], to: &mut [Vertex]) {
        let from = from.as_chunks::<N>().0;
        to.as_chunks_mut::<N>().0.iter_mut().zip(order).for_each(|(to, &at)| *to = from[at as usize]);
    }
    let arity = queries.kind().arity();
    args.resize(order.len() * arity, Vertex::input(0));
    match arity {
        2 => copy::<2>(queries.flat(), order, args),
        3 => copy::<3>(queries.flat(), order, args),
        4 => copy::<4>(queries.flat(), order, args),
        _ => copy::<5>(queries.flat(), order, args),
    }
}
