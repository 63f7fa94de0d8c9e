//! The judge: exact answers computed from definitions, with rationals only.
//!
//! Every backend is checked against this crate, so it shares no code with any of them: it depends on the vocabulary
//! ([`predicament_predicates`]) and on libraries of numbers, and on nothing else of this workspace. It is slow and
//! simple on purpose. The crate `tasks` decides what a disagreement *means*; the crate `oracle` runs the scenes.
//!
//! * [`sign`], [`is_within`], [`verdict`], [`point`]: determinants and constructed points.
//! * [`Points`]: the same for one scene, with its constructed points cached.
//! * [`Decimals`]: the same about the decimals that were written, instead of their doubles.
//! * [`Judged`]: the same as a session, for algorithms that need predicates.
//! * [`boxes`]: which of many boxes are near a box.
//! * [`contacts`]: which simplices of two complexes meet.
//! * [`cubes`]: the measures of a union of cubes.
//! * [`hull`]: the extreme vertices of small scenes.
//! * [`interval`]: the cells of a line that a point is in.
//! * [`locate`]: the regions of a map that a point is in.
//! * [`nearest`]: the double nearest to a rational, for display and files.
//! * [`skin`]: surfaces of triangles in doubles, of other programs.
//! * [`solids`]: the region of a mesh that a point is in.
//! * [`sum`]: sums of many rationals.
//! * [`Sample`]: the part of a large input that is judged.
//! * [`portable`]: signs by a second library of integers, for programs that cannot afford GMP.
//!
//! All but [`portable`] needs GMP and is behind the feature `gmp`, which is on by default.

#[cfg(feature = "gmp")]
pub mod boxes;
#[cfg(feature = "gmp")]
mod constructed;
#[cfg(feature = "gmp")]
pub mod contacts;
#[cfg(feature = "gmp")]
pub mod cubes;
#[cfg(feature = "gmp")]
mod decimals;
#[cfg(feature = "gmp")]
mod determinant;
#[cfg(feature = "gmp")]
mod formula;
#[cfg(feature = "gmp")]
pub mod hull;
#[cfg(feature = "gmp")]
mod integers;
#[cfg(feature = "gmp")]
pub mod interval;
#[cfg(feature = "gmp")]
pub mod locate;
#[cfg(feature = "gmp")]
mod nearest;
#[cfg(feature = "gmp")]
mod points;
pub mod portable;
#[cfg(feature = "gmp")]
mod row;
#[cfg(feature = "gmp")]
mod sample;
#[cfg(feature = "gmp")]
mod session;
#[cfg(feature = "gmp")]
mod short;
#[cfg(feature = "gmp")]
pub mod skin;
#[cfg(feature = "gmp")]
pub mod solids;
mod split;
#[cfg(feature = "gmp")]
pub mod sum;
#[cfg(all(test, feature = "gmp"))]
mod tests;

#[cfg(feature = "gmp")]
pub use constructed::point;
#[cfg(feature = "gmp")]
pub use decimals::Decimals;
#[cfg(feature = "gmp")]
pub use determinant::{Verdict, determinant, is_within, log2_relative, rational, sign, verdict};
#[cfg(feature = "gmp")]
pub use formula::formula_value;
#[cfg(feature = "gmp")]
pub use nearest::nearest;
#[cfg(feature = "gmp")]
pub use points::Points;
#[cfg(feature = "gmp")]
pub use sample::Sample;
#[cfg(feature = "gmp")]
pub use session::{Judged, TieJudge};
