//! The filter of a program: a bound on the error of its estimate, for any finite doubles.
//!
//! The proof is that of `predicament_arithmetic::bound`, step by step for any program. Let u = 2^-53. For each
//! operation x with the true value X, the derivation counts roundings: |x − X| ≤ ((1 + u)^k − 1)·M, where M is the
//! *magnitude*, the same expression with the magnitude of every term. Three kinds of values differ:
//!
//! * **Exact**: coordinates and constants. k = 0, M = |x|.
//! * **Accurate**: a sum or difference of two exact values, a product of accurate or exact ones, a sum of accurate
//!   values that are never negative. Their error is relative to their own value, so M = |x|.
//! * **Others**: a sum has M = M₁ + M₂ and k = max(k₁, k₂) + 1, a product M = M₁M₂ and k = k₁ + k₂ + 1. A product with
//!   a power of two and a negative cost no rounding.
//!
//! M is itself computed in doubles, to p, with m roundings counted likewise: p ≥ (1 − u)^m·M. The last operation's
//! rounding costs nothing, as rounding is monotone: n = max(k₁, k₂) for a last sum, k₁ + k₂ for a last product. So d
//! has the sign of D if |d| ≥ B·p with B = [`semi_static`]`(n, m)`, provided that nothing underflows or overflows.
//!
//! **Underflow.** A product that underflows is off by η ≤ 2^-1075 besides. Later factors multiply η. Let the *leaves*
//! be the exact values and sums of two of which factors of products consist, and x̂ the sum of their magnitudes. By
//! induction the absolute error of each value is at most c·max(1, x̂)^e·η: of a product c₁N₂ + c₂N₁ + 1 with e the
//! larger of e₁ + deg₂ and e₂ + deg₁, where N is the number of terms of M; of a sum c₁ + c₂, and the larger e. The
//! slack s = σ·(1 + x̂^e) with σ = 2^-960 exceeds the sum of these errors by 2^70, as c < 2^40 is required. So **d has
//! the sign of D if |d| > fl(fl(B·p) + s)**.
//!
//! If the program has sums of squares whose terms are the squares of all N leaves, let ŷ be their sum. A leaf is at
//! most max(1, ŷ^½), so max(1, x̂)^e ≤ N^e·max(1, ŷ^⌈e/2⌉), and s = σ·(1 + ŷ^⌈e/2⌉) does as well if c·N^e < 2^40.
//!
//! **Overflow.** M contains the magnitude of every product. If a product or a sum is infinite or NaN then p or x̂ is,
//! and so is the bound. No d is larger.

use predicament_arithmetic::{bound::semi_static, power_of_two};

use crate::program::{Op, Program};

/// The unit of the slack for underflow.
const SLACK: f64 = power_of_two(-960);

/// The largest factor of the underflow error that the slack covers: 2^40.
const LARGEST_FACTOR: f64 = 1_099_511_627_776.0;

/// The largest number of roundings for which [`semi_static`] is proved.
const MOST_ROUNDINGS: u32 = 100;

/// The kind of a value, by what its error is relative to.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Accuracy {
    /// Not rounded.
    Exact,
    /// The error is relative to the value.
    Accurate,
    /// The error is relative to the magnitude, which can be larger than the value.
    Magnitude,
}

/// The derived error of one operation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Error {
    /// The kind of the value.
    pub accuracy: Accuracy,
    /// The roundings of the value, k above.
    pub roundings: u32,
    /// The roundings of the magnitude, m above.
    pub magnitude_roundings: u32,
    /// True if the value is never negative, also after rounding.
    pub is_nonnegative: bool,
    /// The number of terms, with their coefficients: the magnitude if every leaf is 1.
    pub terms: f64,
    /// The degree in leaves.
    pub degree: u32,
    /// The factor c of the absolute error.
    factor: f64,
    /// The exponent e of the absolute error.
    exponent: u32,
    /// True if the operation is a leaf of products: an exact value, or a sum of two.
    is_leaf: bool,
}

/// The filter of a program; the module says how it is derived and proved.
#[derive(Clone, PartialEq, Debug)]
pub struct Filter {
    errors: Vec<Error>,
    /// Leaves of factors of products, or sums of their squares: the slack depends on the sum of their magnitudes.
    leaves: Vec<usize>,
    roundings: [u32; 2],
    constant: f64,
    slack: Slack,
}

/// The slack for underflow.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Slack {
    /// Nothing can underflow: the program has no products.
    None,
    /// σ·(1 + x̂^e), or σ·(1 + ŷ^⌈e/2⌉).
    Power(u32),
}

impl Filter {
    /// Derives the filter of a program.
    ///
    /// # Errors
    /// The reason, if the program has so many roundings or terms that the proof does not hold.
    pub fn of(program: &Program) -> Result<Filter, String> {
        let ops = program.ops();
        let mut errors: Vec<Error> = Vec::with_capacity(ops.len());
        for &op in ops {
            let error = derive(op, ops, &errors);
            errors.push(error);
        }
        let mut last = ops.len() - 1;
        while let Op::Neg(of) = ops[last] {
            last = of;
        }
        let root = errors[last];
        let operands: Vec<Error> = ops[last].operands().into_iter().flatten().map(|at| errors[at]).collect();
        let roundings = match (root.accuracy, ops[last], operands.as_slice()) {
            (Accuracy::Exact | Accuracy::Accurate, ..) => [0, 0],
            (_, Op::Mul(..), [a, b]) => [a.roundings + b.roundings, root.magnitude_roundings],
            (_, _, [a, b]) => [a.roundings.max(b.roundings), root.magnitude_roundings],
            _ => [root.roundings, root.magnitude_roundings],
        };
        let most = errors.iter().flat_map(|error| [error.roundings, error.magnitude_roundings]).max().unwrap_or(0);
        if most > MOST_ROUNDINGS {
            return Err(format!(
                "a term goes through {most} roundings; the filter is proved for up to {MOST_ROUNDINGS}"
            ));
        }
        if errors.iter().any(|error| error.factor >= LARGEST_FACTOR || error.terms >= LARGEST_FACTOR) {
            return Err("the formula has so many terms that underflow is not bounded".to_owned());
        }
        let [n, m] = roundings.map(|count| u8::try_from(count).unwrap_or(u8::MAX));
        let constant = if roundings[0] == 0 { 0.0 } else { semi_static(n, m) };
        let leaves = leaves(ops, &errors);
        let (leaves, exponent) = match squares(ops, &errors, &leaves) {
            Some(squares) if covers(root, leaves.len()) => (squares, root.exponent.div_ceil(2)),
            _ => (leaves, root.exponent),
        };
        let slack = if root.factor > 0.0 { Slack::Power(exponent) } else { Slack::None };
        Ok(Filter { errors, leaves, roundings, constant, slack })
    }

    /// The constant B of the semi-static filter.
    #[must_use]
    pub fn constant(&self) -> f64 {
        self.constant
    }

    /// The roundings n of a term before the last operation, and m of a term of the magnitude.
    #[must_use]
    pub fn roundings(&self) -> [u32; 2] {
        self.roundings
    }

    /// The slack for underflow.
    #[must_use]
    pub fn slack(&self) -> Slack {
        self.slack
    }

    /// The derived errors, one for each operation.
    #[must_use]
    pub fn errors(&self) -> &[Error] {
        &self.errors
    }

    /// The operations on whose magnitudes the slack depends.
    #[must_use]
    pub fn leaves(&self) -> &[usize] {
        &self.leaves
    }

    /// The estimate d, and the magnitude that it must exceed for its sign to be certain.
    ///
    /// NaN or infinite if the bound is not known.
    #[must_use]
    pub fn estimate(&self, program: &Program, coordinate: impl Fn(usize, usize) -> f64) -> [f64; 2] {
        let ops = program.ops();
        let mut values = vec![[0.0_f64; 2]; ops.len()];
        for (at, &op) in ops.iter().enumerate() {
            let value = match op {
                Op::Coordinate { point, axis } => coordinate(point, axis),
                Op::Constant(number) => number,
                Op::Add(a, b) => values[a][0] + values[b][0],
                Op::Sub(a, b) => values[a][0] - values[b][0],
                Op::Mul(a, b) => values[a][0] * values[b][0],
                Op::Neg(a) => -values[a][0],
            };
            let magnitude = if self.errors[at].accuracy == Accuracy::Magnitude {
                match op {
                    Op::Add(a, b) | Op::Sub(a, b) => values[a][1] + values[b][1],
                    Op::Mul(a, b) => values[a][1] * values[b][1],
                    _ => op.operands()[0].map_or(value.abs(), |a| values[a][1]),
                }
            } else {
                value.abs()
            };
            values[at] = [value, magnitude];
        }
        let [value, magnitude] = values.last().copied().unwrap_or_default();
        let slack = match self.slack {
            Slack::None => 0.0,
            Slack::Power(exponent) => {
                let sum: f64 = self.leaves.iter().map(|&at| values[at][1]).sum();
                SLACK * (1.0 + (0..exponent).fold(1.0, |power, _| power * sum))
            }
        };
        let proper = if self.constant > 0.0 { self.constant * magnitude + slack } else { slack };
        [value, proper]
    }

    /// The static bound: the magnitude that any estimate must exceed, if coordinates differ by at most `extent` and are
    /// at most `largest` in magnitude, axis by axis.
    #[must_use]
    pub fn static_bound(&self, program: &Program, extent: &[f64], largest: &[f64]) -> f64 {
        let ops = program.ops();
        let mut magnitudes = vec![0.0_f64; ops.len()];
        let up = |x: f64| if x == 0.0 { 0.0 } else { x.next_up() };
        for (at, &op) in ops.iter().enumerate() {
            magnitudes[at] = match op {
                Op::Coordinate { axis, .. } => largest[axis],
                Op::Constant(number) => number.abs(),
                Op::Sub(a, b) => match (ops[a], ops[b]) {
                    (Op::Coordinate { axis, .. }, Op::Coordinate { axis: same, .. }) if axis == same => extent[axis],
                    _ => up(magnitudes[a] + magnitudes[b]),
                },
                Op::Add(a, b) => up(magnitudes[a] + magnitudes[b]),
                Op::Mul(a, b) => up(magnitudes[a] * magnitudes[b]),
                Op::Neg(a) => magnitudes[a],
            };
        }
        let slack = match self.slack {
            Slack::None => 0.0,
            Slack::Power(exponent) => {
                let sum = self.leaves.iter().fold(0.0, |sum, &at| up(sum + magnitudes[at]));
                SLACK * (1.0 + (0..exponent).fold(1.0, |power, _| up(power * sum)))
            }
        };
        up(up(self.constant * magnitudes.last().copied().unwrap_or_default()) + slack)
    }
}

/// The error of one operation, from those of its operands.
fn derive(op: Op, ops: &[Op], errors: &[Error]) -> Error {
    let exact = |terms: f64, degree: u32, is_nonnegative: bool| Error {
        accuracy: Accuracy::Exact,
        roundings: 0,
        magnitude_roundings: 0,
        is_nonnegative,
        terms,
        degree,
        factor: 0.0,
        exponent: 0,
        is_leaf: true,
    };
    match op {
        Op::Coordinate { .. } => exact(1.0, 1, false),
        Op::Constant(number) => exact(number.abs(), 0, number >= 0.0),
        Op::Neg(a) => Error { is_nonnegative: false, ..errors[a] },
        Op::Add(a, b) | Op::Sub(a, b) => {
            let [x, y] = [errors[a], errors[b]];
            let both_exact = x.accuracy == Accuracy::Exact && y.accuracy == Accuracy::Exact;
            let sum = matches!(op, Op::Add(..)) && x.is_nonnegative && y.is_nonnegative;
            let same = sum && x.accuracy.max(y.accuracy) <= Accuracy::Accurate;
            Error {
                accuracy: if both_exact || same { Accuracy::Accurate } else { Accuracy::Magnitude },
                roundings: x.roundings.max(y.roundings) + 1,
                magnitude_roundings: x.magnitude_roundings.max(y.magnitude_roundings) + 1,
                is_nonnegative: sum,
                // A difference of coordinates is one leaf.
                terms: if both_exact { x.terms.max(y.terms).max(1.0) } else { x.terms + y.terms },
                degree: x.degree.max(y.degree),
                factor: x.factor + y.factor,
                exponent: x.exponent.max(y.exponent),
                is_leaf: both_exact,
            }
        }
        Op::Mul(a, b) => {
            let [x, y] = [errors[a], errors[b]];
            let is_power = |at: usize| matches!(ops[at], Op::Constant(number) if is_power_of_two(number));
            let rounding = u32::from(!is_power(a) && !is_power(b));
            Error {
                accuracy: x.accuracy.max(y.accuracy).max(Accuracy::Accurate),
                roundings: x.roundings + y.roundings + rounding,
                magnitude_roundings: x.magnitude_roundings + y.magnitude_roundings + rounding,
                is_nonnegative: a == b || x.is_nonnegative && y.is_nonnegative,
                terms: x.terms * y.terms,
                degree: x.degree + y.degree,
                factor: x.factor * y.terms + y.factor * x.terms + 1.0,
                exponent: match (x.factor > 0.0, y.factor > 0.0) {
                    (false, false) => 0,
                    (true, false) => x.exponent + y.degree,
                    (false, true) => y.exponent + x.degree,
                    (true, true) => (x.exponent + y.degree).max(y.exponent + x.degree),
                },
                is_leaf: false,
            }
        }
    }
}

/// The leaves of which factors of products consist.
fn leaves(ops: &[Op], errors: &[Error]) -> Vec<usize> {
    let mut is_factor = vec![false; ops.len()];
    for (at, &op) in ops.iter().enumerate().rev() {
        let is_inner = matches!(op, Op::Mul(..)) || is_factor[at] && !errors[at].is_leaf;
        if is_inner {
            op.operands().into_iter().flatten().for_each(|operand| is_factor[operand] = true);
        }
    }
    (0..ops.len()).filter(|&at| is_factor[at] && errors[at].is_leaf && !matches!(ops[at], Op::Constant(_))).collect()
}

/// Sums of squares that the program has anyway, if their squares are those of all leaves.
fn squares(ops: &[Op], errors: &[Error], leaves: &[usize]) -> Option<Vec<usize>> {
    let mut squared: Vec<Vec<usize>> = vec![Vec::new(); ops.len()];
    let mut is_part = vec![false; ops.len()];
    for (at, &op) in ops.iter().enumerate() {
        match op {
            Op::Mul(a, b) if a == b && errors[a].is_leaf => squared[at].push(a),
            Op::Add(a, b) if !squared[a].is_empty() && !squared[b].is_empty() => {
                squared[at] = [&squared[a][..], &squared[b]].concat();
                [is_part[a], is_part[b]] = [true; 2];
            }
            _ => {}
        }
    }
    let (mut chosen, mut missing) = (Vec::new(), leaves.to_vec());
    for at in (0..ops.len()).filter(|&at| !is_part[at]) {
        let before = missing.len();
        missing.retain(|leaf| !squared[at].contains(leaf));
        if missing.len() < before {
            chosen.push(at);
        }
    }
    (missing.is_empty() && chosen.len() < leaves.len()).then_some(chosen)
}

/// True if the factor of the absolute error is small enough for squares of `count` leaves.
fn covers(root: Error, count: usize) -> bool {
    let count = u32::try_from(count).map_or(f64::INFINITY, f64::from);
    (0..root.exponent).fold(root.factor, |factor, _| factor * count) < LARGEST_FACTOR
}

fn is_power_of_two(number: f64) -> bool {
    number.to_bits().trailing_zeros() >= 52 && number != 0.0
}
