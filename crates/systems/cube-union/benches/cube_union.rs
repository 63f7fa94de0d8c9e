//! A benchmark of unions of random cubes on one thread: 10³ to 10⁶ cubes, one of which covers a point on average, and
//! 10⁵ at other densities.

#[path = "../examples/cube_union/random.rs"]
mod random;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use predicament_cube_union::algorithm::cube_union;

fn bench(criterion: &mut Criterion) {
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    let mut group = criterion.benchmark_group("cube-union");
    group.sample_size(10);
    let by_count = [1_000, 10_000, 100_000, 1_000_000].map(|count| (count, 1.0));
    let by_density = [0.1, 4.0, 36.0, 1000.0].map(|density| (100_000, density));
    for (count, density) in by_count.into_iter().chain(by_density) {
        let (lowers, edge) = random::cubes(count, density, 2026);
        group.throughput(Throughput::Elements(count as u64));
        let id = BenchmarkId::new(format!("density {density}"), count);
        group.bench_function(id, |b| b.iter(|| one_thread.install(|| cube_union(&lowers, edge))));
    }
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
