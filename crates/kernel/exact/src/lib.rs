//! The exact backend: the sign of the real determinant, for every finite input.
//!
//! A query climbs a ladder until a rung can prove its answer ([`stage`]):
//!
//! 1. the static filter: plain floating point with one bound on its error
//!    for the whole scene;
//! 2. the semi-static filter, with a bound for the query, for any doubles ([`anywhere`]);
//! 3. plain floating point as it is, where every intermediate is a double anyway;
//! 4. integers of a fixed size ([`determinant`]), over one power of two for the scene or the query;
//! 5. [`dyadic`]: exact dyadic numbers, limbs times a power of two.
//!
//! A session knows how far its scene extends, which is all that filters need. Which of the other rungs apply is proved by a
//! [`Plan`](predicament_arithmetic::Plan), made when a query first climbs to them. [`Precision`] says what
//! was chosen. A scene pays only for the rungs that it needs. A session allocates its plan, and nothing else for input vertices.
//! `docs/EXACT.md` has the conditions and the bits of each.
//!
//! [`constructed`] vertices have a ladder of their own, of two rungs. [`raw`]
//! predicates take coordinates and no scene. [`rational`] is not on the ladder: it
//! returns the exact values of determinants.
//!
//! [`Partial`] is a control: the first rungs alone.
//!
//! [`Session`] also decides without tallying (`decide_…`), for backends that
//! stand on this one and count their own stages.

pub mod anywhere;
mod backend;
mod batch;
mod common_unit;
pub mod constructed;
mod decider;
pub mod determinant;
pub mod dyadic;
pub mod estimate;
pub mod filter;
mod first;
mod ladder;
mod partial;
mod precision;
mod predicate;
mod products;
pub mod rational;
pub mod raw;
mod scene_integers;
mod session;
pub mod side;
pub mod stage;
mod truncate;

pub use backend::Exact;
pub use partial::{Partial, PartialSession};
pub use precision::{Choice, Precision};
pub use session::Session;
