//! Batches: from the cache, from memory, and beside one line or plane.
//!
//! Every query has separate points, uniform in a unit cube, so that the filter settles nearly all. Engines alternate,
//! pass by pass, and the benchmark prints medians:
//!
//! * *in cache*: a pass of queries that the engine has just answered, relative to `robust`'s time for the same pass
//!   (its first time, as its branch predictor must not have learned the queries; it reads its points in order);
//! * *from memory*: all queries, more than caches hold, relative to a loop that only reads the same vertices and
//!   points: 1 is the memory bandwidth that such a loop reaches;
//! * *beside*: one line or plane and many points, relative to the batch of the same queries.

#[path = "../tests/it/common.rs"]
#[allow(dead_code)] // the tests use the rest
mod common;

use std::hint::black_box;
use std::time::Instant;

use common::Random;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use predicament_exact::{Exact, Session};
use predicament_predicates::{Backend, Dimension, Off, Plane, Predicates, Scene, Sign, Vertex};
use robust::{Coord, Coord3D};

/// The number of queries of a pass in cache, and of a pass beside a line or plane.
const PASS: usize = 1 << 12;
const PASSES: usize = 64;
/// The number of queries from memory, and of their repetitions.
const MANY: usize = 5_000_000;
const ROUNDS: usize = 7;

struct Contest<B, R> {
    name: &'static str,
    batch: B,
    robust: R,
}

impl<B, R> Contest<B, R> {
    fn run<const D: usize, const N: usize>(&self, criterion: &mut Criterion)
    where
        B: Fn(&Session<'_, Off>, &[[Vertex; N]], &mut [Sign]),
        R: Fn([[f64; D]; N]) -> f64,
    {
        let mut random = Random(41);
        let points: Vec<[[f64; D]; N]> = (0..MANY).map(|_| random.points(Random::unit)).collect();
        let queries: Vec<[Vertex; N]> =
            (0..MANY).map(|query| std::array::from_fn(|i| Vertex::input(query * N + i))).collect();
        let dimension = if D == 2 { Dimension::Two } else { Dimension::Three };
        let scene = Scene::new(dimension, points.as_flattened().as_flattened().to_vec()).expect("finite");
        let session = Exact.prepare(&scene, Off).expect("prepared");

        let mut signs = [(); 2].map(|()| vec![Sign::Zero; PASS]);
        let mut times = [const { Vec::new() }; 2];
        for pass in 0..PASSES {
            let range = pass * PASS..(pass + 1) * PASS;
            times[0].push(timed(|| {
                for (query, sign) in black_box(&points[range.clone()]).iter().zip(&mut signs[0]) {
                    *sign = Sign::of((self.robust)(*query));
                }
            }));
            (self.batch)(&session, &queries[range.clone()], &mut signs[1]);
            times[1].push(timed(|| (self.batch)(&session, black_box(&queries[range]), &mut signs[1])));
            assert_eq!(signs[0], signs[1]);
        }
        let [robust, batch] = times.map(median);
        #[allow(clippy::cast_precision_loss)] // small numbers
        let each = |time: f64, count: usize| time * 1e9 / count as f64;
        print!("{}, in cache: {:.2} ns, {:.3} of robust;", self.name, each(batch, PASS), batch / robust);

        let mut all = vec![Sign::Zero; MANY];
        let mut times = [const { Vec::new() }; 2];
        for _ in 0..ROUNDS {
            times[0].push(timed(|| _ = black_box(read(black_box(scene.coordinates()), black_box(&queries)))));
            times[1].push(timed(|| (self.batch)(&session, black_box(&queries), &mut all)));
        }
        let [reading, batch] = times.map(median);
        let bytes = size_of_val(scene.coordinates()) + size_of_val(&queries[..]);
        #[allow(clippy::cast_precision_loss)] // small numbers
        let gigabytes = bytes as f64 / batch * 1e-9;
        println!(
            " from memory: {:.2} ns, {gigabytes:.1} GB/s, {:.2} of the bandwidth of reading",
            each(batch, MANY),
            reading / batch
        );

        let mut group = criterion.benchmark_group(self.name);
        group.throughput(Throughput::Elements(PASS as u64));
        group.bench_function("in cache", |bencher| {
            bencher.iter(|| (self.batch)(&session, black_box(&queries[..PASS]), &mut signs[0]));
        });
        group.finish();
    }
}

/// Reads everything, and computes almost nothing from it.
fn read<const N: usize>(coordinates: &[f64], queries: &[[Vertex; N]]) -> (u64, Vertex) {
    let bits = coordinates.iter().fold(0, |all, x| all ^ x.to_bits());
    let largest =
        queries.as_flattened().iter().fold(Vertex::input(0), |largest, &v| if v > largest { v } else { largest });
    (bits, largest)
}

/// Times one line and one plane with many points.
fn beside(_: &mut Criterion) {
    let mut random = Random(43);
    let (mut signs, mut expected) = (vec![Sign::Zero; PASS], vec![Sign::Zero; PASS]);
    let others: Vec<Vertex> = (3..PASS + 3).map(Vertex::input).collect();
    for dimension in [Dimension::Two, Dimension::Three] {
        let count = dimension.count() * (PASS + 4);
        let scene = Scene::new(dimension, (0..count).map(|_| random.unit()).collect()).expect("finite");
        let session = Exact.prepare(&scene, Off).expect("prepared");
        let [a, b, c] = [0, 1, 2].map(Vertex::input);
        let mut times = [const { Vec::new() }; 2];
        for _ in 0..PASSES {
            let [one, many]: [f64; 2] = if dimension == Dimension::Two {
                let queries: Vec<[Vertex; 3]> = others.iter().map(|&c| [a, b, c]).collect();
                [
                    timed(|| session.orient2d_batch(Plane::Xy, black_box(&queries), &mut expected)),
                    timed(|| session.orient2d_line(Plane::Xy, [a, b], black_box(&others), &mut signs)),
                ]
            } else {
                let queries: Vec<[Vertex; 4]> = others.iter().map(|&d| [a, b, c, d]).collect();
                [
                    timed(|| session.orient3d_batch(black_box(&queries), &mut expected)),
                    timed(|| session.orient3d_plane([a, b, c], black_box(&others), &mut signs)),
                ]
            };
            assert_eq!(signs, expected);
            times[0].push(one);
            times[1].push(many);
        }
        let [batch, beside] = times.map(median);
        #[allow(clippy::cast_precision_loss)] // a small number
        let each = beside * 1e9 / PASS as f64;
        let name = if dimension == Dimension::Two { "a line" } else { "a plane" };
        println!("beside {name}: {each:.2} ns, {:.2} of the batch", beside / batch);
    }
}

fn timed(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64()
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}

fn batches(criterion: &mut Criterion) {
    let coord = |[x, y]: [f64; 2]| Coord { x, y };
    let coord3 = |[x, y, z]: [f64; 3]| Coord3D { x, y, z };
    Contest {
        name: "orient2d",
        batch: |session: &Session<'_, Off>, queries: &[_], out: &mut [_]| {
            session.orient2d_batch(Plane::Xy, queries, out);
        },
        robust: |[a, b, c]: [_; 3]| robust::orient2d(coord(a), coord(b), coord(c)),
    }
    .run::<2, 3>(criterion);
    Contest {
        name: "orient3d",
        batch: |session: &Session<'_, Off>, queries: &[_], out: &mut [_]| session.orient3d_batch(queries, out),
        robust: |[a, b, c, d]: [_; 4]| robust::orient3d(coord3(a), coord3(b), coord3(c), coord3(d)),
    }
    .run::<3, 4>(criterion);
    Contest {
        name: "incircle",
        batch: |session: &Session<'_, Off>, queries: &[_], out: &mut [_]| session.incircle_batch(queries, out),
        robust: |[a, b, c, d]: [_; 4]| robust::incircle(coord(a), coord(b), coord(c), coord(d)),
    }
    .run::<2, 4>(criterion);
    Contest {
        name: "insphere",
        batch: |session: &Session<'_, Off>, queries: &[_], out: &mut [_]| session.insphere_batch(queries, out),
        robust: |[a, b, c, d, e]: [_; 5]| robust::insphere(coord3(a), coord3(b), coord3(c), coord3(d), coord3(e)),
    }
    .run::<3, 5>(criterion);
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10).without_plots();
    targets = batches, beside
}
criterion_main!(benches);
