//! Code that the tests share.

pub mod liar;
