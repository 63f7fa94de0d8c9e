//! The exact backend compared with the crate `robust`, on the same queries.
//!
//! * `uniform`: points of a unit cube. Filters settle all.
//! * `near`: collinear, coplanar, cocircular or cospherical up to rounding.
//! * `ties`: exactly degenerate integers of up to 41 bits: every answer is zero.
//! * `scaled ties`: the same, with a separate power of two for each query.
//! * `degenerate`: a small grid with long significands, on one scale: exact ties that floating point cannot recognize,
//!   and clear signs, equally often.
//! * `many scales`: the same, with a separate power of two for each query.
//! * `mixed scales`: exact ties, and points one ulp beside them, in coordinates of different exponents: hardly any
//!   difference is a double.
//!
//! Every query has separate points. There are more queries than a branch predictor can learn, but so few that each
//! engine reads its data (points, or vertices and the session's lists) from caches and not from memory, which `batches`
//! is about. A pass takes the next two thousand queries. Before Criterion times the engines one after another, they
//! alternate pass by pass, through all queries once untimed and then three times. The benchmark compares their answers,
//! and prints a line with their times relative to `robust`'s and the shares of the rungs. On a busy machine only that
//! line is reliable.
//!
//! `robust` and `raw` get coordinates; the others get vertices.

#[path = "../tests/it/common.rs"]
#[allow(dead_code)] // the tests use the rest
mod common;
mod turns;

use std::cell::Cell;
use std::hint::black_box;
use std::time::Duration;

use common::{Random, nudge};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use predicament_exact::{Exact, raw, stage};
use predicament_predicates::{Backend, Counts, Dimension, Off, Plane, PredicateKind, Predicates, Scene, Sign, Vertex};
use robust::{Coord, Coord3D};
use turns::{Engine, Turns};

/// The number of queries of a family, and of a pass.
const QUERIES: usize = 1 << 15;
const PASS: usize = 1 << 11;
/// The number of vertices of the scenes whose preparation is timed.
const VERTICES: usize = 1_000_000;

#[derive(Clone, Copy)]
enum Family {
    Uniform,
    Near,
    Ties,
    ScaledTies,
    Degenerate,
    ManyScales,
    MixedScales,
}

impl Family {
    const ALL: [(Family, &str); 7] = [
        (Family::Uniform, "uniform"),
        (Family::Near, "near"),
        (Family::Ties, "ties"),
        (Family::ScaledTies, "scaled ties"),
        (Family::Degenerate, "degenerate"),
        (Family::ManyScales, "many scales"),
        (Family::MixedScales, "mixed scales"),
    ];

    /// The points of a query: on a circle or a sphere if `round`, else on a line or a plane.
    fn query<const D: usize, const N: usize>(self, random: &mut Random, round: bool) -> [[f64; D]; N] {
        match self {
            Family::Uniform => random.points(Random::unit),
            Family::Near if round => random.points(|random| random.unit() - 0.5).map(|p: [f64; D]| {
                let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
                p.map(|x| x / length)
            }),
            Family::Near => random.points(Random::unit).map(flat),
            Family::Ties => tie(random, round),
            Family::ScaledTies => {
                let scale = exponent(random, 40);
                tie(random, round).map(|p: [f64; D]| p.map(|x| x * scale))
            }
            Family::Degenerate => random.points(grid),
            Family::ManyScales => {
                let scale = exponent(random, 150);
                random.points(|random| grid(random) * scale)
            }
            Family::MixedScales => {
                let mut points: [[f64; D]; N] = if round {
                    let ends: [[f64; D]; 2] = random.points(|random| (1.0 + random.unit()) * exponent(random, 60));
                    std::array::from_fn(|i| std::array::from_fn(|axis| ends[corners::<D>()[i] >> axis & 1][axis]))
                } else {
                    random.points(|random| (1.0 + random.unit()) * exponent(random, 60)).map(|mut p: [f64; D]| {
                        p[D - 1] = p[0];
                        p
                    })
                };
                let last = &mut points[random.below(N)][D - 1];
                *last = nudge(*last, [0, 0, 1, -1][random.below(4)]);
                points
            }
        }
    }
}

/// The point with its last coordinate computed from the others: on a line or a plane.
fn flat<const D: usize>(mut p: [f64; D]) -> [f64; D] {
    p[D - 1] = 0.1 + p[..D - 1].iter().sum::<f64>() / 3.0;
    p
}

/// Integer points of one line or plane, or corners of one box.
fn tie<const D: usize, const N: usize>(random: &mut Random, round: bool) -> [[f64; D]; N] {
    #[allow(clippy::cast_precision_loss)] // 41 bits fit
    let mut integer = |bits: u32| random.below(1 << bits) as f64;
    if round {
        let ends: [[f64; D]; 2] = [(); 2].map(|()| std::array::from_fn(|_| integer(40)));
        return std::array::from_fn(|i| std::array::from_fn(|axis| ends[corners::<D>()[i] >> axis & 1][axis]));
    }
    let origin: [f64; D] = std::array::from_fn(|_| integer(40));
    let steps: [[f64; D]; 2] = [(); 2].map(|()| std::array::from_fn(|_| integer(16)));
    std::array::from_fn(|_| {
        let places = [integer(16), if D == 2 { 0.0 } else { integer(16) }];
        std::array::from_fn(|axis| origin[axis] + places[0] * steps[0][axis] + places[1] * steps[1][axis])
    })
}

/// Corners of a box that are on one circle or sphere, with one bit per axis.
fn corners<const D: usize>() -> &'static [usize] {
    if D == 2 { &[0b00, 0b01, 0b11, 0b10] } else { &[0, 1, 2, 4, 7] }
}

/// A coordinate 0, 1 or 2 plus a multiple of a 53-bit step.
fn grid(random: &mut Random) -> f64 {
    *random.pick(&[0.0, 1.0, 2.0]) * (1.0 + f64::EPSILON)
}

fn exponent(random: &mut Random, largest: i32) -> f64 {
    let choices = usize::try_from(2 * largest + 1).expect("positive");
    2f64.powi(i32::try_from(random.below(choices)).expect("small") - largest)
}

fn scene<const D: usize>(points: &[[f64; D]]) -> Scene {
    let dimension = if D == 2 { Dimension::Two } else { Dimension::Three };
    Scene::new(dimension, points.as_flattened().to_vec()).expect("finite")
}

/// A predicate in all forms that the benchmark can call.
struct Contest<S, T, B, R, C> {
    kind: PredicateKind,
    round: bool,
    single: S,
    counted: T,
    batch: B,
    raw: R,
    robust: C,
}

type Session<'s> = predicament_exact::Session<'s, Off>;
type Counted<'s> = predicament_exact::Session<'s, &'s Counts>;

impl<S, T, B, R, C> Contest<S, T, B, R, C> {
    fn run<const D: usize, const N: usize>(&self, criterion: &mut Criterion)
    where
        S: Fn(&Session, [Vertex; N]) -> Sign,
        T: Fn(&Counted, [Vertex; N]) -> Sign,
        B: Fn(&Session, &[[Vertex; N]], &mut [Sign]),
        R: Fn([[f64; D]; N]) -> Sign,
        C: Fn([[f64; D]; N]) -> f64,
    {
        for (family, family_name) in Family::ALL {
            let mut random = Random(23);
            let points: Vec<[[f64; D]; N]> = (0..QUERIES).map(|_| family.query(&mut random, self.round)).collect();
            let queries: Vec<[Vertex; N]> =
                (0..QUERIES).map(|query| std::array::from_fn(|i| Vertex::input(query * N + i))).collect();
            let (scene, counts) = (scene(points.as_flattened()), Counts::new());
            let session = Exact.prepare(&scene, Off).expect("prepared");
            let counted = Exact.prepare(&scene, &counts).expect("prepared");

            // Monomorphic loops: each engine may be inlined into its own loop.
            let robust = |at: usize, out: &mut [Sign]| {
                for (&query, out) in black_box(&points)[at..].iter().zip(out) {
                    *out = Sign::of((self.robust)(query));
                }
            };
            let raw = |at: usize, out: &mut [Sign]| {
                for (&query, out) in black_box(&points)[at..].iter().zip(out) {
                    *out = (self.raw)(query);
                }
            };
            let single = |at: usize, out: &mut [Sign]| {
                for (&query, out) in black_box(&queries)[at..].iter().zip(out) {
                    *out = (self.single)(&session, query);
                }
            };
            let tallied = |at: usize, out: &mut [Sign]| {
                for (&query, out) in black_box(&queries)[at..].iter().zip(out) {
                    *out = (self.counted)(&counted, query);
                }
            };
            let batch = |at: usize, out: &mut [Sign]| {
                let end = at + out.len();
                (self.batch)(&session, &black_box(&queries)[at..end], out);
            };
            let engines: [Engine; 5] =
                [("robust", &robust), ("raw", &raw), ("single", &single), ("counted", &tallied), ("batch", &batch)];

            print!("{}, {family_name}:", self.kind);
            compare(&engines);
            shares(self.kind, &counts);

            let mut signs = vec![Sign::Zero; PASS];
            let mut group = criterion.benchmark_group(self.kind.to_string());
            group.throughput(Throughput::Elements(PASS as u64));
            for (engine, ask) in engines {
                let next = Cell::new(0);
                group.bench_function(BenchmarkId::new(engine, family_name), |bencher| {
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

/// Compares answers and times; prints the first engine's median, and the other medians relative to it.
fn compare(engines: &[Engine; 5]) {
    let turns = Turns { queries: QUERIES, pass: PASS, rounds: 3, warm_up: 1 };
    let (mut zeros, mut all) = (0, 0);
    let medians = turns.medians(engines, |signs| {
        for (signs_of_one, (name, _)) in signs.iter().zip(engines) {
            assert_eq!(*signs_of_one, signs[0], "{name}");
        }
        zeros += signs[0].iter().filter(|sign| sign.is_zero()).count();
        all += signs[0].len();
    });
    #[allow(clippy::cast_precision_loss)] // small numbers
    let (nanoseconds, zeros) = (medians[0] * 1e9 / PASS as f64, zeros as f64 * 100.0 / all as f64);
    print!(" {} {nanoseconds:.1} ns;", engines[0].0);
    for ((name, _), median) in engines.iter().zip(medians).skip(1) {
        print!(" {name} {:.2},", median / medians[0]);
    }
    print!(" zeros {zeros:.0} %,");
}

/// Prints the number of queries that each rung settled.
fn shares(kind: PredicateKind, counts: &Counts) {
    let settled = |stage: usize| counts.get(kind, stage);
    let all: u64 = (0..stage::NAMES.len()).map(settled).sum();
    for (stage, name) in stage::NAMES.iter().enumerate() {
        if settled(stage) > 0 {
            print!(" {name} {} %", (settled(stage) * 100 + all / 2) / all);
        }
    }
    println!();
}

fn coord([x, y]: [f64; 2]) -> Coord<f64> {
    Coord { x, y }
}

fn coord3([x, y, z]: [f64; 3]) -> Coord3D<f64> {
    Coord3D { x, y, z }
}

fn predicates(criterion: &mut Criterion) {
    Contest {
        kind: PredicateKind::Orient2d,
        round: false,
        single: |session: &Session, [a, b, c]: [Vertex; 3]| session.orient2d(Plane::Xy, a, b, c),
        counted: |session: &Counted, [a, b, c]: [Vertex; 3]| session.orient2d(Plane::Xy, a, b, c),
        batch: |session: &Session, queries: &[_], out: &mut [_]| session.orient2d_batch(Plane::Xy, queries, out),
        raw: raw::orient2d,
        robust: |[a, b, c]: [_; 3]| robust::orient2d(coord(a), coord(b), coord(c)),
    }
    .run::<2, 3>(criterion);
    Contest {
        kind: PredicateKind::Orient3d,
        round: false,
        single: |session: &Session, [a, b, c, d]: [Vertex; 4]| session.orient3d(a, b, c, d),
        counted: |session: &Counted, [a, b, c, d]: [Vertex; 4]| session.orient3d(a, b, c, d),
        batch: |session: &Session, queries: &[_], out: &mut [_]| session.orient3d_batch(queries, out),
        raw: raw::orient3d,
        robust: |[a, b, c, d]: [_; 4]| robust::orient3d(coord3(a), coord3(b), coord3(c), coord3(d)),
    }
    .run::<3, 4>(criterion);
    Contest {
        kind: PredicateKind::Incircle,
        round: true,
        single: |session: &Session, [a, b, c, d]: [Vertex; 4]| session.incircle(a, b, c, d),
        counted: |session: &Counted, [a, b, c, d]: [Vertex; 4]| session.incircle(a, b, c, d),
        batch: |session: &Session, queries: &[_], out: &mut [_]| session.incircle_batch(queries, out),
        raw: raw::incircle,
        robust: |[a, b, c, d]: [_; 4]| robust::incircle(coord(a), coord(b), coord(c), coord(d)),
    }
    .run::<2, 4>(criterion);
    Contest {
        kind: PredicateKind::Insphere,
        round: true,
        single: |session: &Session, [a, b, c, d, e]: [Vertex; 5]| session.insphere(a, b, c, d, e),
        counted: |session: &Counted, [a, b, c, d, e]: [Vertex; 5]| session.insphere(a, b, c, d, e),
        batch: |session: &Session, queries: &[_], out: &mut [_]| session.insphere_batch(queries, out),
        raw: raw::insphere,
        robust: |[a, b, c, d, e]: [_; 5]| robust::insphere(coord3(a), coord3(b), coord3(c), coord3(d), coord3(e)),
    }
    .run::<3, 5>(criterion);
}

/// Times preparation per vertex of a uniform scene.
fn prepare(criterion: &mut Criterion) {
    let mut random = Random(29);
    let flat: Vec<[f64; 2]> = (0..VERTICES).map(|_| random.points::<1, 2>(Random::unit)[0]).collect();
    let solid: Vec<[f64; 3]> = (0..VERTICES).map(|_| random.points::<1, 3>(Random::unit)[0]).collect();
    let mut group = criterion.benchmark_group("prepare");
    group.throughput(Throughput::Elements(VERTICES as u64));
    for (name, scene) in [("2D", scene(&flat)), ("3D", scene(&solid))] {
        group.bench_function(name, |bencher| {
            bencher.iter(|| black_box(Exact.prepare(black_box(&scene), Off).expect("prepared")));
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(15)
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(500))
        .nresamples(2000)
        .without_plots();
    targets = predicates, prepare
}
criterion_main!(benches);
