//! The crate, held to rationals, to explicit infinitesimals and to the hand-made predicates.

mod common;
mod filters;
mod grammar;
mod peers;
mod perturbed;
mod random;
mod written;
