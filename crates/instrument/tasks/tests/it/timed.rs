//! Tests of timed queries of one predicate, by a backend that records its calls.

use std::collections::BTreeSet;
use std::sync::{Arc, Mutex};

use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_predicates::{
    Axis, Backend, Batches, Contract, Declined, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex,
    ZeroMeaning,
};
use predicament_records::Interface;
use predicament_tasks::signs::Signs;
use predicament_tasks::{Contestant, Entry};

/// The recorded calls: batches with their queries, and single queries.
#[derive(Default)]
struct Record {
    singles: Vec<[Vertex; 3]>,
    batches: Vec<Vec<[Vertex; 3]>>,
}

#[derive(Clone)]
struct Recorder {
    record: Arc<Mutex<Record>>,
    batches: Batches,
    /// True if the session has its own clock.
    has_clock: bool,
    /// The index of the single query from which answers differ.
    turns: usize,
}

impl Recorder {
    fn new(batches: Batches) -> Recorder {
        Recorder { record: Arc::default(), batches, has_clock: false, turns: usize::MAX }
    }
}

struct Session<'s> {
    of: &'s Recorder,
    scene: &'s Scene,
}

impl Predicates for Session<'_> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn compare(&self, _: Axis, _: Vertex, _: Vertex) -> Sign {
        unreachable!("nobody compares")
    }

    fn orient2d(&self, _: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let mut record = self.of.record.lock().unwrap();
        record.singles.push([a, b, c]);
        if record.singles.len() > self.of.turns { Sign::Negative } else { Sign::Positive }
    }

    fn orient3d(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("nobody asks about sides")
    }

    fn incircle(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("nobody asks about circles")
    }

    fn insphere(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("nobody asks about spheres")
    }

    fn orient2d_batch(&self, _: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        self.of.record.lock().unwrap().batches.push(queries.to_vec());
        out.fill(Sign::Positive);
    }

    fn own_nanoseconds(&self) -> Option<u64> {
        self.of.has_clock.then_some(0)
    }
}

impl Backend for Recorder {
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        "recorder".to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["record"]
    }

    fn batches(&self, _: PredicateKind) -> Batches {
        self.batches
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Session<'s>, Declined> {
        Ok(Session { of: self, scene })
    }
}

const QUERIES: usize = 20;

fn scene() -> LoadedScene {
    let generator = format!("[[generate]]\nfamily = \"uniform\"\ntask = \"orient2d\"\nn = {QUERIES}\n");
    let suite = Suite::parse(
        predicament_bundle::vocabulary(),
        "s.toml",
        &format!("title = \"t\"\n{generator}"),
        None,
        &Manifest::default(),
    );
    suite.unwrap().scenes[0].load(Level::Quick, &Cache::new("nowhere")).unwrap()
}

/// The passes of a recorder by an interface: the recorded calls, and the digests after each sample.
fn passes(recorder: &Recorder, interface: Interface, samples: &[u32]) -> Vec<u64> {
    let (scene, entry) = (scene(), Entry::new(recorder.clone()));
    let solver = entry.solver("orient2d").unwrap();
    let mut watch = solver.stopwatch(&scene.scene, scene.content.as_ref(), 1, interface).unwrap().unwrap();
    samples.iter().map(|&count| (watch.passes(count), watch.digest()).1).collect()
}

/// Every query of the scene.
fn all() -> BTreeSet<[Vertex; 3]> {
    (0..QUERIES).map(|at| [3 * at, 3 * at + 1, 3 * at + 2].map(Vertex::input)).collect()
}

#[test]
fn single_queries_are_asked_one_by_one_in_an_order_that_changes() {
    let recorder = Recorder::new(Batches::Own);
    let digests = passes(&recorder, Interface::Single, &[1, 3]);
    assert_eq!(digests[0], digests[1]);
    let record = recorder.record.lock().unwrap();
    assert_eq!((record.batches.len(), record.singles.len()), (0, 4 * QUERIES));
    let rounds: BTreeSet<&[[Vertex; 3]]> = record.singles.chunks(QUERIES).collect();
    assert_eq!(rounds.len(), 4, "an order that comes again can be learnt");
    assert!(rounds.iter().all(|round| round.iter().copied().collect::<BTreeSet<_>>() == all()));
}

#[test]
fn batches_are_one_call_in_an_order_that_changes() {
    let recorder = Recorder::new(Batches::Own);
    let digests = passes(&recorder, Interface::Batch, &[1, 3]);
    assert_eq!(digests[0], digests[1]);
    let record = recorder.record.lock().unwrap();
    assert!(record.singles.is_empty());
    assert_eq!(record.batches.iter().map(Vec::len).collect::<Vec<_>>(), [QUERIES, 3 * QUERIES]);
    let rounds: BTreeSet<&[[Vertex; 3]]> = record.batches.iter().flat_map(|batch| batch.chunks(QUERIES)).collect();
    assert_eq!(rounds.len(), 4, "an order that comes again can be learnt");
    assert!(rounds.iter().all(|round| round.iter().copied().collect::<BTreeSet<_>>() == all()));
}

#[test]
fn an_answer_that_changes_while_it_is_timed_changes_the_digest() {
    let honest = passes(&Recorder::new(Batches::Loop), Interface::Single, &[2]);
    let recorder = Recorder { turns: 2 * QUERIES - 1, ..Recorder::new(Batches::Loop) };
    assert_ne!(passes(&recorder, Interface::Single, &[2]), honest, "the last answer of the last round");
}

#[test]
fn who_has_which_interfaces() {
    let scene = scene();
    let content = scene.content.as_ref();
    let of = |recorder: Recorder| {
        let entry = Entry::new(recorder);
        let solver = entry.solver("orient2d").unwrap();
        let interfaces = solver.interfaces(content).into_iter();
        let is_timed = |by: &Interface| solver.stopwatch(&scene.scene, content, 1, *by).unwrap().is_some();
        interfaces.filter(is_timed).collect::<Vec<_>>()
    };
    assert_eq!(of(Recorder::new(Batches::Own)), [Interface::Single, Interface::Batch]);
    assert_eq!(of(Recorder::new(Batches::Loop)), [Interface::Single, Interface::Loop]);
    // A single query would be a message to another program.
    assert_eq!(of(Recorder { has_clock: true, ..Recorder::new(Batches::Own) }), [Interface::Batch]);
    assert_eq!(Entry::new(Recorder::new(Batches::Own)).batches(Signs::ORIENT2D.kind()), Batches::Own);
}
