//! Sums, differences and products of magnitudes: limbs, least significant first.

use alloc::{vec, vec::Vec};
use core::cmp::Ordering;

/// The length in limbs from which on products are Karatsuba's.
const KARATSUBA: usize = 40;

/// Removes zeros at the upper end.
pub(super) fn trim(limbs: &mut Vec<u64>) {
    let length = trimmed(limbs).len();
    limbs.truncate(length);
}

/// The limbs without zeros at the upper end.
pub(super) fn trimmed(limbs: &[u64]) -> &[u64] {
    let length = limbs.iter().rposition(|&limb| limb != 0).map_or(0, |last| last + 1);
    &limbs[..length]
}

/// The order of two magnitudes without zeros at the upper end.
pub(super) fn compare(a: &[u64], b: &[u64]) -> Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

/// The lower and the upper half of a number of two limbs.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // halves of 128 bits
pub(super) fn halves(wide: u128) -> (u64, u64) {
    (wide as u64, (wide >> 64) as u64)
}

/// Adds the shorter number in place and returns the carry.
pub(super) fn add(sum: &mut [u64], other: &[u64]) -> u64 {
    let mut carry = false;
    let (low, high) = sum.split_at_mut(other.len());
    for (limb, &more) in low.iter_mut().zip(other) {
        (*limb, carry) = carrying(*limb, more, carry);
    }
    for limb in high {
        if !carry {
            return 0;
        }
        (*limb, carry) = limb.overflowing_add(1);
    }
    u64::from(carry)
}

/// Subtracts the shorter number in place and returns the borrow.
pub(super) fn subtract(from: &mut [u64], other: &[u64]) -> u64 {
    let mut borrow = false;
    let (low, high) = from.split_at_mut(other.len());
    for (limb, &less) in low.iter_mut().zip(other) {
        (*limb, borrow) = borrowing(*limb, less, borrow);
    }
    for limb in high {
        if !borrow {
            return 0;
        }
        (*limb, borrow) = limb.overflowing_sub(1);
    }
    u64::from(borrow)
}

/// Replaces a number by its difference from a number of the same length that is not smaller.
pub(super) fn subtract_from(less: &mut [u64], from: &[u64]) {
    let mut borrow = false;
    for (limb, &from) in less.iter_mut().zip(from) {
        (*limb, borrow) = borrowing(from, *limb, borrow);
    }
    debug_assert!(!borrow, "the larger number is the second");
}

#[inline(always)]
fn carrying(a: u64, b: u64, carry: bool) -> (u64, bool) {
    let (sum, first) = a.overflowing_add(b);
    let (sum, second) = sum.overflowing_add(u64::from(carry));
    (sum, first | second)
}

#[inline(always)]
fn borrowing(a: u64, b: u64, borrow: bool) -> (u64, bool) {
    let (difference, first) = a.overflowing_sub(b);
    let (difference, second) = difference.overflowing_sub(u64::from(borrow));
    (difference, first | second)
}

/// The product of a magnitude and a power of two.
pub(super) fn shifted(limbs: &[u64], places: u32) -> Vec<u64> {
    let (whole, bits) = (places / u64::BITS, places % u64::BITS);
    let mut shifted = vec![0; whole as usize];
    let mut carry = 0;
    for &limb in limbs {
        let (low, high) = halves(u128::from(limb) << bits);
        shifted.push(low | carry);
        carry = high;
    }
    shifted.push(carry);
    shifted
}

/// The sum of two magnitudes.
pub(super) fn sum(a: &[u64], b: &[u64]) -> Vec<u64> {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let mut sum = Vec::with_capacity(long.len() + 1);
    sum.extend_from_slice(long);
    let carry = add(&mut sum, short);
    sum.push(carry);
    sum
}

/// The difference of two magnitudes, the first of which is not the smaller one.
pub(super) fn difference(a: &[u64], b: &[u64]) -> Vec<u64> {
    let mut difference = a.to_vec();
    let borrow = subtract(&mut difference, b);
    debug_assert_eq!(borrow, 0, "the larger number first");
    difference
}

/// The product of two magnitudes.
pub(super) fn product(a: &[u64], b: &[u64]) -> Vec<u64> {
    let mut product = vec![0; a.len() + b.len()];
    multiply(&mut product, a, b);
    product
}

/// Writes a product to limbs that are zero, as many as both numbers have together.
pub(super) fn multiply(product: &mut [u64], a: &[u64], b: &[u64]) {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    if short.len() < KARATSUBA {
        for (at, &factor) in short.iter().enumerate() {
            product[at + long.len()] = accumulate(&mut product[at..], long, factor);
        }
    } else if 2 * short.len() <= long.len() {
        // Parts of the longer number, each as long as the shorter one.
        for (at, part) in long.chunks(short.len()).enumerate() {
            let mut partial = vec![0; part.len() + short.len()];
            multiply(&mut partial, part, short);
            add(&mut product[at * short.len()..], trimmed(&partial));
        }
    } else {
        karatsuba(product, long, short);
    }
}

/// Adds a multiple of a number in place and returns the carry.
#[inline]
pub(super) fn accumulate(sum: &mut [u64], number: &[u64], factor: u64) -> u64 {
    let mut carry = 0;
    for (limb, &more) in sum.iter_mut().zip(number) {
        (*limb, carry) = halves(u128::from(more) * u128::from(factor) + u128::from(*limb) + u128::from(carry));
    }
    carry
}

/// Karatsuba's product: three products of half the length, for (a₁·X + a₀)(b₁·X + b₀).
///
/// The product in the middle is (a₀ + a₁)(b₀ + b₁) − a₀b₀ − a₁b₁.
fn karatsuba(product: &mut [u64], a: &[u64], b: &[u64]) {
    let half = a.len().div_ceil(2);
    let ((a0, a1), (b0, b1)) = (a.split_at(half), b.split_at(half));
    let (low, high) = product.split_at_mut(2 * half);
    multiply(low, a0, b0);
    multiply(high, a1, b1);
    let (a, b) = (sum(a0, a1), sum(b0, b1));
    let mut middle = self::product(trimmed(&a), trimmed(&b));
    subtract(&mut middle, trimmed(low));
    subtract(&mut middle, trimmed(high));
    add(&mut product[half..], trimmed(&middle));
}
