//! The study of resolution: how small a feature can be before tolerances lose it.
//!
//! A scheme that registers near simplices as degenerate can't distinguish small features. On paper the tolerances
//! determine the smallest size. Here the answers of the whole hierarchy determine it, for features of a known size in
//! any position. The size is in units of L, the length that all tolerances are proportional to.
//!
//! * [`Resolution`]: the study.
//! * [`FEATURES`]: the features, each with one size.
//! * [`survey`]: the share of each size that survives.
//! * [`location`]: the distance between a shallow crossing and its registration.

mod features;
mod location;
mod plots;
mod pose;
mod study;
mod survey;
mod table;

pub use features::{FEATURES, Feature};
pub use location::{Location, location};
pub use study::{Resolution, Resolved};
pub use survey::{Survey, survey};

use predicament_contacts::algorithm::pairs::Contacts;
use predicament_mesh::Complex;
use predicament_predicates::{Dimension, Scene};
use predicament_tasks::AnswerError;
use predicament_tolerance::{Tolerances2d, Tolerances3d};

/// A function that queries a backend for the contacts of two complexes, or returns the reason why it declines.
pub type Ask<'a> = dyn Fn(&Scene, &Complex, &Complex) -> Result<Contacts, AnswerError> + Sync + 'a;

/// The lengths La and Lb of every scene here: L is hardly more than their sum, which is 1.
///
/// The primitives themselves are at most this large, in any rotation.
const LENGTHS: [f64; 2] = [0.5, 0.5];

/// The L of a backend for these scenes.
///
/// It is the L of the paper's tolerances in the backend's precision, and 1 for backends without tolerances.
#[must_use]
pub fn length(backend: &str, dimension: Dimension) -> f64 {
    let [la, lb] = LENGTHS;
    match (backend, dimension) {
        ("tolerance", Dimension::Two) => Tolerances2d::from_lengths(la, lb).length,
        ("tolerance", Dimension::Three) => Tolerances3d::from_lengths(la, lb).length,
        ("tolerance:f32", Dimension::Two) => Tolerances2d::<f32>::from_lengths(0.5, 0.5).length.into(),
        ("tolerance:f32", Dimension::Three) => Tolerances3d::<f32>::from_lengths(0.5, 0.5).length.into(),
        _ => la + lb,
    }
}
