//! Constructed vertices: the exact backend compared with rug's rationals.
//!
//! * `uniform`: random points; the filter settles all.
//! * `degenerate`: every answer is zero, which no filter can prove.
//!
//! Each with one constructed vertex and with all arguments constructed. `rational` computes the points from their
//! definitions, as a query without preparation must; `rational, prepared` has them ready, in lowest terms.
//!
//! Before these, a line for each kind has the time of a query about constructed vertices of a new session, and the time
//! when the same queries are asked again. The difference is the time of exact rows, which few queries need.

#[path = "../tests/it/common.rs"]
#[allow(dead_code)] // the tests use the rest
mod common;
#[path = "../tests/it/constructed/judge.rs"]
#[allow(dead_code)] // the tests use the rest
mod judge;

use std::hint::black_box;

use common::Random;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use judge::{Judge, Point};
use predicament_exact::constructed::Constructed;
use predicament_predicates::{Axis, Construction, Dimension, Plane, Scene, Sign, Vertex};

/// The number of groups of vertices in a scene, and of queries.
const GROUPS: usize = 256;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Ssi,
    Lpi,
    Tpi,
}

/// The geometry that the four constructed vertices of a group share.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Shared {
    /// A line (2D) or a plane (3D) through the group's first vertices.
    Flat,
    /// The same as `Flat`, with constant x on it.
    Upright,
    /// A line through the group's first two vertices.
    Line,
}

impl Kind {
    const ALL: [(Kind, &str); 3] = [(Kind::Ssi, "ssi"), (Kind::Lpi, "lpi"), (Kind::Tpi, "tpi")];

    /// The number of input vertices of a group: as many as the largest kind of sharing takes.
    fn inputs(self) -> usize {
        match self {
            Kind::Ssi => 2 + 4 * 2,
            Kind::Lpi => 2 + 4 * 3,
            Kind::Tpi => 3 + 4 * 6,
        }
    }

    /// The k-th construction of a group whose first vertex has this index.
    fn construction(self, shared: Shared, first: usize, k: usize) -> Construction {
        let v = |index: usize| Vertex::input(first + index);
        let line = |at: usize| [v(at), v(at + 1)];
        let plane = |at: usize| [v(at), v(at + 1), v(at + 2)];
        match (self, shared) {
            (Kind::Ssi, _) => Construction::Ssi([line(0), line(2 + 2 * k)]),
            (Kind::Lpi, Shared::Line) => Construction::Lpi { line: line(0), plane: plane(2 + 3 * k) },
            (Kind::Lpi, _) => Construction::Lpi { line: line(3 + 2 * k), plane: plane(0) },
            (Kind::Tpi, Shared::Line) => Construction::Tpi([plane(0), [v(0), v(1), v(3)], plane(4 + 3 * k)]),
            (Kind::Tpi, _) => Construction::Tpi([plane(0), plane(3 + 6 * k), plane(6 + 6 * k)]),
        }
    }
}

/// Groups of random points, each with four constructed vertices.
fn scene(kind: Kind, shared: Shared) -> Scene {
    let mut random = Random(17);
    let dimension = if kind == Kind::Ssi { Dimension::Two } else { Dimension::Three };
    let stride = dimension.count();
    let mut coordinates: Vec<f64> = (0..GROUPS * kind.inputs() * stride).map(|_| random.unit()).collect();
    if shared == Shared::Upright {
        for group in coordinates.chunks_mut(kind.inputs() * stride) {
            (1..stride).for_each(|vertex| group[vertex * stride] = group[0]);
        }
    }
    let mut scene = Scene::new(dimension, coordinates).expect("finite");
    for group in 0..GROUPS {
        for k in 0..4 {
            scene.construct(kind.construction(shared, group * kind.inputs(), k)).expect("input vertices");
        }
    }
    scene
}

/// A predicate's arguments for every group.
///
/// They are the group's first constructed vertex, then others of the same group, of other groups, or input vertices.
fn queries<const N: usize>(kind: Kind, degenerate: bool, all: bool) -> Vec<[Vertex; N]> {
    let query = |group: usize| {
        std::array::from_fn(|i| match (i, all, degenerate) {
            (0, ..) | (_, true, true) => Vertex::constructed(4 * group + i),
            (_, true, false) => Vertex::constructed((4 * group + 5 * i) % (4 * GROUPS)),
            (_, false, true) => Vertex::input(group * kind.inputs() + i - 1),
            (_, false, false) => Vertex::input(group * kind.inputs() + i + 6),
        })
    };
    (0..GROUPS).map(query).collect()
}

/// Compares the answers of three ways to answer the same queries, then times them.
fn duel<const N: usize>(
    criterion: &mut Criterion,
    (name, kind, kind_name): (&str, Kind, &str),
    scenes: [&Scene; 2],
    ours: impl Fn(&Constructed, [Vertex; N]) -> Sign,
    rational: impl Fn([&Point; N]) -> Sign,
) {
    for (degenerate, scene) in [false, true].into_iter().zip(scenes) {
        let (constructed, judge) = (Constructed::new(scene).expect("points"), Judge::new(scene));
        let prepared = |query: [Vertex; N]| rational(query.map(|v| judge.point(v)));
        let straight = |query: [Vertex; N]| {
            let points = query.map(|v| match scene.construction(v) {
                None => judge.point(v).clone(),
                Some(construction) => judge.solve(construction).expect("a point"),
            });
            rational(points.each_ref())
        };
        for all in [false, true] {
            let queries = queries::<N>(kind, degenerate, all);
            for &query in &queries {
                let truth = prepared(query);
                assert_eq!([ours(&constructed, query), straight(query)], [truth; 2]);
                assert_eq!(truth.is_zero(), degenerate);
            }
            let family = if degenerate { "degenerate" } else { "uniform" };
            let label = format!("{family}, {}", if all { "all" } else { "one" });
            let mut group = criterion.benchmark_group(format!("{name} {kind_name}"));
            group.throughput(Throughput::Elements(queries.len() as u64));
            let mut time = |engine: &str, ask: &dyn Fn([Vertex; N]) -> Sign| {
                group.bench_function(BenchmarkId::new(engine, &label), |bencher| {
                    bencher.iter(|| {
                        queries.iter().map(|&query| isize::from(ask(black_box(query)).as_i8())).sum::<isize>()
                    });
                });
            };
            time("exact", &|query| ours(&constructed, query));
            time("rational", &straight);
            time("rational, prepared", &prepared);
            group.finish();
        }
    }
}

/// Prints the time of general queries about 10,000 constructed vertices, asked the first time and again.
fn first_and_later(kind: Kind, name: &str) {
    const VERTICES: usize = 10_000;
    const QUERIES: usize = 100_000;
    let mut random = Random(5);
    let dimension = if kind == Kind::Ssi { Dimension::Two } else { Dimension::Three };
    let inputs = VERTICES * kind.inputs();
    let coordinates = (0..inputs * dimension.count()).map(|_| 2.0 * random.unit() - 1.0).collect();
    let mut scene = Scene::new(dimension, coordinates).expect("finite");
    for at in 0..VERTICES {
        scene.construct(kind.construction(Shared::Flat, at * kind.inputs(), 0)).expect("input vertices");
    }
    let queries: Vec<[Vertex; 4]> =
        (0..QUERIES).map(|_| [(); 4].map(|()| Vertex::constructed(random.below(VERTICES)))).collect();
    let mut times: [Vec<std::time::Duration>; 2] = Default::default();
    for _ in 0..5 {
        let constructed = Constructed::new(&scene).expect("points");
        for times in &mut times {
            let start = std::time::Instant::now();
            for &[a, b, c, d] in &queries {
                black_box(match kind {
                    Kind::Ssi => constructed.orient2d(Plane::Xy, a, b, c),
                    _ => constructed.orient3d(a, b, c, d),
                });
            }
            times.push(start.elapsed() / u32::try_from(QUERIES).expect("fewer than 2^32"));
        }
    }
    let [first, later] = times.map(|mut times| {
        times.sort_unstable();
        times[times.len() / 2]
    });
    println!("general queries, {name}: {first:?} the first time, {later:?} again");
}

fn constructed(criterion: &mut Criterion) {
    Kind::ALL.into_iter().for_each(|(kind, name)| first_and_later(kind, name));
    for (kind, name) in Kind::ALL {
        let [flat, upright, line] = [Shared::Flat, Shared::Upright, Shared::Line].map(|shared| scene(kind, shared));
        let mut group = criterion.benchmark_group("prepare");
        group.throughput(Throughput::Elements(flat.constructions().len() as u64));
        group.bench_function(name, |bencher| bencher.iter(|| Constructed::new(black_box(&flat)).expect("points")));
        group.finish();
        duel(
            criterion,
            ("compare", kind, name),
            [&flat, &upright],
            |ours, [a, b]| ours.compare(Axis::X, a, b).0,
            |points| judge::order(Axis::X, points),
        );
        duel(
            criterion,
            ("orient2d", kind, name),
            [&flat, &line],
            |ours, [a, b, c]| ours.orient2d(Plane::Xy, a, b, c).0,
            |points| judge::turn(Plane::Xy, points),
        );
        if kind != Kind::Ssi {
            duel(
                criterion,
                ("orient3d", kind, name),
                [&flat, &flat],
                |ours, [a, b, c, d]| ours.orient3d(a, b, c, d).0,
                judge::side,
            );
        }
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(std::time::Duration::from_millis(50))
        .measurement_time(std::time::Duration::from_millis(250))
        .without_plots();
    targets = constructed
}
criterion_main!(benches);
