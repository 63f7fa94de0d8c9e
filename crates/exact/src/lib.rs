//! The exact backend: a floating-point filter, then exact evaluation ending in rationals.
