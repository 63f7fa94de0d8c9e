//! Files that are whole or not there.

use std::ffi::OsString;
use std::fs;
use std::path::Path;

use crate::Error;

/// Writes a file beside its place and moves it there: a full disk leaves the old file, or none, never a half.
///
/// # Errors
/// That of the file system, with the file.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let mut beside = OsString::from(path);
    beside.push(".next");
    let beside = Path::new(&beside);
    let written = fs::write(beside, bytes).and_then(|()| fs::rename(beside, path));
    written.map_err(|error| {
        let _ = fs::remove_file(beside);
        Error::io(path)(error)
    })
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
        // In the place of a file there is a folder.
        let error = replace(folder.path(), b"x").unwrap_err();
        assert_eq!(error.path, folder.path());
        assert!(!folder.path().with_extension("next").exists());
    }
}
