//! Atomic replacement of files: a file is complete or absent.
//!
//! A file is written beside its place under a unique name, and moved to its place when the disk has all of it. After a
//! full disk, a power cut or a race with a second writer, the old file or a complete new one is there, never a part of
//! one.

use std::collections::BTreeSet;
use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, NamedTempFile};

use crate::Error;

/// The end of the name of a file under construction. Such a name is a dot, the final name, a unique text and this
/// ending.
const ENDING: &str = ".next";

/// The files under construction of this process.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes the files under construction of this process, which is about to end. Afterwards other threads wait forever
/// if they begin or keep a file.
pub fn abandon_files() {
    let unfinished = unfinished();
    for path in unfinished.iter() {
        // A file that can't be removed is hidden, and the next writer of its folder removes it.
        let _ = fs::remove_file(path);
    }
    std::mem::forget(unfinished);
}

/// The entry of a file in the list of files under construction.
#[derive(Debug)]
struct Entry(PathBuf);

impl Drop for Entry {
    fn drop(&mut self) {
        unfinished().remove(&self.0);
    }
}

/// A file under construction beside its place. It is removed unless it is kept.
#[derive(Debug)]
pub struct Beside {
    file: NamedTempFile,
    place: PathBuf,
    permissions: Option<Permissions>,
    /// Dropped after the file.
    entry: Entry,
}

impl Beside {
    /// An empty file for this place.
    ///
    /// A link in this place stays: the file that it points to is replaced and keeps its permissions. Files that killed
    /// processes have left in the folder are removed.
    ///
    /// # Errors
    /// If the file system refuses, or a folder is in the place of the file; the error names the file.
    pub fn new(place: &Path) -> Result<Beside, Error> {
        let failed = |error| Error::io(place)(error);
        let (place, permissions) = match fs::metadata(place) {
            Ok(found) if found.is_dir() => return Err(Error::new(place, "it is a folder; name a file")),
            Ok(found) => (fs::canonicalize(place).map_err(failed)?, Some(found.permissions())),
            Err(_) => (place.to_owned(), None),
        };
        let folder = folder_of(&place);
        sweep(folder);
        let name = place.file_name().unwrap_or_default().to_string_lossy();
        let prefix = format!(".{name}.");
        let mut builder = Builder::new();
        builder.prefix(&prefix).suffix(ENDING);
        // As for any new file, the user's umask limits the permissions.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut unfinished = unfinished();
        let file = builder.tempfile_in(folder).map_err(failed)?;
        let entry = Entry(file.path().to_owned());
        unfinished.insert(entry.0.clone());
        drop(unfinished);
        // The lock tells a sweeping process that the file is in use. Where locks are not supported, sweeping is
        // skipped.
        let _ = file.as_file().lock();
        Ok(Beside { file, place, permissions, entry })
    }

    /// The file, for writing.
    #[must_use]
    pub fn file(&self) -> &File {
        self.file.as_file()
    }

    /// The number of bytes written.
    ///
    /// # Errors
    /// If the file system refuses.
    pub fn length(&self) -> Result<u64, Error> {
        Ok(self.file().metadata().map_err(Error::io(&self.place))?.len())
    }

    /// Moves files into their places when the disk has all of each.
    ///
    /// # Errors
    /// If the file system refuses one of the files; the error names it, and files before it may be in their places.
    pub fn keep(files: Vec<Beside>) -> Result<(), Error> {
        for Beside { file, place, permissions, .. } in &files {
            let file = file.as_file();
            permissions.clone().map_or(Ok(()), |of| file.set_permissions(of)).map_err(Error::io(place))?;
            file.sync_data().map_err(Error::io(place))?;
        }
        let mut folders = BTreeSet::new();
        for Beside { file, place, entry, .. } in files {
            let moved = {
                let _unfinished = unfinished();
                file.persist(&place)
            };
            moved.map_err(|error| Error::io(&place)(error.error))?;
            drop(entry);
            folders.insert(folder_of(&place).to_owned());
        }
        folders.iter().try_for_each(|folder| sync_folder(folder))
    }
}

/// Writes a file beside its place and moves it there. A pipe or a device gets the bytes directly.
///
/// # Errors
/// If the file system refuses; the error names the file.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let failed = |error| Error::io(path)(error);
    if fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir()) {
        let mut special = fs::OpenOptions::new().write(true).open(path).map_err(failed)?;
        return special.write_all(bytes).and_then(|()| special.flush()).map_err(failed);
    }
    let beside = Beside::new(path)?;
    beside.file().write_all(bytes).map_err(failed)?;
    Beside::keep(vec![beside])
}

/// Makes a folder and its missing parents, and asks the disk to keep each.
///
/// # Errors
/// If the file system refuses; the error names the folder that was asked for.
pub fn make_folder(folder: &Path) -> Result<(), Error> {
    let missing: Vec<&Path> =
        folder.ancestors().take_while(|above| !above.as_os_str().is_empty() && !above.exists()).collect();
    fs::create_dir_all(folder).map_err(Error::io(folder))?;
    missing.iter().try_for_each(|made| sync_folder(folder_of(made)))
}

/// Asks the disk to keep the names in a folder. Does nothing where folders can't be opened.
///
/// # Errors
/// If the file system refuses.
pub(crate) fn sync_folder(folder: &Path) -> Result<(), Error> {
    match File::open(folder).and_then(|opened| opened.sync_all()) {
        // File systems without this operation return one of these errors.
        Err(error)
            if matches!(
                error.kind(),
                io::ErrorKind::InvalidInput | io::ErrorKind::Unsupported | io::ErrorKind::PermissionDenied
            ) =>
        {
            Ok(())
        }
        done => done.map_err(Error::io(folder)),
    }
}

/// True if the name is that of a file under construction.
pub(crate) fn is_beside(name: &str) -> bool {
    name.starts_with('.') && name.ends_with(ENDING)
}

/// Removes all files under construction that the previous holder of the folder's lock has left.
pub(crate) fn sweep_all(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if is_beside(&entry.file_name().to_string_lossy()) {
            // A file that can't be removed does no harm.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// The folder that contains a file or folder.
pub(crate) fn folder_of(place: &Path) -> &Path {
    place.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Removes the files under construction that ended processes have left in a folder: files that are not locked. Empty
/// files are kept, as their writer may be about to lock them.
fn sweep(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if is_beside(&entry.file_name().to_string_lossy())
            && fs::symlink_metadata(&path).is_ok_and(|found| found.is_file() && found.len() > 0)
            && File::open(&path).is_ok_and(|file| file.try_lock().is_ok())
        {
            // A file that can't be removed does no harm.
            let _ = fs::remove_file(&path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_and_nothing_is_left_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("page.md");
        for text in ["old", "new"] {
            replace(&path, text.as_bytes()).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), text);
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        // A folder is in the place of the file.
        let error = replace(folder.path(), b"x").unwrap_err();
        assert_eq!(error.path, folder.path());
    }

    #[test]
    fn what_was_left_is_swept_and_what_is_written_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let [left, new, held] = [".a.1.next", ".a.2.next", ".a.3.next"].map(|name| folder.path().join(name));
        let [_, _, writer] = [&left, &new, &held].map(|path| File::create(path).unwrap());
        writer.lock().unwrap();
        for path in [&left, &held] {
            fs::write(path, "half").unwrap();
        }
        replace(&folder.path().join("a"), b"x").unwrap();
        assert_eq!([left, new, held].map(|path| path.exists()), [false, true, true]);
    }

    #[test]
    fn ten_writers_leave_one_whole_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("junit.xml");
        let text = |writer: u8| vec![b'0' + writer; 100_000];
        std::thread::scope(|scope| {
            for writer in 0..10 {
                let path = &path;
                scope.spawn(move || (0..20).for_each(|_| replace(path, &text(writer)).unwrap()));
            }
        });
        let found = fs::read(&path).unwrap();
        assert!((0..10).any(|writer| found == text(writer)));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    #[cfg(unix)]
    fn links_and_devices_stay_what_they_are() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let [real, link] = ["real.xml", "link.xml"].map(|name| folder.path().join(name));
        fs::write(&real, "old").unwrap();
        std::os::unix::fs::symlink(&real, &link).unwrap();
        fs::set_permissions(&real, fs::Permissions::from_mode(0o600)).unwrap();
        replace(&link, b"new").unwrap();
        assert_eq!(fs::metadata(&real).unwrap().permissions().mode() & 0o777, 0o600);
        assert_eq!(fs::read_to_string(&real).unwrap(), "new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        replace(Path::new("/dev/null"), b"nothing").unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
        let full = Path::new("/dev/full");
        assert!(!full.exists() || replace(full, b"lost").is_err(), "a full device is an error");
        // A file beside a place may be anybody's: a link there is not followed.
        let (mine, trap) = (folder.path().join("mine"), folder.path().join("page.next"));
        fs::write(&mine, "mine").unwrap();
        std::os::unix::fs::symlink(&mine, &trap).unwrap();
        replace(&folder.path().join("page"), b"page").unwrap();
        assert_eq!(fs::read_to_string(&mine).unwrap(), "mine");
    }
}
