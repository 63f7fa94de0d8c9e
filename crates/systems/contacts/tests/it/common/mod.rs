//! Code that the tests share.

pub mod faces;
pub mod hierarchy;
pub mod whim;
