//! The vocabulary of predicament: signs, vertices, scenes, contracts, and the traits of backends and sessions.
//!
//! Every backend implements these traits and every algorithm is generic over them. This crate computes nothing. Read it
//! first: all others use its terms.
//!
//! * [`Scene`]: finite points by index; [`Vertex`]: one point, by identity.
//! * [`Construction`]: the definition of a constructed vertex; [`Share`]: the exact number in it; [`Constructs`]: a
//!   backend's treatment of constructed vertices; [`Refused`]: why a session did not construct one; [`NoPoint`]: why a
//!   definition has no point.
//! * [`Backend`]: prepares a scene; [`Predicates`]: the session that answers.
//! * [`Sessions`]: prepares sessions for scenes that an algorithm makes.
//! * [`Contract`]: the meaning of zero; [`Band`]: its width; [`Declined`]: the reason of a refusal.
//! * [`Derived`]: a predicate from a formula, beside the five of [`PredicateKind`].
//! * [`QuerySet`]: many queries as data; [`Query`]: one query as text and back.
//! * [`Broken`]: the payload that a session throws if it cannot answer, for example because its process crashed.
//! * [`Class`]: the comparison of an answer with the truth; [`Severity`]: its severity; [`Status`]: the gate's status
//!   of a scene.
//! * [`Tally`]: counts the stage that settled each query; free of cost if it is off.
//! * [`answer_by!`], [`forward_to!`]: write the methods of a session that wraps another one.
//! * [`contradiction!`]: declares the error of an algorithm that stops when signs contradict each other.

#![cfg_attr(not(any(test, feature = "std")), no_std)]

extern crate alloc;

mod backend;
mod boxed;
mod broken;
mod class;
mod construction;
mod constructs;
mod contact;
mod contract;
mod contradiction;
#[cfg(feature = "formulas")]
mod derived;
mod interned;
mod query;
mod question;
mod scene;
mod sessions;
mod share;
mod tally;
#[cfg(not(feature = "formulas"))]
mod underived;
mod unknown_name;
mod vertex;
mod wrap;

/// The types that macros of this crate name in other crates.
#[doc(hidden)]
pub mod alloc_of_macros {
    pub use alloc::boxed::Box;
}

pub use backend::{Backend, Batches, Predicates};
pub use broken::Broken;
pub use class::{Class, Severity, Status};
pub use construction::{Construction, ConstructionError};
pub use constructs::{Constructs, DefinitionError, NoPoint, Refused};
pub use contract::{Band, Contract, Declined, ZeroMeaning};
#[cfg(feature = "formulas")]
pub use derived::Derived;
pub use predicament_arithmetic::Sign;
#[cfg(feature = "formulas")]
pub use predicament_formula as formula;
pub use query::{ParseQueryError, Query};
pub use question::{PredicateKind, QuerySet, Question};
pub use scene::{Dimension, Scene, SceneError};
pub use sessions::Sessions;
pub use share::{Share, ShareError};
pub use tally::{Counts, MAX_STAGES, Off, Tally};
#[cfg(not(feature = "formulas"))]
pub use underived::Derived;
pub use unknown_name::UnknownName;
pub use vertex::{Axis, ParseVertexError, Plane, Vertex};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
