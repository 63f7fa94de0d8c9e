//! Backends picked by name at run time.
//!
//! Hot loops are generic over the backend, the command line is not. This trait
//! is where the two meet: one dynamic call per scene, none per query.

use std::hint::black_box;
use std::time::{Duration, Instant};

use predicament_algorithms::contacts::Contacts;
use predicament_algorithms::cube_union::Mass;
use predicament_algorithms::polygon_locate::Locations;
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{
    Backend, Contract, Off, PredicateKind, Predicates, QuerySet, Question, Scene, Sign, Vertex,
};

use crate::contacts::{self, ContactsCase};
use crate::cubes::{self, CubesCase};
use crate::interval::{self, Cells, IntervalCase};
use crate::locate::{self, LocateCase};
use crate::signs::{self, Budget, SignCase};
use crate::{Outcome, Stop, Watch};
use predicament_judge::TieJudge;

/// A backend that the command line can pick.
pub trait Contestant: Sync {
    /// The full name, with parameters.
    fn name(&self) -> String;

    /// What it promises.
    fn contract(&self, kind: PredicateKind) -> Contract;

    /// Runs it on a sign scene.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    fn run_signs(&self, case: &SignCase, budget: Budget, watch: &Watch) -> Result<Outcome, Stop>;

    /// Runs it on the cells of a line.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    fn run_interval(&self, case: &IntervalCase, budget: Budget, watch: &Watch) -> Result<Outcome, Stop>;

    /// Runs it on a union of cubes.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    fn run_cubes(&self, case: &CubesCase, watch: &Watch) -> Result<Outcome, Stop>;

    /// Runs it on a map.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    fn run_locate(&self, case: &LocateCase, budget: Budget, watch: &Watch) -> Result<Outcome, Stop>;

    /// Runs it on two complexes.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    fn run_contacts(&self, case: &ContactsCase, budget: Budget, watch: &Watch) -> Result<Outcome, Stop>;

    /// Prepares a scene and hands the session over, where what is asked need not be fast.
    ///
    /// # Errors
    /// The reason, where the backend declines; then nobody is handed anything.
    fn with_session(&self, scene: &Scene, ask: &mut dyn FnMut(&dyn Predicates)) -> Result<(), String>;

    /// The independent judge of how it breaks ties, if it does.
    fn tie_judge(&self) -> Option<&TieJudge>;

    /// All answers to a query set, in order.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn answers(&self, scene: &Scene, queries: &QuerySet) -> Result<Vec<Sign>, String>;

    /// The cells of all probes of a line, in order.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn cells(&self, case: &IntervalCase) -> Result<Vec<Cells>, String>;

    /// The mass properties of a union of cubes.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn cube_union(&self, case: &CubesCase) -> Result<Mass, String>;

    /// Where all probes of a map lie, in order.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn locations(&self, case: &LocateCase) -> Result<Locations, String>;

    /// All contacts of two complexes of a scene, which has to know the lengths of their primitives.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn contacts(&self, scene: &Scene, complexes: [&Complex; 2]) -> Result<Contacts, String>;

    /// Prepares a query set for timing.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn time_signs<'a>(&'a self, scene: &'a Scene, queries: &'a QuerySet) -> Result<Box<dyn Stopwatch + 'a>, String>;

    /// Prepares the cells of a line for timing.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn time_interval<'a>(&'a self, case: &'a IntervalCase) -> Result<Box<dyn Stopwatch + 'a>, String>;

    /// Prepares a union of cubes for timing.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn time_cubes<'a>(&'a self, case: &'a CubesCase) -> Result<Box<dyn Stopwatch + 'a>, String>;

    /// Prepares a map for timing.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn time_locate<'a>(&'a self, case: &'a LocateCase) -> Result<Box<dyn Stopwatch + 'a>, String>;

    /// Prepares two complexes for timing on so many threads.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn time_contacts<'a>(&'a self, case: &'a ContactsCase, threads: usize) -> Result<Box<dyn Stopwatch + 'a>, String>;

    /// What it makes of one pair of simplices, in words.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn contact(&self, case: &ContactsCase, pair: [Simplex; 2]) -> Result<String, String>;

    /// The cells of one vertex, in words.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn cells_of_one(&self, case: &IntervalCase, vertex: Vertex) -> Result<String, String>;

    /// Where one vertex of a map lies, in words.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn locate_one(&self, case: &LocateCase, vertex: Vertex) -> Result<String, String>;

    /// One query, asked alone, with everything that can be told about it.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    fn explain(&self, scene: &Scene, question: Question, args: &[Vertex]) -> Result<Explanation, String>;
}

/// A prepared session that can be timed again and again, so that backends can take turns.
pub trait Stopwatch {
    /// Answers everything once, on this thread (contacts: on those it was
    /// prepared for), and says how long it took.
    /// Preparing the scene is not in it.
    fn pass(&mut self) -> Duration;

    /// A digest of the last pass' answers: equal digests, equal answers (with
    /// the usual odds for 64 bits).
    fn digest(&self) -> u64;
}

/// What can be told about one answer.
#[derive(Clone, PartialEq, Debug)]
pub struct Explanation {
    /// The answer.
    pub sign: Sign,
    /// The stage that settled it.
    pub stage: Option<&'static str>,
    /// The floating-point determinant that it stood on, if any.
    pub estimate: Option<f64>,
    /// The band, for backends that have one: lower, width, upper.
    pub band: Option<[f64; 3]>,
}

/// A backend with what the oracle has to know about it.
pub struct Entry<B> {
    backend: B,
    tie_judge: Option<Box<TieJudge>>,
}

impl<B: Backend> Entry<B> {
    /// A backend as it is.
    pub fn new(backend: B) -> Entry<B> {
        Entry { backend, tie_judge: None }
    }

    /// A backend that breaks ties, with an independent judge of how it should.
    pub fn breaking_ties(backend: B, judge: impl Fn(&Scene, Question, &[Vertex]) -> Sign + Sync + 'static) -> Entry<B> {
        Entry { backend, tie_judge: Some(Box::new(judge)) }
    }
}

impl<B: Backend> Contestant for Entry<B> {
    fn name(&self) -> String {
        self.backend.name()
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        self.backend.contract(kind)
    }

    fn run_signs(&self, case: &SignCase, budget: Budget, watch: &Watch) -> Result<Outcome, Stop> {
        signs::run(&self.backend, self.tie_judge.as_deref(), case, budget, watch)
    }

    fn run_interval(&self, case: &IntervalCase, budget: Budget, watch: &Watch) -> Result<Outcome, Stop> {
        interval::run(&self.backend, case, budget, watch)
    }

    fn run_cubes(&self, case: &CubesCase, watch: &Watch) -> Result<Outcome, Stop> {
        cubes::run(&self.backend, case, watch)
    }

    fn run_locate(&self, case: &LocateCase, budget: Budget, watch: &Watch) -> Result<Outcome, Stop> {
        locate::run(&self.backend, case, budget, watch)
    }

    fn run_contacts(&self, case: &ContactsCase, budget: Budget, watch: &Watch) -> Result<Outcome, Stop> {
        contacts::run(&self.backend, self.tie_judge.as_deref(), case, budget, watch)
    }

    fn with_session(&self, scene: &Scene, ask: &mut dyn FnMut(&dyn Predicates)) -> Result<(), String> {
        let session = self.backend.prepare(scene, Off).map_err(|declined| declined.to_string())?;
        ask(&session);
        Ok(())
    }

    fn tie_judge(&self) -> Option<&TieJudge> {
        self.tie_judge.as_deref()
    }

    fn answers(&self, scene: &Scene, queries: &QuerySet) -> Result<Vec<Sign>, String> {
        signs::answers(&self.backend, scene, queries)
    }

    fn cells(&self, case: &IntervalCase) -> Result<Vec<Cells>, String> {
        interval::found(&self.backend, case)
    }

    fn cube_union(&self, case: &CubesCase) -> Result<Mass, String> {
        cubes::found(&self.backend, case)
    }

    fn locations(&self, case: &LocateCase) -> Result<Locations, String> {
        locate::locations(&self.backend, case)
    }

    fn contacts(&self, scene: &Scene, complexes: [&Complex; 2]) -> Result<Contacts, String> {
        contacts::registered(&self.backend, scene, complexes)
    }

    fn time_signs<'a>(&'a self, scene: &'a Scene, queries: &'a QuerySet) -> Result<Box<dyn Stopwatch + 'a>, String> {
        let session = self.backend.prepare(scene, Off).map_err(|declined| declined.to_string())?;
        session.supports(queries.kind()).map_err(|declined| declined.to_string())?;
        Ok(Box::new(SignWatch { session, queries, out: vec![Sign::Zero; queries.len()] }))
    }

    fn time_interval<'a>(&'a self, case: &'a IntervalCase) -> Result<Box<dyn Stopwatch + 'a>, String> {
        interval::stopwatch(&self.backend, case)
    }

    fn time_cubes<'a>(&'a self, case: &'a CubesCase) -> Result<Box<dyn Stopwatch + 'a>, String> {
        cubes::stopwatch(&self.backend, case)
    }

    fn time_locate<'a>(&'a self, case: &'a LocateCase) -> Result<Box<dyn Stopwatch + 'a>, String> {
        locate::stopwatch(&self.backend, case)
    }

    fn time_contacts<'a>(&'a self, case: &'a ContactsCase, threads: usize) -> Result<Box<dyn Stopwatch + 'a>, String> {
        contacts::stopwatch(&self.backend, case, threads)
    }

    fn contact(&self, case: &ContactsCase, pair: [Simplex; 2]) -> Result<String, String> {
        case.ask(&self.backend, pair)
    }

    fn cells_of_one(&self, case: &IntervalCase, vertex: Vertex) -> Result<String, String> {
        case.locate_one(&self.backend, vertex)
    }

    fn locate_one(&self, case: &LocateCase, vertex: Vertex) -> Result<String, String> {
        case.locate_one(&self.backend, vertex)
    }

    fn explain(&self, scene: &Scene, question: Question, args: &[Vertex]) -> Result<Explanation, String> {
        let session = self.backend.prepare(scene, Off).map_err(|declined| declined.to_string())?;
        session.supports(question.kind()).map_err(|declined| declined.to_string())?;
        Ok(Explanation {
            sign: question.ask(&session, args),
            stage: signs::stage_of(&self.backend, scene, question, args),
            estimate: session.estimate(question, args),
            band: session.band(question).map(|band| [band.lower, band.width, band.upper]),
        })
    }
}

struct SignWatch<'a, P> {
    session: P,
    queries: &'a QuerySet,
    out: Vec<Sign>,
}

impl<P: Predicates> Stopwatch for SignWatch<'_, P> {
    fn pass(&mut self) -> Duration {
        let start = Instant::now();
        black_box(self.queries).ask_batch(&self.session, 0..self.queries.len(), &mut self.out);
        black_box(&mut self.out);
        start.elapsed()
    }

    fn digest(&self) -> u64 {
        digest(self.out.iter().map(|sign| sign.as_i8().cast_unsigned()))
    }
}

/// The digest of answers given as signs, for comparison with [`Stopwatch::digest`].
#[must_use]
pub fn digest_of(signs: &[Sign]) -> u64 {
    digest(signs.iter().map(|sign| sign.as_i8().cast_unsigned()))
}

/// 64 bits of FNV-1a: guards against a mix-up, not against an adversary.
pub(crate) fn digest(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
