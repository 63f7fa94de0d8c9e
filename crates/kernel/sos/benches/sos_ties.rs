//! The cost of ties: the exact backend against both schemes.
//!
//! Families of the corpus:
//! * `uniform`: no ties. The perturbation costs nothing extra here.
//! * `grid`: integers from 0 to 15. A few percent are ties, and floating point is exact: the cheapest answers, and the
//!   deepest terms.
//! * `degen`: only ties, in general position.
//!
//! And families of scenes of 2,048 points, which stay in the cache: `10 bits`, `30 bits`: integers of one line, plane,
//! circle or sphere. A query has any distinct vertices; in circles and spheres many points coincide. Doubles make no
//! error with 10 bits.
//!
//! Every query of the corpus has separate points and a random order of arguments, and there are more queries than a
//! branch predictor can learn; a pass takes the next few thousand of them. Before Criterion times the engines one after
//! another, they alternate once, pass by pass, and a line is printed with their times relative to the exact backend's.
//! On a busy machine only that line is reliable.

#[path = "../../exact/tests/it/common.rs"]
#[allow(dead_code)] // the tests use the rest
mod common;
#[path = "../../exact/benches/turns.rs"]
mod turns;

use std::cell::Cell;
use std::hint::black_box;
use std::time::Duration;

use common::Random;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use predicament_corpus::{Level, Suite};
use predicament_exact::Exact;
use predicament_formats::{Cache, Manifest};
use predicament_predicates::{
    Axis, Backend, Dimension, Off, Plane, PredicateKind, Predicates, Question, Scene, Sign, Vertex,
};
use predicament_sos::{Scheme, Session, Sos};
use predicament_tasks::signs::SignQueries;
use turns::{Engine, Turns};

/// The number of queries of a family, and of a pass.
const QUERIES: usize = 1 << 17;
const PASS: usize = 1 << 12;
/// The number of rounds over all queries.
const ROUNDS: usize = 3;

/// The queries of a family, with shuffled arguments.
fn queries<const N: usize>(kind: PredicateKind, family: &str) -> (Scene, Vec<[Vertex; N]>) {
    let text = format!(
        "title = \"ties\"\n[[generate]]\nfamily = \"{family}\"\ntask = \"{kind}\"\nn = {QUERIES}\nseed = 5\n\
         source = \"generated\"\nanalysis = \"What ties cost.\"\n"
    );
    let manifest = Manifest::default();
    let suite = Suite::parse(predicament_bundle::vocabulary(), "ties.toml", &text, None, &manifest).expect("a suite");
    let loaded = suite.scenes[0].load(Level::Quick, &Cache::new("")).expect("generated");
    let queries = &loaded.content::<SignQueries>().expect("a family of signs").queries;
    let mut random = Random(41);
    let queries = queries.flat().as_chunks::<N>().0.iter().map(|query| {
        let mut query = *query;
        for last in (1..N).rev() {
            query.swap(last, random.below(last + 1));
        }
        query
    });
    let queries = queries.collect();
    (loaded.scene, queries)
}

/// Ties of integers with this many bits, or a few more, in a scene that stays in the cache.
fn in_cache<const N: usize>(kind: PredicateKind, bits: u32) -> (Scene, Vec<[Vertex; N]>) {
    const VERTICES: usize = 1 << 11;
    /// Points of the circle of radius 65.
    const CIRCLE: [[f64; 2]; 9] = [
        [65.0, 0.0],
        [63.0, 16.0],
        [60.0, 25.0],
        [56.0, 33.0],
        [52.0, 39.0],
        [39.0, 52.0],
        [33.0, 56.0],
        [25.0, 60.0],
        [16.0, 63.0],
    ];
    let mut random = Random(43);
    #[allow(clippy::cast_precision_loss)] // 30 bits fit
    let mut point = || {
        let [x, y] = [(); 2].map(|()| random.below(1 << bits) as f64);
        let [p, q] = *random.pick(&CIRCLE);
        let scale = if bits > 10 { 1_048_583.0 } else { 1.0 };
        let [p, q] = [p * *random.pick(&[scale, -scale]), q * *random.pick(&[scale, -scale])];
        match kind {
            PredicateKind::Compare => vec![1.0, x],
            PredicateKind::Orient2d => vec![x, 3.0 * x],
            PredicateKind::Orient3d => vec![x, y, 3.0 * x + 5.0 * y],
            PredicateKind::Incircle => vec![p, q],
            PredicateKind::Derived(_) => unreachable!("the bench is about the five"),
            PredicateKind::Insphere => {
                let mut point = vec![p, q, 0.0];
                point.rotate_right(random.below(3));
                point
            }
        }
    };
    let coordinates: Vec<f64> = (0..VERTICES).flat_map(|_| point()).collect();
    let dimension = if coordinates.len() == 2 * VERTICES { Dimension::Two } else { Dimension::Three };
    let mut query = || loop {
        let query: [Vertex; N] = std::array::from_fn(|_| Vertex::input(random.below(VERTICES)));
        if (1..N).all(|i| !query[..i].contains(&query[i])) {
            break query;
        }
    };
    let queries = (0..QUERIES).map(|_| query()).collect();
    (Scene::new(dimension, coordinates).expect("finite"), queries)
}

/// A predicate of both backends, called singly and by batch.
struct Contest<E, S, F, T> {
    question: Question,
    exact: E,
    sos: S,
    exact_batch: F,
    sos_batch: T,
}

type ExactSession<'s> = predicament_exact::Session<'s, Off>;
type SosSession<'s> = Session<'s, Off>;

impl<E, S, F, T> Contest<E, S, F, T> {
    fn run<const N: usize>(&self, criterion: &mut Criterion)
    where
        E: Fn(&ExactSession, [Vertex; N]) -> Sign,
        S: Fn(&SosSession, [Vertex; N]) -> Sign,
        F: Fn(&ExactSession, &[[Vertex; N]], &mut [Sign]),
        T: Fn(&SosSession, &[[Vertex; N]], &mut [Sign]),
    {
        let kind = self.question.kind();
        for family in ["uniform", "grid", "degen", "10 bits", "30 bits"] {
            let (scene, queries) = match family {
                "10 bits" => in_cache::<N>(kind, 10),
                "30 bits" => in_cache::<N>(kind, 30),
                _ => queries::<N>(kind, family),
            };
            let backends = Scheme::ALL.map(|scheme| Sos { scheme });
            let exact = Exact.prepare(&scene, Off).expect("prepared");
            let [first, second] = backends.each_ref().map(|sos| sos.prepare(&scene, Off).expect("prepared"));

            // Monomorphic loops: each engine may be inlined into its own loop.
            let exact_single = |at: usize, out: &mut [Sign]| {
                for (&query, out) in black_box(&queries)[at..].iter().zip(out) {
                    *out = (self.exact)(&exact, query);
                }
            };
            let single = |session: &SosSession, at: usize, out: &mut [Sign]| {
                for (&query, out) in black_box(&queries)[at..].iter().zip(out) {
                    *out = (self.sos)(session, query);
                }
            };
            let exact_batch = |at: usize, out: &mut [Sign]| {
                let end = at + out.len();
                (self.exact_batch)(&exact, &black_box(&queries)[at..end], out);
            };
            let batch = |session: &SosSession, at: usize, out: &mut [Sign]| {
                let end = at + out.len();
                (self.sos_batch)(session, &black_box(&queries)[at..end], out);
            };
            let names = backends.each_ref().map(Sos::name);
            let singles: [Engine; 3] = [
                ("exact", &exact_single),
                (&names[0], &|at, out| single(&first, at, out)),
                (&names[1], &|at, out| single(&second, at, out)),
            ];
            let batches: [Engine; 3] = [
                ("exact, batch", &exact_batch),
                (&names[0], &|at, out| batch(&first, at, out)),
                (&names[1], &|at, out| batch(&second, at, out)),
            ];
            print!("{kind}, {family}:");
            compare(&singles);
            print!(";");
            compare(&batches);
            println!();

            let mut signs = vec![Sign::Zero; PASS];
            let mut group = criterion.benchmark_group(format!("{kind} {family}"));
            group.throughput(Throughput::Elements(PASS as u64));
            for (engine, ask) in singles {
                let next = Cell::new(0);
                group.bench_function(BenchmarkId::from_parameter(engine), |bencher| {
                    bencher.iter(|| {
                        ask(next.get(), &mut signs);
                        next.set((next.get() + PASS) % QUERIES);
                    });
                });
            }
            group.finish();
        }
    }
}

/// Compares answers, and times.
///
/// It prints the first engine's median, the other medians relative to it, and the share of ties.
fn compare(engines: &[Engine; 3]) {
    let turns = Turns { queries: QUERIES, pass: PASS, rounds: ROUNDS, warm_up: 0 };
    let mut ties = 0;
    let medians = turns.medians(engines, |signs| {
        for (at, &truth) in signs[0].iter().enumerate() {
            for (sos, (name, _)) in signs.iter().zip(engines).skip(1) {
                assert!(!sos[at].is_zero() && (truth.is_zero() || sos[at] == truth), "{name}");
            }
            ties += usize::from(truth.is_zero());
        }
    });
    #[allow(clippy::cast_precision_loss)] // small numbers
    let (nanoseconds, ties) = (medians[0] * 1e9 / PASS as f64, ties as f64 * 100.0 / (ROUNDS * QUERIES) as f64);
    print!(" {} {nanoseconds:.1} ns, {ties:.0} % ties", engines[0].0);
    for ((name, _), median) in engines.iter().zip(medians).skip(1) {
        print!(", {name} {:.2}", median / medians[0]);
    }
}

fn ties(criterion: &mut Criterion) {
    Contest {
        question: Question::Compare(Axis::X),
        exact: |session: &ExactSession, [a, b]: [Vertex; 2]| session.compare(Axis::X, a, b),
        sos: |session: &SosSession, [a, b]: [Vertex; 2]| session.compare(Axis::X, a, b),
        exact_batch: |session: &ExactSession, queries: &[_], out: &mut [_]| {
            session.compare_batch(Axis::X, queries, out);
        },
        sos_batch: |session: &SosSession, queries: &[_], out: &mut [_]| session.compare_batch(Axis::X, queries, out),
    }
    .run::<2>(criterion);
    Contest {
        question: Question::Orient2d(Plane::Xy),
        exact: |session: &ExactSession, [a, b, c]: [Vertex; 3]| session.orient2d(Plane::Xy, a, b, c),
        sos: |session: &SosSession, [a, b, c]: [Vertex; 3]| session.orient2d(Plane::Xy, a, b, c),
        exact_batch: |session: &ExactSession, queries: &[_], out: &mut [_]| {
            session.orient2d_batch(Plane::Xy, queries, out);
        },
        sos_batch: |session: &SosSession, queries: &[_], out: &mut [_]| session.orient2d_batch(Plane::Xy, queries, out),
    }
    .run::<3>(criterion);
    Contest {
        question: Question::Orient3d,
        exact: |session: &ExactSession, [a, b, c, d]: [Vertex; 4]| session.orient3d(a, b, c, d),
        sos: |session: &SosSession, [a, b, c, d]: [Vertex; 4]| session.orient3d(a, b, c, d),
        exact_batch: |session: &ExactSession, queries: &[_], out: &mut [_]| session.orient3d_batch(queries, out),
        sos_batch: |session: &SosSession, queries: &[_], out: &mut [_]| session.orient3d_batch(queries, out),
    }
    .run::<4>(criterion);
    Contest {
        question: Question::Incircle,
        exact: |session: &ExactSession, [a, b, c, d]: [Vertex; 4]| session.incircle(a, b, c, d),
        sos: |session: &SosSession, [a, b, c, d]: [Vertex; 4]| session.incircle(a, b, c, d),
        exact_batch: |session: &ExactSession, queries: &[_], out: &mut [_]| session.incircle_batch(queries, out),
        sos_batch: |session: &SosSession, queries: &[_], out: &mut [_]| session.incircle_batch(queries, out),
    }
    .run::<4>(criterion);
    Contest {
        question: Question::Insphere,
        exact: |session: &ExactSession, [a, b, c, d, e]: [Vertex; 5]| session.insphere(a, b, c, d, e),
        sos: |session: &SosSession, [a, b, c, d, e]: [Vertex; 5]| session.insphere(a, b, c, d, e),
        exact_batch: |session: &ExactSession, queries: &[_], out: &mut [_]| session.insphere_batch(queries, out),
        sos_batch: |session: &SosSession, queries: &[_], out: &mut [_]| session.insphere_batch(queries, out),
    }
    .run::<5>(criterion);
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(15)
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(500))
        .nresamples(2000)
        .without_plots();
    targets = ties
}
criterion_main!(benches);
