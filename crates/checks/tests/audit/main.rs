//! Contacts held to exact distances: the tolerance paper's algorithms at their
//! thresholds, and whole sets of contacts.

mod algorithms;
mod oracle;
mod sets;
mod thresholds;
