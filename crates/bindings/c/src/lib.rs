//! The C library: exact signs of geometric predicates behind functions of C.
//!
//! The crate answers one question: how does a program in C, or in a language that calls C, ask this project's
//! predicates? It computes nothing itself. Signs are those of the crates `exact` and `sos`. Programs include
//! `include/predicament.h`, which cbindgen makes from [`ffi`]; `README.md` is the manual.
//!
//! * [`ffi`]: the functions of the header, the only module with unsafe code. A panic never leaves it.
//! * [`failure`]: the result codes.
//! * [`number`]: signs of points for each type of number.
//! * [`prepared`]: a scene with its session, in one value.

mod centred;
mod failure;
#[allow(unsafe_code)]
pub mod ffi;
mod number;
mod prepared;
