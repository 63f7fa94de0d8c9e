//! Sorting by signs that may contradict each other.
//!
//! The sorts of the standard library may panic if a comparison is not an order, and the signs of a tolerance or of
//! plain floating point are sometimes not an order. The number of steps of this sort is bounded for any answers. It
//! keeps runs that are already in order: if items are first sorted by rounded coordinates, each costs one comparison.

use predicament_predicates::Sign;

/// Sorts the items by a comparison: merges the runs that are in order, in pairs; stable.
///
/// At most n·(1 + ⌈log₂ n⌉) comparisons, and n − 1 where the items are in order.
pub fn sort_by_sign<T: Copy>(items: &mut [T], mut compare: impl FnMut(T, T) -> Sign) {
    let ends = (1..items.len()).filter(|&i| compare(items[i], items[i - 1]) == Sign::Negative).collect();
    merge_runs(items, ends, compare);
}

/// Merges sorted runs, which end before these places and at the end of the list: the second part of [`sort_by_sign`].
pub fn merge_runs<T: Copy>(items: &mut [T], mut ends: Vec<usize>, mut compare: impl FnMut(T, T) -> Sign) {
    if ends.is_empty() {
        return;
    }
    ends.push(items.len());
    let mut from = items.to_vec();
    let mut to = Vec::with_capacity(items.len());
    while ends.len() > 1 {
        to.clear();
        let mut start = 0;
        let mut merged = Vec::with_capacity(ends.len().div_ceil(2));
        for pair in ends.chunks(2) {
            let (middle, end) = (pair[0], pair[pair.len() - 1]);
            merge(&from[start..middle], &from[middle..end], &mut to, &mut compare);
            merged.push(end);
            start = end;
        }
        std::mem::swap(&mut from, &mut to);
        ends = merged;
    }
    items.copy_from_slice(&from);
}

/// Appends both runs in order; of equal items, those of the first run come first.
fn merge<T: Copy>(mut first: &[T], mut second: &[T], to: &mut Vec<T>, compare: &mut impl FnMut(T, T) -> Sign) {
    while let (Some((&a, after_a)), Some((&b, after_b))) = (first.split_first(), second.split_first()) {
        if compare(b, a) == Sign::Negative {
            to.push(b);
            second = after_b;
        } else {
            to.push(a);
            first = after_a;
        }
    }
    to.extend_from_slice(first);
    to.extend_from_slice(second);
}
