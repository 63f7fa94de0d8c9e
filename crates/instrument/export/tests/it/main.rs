//! Run folders exported and read back, and what is refused.

mod common;
mod copies;
mod refused;
mod round_trip;
