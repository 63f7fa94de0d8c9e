//! Half-edge meshes from outside: conversions, operations, long random sequences.

mod conversion;
mod cut;
mod loops;
mod operations;
mod random;
mod sequence;
mod shapes;
