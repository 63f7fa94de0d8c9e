//! Broad phases.
