//! The study of parity: how often registrations make two closed curves cross an odd number of times.
//!
//! Closed curves can't, so if registrations say that they do, the registrations contradict each other. Neither
//! perturbed nor exact signs ever do. A tolerance scheme decides each pair within its tolerance of the truth, and no
//! tolerance on single pairs keeps the sum even. The reason: registering two vertices as one moves edges by more than
//! the distance within which an edge and a vertex are registered, so an edge can be moved across a vertex.
//! `docs/TOLERANCE.md` explains it on the smallest scene found.
//!
//! * [`Parity`]: the study.
//! * [`PolygonPair`]: two simple closed polygons; [`random_pair`]: nearly degenerate ones.
//! * [`examine`]: merges a pair by a backend's registrations and counts crossings.
//! * [`search`]: many pairs, counted.
//! * [`shrink_odd`]: the smallest pair that a find can be reduced to; [`smallest`]: the smallest pair of each kind.
//! * [`space`]: all of this for closed surfaces.

mod examine;
mod kind;
mod pair;
mod random;
mod search;
mod searched;
mod smallest;
pub mod space;
mod study;
mod suite;
mod table;

pub use examine::{Examined, examine};
pub use kind::Kind;
pub use pair::{PolygonPair, shrink_odd};
pub use random::{Recipe, random_pair};
pub use search::{Census, Found, Row, SeatCounts, search};
pub use searched::{Measured, Parity, PlaneSearched, Searched, SpaceSearched};
pub use smallest::{Find, Small, Smallest, smallest};
