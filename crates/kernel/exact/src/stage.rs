//! The rungs of the ladder, as the indices of [`Backend::stages`](predicament_predicates::Backend::stages).

/// The comparison of two coordinates.
pub const COMPARE: usize = 0;
/// Plain floating point that makes no error.
pub const DOUBLE: usize = 1;
/// Plain floating point and one error bound for the whole scene.
pub const STATIC: usize = 2;
/// Plain floating point and an error bound for this query.
pub const SEMI_STATIC: usize = 3;
/// Integers of a fixed size, with differences of one limb.
pub const INTEGER: usize = 4;
/// Integers of a fixed size, with differences of two limbs.
pub const WIDE_INTEGER: usize = 5;
/// Exact dyadic numbers: limbs times a power of two.
pub const DYADIC: usize = 6;
/// The names of the stages, in this order.
pub const NAMES: [&str; 7] =
    ["compare", "double", "static filter", "semi-static filter", "integer", "wide integer", "dyadic"];
