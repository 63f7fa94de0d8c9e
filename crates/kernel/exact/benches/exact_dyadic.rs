//! Exact signs in dyadic numbers, in integers over a common power of two (`rational`, GMP), and by the crate `robust`,
//! on the same raw coordinates.
//!
//! * `uniform`: in a unit cube.
//! * `near`: collinear, coplanar, cocircular or cospherical up to rounding.
//! * `degenerate`: corners of a box with long coordinates; every answer is zero.
//! * `mixed`: exponents from −90 to 90, too far apart for fixed-width integers.
//! * `wide`: exponents from −1000 to 1000. `robust` overflows and underflows here, so some of its timed answers are
//!   wrong.
//! * `mixed-tie`, `wide-tie`: `degenerate` with such exponents.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use predicament_exact::dyadic;
use predicament_predicates::Sign;
use robust::{Coord, Coord3D};

#[path = "../tests/rational/mod.rs"]
mod rational;

const QUERIES: usize = 1024;
const FAMILIES: [&str; 7] = ["uniform", "near", "degenerate", "mixed", "mixed-tie", "wide", "wide-tie"];

/// SplitMix64 (Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    /// A number in [0, 1), a multiple of 2^-53.
    #[allow(clippy::cast_precision_loss)] // 53 bits fit
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A random exponent in −`largest` .. `largest`.
    fn exponents(&mut self, largest: f64) -> f64 {
        let exponent = (self.next() * 2.0 * largest).floor() - largest;
        let sign = if self.next() < 0.5 { -1.0 } else { 1.0 };
        sign * (1.0 + self.next()) * exponent.exp2()
    }
}

/// Queries of N points; `round` selects points for circles and spheres.
fn queries<const N: usize, const D: usize>(family: &str, round: bool) -> Vec<[[f64; D]; N]> {
    let mut random = Random(1);
    let mut coordinate = || match family {
        "mixed" | "mixed-tie" => random.exponents(90.0),
        "wide" | "wide-tie" => random.exponents(1000.0),
        _ => random.next(),
    };
    (0..QUERIES)
        .map(|_| {
            let free: [[f64; D]; N] = std::array::from_fn(|_| std::array::from_fn(|_| coordinate()));
            match family {
                "degenerate" | "mixed-tie" | "wide-tie" if round => {
                    std::array::from_fn(|i| std::array::from_fn(|axis| free[usize::from(i == axis + 1 || i > D)][axis]))
                }
                "degenerate" | "mixed-tie" | "wide-tie" => free.map(|mut p| {
                    p[D - 1] = p[0];
                    p
                }),
                "near" if round => free.map(|p| {
                    let centered = p.map(|x| x - 0.5);
                    let length = centered.iter().map(|x| x * x).sum::<f64>().sqrt();
                    centered.map(|x| x / length)
                }),
                "near" => free.map(|mut p| {
                    // The last coordinate from the others: on a line or a plane.
                    p[D - 1] = 0.1 + p[..D - 1].iter().sum::<f64>() / 3.0;
                    p
                }),
                _ => free,
            }
        })
        .collect()
}

/// A function that answers a query.
type Answer<const N: usize, const D: usize> = fn([[f64; D]; N]) -> Sign;

fn compete<const N: usize, const D: usize>(
    criterion: &mut Criterion,
    name: &str,
    round: bool,
    contestants: [(&str, Answer<N, D>); 3],
) {
    for family in FAMILIES {
        let queries = queries::<N, D>(family, round);
        let mut group = criterion.benchmark_group(format!("{name}/{family}"));
        group.throughput(Throughput::Elements(QUERIES as u64));
        for (who, answer) in contestants {
            let mut out = vec![Sign::Zero; QUERIES];
            group.bench_function(BenchmarkId::from_parameter(who), |bencher| {
                bencher.iter(|| {
                    for (out, &query) in out.iter_mut().zip(black_box(&queries)) {
                        *out = answer(query);
                    }
                    black_box(&mut out);
                });
            });
        }
        group.finish();
    }
}

fn flat([x, y]: [f64; 2]) -> Coord<f64> {
    Coord { x, y }
}

fn space([x, y, z]: [f64; 3]) -> Coord3D<f64> {
    Coord3D { x, y, z }
}

fn predicates(criterion: &mut Criterion) {
    compete(
        criterion,
        "orient2d",
        false,
        [
            ("dyadic", |[a, b, c]| dyadic::orient2d(a, b, c)),
            ("rational", |[a, b, c]| rational::orient2d(a, b, c).sign()),
            ("robust", |[a, b, c]| Sign::of(robust::orient2d(flat(a), flat(b), flat(c)))),
        ],
    );
    compete(
        criterion,
        "orient3d",
        false,
        [
            ("dyadic", |[a, b, c, d]| dyadic::orient3d(a, b, c, d)),
            ("rational", |[a, b, c, d]| rational::orient3d(a, b, c, d).sign()),
            ("robust", |[a, b, c, d]| Sign::of(robust::orient3d(space(a), space(b), space(c), space(d)))),
        ],
    );
    compete(
        criterion,
        "incircle",
        true,
        [
            ("dyadic", |[a, b, c, d]| dyadic::incircle(a, b, c, d)),
            ("rational", |[a, b, c, d]| rational::incircle(a, b, c, d).sign()),
            ("robust", |[a, b, c, d]| Sign::of(robust::incircle(flat(a), flat(b), flat(c), flat(d)))),
        ],
    );
    compete(
        criterion,
        "insphere",
        true,
        [
            ("dyadic", |[a, b, c, d, e]| dyadic::insphere(a, b, c, d, e)),
            ("rational", |[a, b, c, d, e]| rational::insphere(a, b, c, d, e).sign()),
            ("robust", |[a, b, c, d, e]| Sign::of(robust::insphere(space(a), space(b), space(c), space(d), space(e)))),
        ],
    );
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(std::time::Duration::from_millis(100))
        .measurement_time(std::time::Duration::from_millis(300))
        .without_plots();
    targets = predicates
}
criterion_main!(benches);
