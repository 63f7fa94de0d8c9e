//! Exactly degenerate queries: integer points on a common line, plane, circle or sphere in general position, so that no
//! coordinate test detects it.

use predicament_predicates::PredicateKind;

use crate::Random;
use crate::bits::{integer, power_of_two};

/// The magnitudes of a query's integers.
struct Sizes {
    /// The magnitude of a line's or plane's first point, and of a circle's centre.
    origin: i64,
    /// The magnitude of a direction's components.
    step: i64,
    /// The number of steps to the points.
    steps: i64,
    /// The magnitude of the integers that parametrise points on a circle or sphere.
    parameter: i64,
}

/// A query whose answer is 0, also after scaling by 2^k: the coordinates are integers of at most 48 bits times a power
/// of two, hence doubles.
///
/// # Panics
/// For a predicate from a formula.
pub fn scaled(kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
    let sizes = Sizes { origin: 1 << 30, step: 1 << 15, steps: 1 << 15, parameter: 12 };
    let unit = power_of_two(rng.integer(-40, 40));
    out.extend(integers(kind, &sizes, rng).into_iter().map(|n| integer(n) * unit));
}

/// A query that is degenerate as decimals with a few fractional digits; the nearest doubles miss it by their roundings.
/// Dividing an integer by a power of ten (both doubles) rounds as reading the decimal does.
///
/// # Panics
/// For a predicate from a formula, or for more than 18 digits.
pub fn decimal(kind: PredicateKind, digits: u32, rng: &mut Random, out: &mut Vec<f64>) {
    let sizes = Sizes { origin: 100, step: 12, steps: 12, parameter: 3 };
    let power = integer(10_i64.pow(digits));
    out.extend(integers(kind, &sizes, rng).into_iter().map(|n| integer(n) / power));
}

fn integers(kind: PredicateKind, sizes: &Sizes, rng: &mut Random) -> Vec<i64> {
    match kind {
        PredicateKind::Compare => {
            let x = rng.integer(-sizes.origin, sizes.origin);
            let y = rng.integer(-sizes.origin, sizes.origin);
            vec![x, y, x, y + rng.nonzero(sizes.origin)]
        }
        PredicateKind::Orient2d => line(sizes, rng),
        PredicateKind::Orient3d => plane(sizes, rng),
        PredicateKind::Incircle => round::<2>(4, sizes, rng),
        PredicateKind::Insphere => round::<3>(5, sizes, rng),
        PredicateKind::Derived(derived) => panic!("{}: formulas have families of their own", derived.name()),
    }
}

/// Three different points on a line.
fn line(sizes: &Sizes, rng: &mut Random) -> Vec<i64> {
    let origin: [i64; 2] = std::array::from_fn(|_| rng.integer(-sizes.origin, sizes.origin));
    let direction: [i64; 2] = std::array::from_fn(|_| rng.nonzero(sizes.step));
    let first = rng.nonzero(sizes.steps);
    let second = loop {
        let second = rng.nonzero(sizes.steps);
        if second != first {
            break second;
        }
    };
    [0, first, second].iter().flat_map(|k| [0, 1].map(|i| origin[i] + k * direction[i])).collect()
}

/// Four different points in a plane.
fn plane(sizes: &Sizes, rng: &mut Random) -> Vec<i64> {
    let mut vector = |size| -> [i64; 3] { std::array::from_fn(|_| rng.nonzero(size)) };
    let (origin, u, v) = (vector(sizes.origin), vector(sizes.step), vector(sizes.step));
    let mut places = vec![[0, 0]];
    while places.len() < 4 {
        let place = [rng.integer(-sizes.steps, sizes.steps), rng.integer(-sizes.steps, sizes.steps)];
        if !places.contains(&place) {
            places.push(place);
        }
    }
    places.iter().flat_map(|[j, k]| [0, 1, 2].map(|i| origin[i] + j * u[i] + k * v[i])).collect()
}

/// Distinct points on one circle (N = 2) or sphere (N = 3).
///
/// A rational point of the unit circle or sphere is n/d with the numerators (2ps, …, s² − Σp²) over d = s² + Σp² for
/// integers p, s. Times the product of all the denominators it is an integer point of one large circle or sphere.
fn round<const N: usize>(count: usize, sizes: &Sizes, rng: &mut Random) -> Vec<i64> {
    let mut points: Vec<([i64; N], i64)> = Vec::with_capacity(count);
    while points.len() < count {
        let s = rng.integer(1, sizes.parameter);
        let p: [i64; N] =
            std::array::from_fn(|i| if i + 1 < N { rng.integer(-sizes.parameter, sizes.parameter) } else { 0 });
        let squares: i64 = p.iter().map(|p| p * p).sum();
        let mut numerators: [i64; N] = std::array::from_fn(|i| 2 * p[i] * s);
        numerators[N - 1] = s * s - squares;
        let denominator = s * s + squares;
        let same = |(n, d): &([i64; N], i64)| (0..N).all(|i| n[i] * denominator == numerators[i] * d);
        if !points.iter().any(same) {
            points.push((numerators, denominator));
        }
    }
    let product: i64 = points.iter().map(|(_, denominator)| denominator).product();
    let centre: [i64; N] = std::array::from_fn(|_| rng.integer(-sizes.origin, sizes.origin));
    points.iter().flat_map(|(n, d)| -> [i64; N] { std::array::from_fn(|i| centre[i] + product / d * n[i]) }).collect()
}
