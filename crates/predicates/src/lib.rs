//! The vocabulary of predicament: signs, vertices, scenes, contracts, and the
//! two traits that every backend implements and every algorithm is generic over.
//!
//! Nothing here computes: a newcomer can read this crate and know what the
//! rest of the house talks about.
//!
//! * [`Scene`]: finite points by index; [`Vertex`]: one of them, by identity.
//! * [`Construction`]: a vertex that is no input, by what defines it;
//!   [`Constructs`]: what a backend does with those that come up while it runs,
//!   [`Refused`]: why it did not construct one.
//! * [`Backend`]: prepares a scene; [`Predicates`]: the session that answers.
//! * [`Contract`]: what zero means; [`Band`]: how wide it is; [`Declined`]: "I can't".
//! * [`QuerySet`]: many questions as data; [`Query`]: one of them as text and back.
//! * [`Class`]: what becomes of an answer; [`Status`]: of a scene.
//! * [`Tally`]: which stage settled a query, at no cost when nobody asks.

mod backend;
mod class;
mod construction;
mod constructs;
mod contact;
mod contract;
mod interned;
mod query;
mod question;
mod scene;
mod sign;
mod tally;
mod vertex;

pub use backend::{Backend, Predicates};
pub use class::{Class, Status};
pub use construction::{Construction, ConstructionError};
pub use constructs::{Constructs, Refused};
pub use contract::{Band, Contract, Declined, ZeroMeaning};
pub use query::{ParseQueryError, Query};
pub use question::{PredicateKind, QuerySet, Question};
pub use scene::{Dimension, Scene, SceneError};
pub use sign::Sign;
pub use tally::{Counts, MAX_STAGES, Off, Tally};
pub use vertex::{Axis, ParseVertexError, Plane, Vertex};
