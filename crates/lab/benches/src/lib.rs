//! Compiles the benches in the folders `benches` of the other crates; this library is empty.
//!
//! A bench is stored beside the code that it times. It is a target of this package, so that no other crate depends on
//! Criterion or geo. With the feature `peers`, benches of whole algorithms run published peers on the same input in the
//! same run.
