//! What must hold for contacts.
//!
//! * [`pairs`]: registered pairs, and the curves and surfaces that they merge.
//! * [`audit`]: contacts held to exact distances.

pub mod audit;
pub mod pairs;
