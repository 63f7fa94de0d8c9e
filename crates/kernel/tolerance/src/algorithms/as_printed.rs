//! Algorithms 3 and 8 as the paper prints them, with û = A − B.
//!
//! Then â/m is minus the weight: vertices with their foot on the edge are rejected, and vertices beside its mirror
//! image at A are registered. Algorithms above must then not rely on "no degeneracy was registered". The printed form
//! is kept so that a harness can show that it detects the error.

use predicament_error_calculus::vector::minus;

use super::{plane, space};
use crate::quantities::edge;
use crate::{Float, Tolerances2d, Tolerances3d};

/// Algorithm 3 as printed.
#[must_use]
pub fn edge_vertex2d<F: Float>(tolerances: &Tolerances2d<F>, [a, b]: &[[F; 2]; 2], p: &[F; 2]) -> Option<F> {
    plane::from_edge(tolerances, edge(b, a), &minus(p, a))
}

/// Algorithm 8 as printed.
#[must_use]
pub fn edge_vertex3d<F: Float>(tolerances: &Tolerances3d<F>, [a, b]: &[[F; 3]; 2], p: &[F; 3]) -> Option<F> {
    space::from_edge(tolerances, edge(b, a), &minus(p, a))
}
