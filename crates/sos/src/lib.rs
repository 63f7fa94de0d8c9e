//! The Simulation of Simplicity backend.
