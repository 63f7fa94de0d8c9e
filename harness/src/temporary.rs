//! Temporary folders, removed when they are dropped.

use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};

/// A new folder for temporary files.
pub struct Temporary {
    pub path: PathBuf,
}

impl Temporary {
    /// Makes a folder whose name begins with this stem.
    pub fn new(stem: &str) -> std::io::Result<Temporary> {
        static COUNT: AtomicU64 = AtomicU64::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("{stem}-{}-{number}", std::process::id()));
        // An existing folder is an error: another program may have put links there.
        std::fs::create_dir(&path)?;
        Ok(Temporary { path })
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.path);
    }
}
