//! The lock of a run folder: one process writes it at a time.
//!
//! The system drops the lock when its process ends, however it ends, so a killed run does not leave a lock. The file
//! stays: if it were removed, two processes could lock two files of one name.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::Path;

use crate::Error;
use crate::replace::is_beside;

/// The name of the locked file.
pub(super) const FILE: &str = "run.lock";

/// The lock of a run folder, held by this process.
pub(super) struct Lock(#[allow(dead_code, reason = "held, not read: the lock goes with the file")] File);

impl Lock {
    /// Locks a folder.
    pub fn take(folder: &Path) -> Result<Lock, Error> {
        let path = folder.join(FILE);
        let file = OpenOptions::new().create(true).append(true).open(&path).map_err(Error::io(&path))?;
        match file.try_lock() {
            Ok(()) => {
                // The file is kept empty; foreign content is removed.
                file.set_len(0).map_err(Error::io(&path))?;
                Ok(Lock(file))
            }
            Err(TryLockError::WouldBlock) => {
                Err(Error::new(folder, "another process is writing this run; wait for its end, or stop it"))
            }
            Err(TryLockError::Error(error)) => Err(Error::no_locks(&path, error)),
        }
    }

    /// True if a process is writing the folder; false if the folder has no lock file.
    pub fn is_taken(folder: &Path) -> Result<bool, Error> {
        let path = folder.join(FILE);
        let file = match File::open(&path) {
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(false),
            opened => opened.map_err(Error::io(&path))?,
        };
        match file.try_lock_shared() {
            Ok(()) => Ok(false),
            Err(TryLockError::WouldBlock) => Ok(true),
            // Without support for locks, runs do not start, so nobody writes.
            Err(TryLockError::Error(error)) if error.kind() == std::io::ErrorKind::Unsupported => Ok(false),
            Err(TryLockError::Error(error)) => Err(Error::io(&path)(error)),
        }
    }

    /// True if a folder holds more than a lock and a partly written plan of a run that was ended early.
    pub fn others(folder: &Path) -> Result<bool, Error> {
        for entry in fs::read_dir(folder).map_err(Error::io(folder))? {
            let name = entry.map_err(Error::io(folder))?.file_name();
            if name != FILE && !is_beside(&name.to_string_lossy()) {
                return Ok(true);
            }
        }
        Ok(false)
    }
}
