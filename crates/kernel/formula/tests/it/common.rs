//! Formulas and inputs that several tests use.

// Small numbers, and random bits of which any part is as good.
#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, clippy::cast_sign_loss)]

use predicament_formula::{Definition, Formula};
use predicament_judge::formula_value;
use rug::Rational;

/// The four determinants, in the order of their degrees, with the conventions of `predicament-predicates`.
pub const HAND_MADE: [(&str, &str, usize); 4] = [
    ("orient2d", "det(a - c, b - c)", 2),
    ("orient3d", "det(a - d, b - d, c - d)", 3),
    ("incircle", "det([a - d, sq(a - d)], [b - d, sq(b - d)], [c - d, sq(c - d)])", 2),
    ("insphere", "det([a - e, sq(a - e)], [b - e, sq(b - e)], [c - e, sq(c - e)], [d - e, sq(d - e)])", 3),
];

pub fn formula(text: &str, dimension: usize) -> Formula {
    let definition = Definition { dimension: Some(dimension), ..Definition::anonymous(text) };
    Formula::new(definition).unwrap_or_else(|error| panic!("{}", error.shown(text)))
}

/// A small generator for reproducible samples (splitmix64).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ x >> 31
    }

    pub fn below(&mut self, bound: u64) -> u64 {
        self.next() % bound
    }

    /// A double in (−1, 1).
    pub fn unit(&mut self) -> f64 {
        let bits = (self.next() >> 12) | 1.0_f64.to_bits();
        (f64::from_bits(bits) - 1.5) * 2.0
    }
}

/// The kinds of inputs: each is near or on the zero set in another way, or at another scale.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Input {
    Uniform,
    Grid,
    Far,
    Mixed,
    /// The products of all factors are subnormal, and so rounded more than others.
    Faint,
    Tiny,
    Huge,
    Any,
}

impl Input {
    pub const ALL: [Input; 8] =
        [Input::Uniform, Input::Grid, Input::Far, Input::Mixed, Input::Faint, Input::Tiny, Input::Huge, Input::Any];

    fn coordinate(self, random: &mut Random) -> f64 {
        let small = |random: &mut Random, bound: u64| random.below(bound) as f64 - (bound / 2) as f64;
        match self {
            Input::Uniform => random.unit(),
            Input::Grid => small(random, 7),
            Input::Far => 1e9 + small(random, 5) * 0.125,
            Input::Mixed => random.unit() * 2f64.powi(random.below(80) as i32 - 40),
            Input::Faint => random.unit(),
            Input::Tiny => small(random, 9) * 2f64.powi(-1074 + random.below(60) as i32),
            Input::Huge => random.unit() * 2f64.powi(900 + random.below(123) as i32),
            Input::Any => loop {
                let x = f64::from_bits(random.next());
                if x.is_finite() {
                    break x;
                }
            },
        }
    }

    pub fn points(self, formula: &Formula, random: &mut Random) -> Vec<Vec<f64>> {
        let faint = 2f64.powi(-1071 / formula.polynomial().degree() as i32);
        let scale = if self == Input::Faint { faint } else { 1.0 };
        (0..formula.arity())
            .map(|_| (0..formula.coordinates()).map(|_| scale * self.coordinate(random)).collect())
            .collect()
    }
}

pub fn slices(points: &[Vec<f64>]) -> Vec<&[f64]> {
    points.iter().map(Vec::as_slice).collect()
}

/// Moves one coordinate so that the value nearly vanishes, if the polynomial has degree 1 in it.
///
/// The exact root is rounded to a double, and sometimes moved by some units in the last place.
pub fn solve(formula: &Formula, points: &mut [Vec<f64>], random: &mut Random) -> bool {
    let dimension = formula.coordinates();
    let start = random.below((points.len() * dimension) as u64) as usize;
    for at in 0..points.len() * dimension {
        let variable = (start + at) % (points.len() * dimension);
        if formula.polynomial().degree_in(variable) != 1 {
            continue;
        }
        let (point, axis) = (variable / dimension, variable % dimension);
        let mut value_at = |x: f64| {
            points[point][axis] = x;
            formula_value(formula, &slices(points)).expect("finite")
        };
        let [zero, one] = [0.0, 1.0].map(&mut value_at);
        let slope = Rational::from(&one - &zero);
        if slope.is_zero() {
            continue;
        }
        let root = (-zero / slope).to_f64();
        if !root.is_finite() {
            continue;
        }
        let step = random.below(5);
        points[point][axis] = match step {
            0 => root.next_up(),
            1 => root.next_down(),
            _ => root,
        };
        if points[point][axis].is_finite() {
            return true;
        }
        points[point][axis] = root;
        return true;
    }
    false
}
