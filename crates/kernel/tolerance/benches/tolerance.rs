//! The cost of the tolerance scheme and the savings of its band, compared with exact signs, where floating point
//! settles both.
//!
//! Every query has its own points, uniform in a unit cube or square. The engines alternate, pass by pass, on queries in
//! cache, one by one and in batches. The benchmark prints medians and their ratio: 1 is the time of the filters of
//! `exact`.

#[path = "../../exact/tests/it/common.rs"]
#[allow(dead_code)] // the tests use the rest
mod common;

use std::hint::black_box;
use std::time::Instant;

use common::Random;
use criterion::{Criterion, criterion_group, criterion_main};
use predicament_exact::Exact;
use predicament_predicates::{Axis, Backend, Dimension, Off, Plane, Predicates, Scene, Sign, Vertex};
use predicament_tolerance::Tolerance;

/// The number of queries of a pass; all fit in cache.
const PASS: usize = 1 << 12;
const PASSES: usize = 64;

/// Times both engines on a predicate.
fn contest<const D: usize, const N: usize>(name: &str, predicate: &impl Ask<N>) {
    let mut random = Random(43);
    let points: Vec<[[f64; D]; N]> = (0..PASS * PASSES).map(|_| random.points(Random::unit)).collect();
    let queries: Vec<[Vertex; N]> =
        (0..PASS * PASSES).map(|query| std::array::from_fn(|i| Vertex::input(query * N + i))).collect();
    let dimension = if D == 2 { Dimension::Two } else { Dimension::Three };
    let scene = Scene::new(dimension, points.as_flattened().as_flattened().to_vec()).expect("finite");
    let exact = Exact.prepare(&scene, Off).expect("prepared");
    let tolerance = Tolerance.prepare(&scene, Off).expect("prepared");
    for is_batch in [false, true] {
        let mut signs = [(); 2].map(|()| vec![Sign::Zero; PASS]);
        let mut times = [const { Vec::new() }; 2];
        for queries in queries.chunks_exact(PASS) {
            // The first round warms the caches, the second is timed.
            for times in [&mut [const { Vec::new() }; 2], &mut times] {
                let [by_exact, by_tolerance] = &mut signs;
                let queries = black_box(queries);
                times[0].push(timed(|| match is_batch {
                    true => predicate.many(&exact, queries, by_exact),
                    false => {
                        queries.iter().zip(by_exact).for_each(|(query, sign)| *sign = predicate.one(&exact, query))
                    }
                }));
                times[1].push(timed(|| match is_batch {
                    true => predicate.many(&tolerance, queries, by_tolerance),
                    false => {
                        queries
                            .iter()
                            .zip(by_tolerance)
                            .for_each(|(query, sign)| *sign = predicate.one(&tolerance, query));
                    }
                }));
            }
            assert_eq!(signs[0], signs[1]);
        }
        let [exact, tolerance] = times.map(median);
        #[allow(clippy::cast_precision_loss)] // a small number
        let each = |time: f64| time * 1e9 / PASS as f64;
        println!(
            "{}, {}: exact {:.2} ns, tolerance {:.2} ns, ratio {:.2}",
            name,
            if is_batch { "batch" } else { "single" },
            each(exact),
            each(tolerance),
            tolerance / exact
        );
    }
}

/// A predicate of `N` vertices.
trait Ask<const N: usize> {
    fn one<P: Predicates>(&self, session: &P, query: &[Vertex; N]) -> Sign;
    fn many<P: Predicates>(&self, session: &P, queries: &[[Vertex; N]], out: &mut [Sign]);
}

/// Declares a type for a predicate: its vertices, one query and many queries.
macro_rules! predicate {
    ($type:ident, $count:literal, |$session:ident, $query:pat_param| $one:expr, |$same:ident, $queries:ident, $out:ident| $many:expr) => {
        struct $type;

        impl Ask<$count> for $type {
            #[inline(always)]
            fn one<P: Predicates>(&self, $session: &P, &$query: &[Vertex; $count]) -> Sign {
                $one
            }

            #[inline(always)]
            fn many<P: Predicates>(&self, $same: &P, $queries: &[[Vertex; $count]], $out: &mut [Sign]) {
                $many
            }
        }
    };
}

predicate!(Compare, 2, |s, [a, b]| s.compare(Axis::Y, a, b), |s, q, out| s.compare_batch(Axis::Y, q, out));
predicate!(Turn, 3, |s, [a, b, c]| s.orient2d(Plane::Xy, a, b, c), |s, q, out| s.orient2d_batch(Plane::Xy, q, out));
predicate!(Shadow, 3, |s, [a, b, c]| s.orient2d(Plane::Zx, a, b, c), |s, q, out| s.orient2d_batch(Plane::Zx, q, out));
predicate!(Side, 4, |s, [a, b, c, d]| s.orient3d(a, b, c, d), |s, q, out| s.orient3d_batch(q, out));
predicate!(Circle, 4, |s, [a, b, c, d]| s.incircle(a, b, c, d), |s, q, out| s.incircle_batch(q, out));
predicate!(Sphere, 5, |s, [a, b, c, d, e]| s.insphere(a, b, c, d, e), |s, q, out| s.insphere_batch(q, out));

fn timed(work: impl FnOnce()) -> f64 {
    let begin = Instant::now();
    work();
    begin.elapsed().as_secs_f64()
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn tolerance(_: &mut Criterion) {
    contest::<2, 2>("compare", &Compare);
    contest::<2, 3>("orient2d", &Turn);
    contest::<3, 3>("orient2d of a projection", &Shadow);
    contest::<3, 4>("orient3d", &Side);
    contest::<2, 4>("incircle", &Circle);
    contest::<3, 5>("insphere", &Sphere);
}

criterion_group!(benches, tolerance);
criterion_main!(benches);
