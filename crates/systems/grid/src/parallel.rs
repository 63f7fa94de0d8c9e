//! Parallel loops that are compiled once, and not for each kind of session.
//!
//! An algorithm is generic over the session, and a parallel iterator inside of it would be compiled again for each
//! backend, with all its dependencies. Here the work on a piece is behind a pointer: one indirect call for a piece of
//! many items.

use std::ops::Range;

use rayon::prelude::*;

/// The number of items below which one thread processes them all.
const ALONE: usize = 1 << 13;
/// Pieces of work per thread, if pieces take different times.
const UNEVEN: usize = 8;

/// The results of `work` for each of `0..count`, in this order.
pub fn each<R: Send>(count: usize, work: &(dyn Fn(usize) -> R + Sync)) -> Vec<R> {
    (0..count).into_par_iter().map(work).collect()
}

/// The results of `work` for each piece of `piece` items, in the order of the items.
pub fn pieces<T: Sync, R: Send>(items: &[T], piece: usize, work: &(dyn Fn(&[T]) -> R + Sync)) -> Vec<R> {
    items.par_chunks(piece).map(work).collect()
}

/// The results of `work` for each item, in their order; for short work.
pub fn all<T: Sync, R: Send>(items: &[T], work: &(dyn Fn(&T) -> R + Sync)) -> Vec<R> {
    items.par_iter().with_min_len(8192).map(work).collect()
}

/// The results of two pieces of work.
pub fn both<R: Send>(one: &(dyn Fn() -> R + Sync), other: &(dyn Fn() -> R + Sync)) -> [R; 2] {
    rayon::join(one, other).into()
}

/// The results of two pieces of work on this many items, in parallel if there are many.
pub fn two<A: Send, B: Send>(items: usize, one: impl FnOnce() -> A + Send, other: impl FnOnce() -> B + Send) -> (A, B) {
    if threads(items) == 1 { (one(), other()) } else { rayon::join(one, other) }
}

/// The number of threads for work on this many items: one, if there are few.
#[must_use]
pub fn threads(items: usize) -> usize {
    if items < 2 * ALONE { 1 } else { rayon::current_num_threads().min(items / ALONE) }
}

/// The results of pieces of work, in order; at least one. A single result needs no allocation.
pub struct Parts<R> {
    first: R,
    others: Vec<R>,
}

impl<R> Parts<R> {
    /// True if there is one result.
    #[must_use]
    pub fn is_single(&self) -> bool {
        self.others.is_empty()
    }

    /// The first result, with the others added to it one by one.
    pub fn joined(self, mut add: impl FnMut(&mut R, R)) -> R {
        let mut all = self.first;
        self.others.into_iter().for_each(|one| add(&mut all, one));
        all
    }
}

impl<R> IntoIterator for Parts<R> {
    type Item = R;
    type IntoIter = std::iter::Chain<std::iter::Once<R>, std::vec::IntoIter<R>>;

    fn into_iter(self) -> Self::IntoIter {
        std::iter::once(self.first).chain(self.others)
    }
}

/// The results of `work` for ranges that cover `0..count`, in order. One thread processes a single range.
///
/// The number of threads decides where ranges end, so the joined results must not depend on that.
pub fn ranges<R: Send>(count: usize, work: &(dyn Fn(Range<usize>) -> R + Sync)) -> Parts<R> {
    in_parts(count, threads(count), work)
}

/// The results of `work` as by [`ranges`], in more and shorter ranges: for items that take different times.
pub fn uneven<R: Send>(count: usize, items: usize, work: &(dyn Fn(Range<usize>) -> R + Sync)) -> Parts<R> {
    let threads = threads(items);
    in_parts(count, if threads == 1 { 1 } else { UNEVEN * threads }, work)
}

/// The results of `work` for this many ranges of about equal length that cover `0..count`, in order.
pub fn in_parts<R: Send>(count: usize, parts: usize, work: &(dyn Fn(Range<usize>) -> R + Sync)) -> Parts<R> {
    let parts = parts.min(count).max(1);
    let part = |part: usize| work(count * part / parts..count * (part + 1) / parts);
    if parts == 1 {
        return Parts { first: part(0), others: Vec::new() };
    }
    let mut others = each(parts, &part);
    Parts { first: others.remove(0), others }
}

/// The lists one after the other.
#[must_use]
pub fn joined<T>(lists: Parts<Vec<T>>) -> Vec<T> {
    let more = lists.others.iter().map(Vec::len).sum();
    lists.joined(|all, mut list| {
        if all.capacity() - all.len() < list.len() {
            all.reserve_exact(more);
        }
        all.append(&mut list);
    })
}

/// The lists one after the other, or the first error.
///
/// # Errors
/// The first error of the list.
pub fn all_joined<T, E>(lists: Parts<Result<Vec<T>, E>>) -> Result<Vec<T>, E> {
    let (first, others) = (lists.first?, lists.others.into_iter().collect::<Result<_, E>>()?);
    Ok(joined(Parts { first, others }))
}

/// Sorts items by a key, on all threads if there are many. Items with equal keys have to be equal.
pub fn sort_by_key<T: Send, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K + Sync) {
    if threads(items.len()) == 1 { items.sort_unstable_by_key(key) } else { items.par_sort_unstable_by_key(key) }
}
