//! Tests of hunts on backends that are known to be wrong, and on one that is right.

use std::sync::atomic::AtomicBool;

use predicament_corpus::Library;
use predicament_predicates::PredicateKind;
use predicament_tasks::{Class, Contestant, Watch};

use super::{Hunt, Options, Quarry, Seed, State, seeds};
use crate::Wanted;

static GO_ON: AtomicBool = AtomicBool::new(false);

/// The settings of a test hunt.
#[derive(Clone)]
struct Order {
    task: &'static str,
    backend: &'static str,
    wanted: Wanted,
    seeds: Vec<Seed>,
    finds: usize,
}

impl Order {
    fn new(task: &'static str, backend: &'static str, class: Option<Class>) -> Order {
        Order { task, backend, wanted: Wanted { class, check: None }, seeds: Vec::new(), finds: 10 }
    }

    /// The state after a number of evaluations, starting from an earlier state.
    fn hunt(&self, evaluations: u64, state: State) -> State {
        let quiet = |_: u64| {};
        let watch = Watch::new(&GO_ON, None, &quiet);
        let backend = predicament_bundle::backend(self.backend).unwrap();
        let task = predicament_bundle::tasks().iter().copied().find(|task| task.name() == self.task).unwrap();
        let shown_by: Vec<&dyn Contestant> = vec![backend.as_ref()];
        let quarry = Quarry {
            vocabulary: predicament_bundle::vocabulary(),
            task,
            budget: Quarry::budget(&self.wanted),
            wanted: self.wanted.clone(),
            shown_by,
            not_by: Vec::new(),
            watch: &watch,
            limit: None,
        };
        let options = Options { seed: 1, finds: self.finds, shrinking: 500, shapes: true };
        let mut hunt = Hunt::new(quarry, options, self.seeds.clone(), state).unwrap();
        while !hunt.is_done() && hunt.state().evaluations < evaluations {
            hunt.generation(&|| 0.0).unwrap();
        }
        hunt.saved()
    }
}

#[test]
fn a_sign_flip_of_naive_is_found_soon_and_shrunk() {
    let order = Order { finds: 1, ..Order::new("orient2d", "naive", Some(Class::SignFlip)) };
    let state = order.hunt(2000, State::default());
    let [find] = state.finds.as_slice() else { panic!("{} finds in {}", state.finds.len(), state.evaluations) };
    assert_eq!((find.class.as_str(), find.check.as_str()), ("sign_flip", "sign"));
    assert!(find.pieces[1] <= find.pieces[0]);
    assert!(super::read(predicament_bundle::vocabulary(), &find.shrunk).is_ok(), "{}", find.shrunk);
    assert!(find.story.contains("shape"), "{}", find.story);
}

/// A number of evaluations for several generations, the first of which have finds.
const MANY: u64 = 150;

#[test]
fn the_number_of_threads_changes_nothing_and_a_stop_neither() {
    let order = Order::new("orient2d", "shewchuk", None);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| order.hunt(MANY, State::default()))
    };
    let (one, three) = (on(1), on(3));
    assert!(!one.finds.is_empty());
    assert_eq!(one, three);
    let stopped = order.hunt(MANY / 3, State::default());
    assert!(stopped.generations < one.generations);
    assert_eq!(order.hunt(MANY, stopped), one, "a resumed hunt is equal to one that was not stopped");
}

/// Some tasks read scenes in another order than they are written: edges that are turned, triangles that occur twice.
#[test]
fn what_is_derived_is_the_same_from_memory_and_from_a_file() {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let seeds = seeds(library.suites().unwrap(), "contacts2d").unwrap();
    let order = Order { seeds, finds: 40, ..Order::new("contacts2d", "epsilon:1e-4", None) };
    let whole = order.hunt(MANY, State::default());
    let stopped = order.hunt(MANY / 2, State::default());
    assert!(stopped.generations < whole.generations && stopped != whole);
    let text = serde_json::to_string(&stopped).unwrap();
    assert_eq!(order.hunt(MANY, serde_json::from_str(&text).unwrap()), whole);
}

#[test]
fn a_right_backend_gives_no_find() {
    for kind in [PredicateKind::Orient2d, PredicateKind::Insphere] {
        let state = Order::new(kind.name(), "exact", None).hunt(250, State::default());
        assert!(state.finds.is_empty(), "{:?}", state.finds);
        assert!(state.evaluations >= 250);
    }
}

/// A finding that a seed already shows is not a find.
#[test]
fn seeds_that_show_it_already_are_left_out() {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let seeds = seeds(&[library.suite("classics").unwrap()], "orient2d").unwrap();
    assert!(seeds.len() > 3 && seeds.iter().all(|seed| seed.spelled.points.len() <= 40));
    let order = Order { seeds, ..Order::new("orient2d", "naive", Some(Class::SignFlip)) };
    let state = order.hunt(1, State::default());
    assert!(state.known.iter().any(|name| name.starts_with("classics/kettner")), "{:?}", state.known);
}

#[test]
fn a_task_without_seeds_is_refused() {
    let quiet = |_: u64| {};
    let watch = Watch::new(&GO_ON, None, &quiet);
    let backend = predicament_bundle::backend("exact").unwrap();
    let task = predicament_bundle::tasks().iter().copied().find(|task| task.name() == "contacts2d").unwrap();
    let wanted = Wanted { class: None, check: None };
    let budget = Quarry::budget(&wanted);
    let (shown_by, not_by) = (vec![backend.as_ref()], Vec::new());
    let quarry = Quarry {
        vocabulary: predicament_bundle::vocabulary(),
        task,
        wanted,
        shown_by,
        not_by,
        budget,
        watch: &watch,
        limit: None,
    };
    let options = Options { seed: 1, finds: 1, shrinking: 1, shapes: true };
    assert!(Hunt::new(quarry, options, Vec::new(), State::default()).is_err());
}
