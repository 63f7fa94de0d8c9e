//! What ties cost: the exact backend against both schemes, on points without
//! ties and on grids, where the perturbation has to be paid.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Dimension, Off, Plane, QuerySet, Question, Scene, Sign, Vertex};
use predicament_sos::{Scheme, Sos};

const QUERIES: usize = 2000;

/// A reproducible stream of random bits (splitmix64).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    /// Uniform in [0, 1): 52 random bits.
    fn uniform(&mut self) -> f64 {
        f64::from_bits(1_f64.to_bits() | (self.bits() >> 12)) - 1.0
    }
}

fn ask(c: &mut Criterion, group: &str, backend: &impl Backend, scene: &Scene, queries: &QuerySet) {
    let session = backend.prepare(scene, Off).expect("exact and sos take every scene");
    let mut out = vec![Sign::Zero; queries.len()];
    let mut group = c.benchmark_group(group);
    group.throughput(Throughput::Elements(QUERIES as u64)).sample_size(20);
    group.bench_function(BenchmarkId::from_parameter(backend.name()), |b| {
        b.iter(|| queries.ask_batch(&session, 0..queries.len(), &mut out));
    });
    group.finish();
}

fn ties(c: &mut Criterion) {
    let questions = [Question::Orient2d(Plane::Xy), Question::Incircle, Question::Orient3d, Question::Insphere];
    for question in questions {
        let flat = matches!(question, Question::Orient2d(_) | Question::Incircle);
        let dimension = if flat { Dimension::Two } else { Dimension::Three };
        for family in ["uniform", "grid"] {
            let mut random = Random(1);
            let vertices = 5 * QUERIES;
            let coordinate = |_| if family == "grid" { (3.0 * random.uniform()).floor() } else { random.uniform() };
            let coordinates = (0..vertices * dimension.count()).map(coordinate).collect();
            let scene = Scene::new(dimension, coordinates).expect("finite");
            let args: Vec<Vertex> = scene.vertices().take(question.kind().arity() * QUERIES).collect();
            let queries = QuerySet::new(question, args);
            let group = format!("{} {family}", question.kind());
            ask(c, &group, &Exact, &scene, &queries);
            for scheme in Scheme::ALL {
                ask(c, &group, &Sos { scheme }, &scene, &queries);
            }
        }
    }
}

criterion_group!(benches, ties);
criterion_main!(benches);
