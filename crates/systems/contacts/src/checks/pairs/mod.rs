//! The topology of contact sets: what must be true of registrations whatever
//! the points are.
//!
//! * [`crossings`]: two closed curves cross an even number of times, after
//!   they have been merged where they are in contact.
//! * [`piercings`]: a closed curve pierces a closed surface as often inwards
//!   as outwards.
//! * [`loose_ends`]: the intersection curves of two closed surfaces have none.
//! * [`boundaries`]: the boundary of a triangle pierces a closed surface an even number of times.
//! * [`clusters`], [`collapses`]: what merging does to the features themselves.
//!   These are no faults of the registrations; they are what they cost.
//!
//! # The crossing number after merging
//! Registrations say which features are one. A registered crossing of two
//! edges counts as one crossing, unless both pass through a common merged point:
//! two edges meet once. At a merged point, or along a chain of merged
//! points that both curves pass through, the curves cross if the second
//! changes sides of the first: if its arcs leave on different sides. Sides are
//! decided on the merged curves, edges bent through the points that they were
//! registered with, and those sitting where the [`Seat`] rule puts them.
//!
//! Both cases, and curves that pass through a point or along a chain more than
//! once, are counted in one way: the second curve is moved by (δ, δ²), for an
//! infinitesimal δ > 0, and then crosses the first transversally near what
//! they share. Around a common point the sectors of the first curve are left
//! as often as the cyclic order of the arcs says, and a moved chain stays on
//! the side that it was moved to until it has to change. Only pieces that have
//! a merged point in common are counted (the same, or two that an edge without
//! length joins): what happens elsewhere is no matter of
//! geometry, but of what was registered.
//!
//! Were *all* pairs of pieces counted, the sum would be even for any two closed
//! curves. So it is odd over the registered ones exactly if an odd number of
//! crossings is there without being registered, or registered without being
//! there: [`Crossings::unfaithful`] names them.

mod boundaries;
mod clusters;
mod crossings;
mod embedded;
mod loose_ends;
mod orient;
mod piercings;
mod seated;

pub use crate::answer::{Seat, Side};
pub use boundaries::{Boundaries, boundaries};
pub use clusters::{Cluster, Collapse, clusters, collapses};
pub use crossings::{Crossings, Unfaithful, crossings};
pub use embedded::is_embedded;
pub use loose_ends::{LooseEnd, LooseEnds, loose_ends};
pub use orient::{NotOriented, Oriented, oriented_curve, oriented_surface};
pub use piercings::{Piercings, piercings};
