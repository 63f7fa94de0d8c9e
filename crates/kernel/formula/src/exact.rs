//! The sign of a program's value for any finite doubles: integers of 128 bits, or dyadic numbers.
//!
//! Programs have only sums and products, so doubles give dyadic numbers, which [`Number`] holds without rounding. If
//! the polynomial is homogeneous, one power of two can be factored out of all coordinates, and where the coordinates
//! are then short, integers of 128 bits suffice.

use std::cmp::Ordering;

use predicament_arithmetic::Parts;
use predicament_arithmetic::dyadic::{Number, Space, Take};

use crate::bits::Bits;
use crate::program::{Op, Program, whole};

/// The limbs of a space on the stack; longer ones are allocated.
const STACK: usize = 768;

/// The sign of the value in 128-bit integers; `None` if the coordinates are too long for them.
///
/// `bits` are the bits of the program if it is homogeneous.
#[must_use]
pub fn integers(program: &Program, bits: &Bits, coordinates: &[&[f64]]) -> Option<Ordering> {
    let (mut low, mut high) = (i32::MAX, i32::MIN);
    for &x in coordinates.iter().flat_map(|point| point.iter()) {
        let parts = Parts::of(x)?;
        if let (Some(lowest), Some(highest)) = (parts.lowest(), parts.highest()) {
            low = low.min(lowest);
            high = high.max(highest);
        }
    }
    if low > high {
        (low, high) = (0, 0);
    }
    // The scale changes no sign of a homogeneous polynomial; others must keep theirs.
    if !bits.is_homogeneous() {
        if low < 0 {
            return None;
        }
        low = 0;
    }
    if high - low > 62 || bits.of(high.saturating_sub(low).cast_unsigned()) > 127 {
        return None;
    }
    let coordinate = |point: usize, axis: usize| {
        let parts =
            Parts::of(coordinates[point][axis]).unwrap_or(Parts { negative: false, significand: 0, exponent: 0 });
        let shift = parts.exponent - low;
        let magnitude = if parts.significand == 0 {
            0
        } else if shift >= 0 {
            i128::from(parts.significand) << shift
        } else {
            i128::from(parts.significand >> -shift)
        };
        if parts.negative { -magnitude } else { magnitude }
    };
    // The bits say that nothing overflows; a mistake there gives no answer instead of a wrong one.
    let arithmetic = |op, [a, b]: [&i128; 2]| match op {
        Op::Add(..) => a.checked_add(*b),
        Op::Sub(..) => a.checked_sub(*b),
        Op::Mul(..) => a.checked_mul(*b),
        _ => a.checked_neg(),
    };
    program.evaluate(coordinate, whole, arithmetic).map(|value| value.cmp(&0))
}

/// The sign of the value in dyadic numbers.
#[must_use]
pub fn dyadic(program: &Program, coordinates: &[&[f64]]) -> Ordering {
    let ops = program.ops();
    // The lowest bit and the highest of each value, to know the space; `None` for zero.
    let mut ranges: Vec<Option<[i32; 2]>> = Vec::with_capacity(ops.len());
    let mut limbs = 0;
    for &op in ops {
        let double = |x: f64| {
            let parts = Parts::of(x)?;
            Some([parts.lowest()?, parts.highest()?])
        };
        let range = match op {
            Op::Coordinate { point, axis } => double(coordinates[point][axis]),
            Op::Constant(number) => double(number),
            Op::Neg(a) => ranges[a],
            Op::Add(a, b) | Op::Sub(a, b) => match (ranges[a], ranges[b]) {
                (Some([low, high]), Some([other, top])) => Some([low.min(other), high.max(top) + 1]),
                (one, other) => one.or(other),
            },
            Op::Mul(a, b) => match (ranges[a], ranges[b]) {
                (Some([low, high]), Some([other, top])) => Some([low + other, high + top]),
                _ => None,
            },
        };
        // The window of a sum begins and ends at whole limbs, and has a sign.
        limbs += range.map_or(2, |[low, high]| usize::try_from((high - low) / 64 + 5).unwrap_or(0));
        ranges.push(range);
    }
    let mut stack = [0; STACK];
    let mut heap;
    let zeros = if limbs <= STACK {
        &mut stack[..limbs]
    } else {
        heap = vec![0; limbs];
        &mut heap[..]
    };
    let mut space = Space::new(zeros);
    let mut values: Vec<Number<'_>> = Vec::with_capacity(ops.len());
    for &op in ops {
        let one = Number::ONE;
        let value = match op {
            Op::Coordinate { point, axis } => Number::scaled(&mut space, coordinates[point][axis], 0),
            Op::Constant(number) => Number::scaled(&mut space, number, 0),
            Op::Add(a, b) => Number::sum(&mut space, [(values[a], one, Take::Plus), (values[b], one, Take::Plus)]),
            Op::Sub(a, b) => Number::sum(&mut space, [(values[a], one, Take::Plus), (values[b], one, Take::Minus)]),
            Op::Mul(a, b) => Number::sum(&mut space, [(values[a], values[b], Take::Plus)]),
            Op::Neg(a) => Number { negative: !values[a].negative, ..values[a] },
        };
        values.push(value);
    }
    values.last().map_or(Ordering::Equal, |value| value.cmp0())
}
