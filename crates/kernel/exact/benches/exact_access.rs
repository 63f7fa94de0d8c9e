//! The exact backend in realistic use: vertices by random ids, scenes of every size, with and without preparation time.
//!
//! * *random*: ids at random from a scene of 10⁶ vertices, so that points come from the third-level cache or from
//!   memory; *in cache*: the same family in a scene that fits in the first two levels.
//! * *prepared in*: a scene with as many vertices as its queries need, prepared and queried once, from 10 queries on.
//! * *projected*: orient2d of the projections of a scene in space.
//! * *sizes*: 2¹⁶ random queries of prepared scenes of 10 to 10⁷ vertices, also as a plot.
//!
//! Every query of a pass is new, so branch predictors cannot learn the queries. Engines alternate pass by pass; a line
//! has their medians relative to `robust`'s. All get ids, and read the same points:
//!
//! * `naive`: the determinant in doubles, the lower limit;
//! * `robust`: the crate;
//! * `fpg`: the filters that CGAL and Attene's predicates use, with their published constants (Meyer and Pion, FPG: a
//!   code generator for fast and certified geometric predicates, 2008; CGAL's static filters), and `robust` where they
//!   fail;
//! * `single`, `batch`: a session of the exact backend; `raw`: its predicates on coordinates.
//!
//! Families: *uniform* in the unit cube; *near*: of one line, plane, circle or sphere up to two ulps; *mixed*: a
//! separate exponent for each coordinate; *large near*: as *near* a million times larger, so that many scenes span more
//! bits than a limb; *ties*: integers of one line, plane, circle or sphere; *lattice*: integers from 0 to 15; *mesh*:
//! neighbours on a terrain over a jittered grid, whose vertices lie row after row.
//!
//! * *signs*: 10⁷ random queries of each predicate and family, answered by all engines and compared; not timed, and
//!   only on request.
//!
//! Words after `--` select measurements and predicates, as in `-- random orient2d`. Without words, everything is
//! measured.

#[path = "../tests/it/common.rs"]
#[allow(dead_code)] // the tests use the rest
mod common;
#[path = "access/family.rs"]
mod family;
#[path = "access/fpg.rs"]
mod fpg;
#[path = "access/plot.rs"]
mod plot;
mod turns;

use std::hint::black_box;
use std::time::Instant;

use common::Random;
use family::Family;
use plot::Line;
use predicament_controls::Naive;
use predicament_exact::{Exact, raw};
use predicament_predicates::{Backend, Dimension, Off, Plane, Predicates, Scene, Sign, Vertex};
use robust::{Coord, Coord3D};
use turns::{Engine, Turns, median};

const LARGE: usize = 1_000_000;
const SMALL: usize = 1 << 11;
const QUERIES: usize = 1 << 16;
const PASS: usize = 1 << 11;
const ENGINES: [&str; 6] = ["robust", "naive", "fpg", "single", "batch", "raw"];
/// The number of queries whose signs are compared.
const MANY: usize = 10_000_000;
/// Sizes, in queries, of scenes that are prepared for their queries.
const ONCE: [usize; 4] = [10, 100, 1_000, 10_000];
/// Sizes, in vertices, of scenes with random queries.
const SIZES: [usize; 7] = [10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000];

/// A function that answers a pass of queries from a first query on.
type Answer<'a> = &'a dyn Fn(usize, &mut [Sign]);
type Session<'s> = predicament_exact::Session<'s, Off>;
type Doubles<'s> = <Naive as Backend>::Session<'s, Off>;

/// A predicate in all forms that the benchmark can call.
struct Contest<N, S, B, W, R, F> {
    name: &'static str,
    round: bool,
    naive: N,
    single: S,
    batch: B,
    raw: W,
    robust: R,
    fpg: F,
}

impl<A, S, B, W, R, F> Contest<A, S, B, W, R, F> {
    fn run<const D: usize, const N: usize>(&self, words: &[String], lines: &mut Vec<Line>)
    where
        A: Fn(&Doubles, [Vertex; N]) -> Sign,
        S: Fn(&Session, [Vertex; N]) -> Sign,
        B: Fn(&Session, &[[Vertex; N]], &mut [Sign]),
        W: Fn([[f64; D]; N]) -> Sign,
        R: Fn([[f64; D]; N]) -> Sign,
        F: Fn([[f64; D]; N]) -> Sign,
    {
        let chosen = |word: &str| words.is_empty() || words.iter().any(|w| w == word);
        let predicates = ["orient2d", "orient3d", "incircle", "insphere"];
        if words.iter().any(|w| predicates.contains(&w.as_str())) && !words.iter().any(|w| w == self.name) {
            return;
        }
        if words.iter().any(|w| w == "projected") {
            return;
        }
        let chosen = |what: &str| {
            chosen(what)
                || words.iter().all(|w| predicates.contains(&w.as_str()) || Family::ALL.iter().any(|f| f.1 == w))
        };
        for (family, name) in Family::ALL {
            let families = words.iter().any(|w| Family::ALL.iter().any(|f| f.1 == w));
            if families && !words.iter().any(|w| w == name) {
                continue;
            }
            if chosen("random") {
                self.places::<D, N>("random", (family, name), LARGE);
            }
            if words.iter().any(|w| w == "signs") {
                self.signs::<D, N>(family, name);
            }
            if chosen("cache") {
                self.places::<D, N>("in cache", (family, name), SMALL);
            }
        }
        if chosen("once") {
            ONCE.iter().for_each(|&queries| self.once::<D, N>(queries));
        }
        if chosen("sizes") {
            for (family, name) in [(Family::Uniform, "uniform"), (Family::Near, "near")] {
                let medians = SIZES.map(|size| self.places::<D, N>("sizes", (family, name), size));
                for (at, engine) in ENGINES.iter().enumerate().filter(|(_, engine)| **engine != "naive") {
                    #[allow(clippy::cast_precision_loss)] // small numbers
                    let point = |(size, medians): (usize, [f64; 6])| (size as f64, medians[at] * 1e9 / PASS as f64);
                    let points = SIZES.into_iter().zip(medians).map(point).collect();
                    lines.push(Line { predicate: self.name, family: name, engine, points });
                }
            }
        }
        if chosen("prepare") {
            for (family, name) in
                [(Family::Uniform, "uniform"), (Family::Near, "near"), (Family::LargeNear, "large near")]
            {
                self.prepare::<D, N>(family, name);
            }
        }
    }

    /// The median time of each engine for a pass of random queries of a prepared scene, in seconds.
    fn places<const D: usize, const N: usize>(
        &self,
        what: &str,
        (family, name): (Family, &str),
        vertices: usize,
    ) -> [f64; 6]
    where
        A: Fn(&Doubles, [Vertex; N]) -> Sign,
        S: Fn(&Session, [Vertex; N]) -> Sign,
        B: Fn(&Session, &[[Vertex; N]], &mut [Sign]),
        W: Fn([[f64; D]; N]) -> Sign,
        R: Fn([[f64; D]; N]) -> Sign,
        F: Fn([[f64; D]; N]) -> Sign,
    {
        let mut random = Random(31);
        let points = family.points::<D>(&mut random, vertices, self.round);
        let queries: Vec<[Vertex; N]> =
            (0..QUERIES).map(|_| family.query(&mut random, vertices).map(Vertex::input)).collect();
        let scene = scene(&points);
        let session = Exact.prepare(&scene, Off).expect("prepared");
        let naive = black_box(Naive::default());
        let doubles = naive.prepare(&scene, Off).expect("prepared");
        // All engines read the points of the scene.
        let points: &[[f64; D]] = scene.coordinates().as_chunks().0;
        // (Number by number, so that they stay in registers.)
        #[allow(clippy::manual_memcpy)]
        let at = |query: [Vertex; N]| -> [[f64; D]; N] {
            let mut at = [[0.0; D]; N];
            for row in 0..N {
                let point = &points[query[row].index()];
                for axis in 0..D {
                    at[row][axis] = point[axis];
                }
            }
            at
        };
        macro_rules! engine {
            ($query:ident => $answer:expr) => {
                &|first: usize, out: &mut [Sign]| {
                    for (&$query, out) in black_box(&queries)[first..].iter().zip(out) {
                        *out = $answer;
                    }
                }
            };
        }
        let batch = |first: usize, out: &mut [Sign]| {
            let last = first + out.len();
            (self.batch)(&session, &black_box(&queries)[first..last], out);
        };
        let answers: [Answer; 6] = [
            engine!(query => (self.robust)(at(query))),
            engine!(query => (self.naive)(&doubles, query)),
            engine!(query => (self.fpg)(at(query))),
            engine!(query => (self.single)(&session, query)),
            &batch,
            engine!(query => (self.raw)(at(query))),
        ];
        let engines: [Engine; 6] = std::array::from_fn(|at| (ENGINES[at], answers[at]));
        let mut zeros = 0;
        let turns = Turns { queries: QUERIES, pass: PASS, rounds: 3, warm_up: 1 };
        let medians = turns.medians(&engines, |signs| {
            for of in [2, 3, 4, 5] {
                assert_eq!(signs[of], signs[0], "{}", engines[of].0);
            }
            zeros += signs[0].iter().filter(|sign| sign.is_zero()).count();
        });
        print!("{what:8} {:8} {name:10} {vertices:8} vertices:", self.name);
        line(&engines, &medians, zeros);
        medians
    }

    /// Compares the signs of 10⁷ random queries with those of `robust`.
    ///
    /// `robust` is exact if nothing underflows or overflows.
    fn signs<const D: usize, const N: usize>(&self, family: Family, name: &str)
    where
        S: Fn(&Session, [Vertex; N]) -> Sign,
        B: Fn(&Session, &[[Vertex; N]], &mut [Sign]),
        W: Fn([[f64; D]; N]) -> Sign,
        R: Fn([[f64; D]; N]) -> Sign,
    {
        let mut random = Random(47);
        let points = family.points::<D>(&mut random, LARGE, self.round);
        let scene = scene(&points);
        let session = Exact.prepare(&scene, Off).expect("prepared");
        let mut batch = vec![Sign::Zero; PASS];
        let (mut zeros, mut wrong) = (0, 0);
        for _ in 0..MANY / PASS {
            let queries: [[Vertex; N]; PASS] =
                std::array::from_fn(|_| family.query(&mut random, LARGE).map(Vertex::input));
            (self.batch)(&session, &queries, &mut batch);
            for (&query, &batch) in queries.iter().zip(&batch) {
                let query_points = query.map(|v| points[v.index()]);
                let truth = (self.robust)(query_points);
                let answers = [batch, (self.single)(&session, query), (self.raw)(query_points)];
                wrong += answers.iter().filter(|&&answer| answer != truth).count();
                zeros += usize::from(truth.is_zero());
            }
        }
        println!("signs    {:8} {name:10} {MANY:8} queries: {wrong} wrong, {zeros} zeros", self.name);
    }

    /// Scenes with the points of this many queries, each prepared and queried once; `robust` gets the coordinates.
    fn once<const D: usize, const N: usize>(&self, queries: usize)
    where
        S: Fn(&Session, [Vertex; N]) -> Sign,
        B: Fn(&Session, &[[Vertex; N]], &mut [Sign]),
        R: Fn([[f64; D]; N]) -> Sign,
    {
        let mut random = Random(37);
        let scenes: Vec<Scene> = (0..((1 << 17) / queries).max(4))
            .map(|_| scene(&Family::Uniform.points::<D>(&mut random, N * queries, self.round)))
            .collect();
        let asked: Vec<[Vertex; N]> =
            (0..queries).map(|query| std::array::from_fn(|i| Vertex::input(query * N + i))).collect();
        let mut signs = [(); 3].map(|()| vec![Sign::Zero; queries * scenes.len()]);
        let mut times = [const { Vec::new() }; 3];
        for _ in 0..5 {
            let start = Instant::now();
            for (scene, out) in black_box(&scenes).iter().zip(signs[0].chunks_mut(queries)) {
                let points: &[[f64; D]] = scene.coordinates().as_chunks().0;
                for (query, out) in black_box(&asked).iter().zip(out) {
                    *out = (self.robust)(std::array::from_fn(|i| points[query[i].index()]));
                }
            }
            times[0].push(start.elapsed());
            let start = Instant::now();
            for (scene, out) in black_box(&scenes).iter().zip(signs[1].chunks_mut(queries)) {
                let session = Exact.prepare(scene, Off).expect("prepared");
                for (&query, out) in black_box(&asked).iter().zip(out) {
                    *out = (self.single)(&session, query);
                }
            }
            times[1].push(start.elapsed());
            let start = Instant::now();
            for (scene, out) in black_box(&scenes).iter().zip(signs[2].chunks_mut(queries)) {
                let session = Exact.prepare(scene, Off).expect("prepared");
                (self.batch)(&session, black_box(&asked), out);
            }
            times[2].push(start.elapsed());
            assert!(signs[1] == signs[0] && signs[2] == signs[0]);
        }
        #[allow(clippy::cast_precision_loss)] // small numbers
        let each = scenes.len() as f64;
        let [robust, single, batch] = times.map(|times| median(times) / each);
        println!(
            "once     {:8} uniform    {queries:8} queries: robust {:.0} ns; prepare and single {:.2}, prepare and batch {:.2}",
            self.name,
            robust * 1e9,
            single / robust,
            batch / robust
        );
    }

    /// The times of preparing a scene and of the first query.
    fn prepare<const D: usize, const N: usize>(&self, family: Family, name: &str)
    where
        S: Fn(&Session, [Vertex; N]) -> Sign,
    {
        let mut random = Random(41);
        let scene = scene(&family.points::<D>(&mut random, LARGE, self.round));
        let query = std::array::from_fn(Vertex::input);
        let mut times = [const { Vec::new() }; 2];
        for _ in 0..9 {
            let start = Instant::now();
            let session = Exact.prepare(black_box(&scene), Off).expect("prepared");
            times[0].push(start.elapsed());
            black_box((self.single)(&session, black_box(query)));
            times[1].push(start.elapsed());
        }
        let [prepare, first] = times.map(|times| median(times) * 1e9);
        #[allow(clippy::cast_precision_loss)] // a million
        let each = LARGE as f64;
        println!(
            "prepare  {:8} {name:10} {LARGE:8} vertices: {:.2} ns a vertex; first answer after {:.2}",
            self.name,
            prepare / each,
            first / each
        );
    }
}

/// Turns of points in space, projected along an axis; if the points are coplanar, all are ties.
fn projected(words: &[String]) {
    let predicates = ["orient3d", "incircle", "insphere"];
    if words.iter().any(|w| predicates.contains(&w.as_str()) || Family::ALL.iter().any(|f| f.1 == w))
        || !(words.is_empty() || words.iter().any(|w| w == "projected"))
    {
        return;
    }
    for (name, vertices) in [("in cache", SMALL), ("random", LARGE)] {
        for (family, family_name) in [(Family::Uniform, "uniform"), (Family::Near, "near"), (Family::Ties, "ties")] {
            let mut random = Random(43);
            let flat = family.points::<2>(&mut random, vertices, false);
            let points: Vec<[f64; 3]> = flat.iter().map(|&[x, y]| [y, random.unit(), x]).collect();
            let queries: Vec<[Vertex; 3]> =
                (0..QUERIES).map(|_| std::array::from_fn(|_| Vertex::input(random.below(vertices)))).collect();
            let scene = scene(&points);
            let session = Exact.prepare(&scene, Off).expect("prepared");
            let points: &[[f64; 3]] = scene.coordinates().as_chunks().0;
            let at = |v: Vertex| {
                let [y, _, x] = points[v.index()];
                Coord { x, y }
            };
            let robust = |first: usize, out: &mut [Sign]| {
                for (&[a, b, c], out) in black_box(&queries)[first..].iter().zip(out) {
                    *out = Sign::of(robust::orient2d(at(a), at(b), at(c)));
                }
            };
            let single = |first: usize, out: &mut [Sign]| {
                for (&[a, b, c], out) in black_box(&queries)[first..].iter().zip(out) {
                    *out = session.orient2d(Plane::Zx, a, b, c);
                }
            };
            let batch = |first: usize, out: &mut [Sign]| {
                let last = first + out.len();
                session.orient2d_batch(Plane::Zx, &black_box(&queries)[first..last], out);
            };
            let engines: [Engine; 3] = [("robust", &robust), ("single", &single), ("batch", &batch)];
            let turns = Turns { queries: QUERIES, pass: PASS, rounds: 3, warm_up: 1 };
            let [robust, single, batch] = turns.medians(&engines, |signs| {
                assert!(signs[1] == signs[0] && signs[2] == signs[0]);
            });
            #[allow(clippy::cast_precision_loss)] // small numbers
            let nanoseconds = robust * 1e9 / PASS as f64;
            println!(
                "projected orient2d {family_name:8} {name}: robust {nanoseconds:.1} ns; single {:.2}, batch {:.2}",
                single / robust,
                batch / robust
            );
        }
    }
}

/// Prints the median of the first engine, and the other medians relative to it.
fn line(engines: &[Engine; 6], medians: &[f64; 6], zeros: usize) {
    #[allow(clippy::cast_precision_loss)] // small numbers
    let (nanoseconds, zeros) = (medians[0] * 1e9 / PASS as f64, zeros as f64 * 100.0 / (4 * QUERIES) as f64);
    print!(" {} {nanoseconds:.1} ns;", engines[0].0);
    for ((name, _), median) in engines.iter().zip(medians).skip(1) {
        print!(" {name} {:.2},", median / medians[0]);
    }
    println!(" zeros {zeros:.0} %");
}

fn scene<const D: usize>(points: &[[f64; D]]) -> Scene {
    let dimension = if D == 2 { Dimension::Two } else { Dimension::Three };
    Scene::new(dimension, points.as_flattened().to_vec()).expect("finite")
}

fn coord([x, y]: [f64; 2]) -> Coord<f64> {
    Coord { x, y }
}

fn coord3([x, y, z]: [f64; 3]) -> Coord3D<f64> {
    Coord3D { x, y, z }
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    let mut lines = Vec::new();
    projected(&words);
    let robust2 = |[a, b, c]: [_; 3]| Sign::of(robust::orient2d(coord(a), coord(b), coord(c)));
    let robust3 = |[a, b, c, d]: [_; 4]| Sign::of(robust::orient3d(coord3(a), coord3(b), coord3(c), coord3(d)));
    let circle = |[a, b, c, d]: [_; 4]| Sign::of(robust::incircle(coord(a), coord(b), coord(c), coord(d)));
    let sphere =
        |[a, b, c, d, e]: [_; 5]| Sign::of(robust::insphere(coord3(a), coord3(b), coord3(c), coord3(d), coord3(e)));
    Contest {
        name: "orient2d",
        round: false,
        naive: |session: &Doubles, [a, b, c]: [_; 3]| session.orient2d(Plane::Xy, a, b, c),
        single: |session: &Session, [a, b, c]: [_; 3]| session.orient2d(Plane::Xy, a, b, c),
        batch: |session: &Session, queries: &[_], out: &mut [_]| session.orient2d_batch(Plane::Xy, queries, out),
        raw: raw::orient2d,
        robust: robust2,
        fpg: |points| fpg::orient2d(points).unwrap_or_else(|| robust2(points)),
    }
    .run::<2, 3>(&words, &mut lines);
    Contest {
        name: "orient3d",
        round: false,
        naive: |session: &Doubles, [a, b, c, d]: [_; 4]| session.orient3d(a, b, c, d),
        single: |session: &Session, [a, b, c, d]: [_; 4]| session.orient3d(a, b, c, d),
        batch: |session: &Session, queries: &[_], out: &mut [_]| session.orient3d_batch(queries, out),
        raw: raw::orient3d,
        robust: robust3,
        fpg: |points| fpg::orient3d(points).unwrap_or_else(|| robust3(points)),
    }
    .run::<3, 4>(&words, &mut lines);
    Contest {
        name: "incircle",
        round: true,
        naive: |session: &Doubles, [a, b, c, d]: [_; 4]| session.incircle(a, b, c, d),
        single: |session: &Session, [a, b, c, d]: [_; 4]| session.incircle(a, b, c, d),
        batch: |session: &Session, queries: &[_], out: &mut [_]| session.incircle_batch(queries, out),
        raw: raw::incircle,
        robust: circle,
        fpg: |points| fpg::incircle(points).unwrap_or_else(|| circle(points)),
    }
    .run::<2, 4>(&words, &mut lines);
    Contest {
        name: "insphere",
        round: true,
        naive: |session: &Doubles, [a, b, c, d, e]: [_; 5]| session.insphere(a, b, c, d, e),
        single: |session: &Session, [a, b, c, d, e]: [_; 5]| session.insphere(a, b, c, d, e),
        batch: |session: &Session, queries: &[_], out: &mut [_]| session.insphere_batch(queries, out),
        raw: raw::insphere,
        robust: sphere,
        fpg: |points| fpg::insphere(points).unwrap_or_else(|| sphere(points)),
    }
    .run::<3, 5>(&words, &mut lines);
    plot::draw(&lines);
}
