//! Benchmark: a torus of 100,000 triangles, simplified to 10,000, on one thread.
//!
//! The bumpy torus is in general position, and the smooth one is not. The time of building the mesh is left out.

use std::hint::black_box;
use std::time::Instant;

use predicament_corpus::Random;
use predicament_exact::Exact;
use predicament_mesh::HalfEdgeMesh;
use predicament_predicates::{Backend, Off, Scene, Vertex};
use predicament_simplify::algorithm::simplify;
use predicament_simplify::answer::Step;
use predicament_sos::Sos;

/// The number of cells around the torus in each direction.
const AROUND: u32 = 224;
const TARGET: usize = 10_000;
const ROUNDS: usize = 3;

fn torus(bump: f64) -> (Scene, Vec<[Vertex; 3]>) {
    let mut random = Random::new("torus", "bench", 1);
    let turn = |at: u32| f64::from(at) / f64::from(AROUND) * std::f64::consts::TAU;
    let mut points = Vec::new();
    for (i, j) in (0..AROUND).flat_map(|i| (0..AROUND).map(move |j| (i, j))) {
        let thick = 0.375 + bump * random.unit();
        let radius = 1.0 + thick * turn(j).cos();
        points.push([radius * turn(i).cos(), radius * turn(i).sin(), thick * turn(j).sin()]);
    }
    let at = |i: u32, j: u32| Vertex::input((i % AROUND * AROUND + j % AROUND) as usize);
    let cells = (0..AROUND).flat_map(|i| (0..AROUND).map(move |j| (i, j)));
    let triangles = cells.flat_map(|(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    let triangles = triangles.collect();
    (Scene::from_points3(&points).expect("finite"), triangles)
}

fn measured<B: Backend>(name: &str, backend: &B, scene: &Scene, triangles: &[[Vertex; 3]]) {
    let mut best = f64::INFINITY;
    let mut steps = Vec::new();
    for _ in 0..ROUNDS {
        let mesh = HalfEdgeMesh::of_scene(scene.len(), triangles).expect("a torus");
        let session = backend.prepare(scene, Off).unwrap_or_else(|why| panic!("{why}"));
        let start = Instant::now();
        let Ok(answer) = simplify(&session, mesh, TARGET, &mut |_| Ok::<_, std::convert::Infallible>(()));
        best = best.min(start.elapsed().as_secs_f64());
        assert!(answer.triangles.len() <= TARGET, "{} triangles", answer.triangles.len());
        steps = black_box(answer).steps;
    }
    let refused = steps.iter().filter(|step| matches!(step, Step::Refusal { .. })).count();
    println!("{name}: {:.3} s, {} collapses, {refused} refused", best, steps.len() - refused);
}

fn main() {
    for (kind, bump) in [("smooth", 0.0), ("bumpy", 1e-4)] {
        let (scene, triangles) = torus(bump);
        println!("{kind}: {} triangles to {TARGET}", triangles.len());
        measured("exact", &Exact, &scene, &triangles);
        measured("sos", &Sos::default(), &scene, &triangles);
    }
}
