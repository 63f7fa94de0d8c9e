//! Straight-line programs: a formula as a list of additions, subtractions and multiplications in a fixed order.
//!
//! The order of operations decides the error of an estimate, so everything that is derived (filters, bits, generated
//! code) reads the same program.

use std::collections::BTreeMap;

use predicament_arithmetic::Parts;

/// An operation; operands are places of earlier operations.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Op {
    /// A coordinate of a point.
    Coordinate {
        /// The place of the point among the arguments.
        point: usize,
        /// 0 for x, 1 for y and so on.
        axis: usize,
    },
    /// A whole number, as a double.
    Constant(f64),
    /// A sum.
    Add(usize, usize),
    /// A difference.
    Sub(usize, usize),
    /// A product.
    Mul(usize, usize),
    /// The negative.
    Neg(usize),
}

impl Op {
    /// The places of the operands.
    #[must_use]
    pub fn operands(self) -> [Option<usize>; 2] {
        match self {
            Op::Coordinate { .. } | Op::Constant(_) => [None, None],
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) => [Some(a), Some(b)],
            Op::Neg(a) => [Some(a), None],
        }
    }
}

/// A straight-line program; its value is the last operation.
#[derive(Clone, PartialEq, Debug)]
pub struct Program {
    ops: Vec<Op>,
}

impl Program {
    /// The operations, in order.
    #[must_use]
    pub fn ops(&self) -> &[Op] {
        &self.ops
    }

    /// The value for coordinates given by a function of point and axis, in any ring of numbers.
    ///
    /// `None` if the arithmetic returns `None`, for example because a number does not fit.
    pub fn evaluate<N: Clone>(
        &self,
        coordinate: impl Fn(usize, usize) -> N,
        constant: impl Fn(f64) -> N,
        arithmetic: impl Fn(Op, [&N; 2]) -> Option<N>,
    ) -> Option<N> {
        let mut values: Vec<N> = Vec::with_capacity(self.ops.len());
        for &op in &self.ops {
            let value = match op {
                Op::Coordinate { point, axis } => coordinate(point, axis),
                Op::Constant(number) => constant(number),
                Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) => arithmetic(op, [&values[a], &values[b]])?,
                Op::Neg(a) => arithmetic(op, [&values[a], &values[a]])?,
            };
            values.push(value);
        }
        values.pop()
    }

    /// The value in doubles, rounded after each operation in the program's order.
    #[must_use]
    pub fn estimate(&self, coordinate: impl Fn(usize, usize) -> f64) -> f64 {
        let arithmetic = |op, [a, b]: [&f64; 2]| {
            Some(match op {
                Op::Add(..) => a + b,
                Op::Sub(..) => a - b,
                Op::Mul(..) => a * b,
                _ => -a,
            })
        };
        self.evaluate(coordinate, |number| number, arithmetic).unwrap_or(f64::NAN)
    }
}

/// The key of an operation for finding it again: doubles by their bits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Key {
    Coordinate(usize, usize),
    Constant(u64),
    Add(usize, usize),
    Sub(usize, usize),
    Mul(usize, usize),
    Neg(usize),
}

/// Builds a program: each operation once, without operations on constants and with zeros and ones left out.
///
/// Every simplification keeps the value exactly, in real numbers and in doubles.
#[derive(Default)]
pub struct Builder {
    ops: Vec<Op>,
    known: BTreeMap<Key, usize>,
}

impl Builder {
    fn push(&mut self, op: Op) -> usize {
        let key = match op {
            Op::Coordinate { point, axis } => Key::Coordinate(point, axis),
            Op::Constant(number) => Key::Constant(number.to_bits()),
            Op::Add(a, b) => Key::Add(a, b),
            Op::Sub(a, b) => Key::Sub(a, b),
            Op::Mul(a, b) => Key::Mul(a, b),
            Op::Neg(a) => Key::Neg(a),
        };
        let ops = &mut self.ops;
        *self.known.entry(key).or_insert_with(|| {
            ops.push(op);
            ops.len() - 1
        })
    }

    fn constant_at(&self, at: usize) -> Option<f64> {
        if let Op::Constant(number) = self.ops[at] { Some(number) } else { None }
    }

    /// A coordinate of a point.
    pub fn coordinate(&mut self, point: usize, axis: usize) -> usize {
        self.push(Op::Coordinate { point, axis })
    }

    /// A whole number; −0 becomes 0.
    pub fn constant(&mut self, number: f64) -> usize {
        self.push(Op::Constant(number + 0.0))
    }

    /// A whole number of any size, as a sum of doubles.
    pub fn whole(&mut self, number: i128) -> usize {
        const HALF: i128 = 1 << 48;
        if number.abs() < HALF {
            #[allow(clippy::cast_precision_loss)] // below 2^48
            return self.constant(number as f64);
        }
        let [high, low] = [number.div_euclid(HALF), number.rem_euclid(HALF)].map(|part| self.whole(part));
        let half = self.whole(HALF - 1);
        let one = self.constant(1.0);
        let unit = self.push(Op::Add(half.min(one), half.max(one)));
        let shifted = self.push(Op::Mul(high.min(unit), high.max(unit)));
        self.push(Op::Add(shifted.min(low), shifted.max(low)))
    }

    /// The result of an operation on two constants, if it is exact.
    fn folded(&mut self, a: usize, b: usize, fold: impl Fn(f64, f64) -> f64) -> Option<usize> {
        let number = fold(self.constant_at(a)?, self.constant_at(b)?);
        // Whole numbers below 2^53 in magnitude are not rounded.
        (number.abs() < 9_007_199_254_740_992.0).then(|| self.constant(number))
    }

    fn is(&self, at: usize, number: f64) -> bool {
        self.constant_at(at).is_some_and(|constant| constant.total_cmp(&number).is_eq())
    }

    /// A sum.
    pub fn add(&mut self, a: usize, b: usize) -> usize {
        if let Some(folded) = self.folded(a, b, |x, y| x + y) {
            return folded;
        }
        if self.is(a, 0.0) {
            return b;
        }
        if self.is(b, 0.0) {
            return a;
        }
        match (self.ops[a], self.ops[b]) {
            (_, Op::Neg(of)) => self.sub(a, of),
            (Op::Neg(of), _) => self.sub(b, of),
            _ => self.push(Op::Add(a.min(b), a.max(b))),
        }
    }

    /// A difference.
    pub fn sub(&mut self, a: usize, b: usize) -> usize {
        if let Some(folded) = self.folded(a, b, |x, y| x - y) {
            return folded;
        }
        if a == b {
            return self.constant(0.0);
        }
        if self.is(a, 0.0) {
            return self.neg(b);
        }
        if self.is(b, 0.0) {
            return a;
        }
        match (self.ops[a], self.ops[b]) {
            (_, Op::Neg(of)) => self.add(a, of),
            (Op::Neg(of), _) => {
                let sum = self.add(of, b);
                self.neg(sum)
            }
            _ => self.push(Op::Sub(a, b)),
        }
    }

    /// A product.
    pub fn mul(&mut self, a: usize, b: usize) -> usize {
        if let Some(folded) = self.folded(a, b, |x, y| x * y) {
            return folded;
        }
        for (constant, other) in [(a, b), (b, a)] {
            if self.is(constant, 0.0) {
                return constant;
            }
            if self.is(constant, 1.0) {
                return other;
            }
            if self.is(constant, -1.0) {
                return self.neg(other);
            }
        }
        match (self.ops[a], self.ops[b]) {
            (Op::Neg(x), Op::Neg(y)) => self.mul(x, y),
            (Op::Neg(of), _) => {
                let product = self.mul(of, b);
                self.neg(product)
            }
            (_, Op::Neg(of)) => {
                let product = self.mul(a, of);
                self.neg(product)
            }
            _ => self.push(Op::Mul(a.min(b), a.max(b))),
        }
    }

    /// The negative.
    pub fn neg(&mut self, a: usize) -> usize {
        match self.ops[a] {
            Op::Constant(number) => self.constant(-number),
            Op::Neg(of) => of,
            Op::Sub(x, y) => self.push(Op::Sub(y, x)),
            _ => self.push(Op::Neg(a)),
        }
    }

    /// The program whose value is this place, without the operations that it does not need.
    #[must_use]
    pub fn finish(self, value: usize) -> Program {
        let mut needed = vec![false; self.ops.len()];
        needed[value] = true;
        for at in (0..=value).rev() {
            if needed[at] {
                self.ops[at].operands().into_iter().flatten().for_each(|operand| needed[operand] = true);
            }
        }
        let mut places = vec![0; self.ops.len()];
        let mut ops = Vec::new();
        for at in (0..=value).filter(|&at| needed[at]) {
            places[at] = ops.len();
            ops.push(match self.ops[at] {
                Op::Add(a, b) => Op::Add(places[a], places[b]),
                Op::Sub(a, b) => Op::Sub(places[a], places[b]),
                Op::Mul(a, b) => Op::Mul(places[a], places[b]),
                Op::Neg(a) => Op::Neg(places[a]),
                leaf => leaf,
            });
        }
        Program { ops }
    }
}

/// A whole number below 2^53 in magnitude, as an integer.
pub(crate) fn whole(number: f64) -> i128 {
    let Some(parts) = Parts::of(number).map(Parts::odd) else { return 0 };
    let magnitude = i128::from(parts.significand) << parts.exponent.max(0);
    if parts.negative { -magnitude } else { magnitude }
}
