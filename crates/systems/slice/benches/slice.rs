//! Benchmark: a million triangles split by 10 to 100 planes through vertices, on one thread; each time is listed beside
//! the number of crossed faces. The aim is a time proportional to that number.
//!
//! Three costs do not depend on it: the mesh is built once, each plane tests every vertex in one batch and visits every
//! edge, and the end lists every triangle. So the reported time per crossed face is the difference between a run with
//! more planes and the run with the fewest planes. The batches of vertices are also timed alone.

use std::hint::black_box;
use std::time::Instant;

use predicament_corpus::Random;
use predicament_exact::Exact;
use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::IndexedFaces;
use predicament_predicates::{Backend, Off, Predicates, Scene, Sign, Vertex};
use predicament_slice::algorithm::slice;
use predicament_sos::Sos;

/// The number of cells around the torus in each direction: 999,698 triangles.
const AROUND: u32 = 707;
const PLANES: [usize; 4] = [10, 30, 60, 100];
const ROUNDS: usize = 3;

/// A torus with a bumpy surface, so that its vertices are in general position.
fn torus(random: &mut Random) -> (Scene, IndexedFaces, Vec<[Vertex; 3]>) {
    let turn = |at: u32| f64::from(at) / f64::from(AROUND) * std::f64::consts::TAU;
    let mut points = Vec::new();
    for (i, j) in (0..AROUND).flat_map(|i| (0..AROUND).map(move |j| (i, j))) {
        let thick = 0.375 + 1e-4 * random.unit();
        let radius = 1.0 + thick * turn(j).cos();
        points.push([radius * turn(i).cos(), radius * turn(i).sin(), thick * turn(j).sin()]);
    }
    let at = |i: u32, j: u32| i % AROUND * AROUND + j % AROUND;
    let cells = (0..AROUND).flat_map(|i| (0..AROUND).map(move |j| (i, j)));
    let triangles = cells.flat_map(|(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    let triangles: Vec<[u32; 3]> = triangles.collect();
    let supports = triangles.iter().map(|t| t.map(|v| Vertex::input(v as usize))).collect();
    (Scene::from_points3(&points).expect("finite"), triangles.into_iter().collect(), supports)
}

fn measured<B: Backend>(name: &str, backend: &B, planes: &[[Vertex; 3]]) {
    let (scene, faces, supports) = torus(&mut Random::new("torus", "bench", 1));
    let vertices: Vec<Vertex> = scene.vertices().collect();
    let mut base: Option<(f64, u64)> = None;
    for count in PLANES {
        let mut best = [f64::INFINITY; 2];
        let (mut split, mut parts) = (0, 0);
        for _ in 0..ROUNDS {
            let mesh = HalfEdgeMesh::new(vertices.clone(), &faces).expect("a torus");
            let mut session = backend.prepare(&scene, Off).unwrap_or_else(|why| panic!("{why}"));
            let start = Instant::now();
            let sliced = slice(&mut session, mesh, &supports, &planes[..count]).unwrap_or_else(|why| panic!("{why}"));
            best[0] = best[0].min(start.elapsed().as_secs_f64());
            assert_eq!(sliced.broken, None);
            (split, parts) = (sliced.faces_split, sliced.parts.len());
            black_box(sliced);
            let session = backend.prepare(&scene, Off).unwrap_or_else(|why| panic!("{why}"));
            let mut signs = vec![Sign::Zero; vertices.len()];
            let start = Instant::now();
            for plane in &planes[..count] {
                session.orient3d_plane(*plane, &vertices, &mut signs);
                black_box(&signs);
            }
            best[1] = best[1].min(start.elapsed().as_secs_f64());
        }
        let (fewest, fewer) = *base.get_or_insert((best[0], split));
        let each = if split > fewer {
            #[allow(clippy::cast_precision_loss)] // far fewer than 2^53
            let more = (split - fewer) as f64;
            format!("{:.2} µs for each more", (best[0] - fewest) / more * 1e6)
        } else {
            String::new()
        };
        println!(
            "{name}: {count} planes, {split} faces split, {parts} parts: {:.3} s, of which batches of input vertices {:.3} s; {each}",
            best[0], best[1]
        );
    }
}

fn main() {
    let last = i64::from(AROUND * AROUND) - 1;
    let mut random = Random::new("planes", "bench", 1);
    let mut vertex = || Vertex::input(usize::try_from(random.integer(0, last)).expect("from zero"));
    let planes: Vec<[Vertex; 3]> = (0..PLANES[PLANES.len() - 1]).map(|_| [vertex(), vertex(), vertex()]).collect();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    pool.install(|| {
        measured("exact", &Exact, &planes);
        measured("sos", &Sos::default(), &planes);
    });
}
