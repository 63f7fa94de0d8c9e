//! The mark in the environment of a process group.

use std::hash::{BuildHasher as _, RandomState};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// The environment variable whose value identifies the processes of one group.
pub(crate) const MARK: &str = "PREDICAMENT_ENGINE_PROCESS";

/// A new value that no other group has, in this or another process.
pub(crate) fn mark() -> String {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    // The system's randomness is needed because an earlier process may have had this id.
    let random = RandomState::new().hash_one(std::process::id());
    format!("{}-{random:016x}-{}", std::process::id(), NEXT.fetch_add(1, Relaxed))
}
