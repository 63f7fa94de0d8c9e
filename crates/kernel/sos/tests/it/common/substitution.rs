//! Small numbers in place of infinitesimals, and determinants of the moved points.

use predicament_predicates::Scene;
use rug::{Integer, Rational};

/// Input vertices moved by small numbers in place of infinitesimals.
///
/// Coordinate number n moves by 2^(−32 · 2^n), n counted from 1. Each vertex stands in one place of the question, so
/// that no infinitesimal has a square.
pub fn moved(scene: &Scene) -> Vec<Vec<Rational>> {
    let dimension = scene.dimension().count();
    let by = |n: usize| Rational::from((Integer::from(1), Integer::from(1) << (32_u32 << (n + 1))));
    let exact = |x: f64| Rational::from_f64(x).unwrap();
    let coordinates: Vec<Rational> = scene.coordinates().iter().enumerate().map(|(n, &x)| exact(x) + by(n)).collect();
    coordinates.chunks(dimension).map(<[Rational]>::to_vec).collect()
}

/// The point p + t (q − p) for the t with f = 0, from f(p) and f(q).
pub fn between(p: &[Rational], q: &[Rational], [at_p, at_q]: [Rational; 2]) -> Vec<Rational> {
    let t = at_p.clone() / (at_p - at_q);
    p.iter().zip(q).map(|(p, q)| Rational::from(q - p) * &t + p).collect()
}

pub fn turn(a: &[Rational], b: &[Rational], c: &[Rational]) -> Rational {
    let [u, v] = [a, b].map(|p| [0, 1].map(|i| Rational::from(&p[i] - &c[i])));
    Rational::from(&u[0] * &v[1]) - Rational::from(&u[1] * &v[0])
}

pub fn side(a: &[Rational], b: &[Rational], c: &[Rational], d: &[Rational]) -> Rational {
    let [u, v, w] = [a, b, c].map(|p| [0, 1, 2].map(|i| Rational::from(&p[i] - &d[i])));
    let minor = |i: usize, j: usize| Rational::from(&v[i] * &w[j]) - Rational::from(&v[j] * &w[i]);
    minor(1, 2) * &u[0] + minor(2, 0) * &u[1] + minor(0, 1) * &u[2]
}
