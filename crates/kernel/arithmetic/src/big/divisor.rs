//! Greatest common divisors, remainders, and quotients without a remainder.

use alloc::{vec, vec::Vec};
use core::cmp::Ordering;
use core::mem::swap;

use super::limbs::{add, compare, halves, subtract, trim, trimmed};

/// The number of leading bits that a round of Lehmer's algorithm reads: cofactors and their sums fit an `i64`.
const LEADING: u32 = 62;

/// The greatest common divisor of two magnitudes, by Lehmer's algorithm.
///
/// The first quotients of Euclid's algorithm depend on the leading bits alone. A round finds these quotients, and takes
/// all their steps at once, as one linear map of both numbers.
pub(super) fn gcd(mut a: Vec<u64>, mut b: Vec<u64>) -> Vec<u64> {
    if compare(&a, &b) == Ordering::Less {
        swap(&mut a, &mut b);
    }
    // From here on the first number is the larger one.
    while b.len() > 1 {
        match steps(leading(&a, &b)) {
            // Not one quotient is certain: one step of Euclid's.
            [_, 0, _, _] => {
                remainder(&mut a, &b);
                swap(&mut a, &mut b);
            }
            map => combine(&mut a, &mut b, map),
        }
    }
    let Some(&short) = b.first() else { return a };
    remainder(&mut a, &b);
    let (mut a, mut b) = (short, a.first().copied().unwrap_or(0));
    while b != 0 {
        (a, b) = (b, a % b);
    }
    vec![a]
}

/// The leading bits of the first number, and the bits of the second one at the same places.
#[allow(clippy::cast_possible_wrap)] // 62 bits
fn leading(a: &[u64], b: &[u64]) -> [i64; 2] {
    let shift = a[a.len() - 1].leading_zeros();
    [a, b].map(|number| {
        let limb = |at: usize| u128::from(number.get(at).copied().unwrap_or(0));
        let two = limb(a.len() - 1) << 64 | limb(a.len() - 2);
        (halves(two << shift).1 >> (64 - LEADING)) as i64
    })
}

/// The map of the steps that leading bits determine: the new numbers are x·a + y·b and u·a + v·b for [x, y, u, v].
///
/// The true ratio of the numbers is between (a + x)/(b + u) and (a + y)/(b + v), so a quotient is certain if both have
/// it (Knuth, algorithm L).
fn steps([mut a, mut b]: [i64; 2]) -> [i64; 4] {
    let [mut x, mut y, mut u, mut v] = [1, 0, 0, 1];
    while b + u != 0 && b + v != 0 {
        let quotient = (a + x) / (b + u);
        if quotient != (a + y) / (b + v) {
            break;
        }
        (a, b) = (b, a - quotient * b);
        (x, u) = (u, x - quotient * u);
        (y, v) = (v, y - quotient * v);
    }
    [x, y, u, v]
}

/// Replaces both numbers by their combinations, which are not negative.
fn combine(a: &mut Vec<u64>, b: &mut Vec<u64>, map: [i64; 4]) {
    let [x, y, u, v] = map.map(i128::from);
    b.resize(a.len(), 0);
    let (mut first, mut second) = (0_i128, 0_i128);
    for (a, b) in a.iter_mut().zip(b.iter_mut()) {
        let [of_a, of_b] = [*a, *b].map(i128::from);
        first += x * of_a + y * of_b;
        second += u * of_a + v * of_b;
        (*a, *b) = (lowest(first), lowest(second));
        (first, second) = (first >> 64, second >> 64);
    }
    debug_assert!(first == 0 && second == 0, "remainders are not negative");
    trim(a);
    trim(b);
}

/// The lowest limb of a number in two's complement.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // the lowest 64 bits
fn lowest(number: i128) -> u64 {
    number as u64
}

/// Replaces a number by its remainder by a divisor that is not zero (Knuth, 4.3.1, algorithm D).
pub(super) fn remainder(a: &mut Vec<u64>, divisor: &[u64]) {
    if let &[short] = divisor {
        let rest = a.iter().rev().fold(0, |rest, &limb| {
            let wide = u128::from(rest) << 64 | u128::from(limb);
            halves(wide % u128::from(short)).0
        });
        *a = vec![rest];
        return trim(a);
    }
    // The divisor's highest bit is set, so that a quotient estimated by three limbs is one too large at most.
    let shift = divisor[divisor.len() - 1].leading_zeros();
    let mut scaled = divisor.to_vec();
    shift_left(&mut scaled, shift);
    a.push(0);
    shift_left(a, shift);
    let length = scaled.len();
    let (top, next) = (u128::from(scaled[length - 1]), u128::from(scaled[length - 2]));
    for at in (0..a.len().saturating_sub(length)).rev() {
        let part = &mut a[at..=at + length];
        let leading = u128::from(part[length]) << 64 | u128::from(part[length - 1]);
        let (mut quotient, mut rest) = (leading / top, leading % top);
        while quotient >> 64 != 0 || quotient * next > (rest << 64 | u128::from(part[length - 2])) {
            quotient -= 1;
            rest += top;
            if rest >> 64 != 0 {
                break;
            }
        }
        let quotient = halves(quotient).0;
        let borrow = subtract_multiple(&mut part[..length], &scaled, quotient);
        let (limb, too_much) = part[length].overflowing_sub(borrow);
        part[length] = limb;
        if too_much {
            let carry = add(&mut part[..length], &scaled);
            part[length] = part[length].wrapping_add(carry);
        }
    }
    trim(a);
    shift_right(a, shift);
    trim(a);
}

/// Subtracts a multiple of a number in place, as far as there are limbs, and returns the borrow.
fn subtract_multiple(from: &mut [u64], number: &[u64], factor: u64) -> u64 {
    let mut borrow = 0;
    for (limb, &less) in from.iter_mut().zip(number) {
        let (low, high) = halves(u128::from(less) * u128::from(factor) + u128::from(borrow));
        let (difference, more) = limb.overflowing_sub(low);
        *limb = difference;
        borrow = high + u64::from(more);
    }
    borrow
}

/// Shifts limbs left by less than 64 bits; the highest bits must be zero.
fn shift_left(limbs: &mut [u64], shift: u32) {
    let mut carry = 0;
    for limb in limbs {
        let (low, high) = halves(u128::from(*limb) << shift);
        (*limb, carry) = (low | carry, high);
    }
}

/// Shifts limbs right by less than 64 bits.
fn shift_right(limbs: &mut [u64], shift: u32) {
    let mut carry = 0;
    for limb in limbs.iter_mut().rev() {
        let (low, high) = halves((u128::from(*limb) << 64) >> shift);
        (*limb, carry) = (high | carry, low);
    }
}

/// The quotient of a number by one of its divisors, from the low end (Jebelean 1993).
///
/// An odd divisor has an inverse modulo 2^64. The lowest limb of what remains, times this inverse, is the next limb of
/// the quotient.
pub(super) fn exact(number: &[u64], divisor: &[u64]) -> Vec<u64> {
    let zeros = divisor.iter().take_while(|&&limb| limb == 0).count();
    let (Some(number), divisor) = (number.get(zeros..), &divisor[zeros..]) else { return Vec::new() };
    let shift = divisor[0].trailing_zeros();
    let (mut rest, mut odd) = (number.to_vec(), divisor.to_vec());
    shift_right(&mut rest, shift);
    shift_right(&mut odd, shift);
    let odd = trimmed(&odd);
    let Some(length) = (rest.len() + 1).checked_sub(odd.len()) else { return Vec::new() };
    let inverse = inverse(odd[0]);
    rest.truncate(length);
    let mut quotient = Vec::with_capacity(length);
    for at in 0..length {
        let limb = rest[at].wrapping_mul(inverse);
        quotient.push(limb);
        let rest = &mut rest[at..];
        let borrow = subtract_multiple(rest, odd, limb);
        if let Some(beyond) = rest.get_mut(odd.len()..).filter(|beyond| !beyond.is_empty()) {
            subtract(beyond, &[borrow]);
        }
    }
    quotient
}

/// The inverse of an odd number modulo 2^64, by Newton's iteration: each step doubles the bits that are right.
fn inverse(odd: u64) -> u64 {
    // Three bits are right: the square of an odd number is 1 modulo 8.
    let mut inverse = odd;
    for _ in 0..5 {
        inverse = inverse.wrapping_mul(2_u64.wrapping_sub(odd.wrapping_mul(inverse)));
    }
    inverse
}
