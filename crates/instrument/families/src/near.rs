//! Nearly degenerate queries: a few ulps off a line, plane, circle or sphere.

use predicament_predicates::PredicateKind;

use crate::Random;
use crate::bits::step;

/// A query whose last point is at a degenerate position, up to rounding, moved by at most `ulps` ulps in every
/// coordinate.
///
/// # Panics
/// For a predicate from a formula.
pub fn near(kind: PredicateKind, ulps: i64, rng: &mut Random, out: &mut Vec<f64>) {
    let start = out.len();
    let dimension = super::native(kind);
    match kind {
        PredicateKind::Derived(derived) => panic!("{}: formulas have families of their own", derived.name()),
        PredicateKind::Compare => {
            let x = rng.unit();
            out.extend([x, rng.unit(), x, rng.unit()]);
        }
        PredicateKind::Orient2d => {
            let [a, b] = [unit2(rng), unit2(rng)];
            let t = rng.unit();
            out.extend([a, b].as_flattened());
            out.extend((0..2).map(|i| a[i] + t * (b[i] - a[i])));
        }
        PredicateKind::Orient3d => {
            let [a, b, c] = [unit3(rng), unit3(rng), unit3(rng)];
            let (s, t) = (rng.unit(), rng.unit());
            out.extend([a, b, c].as_flattened());
            out.extend((0..3).map(|i| a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i])));
        }
        PredicateKind::Incircle => {
            let (centre, radius) = (unit2(rng), rng.between(0.125, 0.5));
            for _ in 0..4 {
                let on = circle(rng);
                out.extend((0..2).map(|i| centre[i] + radius * on[i]));
            }
        }
        PredicateKind::Insphere => {
            let (centre, radius) = (unit3(rng), rng.between(0.125, 0.5));
            for _ in 0..5 {
                let on = sphere(rng);
                out.extend((0..3).map(|i| centre[i] + radius * on[i]));
            }
        }
    }
    let last = out.len() - dimension;
    assert!(last > start);
    for x in &mut out[last..] {
        *x = step(*x, rng.integer(-ulps, ulps));
    }
}

/// Two points and their midpoint, rounded; for `orient3d` with an arbitrary fourth point.
pub fn midpoint(kind: PredicateKind, rng: &mut Random, out: &mut Vec<f64>) {
    let dimension = super::native(kind);
    let a: Vec<_> = (0..dimension).map(|_| rng.unit()).collect();
    let b: Vec<_> = (0..dimension).map(|_| rng.unit()).collect();
    out.extend(&a);
    out.extend(a.iter().zip(&b).map(|(a, b)| f64::midpoint(*a, *b)));
    out.extend(&b);
    if kind == PredicateKind::Orient3d {
        out.extend((0..dimension).map(|_| rng.unit()));
    }
}

pub(crate) fn unit2(rng: &mut Random) -> [f64; 2] {
    [rng.unit(), rng.unit()]
}

pub(crate) fn unit3(rng: &mut Random) -> [f64; 3] {
    [rng.unit(), rng.unit(), rng.unit()]
}

/// A point of the unit circle, up to rounding, by the rational parametrisation: the last bits of a sine differ between
/// platforms.
fn circle(rng: &mut Random) -> [f64; 2] {
    let t = rng.between(-1.0, 1.0);
    let m = 1.0 + t * t;
    let x = (1.0 - t * t) / m;
    [if rng.one_in(2) { x } else { -x }, 2.0 * t / m]
}

/// A point of the unit sphere, up to rounding, by stereographic projection.
fn sphere(rng: &mut Random) -> [f64; 3] {
    let (s, t) = (rng.between(-1.0, 1.0), rng.between(-1.0, 1.0));
    let q = s * s + t * t;
    let m = 1.0 + q;
    let z = (1.0 - q) / m;
    [2.0 * s / m, 2.0 * t / m, if rng.one_in(2) { z } else { -z }]
}
