//! Judging of points in the regions of a map, by the sectors of the plane around them.
//!
//! A map that tiles the plane puts every point in exactly one region. Real maps have coasts, seas and mistakes, and a
//! probe may lie exactly on a border, where only a perturbation puts it into one region. So the law comes from the map
//! itself:
//!
//! 1. [`map_flaws`](crate::truth::map_flaws) finds where the map is not a tiling: crossings, T-junctions, duplicate
//!    points, overlapping edges.
//! 2. [`surroundings`](crate::truth::surroundings) decides, exactly, which regions cover each *sector* around a probe:
//!    the parts into which the edges through the probe cut a small disc around it. Away from all edges there is one
//!    sector.
//! 3. [`tiling_report`] compares a session's answers with them.
//!
//! # The law
//! A perturbation smaller than every real distance moves a probe that lies on edges into *one* of its sectors. At a
//! sound probe the edges form a star around one vertex, or a single edge runs through; a perturbed star is a star with
//! the same sectors in the same order. So the regions answered must be those of one sector. For land (every sector in
//! exactly one region) that means exactly one region, for a coast at most one, for the open sea none.
//!
//! A closed-set answer may name regions B whose boundary contains the probe, besides the regions I that contain it. It
//! accounts for a sector with the regions S iff I ⊆ S ⊆ I ∪ B, and it must account for some sector. With B empty this
//! is the law above.
//!
//! # Why a flaw elsewhere on the ray is no excuse
//! Each region's boundary is closed *by vertex identity*, and stays so under any perturbation that moves vertices by
//! identity. The crossing parity of a closed curve, seen from a point that is not on it, is the same for every ray,
//! whatever the curve crosses or overlaps on the way; and each region is counted by itself. A T-junction above a probe
//! makes two regions disagree about the points *at the junction*, not about the points below it. Only if the probe lies
//! on the flaw itself does the perturbation decide if it falls into the gap. Such probes are
//! [`Ground::Defect`](crate::truth::Ground::Defect), and the law does not apply to them.

mod report;

pub use report::{Counts, Fault, TilingReport, TilingViolation, tiling_report};
