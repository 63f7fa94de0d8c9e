//! Construction of 10⁵ vertices in a running session, compared with preparing from scratch.
//!
//! * `at once`: one call of `construct` on a prepared session.
//! * `one by one`: 10⁵ calls.
//! * `ten phases`: ten calls of 10⁴, and a tie about the last vertex of each.
//! * `from scratch`: the scene gets all definitions and is then prepared.
//! * `ten times from scratch`: the cost of ten phases without `construct`: after each, the scene is prepared again with
//!   all vertices so far.
//!
//! Each ends with an exact tie about the last vertex, on its own line or plane. Before Criterion times them one after
//! another, they alternate, and a line is printed with their times relative to `from scratch`. On a busy machine only
//! that line is reliable.

#[path = "../tests/it/common.rs"]
#[allow(dead_code)] // the tests use the rest
mod common;

use std::hint::black_box;
use std::time::{Duration, Instant};

use common::Random;
use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use predicament_exact::{Exact, Session};
use predicament_predicates::{Backend, Construction, Dimension, Off, Plane, Predicates, Scene, Sign, Vertex};

const VERTICES: usize = 100_000;
const PHASES: usize = 10;
/// The number of alternating rounds.
const ROUNDS: usize = 5;

/// A scene with as many points as constructed vertices.
fn base(dimension: Dimension) -> Scene {
    let mut random = Random(23);
    Scene::new(dimension, (0..VERTICES * dimension.count()).map(|_| random.unit()).collect()).expect("finite")
}

/// Lines and planes through points that are adjacent in the list.
fn definitions(dimension: Dimension) -> Vec<Construction> {
    let at = |index: usize| Vertex::input(index % VERTICES);
    let definition = |i: usize| match dimension {
        Dimension::Two => Construction::Ssi([[at(i), at(i + 1)], [at(i + 2), at(i + 3)]]),
        Dimension::Three => Construction::Lpi { line: [at(i), at(i + 1)], plane: [at(i + 2), at(i + 3), at(i + 4)] },
    };
    (0..VERTICES).map(definition).collect()
}

/// Checks that the vertex is on its defining line or plane.
fn tie(session: &Session<'_, Off>, x: Vertex) {
    let sign = match *session.scene().construction(x).expect("constructed") {
        Construction::Ssi([[a, b], _]) => session.orient2d(Plane::Xy, a, b, black_box(x)),
        Construction::Lpi { plane: [a, b, c], .. } => session.orient3d(a, b, c, black_box(x)),
        Construction::Tpi(_) | Construction::Ratio { .. } => unreachable!("there are none"),
    };
    assert_eq!(sign, Sign::Zero);
}

fn at_once(mut session: Session<'_, Off>, definitions: &[Construction]) {
    let vertices = session.construct(definitions).expect("general position");
    tie(&session, vertices[vertices.len() - 1]);
}

fn in_parts(mut session: Session<'_, Off>, definitions: &[Construction], part: usize) {
    for part in definitions.chunks(part) {
        let vertices = session.construct(part).expect("general position");
        tie(&session, vertices[vertices.len() - 1]);
    }
}

fn from_scratch(mut scene: Scene, definitions: &[Construction]) {
    let vertices = scene.construct_all(definitions, |_, _| Ok(())).expect("vertices of the scene");
    let session = Exact.prepare(&scene, Off).expect("general position");
    tie(&session, vertices[vertices.len() - 1]);
}

fn ten_times_from_scratch(mut scene: Scene, definitions: &[Construction]) {
    for part in definitions.chunks(VERTICES / PHASES) {
        let vertices = scene.construct_all(part, |_, _| Ok(())).expect("vertices of the scene");
        let session = Exact.prepare(&scene, Off).expect("general position");
        tie(&session, vertices[vertices.len() - 1]);
    }
}

/// Prints the time of each way, without making the sessions, relative to `from scratch`.
fn turns(name: &str, scene: &Scene, definitions: &[Construction]) {
    let fresh = || Exact.prepare(scene, Off).expect("prepared");
    let mut times: [Vec<Duration>; 5] = Default::default();
    for _ in 0..ROUNDS {
        let mut time = |way: usize, run: &mut dyn FnMut()| {
            let start = Instant::now();
            run();
            times[way].push(start.elapsed());
        };
        let [mut first, mut second, mut third] = [Some(fresh()), Some(fresh()), Some(fresh())];
        time(0, &mut || at_once(first.take().expect("fresh"), definitions));
        time(1, &mut || in_parts(second.take().expect("fresh"), definitions, 1));
        time(2, &mut || in_parts(third.take().expect("fresh"), definitions, VERTICES / PHASES));
        time(3, &mut || from_scratch(scene.clone(), definitions));
        time(4, &mut || ten_times_from_scratch(scene.clone(), definitions));
    }
    let medians = times.map(|mut times| {
        times.sort_unstable();
        times[ROUNDS / 2].as_secs_f64()
    });
    let [at_once, one_by_one, phases, scratch, ten] = medians.map(|time| time / medians[3]);
    let count = f64::from(u32::try_from(VERTICES).expect("10⁵"));
    println!(
        "{name}: at once {at_once:.2}, one by one {one_by_one:.2}, ten phases {phases:.2}, from scratch {scratch:.2} \
         ({:.0} ns a vertex), ten times from scratch {ten:.2}",
        medians[3] / count * 1e9
    );
}

fn bulk(criterion: &mut Criterion) {
    for (dimension, name) in [(Dimension::Two, "ssi"), (Dimension::Three, "lpi")] {
        let (scene, definitions) = (base(dimension), definitions(dimension));
        turns(name, &scene, &definitions);
        let mut group = criterion.benchmark_group(format!("bulk {name}"));
        group.throughput(Throughput::Elements(VERTICES as u64));
        group.bench_function("at once", |bencher| {
            let fresh = || Exact.prepare(&scene, Off).expect("prepared");
            bencher.iter_batched(fresh, |session| at_once(session, &definitions), BatchSize::PerIteration);
        });
        group.bench_function("from scratch", |bencher| {
            let fresh = || scene.clone();
            bencher.iter_batched(fresh, |scene| from_scratch(scene, &definitions), BatchSize::PerIteration);
        });
        group.finish();
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(50))
        .measurement_time(Duration::from_millis(500))
        .without_plots();
    targets = bulk
}
criterion_main!(benches);
