//! Benchmark: unions of many pairs of meshes of published packages in random places, and those of other libraries.
//!
//! ```text
//! crates/systems/mesh-intersect/benches/mesh_race/race.sh FOLDER --pairs 1000 --seed 1
//! ```
//!
//! builds the other programs, fetches the meshes (`meshes.py` names the packages) and starts this bench. Before a pair
//! is formed, each mesh is scaled by a power of two, so that the diagonal of its box is in [1, 2). Then it is turned at
//! random around the middle of its box, and the second one is moved, by at most half of the sum of both boxes' edges in
//! each coordinate: the boxes overlap. Coordinates are rounded to doubles. So the operands are the meshes as people
//! made them, in general position or nearly so.
//!
//! All contestants unite a pair in turns, from arrays of doubles and indices to such arrays; reading and writing files
//! is not timed. One process of each program answers all pairs (see `race.hpp` for the protocol); it is started again
//! after it crashed or took longer than the cap. Everybody runs on the cores that this process may use: `taskset -c 0`
//! before the command makes it a race on one thread.
//!
//! A result is right if it is closed (each side of a triangle has an opposite one, corners compared by position) and
//! has the volume that most contestants find, within [`ALIKE`]. Each time, and the outcome of each failure, goes to
//! `race.csv`. Percentiles are of right results; ratios are of pairs that both solved.

#[path = "../closed.rs"]
mod closed;
mod contest;
mod table;

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

use self::closed::Closed;
use self::contest::{Contestant, Made, Outcome};

/// The maximum difference of equal volumes, in relation to the area of both meshes. The diagonals of their boxes are
/// between 1 and 2, so this is the thickness of a layer.
const ALIKE: f64 = 1e-9;

struct Options {
    meshes: PathBuf,
    out: PathBuf,
    pairs: usize,
    seed: u64,
    cap: Duration,
}

impl Options {
    fn read() -> Result<Options, String> {
        let mut options = Options {
            meshes: PathBuf::from("meshes"),
            out: std::env::temp_dir(),
            pairs: 50,
            seed: 1,
            cap: Duration::from_secs(20),
        };
        let mut arguments = std::env::args().skip(1).filter(|argument| argument != "--bench");
        while let Some(name) = arguments.next() {
            let value = arguments.next().ok_or(format!("{name} needs a value"))?;
            let number = || value.parse::<u64>().map_err(|_| format!("{name} is a whole number, not `{value}`"));
            match &name[..] {
                "--meshes" => options.meshes = PathBuf::from(&value),
                "--out" => options.out = PathBuf::from(&value),
                "--pairs" => options.pairs = usize::try_from(number()?).map_err(|why| why.to_string())?,
                "--seed" => options.seed = number()?,
                "--cap" => options.cap = Duration::from_secs(number()?),
                _ => return Err(format!("{name}? There are --meshes, --out, --pairs, --seed and --cap")),
            }
        }
        Ok(options)
    }
}

/// A generator of pseudo-random numbers: SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in [−1, 1).
    fn number(&mut self) -> f64 {
        let bits = self.next();
        let [high, low] = [32, 0].map(|shift| f64::from(u32::try_from(bits >> shift & 0x3f_ffff).expect("22 bits")));
        (high + low / 4_194_304.0) / 2_097_152.0 - 1.0
    }

    fn below(&mut self, count: usize) -> usize {
        usize::try_from(self.next() % count as u64).expect("below a count")
    }

    /// The rows of a random rotation, by a quaternion that is uniform in a ball.
    fn rotation(&mut self) -> [[f64; 3]; 3] {
        loop {
            let q = [(); 4].map(|()| self.number());
            let square: f64 = q.iter().map(|x| x * x).sum();
            if (0.01..=1.0).contains(&square) {
                let [w, x, y, z] = q.map(|x| x / square.sqrt());
                let row = |a: f64, b: f64, c: f64| [a, b, c];
                return [
                    row(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)),
                    row(2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)),
                    row(2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)),
                ];
            }
        }
    }
}

/// The lower and upper corner of a mesh's box.
fn bounds(mesh: &Closed) -> [[f64; 3]; 2] {
    let of = |start: f64, choose: fn(f64, f64) -> f64| {
        mesh.points.iter().fold([start; 3], |all, p| [0, 1, 2].map(|i: usize| choose(all[i], p[i])))
    };
    [of(f64::INFINITY, f64::min), of(f64::NEG_INFINITY, f64::max)]
}

/// A mesh scaled by a power of two, and turned around the middle of its box, which becomes the origin.
fn turned(mesh: &Closed, rows: [[f64; 3]; 3]) -> Closed {
    let [low, high] = bounds(mesh);
    let edges = closed::minus(high, low);
    let diagonal = edges.iter().map(|x| x * x).sum::<f64>().sqrt();
    let scale = (-diagonal.log2().floor()).exp2();
    let turn = |p: &[f64; 3]| {
        let from = [0, 1, 2].map(|i: usize| (p[i] - f64::midpoint(low[i], high[i])) * scale);
        rows.map(|row| row.iter().zip(from).map(|(a, x)| a * x).sum())
    };
    Closed { points: mesh.points.iter().map(turn).collect(), triangles: mesh.triangles.clone() }
}

/// A random pair: the indices of two meshes, and the meshes in their places.
fn pair(meshes: &[Closed], random: &mut Random) -> ([usize; 2], [Closed; 2]) {
    let first = random.below(meshes.len());
    let second = (first + 1 + random.below(meshes.len() - 1)) % meshes.len();
    let [one, other] = [first, second].map(|at| turned(&meshes[at], random.rotation()));
    let [edges, others] = [&one, &other].map(|mesh| {
        let [low, high] = bounds(mesh);
        closed::minus(high, low)
    });
    let by = [0, 1, 2].map(|i: usize| random.number() * (edges[i] + others[i]) / 4.0);
    ([first, second], [one, other.moved(by)])
}

fn area(mesh: &Closed) -> f64 {
    let of = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|at| mesh.points[at as usize]);
        let [u, v] = [closed::minus(b, a), closed::minus(c, a)];
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        cross.iter().map(|x| x * x).sum::<f64>().sqrt() / 2.0
    };
    mesh.triangles.iter().map(of).sum()
}

/// Marks results whose volume is not the one that most of them have.
fn vote(made: &mut [Made], allowed: f64) {
    let volumes: Vec<f64> = made.iter().filter(|made| made.outcome == Outcome::Right).map(|made| made.volume).collect();
    let friends = |volume: f64| volumes.iter().filter(|other| (*other - volume).abs() <= allowed).count();
    let Some(chosen) = volumes.iter().copied().reduce(|a, b| if friends(b) > friends(a) { b } else { a }) else {
        return;
    };
    for made in made {
        if made.outcome == Outcome::Right && (made.volume - chosen).abs() > allowed {
            made.outcome = Outcome::Volume;
        }
    }
}

fn about(path: &Path, why: impl std::fmt::Display) -> String {
    format!("{}: {why}", path.display())
}

fn run(options: &Options) -> Result<(), String> {
    let list = options.meshes.join("meshes.csv");
    let text = std::fs::read_to_string(&list).map_err(|why| about(&list, why))?;
    let names: Vec<&str> = text.lines().skip(1).filter_map(|line| line.split(',').next()).collect();
    let mut meshes = Vec::new();
    for name in &names {
        meshes.push(contest::mesh(&options.meshes.join(name))?);
    }
    if meshes.len() < 2 {
        return Err(format!("{}: a race needs two meshes", list.display()));
    }
    let path = options.out.join("race.csv");
    let mut rows = std::fs::File::create(&path).map_err(|why| about(&path, why))?;
    let head = "pair,first,second,triangles,contestant,seconds,result,volume,outcome,why\n";
    rows.write_all(head.as_bytes()).map_err(|why| about(&path, why))?;

    let mut contestants = contest::contestants(&options.out, options.cap)?;
    let mut all: Vec<Vec<Made>> = Vec::new();
    let mut random = Random(options.seed);
    for number in 0..options.pairs {
        let (indices, closed) = pair(&meshes, &mut random);
        let given: usize = closed.iter().map(|mesh| mesh.triangles.len()).sum();
        let allowed = ALIKE * closed.iter().map(area).sum::<f64>();
        let files = contest::write(&options.out, &closed)?;
        let mut made = vec![Made::default(); contestants.len()];
        for turn in 0..contestants.len() {
            let at = (number + turn) % contestants.len();
            made[at] = contestants[at].unite(&closed, &files);
        }
        vote(&mut made, allowed);
        for (contestant, made) in contestants.iter().zip(&made) {
            let [first, second] = indices.map(|at| names[at]);
            let Made { seconds, triangles, volume, outcome, why } = made;
            let name = contestant.name();
            let line = format!(
                "{number},{first},{second},{given},{name},{seconds},{triangles},{volume},{outcome:?},\"{}\"\n",
                why.replace('"', "'")
            );
            rows.write_all(line.as_bytes()).map_err(|why| about(&path, why))?;
        }
        all.push(made);
        eprint!("\r{} pairs", number + 1);
    }
    eprintln!();
    let names: Vec<&str> = contestants.iter().map(Contestant::name).collect();
    print!("{}", table::table(&names, &all));
    Ok(())
}

fn main() -> std::process::ExitCode {
    match Options::read().and_then(|options| run(&options)) {
        Ok(()) => std::process::ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            std::process::ExitCode::from(2)
        }
    }
}
