//! Tests of the checks: right predicates conform, planted faults are found, and each check is needed.

mod exact;
mod faults;
mod indirect;
mod peers;
mod types;
