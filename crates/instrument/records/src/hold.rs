//! An exclusive lock for writers: of a file that is read, changed and written back, or of a folder whose files belong
//! together.
//!
//! A second writer waits for the first, and reads what the first has written. The system drops the lock when its
//! process ends, however it ends.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::Error;

/// The longest time that a second writer waits for the first.
const PATIENCE: Duration = Duration::from_secs(60);
/// The interval at which a waiting writer tries again.
const LOOK: Duration = Duration::from_millis(5);

/// The exclusive right to write a file or a folder, until it is dropped.
#[derive(Debug)]
pub struct Hold {
    lock: PathBuf,
    _file: File,
}

impl Hold {
    /// Waits for the exclusive right to write a file or a folder. `whose` describes this process to waiting
    /// processes.
    ///
    /// # Errors
    /// If the file system refuses, or another process holds the right for longer than a minute; the message names that
    /// process.
    pub fn take(place: &Path, whose: &str) -> Result<Hold, Error> {
        Hold::take_within(place, whose, PATIENCE)
    }

    fn take_within(place: &Path, whose: &str, patience: Duration) -> Result<Hold, Error> {
        let place = &fs::canonicalize(place).unwrap_or_else(|_| place.to_owned());
        let name = place.file_name().unwrap_or_default().to_string_lossy();
        let lock = place.with_file_name(format!(".{name}.lock"));
        let start = Instant::now();
        loop {
            let open = OpenOptions::new().create(true).append(true).read(true).open(&lock);
            let mut file = open.map_err(Error::io(&lock))?;
            match file.try_lock() {
                // The previous holder has removed the file: another file of its name may exist by now.
                Ok(()) if !is_still(&file, &lock) => continue,
                Ok(()) => {
                    let told = format!("process {} ({whose})", std::process::id());
                    file.set_len(0).and_then(|()| file.write_all(told.as_bytes())).map_err(Error::io(&lock))?;
                    return Ok(Hold { lock, _file: file });
                }
                Err(TryLockError::WouldBlock) if start.elapsed() < patience => std::thread::sleep(LOOK),
                Err(TryLockError::WouldBlock) => {
                    let mut told = String::new();
                    let _ = file.take(200).read_to_string(&mut told);
                    let told: String = told.chars().filter(|c| !c.is_control()).collect();
                    let who = if told.is_empty() { "another process".to_owned() } else { told };
                    return Err(Error::new(place, format!("{who} is writing it; wait for its end, or stop it")));
                }
                Err(TryLockError::Error(error)) => return Err(Error::no_locks(&lock, error)),
            }
        }
    }
}

impl Drop for Hold {
    fn drop(&mut self) {
        // Removed while it is held, so that the next process creates a new file. On other systems an open file can't be
        // removed.
        if cfg!(unix) {
            let _ = fs::remove_file(&self.lock);
        }
    }
}

/// True if the file of this name is the open one.
fn is_still(file: &File, path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let of = |found: fs::Metadata| (found.dev(), found.ino());
        let (open, named) = (file.metadata().map(of), fs::metadata(path).map(of));
        matches!((open, named), (Ok(open), Ok(named)) if open == named)
    }
    #[cfg(not(unix))]
    {
        let _ = (file, path);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_writers_lose_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("expected.toml");
        fs::write(&path, "").unwrap();
        std::thread::scope(|scope| {
            for writer in 0..10 {
                let path = &path;
                scope.spawn(move || {
                    for line in 0..10 {
                        let _hold = Hold::take(path, "a test").unwrap();
                        let text = fs::read_to_string(path).unwrap() + &format!("{writer} {line}\n");
                        crate::replace(path, text.as_bytes()).unwrap();
                    }
                });
            }
        });
        assert_eq!(fs::read_to_string(&path).unwrap().lines().count(), 100);
        assert!(cfg!(not(unix)) || fs::read_dir(folder.path()).unwrap().count() == 1, "no lock is left");
    }

    #[test]
    fn whoever_waits_too_long_is_told_for_whom() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mine.toml");
        let held = Hold::take(&path, "expect update").unwrap();
        let error = Hold::take_within(&path, "expect prune", Duration::ZERO).unwrap_err().to_string();
        let who = format!("mine.toml: process {} (expect update) is writing it; wait", std::process::id());
        assert!(error.contains(&who), "{error}");
        drop(held);
        Hold::take_within(&path, "expect prune", Duration::ZERO).unwrap();
    }
}
