//! Many queries at once in vector registers, for every backend that answers batches.
//!
//! A batch is taken in [blocks](Block) of [`BLOCK`] queries: the points of a block are fetched and transposed, a formula is evaluated lane
//! by lane, and signs are written. A [`Kernel`] is compiled once for each [`Width`] of registers, from the same source. No operation
//! is fused or reordered, so a lane computes what the same formula computes about one query.
//!
//! * [`answer`]: the signs of a formula, as they are: what backends without filters answer.
//! * [`signs_of`]: the signs of a formula where they are certain, and which queries are left open.
//! * [`Block`], [`Kernel`], [`dispatch`]: the parts, for backends with filters of their own.
//!
//! Backends share this crate so that their timings differ by arithmetic and not by how points are fetched.

mod answer;
mod block;
mod certain;
mod simd;

pub use answer::answer;
pub use block::{Along, BLOCK, Block, View, Whole, Xy, Yz, Zx};
pub use certain::signs_of;
pub use simd::{Kernel, Width, dispatch, run_on};
