//! A benchmark of Delaunay triangulations of a million points on one thread, and once on all threads; with the feature
//! `peers` against `spade` and `delaunator`.
//!
//! All contestants take turns; the medians and their ratios are printed. Our time ends at the last edge of the
//! canonical rule. The task also lists the triangles sorted: that is timed separately.
//!
//! `DELAUNAY_PROGRAMS` adds programs in other languages: `name=path`, separated by semicolons. A program gets a file of
//! coordinates (doubles, little-endian, two a point) and prints the seconds and the number of triangles.
//!
//! Arguments: the families to run, of `uniform`, `grid`, `rings`, `clusters` and `sliver`; all by default.

use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use predicament_corpus::{Level, Suite};
use predicament_delaunay::algorithm::delaunay2d;
use predicament_exact::Exact;
use predicament_formats::{Cache, Manifest};
use predicament_predicates::{Backend, Off, Predicates, Scene};
use predicament_sos::Sos;

const ROUNDS: usize = 5;

/// The time of a triangulation in seconds, and its number of triangles.
type Run = (f64, usize);
type Contestant<'a> = (String, Box<dyn Fn() -> Run + 'a>);

fn timed(work: impl FnOnce() -> usize) -> Run {
    let start = Instant::now();
    let triangles = black_box(work());
    (start.elapsed().as_secs_f64(), triangles)
}

/// Times the construction of a structure, without counting its triangles.
fn built<T>(work: impl FnOnce() -> T, count: impl FnOnce(&T) -> usize) -> Run {
    let start = Instant::now();
    let structure = black_box(work());
    let time = start.elapsed().as_secs_f64();
    (time, count(&structure))
}

/// The median of some times.
fn median(times: &mut [f64]) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Times all contestants in turns; prints medians, and ratios to the first.
fn compare(what: &str, contestants: &[Contestant<'_>]) {
    let mut times = vec![Vec::new(); contestants.len()];
    let mut triangles = vec![0; contestants.len()];
    for round in 0..ROUNDS {
        for turn in 0..contestants.len() {
            let at = (round + turn) % contestants.len();
            let (time, found) = contestants[at].1();
            times[at].push(time);
            triangles[at] = found;
        }
    }
    let medians: Vec<f64> = times.iter_mut().map(|times| median(times)).collect();
    println!("{what}");
    for (((name, _), time), triangles) in contestants.iter().zip(&medians).zip(triangles) {
        println!("  {name:<26} {:9.1} ms  {:5.2}  {triangles} triangles", 1e3 * time, time / medians[0]);
    }
}

/// The points of a family.
fn points(family: &str, n: usize) -> Scene {
    let text =
        format!("title = \"t\"\n[[generate]]\nfamily = \"{family}\"\ntask = \"delaunay2d\"\nn = {n}\nseed = 1\n");
    let suite = Suite::parse(predicament_bundle::vocabulary(), "bench.toml", &text, None, &Manifest::default());
    suite.expect("a suite").scenes[0].load(Level::Quick, &Cache::new("nowhere")).expect("points").scene
}

/// The result that a program in another language prints.
fn program(path: &str, points: &Path) -> Run {
    let output = Command::new(path).arg(points).output().unwrap_or_else(|why| panic!("{path}: {why}"));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let mut words = text.split_ascii_whitespace();
    let time = words.next().and_then(|word| word.parse().ok());
    let triangles = words.next().and_then(|word| word.parse().ok());
    time.zip(triangles).unwrap_or_else(|| panic!("{path} printed `{text}`"))
}

#[cfg(feature = "peers")]
fn peers(scene: &Scene) -> Vec<Contestant<'_>> {
    use spade::Triangulation as _;

    let points = || scene.coordinates().as_chunks::<2>().0.iter();
    let spade: Vec<spade::Point2<f64>> = points().map(|&[x, y]| spade::Point2::new(x, y)).collect();
    let delaunator: Vec<delaunator::Point> = points().map(|&[x, y]| delaunator::Point { x, y }).collect();
    let of_spade = move || {
        let vertices = spade.clone();
        built(
            || spade::DelaunayTriangulation::<spade::Point2<f64>>::bulk_load(vertices).expect("finite"),
            |found| found.num_inner_faces(),
        )
    };
    let of_delaunator = move || built(|| delaunator::triangulate(&delaunator), |found| found.triangles.len() / 3);
    vec![("spade, bulk".into(), Box::new(of_spade)), ("delaunator".into(), Box::new(of_delaunator))]
}

#[cfg(not(feature = "peers"))]
fn peers(_: &Scene) -> Vec<Contestant<'_>> {
    Vec::new()
}

fn family(name: &str, family: &str, n: usize) {
    let scene = points(family, n);
    let programs = std::env::var("DELAUNAY_PROGRAMS").unwrap_or_default();
    let file: PathBuf = std::env::temp_dir().join(format!("predicament-delaunay-{}.bin", std::process::id()));
    if !programs.is_empty() {
        let bytes: Vec<u8> = scene.coordinates().iter().flat_map(|x| x.to_le_bytes()).collect();
        std::fs::write(&file, bytes).expect("a temporary file");
    }
    let (sos, exact) = (Sos::default(), Exact);
    let exact = exact.prepare(&scene, Off).expect("takes all");
    let sos = sos.prepare(&scene, Off).expect("takes all");
    let dynamic: &dyn Predicates = &exact;
    let threads = rayon::ThreadPoolBuilder::new().num_threads(all_threads()).build().expect("threads");
    let mut contestants: Vec<Contestant<'_>> = vec![
        ("exact".into(), Box::new(|| built(|| delaunay2d(&exact), |found| found.count()))),
        ("sos".into(), Box::new(|| built(|| delaunay2d(&sos), |found| found.count()))),
        ("exact, by dynamic calls".into(), Box::new(|| built(|| delaunay2d(dynamic), |found| found.count()))),
        (
            "exact, all threads".into(),
            Box::new(|| threads.install(|| built(|| delaunay2d(&exact), |found| found.count()))),
        ),
        ("exact, listed and sorted".into(), Box::new(|| timed(|| delaunay2d(&exact).answer().triangles.len()))),
    ];
    contestants.extend(peers(&scene));
    for (name, path) in programs.split(';').filter_map(|named| named.split_once('=')) {
        contestants.push((name.to_owned(), Box::new(|| program(path, &file))));
    }
    compare(&format!("{name}, {n} points"), &contestants);
    if !programs.is_empty() {
        std::fs::remove_file(&file).expect("the temporary file");
    }
}

/// The number of threads of the machine.
fn all_threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

fn main() {
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().expect("the first use of threads");
    let wanted: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    for (name, of, n) in [
        ("uniform", "delaunay-uniform", 1_000_000),
        ("grid", "delaunay-grid", 1_000_000),
        ("rings", "delaunay-rings", 1_000_000),
        ("clusters", "delaunay-clusters", 1_000_000),
        ("sliver", "delaunay-sliver", 1_000_000),
    ] {
        if wanted.is_empty() || wanted.iter().any(|w| w == name) {
            family(name, of, n);
        }
    }
}
