//! The vocabulary of predicament: signs, vertices, scenes, contracts, and the
//! two traits that every backend implements and every algorithm is generic over.
//!
//! Nothing here computes. Read this crate first: all others use its terms.
//!
//! * [`Scene`]: finite points by index; [`Vertex`]: one of them, by identity.
//! * [`Construction`]: a vertex that is no input, by what defines it;
//!   [`Constructs`]: what a backend does with those that come up while it runs,
//!   [`Refused`]: why it did not construct one, [`NoPoint`]: why there is none.
//! * [`Backend`]: prepares a scene; [`Predicates`]: the session that answers.
//! * [`Sessions`]: what prepares sessions for scenes that an algorithm makes itself.
//! * [`Contract`]: what zero means; [`Band`]: how wide it is; [`Declined`]: why it refuses.
//! * [`QuerySet`]: many questions as data; [`Query`]: one of them as text and back.
//! * [`Broken`]: what a session throws where it cannot answer, such as one whose process has crashed.
//! * [`Class`]: how an answer compares with the truth, and [`Severity`]: how bad that is; [`Status`]: how the gate sees a scene.
//! * [`Tally`]: which stage settled a query; free of cost where it is off.
//! * [`answer_by!`], [`forward_to!`]: the methods of a session that wraps another one.
//! * [`contradiction!`]: the error of an algorithm that stops where signs contradict each other.

mod backend;
mod boxed;
mod broken;
mod class;
mod construction;
mod constructs;
mod contact;
mod contract;
mod contradiction;
mod interned;
mod query;
mod question;
mod scene;
mod sessions;
mod sign;
mod tally;
mod unknown_name;
mod vertex;
mod wrap;

pub use backend::{Backend, Batches, Predicates};
pub use broken::Broken;
pub use class::{Class, Severity, Status};
pub use construction::{Construction, ConstructionError};
pub use constructs::{Constructs, DefinitionError, NoPoint, Refused};
pub use contract::{Band, Contract, Declined, ZeroMeaning};
pub use query::{ParseQueryError, Query};
pub use question::{PredicateKind, QuerySet, Question};
pub use scene::{Dimension, Scene, SceneError};
pub use sessions::Sessions;
pub use sign::Sign;
pub use tally::{Counts, MAX_STAGES, Off, Tally};
pub use unknown_name::UnknownName;
pub use vertex::{Axis, ParseVertexError, Plane, Vertex};
