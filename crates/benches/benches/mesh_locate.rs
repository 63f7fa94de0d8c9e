//! Points in multi-material meshes, phase by phase: the grid, its regions of empty cells, preparing a session, labels, and queries,
//! random ones and degenerate ones, on one thread and on all.
//!
//! Degenerate queries are the vertices of the mesh, midpoints of edges, and points straight below vertices.
//!
//! Arguments: the number of triangles, 10^6 if left out; `grid=X,Y,Z,FINE,FULL` for a grid of these sizes.

use std::hint::black_box;
use std::time::{Duration, Instant};

use predicament_algorithms::mesh_locate::{Location, MeshIndex, Scratch, locate_all};
use predicament_exact::Exact;
use predicament_grid::two_level::Sizes;
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use predicament_sos::{PerMesh, Sos};

const QUERIES: usize = 1_000_000;
const ROUNDS: usize = 5;

struct Random(u64);

impl Random {
    #[allow(clippy::cast_precision_loss)] // 53 bits fit
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[allow(clippy::cast_precision_loss)] // about
fn torus(n: usize) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let side = (n / 2).isqrt();
    let mut points = Vec::new();
    let angle = |i: usize| std::f64::consts::TAU * i as f64 / side as f64;
    for i in 0..side {
        for j in 0..side {
            let radius = 1.0 + 0.375 * angle(j).cos();
            points.push([radius * angle(i).cos(), radius * angle(i).sin(), 0.375 * angle(j).sin()]);
        }
    }
    let at = |i: usize, j: usize| i % side * side + j % side;
    let mut triangles = Vec::new();
    for i in 0..side {
        for j in 0..side {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    (points, triangles)
}

fn time<T>(name: &str, per: usize, mut work: impl FnMut() -> T) -> T {
    let mut times = Vec::new();
    let mut last = None;
    for _ in 0..ROUNDS {
        drop(last.take());
        let start = Instant::now();
        last = Some(black_box(work()));
        times.push(start.elapsed());
    }
    times.sort_unstable();
    let median: Duration = times[ROUNDS / 2];
    #[allow(clippy::cast_precision_loss)] // about
    let each = median.as_secs_f64() * 1e9 / per as f64;
    println!("  {name:<36} {:>10.2} ms {each:>9.1} ns each", median.as_secs_f64() * 1e3);
    last.expect("rounds")
}

fn queries(points: &[[f64; 3]], triangles: &[[usize; 3]]) -> [(&'static str, Vec<[f64; 3]>); 4] {
    let mut rng = Random(1);
    let low = [0, 1, 2].map(|axis: usize| points.iter().map(|p| p[axis]).fold(f64::INFINITY, f64::min));
    let high = [0, 1, 2].map(|axis: usize| points.iter().map(|p| p[axis]).fold(f64::NEG_INFINITY, f64::max));
    let random =
        (0..QUERIES).map(|_| [0, 1, 2].map(|axis: usize| low[axis] + rng.unit() * (high[axis] - low[axis]))).collect();
    let vertices = points.iter().copied().cycle().take(QUERIES).collect();
    let middle = |t: &[usize; 3]| [0, 1, 2].map(|axis: usize| f64::midpoint(points[t[0]][axis], points[t[1]][axis]));
    let midpoints = triangles.iter().map(middle).cycle().take(QUERIES).collect();
    let below = points
        .iter()
        .cycle()
        .take(QUERIES)
        .map(|&[x, y, _]| [x, y, low[2] + rng.unit() * (high[2] - low[2])])
        .collect();
    [("random", random), ("vertices", vertices), ("midpoints", midpoints), ("below vertices", below)]
}

fn ask<P: Predicates>(name: &str, index: &MeshIndex, session: &P, kinds: &[(&'static str, Vec<Vertex>)]) {
    for (kind, queries) in kinds {
        let labels = time(&format!("{name}: labels, {kind}"), queries.len(), || index.labels(session, queries));
        let found = time(&format!("{name}: {kind}"), queries.len(), || {
            let mut scratch = Scratch::new();
            queries
                .iter()
                .map(|&q| index.locate(session, &labels, q, &mut scratch))
                .filter(|at| matches!(at, Location::In(1)))
                .count()
        });
        println!("    {found} inside");
        time(&format!("{name}: {kind}, all threads"), queries.len(), || locate_all(index, session, queries, &|_| true));
    }
}

fn main() {
    let n: usize = std::env::args().filter_map(|argument| argument.parse().ok()).next().unwrap_or(1_000_000);
    let sizes = std::env::args().find_map(|argument| {
        let numbers = argument.strip_prefix("grid=")?.split(',').map(|number| number.parse().expect("a number"));
        let [x, y, z, fine, full] = numbers.collect::<Vec<u32>>()[..] else { panic!("grid=X,Y,Z,FINE,FULL") };
        Some(Sizes { coarse: [x, y, z], fine, full })
    });
    let (points, triangles) = torus(n);
    println!("torus, {} triangles", triangles.len());
    let kinds = queries(&points, &triangles);
    let mut all = points.clone();
    let mut named = Vec::new();
    for (kind, queries) in kinds {
        let first = all.len();
        all.extend(queries);
        named.push((kind, (first..all.len()).map(Vertex::input).collect::<Vec<_>>()));
    }
    let scene = Scene::from_points3(&all).expect("finite");
    let scene = scene.with_second_mesh((points.len()..all.len()).map(Vertex::input));
    let corners: Vec<[Vertex; 3]> = triangles.iter().map(|triangle| triangle.map(Vertex::input)).collect();
    let mesh = time("mesh: checked", corners.len(), || {
        MaterialMesh::of_closed(points.len(), corners.clone()).expect("closed")
    });
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    time("index, one thread", corners.len(), || one.install(|| MeshIndex::with_sizes(mesh.clone(), &scene, sizes)));
    let index = time("index", corners.len(), || MeshIndex::with_sizes(mesh.clone(), &scene, sizes));
    let (slots, entries) = (index.grid().slots(), index.grid().all_entries());
    println!("  {slots} cells, {} refined, {entries} entries, {} bytes", index.grid().refined(), index.bytes());
    one.install(|| {
        let session = time("exact: prepare", all.len(), || Exact.prepare(&scene, Off).expect("in space"));
        ask("exact", &index, &session, &named);
        let sos = Sos::default();
        let session = time("sos: prepare", all.len(), || sos.prepare(&scene, Off).expect("in space"));
        ask("sos", &index, &session, &named);
        let session = time("per mesh: prepare", all.len(), || PerMesh.prepare(&scene, Off).expect("in space"));
        ask("per mesh", &index, &session, &named);
    });
}
