//! What the tests share.

pub mod liar;
