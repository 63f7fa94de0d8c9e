//! Predicates on points beside published crates of the same interface: time and wrong answers, in turns.
//!
//! * `uniform`: points of a unit cube.
//! * `kettner`: the first point is a few ulps from (0.5, …), the others are (12, …), (24, …), (18, …): nearly
//!   degenerate (Kettner et al., Classroom examples of robustness problems, 2008).
//! * `ties`: corners of a box with long coordinates, and three points of a line through the origin; every answer is
//!   zero.
//! * `tiny`, `huge`: uniform points times 1e-200, and times 1e200. Products of differences underflow or overflow.
//! * `wide`: every coordinate has its own exponent, from −1000 to 1000.
//!
//! `try` is the form that returns an error for coordinates that are not finite, as `arithmetica` does. Truth is the
//! determinant in integers of GMP.

use std::hint::black_box;

use predicament_predicates::Sign;
use turns::{Engine, Turns};

#[path = "../tests/it/common.rs"]
#[allow(dead_code)] // the tests use the rest
mod common;
#[path = "../tests/rational/mod.rs"]
mod rational;
mod turns;

use common::Random;

const QUERIES: usize = 1 << 14;
const PASS: usize = 1 << 11;
const FAMILIES: [&str; 6] = ["uniform", "kettner", "ties", "tiny", "huge", "wide"];

/// A query of a family.
fn query<const D: usize, const N: usize>(family: &str, random: &mut Random) -> [[f64; D]; N] {
    let kettner = [0.5, 12.0, 24.0, 18.0, 6.0];
    let corner: [[f64; 2]; D] = std::array::from_fn(|_| [random.unit(), random.unit()]);
    std::array::from_fn(|point| {
        std::array::from_fn(|axis| match family {
            "uniform" => random.unit(),
            "tiny" => random.unit() * 1e-200,
            "huge" => random.unit() * 1e200,
            "ties" if N == 3 => corner[axis][0] * [1.0, 2.0, 4.0][point],
            "ties" => corner[axis][usize::from(point >> axis & 1 == 1)],
            "wide" => (random.unit() - 0.5) * 2f64.powf(random.unit() * 2000.0 - 1000.0),
            _ if point == 0 => 0.5 + (random.unit() * 256.0).floor() * f64::EPSILON / 2.0,
            _ => kettner[point],
        })
    })
}

/// The answers of an engine to queries.
type Answers<'a, const D: usize, const N: usize> = &'a dyn Fn(&[[[f64; D]; N]], &mut [Sign]);

fn race<const D: usize, const N: usize>(
    predicate: &str,
    truth: impl Fn([[f64; D]; N]) -> Sign,
    engines: [(&str, Answers<'_, D, N>); 5],
) {
    for family in FAMILIES {
        let mut random = Random(31);
        let points: Vec<[[f64; D]; N]> = (0..QUERIES).map(|_| query(family, &mut random)).collect();
        let truth: Vec<Sign> = points.iter().map(|&points| truth(points)).collect();
        let points = &points;
        let asks =
            engines.map(|(_, ask)| move |at: usize, out: &mut [Sign]| ask(&black_box(points)[at..at + out.len()], out));
        let turns: [Engine; 5] = std::array::from_fn(|at| (engines[at].0, &asks[at] as &dyn Fn(usize, &mut [Sign])));
        let medians = Turns { queries: QUERIES, pass: PASS, rounds: 9, warm_up: 1 }.medians(&turns, |_| ());
        print!("{predicate:9} {family:8}");
        for ((name, ask), median) in turns.iter().zip(medians) {
            let mut signs = vec![Sign::Zero; QUERIES];
            ask(0, &mut signs);
            let wrong = signs.iter().zip(&truth).filter(|(sign, truth)| sign != truth).count();
            #[allow(clippy::cast_precision_loss)] // small numbers
            let nanoseconds = median * 1e9 / PASS as f64;
            print!(" | {name} {nanoseconds:6.1} ns, {:.2}, {wrong:5} wrong", median / medians[0]);
        }
        println!();
    }
}

/// A loop over queries, so that each engine is inlined into a loop of its own.
macro_rules! each {
    ($points:pat => $answer:expr) => {
        &|queries, out| {
            for (&$points, out) in queries.iter().zip(out) {
                *out = $answer;
            }
        }
    };
}

fn theirs(sign: Result<arithmetica::Sign, arithmetica::NonFinite>) -> Sign {
    match sign {
        Ok(arithmetica::Sign::Negative) => Sign::Negative,
        Ok(arithmetica::Sign::Positive) => Sign::Positive,
        _ => Sign::Zero,
    }
}

fn coord([x, y]: [f64; 2]) -> robust::Coord<f64> {
    robust::Coord { x, y }
}

fn coord3([x, y, z]: [f64; 3]) -> robust::Coord3D<f64> {
    robust::Coord3D { x, y, z }
}

fn main() {
    println!("time of a query; relative to `robust`; wrong answers of {QUERIES} queries");
    race::<2, 3>(
        "orient2d",
        |[a, b, c]| rational::orient2d(a, b, c).sign(),
        [
            ("robust", each!([a, b, c] => Sign::of(robust::orient2d(coord(a), coord(b), coord(c))))),
            ("ours", each!([a, b, c] => predicament_exact::orient2d(a, b, c))),
            ("try", each!([a, b, c] => predicament_exact::try_orient2d(a, b, c).unwrap_or_default())),
            ("arithmetica", each!([a, b, c] => theirs(arithmetica::orient2d(a, b, c)))),
            ("geometry-predicates", each!([a, b, c] => Sign::of(geometry_predicates::orient2d(a, b, c)))),
        ],
    );
    race::<3, 4>(
        "orient3d",
        |[a, b, c, d]| rational::orient3d(a, b, c, d).sign(),
        [
            ("robust", each!([a, b, c, d] => Sign::of(robust::orient3d(coord3(a), coord3(b), coord3(c), coord3(d))))),
            ("ours", each!([a, b, c, d] => predicament_exact::orient3d(a, b, c, d))),
            ("try", each!([a, b, c, d] => predicament_exact::try_orient3d(a, b, c, d).unwrap_or_default())),
            ("arithmetica", each!([a, b, c, d] => theirs(arithmetica::orient3d(a, b, c, d)))),
            ("geometry-predicates", each!([a, b, c, d] => Sign::of(geometry_predicates::orient3d(a, b, c, d)))),
        ],
    );
    race::<2, 4>(
        "incircle",
        |[a, b, c, d]| rational::incircle(a, b, c, d).sign(),
        [
            ("robust", each!([a, b, c, d] => Sign::of(robust::incircle(coord(a), coord(b), coord(c), coord(d))))),
            ("ours", each!([a, b, c, d] => predicament_exact::incircle(a, b, c, d))),
            ("try", each!([a, b, c, d] => predicament_exact::try_incircle(a, b, c, d).unwrap_or_default())),
            ("arithmetica", each!([a, b, c, d] => theirs(arithmetica::incircle(a, b, c, d)))),
            ("geometry-predicates", each!([a, b, c, d] => Sign::of(geometry_predicates::incircle(a, b, c, d)))),
        ],
    );
    race::<3, 5>(
        "insphere",
        |[a, b, c, d, e]| rational::insphere(a, b, c, d, e).sign(),
        [
            (
                "robust",
                each!([a, b, c, d, e] =>
                    Sign::of(robust::insphere(coord3(a), coord3(b), coord3(c), coord3(d), coord3(e)))),
            ),
            ("ours", each!([a, b, c, d, e] => predicament_exact::insphere(a, b, c, d, e))),
            ("try", each!([a, b, c, d, e] => predicament_exact::try_insphere(a, b, c, d, e).unwrap_or_default())),
            ("arithmetica", each!([a, b, c, d, e] => theirs(arithmetica::insphere(a, b, c, d, e)))),
            ("geometry-predicates", each!([a, b, c, d, e] => Sign::of(geometry_predicates::insphere(a, b, c, d, e)))),
        ],
    );
}
