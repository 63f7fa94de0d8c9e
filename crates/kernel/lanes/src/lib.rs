//! Many queries at once in vector registers, for every backend that answers batches.
//!
//! A batch is split into [blocks](Block) of [`BLOCK`] queries: the points of a block are fetched and transposed, a
//! formula is evaluated lane by lane, and signs are written. A [`Kernel`] is compiled once for each [`Width`] of
//! registers, from the same source. The compiler neither fuses nor reorders operations, so a lane computes the same as
//! the formula for one query.
//!
//! * [`answer`]: the signs of a formula without a certificate, for backends without filters.
//! * [`signs_of`]: the signs of a formula where they are certain, and the queries that remain open.
//! * [`Block`], [`Kernel`], [`dispatch`]: the parts, for backends with their own filters.
//!
//! Backends share this crate so that their timings differ by arithmetic and not by the fetching of points.

#![cfg_attr(not(any(test, feature = "std")), no_std)]

extern crate alloc;

mod answer;
mod block;
mod certain;
mod simd;

pub use answer::answer;
pub use block::{Along, BLOCK, Block, Numbers, View, Whole, Xy, Yz, Zx};
pub use certain::signs_of;
pub use simd::{Kernel, Width, dispatch, run_on};
