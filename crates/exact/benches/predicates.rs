//! The exact backend beside the crate `robust`, on the same scenes.
//!
//! * `uniform`: points of a unit cube. The filter settles all.
//! * `near`: collinear, coplanar, cocircular or cospherical up to rounding.
//! * `degenerate`: a small integer grid shifted and scaled by a long significand,
//!   so that ties are exact and hidden from plain floating point.

use std::hint::black_box;

use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Off, Plane, Predicates, Scene, Sign, Vertex};
use robust::{Coord, Coord3D};

const QUERIES: usize = 1024;
const FAMILIES: [&str; 3] = ["uniform", "near", "degenerate"];

/// A Weyl sequence over [0, 1): spread evenly, and enough for timing.
struct Weyl(f64);

impl Weyl {
    fn next(&mut self) -> f64 {
        self.0 = (self.0 + 0.618_033_988_749_894_9).fract();
        (self.0 * 7919.0).fract()
    }
}

/// N points a query, coordinates in [0, 1) made to fit the family.
fn points<const N: usize, const D: usize>(family: &str, round: bool) -> Vec<[f64; D]> {
    let mut weyl = Weyl(0.5);
    let mut query = || -> [[f64; D]; N] {
        let free: [[f64; D]; N] = std::array::from_fn(|_| std::array::from_fn(|_| weyl.next()));
        match family {
            "degenerate" => free.map(|p| p.map(|x| (x * 3.0).floor() * (1.0 + f64::EPSILON))),
            "near" if round => free.map(|p| {
                let centered = p.map(|x| x - 0.5);
                let length = centered.iter().map(|x| x * x).sum::<f64>().sqrt();
                centered.map(|x| x / length)
            }),
            "near" => free.map(|mut p| {
                // The last coordinate from the others: on a line, or a plane.
                p[D - 1] = 0.1 + p[..D - 1].iter().sum::<f64>() / 3.0;
                p
            }),
            _ => free,
        }
    };
    (0..QUERIES).flat_map(|_| query()).collect()
}

fn vertices<const N: usize>() -> Vec<[Vertex; N]> {
    (0..QUERIES).map(|query| std::array::from_fn(|i| Vertex::input(query * N + i))).collect()
}

/// Times two ways to answer the same queries into the same array.
fn duel<const N: usize>(
    criterion: &mut Criterion,
    name: &str,
    family: &str,
    ours: impl Fn(&[[Vertex; N]], &mut [Sign]),
    robust: impl Fn([Vertex; N]) -> f64,
) {
    let queries = vertices::<N>();
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(QUERIES as u64));
    group.bench_function(BenchmarkId::new("exact", family), |bencher| {
        bencher.iter_batched_ref(
            || vec![Sign::Zero; QUERIES],
            |out| ours(black_box(&queries), out),
            BatchSize::SmallInput,
        );
    });
    group.bench_function(BenchmarkId::new("robust", family), |bencher| {
        bencher.iter_batched_ref(
            || vec![Sign::Zero; QUERIES],
            |out| {
                for (&query, out) in black_box(&queries).iter().zip(out) {
                    *out = Sign::of(robust(query));
                }
            },
            BatchSize::SmallInput,
        );
    });
    group.finish();
}

fn predicates(criterion: &mut Criterion) {
    for family in FAMILIES {
        let scene = Scene::from_points2(&points::<3, 2>(family, false)).expect("finite");
        let session = Exact.prepare(&scene, Off).expect("prepared");
        let at = |v: Vertex| {
            let [x, y] = scene.point2(Plane::Xy, v);
            Coord { x, y }
        };
        duel(
            criterion,
            "orient2d",
            family,
            |queries, out| session.orient2d_batch(Plane::Xy, queries, out),
            |[a, b, c]| robust::orient2d(at(a), at(b), at(c)),
        );

        let scene = Scene::from_points2(&points::<4, 2>(family, true)).expect("finite");
        let session = Exact.prepare(&scene, Off).expect("prepared");
        let at = |v: Vertex| {
            let [x, y] = scene.point2(Plane::Xy, v);
            Coord { x, y }
        };
        duel(
            criterion,
            "incircle",
            family,
            |queries, out| session.incircle_batch(queries, out),
            |[a, b, c, d]| robust::incircle(at(a), at(b), at(c), at(d)),
        );

        let scene = Scene::from_points3(&points::<4, 3>(family, false)).expect("finite");
        let session = Exact.prepare(&scene, Off).expect("prepared");
        let at = |v: Vertex| {
            let [x, y, z] = scene.point3(v);
            Coord3D { x, y, z }
        };
        duel(
            criterion,
            "orient3d",
            family,
            |queries, out| session.orient3d_batch(queries, out),
            |[a, b, c, d]| robust::orient3d(at(a), at(b), at(c), at(d)),
        );

        let scene = Scene::from_points3(&points::<5, 3>(family, true)).expect("finite");
        let session = Exact.prepare(&scene, Off).expect("prepared");
        let at = |v: Vertex| {
            let [x, y, z] = scene.point3(v);
            Coord3D { x, y, z }
        };
        duel(
            criterion,
            "insphere",
            family,
            |queries, out| session.insphere_batch(queries, out),
            |[a, b, c, d, e]| robust::insphere(at(a), at(b), at(c), at(d), at(e)),
        );
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(std::time::Duration::from_millis(200))
        .measurement_time(std::time::Duration::from_millis(800))
        .without_plots();
    targets = predicates
}
criterion_main!(benches);
