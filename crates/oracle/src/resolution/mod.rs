//! What tolerances cost in resolution, measured.
//!
//! A scheme that registers what is close as degenerate can't tell small
//! features apart. How small is a matter of its tolerances on paper; here it is
//! a matter of what the whole hierarchy answers about features of a known size,
//! in any position. The size is in units of L, the length that all tolerances
//! are proportional to.
//!
//! * [`FEATURES`]: the features, each with one size.
//! * [`survey`]: how many of each size survive.
//! * [`location`]: how far from the crossing a shallow crossing is registered.

mod features;
mod location;
mod pose;
mod survey;

pub use features::{FEATURES, Feature};
pub use location::{Location, location};
pub use pose::Precision;
pub use survey::{Survey, survey};

use predicament_algorithms::contacts::Contacts;
use predicament_mesh::Complex;
use predicament_predicates::Scene;

/// Asks a backend for the contacts of two complexes; the reason where it declines.
pub type Ask<'a> = dyn Fn(&Scene, &Complex, &Complex) -> Result<Contacts, String> + Sync + 'a;

/// La and Lb of every scene here: L is hardly more than their sum, which is 1.
/// (The primitives themselves are no larger, whatever way they are turned.)
const LENGTHS: [f64; 2] = [0.5, 0.5];
