//! Tests that export run folders and read them back, and tests of refused input.

mod common;
mod copies;
mod refused;
mod round_trip;
