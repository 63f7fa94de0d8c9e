//! Builds half-edge meshes from a million triangles and converts them back, on one thread. Inputs are the triangles of
//! a grid row by row, and the same with triangles and vertices shuffled. The aim is at most twice the time of sorting
//! the edges once.
//!
//! The sort is of vertex pairs with the index of the half-edge, which would give the opposites. The measurements
//! alternate; the program prints the medians and their ratios.

use std::hint::black_box;
use std::time::{Duration, Instant};

use predicament_corpus::Random;
use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::IndexedFaces;
use predicament_predicates::Vertex;

/// The number of cells along a side of the grid: 999,698 triangles.
const SIDE: u32 = 707;
const ROUNDS: usize = 21;

fn grid() -> Vec<[u32; 3]> {
    let wide = SIDE + 1;
    let cell = |x: u32, y: u32| {
        let a = y * wide + x;
        [[a, a + 1, a + wide + 1], [a, a + wide + 1, a + wide]]
    };
    (0..SIDE).flat_map(|y| (0..SIDE).flat_map(move |x| cell(x, y))).collect()
}

fn shuffle<T>(list: &mut [T], random: &mut Random) {
    for at in (1..list.len()).rev() {
        let last = i64::try_from(at).expect("a million");
        list.swap(at, usize::try_from(random.integer(0, last)).expect("from zero"));
    }
}

/// The surface with triangles and vertices in random order.
fn shuffled(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut random = Random::new("half-edge", "bench", 1);
    let mut names: Vec<u32> = (0..(SIDE + 1) * (SIDE + 1)).collect();
    shuffle(&mut names, &mut random);
    let mut triangles: Vec<[u32; 3]> = triangles.iter().map(|corners| corners.map(|v| names[v as usize])).collect();
    shuffle(&mut triangles, &mut random);
    triangles
}

fn sorted_edges(faces: &IndexedFaces) -> Vec<(u32, u32, u32)> {
    let triangles = faces.corners().as_chunks::<3>().0;
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut edges: Vec<_> = sides.zip(0..).map(|([a, b], at)| (a.min(b), a.max(b), at)).collect();
    edges.sort_unstable();
    edges
}

fn timed<T>(times: &mut Vec<Duration>, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let made = black_box(work());
    times.push(start.elapsed());
    made
}

/// The median of some times, in seconds.
fn median(mut times: Vec<Duration>) -> f64 {
    times.sort_unstable();
    times[times.len() / 2].as_secs_f64()
}

fn main() {
    let in_order = grid();
    for (name, triangles) in [("in order", &in_order), ("shuffled", &shuffled(&in_order))] {
        let faces: IndexedFaces = triangles.iter().copied().collect();
        let vertices: Vec<Vertex> = (0..((SIDE + 1) * (SIDE + 1)) as usize).map(Vertex::input).collect();
        let mut times = [const { Vec::new() }; 4];
        for _ in 0..ROUNDS {
            let vertices = vertices.clone();
            let [sorting, building, validating, listing] = &mut times;
            let edges = timed(sorting, || sorted_edges(&faces));
            let mesh = timed(building, || HalfEdgeMesh::new(vertices, &faces)).expect("a grid");
            assert_eq!(timed(validating, || mesh.validate()), Ok(()));
            let (_, listed) = timed(listing, || mesh.to_indexed());
            assert_eq!(listed, faces);
            let mut pairs: Vec<(u32, u32)> = edges.into_iter().map(|(a, b, _)| (a, b)).collect();
            pairs.dedup();
            assert_eq!(mesh.edge_count(), pairs.len());
        }
        let [sorting, building, validating, listing] = times.map(median);
        println!("{name}: {} triangles, medians of {ROUNDS} rounds", triangles.len());
        for (what, time) in [
            ("sort the edges", sorting),
            ("half-edges from triangles", building),
            ("validate", validating),
            ("triangles from half-edges", listing),
        ] {
            println!("  {what:<26} {:>7.1} ms, {:.2} of sorting", time * 1e3, time / sorting);
        }
    }
}
