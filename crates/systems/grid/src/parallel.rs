//! Parallel loops that are compiled once, and not for each kind of session.
//!
//! An algorithm is generic over the session, and a parallel iterator inside of it would be compiled again for each
//! backend, with all its dependencies. Here the work on a piece is behind a pointer: one indirect call for a piece of
//! many items.

use rayon::prelude::*;

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
