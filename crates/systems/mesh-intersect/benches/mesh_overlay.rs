//! Benchmark: unions of two meshes, on one thread and on all. The phases: checking the meshes, preparing a session, the
//! overlay, and taking the solid.
//!
//! Backends take turns; the benchmark prints medians, and ratios of totals to the first. Volumes are compared before
//! any time is shown.
//!
//! Arguments (default: all): `6`, `7` and `8` are numbers of subdivisions of an icosahedron's faces into four, for two
//! spheres of 81,920, 327,680 or 1,310,720 triangles each. The second sphere is moved by (0.5, 0.3, 0.1). `same` is a
//! mesh with itself, and `cubes` is two stacks of boxes that share faces; there `sos`, which moves each vertex, is left
//! out.
//!
//! Programs of other libraries take part if `MESH_OVERLAY_PROGRAMS` names them: `name=command`, separated by
//! semicolons, words of a command separated by blanks. They get the files of two closed meshes, each counterclockwise
//! as seen from outside: two 64-bit counts, of points and of triangles, then coordinates as doubles, three for each
//! point, then 32-bit indices, three for each triangle; all little-endian. They print the seconds that the union took
//! (without reading), the number of its triangles, and its volume. They choose their number of threads.
//! `mesh_overlay.py` beside this file is such a program for Manifold, libigl and trueform.

#[path = "closed.rs"]
mod closed;

use std::collections::HashMap;
use std::hint::black_box;
use std::path::PathBuf;
use std::process::Command;
use std::sync::Arc;
use std::time::Instant;

use predicament_exact::Exact;
use predicament_mesh::MaterialMesh;
use predicament_mesh_intersect::algorithm::overlay::{Zeros, mesh_overlay};
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use predicament_sos::{PerMesh, Sos};

use self::closed::{Closed, index, place, sixth};

/// Pairs of a maximum number of triangles in a mesh and the number of rounds.
const ROUNDS: [(usize, usize); 2] = [(100_000, 5), (usize::MAX, 3)];
const PHASES: [&str; 4] = ["check", "prepare", "overlay", "solid"];
/// The maximum relative difference of equal volumes: they are sums of doubles.
const ALIKE: f64 = 1e-9;

/// The time of a union, in seconds, and its result.
#[derive(Clone, Copy, Default)]
struct Run {
    total: f64,
    /// The times of [`PHASES`]; zeros if they are not reported.
    phases: [f64; 4],
    triangles: usize,
    volume: f64,
}

type Contestant<'a> = (String, Box<dyn Fn() -> Run + Sync + 'a>);

impl Closed {
    /// An icosahedron, with each face subdivided into four `levels` times, projected to a sphere around the origin.
    fn sphere(levels: usize) -> Closed {
        let on_sphere = |p: [f64; 3]| {
            let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
            p.map(|x| x / length)
        };
        let golden = f64::midpoint(1.0, 5f64.sqrt());
        let corners = [[-1.0, golden], [1.0, golden], [-1.0, -golden], [1.0, -golden]];
        let turned = (0..3).flat_map(|turn| {
            corners.map(|[a, b]| {
                let mut p = [a, b, 0.0];
                p.rotate_right(turn);
                on_sphere(p)
            })
        });
        let mut points: Vec<[f64; 3]> = turned.collect();
        let mut triangles: Vec<[u32; 3]> = vec![
            [0, 11, 5],
            [0, 5, 1],
            [0, 1, 7],
            [0, 7, 10],
            [0, 10, 11],
            [1, 5, 9],
            [5, 11, 4],
            [11, 10, 2],
            [10, 7, 6],
            [7, 1, 8],
            [3, 9, 4],
            [3, 4, 2],
            [3, 2, 6],
            [3, 6, 8],
            [3, 8, 9],
            [4, 9, 5],
            [2, 4, 11],
            [6, 2, 10],
            [8, 6, 7],
            [9, 8, 1],
        ];
        for _ in 0..levels {
            let mut middles: HashMap<[u32; 2], u32> = HashMap::with_capacity(2 * triangles.len());
            let mut middle = |a: u32, b: u32| {
                *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    let [p, q] = [points[a as usize], points[b as usize]];
                    points.push(on_sphere([0, 1, 2].map(|i: usize| p[i] + q[i])));
                    index(points.len() - 1)
                })
            };
            let mut finer = Vec::with_capacity(4 * triangles.len());
            for &[a, b, c] in &triangles {
                let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
            }
            triangles = finer;
        }
        Closed { points, triangles }
    }

    /// Separate unit cubes, `side` along each axis, with gaps large enough for another cube.
    fn stacks(side: u32) -> Closed {
        let mut all = Closed { points: Vec::new(), triangles: Vec::new() };
        let cells = (0..side.pow(3)).map(|cell| [cell / side / side, cell / side % side, cell % side]);
        for cell in cells {
            let first = index(all.points.len());
            for corner in 0..8 {
                all.points.push([0, 1, 2].map(|i: usize| f64::from(2 * cell[i] + (corner >> i & 1))));
            }
            for [a, b, c, d] in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
                all.triangles.extend([[a, b, c], [a, c, d]].map(|corners: [u32; 3]| corners.map(|at| first + at)));
            }
        }
        all
    }
}

/// Two meshes in one scene.
struct Pair {
    closed: [Closed; 2],
    scene: Scene,
    corners: [Vec<[Vertex; 3]>; 2],
}

impl Pair {
    fn new(closed: [Closed; 2]) -> Pair {
        let (scene, corners) = closed::scene(closed.each_ref());
        Pair { closed, scene, corners }
    }

    /// The union by a backend, timed by phase.
    fn union<B: Backend>(&self, backend: &B) -> Run {
        let corners = self.corners.clone();
        let mut times = [Instant::now(); 5];
        let check = |corners| Arc::new(MaterialMesh::of_closed(self.scene.len(), corners).expect("closed"));
        let [first, second] = corners;
        let meshes: [Arc<MaterialMesh>; 2] = rayon::join(|| check(first), || check(second)).into();
        times[1] = Instant::now();
        let mut session = backend.prepare(&self.scene, Off).expect("in space");
        times[2] = Instant::now();
        let overlay = mesh_overlay(&mut session, meshes, Zeros::Zero).unwrap_or_else(|why| panic!("{why}"));
        times[3] = Instant::now();
        let union = black_box(overlay.solid(Operation::Union));
        times[4] = Instant::now();
        let seconds = |from: usize, to: usize| times[to].duration_since(times[from]).as_secs_f64();
        let volume_of = |triangles: &[[Vertex; 3]]| -> f64 {
            triangles.iter().map(|triangle| sixth(triangle.map(|v| place(session.scene(), v)))).sum()
        };
        let volume = volume_of(&union.triangles);
        // The volume of union and intersection together is that of both meshes together.
        let both = volume_of(&overlay.solid(Operation::Intersection).triangles);
        let sum: f64 = self.closed.iter().map(Closed::volume).sum();
        assert!((volume + both - sum).abs() <= ALIKE * sum, "{volume} and {both} are not {sum}");
        let phases = [0, 1, 2, 3].map(|phase| seconds(phase, phase + 1));
        Run { total: seconds(0, 4), phases, triangles: union.triangles.len(), volume }
    }

    /// Writes both meshes to files, for other programs.
    fn files(&self) -> [PathBuf; 2] {
        [0, 1].map(|mesh: usize| {
            let name = format!("predicament-mesh-overlay-{}-{mesh}.bin", std::process::id());
            let path = std::env::temp_dir().join(name);
            std::fs::write(&path, self.closed[mesh].bytes()).expect("a temporary file");
            path
        })
    }
}

/// Runs a program on two files and reads its output.
fn program(command: &str, files: &[PathBuf; 2]) -> Run {
    let mut words = command.split_whitespace();
    let output = Command::new(words.next().expect("a program")).args(words).args(files).output();
    let output = output.unwrap_or_else(|why| panic!("{command}: {why}"));
    let said = String::from_utf8_lossy(&output.stdout);
    let words: Vec<&str> = said.split_whitespace().collect();
    let [seconds, triangles, volume] = words[..] else {
        panic!("{command} printed `{said}`{}", String::from_utf8_lossy(&output.stderr))
    };
    let run = || Some((seconds.parse().ok()?, triangles.parse().ok()?, volume.parse().ok()?));
    let (total, triangles, volume) = run().unwrap_or_else(|| panic!("{command} printed `{said}`"));
    Run { total, phases: [0.0; 4], triangles, volume }
}

/// The median of measured times.
fn median(mut times: Vec<f64>) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Runs all contestants in turns on `threads` threads; prints medians, and ratios to the first.
fn compare(what: &str, threads: usize, rounds: usize, contestants: &[Contestant<'_>]) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let mut runs: Vec<Vec<Run>> = vec![Vec::new(); contestants.len()];
    for round in 0..rounds {
        for turn in 0..contestants.len() {
            let at = (round + turn) % contestants.len();
            runs[at].push(pool.install(|| contestants[at].1()));
        }
    }
    let volume = runs[0][0].volume;
    for ((name, _), run) in contestants.iter().zip(&runs).flat_map(|(of, runs)| runs.iter().map(move |run| (of, run))) {
        assert!((run.volume - volume).abs() <= ALIKE * volume, "{name}: the volume is {}, not {volume}", run.volume);
    }
    println!("{what}, threads: {threads}; {rounds} rounds in turns, medians in ms; volume {volume:.9}");
    println!("  {:<16} {:>10}  ratio{}  triangles", "", "total", PHASES.map(|phase| format!(" {phase:>10}")).concat());
    let of = |runs: &[Run], time: &dyn Fn(&Run) -> f64| median(runs.iter().map(time).collect());
    let first = of(&runs[0], &|run| run.total);
    for ((name, _), runs) in contestants.iter().zip(&runs) {
        let total = of(runs, &|run| run.total);
        let phases = [0, 1, 2, 3].map(|phase: usize| of(runs, &|run| run.phases[phase]));
        let phases = if phases == [0.0; 4] {
            PHASES.map(|_| format!(" {:>10}", "")).concat()
        } else {
            phases.map(|time| format!(" {:10.2}", 1e3 * time)).concat()
        };
        println!("  {name:<16} {:10.2}  {:5.2}{phases}  {}", 1e3 * total, total / first, runs[0].triangles);
    }
}

/// Compares some of our backends and all programs on a pair of meshes.
fn pair(name: &str, closed: [Closed; 2], backends: &[&str]) {
    let pair = Pair::new(closed);
    let count = pair.closed[0].triangles.len();
    let rounds = ROUNDS.into_iter().find(|(most, _)| count <= *most).map_or(1, |(_, rounds)| rounds);
    let programs = std::env::var("MESH_OVERLAY_PROGRAMS").unwrap_or_default();
    let files = (!programs.is_empty()).then(|| pair.files());
    let sos = Sos::default();
    let mut contestants: Vec<Contestant<'_>> = Vec::new();
    for &backend in backends {
        contestants.push((
            backend.to_owned(),
            match backend {
                "exact" => Box::new(|| pair.union(&Exact)),
                "sos" => Box::new(|| pair.union(&sos)),
                _ => Box::new(|| pair.union(&PerMesh)),
            },
        ));
    }
    for (name, command) in programs.split(';').filter_map(|named| named.split_once('=')) {
        let files = files.as_ref().expect("written for programs");
        contestants.push((name.to_owned(), Box::new(move || program(command, files))));
    }
    for threads in [1, std::thread::available_parallelism().map_or(1, std::num::NonZero::get)] {
        compare(&format!("{name}, {count} triangles each"), threads, rounds, &contestants);
    }
    for file in files.iter().flatten() {
        std::fs::remove_file(file).expect("the temporary file");
    }
}

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let wants = |name: &str| wanted.is_empty() || wanted.iter().any(|argument| argument == name);
    let all = ["6", "7", "8", "same", "cubes"];
    let unknown =
        wanted.iter().find(|argument| argument.parse::<usize>().is_err() && !all.contains(&argument.as_str()));
    assert_eq!(unknown, None, "arguments are numbers, `same` and `cubes`");
    let mut levels: Vec<usize> = wanted.iter().filter_map(|argument| argument.parse().ok()).collect();
    if wanted.is_empty() {
        levels = vec![6, 7, 8];
    }
    for level in levels {
        let sphere = Closed::sphere(level);
        let moved = sphere.moved([0.5, 0.3, 0.1]);
        pair("spheres", [sphere, moved], &["exact", "sos", "sos:per-mesh"]);
    }
    if wants("same") {
        for level in [6, 8] {
            let sphere = Closed::sphere(level);
            pair("a sphere with itself", [sphere.clone(), sphere], &["exact", "sos:per-mesh"]);
        }
    }
    if wants("cubes") {
        let cubes = Closed::stacks(9);
        let between = cubes.moved([0.0, 0.0, 1.0]);
        pair("stacks of cubes", [cubes, between], &["exact", "sos:per-mesh"]);
    }
}
