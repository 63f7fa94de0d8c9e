//! The tolerance backend (Wang, Jiang, Schroeder & Teran, *Robust Intersections
//! under Floating Point*).
//!
//! Its philosophy: don't decide what floating point can't see. A determinant
//! within a tolerance T of zero is registered as degenerate; beyond it the
//! computed sign is right. Each T comes with T₋ < T < T₊ such that everything
//! up to T₋ *is* registered and nothing beyond T₊ ever is; that is the promise
//! the backend is held to.
//!
//! * [`Tolerances2d`] and [`Tolerances3d`]: the paper's Figures 1 and 5, made
//!   from lengths by its Algorithms 1 and 6.
//! * [`quantities`]: what is compared with them, over any number.
//! * [`circles`]: bands for `incircle` and `insphere`, which are ours.
//! * [`bounds`]: every bound and constraint of the paper, derived and decided.
//! * [`Tolerance`]: the backend.
//!
//! # Which ε
//! The paper's ε is the machine epsilon, and so is the one here:
//! ε = 2⁻⁵² ([`f64::EPSILON`]), the distance from 1 to the next double. Its
//! roots are exact: √ε = 2⁻²⁶, ε^¼ = 2⁻¹³. With the unit roundoff u = ε/2
//! instead everything would hold as well, with half the room to spare in use.

mod backend;
pub mod bounds;
pub mod circles;
mod extent;
pub mod quantities;
mod tolerances2d;
mod tolerances3d;

pub use backend::{Session, Tolerance};
pub use tolerances2d::Tolerances2d;
pub use tolerances3d::Tolerances3d;

use predicament_predicates::Band;

/// A band from its three coefficients and the unit that they share.
fn band([lower, width, upper]: [f64; 3], unit: f64) -> Band {
    Band { lower: lower * unit, width: width * unit, upper: upper * unit }
}

/// Whether a band is what its formula says: neither infinite nor NaN, and
/// nothing of it lost to underflow.
fn is_sound(band: Band) -> bool {
    [band.lower, band.width, band.upper].into_iter().all(f64::is_normal)
}
