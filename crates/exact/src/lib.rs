//! The exact backend: the sign of the real determinant, for every finite input.
//!
//! A query climbs a ladder until a rung can prove its answer ([`stage`]):
//!
//! 1. plain floating point, where every intermediate is a double anyway;
//! 2. the static [`filter`]: plain floating point with one bound on its error
//!    for the whole scene;
//! 3. the semi-static filter, with a bound for the query;
//! 4. [`integer`]s of a fixed size, over one power of two for the scene;
//! 5. [`dyadic`]: exact dyadic numbers, limbs times a power of two.
//!
//! Which of them apply is proved, once per scene, by a
//! [`Plan`](predicament_arithmetic::Plan), and for a scene whose exponents are
//! too wide for integers, again for each query alone. [`Precision`] says what
//! was chosen. A scene pays only for the rungs that it needs: short numbers get no
//! filter, and long ones climb straight to the integers that they fit. No
//! rung allocates. `docs/EXACT.md` has the conditions and the bits of each.
//!
//! [`constructed`] vertices have a ladder of their own, of two rungs. [`raw`]
//! predicates take coordinates and no scene. [`rational`] is not on the ladder: it
//! returns the exact values of determinants.
//!
//! [`Partial`] is a control: the first rungs alone.
//!
//! [`Session`] also decides without tallying (`decide_…`), for backends that
//! stand on this one and count their own stages.

mod backend;
mod batch;
pub mod constructed;
pub mod dyadic;
pub mod estimate;
pub mod filter;
pub mod form;
pub mod integer;
mod integers;
mod ladder;
mod partial;
mod precision;
mod predicate;
mod products;
pub mod rational;
pub mod raw;
mod session;
pub mod side;
pub mod stage;
mod truncate;

pub use backend::Exact;
pub use partial::{Partial, PartialSession};
pub use precision::{Choice, Precision};
pub use session::Session;
