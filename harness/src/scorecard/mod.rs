//! The scorecard of `selftest`: planted faults, the checks that have to find them, and what became of each.
//!
//! * [`declared`]: all checks that there are.
//! * [`entries`]: all faults, and the honest backends beside them.
//! * [`work`]: runs them on scenes.
//! * [`verdict`]: what is as it should be, also with a check switched off.
//! * [`page`]: tables of faults and of checks.
//! * [`shrunk`]: how small a scene can be that still shows a fault.

pub mod declared;
pub mod entries;
pub mod page;
pub mod shrunk;
pub mod verdict;
pub mod work;
