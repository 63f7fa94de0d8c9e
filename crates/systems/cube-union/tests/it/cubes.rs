//! Unions of cubes: the vertices' sums against other ways to measure them.

mod backends;
mod crowds;
mod dense;
mod expected;
mod lattices;
mod laws;
mod oracle;
mod refused;
mod scenes;
mod union;
