//! Triangulation of large polygons on one thread, by the sweep and by ear clipping, under exact and perturbed
//! predicates.
//!
//! The feature `peers` adds `earcutr` and `i_triangle`: they run on the same coordinates in the same run, in turns. The
//! aims: a star of 10^5 vertices faster than `earcutr` and within 1.5 times `i_triangle`; a spiral and combs as n·log
//! n.
//!
//! Our algorithm gets the loop and nothing else, so its time includes sorting. Sessions are prepared before the clock
//! starts.
//!
//! Arguments: the shapes to run, of `star`, `spiral`, `comb` and `sideways` (default: all); and `sweeps`, which leaves
//! out the peers and ear clipping, because they are quadratic on some shapes.

use std::hint::black_box;
use std::time::{Duration, Instant};

use predicament_corpus::{Level, Suite};
use predicament_exact::Exact;
use predicament_formats::{Cache, Manifest};
use predicament_predicates::{Backend, Off, Plane, Predicates, Scene, Vertex};
use predicament_sos::Sos;
use predicament_triangulate::algorithm::{Method, triangulate};
use predicament_triangulate::task::Polygons;

const ROUNDS: usize = 7;

/// A generated polygon with about n vertices.
fn polygon(family: &str, n: usize) -> (Scene, Vec<Vec<Vertex>>) {
    let text = format!("title = \"t\"\n[[generate]]\n{family}\ntask = \"triangulate\"\nn = {n}\nseed = 1\n");
    let suite = Suite::parse(predicament_bundle::vocabulary(), "bench.toml", &text, None, &Manifest::default());
    let loaded = suite.expect("a suite").scenes[0].load(Level::Quick, &Cache::new("nowhere")).expect("a polygon");
    let polygons: &Polygons = loaded.content().expect("polygons");
    let loops = polygons.polygons[0].clone();
    (loaded.scene, loops)
}

/// A triangulation method with its name; the function returns the number of triangles.
type Way<'a> = (&'static str, Box<dyn Fn() -> usize + 'a>);

fn ours<'a, P: Predicates>(name: &'static str, session: &'a P, loops: &'a [Vec<Vertex>], method: Method) -> Way<'a> {
    (name, Box::new(move || triangulate(session, Plane::Xy, false, loops, method).triangles.len()))
}

#[cfg(feature = "peers")]
fn peers(points: &[[f64; 2]]) -> Vec<Way<'_>> {
    use i_triangle::float::triangulatable::Triangulatable;
    use i_triangle::float::unchecked::UncheckedTriangulatable;

    let flat = points.as_flattened();
    vec![
        ("earcutr", Box::new(move || earcutr::earcut(flat, &[], 2).map_or(0, |corners| corners.len() / 3))),
        ("i_triangle", Box::new(move || points.triangulate().to_triangulation::<u32>().indices.len() / 3)),
        (
            "i_triangle, i64",
            Box::new(move || points.triangulate_as::<i64>().to_triangulation::<u32>().indices.len() / 3),
        ),
        (
            "i_triangle, unchecked",
            Box::new(move || points.unchecked_triangulate().to_triangulation::<u32>().indices.len() / 3),
        ),
    ]
}

#[cfg(not(feature = "peers"))]
fn peers(_: &[[f64; 2]]) -> Vec<Way<'_>> {
    Vec::new()
}

/// The median of measured times, in milliseconds.
fn median(times: &mut [Duration]) -> f64 {
    times.sort_unstable();
    times[times.len() / 2].as_secs_f64() * 1e3
}

fn main() {
    let shapes = [
        ("star", "family = \"polygon-star\""),
        ("spiral", "family = \"polygon-spiral\""),
        ("comb", "family = \"polygon-comb\""),
        ("sideways", "family = \"polygon-comb\"\nteeth = \"sideways\""),
    ];
    let wanted: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let only_sweeps = wanted.iter().any(|w| w == "sweeps");
    let is_wanted = |name: &str| wanted.iter().all(|w| w == "sweeps") || wanted.iter().any(|w| w == name);
    for (name, family) in shapes.into_iter().filter(|(name, _)| is_wanted(name)) {
        for n in [10_000, 100_000, 1_000_000] {
            let (scene, loops) = polygon(family, n);
            let points: Vec<[f64; 2]> = loops[0].iter().map(|&v| scene.point2(Plane::Xy, v)).collect();
            let exact = Exact.prepare(&scene, Off).expect("points");
            let sos = Sos::default();
            let sos = sos.prepare(&scene, Off).expect("points");
            let dynamic: &dyn Predicates = &exact;
            let mut ways = vec![
                ours("exact, sweep", &exact, &loops, Method::Monotone),
                ours("sos, sweep", &sos, &loops, Method::Monotone),
                (
                    "exact, sweep, by dynamic calls",
                    Box::new(|| triangulate(dynamic, Plane::Xy, false, &loops, Method::Monotone).triangles.len()),
                ),
            ];
            if n <= 100_000 && !only_sweeps {
                ways.push(ours("exact, ears", &exact, &loops, Method::Ears));
            }
            if n <= 100_000 && !only_sweeps {
                ways.extend(peers(&points));
            }
            let mut times = vec![Vec::new(); ways.len()];
            let mut triangles = vec![0; ways.len()];
            for _ in 0..ROUNDS {
                for ((_, way), (times, triangles)) in ways.iter().zip(times.iter_mut().zip(&mut triangles)) {
                    // A slow run is measured once.
                    if times.first().is_none_or(|first: &Duration| first.as_secs_f64() < 2.0) {
                        let start = Instant::now();
                        *triangles = black_box(way());
                        times.push(start.elapsed());
                    }
                }
            }
            let medians: Vec<f64> = times.iter_mut().map(|times| median(times)).collect();
            println!("{name} of {} vertices, {ROUNDS} rounds in turns, medians:", points.len());
            for (((way, _), median), triangles) in ways.iter().zip(&medians).zip(&triangles) {
                println!("  {way:32} {median:10.2} ms   {:6.2} × ours   {triangles} triangles", median / medians[0]);
            }
        }
    }
}
