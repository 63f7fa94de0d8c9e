//! Tests that open determinants fit in their limbs, and nearly need all of them.
//!
//! Determinants that a filter leaves open are computed modulo a power of two
//! (`determinant::Determinant::limbs_left_open`). Here points are moved, along one axis, to the place where the filter
//! just fails: determinants have their maximum there.

use crate::common::Random;
use crate::rational::Value;
use predicament_arithmetic::{bound, rational};
use predicament_exact::determinant::{self, Determinant};
use predicament_exact::{Exact, Session, estimate, stage};
use predicament_predicates::{Backend, Dimension, Off, Scene, Sign, Vertex};
use rug::Rational;

const QUERIES: usize = 200;

/// A predicate with the functions under test.
struct Subject<const D: usize, const N: usize> {
    determinant: Determinant,
    static_bound: fn([f64; D]) -> f64,
    estimate: fn(&[[f64; D]; N]) -> f64,
    value: fn(&[[f64; D]; N]) -> Value,
    decide: fn(&Session<'_, Off>, &[Vertex]) -> (Sign, usize),
}

fn power(exponent: i32) -> Rational {
    Rational::from(1) << exponent
}

/// Half of the range of this many limbs.
fn capacity(limbs: usize) -> Rational {
    power(64 * i32::try_from(limbs).unwrap() - 1)
}

impl<const D: usize, const N: usize> Subject<D, N> {
    /// The largest determinant of queries that the static filter leaves open, with coordinates of this many bits.
    ///
    /// It also asks these queries.
    fn largest(&self, bits: i32, random: &mut Random) -> Rational {
        let extent = 2f64.powi(bits).next_down();
        let bound = (self.static_bound)([extent; D]);
        let mut queries = Vec::new();
        while queries.len() < QUERIES {
            if let Some(query) = self.narrowed(extent, bound, random) {
                queries.push(query);
            }
        }
        let mut points: Vec<[f64; D]> = queries.iter().copied().flatten().collect();
        // The scene's lowest bit, and its extent.
        points.extend([[0.0; D], [1.0; D], [extent; D]]);
        let dimension = if D == 2 { Dimension::Two } else { Dimension::Three };
        let scene = Scene::new(dimension, points.as_flattened().to_vec()).unwrap();
        let session = Exact.prepare(&scene, Off).unwrap();
        let mut largest = Rational::new();
        for (i, query) in queries.iter().enumerate() {
            let value = (self.value)(query);
            let vertices: Vec<Vertex> = (0..N).map(|k| Vertex::input(N * i + k)).collect();
            assert_eq!((self.decide)(&session, &vertices), (value.sign(), stage::INTEGER), "{bits} bits: {query:?}");
            largest = largest.max(value.to_rational().abs());
        }
        largest
    }

    /// Points with an estimate between half the bound and the bound, if bisection finds any.
    fn narrowed(&self, extent: f64, bound: f64, random: &mut Random) -> Option<[[f64; D]; N]> {
        // Near the corners of the box, where determinants and errors are large.
        let mut points: [[f64; D]; N] = random.points(|random| {
            let inset = random.unit() * 0.1;
            ((if random.below(2) == 0 { inset } else { 1.0 - inset }) * extent).trunc()
        });
        let at = |points: &mut [[f64; D]; N], x: f64| {
            points[0][0] = x.trunc();
            (self.estimate)(points)
        };
        let (mut low, mut high) = (0.0, extent);
        let [first, last] = [at(&mut points, low), at(&mut points, high)];
        if (first > 0.0) == (last > 0.0) {
            return None;
        }
        for _ in 0..200 {
            let middle = low + (high - low) / 2.0;
            let value = at(&mut points, middle);
            if value.abs() < bound {
                return (value.abs() > bound / 2.0).then_some(points);
            }
            if (value > 0.0) == (first > 0.0) { low = middle } else { high = middle }
        }
        None
    }

    /// Checks the last number of bits for each number of limbs, and that one limb less is not enough there.
    fn check(&self) {
        let mut random = Random(61);
        let limbs = |bits| self.determinant.limbs_left_open(bits);
        let edges: Vec<i32> = (40..62).filter(|&bits| limbs(bits) != limbs(bits + 1)).collect();
        assert!(!edges.is_empty());
        for edge in edges {
            assert_eq!(limbs(edge) + 1, limbs(edge + 1));
            assert!(self.largest(edge, &mut random) < capacity(limbs(edge)), "{edge} bits");
            // The proved value is about twice the actual one, in a power of M.
            let beyond = (edge + 3).min(62);
            let largest = self.largest(beyond, &mut random);
            assert!(largest < capacity(limbs(beyond)), "{beyond} bits");
            if beyond == edge + 3 {
                assert!(largest > capacity(limbs(edge)), "{beyond} bits: {largest}");
            }
        }
    }
}

#[test]
fn orient3d() {
    Subject::<3, 4> {
        determinant: determinant::ORIENT3D,
        static_bound: bound::static_orient3d,
        estimate: |&[a, b, c, d]| estimate::orient3d(a, b, c, d).determinant,
        value: |&[a, b, c, d]| crate::rational::orient3d(a, b, c, d),
        decide: |session, v| session.decide_orient3d(v[0], v[1], v[2], v[3]),
    }
    .check();
}

#[test]
fn incircle() {
    Subject::<2, 4> {
        determinant: determinant::INCIRCLE,
        static_bound: bound::static_incircle,
        estimate: |&[a, b, c, d]| estimate::incircle(a, b, c, d).determinant,
        value: |&[a, b, c, d]| crate::rational::incircle(a, b, c, d),
        decide: |session, v| session.decide_incircle(v[0], v[1], v[2], v[3]),
    }
    .check();
}

#[test]
fn insphere() {
    Subject::<3, 5> {
        determinant: determinant::INSPHERE,
        static_bound: bound::static_insphere,
        estimate: |&[a, b, c, d, e]| estimate::insphere(a, b, c, d, e).determinant,
        value: |&[a, b, c, d, e]| crate::rational::insphere(a, b, c, d, e),
        decide: |session, v| session.decide_insphere(v[0], v[1], v[2], v[3], v[4]),
    }
    .check();
}

/// The limbs suffice for the proof's bound, and are the fewest that do.
#[test]
fn limbs_are_as_many_as_the_proof_needs() {
    let all = [
        (determinant::ORIENT2D, 2),
        (determinant::ORIENT3D, 6),
        (determinant::INCIRCLE, 12),
        (determinant::INSPHERE, 72),
    ];
    for (determinant, terms) in all {
        let open = rational(determinant.bound).unwrap() * Rational::from((201, 100));
        for bits in 1..=126 {
            let scale = power(determinant.form.degree * bits);
            let [all, left_open] = [determinant.limbs(bits), determinant.limbs_left_open(bits)];
            assert!(Rational::from(&scale * terms) <= capacity(all));
            assert!(Rational::from(&scale * terms) * &open < capacity(left_open));
            // (Growth and bound are rounded up to powers of two: a factor of four at most.)
            assert!(all == 1 || Rational::from(&scale * terms) * 4u32 > capacity(all - 1));
            assert!(left_open == 1 || Rational::from(&scale * terms) * &open * 4u32 > capacity(left_open - 1));
        }
    }
}
