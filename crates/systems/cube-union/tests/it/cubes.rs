//! Unions of cubes: the sums over vertices, compared with other ways to measure them.

mod backends;
mod closed;
mod crowds;
mod dense;
mod expected;
mod lattices;
mod laws;
mod oracle;
mod refused;
mod scenes;
mod union;
