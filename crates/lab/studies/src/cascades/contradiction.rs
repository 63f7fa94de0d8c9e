//! The rules that steps of a cascade rely on.

use predicament_predicates::contradiction;

contradiction! {
    /// A rule that a step of a cascade breaks.
    pub enum Contradiction {
        Unsettled: "thick primitives settle", "thick primitives do not settle";
    }
    or {
        /// The arrangement, or a result of it, contradicts itself.
        Arrangement(predicament_overlay::algorithm::overlay::Contradiction);
    }
}
