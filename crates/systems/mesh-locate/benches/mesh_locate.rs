//! Benchmark of point location in multi-material meshes, phase by phase, on one thread and on all, with the memory of
//! each phase.
//!
//! The phases: checking the mesh, the grid with its regions of empty cells, preparing a session, labels, random queries
//! and degenerate queries. Degenerate queries are the vertices of the mesh, midpoints of edges, and points on vertical
//! lines through vertices.
//!
//! Arguments: numbers of triangles, default 10^6, up to 5 × 10^7 (which takes a minute and 6 GiB);
//! `grid=X,Y,Z,FINE,FULL` for a grid of these sizes; names of backends, `exact`, `sos` and `per-mesh`, default all.
//!
//! A program of another library can take part: the environment variable `PREDICAMENT_MESH_LOCATE` names it. It gets the
//! files of a mesh and of the four kinds of queries, in this order; its output is printed. A mesh is two 64-bit counts,
//! of points and triangles, then coordinates as doubles, then 32-bit indices; queries are a 64-bit count, then
//! coordinates; all little-endian.

use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use predicament_exact::Exact;
use predicament_grid::two_level::Sizes;
use predicament_mesh::MaterialMesh;
use predicament_mesh_locate::algorithm::{Location, MeshIndex, Scratch, locate_all};
use predicament_predicates::{Backend, Dimension, Off, Predicates, Scene, Vertex};
use predicament_sos::{PerMesh, Sos};

const QUERIES: usize = 1_000_000;

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

/// The number of rounds: halved for each factor of ten above a million triangles, and at least one.
fn rounds(n: usize) -> usize {
    if n <= 1_000_000 {
        5
    } else if n <= 10_000_000 {
        3
    } else {
        1
    }
}

fn time<T>(name: &str, rounds: usize, per: usize, mut work: impl FnMut() -> T) -> T {
    let mut times = Vec::new();
    let mut last = None;
    for _ in 0..rounds {
        drop(last.take());
        let start = Instant::now();
        last = Some(black_box(work()));
        times.push(start.elapsed());
    }
    times.sort_unstable();
    let median: Duration = times[rounds / 2];
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

/// The kinds of queries by name.
type Kinds = Vec<(&'static str, Vec<Vertex>)>;

fn ask<P: Predicates>(name: &str, rounds: usize, index: &MeshIndex, session: &P, kinds: &Kinds) {
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    for (kind, queries) in kinds {
        let count = queries.len();
        let labels =
            time(&format!("{name}: labels, {kind}"), rounds, count, || one.install(|| index.labels(session, queries)));
        let found = time(&format!("{name}: {kind}"), rounds, count, || {
            let mut scratch = Scratch::new();
            let inside = |q: &&Vertex| index.locate(session, &labels, **q, &mut scratch) == Location::In(1);
            queries.iter().filter(inside).count()
        });
        println!("    {found} inside");
        time(&format!("{name}: {kind}, with labels"), rounds, count, || {
            one.install(|| locate_all(index, session, queries, &|_| true))
        });
        time(&format!("{name}: {kind}, with labels, all threads"), rounds, count, || {
            locate_all(index, session, queries, &|_| true)
        });
    }
}

/// The peak memory of the process so far, if the system reports it.
fn peak() -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with("VmHWM:"));
    line.map_or_else(String::new, |line| line.split_whitespace().skip(1).collect::<Vec<_>>().join(" "))
}

/// Runs the program of another library on files of the same mesh and queries.
fn peer(program: &str, points: &[[f64; 3]], triangles: &[[usize; 3]], kinds: &[(&'static str, Vec<[f64; 3]>); 4]) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let doubles = |points: &[[f64; 3]]| points.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    let count = |count: usize| (count as u64).to_le_bytes();
    let mut mesh = [count(points.len()), count(triangles.len())].concat();
    mesh.extend(doubles(points));
    let index = |&index: &usize| u32::try_from(index).expect("fewer than 2^32 points").to_le_bytes();
    mesh.extend(triangles.as_flattened().iter().flat_map(index));
    let mut files = vec![folder.path().join("mesh.bin")];
    std::fs::write(&files[0], mesh).expect("the mesh is written");
    for (kind, queries) in kinds {
        let file = folder.path().join(format!("{}.q", kind.replace(' ', "-")));
        std::fs::write(&file, [&count(queries.len())[..], &doubles(queries)].concat()).expect("queries are written");
        files.push(file);
    }
    let out = std::process::Command::new(program).args(&files).output().expect("the program runs");
    print!("{}", String::from_utf8_lossy(&out.stdout).replace(&format!("{}/", folder.path().display()), "  "));
}

fn shape(n: usize, sizes: Option<Sizes>, backends: &[String]) {
    let (points, triangles) = torus(n);
    let (count, rounds) = (triangles.len(), rounds(n));
    println!("torus, {count} triangles, {rounds} rounds, medians");
    let kinds = queries(&points, &triangles);
    if let Ok(program) = std::env::var("PREDICAMENT_MESH_LOCATE") {
        peer(&program, &points, &triangles, &kinds);
    }
    let mut all = points.clone();
    let mut named: Kinds = Vec::new();
    for (kind, queries) in kinds {
        let first = all.len();
        all.extend(queries);
        named.push((kind, (first..all.len()).map(Vertex::input).collect()));
    }
    let vertices = points.len();
    drop(points);
    let corners: Vec<[Vertex; 3]> = triangles.iter().map(|triangle| triangle.map(Vertex::input)).collect();
    drop(triangles);
    let whole = all.len();
    let scene = Scene::new(Dimension::Three, all.into_flattened()).expect("finite");
    let scene = scene.with_second_mesh((vertices..whole).map(Vertex::input));
    let mesh = Arc::new(if rounds == 1 {
        time("mesh: checked", 1, count, || MaterialMesh::of_closed(vertices, corners.clone()).expect("closed"))
    } else {
        time("mesh: copied and checked", rounds, count, || {
            MaterialMesh::of_closed(vertices, corners.clone()).expect("closed")
        })
    });
    drop(corners);
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    let build = || MeshIndex::with_sizes(mesh.clone(), &scene, sizes);
    drop(time("grid and regions of cells", rounds, count, || one.install(build)));
    let index = time("grid and regions of cells, all threads", rounds, count, build);
    let (slots, entries) = (index.grid().slots(), index.grid().all_entries());
    println!(
        "  {slots} cells, {} refined, {entries} entries, {} regions to be found",
        index.grid().refined(),
        index.references().len()
    );
    #[allow(clippy::cast_precision_loss)] // about
    let each = index.bytes() as f64 / count as f64;
    println!("  {} bytes, {each:.1} a triangle; the process so far {}", index.bytes(), peak());
    let wants = |name: &str| backends.is_empty() || backends.iter().any(|wanted| wanted == name);
    if wants("exact") {
        let session = time("exact: prepare", rounds, whole, || Exact.prepare(&scene, Off).expect("in space"));
        ask("exact", rounds, &index, &session, &named);
    }
    if wants("sos") {
        let sos = Sos::default();
        let session = time("sos: prepare", rounds, whole, || sos.prepare(&scene, Off).expect("in space"));
        ask("sos", rounds, &index, &session, &named);
    }
    if wants("per-mesh") {
        let session = time("per-mesh: prepare", rounds, whole, || PerMesh.prepare(&scene, Off).expect("in space"));
        ask("per-mesh", rounds, &index, &session, &named);
    }
    println!("  the process at most {}", peak());
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let sizes = arguments.iter().find_map(|argument| {
        let numbers = argument.strip_prefix("grid=")?.split(',').map(|number| number.parse().expect("a number"));
        let [x, y, z, fine, full] = numbers.collect::<Vec<u32>>()[..] else { panic!("grid=X,Y,Z,FINE,FULL") };
        Some(Sizes { coarse: [x, y, z], fine, full })
    });
    let numbers: Vec<usize> = arguments.iter().filter_map(|argument| argument.parse().ok()).collect();
    let is_backend = |argument: &&String| ["exact", "sos", "per-mesh"].contains(&argument.as_str());
    let backends: Vec<String> = arguments.iter().filter(is_backend).cloned().collect();
    for n in if numbers.is_empty() { vec![1_000_000] } else { numbers } {
        shape(n, sizes, &backends);
    }
}
