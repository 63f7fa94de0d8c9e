//! Files that are whole or not there.

use std::ffi::OsString;
use std::fs;
use std::io::Write as _;
use std::path::Path;

use crate::Error;

/// Writes a file beside its place and moves it there: a full disk leaves the old file, or none, never a half. A link
/// stays, and the file that it names is replaced, keeping its permissions; into a pipe or a device the bytes are written as they are.
///
/// # Errors
/// That of the file system, with the file.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let failed = |error| Error::io(path)(error);
    let mut permissions = None;
    let place = match fs::metadata(path) {
        Ok(found) if found.is_file() => {
            permissions = Some(found.permissions());
            fs::canonicalize(path).map_err(failed)?
        }
        Ok(found) if found.is_dir() => return Err(Error::new(path, "it is a folder; name a file")),
        Ok(_) => {
            let mut special = fs::OpenOptions::new().write(true).open(path).map_err(failed)?;
            return special.write_all(bytes).and_then(|()| special.flush()).map_err(failed);
        }
        Err(_) => path.to_owned(),
    };
    let mut beside = OsString::from(&place);
    beside.push(".next");
    let beside = Path::new(&beside);
    let written = fs::write(beside, bytes)
        .and_then(|()| permissions.map_or(Ok(()), |permissions| fs::set_permissions(beside, permissions)))
        .and_then(|()| fs::rename(beside, &place));
    written.map_err(|error| {
        let _ = fs::remove_file(beside);
        failed(error)
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
    }
}
