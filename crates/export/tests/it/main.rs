//! Run folders exported and read back, and what is refused.

mod common;
mod refused;
mod round_trip;
