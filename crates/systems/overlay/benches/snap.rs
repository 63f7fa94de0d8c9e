//! Benchmark: snap rounding of segments with a million crossings, on one thread and on all.
//!
//! Each time is listed beside the number of crossings. The time should grow at most as n·log n with that number. The
//! crossings are found beforehand, in the overlay's time.

use std::hint::black_box;
use std::time::Instant;

use predicament_corpus::Random;
use predicament_exact::Exact;
use predicament_overlay::algorithm::overlay::{self, Edge, arrange};
use predicament_overlay::algorithm::snap::{Drawing, Method, snap};
use predicament_predicates::{Backend, Construction, Off, Predicates, Scene, Vertex};

const SEGMENTS: [usize; 5] = [200, 400, 800, 1600, 3000];
const ROUNDS: usize = 3;
/// The binary logarithms of the pixel sizes: with 2^-20 few crossings share a pixel, with 2^-9 most do.
const PIXELS: [i32; 2] = [-20, -9];

fn main() {
    let all = std::thread::available_parallelism().map_or(1, usize::from);
    for threads in [1, all] {
        println!("threads: {threads}");
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads").install(measured);
    }
}

fn measured() {
    for count in SEGMENTS {
        let mut random = Random::new("snap", "bench", 1);
        let points: Vec<[f64; 2]> = (0..2 * count).map(|_| [random.unit(), random.unit()]).collect();
        let scene = Scene::from_points2(&points).expect("finite");
        let exact = Exact;
        let mut session = exact.prepare(&scene, Off).unwrap_or_else(|why| panic!("{why}"));
        let edges: Vec<Edge> =
            (0..count).map(|at| Edge::whole(Vertex::input(2 * at), Vertex::input(2 * at + 1))).collect();
        let start = Instant::now();
        let arrangement = arrange(&mut session, &edges, overlay::Method::Grid).unwrap_or_else(|why| panic!("{why}"));
        let arranged = start.elapsed().as_secs_f64();
        let number = |v: Vertex| u32::try_from(v.index()).expect("few points");
        let segments: Vec<[u32; 2]> = arrangement.segments.iter().map(|ends| ends.map(number)).collect();
        let constructed = arrangement.vertices.iter().filter_map(|&v| session.scene().construction(v));
        let crossings: Vec<[u32; 2]> = constructed
            .filter_map(|construction| match construction {
                Construction::Ssi(lines) => Some(lines.map(|mut ends| {
                    ends.sort_unstable();
                    let at = arrangement.segments.binary_search(&ends).expect("one of the segments");
                    u32::try_from(at).expect("few segments")
                })),
                Construction::Lpi { .. } | Construction::Tpi(_) | Construction::Ratio { .. } => None,
            })
            .collect();
        for pixel in PIXELS {
            for method in [Method::Naive, Method::Snap, Method::Iterated] {
                let drawing = Drawing { points: &points, segments: &segments, crossings: &crossings, touching: &[] };
                let mut best = f64::INFINITY;
                let (mut hot, mut nodes) = (0, 0);
                for _ in 0..ROUNDS {
                    let start = Instant::now();
                    let snapped = snap(drawing, pixel, method).unwrap_or_else(|why| panic!("{why}"));
                    best = best.min(start.elapsed().as_secs_f64());
                    (hot, nodes) = (snapped.pixels.len(), snapped.chains.iter().map(Vec::len).sum());
                    black_box(snapped);
                }
                #[allow(clippy::cast_precision_loss)] // far fewer than 2^53
                let each = best / crossings.len() as f64 * 1e9;
                println!(
                    "{count} segments, {} crossings (arranged in {arranged:.3} s), pixels of 2^{pixel}, {method:?}: {hot} hot, chains of \
                     {nodes}, {best:.3} s, {each:.0} ns a crossing",
                    crossings.len()
                );
            }
        }
    }
}
