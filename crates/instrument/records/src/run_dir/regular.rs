//! Reading a folder's regular files.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use crate::Error;

/// The bytes of a regular file; other kinds are refused, as opening a pipe blocks and a device may never end.
pub(super) fn read_regular(path: &Path) -> Result<Vec<u8>, Error> {
    let metadata = fs::metadata(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => {
            Error::new(path, "there is no such file; restore it from a copy, start a new run, or name another folder")
        }
        _ => Error::io(path)(error),
    })?;
    if metadata.is_file() {
        fs::read(path).map_err(Error::io(path))
    } else {
        Err(Error::new(path, "it is not a regular file (a folder, a pipe or a device)"))
    }
}

/// The length in bytes of the header line, with its line end.
pub(super) fn header_length(bytes: &[u8]) -> u64 {
    bytes.iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |end| end + 1) as u64
}
