//! Benches only, in the folder `benches`; this library is empty.
//!
//! With the feature `peers`, benches of whole algorithms run published peers on the same input in the same run.
