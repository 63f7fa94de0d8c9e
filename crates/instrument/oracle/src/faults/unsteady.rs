//! Backends that do not give the same answer twice: tests for the law `repeat`.
//!
//! They are not part of `selftest`, whose checks ask each question once.

use std::hash::{BuildHasher, RandomState};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::SystemTime;

use predicament_exact::Exact;
use predicament_predicates::{
    Backend, Contract, Declined, Off, PredicateKind, Predicates, Question, Scene, Sign, Tally, Vertex, answer_by,
};

/// The dependence of a backend on something besides the points and the question.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unsteady {
    /// A global: the number of questions that the process has asked.
    Global,
    /// The clock.
    Time,
    /// The number of threads.
    Threads,
    /// The question that the session was asked before.
    Order,
    /// A random number of the process.
    Process,
    /// The numbers of the vertices.
    Ids,
}

impl Unsteady {
    /// All kinds.
    pub const ALL: [Unsteady; 6] =
        [Unsteady::Global, Unsteady::Time, Unsteady::Threads, Unsteady::Order, Unsteady::Process, Unsteady::Ids];

    /// The fault's name after `fault:`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Unsteady::Global => "unsteady-global",
            Unsteady::Time => "unsteady-time",
            Unsteady::Threads => "unsteady-threads",
            Unsteady::Order => "unsteady-order",
            Unsteady::Process => "unsteady-process",
            Unsteady::Ids => "unsteady-ids",
        }
    }

    /// True if the answer to a question is reversed. `before` is the hash of the session's previous question.
    fn reverses(self, args: &[Vertex], before: u64) -> bool {
        static ASKED: AtomicU64 = AtomicU64::new(0);
        static SEED: OnceLock<u64> = OnceLock::new();
        let one_in = |n: u64, of: u64| of.is_multiple_of(n);
        match self {
            Unsteady::Global => one_in(61, ASKED.fetch_add(1, Relaxed)),
            Unsteady::Time => {
                let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
                one_in(7, since.map_or(0, |since| u64::from(since.subsec_nanos() / 16)))
            }
            Unsteady::Threads => rayon::current_num_threads() > 1 && one_in(61, sum(args)),
            Unsteady::Order => one_in(61, before),
            Unsteady::Process => {
                let seed = SEED.get_or_init(|| RandomState::new().hash_one(0));
                one_in(7, sum(args).wrapping_mul(*seed | 1) >> 32)
            }
            Unsteady::Ids => one_in(61, sum(args)),
        }
    }
}

/// A number that depends on the vertices of a question.
fn sum(args: &[Vertex]) -> u64 {
    args.iter().fold(0, |sum, v| sum * 31 + v.index() as u64)
}

impl Backend for Unsteady {
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        format!("fault:{}", Unsteady::name(*self))
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        Contract { proved: false, ..Exact.contract(kind) }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["unsteady"]
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Session<'s>, Declined> {
        Ok(Session { kind: *self, exact: Exact.prepare(scene, Off)?, before: AtomicU64::new(1) })
    }
}

/// An exact session that sometimes reverses an answer.
pub struct Session<'s> {
    kind: Unsteady,
    exact: predicament_exact::Session<'s, Off>,
    before: AtomicU64,
}

impl Session<'_> {
    fn answer<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let exact = question.ask(&self.exact, &args);
        let before = self.before.swap(sum(&args), Relaxed);
        if self.kind.reverses(&args, before) { -exact } else { exact }
    }
}

impl Predicates for Session<'_> {
    fn scene(&self) -> &Scene {
        self.exact.scene()
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.exact.supports(kind)
    }

    answer_by!(answer);
}
