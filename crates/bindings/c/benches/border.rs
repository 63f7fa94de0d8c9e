//! The price of a call from C: the loops of `border.c` in Rust, beside the program in C.
//!
//! `cargo xtask c-library bench` compiles `border.c` and starts this bench with its path. Rounds alternate; each figure
//! is the fastest of all rounds. Both programs have the same points, and their sums of signs are compared.

use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::Instant;

use predicament_exact::{Exact, raw};
use predicament_predicates::{Backend, Off, Plane, Predicates, Scene, Sign, Vertex};

const POINTS: usize = 1_000_000;
const ROUNDS: usize = 50;
/// The variable with the path of the program in C.
const PROGRAM: &str = "PREDICAMENT_BORDER";

/// A time for one query in nanoseconds, and the sum of all signs.
type Timed = (f64, i64);

struct Random(u64);

impl Random {
    /// SplitMix64.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        #[allow(clippy::cast_precision_loss)] // 53 bits
        let bits = ((x ^ x >> 31) >> 11) as f64;
        bits * f64::EPSILON / 2.0
    }
}

#[allow(clippy::cast_precision_loss)] // shown with three digits
fn nanoseconds(start: Instant, queries: usize) -> f64 {
    start.elapsed().as_nanos() as f64 / queries as f64
}

/// Asks about neighbours in the list of points, one query at a time.
#[inline(never)]
fn single<const D: usize, const N: usize>(points: &[[f64; D]], sign: impl Fn([[f64; D]; N]) -> Sign) -> Timed {
    let start = Instant::now();
    let mut sum = 0;
    for window in black_box(points).windows(N) {
        sum += i64::from(sign(std::array::from_fn(|at| window[at])).as_i8());
    }
    (nanoseconds(start, points.len() - N + 1), sum)
}

/// Asks about neighbours in the list of points, all at once.
fn together<const N: usize>(ask: impl FnOnce(&[[Vertex; N]], &mut [Sign])) -> Timed {
    let queries: Vec<[Vertex; N]> =
        (0..POINTS - N + 1).map(|at| std::array::from_fn(|corner| Vertex::input(at + corner))).collect();
    let mut signs = vec![Sign::Zero; queries.len()];
    let start = Instant::now();
    ask(&queries, &mut signs);
    let time = nanoseconds(start, queries.len());
    (time, signs.iter().map(|sign| i64::from(sign.as_i8())).sum())
}

fn in_rust(flat: &Scene, solid: &Scene) -> BTreeMap<String, Timed> {
    let (points2, points3) = (flat.coordinates().as_chunks::<2>().0, solid.coordinates().as_chunks::<3>().0);
    let plane = Exact.prepare(flat, Off).expect("a session");
    let space = Exact.prepare(solid, Off).expect("a session");
    let all = [
        ("single orient2d", single(points2, raw::orient2d)),
        ("single orient3d", single(points3, raw::orient3d)),
        ("single incircle", single(points2, raw::incircle)),
        ("single insphere", single(points3, raw::insphere)),
        ("scene orient2d", together(|queries, out| plane.orient2d_batch(Plane::Xy, queries, out))),
        ("scene orient3d", together(|queries, out| space.orient3d_batch(queries, out))),
        ("scene incircle", together(|queries, out| plane.incircle_batch(queries, out))),
        ("scene insphere", together(|queries, out| space.insphere_batch(queries, out))),
    ];
    all.into_iter().map(|(name, timed)| (name.to_owned(), timed)).collect()
}

fn in_c(program: &str) -> BTreeMap<String, Timed> {
    let output = std::process::Command::new(program).output().expect("the program in C starts");
    assert!(output.status.success(), "{}", output.status);
    let text = String::from_utf8(output.stdout).expect("text");
    let line = |line: &str| {
        let mut words = line.rsplitn(3, ' ');
        let sum = words.next()?.parse().ok()?;
        let time = words.next()?.parse().ok()?;
        Some((words.next()?.to_owned(), (time, sum)))
    };
    text.lines().map(|text| line(text).unwrap_or_else(|| panic!("`{text}`"))).collect()
}

/// Keeps the faster of two times of each loop.
fn keep(best: &mut BTreeMap<String, Timed>, round: BTreeMap<String, Timed>) {
    for (name, (time, sum)) in round {
        let kept = best.entry(name.clone()).or_insert((f64::INFINITY, sum));
        assert_eq!(kept.1, sum, "{name} has other signs");
        kept.0 = kept.0.min(time);
    }
}

fn main() {
    let Ok(program) = std::env::var(PROGRAM) else {
        println!("{PROGRAM} is not set: type `cargo xtask c-library bench`");
        return;
    };
    let mut random = Random(1);
    let mut points = |count: usize| (0..count).map(|_| random.unit()).collect::<Vec<f64>>();
    let flat = Scene::from_points2(points(2 * POINTS).as_chunks().0).expect("finite");
    let solid = Scene::from_points3(points(3 * POINTS).as_chunks().0).expect("finite");
    let (mut rust, mut c) = (BTreeMap::new(), BTreeMap::new());
    for _ in 0..ROUNDS {
        keep(&mut rust, in_rust(&flat, &solid));
        keep(&mut c, in_c(&program));
    }
    println!("{:<16} {:>8} {:>8} {:>9} {:>14}", "", "C, ns", "Rust, ns", "C / Rust", "C, calls a s");
    for (name, (time, sum)) in &c {
        // Arrays have no function in Rust: beside them stand single queries.
        let (other, signs) = rust[&name.replace("array", "single")];
        assert_eq!(*sum, signs, "{name}");
        println!("{name:<16} {time:>8.2} {other:>8.2} {:>9.2} {:>14.3e}", time / other, 1e9 / time);
    }
}
