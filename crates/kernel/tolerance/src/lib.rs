//! The tolerance backend (Wang, Jiang, Schroeder & Teran, *Robust Intersections under Floating Point*).
//!
//! Floating point decides only what it can. A determinant within a tolerance T of zero is registered as degenerate;
//! beyond it the computed sign is right. Each T comes with T₋ < T < T₊ such that everything up to T₋ *is* registered
//! and nothing beyond T₊ ever is. The harness checks this promise.
//!
//! * [`Tolerances2d`] and [`Tolerances3d`]: the paper's Figures 1 and 5, made from lengths by its Algorithms 1 and 6.
//! * [`quantities`]: the quantities that the tolerances are compared with, over any number type.
//! * [`algorithms`]: Algorithms 2 to 5 and 7 to 12, over any [`Float`].
//! * [`circles`]: bands for circles and spheres, which are ours.
//! * [`bounds`]: every bound and constraint of the paper, derived and decided.
//! * [`struct@Tolerance`]: the backend; [`Misscaled`]: planted faults of its tolerances.
//!
//! # Which ε
//! The paper's ε is the machine epsilon, and so is the one here: the distance from 1 to the next number, 2⁻⁵² for `f64`
//! ([`f64::EPSILON`]), 2⁻²³ for `f32`. The roots of the former are exact: √ε = 2⁻²⁶, ε^¼ = 2⁻¹³. With the unit roundoff
//! u = ε/2 instead everything would hold as well, with half the slack in use. Formats with ε ≥ 10⁻⁵ are refused.

pub mod algorithms;
mod backend;
mod band;
pub mod bounds;
pub mod circles;
mod contacts;
pub mod derived;
mod extent;
mod float;
mod planted;
pub mod quantities;
mod session;
mod shift;
mod tolerances2d;
mod tolerances3d;

pub use backend::Tolerance;
pub use contacts::ContactTolerances;
pub use float::Float;
pub use planted::Misscaled;
pub use session::Session;
pub use tolerances2d::Tolerances2d;
pub use tolerances3d::Tolerances3d;
