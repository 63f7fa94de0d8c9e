//! The mark that a group of processes has in its environment.

use std::hash::{BuildHasher as _, RandomState};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// The variable whose value tells the processes of one group from all others.
pub(crate) const MARK: &str = "PREDICAMENT_ENGINE_PROCESS";

/// A value that no other group has, of this or another process.
pub(crate) fn mark() -> String {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    // The system's randomness: an earlier process may have had this number.
    let random = RandomState::new().hash_one(std::process::id());
    format!("{}-{random:016x}-{}", std::process::id(), NEXT.fetch_add(1, Relaxed))
}
