//! The lock of a run folder: one process writes it at a time.
//!
//! The system drops the lock with the process, however that ends, so a killed
//! run leaves no lock behind. The file stays: to remove it would let two
//! processes lock two files of one name.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::Path;

use crate::Error;
use crate::replace::is_beside;

/// The file that is locked.
pub(super) const FILE: &str = "run.lock";

/// A run folder that this process writes.
pub(super) struct Lock(#[allow(dead_code, reason = "held, not read: the lock goes with the file")] File);

impl Lock {
    /// Locks a folder.
    pub fn take(folder: &Path) -> Result<Lock, Error> {
        let path = folder.join(FILE);
        let file = OpenOptions::new().create(true).append(true).open(&path).map_err(Error::io(&path))?;
        match file.try_lock() {
            Ok(()) => {
                // It holds nothing; what somebody else has put there does not stay.
                file.set_len(0).map_err(Error::io(&path))?;
                Ok(Lock(file))
            }
            Err(TryLockError::WouldBlock) => {
                Err(Error::new(folder, "another process is writing this run; wait for its end, or stop it"))
            }
            Err(TryLockError::Error(error)) => Err(Error::no_locks(&path, error)),
        }
    }

    /// Whether a process is writing a folder; a folder without the file is written by nobody.
    pub fn is_taken(folder: &Path) -> Result<bool, Error> {
        let path = folder.join(FILE);
        let file = match File::open(&path) {
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(false),
            opened => opened.map_err(Error::io(&path))?,
        };
        match file.try_lock_shared() {
            Ok(()) => Ok(false),
            Err(TryLockError::WouldBlock) => Ok(true),
            // Where there are no locks nobody writes: no run begins there.
            Err(TryLockError::Error(error)) if error.kind() == std::io::ErrorKind::Unsupported => Ok(false),
            Err(TryLockError::Error(error)) => Err(Error::io(&path)(error)),
        }
    }

    /// Whether a folder holds anything but a lock, and the plan of a run that was ended while it was written.
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
