//! The topology of contact sets: laws of registrations that hold for any points.
//!
//! * [`crossings`]: two closed curves cross an even number of times after they have been merged at their contacts.
//! * [`piercings`]: a closed curve pierces a closed surface as often inwards as outwards.
//! * [`loose_ends`]: the intersection curves of two closed surfaces have no loose ends.
//! * [`boundaries`]: the boundary of a triangle pierces a closed surface an even number of times.
//! * [`clusters`], [`collapses`]: the effects of merging on the features themselves. These are not faults of the
//!   registrations, but their costs.
//!
//! # The crossing number after merging
//! Registrations identify features. A registered crossing of two edges counts as one crossing, unless both pass through
//! a common merged point: two edges meet once. Both curves can pass through a merged point, or along a chain of merged
//! points. There they cross if the second changes sides of the first, that is, if its arcs leave on different sides.
//! Sides are decided on the merged curves: edges are bent through the points that they were registered with, at the
//! locations that the [`Seat`] rule gives.
//!
//! Both cases, and curves that pass through a point or along a chain more than once, are counted in one way. The second
//! curve is moved by (δ, δ²), for an infinitesimal δ > 0, and then crosses the first transversally near their shared
//! parts. Around a common point the sectors of the first curve are left as often as the cyclic order of the arcs says.
//! A moved chain stays on the side that it was moved to until it has to change. Only pieces with a merged point in
//! common are counted (the same point, or two points that an edge without length joins): elsewhere the registrations
//! decide, not the geometry.
//!
//! If *all* pairs of pieces were counted, the sum would be even for any two closed curves. So the sum over the
//! registered ones is odd exactly if an odd number of crossings exist without registration or are registered without
//! existing: [`Crossings::unfaithful`] lists them.

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
