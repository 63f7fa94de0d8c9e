//! Benchmark: unions of large polygons on one thread, under exact and perturbed predicates, by a grid and by a sweep;
//! and once on all threads.
//!
//! The feature `peers` adds `i_overlay` and `geo`: they run on the same coordinates in the same run, in turns. Each way
//! has a process of its own: in a shared one, its time depends on the memory that other ways have given back. The aim:
//! two stars of 10^5 edges each within twice the time of `i_overlay`, which rounds to a grid of integers, and faster
//! than `geo` and GEOS.
//!
//! A program of another library can take part: the environment variable `PREDICAMENT_OVERLAY` names it. It reads two
//! rings, each as a line of coordinates separated by blanks, and prints the seconds that their union took.
//!
//! Our algorithm gets only loops of vertices, and makes oriented regions. Its time includes preparing the sessions,
//! because they construct the crossings.
//!
//! Arguments: the shapes to run, of `stars`, `smooth`, `combs` and `segments`; default all.

use std::fmt::Write as _;
use std::hint::black_box;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use predicament_corpus::{Level, Suite};
use predicament_exact::Exact;
use predicament_formats::{Cache, Manifest};
use predicament_overlay::algorithm::overlay::{Method, Operation, Polygon, Rule, arrange, operate};
use predicament_overlay::task::overlay::{Layered, Layers};
use predicament_predicates::{Backend, Off, Plane, Scene, Vertex};
use predicament_sos::Sos;

const ROUNDS: usize = 7;

/// A generated scene.
fn scene(family: &str, n: usize) -> (Scene, Layers) {
    let text = format!(
        "title = \"t\"\n[[generate]]\nfamily = \"overlay-{family}\"\ntask = \"overlay2d\"\nn = {n}\nseed = 1\n"
    );
    let suite = Suite::parse(predicament_bundle::vocabulary(), "bench.toml", &text, None, &Manifest::default());
    let loaded = suite.expect("a suite").scenes[0].load(Level::Quick, &Cache::new("nowhere")).expect("a scene");
    let content: &Layered = loaded.content().expect("layers");
    (loaded.scene.clone(), content.layers.clone())
}

/// Circles of n corners with slightly different centres: short edges, few crossings.
fn smooth(n: usize) -> (Scene, Layers) {
    let mut points = Vec::with_capacity(2 * n);
    for shift in [0.0, 0.25] {
        #[allow(clippy::cast_precision_loss)] // about
        points.extend((0..n).map(|i| {
            let angle = std::f64::consts::TAU * i as f64 / n as f64;
            let radius = 1.0 + 0.25 * (16.0 * angle).sin();
            [radius * angle.cos() + shift, radius * angle.sin()]
        }));
    }
    let ids = |from: usize| vec![(from..from + n).map(Vertex::input).collect()];
    (Scene::from_points2(&points).expect("finite"), Layers::Polygons([ids(0), ids(n)], Rule::NonZero))
}

/// A method with its name; the function returns the number of corners of the result, or of edges of the arrangement.
type Way<'a> = (&'static str, Box<dyn Fn() -> (usize, Option<Duration>) + Sync + 'a>);

fn ours<'a, B: Backend>(
    name: &'static str,
    backend: &'a B,
    scene: &'a Scene,
    layers: &'a Layers,
    method: Method,
) -> Way<'a> {
    let made = move || -> usize {
        let mut session = backend.prepare(scene, Off).expect("points");
        match layers {
            Layers::Segments(segments) => {
                let edges: Vec<_> =
                    segments.iter().map(|&[a, b]| predicament_overlay::algorithm::overlay::Edge::whole(a, b)).collect();
                arrange(&mut session, &edges, method).map_or(0, |made| made.pieces.len())
            }
            Layers::Polygons(loops, rule) => {
                let [a, b] = loops.each_ref().map(|loops| Polygon::of_vertices(loops, *rule));
                let Ok(made) = operate(&mut session, [&a, &b], Operation::Union, method) else { return 0 };
                made.regions.iter().flat_map(|region| region.loops()).map(Vec::len).sum()
            }
        }
    };
    (name, Box::new(move || (made(), None)))
}

/// The rings of both operands, as coordinates.
fn rings(scene: &Scene, layers: &Layers) -> Option<[Vec<Vec<[f64; 2]>>; 2]> {
    let Layers::Polygons(loops, _) = layers else { return None };
    let ring = |one: &Vec<Vertex>| one.iter().map(|&v| scene.point2(Plane::Xy, v)).collect();
    Some(loops.each_ref().map(|loops| loops.iter().map(ring).collect()))
}

#[cfg(feature = "peers")]
fn peers(rings: &[Vec<Vec<[f64; 2]>>; 2]) -> Vec<Way<'_>> {
    use geo::{BooleanOps, Coord, CoordsIter, LineString, Polygon as Area};
    use i_overlay::core::fill_rule::FillRule;
    use i_overlay::core::overlay_rule::OverlayRule;
    use i_overlay::float::single::SingleFloatOverlay;

    let area = |rings: &Vec<Vec<[f64; 2]>>| {
        let line = |ring: &Vec<[f64; 2]>| LineString::new(ring.iter().map(|&[x, y]| Coord { x, y }).collect());
        let mut lines = rings.iter().map(line);
        Area::new(lines.next().expect("an outer ring"), lines.collect())
    };
    let [a, b] = rings.each_ref().map(area);
    vec![
        (
            "i_overlay",
            Box::new(move || {
                let made = rings[0].overlay(&rings[1], OverlayRule::Union, FillRule::NonZero);
                (made.iter().flatten().map(Vec::len).sum(), None)
            }),
        ),
        ("geo", Box::new(move || (a.union(&b).coords_count(), None))),
    ]
}

#[cfg(not(feature = "peers"))]
fn peers(_: &[Vec<Vec<[f64; 2]>>; 2]) -> Vec<Way<'_>> {
    Vec::new()
}

/// Runs a program of another library, timed by its own clock.
fn program(rings: &[Vec<Vec<[f64; 2]>>; 2]) -> Option<Way<'_>> {
    let program = std::env::var_os("PREDICAMENT_OVERLAY")?;
    let run = move || {
        let mut text = String::new();
        for ring in rings.iter().flatten() {
            ring.as_flattened().iter().for_each(|x| write!(text, "{x:?} ").expect("strings take everything"));
            text.push('\n');
        }
        let mut child = Command::new(&program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("a program");
        std::io::Write::write_all(&mut child.stdin.take().expect("a pipe"), text.as_bytes()).expect("it reads");
        let out = child.wait_with_output().expect("it ends");
        let told = String::from_utf8_lossy(&out.stdout);
        let mut words = told.split_whitespace();
        let seconds: f64 = words.next().and_then(|word| word.parse().ok()).expect("seconds");
        let corners = words.next().and_then(|word| word.parse().ok()).unwrap_or(0);
        (corners, Some(Duration::from_secs_f64(seconds)))
    };
    Some(("program", Box::new(run)))
}

/// Calls a function with all ways to overlay a shape of this size.
fn with_ways(name: &str, n: usize, call: impl FnOnce(&[Way<'_>])) {
    let all = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = rayon::ThreadPoolBuilder::new().num_threads(all).build().expect("threads");
    let (scene, layers) = if name == "smooth" { smooth(n) } else { scene(name, n) };
    let rings = rings(&scene, &layers);
    let sos = Sos::default();
    let (_, on_one) = ours("exact, grid", &Exact, &scene, &layers, Method::Grid);
    let mut ways: Vec<Way<'_>> = vec![
        ours("exact, grid", &Exact, &scene, &layers, Method::Grid),
        ("exact, all threads", Box::new(|| threads.install(&on_one))),
        ours("sos, grid", &sos, &scene, &layers, Method::Grid),
    ];
    if n <= 100_000 {
        ways.push(ours("exact, sweep", &Exact, &scene, &layers, Method::Sweep));
    }
    if let Some(rings) = &rings {
        ways.extend(peers(rings));
        ways.extend(program(rings));
    }
    call(&ways);
}

/// The word for a process that times one way.
const ALONE: &str = "alone";

/// The time of a way in a process of its own, and the size of its result.
///
/// In one process for all it would depend on the memory that the ways before have given back.
fn alone(name: &str, n: usize, way: usize) -> (Duration, usize) {
    let program = std::env::current_exe().expect("this program");
    let asked = [ALONE, name, &n.to_string(), &way.to_string()];
    let out = Command::new(program).args(asked).stderr(Stdio::inherit()).output().expect("a process");
    let told = String::from_utf8_lossy(&out.stdout);
    let (seconds, count) = told.trim().split_once(' ').unwrap_or_else(|| panic!("{name} of {n}: no time of way {way}"));
    (Duration::from_secs_f64(seconds.parse().expect("seconds")), count.parse().expect("a number"))
}

/// Prints the seconds that a way takes in its second run, and the size of its result.
fn time_alone(name: &str, n: usize, way: usize) {
    with_ways(name, n, |ways| {
        let (_, run) = &ways[way];
        // The first run gets memory from the system.
        black_box(run());
        let start = Instant::now();
        let (count, own) = black_box(run());
        println!("{} {count}", own.unwrap_or_else(|| start.elapsed()).as_secs_f64());
    });
}

fn main() {
    // One thread for everything; index structures would use all.
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().expect("no pool before");
    let words: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    if let [first, name, n, way] = &words[..]
        && first == ALONE
    {
        return time_alone(name, n.parse().expect("a size"), way.parse().expect("a number"));
    }
    let sizes = [
        ("stars", [10_000, 100_000]),
        ("smooth", [10_000, 100_000]),
        ("combs", [400, 2_000]),
        ("segments", [10_000, 1_000_000]),
    ];
    for (name, sizes) in sizes.into_iter().filter(|(name, _)| words.is_empty() || words.iter().any(|w| w == name)) {
        for n in sizes {
            let mut names = Vec::new();
            with_ways(name, n, |ways| names.extend(ways.iter().map(|(name, _)| *name)));
            let mut times = vec![Vec::new(); names.len()];
            let mut corners = vec![0; names.len()];
            for _ in 0..ROUNDS {
                for (way, (times, corners)) in times.iter_mut().zip(&mut corners).enumerate() {
                    // A slow run is measured once.
                    if times.first().is_none_or(|first: &Duration| first.as_secs_f64() < 2.0) {
                        let (time, count) = alone(name, n, way);
                        times.push(time);
                        *corners = count;
                    }
                }
            }
            println!("{name} of {n}, {ROUNDS} rounds in turns, medians:");
            let first = median(&mut times[0]);
            for ((way, times), corners) in names.iter().zip(&mut times).zip(&corners) {
                let time = median(times);
                println!("  {way:18} {time:10.2} ms   {:6.2} × ours   {corners} corners", time / first);
            }
        }
    }
}

/// The median of measured times, in milliseconds.
fn median(times: &mut [Duration]) -> f64 {
    times.sort_unstable();
    times[times.len() / 2].as_secs_f64() * 1e3
}
