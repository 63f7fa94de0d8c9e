//! The arithmetic under [`Dyadic`](super::Dyadic), on slices of any length.
//!
//! Capacities are part of types, and code for each combination of them would
//! be code a hundred times. Here is one copy, which reads numbers where they
//! lie and writes the result where it belongs.

use std::cmp::Ordering;

/// A number to read: ± Σ limbs\[i\]·2^(64·(place + i)), with no zero limb at
/// either end, and none at all for zero.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    pub negative: bool,
    pub place: i32,
    pub limbs: &'a [u64],
}

/// What there is to a number besides its limbs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Header {
    pub negative: bool,
    pub place: i32,
    pub len: usize,
}

impl Header {
    pub const ZERO: Header = Header { negative: false, place: 0, len: 0 };
}

/// ± significand · 2^exponent.
#[inline]
pub(super) fn write(out: &mut [u64], negative: bool, significand: u64, exponent: i32) -> Header {
    if significand == 0 {
        return Header::ZERO;
    }
    let place = exponent.div_euclid(64);
    let (low, high) = split(u128::from(significand) << exponent.rem_euclid(64));
    let (len, place) = match (low, high) {
        (_, 0) => (1, place),
        (0, _) => (1, place + 1),
        _ => (2, place),
    };
    assert_fits(len, out);
    out[0] = if low == 0 { high } else { low };
    if len == 2 {
        out[1] = high;
    }
    Header { negative, place, len }
}

/// a + b.
#[inline(never)]
pub(super) fn sum(out: &mut [u64], a: View, b: View) -> Header {
    if b.limbs.is_empty() {
        return copy(out, a);
    }
    if a.limbs.is_empty() {
        return copy(out, b);
    }
    // Both counted from the lower of the lowest limbs.
    let place = a.place.min(b.place);
    let [a_start, b_start] = [a, b].map(|number| distance(place, number.place));
    let [a_end, b_end] = [a_start + a.limbs.len(), b_start + b.limbs.len()];
    if a.negative == b.negative {
        let end = a_end.max(b_end);
        assert_fits(end, out);
        spread(&mut out[..end], a_start, a.limbs);
        let mut len = end;
        if add(&mut out[b_start..end], b.limbs) {
            len += 1;
            assert_fits(len, out);
            out[end] = 1;
        }
        return trimmed(out, Header { negative: a.negative, place, len });
    }
    let (larger, start, len, smaller, smaller_start) = match compare((a.limbs, a_start), (b.limbs, b_start)) {
        Ordering::Equal => return Header::ZERO,
        Ordering::Greater => (a, a_start, a_end, b, b_start),
        Ordering::Less => (b, b_start, b_end, a, a_start),
    };
    assert_fits(len, out);
    spread(&mut out[..len], start, larger.limbs);
    subtract(&mut out[smaller_start..len], smaller.limbs);
    trimmed(out, Header { negative: larger.negative, place, len })
}

/// a · b.
#[inline(never)]
pub(super) fn product(out: &mut [u64], a: View, b: View) -> Header {
    let len = a.limbs.len() + b.limbs.len();
    // The fewer rows the better.
    let (rows, columns) = if a.limbs.len() < b.limbs.len() { (a.limbs, b.limbs) } else { (b.limbs, a.limbs) };
    let Some((&first, rows)) = rows.split_first() else {
        return Header::ZERO;
    };
    assert_fits(len, out);
    let mut carry = 0;
    for (limb, &y) in out.iter_mut().zip(columns) {
        (*limb, carry) = split(u128::from(first) * u128::from(y) + u128::from(carry));
    }
    out[columns.len()] = carry;
    for (below, &x) in rows.iter().enumerate() {
        let row = &mut out[below + 1..][..=columns.len()];
        let (top, row) = row.split_last_mut().expect("as long as a factor, and one more");
        *top = 0;
        // Sums of far-apart numbers are full of zeros.
        if x != 0 {
            let mut carry = 0;
            for (limb, &y) in row.iter_mut().zip(columns) {
                (*limb, carry) = split(u128::from(x) * u128::from(y) + u128::from(*limb) + u128::from(carry));
            }
            *top = carry;
        }
    }
    trimmed(out, Header { negative: a.negative != b.negative, place: add_places(a.place, b.place), len })
}

/// A number as it is.
pub(super) fn copy(out: &mut [u64], a: View) -> Header {
    let len = a.limbs.len();
    assert_fits(len, out);
    out[..len].copy_from_slice(a.limbs);
    Header { negative: a.negative, place: a.place, len }
}

/// Drops zero limbs at both ends of a number that is not zero.
#[inline(always)]
fn trimmed(out: &mut [u64], mut header: Header) -> Header {
    while out[header.len - 1] == 0 {
        header.len -= 1;
    }
    if out[0] == 0 {
        let zeros = out.iter().take_while(|&&limb| limb == 0).count();
        out.copy_within(zeros..header.len, 0);
        header.len -= zeros;
        header.place = add_places(header.place, i32::try_from(zeros).expect("a capacity is small"));
    }
    header
}

/// The limbs from `start` on, and zeros around them.
#[inline(always)]
fn spread(out: &mut [u64], start: usize, limbs: &[u64]) {
    let (below, rest) = out.split_at_mut(start);
    let (here, above) = rest.split_at_mut(limbs.len());
    // Most often there is nothing around them.
    if !below.is_empty() {
        below.fill(0);
    }
    here.copy_from_slice(limbs);
    if !above.is_empty() {
        above.fill(0);
    }
}

/// Compares magnitudes, each with the place where it starts.
#[inline]
fn compare((a, a_start): (&[u64], usize), (b, b_start): (&[u64], usize)) -> Ordering {
    let (a_end, b_end) = (a_start + a.len(), b_start + b.len());
    let at = |limbs: &[u64], start: usize, place: usize| {
        place.checked_sub(start).and_then(|i| limbs.get(i)).copied().unwrap_or(0)
    };
    a_end.cmp(&b_end).then_with(|| {
        (a_start.min(b_start)..a_end)
            .rev()
            .map(|place| at(a, a_start, place).cmp(&at(b, b_start, place)))
            .find(|order| order.is_ne())
            .unwrap_or(Ordering::Equal)
    })
}

/// sum += b; whether a carry leaves `sum`.
#[inline]
fn add(sum: &mut [u64], b: &[u64]) -> bool {
    let (low, high) = sum.split_at_mut(b.len());
    let mut carry = false;
    for (a, &b) in low.iter_mut().zip(b) {
        let (partial, first) = a.overflowing_add(b);
        let (total, second) = partial.overflowing_add(u64::from(carry));
        (*a, carry) = (total, first | second);
    }
    for a in high {
        if !carry {
            break;
        }
        (*a, carry) = a.overflowing_add(1);
    }
    carry
}

/// difference −= b, which is smaller.
#[inline]
fn subtract(difference: &mut [u64], b: &[u64]) {
    let (low, high) = difference.split_at_mut(b.len());
    let mut borrow = false;
    for (a, &b) in low.iter_mut().zip(b) {
        let (partial, first) = a.overflowing_sub(b);
        let (total, second) = partial.overflowing_sub(u64::from(borrow));
        (*a, borrow) = (total, first | second);
    }
    for a in high {
        if !borrow {
            break;
        }
        (*a, borrow) = a.overflowing_sub(1);
    }
}

/// The low and the high half.
#[inline]
#[allow(clippy::cast_possible_truncation)] // that is what splitting means
fn split(wide: u128) -> (u64, u64) {
    (wide as u64, (wide >> 64) as u64)
}

/// How many limbs `place` lies above `origin`.
#[inline]
fn distance(origin: i32, place: i32) -> usize {
    usize::try_from(i64::from(place) - i64::from(origin)).expect("the origin is the lower one")
}

#[inline]
fn add_places(a: i32, b: i32) -> i32 {
    a.checked_add(b).expect("the exponent of a dyadic number fits")
}

#[inline]
fn assert_fits(len: usize, out: &[u64]) {
    assert!(len <= out.len(), "a number of {len} limbs exceeds the capacity of {}", out.len());
}
