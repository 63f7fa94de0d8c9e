//! Tests of half-edge meshes through the public interface: conversions, operations, long random sequences.

mod collapse;
mod conversion;
mod cut;
mod loops;
mod operations;
mod random;
mod sequence;
mod shapes;
mod structures;
