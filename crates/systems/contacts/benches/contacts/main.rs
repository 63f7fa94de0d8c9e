//! A benchmark of contacts of two complexes of 10^3 to 10^6 primitives (edges in the plane, triangles in space), by
//! backend.
//!
//! Crossing edges are also found by an R-tree of the crate `rstar` with the same exact test, and by the sweep of `geo`.
//! The time of each phase and the numbers of pairs by outcome are printed first; contacts are compared before anything
//! is timed.

mod scenes;

use std::time::Instant;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use geo::sweep::{Cross, Intersections};
use geo::{Coord, Line};
use predicament_contacts::algorithm::pairs::{Contacts, contacts2d, contacts3d};
use predicament_controls::Naive;
use predicament_exact::Exact;
use predicament_mesh::Complex;
use predicament_predicates::{Axis, Backend, Off, Predicates, Scene};
use predicament_sos::Sos;
use predicament_tolerance::Tolerance;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};
use scenes::{Pair, polygons, tori};

const SIZES: [usize; 4] = [1_000, 10_000, 100_000, 1_000_000];

type Run<S> = fn(&S, &Complex, &Complex) -> Contacts;

fn primitives(Pair { a, b, .. }: &Pair) -> usize {
    if a.triangles().is_empty() { a.edges().len() + b.edges().len() } else { a.triangles().len() + b.triangles().len() }
}

/// Prints one line for the backend, and one for each kind of pair.
#[allow(clippy::cast_precision_loss)] // for people
fn summary(name: &str, pair: &Pair, seconds: f64, found: &Contacts) {
    let count = primitives(pair);
    let candidates: u64 = found.levels.iter().map(|level| level.candidates).sum();
    println!(
        "{name:>14} {count:>8} primitives {:>8.1} ns each {:>10} registered {:>6.2} candidates each",
        seconds * 1e9 / count as f64,
        found.registered.len(),
        candidates as f64 / count as f64,
    );
    for level in found.levels.iter().filter(|level| level.candidates > 0) {
        println!(
            "{:>14} {:?}: {} candidates, {} ended, {} registered",
            "", level.ranks, level.candidates, level.ended, level.registered
        );
    }
}

fn backend<B: Backend>(criterion: &mut Criterion, backend: &B, task: &str, pair: &Pair)
where
    for<'s> B::Session<'s, Off>: Predicates,
{
    let session = match backend.prepare(&pair.scene, Off) {
        Ok(session) => session,
        Err(declined) => return println!("{:>14} {task} declined: {declined}", backend.name()),
    };
    let run: Run<B::Session<'_, Off>> = if task == "contacts2d" { contacts2d } else { contacts3d };
    let start = Instant::now();
    let found = run(&session, &pair.a, &pair.b);
    summary(&backend.name(), pair, start.elapsed().as_secs_f64(), &found);
    let mut group = criterion.benchmark_group(task);
    group.sample_size(10).throughput(Throughput::Elements(primitives(pair) as u64));
    group.bench_function(BenchmarkId::new(backend.name(), primitives(pair)), |bencher| {
        bencher.iter(|| run(&session, &pair.a, &pair.b));
    });
    group.finish();
}

fn backends(criterion: &mut Criterion, task: &str, pair: &Pair) {
    backend(criterion, &Exact, task, pair);
    backend(criterion, &Sos::default(), task, pair);
    backend(criterion, &Naive::default(), task, pair);
    backend(criterion, &Tolerance::<f64>::new(), task, pair);
    backend(criterion, &Tolerance::<f32>::new(), task, pair);
}

/// The number of crossing edges, by a bulk-loaded R-tree of boxes and the session's test.
fn crossings<S: Predicates>(session: &S, scene: &Scene, a: &Complex, b: &Complex) -> usize {
    let ends = |edge: &[predicament_predicates::Vertex; 2]| {
        edge.map(|v| [Axis::X, Axis::Y].map(|axis| scene.coordinate(axis, v)))
    };
    let boxed = |(at, edge)| {
        let [p, q] = ends(edge);
        GeomWithData::new(Rectangle::from_corners(p, q), at)
    };
    let tree = RTree::bulk_load(b.edges().iter().enumerate().map(boxed).collect());
    let of = |edge| {
        let [p, q] = ends(edge);
        let near = tree.locate_in_envelope_intersecting(&AABB::from_corners(p, q));
        near.filter(|other| session.edge_edge(*edge, b.edges()[other.data]).is_some()).count()
    };
    a.edges().iter().map(of).sum()
}

/// An edge for `geo`, and true if it belongs to the second complex.
#[derive(Clone, Copy, Debug)]
struct Edge(Line, bool);

impl Cross for Edge {
    type Scalar = f64;

    fn line(&self) -> Line {
        self.0
    }
}

/// The number of crossing edges, by the sweep of `geo` over both complexes; crossings within one complex are dropped.
fn swept(scene: &Scene, a: &Complex, b: &Complex) -> usize {
    let end = |v| {
        let [x, y] = [Axis::X, Axis::Y].map(|axis| scene.coordinate(axis, v));
        Coord { x, y }
    };
    let edges = |of: &Complex, of_b| -> Vec<Edge> {
        of.edges().iter().map(|&[p, q]| Edge(Line::new(end(p), end(q)), of_b)).collect()
    };
    let all: Intersections<Edge> = edges(a, false).into_iter().chain(edges(b, true)).collect();
    all.filter(|(e, f, _)| e.1 != f.1).count()
}

fn bench(criterion: &mut Criterion) {
    for size in SIZES {
        backends(criterion, "contacts2d", &polygons(size));
        backends(criterion, "contacts3d", &tori(size));
    }
    let pair = polygons(100_000);
    let session = Exact.prepare(&pair.scene, Off).expect("a 2D scene");
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    let ours = || one.install(|| contacts2d(&session, &pair.a, &pair.b));
    let crossing = ours().levels.iter().find(|level| level.ranks == [1, 1]).map(|level| level.registered);
    assert_eq!(crossing, Some(crossings(&session, &pair.scene, &pair.a, &pair.b) as u64));
    assert_eq!(crossing, Some(swept(&pair.scene, &pair.a, &pair.b) as u64));
    let mut group = criterion.benchmark_group("crossings");
    group.sample_size(10).throughput(Throughput::Elements(primitives(&pair) as u64));
    group.bench_function("all contacts, one thread", |bencher| bencher.iter(ours));
    group.bench_function("edges alone, rstar", |bencher| {
        bencher.iter(|| crossings(&session, &pair.scene, &pair.a, &pair.b));
    });
    group.bench_function("edges alone, geo's sweep", |bencher| bencher.iter(|| swept(&pair.scene, &pair.a, &pair.b)));
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
