//! Points in the regions of a map, judged by the sectors of the plane around them.
//!
//! A map that tiles the plane puts every point in exactly one region. Real
//! maps have coasts, seas and mistakes, and a probe may lie exactly on a
//! border, where "which region" has no answer but a perturbed one. So the law
//! is taken from the map itself:
//!
//! 1. [`map_flaws`](crate::truth::map_flaws) finds where the map is no tiling: crossings, T-junctions,
//!    duplicate points, overlapping edges.
//! 2. [`surroundings`](crate::truth::surroundings) decides, exactly, which regions cover each *sector*
//!    around a probe: the parts into which the edges through the probe cut a
//!    small disc around it. Away from all edges there is one sector.
//! 3. [`tiling_report`] compares a session's answers with them.
//!
//! # The law
//! A perturbation smaller than every real distance moves a probe that lies on
//! edges into *one* of its sectors: at a sound probe the edges form a star
//! around one vertex, or a single edge runs through, and a perturbed star is
//! a star with the same sectors in the same order. So the regions answered
//! must be those of one sector. For land (every sector in exactly one region)
//! that means exactly one, for a coast at most one, for the open sea none.
//!
//! A closed-set answer may name regions B whose boundary the probe is on,
//! besides the regions I that it is inside of. It accounts for a sector with
//! the regions S iff I ⊆ S ⊆ I ∪ B, and some sector must be accounted for.
//! With B empty this is the law above.
//!
//! # Why a flaw elsewhere on the ray is no excuse
//! Each region's boundary is closed *by vertex identity*, and stays so under
//! any perturbation that moves vertices by identity. The crossing parity of a
//! closed curve, seen from a point that is not on it, is the same for every
//! ray, whatever the curve crosses or overlaps on the way; and each region is
//! counted by itself. A T-junction above a probe makes two regions disagree
//! about the points *at the junction*, not about the points below it. Only
//! where the probe lies on the flaw itself does the perturbation decide
//! whether it falls into the gap: such probes are [`Ground::Defect`](crate::truth::Ground::Defect), and no
//! law is read off them.

mod report;

pub use report::{Counts, Fault, TilingReport, TilingViolation, tiling_report};
