//! Backends that do not give the same answer twice: tests for the law `repeat`.
//!
//! `selftest` plants one of them, [`Unsteady::Again`]: it depends on nothing but the questions, so that a scorecard is
//! reproducible.

use std::collections::HashSet;
use std::hash::{BuildHasher, RandomState};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, OnceLock};
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
    /// The question's own past: the session has been asked before.
    Again,
    /// A random number of the process.
    Process,
    /// The numbers of the vertices.
    Ids,
}

impl Unsteady {
    /// All kinds.
    pub const ALL: [Unsteady; 7] = [
        Unsteady::Global,
        Unsteady::Time,
        Unsteady::Threads,
        Unsteady::Order,
        Unsteady::Again,
        Unsteady::Process,
        Unsteady::Ids,
    ];

    /// The fault's name after `fault:`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Unsteady::Global => "unsteady-global",
            Unsteady::Time => "unsteady-time",
            Unsteady::Threads => "unsteady-threads",
            Unsteady::Order => "unsteady-order",
            Unsteady::Again => "unsteady-again",
            Unsteady::Process => "unsteady-process",
            Unsteady::Ids => "unsteady-ids",
        }
    }

    /// True if the session reverses its answer to a question.
    fn reverses(self, args: &[Vertex], session: &Session<'_>) -> bool {
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
            Unsteady::Order => one_in(61, session.before.swap(sum(args), Relaxed)),
            Unsteady::Again => {
                let is_new = session.asked.lock().is_ok_and(|mut asked| asked.insert(args.to_vec()));
                !is_new && one_in(7, sum(args))
            }
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
        Ok(Session {
            kind: *self,
            exact: Exact.prepare(scene, Off)?,
            before: AtomicU64::new(1),
            asked: Mutex::default(),
        })
    }
}

/// An exact session that sometimes reverses an answer.
pub struct Session<'s> {
    kind: Unsteady,
    exact: predicament_exact::Session<'s, Off>,
    /// A hash of the previous question.
    before: AtomicU64,
    /// The vertices of all questions.
    asked: Mutex<HashSet<Vec<Vertex>>>,
}

impl Session<'_> {
    fn answer<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let exact = question.ask(&self.exact, &args);
        if self.kind.reverses(&args, self) { -exact } else { exact }
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
