//! Families of queries: points at which predicates err, generated from a name, parameters and a seed.
//!
//! The same family, predicate, parameters and seed give the same bits on every platform: ChaCha8 is seeded with a hash
//! of them, and coordinates come from integer arithmetic, + − · / and square roots only, which IEEE 754 rounds the same
//! everywhere.
//!
//! The crate reads no file, computes no truth, and needs few other crates, so that tests of other people's predicates
//! can afford it (the crate `conformance`). The crate `tasks` makes the same queries for the `[[generate]]` tables
//! of suites. Predicates from formulas have families of their own there.
//!
//! * [`Random`]: streams of random numbers. [`bits`]: doubles by their bits.
//! * [`uniform`], [`grid`], [`near`], [`midpoint`], [`kettner`], [`degenerate`], [`decimal`], [`wide_scaled`],
//!   [`wide_mixed`], [`far`]: one query at a time.
//! * [`Typed`]: one query of decimals as people write them, or boxes that share sides, as integers over a power of ten.
//! * [`Directions`]: one query of directions on the unit sphere.
//! * [`scattered`], [`band`], [`PixelMap`], [`Arrangement`]: a whole scene, as a [`Cloud`].
//! * [`place`]: the map from a family's plane to the plane of the question.

mod band;
pub mod bits;
mod constructed;
mod decimals;
mod degenerate;
mod far;
mod kettner;
mod near;
mod pixels;
mod plain;
mod random;
mod scattered;
mod shape;
mod sphere;
mod wide;

pub use band::band;
pub use constructed::{Arrangement, Kind, Trouble};
pub use decimals::{Figure, MOST_DIGITS, Neighbours, Place, Typed};
pub use degenerate::{decimal, scaled as degenerate};
pub use far::far;
pub use kettner::kettner;
pub use near::{midpoint, near};
pub use pixels::{PixelError, PixelMap, SIDE, STEP};
pub use plain::{grid, uniform};
pub use random::Random;
pub use scattered::{POINTS as SCATTERED_POINTS, scattered};
pub use shape::place;
pub use sphere::Directions;
pub use wide::{Ordinary, mixed as wide_mixed, scaled as wide_scaled, scaled_by as wide_scaled_by};

use predicament_predicates::{Construction, PredicateKind, Vertex};

/// Points, constructions from them, and the queries unless these are consecutive tuples.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Cloud {
    /// The coordinates, point after point.
    pub coordinates: Vec<f64>,
    /// The vertices of all queries, one query after the other; `None` for consecutive tuples of points.
    pub args: Option<Vec<Vertex>>,
    /// The definitions of the constructed vertices.
    pub constructions: Vec<Construction>,
}

/// The number of coordinates of a point that a family makes for a predicate.
#[must_use]
pub fn native(kind: PredicateKind) -> usize {
    match kind {
        PredicateKind::Compare | PredicateKind::Orient2d | PredicateKind::Incircle => 2,
        PredicateKind::Orient3d | PredicateKind::Insphere => 3,
        PredicateKind::Derived(derived) => derived.dimension().count() + usize::from(derived.is_weighted()),
    }
}
