//! The arithmetic under [`Number`](super::Number), on slices of any length.

/// Adds a·b to the window or subtracts it, modulo the window's length.
#[inline(never)]
pub(super) fn accumulate(window: &mut [u64], a: &[u64], b: &[u64], minus: bool) {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    for (i, &factor) in short.iter().enumerate() {
        // Sums of numbers with far-apart exponents have many zero limbs.
        if factor != 0 {
            let row = &mut window[i..];
            if minus { subtract_row(row, long, factor) } else { add_row(row, long, factor) }
        }
    }
}

/// Adds a row of products; the carry is a limb at most: (2^64 − 1)² + 2(2^64 − 1) = 2^128 − 1.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // halves of 128 bits
fn add_row(row: &mut [u64], long: &[u64], factor: u64) {
    let mut carry = 0;
    let (body, above) = row.split_at_mut(long.len());
    for (limb, &other) in body.iter_mut().zip(long) {
        let wide = u128::from(factor) * u128::from(other) + u128::from(*limb) + u128::from(carry);
        *limb = wide as u64;
        carry = (wide >> 64) as u64;
    }
    for limb in above {
        let (sum, over) = limb.overflowing_add(carry);
        *limb = sum;
        if !over {
            return;
        }
        carry = 1;
    }
}

/// Subtracts a row of products; the borrow is a limb at most.
///
/// The lower half of (2^64 − 1)² + 2^64 − 1 = (2^64 − 1)·2^64 is zero, and any smaller value has an upper half that can
/// take one more.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // halves of 128 bits
fn subtract_row(row: &mut [u64], long: &[u64], factor: u64) {
    let mut borrow = 0;
    let (body, above) = row.split_at_mut(long.len());
    for (limb, &other) in body.iter_mut().zip(long) {
        let wide = u128::from(factor) * u128::from(other) + u128::from(borrow);
        let (difference, under) = limb.overflowing_sub(wide as u64);
        *limb = difference;
        borrow = (wide >> 64) as u64 + u64::from(under);
    }
    for limb in above {
        let (difference, under) = limb.overflowing_sub(borrow);
        *limb = difference;
        if !under {
            return;
        }
        borrow = 1;
    }
}

/// Replaces the number by its negative in two's complement.
pub(super) fn negate(window: &mut [u64]) {
    let mut carry = true;
    for limb in window {
        (*limb, carry) = (!*limb).overflowing_add(u64::from(carry));
    }
}
