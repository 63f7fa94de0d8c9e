//! One loaded scene with the truth about it, ready for one backend after another.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use predicament_corpus::{LoadedScene, Work};
use predicament_predicates::{QuerySet, Sign, Vertex};

use crate::contacts::ContactsCase;
use crate::cubes::CubesCase;
use crate::interval::IntervalCase;
use crate::locate::LocateCase;
use crate::signs::{self, Budget, SignCase};
use crate::{Class, Contestant, Outcome, Stop, Watch};

/// A scene with the truth about it.
pub struct Case<'a> {
    loaded: &'a LoadedScene,
    truth: Truth<'a>,
}

/// What is true.
pub enum Truth<'a> {
    /// Exact signs.
    Signs {
        /// What is asked.
        queries: &'a QuerySet,
        /// The answers, by the judge.
        signs: Vec<Sign>,
    },
    /// Exact cells.
    Interval(Box<IntervalCase<'a>>),
    /// Exact mass properties.
    Cubes(Box<CubesCase<'a>>),
    /// Exact locations.
    Locate(Box<LocateCase<'a>>),
    /// Exact contacts.
    Contacts(Box<ContactsCase<'a>>),
}

/// A scene whose author and the judge disagree: one of the two is wrong, and
/// nothing is compared until a person has looked.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Dispute {
    /// How many signs differ.
    pub count: usize,
    /// The first one, in words.
    pub first: String,
}

impl std::fmt::Display for Dispute {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} of the data's own signs differ from the exact ones, first {}", self.count, self.first)
    }
}

impl<'a> Case<'a> {
    /// Works out the truth.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    pub fn new(loaded: &'a LoadedScene, watch: &Watch) -> Result<Case<'a>, Stop> {
        let truth = match &loaded.work {
            Work::Signs(queries) => Truth::Signs { queries, signs: signs::truth(&loaded.scene, queries, watch)? },
            Work::Locate { map, probes } => {
                let probes: Vec<Vertex> = probes.iter().map(|probe| probe.vertex).collect();
                Truth::Locate(Box::new(LocateCase::new(&loaded.scene, map, probes, watch)?))
            }
            Work::Interval { axis, cells, probes } => {
                Truth::Interval(Box::new(IntervalCase::new(&loaded.scene, *axis, cells, probes, watch)?))
            }
            Work::Cubes { .. } => Truth::Cubes(Box::new(CubesCase::new(&loaded.scene, watch)?)),
            Work::Contacts { a, b } => Truth::Contacts(Box::new(ContactsCase::new(&loaded.scene, a, b, watch)?)),
        };
        Ok(Case { loaded, truth })
    }

    /// The scene.
    #[must_use]
    pub fn loaded(&self) -> &'a LoadedScene {
        self.loaded
    }

    /// The truth.
    #[must_use]
    pub fn truth(&self) -> &Truth<'a> {
        &self.truth
    }

    /// Holds the signs that came with the data, if any, against the judge's.
    #[must_use]
    pub fn dispute(&self) -> Option<Dispute> {
        let (Truth::Signs { queries, signs }, Some(expected)) = (&self.truth, &self.loaded.expected) else {
            return None;
        };
        let mut wrong = (0..signs.len()).filter(|&i| signs[i] != expected[i]).peekable();
        let &first = wrong.peek()?;
        let first = format!(
            "{} at query {first}: the data say {}, the judge {}",
            queries.question().describe(queries.args(first)),
            expected[first],
            signs[first]
        );
        Some(Dispute { count: wrong.count(), first })
    }

    /// Runs one backend. A panic is a finding about that backend and stays here.
    ///
    /// # Errors
    /// [`Stop::Interrupted`]; a timeout is an outcome.
    pub fn run(&self, contestant: &dyn Contestant, budget: Budget, watch: &Watch) -> Result<Outcome, Stop> {
        let queries = self.loaded.work.len() as u64;
        let ran = catch_unwind(AssertUnwindSafe(|| match &self.truth {
            Truth::Signs { queries, signs } => {
                let case = SignCase { scene: &self.loaded.scene, queries, truth: signs };
                contestant.run_signs(&case, budget, watch)
            }
            Truth::Interval(case) => contestant.run_interval(case, budget, watch),
            Truth::Cubes(case) => contestant.run_cubes(case, watch),
            Truth::Locate(case) => contestant.run_locate(case, budget, watch),
            Truth::Contacts(case) => contestant.run_contacts(case, budget, watch),
        }));
        match ran {
            Ok(Err(Stop::Timeout)) => {
                Ok(Outcome::of_scene(queries, Class::Timeout, "time limit", "took too long".to_owned()))
            }
            Ok(done) => done,
            Err(payload) => Ok(Outcome::of_scene(queries, Class::Panic, "panic", message(payload.as_ref()))),
        }
    }
}

/// What a panic said, in one line.
fn message(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    let text = text.or_else(|| payload.downcast_ref::<String>().cloned());
    text.unwrap_or_else(|| "no message".to_owned()).replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Entry, roster};
    use predicament_corpus::{Cache, Level, Library};
    use predicament_predicates::{
        Axis, Backend, Contract, Declined, Plane, PredicateKind, Predicates, Scene, Tally, ZeroMeaning,
    };
    use std::sync::atomic::AtomicBool;

    /// Answers that everything is positive, or panics at the third query.
    struct Stub {
        panics: bool,
    }

    struct Session<'s> {
        scene: &'s Scene,
        panics: bool,
    }

    impl Backend for Stub {
        type Session<'s, T: Tally + 's> = Session<'s>;

        fn name(&self) -> String {
            "stub".to_owned()
        }

        fn contract(&self, _: PredicateKind) -> Contract {
            Contract { zero: ZeroMeaning::Exact, proved: false }
        }

        fn stages(&self) -> &'static [&'static str] {
            &["stub"]
        }

        fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Session<'s>, Declined> {
            Ok(Session { scene, panics: self.panics })
        }
    }

    impl Predicates for Session<'_> {
        fn scene(&self) -> &Scene {
            self.scene
        }

        fn compare(&self, _: Axis, _: Vertex, _: Vertex) -> Sign {
            Sign::Positive
        }

        fn orient2d(&self, _: Plane, _: Vertex, _: Vertex, c: Vertex) -> Sign {
            assert!(!self.panics || c.index() < 3, "third\nquery");
            Sign::Positive
        }

        fn orient3d(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
            Sign::Positive
        }

        fn incircle(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
            Sign::Positive
        }

        fn insphere(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
            Sign::Positive
        }
    }

    fn load(name: &str) -> LoadedScene {
        let library = Library::embedded().unwrap();
        let scenes = library.suites().iter().flat_map(|suite| &suite.scenes);
        let scene = scenes.into_iter().find(|scene| scene.name == name).expect("a scene of the corpora");
        scene.load(Level::Quick, &Cache::new("nowhere")).unwrap()
    }

    fn run(loaded: &LoadedScene, stub: Stub) -> Outcome {
        run_any(loaded, &Entry::new(stub))
    }

    fn run_any(loaded: &LoadedScene, contestant: &dyn Contestant) -> Outcome {
        let (cancel, progress) = (AtomicBool::new(false), |_: u64| {});
        let watch = Watch::new(&cancel, None, &progress);
        Case::new(loaded, &watch).unwrap().run(contestant, Budget::QUICK, &watch).unwrap()
    }

    #[test]
    fn constructed_vertices_are_judged_declined_or_found_to_be_rounded() {
        for name in ["kite", "kite-order", "pyramid", "lpi-tpi-near-orient3d"] {
            let loaded = load(name);
            let outcome = |backend: &str| run_any(&loaded, roster::backend(backend).unwrap().as_ref());
            let exact = outcome("exact");
            assert_eq!((exact.counts.get(Class::Agree), exact.counts.findings()), (exact.queries, 0), "{name}");
            let sos = outcome("sos");
            assert_eq!(sos.counts.get(Class::Agree) + sos.counts.get(Class::TieBroken), sos.queries, "{name}");
            assert!(sos.counts.get(Class::TieBroken) > 0 && sos.counts.findings() == 0, "{name}");
            for backend in ["sos:edelsbrunner-mucke", "sos:per-mesh", "tolerance", "fault:sos-swapped-term"] {
                let declined = outcome(backend).counts;
                assert_eq!((declined.get(Class::Declined), declined.findings()), (1, 1), "{backend} on {name}");
            }
            for backend in ["naive", "naive:first", "shewchuk", "fault:exact-rounded-vertex"] {
                let outcome = outcome(backend);
                assert!(outcome.counts.findings() > 0, "{backend} on {name}");
                assert!(outcome.findings.iter().any(|finding| finding.query.contains('c')), "{backend} on {name}");
                assert_eq!(outcome.counts.get(Class::Panic), 0, "{backend} on {name}");
            }
            for fault in ["exact-halved-filter", "exact-one-limb", "exact-flushed"] {
                assert_eq!(outcome(&format!("fault:{fault}")).counts.findings(), 0, "{fault} on {name}");
            }
        }
    }

    #[test]
    fn a_panic_is_a_finding_about_the_backend() {
        let outcome = run(&load("kettner-a1"), Stub { panics: true });
        assert_eq!(outcome.counts.get(Class::Panic), 1);
        assert_eq!(outcome.counts.findings(), 1);
        assert!(outcome.findings[0].got.contains("third query"), "{:?}", outcome.findings);
    }

    #[test]
    fn an_answer_that_is_always_the_same_is_flipped_inconsistent_and_no_zero() {
        let loaded = load("kettner-b2");
        let outcome = run(&loaded, Stub { panics: false });
        assert!(outcome.counts.get(Class::SignFlip) > 0);
        assert!(outcome.counts.get(Class::Inconsistent) > 0);
        assert_eq!(outcome.counts.get(Class::Overreach), 0, "it never says zero");
        let classed: u64 =
            [Class::Agree, Class::SignFlip, Class::MissedZero].map(|class| outcome.counts.get(class)).iter().sum();
        assert!(classed <= outcome.queries && outcome.queries == loaded.work.len() as u64);
    }

    #[test]
    fn signs_that_came_with_the_data_are_held_against_the_judge() {
        let mut loaded = load("kettner-b2");
        let (cancel, progress) = (AtomicBool::new(false), |_: u64| {});
        let watch = Watch::new(&cancel, None, &progress);
        let Truth::Signs { signs, .. } = Case::new(&loaded, &watch).unwrap().truth else { panic!("a sign scene") };
        loaded.expected = Some(signs.clone());
        assert_eq!(Case::new(&loaded, &watch).unwrap().dispute(), None);
        let wrong: Vec<Sign> = signs.iter().enumerate().map(|(i, &sign)| if i == 4 { -sign } else { sign }).collect();
        loaded.expected = Some(wrong);
        let dispute = Case::new(&loaded, &watch).unwrap().dispute().unwrap();
        assert_eq!(dispute.count, 1);
        assert!(dispute.first.contains("at query 4"), "{dispute}");
    }
}
