//! The judge: exact answers computed from definitions, with rationals only.
//!
//! Every backend is checked against this crate, so it shares no code with any of them: it depends on the vocabulary
//! ([`predicament_predicates`]) and on `rug`, and on nothing else of this workspace. It is slow and simple on purpose.
//! The crate `tasks` decides what a disagreement *means*; the crate `oracle` runs the scenes.
//!
//! * [`sign`], [`is_within`], [`verdict`], [`point`]: determinants and constructed points.
//! * [`Points`]: the same for one scene, with its constructed points cached.
//! * [`Judged`]: the same as a session, for algorithms that need predicates.
//! * [`boxes`]: which of many boxes are near a box.
//! * [`contacts`]: which simplices of two complexes meet.
//! * [`cubes`]: the measures of a union of cubes.
//! * [`hull`]: the extreme vertices of small scenes.
//! * [`interval`]: the cells of a line that a point is in.
//! * [`locate`]: the regions of a map that a point is in.
//! * [`nearest`]: the double nearest to a rational, for display and files.
//! * [`solids`]: the region of a mesh that a point is in.
//! * [`sum`]: sums of many rationals.
//! * [`Sample`]: the part of a large input that is judged.

pub mod boxes;
mod constructed;
pub mod contacts;
pub mod cubes;
mod determinant;
mod formula;
pub mod hull;
mod integers;
pub mod interval;
pub mod locate;
mod nearest;
mod points;
mod row;
mod sample;
mod session;
pub mod solids;
pub mod sum;
#[cfg(test)]
mod tests;

pub use constructed::point;
pub use determinant::{Verdict, determinant, is_within, log2_relative, rational, sign, verdict};
pub use formula::formula_value;
pub use nearest::nearest;
pub use points::Points;
pub use sample::Sample;
pub use session::{Judged, TieJudge};
