//! Triangulations and hulls of three published crates, with their times and a checksum of their results.
//!
//! Run it twice and compare the lines:
//!
//! ```text
//! cargo run --release
//! cargo run --release --config 'patch.crates-io.robust.path="robust"'
//! ```
//!
//! The first run uses the published `robust`, the second one `predicament-exact` by the same functions. Where `robust`
//! is right, all checksums are equal. The last line is a triangle with sides of 1e-200, whose area underflows: `robust`
//! calls its corners collinear.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::time::{Duration, Instant};

use geo::{
    ConvexHull, MultiPoint, Orientation, Point,
    kernels::{Kernel, RobustKernel},
};
use spade::{DelaunayTriangulation, Point2, Triangulation};

const RUNS: usize = 5;

/// SplitMix64 (Steele, Lea and Flood 2014), as a number from 0 to 1.
fn noise(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut x = *state;
    x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    f64::from(u32::try_from((x ^ x >> 31) >> 32).expect("32 bits")) / 4_294_967_296.0
}

/// The inputs that the crates' own tests and benches use: uniform points, a grid, a circle, and nearly collinear
/// points.
fn inputs() -> Vec<(&'static str, Vec<[f64; 2]>)> {
    let mut state = 1;
    let mut make = |count: u32, point: &dyn Fn(f64, f64, f64) -> [f64; 2]| -> Vec<[f64; 2]> {
        (0..count).map(|index| point(f64::from(index), noise(&mut state), noise(&mut state))).collect()
    };
    let side = 447.0;
    vec![
        ("uniform", make(200_000, &|_, x, y| [x, y])),
        ("grid", make(200_000, &|index, _, _| [index % side, (index / side).floor()])),
        ("circle", make(20_000, &|index, _, _| [index.cos(), index.sin()])),
        ("nearly collinear", make(10_000, &|_, x, y| [x, 0.3 * x + 0.1 + (y * 4.0).floor() * f64::EPSILON])),
    ]
}

/// The shortest time of some runs, and the checksum of the result.
fn timed<R: Hash>(work: impl Fn() -> R) -> (Duration, u64) {
    let run = |_| {
        let start = Instant::now();
        let result = work();
        let time = start.elapsed();
        let mut hasher = DefaultHasher::new();
        result.hash(&mut hasher);
        (time, hasher.finish())
    };
    (0..RUNS).map(run).min().expect("runs")
}

fn main() {
    println!("{:18} {:12} {:>10} {:>17}", "points", "algorithm", "seconds", "checksum");
    for (name, points) in inputs() {
        let line = |algorithm: &str, (time, checksum): (Duration, u64)| {
            println!("{name:18} {algorithm:12} {:10.4} {checksum:17x}", time.as_secs_f64());
        };
        line(
            "delaunator",
            timed(|| {
                let points: Vec<_> = points.iter().map(|&[x, y]| delaunator::Point { x, y }).collect();
                delaunator::triangulate(&points).triangles
            }),
        );
        line(
            "spade",
            timed(|| {
                let points = points.iter().map(|&[x, y]| Point2::new(x, y)).collect();
                let mesh = DelaunayTriangulation::<Point2<f64>>::bulk_load(points).expect("coordinates in its range");
                let triangles = mesh.inner_faces().map(|face| face.vertices().map(|vertex| vertex.index()));
                triangles.collect::<Vec<_>>()
            }),
        );
        line(
            "geo's hull",
            timed(|| {
                let points: MultiPoint = points.iter().map(|&[x, y]| Point::new(x, y)).collect();
                let hull = points.convex_hull();
                hull.exterior().coords().map(|p| [p.x.to_bits(), p.y.to_bits()]).collect::<Vec<_>>()
            }),
        );
    }
    let corner = |x, y| Point::new(x, y).0;
    let turn = RobustKernel::orient2d(corner(0.0, 0.0), corner(1e-200, 0.0), corner(0.0, 1e-200));
    println!(
        "a triangle with sides of 1e-200: {turn:?}{}",
        if turn == Orientation::Collinear { ", which is wrong" } else { "" }
    );
}
