//! The scorecard of `selftest`: planted faults, the checks that have to find them, and the results.
//!
//! * [`declared`]: all checks.
//! * [`entries`]: all faults, and the honest backends.
//! * [`work`]: runs them on scenes.
//! * [`verdict`]: verdicts, with all checks or with some switched off.
//! * [`page`]: tables of faults and of checks.
//! * [`shrunk`]: the size of the smallest scene that still shows a fault.

pub mod declared;
pub mod entries;
pub mod page;
pub mod shrunk;
pub mod verdict;
pub mod work;
