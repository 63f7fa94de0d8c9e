//! The predicament tool.
fn main() {}
