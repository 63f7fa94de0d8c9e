//! A benchmark of convex hulls on one thread, and in space once on all threads, against other libraries.
//!
//! A million points of a square run against `geo`; 10^5 points on a sphere and 10^6 in a cube against `parry3d`, with
//! the feature `peers`. All contestants take turns; the medians and their ratios are printed.
//!
//! `HULL_PROGRAMS` adds programs in other languages: `name=path`, separated by semicolons. A program gets a file of
//! coordinates (doubles, little-endian, three a point) and prints the seconds and the number of vertices.

use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use geo::ConvexHull;
use predicament_corpus::Random;
use predicament_exact::Exact;
use predicament_hull::algorithm::{PlaneMethod, SpaceMethod, hull2d, hull3d};
use predicament_predicates::{Backend, Dimension, Off, Predicates, Scene};
use predicament_sos::Sos;

const ROUNDS: usize = 9;

/// The time of a hull in seconds, and its number of vertices.
type Run = (f64, usize);
type Contestant<'a> = (String, Box<dyn Fn() -> Run + 'a>);

fn timed(work: impl FnOnce() -> usize) -> Run {
    let start = Instant::now();
    let vertices = black_box(work());
    (start.elapsed().as_secs_f64(), vertices)
}

/// The median of some times.
fn median(times: &mut [f64]) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Times all contestants in turns; prints medians, and ratios to the first.
fn compare(what: &str, contestants: &[Contestant<'_>]) {
    let mut times = vec![Vec::new(); contestants.len()];
    let mut vertices = vec![0; contestants.len()];
    for round in 0..ROUNDS {
        for turn in 0..contestants.len() {
            let at = (round + turn) % contestants.len();
            let (time, found) = contestants[at].1();
            times[at].push(time);
            vertices[at] = found;
        }
    }
    let medians: Vec<f64> = times.iter_mut().map(|times| median(times)).collect();
    println!("{what}");
    for (((name, _), time), vertices) in contestants.iter().zip(&medians).zip(vertices) {
        println!("  {name:<22} {:9.1} ms  {:5.2}  {vertices} vertices", 1e3 * time, time / medians[0]);
    }
}

fn plane(n: usize) {
    let mut random = Random::new("hull", "bench", 2);
    let points: Vec<[f64; 2]> = (0..n).map(|_| [random.unit(), random.unit()]).collect();
    let scene = Scene::from_points2(&points).expect("finite");
    let cloud = geo::MultiPoint::from(points);
    let (sos, exact) = (Sos::default(), Exact);
    let exact = exact.prepare(&scene, Off).expect("takes all");
    let sos = sos.prepare(&scene, Off).expect("takes all");
    let of = |session: &'_ dyn Predicates, method| timed(|| hull2d(session, method).vertices.len());
    let contestants: [Contestant<'_>; 5] = [
        ("exact, chain".into(), Box::new(|| of(&exact, PlaneMethod::Chain))),
        ("sos, chain".into(), Box::new(|| of(&sos, PlaneMethod::Chain))),
        ("exact, divide".into(), Box::new(|| of(&exact, PlaneMethod::Divide))),
        ("sos, divide".into(), Box::new(|| of(&sos, PlaneMethod::Divide))),
        ("geo".into(), Box::new(|| timed(|| cloud.convex_hull().exterior().0.len() - 1))),
    ];
    compare(&format!("hull2d, {n} points of a square"), &contestants);
}

/// The result that a program in another language prints.
fn program(path: &str, points: &Path) -> Run {
    let output = Command::new(path).arg(points).output().unwrap_or_else(|why| panic!("{path}: {why}"));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let mut words = text.split_ascii_whitespace();
    let time = words.next().and_then(|word| word.parse().ok());
    let vertices = words.next().and_then(|word| word.parse().ok());
    time.zip(vertices).unwrap_or_else(|| panic!("{path} printed `{text}`"))
}

fn space(what: &str, coordinates: Vec<f64>) {
    let points: PathBuf = std::env::temp_dir().join(format!("predicament-hull-{}.bin", std::process::id()));
    let programs = std::env::var("HULL_PROGRAMS").unwrap_or_default();
    if !programs.is_empty() {
        let bytes: Vec<u8> = coordinates.iter().flat_map(|x| x.to_le_bytes()).collect();
        std::fs::write(&points, bytes).expect("a temporary file");
    }
    let scene = Scene::new(Dimension::Three, coordinates).expect("finite");
    let (sos, exact) = (Sos::default(), Exact);
    let exact = exact.prepare(&scene, Off).expect("takes all");
    let sos = sos.prepare(&scene, Off).expect("takes all");
    let all = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = rayon::ThreadPoolBuilder::new().num_threads(all).build().expect("threads");
    let of = |session: &'_ dyn Predicates, method| timed(|| hull3d(session, method).vertices.len());
    let mut contestants: Vec<Contestant<'_>> = vec![
        ("exact, incremental".into(), Box::new(|| of(&exact, SpaceMethod::Incremental))),
        ("sos, incremental".into(), Box::new(|| of(&sos, SpaceMethod::Incremental))),
        ("exact, all threads".into(), Box::new(|| threads.install(|| of(&exact, SpaceMethod::Incremental)))),
        ("exact, divide".into(), Box::new(|| of(&exact, SpaceMethod::Divide))),
        ("sos, divide".into(), Box::new(|| of(&sos, SpaceMethod::Divide))),
    ];
    #[cfg(feature = "peers")]
    {
        let cloud: Vec<parry3d_f64::math::Vector> = scene
            .vertices()
            .map(|v| scene.point3(v))
            .map(|[x, y, z]| parry3d_f64::math::Vector::new(x, y, z))
            .collect();
        let parry = move || {
            timed(|| parry3d_f64::transformation::try_convex_hull(&cloud).map_or(0, |(vertices, _)| vertices.len()))
        };
        contestants.push(("parry3d".into(), Box::new(parry)));
    }
    for (name, path) in programs.split(';').filter_map(|named| named.split_once('=')) {
        contestants.push((name.to_owned(), Box::new(|| program(path, &points))));
    }
    compare(&format!("hull3d, {} points {what}", scene.len()), &contestants);
    if !programs.is_empty() {
        std::fs::remove_file(&points).expect("the temporary file");
    }
}

fn main() {
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().expect("the first use of threads");
    plane(1_000_000);
    let mut random = Random::new("hull", "bench", 3);
    let on_sphere = (0..100_000).flat_map(|_| {
        loop {
            let point = [(); 3].map(|()| random.between(-1.0, 1.0));
            let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
            if (0.1..=1.0).contains(&length) {
                return point.map(|x| x / length);
            }
        }
    });
    space("on a sphere", on_sphere.collect());
    space("in a cube", (0..3_000_000).map(|_| random.unit()).collect());
    let in_ball = (0..1_000_000).flat_map(|_| {
        loop {
            let point = [(); 3].map(|()| random.between(-1.0, 1.0));
            if point.iter().map(|x| x * x).sum::<f64>() <= 1.0 {
                return point;
            }
        }
    });
    space("in a ball", in_ball.collect());
}
