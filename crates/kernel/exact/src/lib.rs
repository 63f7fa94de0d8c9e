//! The exact backend: the sign of the real determinant, for every finite input.
//!
//! A query climbs a ladder until a rung proves its answer ([`stage`]):
//!
//! 1. the static filter: plain floating point with one bound on its error for the whole scene;
//! 2. the semi-static filter, with a bound for the query, for any doubles ([`anywhere`]);
//! 3. plain floating point, if every intermediate is representable;
//! 4. integers of a fixed size ([`determinant`]), over one power of two for the scene or the query;
//! 5. [`dyadic`]: exact dyadic numbers, limbs times a power of two.
//!
//! A session stores the extents of its scene; filters need nothing else. A [`Plan`](predicament_arithmetic::Plan), made
//! when a query first climbs beyond the filters, proves which of the other rungs apply. [`Precision`] reports the
//! choice. A scene pays only for the rungs that it needs. A session allocates its plan, and nothing else for input
//! vertices. `docs/EXACT.md` has the conditions and the bits of each.
//!
//! [`constructed`] vertices have a separate ladder of two rungs. [`raw`] predicates take coordinates and no scene.
//!
//! [`Partial`] is a control that uses the first rungs alone, and [`without::Without`] one that leaves one device out.
//!
//! [`Session`] also decides without tallying (`decide_…`), for backends that build on this one and count their own
//! stages.

#![cfg_attr(not(any(test, feature = "std")), no_std)]

#[cfg(feature = "scenes")]
extern crate alloc;

mod alone;
pub mod anywhere;
#[cfg(feature = "scenes")]
mod backend;
#[cfg(feature = "scenes")]
mod batch;
mod common_unit;
#[cfg(feature = "scenes")]
pub mod constructed;
#[cfg(feature = "scenes")]
mod decider;
#[cfg(feature = "formulas")]
pub mod derived;
pub mod determinant;
#[cfg_attr(not(feature = "scenes"), allow(dead_code))] // sessions use the rest
mod differences;
pub mod dyadic;
pub mod estimate;
mod few_bits;
#[cfg(feature = "scenes")]
mod first;
#[cfg(feature = "scenes")]
mod ladder;
#[cfg(feature = "scenes")]
mod once;
#[cfg(feature = "scenes")]
mod partial;
mod points;
#[cfg(feature = "scenes")]
mod precision;
pub mod predicate;
mod products;
#[cfg(test)]
#[path = "../tests/rational/mod.rs"]
mod rational;
pub mod raw;
#[cfg(feature = "scenes")]
mod scene_integers;
#[cfg(feature = "scenes")]
mod session;
#[cfg(feature = "scenes")]
pub mod side;
pub mod stage;
mod truncate;
#[cfg(feature = "scenes")]
pub mod without;

#[cfg(feature = "scenes")]
pub use backend::Exact;
#[cfg(feature = "scenes")]
pub use batch::Ties;
#[cfg(feature = "scenes")]
pub use decider::Filtered;
#[cfg(feature = "scenes")]
pub use partial::{Partial, PartialSession};
pub use points::{
    f32, i32, i64, incircle, insphere, orient2d, orient3d, try_incircle, try_insphere, try_orient2d, try_orient3d,
};
#[cfg(feature = "scenes")]
pub use precision::{Choice, Precision};
pub use predicament_arithmetic::Sign;
#[cfg(feature = "scenes")]
pub use predicament_predicates as predicates;
pub use raw::NotFinite;
#[cfg(feature = "scenes")]
pub use session::Session;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
