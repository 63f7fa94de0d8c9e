//! A file for appending, with the SHA-256 of its whole content.
//!
//! Each commit of a run records the length and the digest of every table. Reading a table again for each commit would
//! cost more than the run, so the digest grows with the file. It is finished once for each content: most commits leave
//! most tables as they were.

use std::cell::{Cell, RefCell};
use std::fs::File;
use std::io::{self, Write};

use sha2::{Digest, Sha256};

/// The SHA-256 of bytes in hex digits.
pub(super) fn digest(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes))
}

/// Bytes in hex digits.
pub(super) fn hex(bytes: &[u8]) -> String {
    let digit = |half: u8| char::from_digit(u32::from(half), 16).expect("four bits");
    bytes.iter().flat_map(|byte| [digit(byte >> 4), digit(byte & 15)]).collect()
}

/// A file with the digest of its bytes.
pub(super) struct Hashed {
    file: File,
    so_far: RefCell<(Sha256, u64)>,
    /// The last digest, and the number of bytes that it is of.
    finished: RefCell<Option<(String, u64)>>,
    /// The number of bytes that the disk has.
    synced: Cell<u64>,
}

impl Hashed {
    /// An empty file.
    pub fn new(file: File) -> Hashed {
        Hashed::after(file, &[])
    }

    /// A file with these bytes, opened for appending.
    pub fn after(file: File, bytes: &[u8]) -> Hashed {
        let so_far = RefCell::new((Sha256::new_with_prefix(bytes), bytes.len() as u64));
        Hashed { file, so_far, finished: RefCell::default(), synced: Cell::new(0) }
    }

    /// The number of bytes in the file.
    pub fn length(&self) -> u64 {
        self.so_far.borrow().1
    }

    /// The SHA-256 of the file in hex digits.
    pub fn digest(&self) -> String {
        let (so_far, length) = &*self.so_far.borrow();
        let mut finished = self.finished.borrow_mut();
        match &*finished {
            Some((digest, of)) if of == length => digest.clone(),
            _ => finished.insert((hex(&so_far.clone().finalize()), *length)).0.clone(),
        }
    }

    /// Asks the disk to keep the file, unless the disk already has all of it.
    pub fn sync(&self) -> io::Result<()> {
        if self.synced.get() != self.length() {
            self.file.sync_data()?;
            self.synced.set(self.length());
        }
        Ok(())
    }

    /// Cuts the file to this length. The digest and the length stay those of the uncut file.
    pub fn cut(&self, length: u64) -> io::Result<()> {
        self.file.set_len(length)?;
        self.file.sync_data()
    }

    /// Appends all of these bytes.
    pub fn append(&self, bytes: &[u8]) -> io::Result<()> {
        let mut rest = bytes;
        while !rest.is_empty() {
            match self.some(rest) {
                Ok(0) => return Err(io::ErrorKind::WriteZero.into()),
                Ok(count) => rest = &rest[count..],
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }

    /// Appends some of these bytes, and returns the number of bytes that the system has taken.
    fn some(&self, bytes: &[u8]) -> io::Result<usize> {
        let count = (&self.file).write(bytes)?;
        let (digest, length) = &mut *self.so_far.borrow_mut();
        digest.update(&bytes[..count]);
        *length += count as u64;
        Ok(count)
    }
}

impl Write for Hashed {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.some(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}
