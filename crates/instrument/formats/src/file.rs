//! Opening files: regular files, of bounded size, unpacked within bounds.
//!
//! Suites, and the paths in them, may come from untrusted sources. Reading a pipe would block, a device never ends, and
//! a packed file of a megabyte may hold a terabyte: each is refused with a one-line error.

use std::fmt;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use flate2::read::MultiGzDecoder;

use crate::CorpusError;

/// The maximum size of a data file, packed or not.
const MOST_DATA: u64 = 2 << 30;
/// The maximum size after unpacking. Its parsed contents take up to seventeen times as much memory (short numbers in
/// ASCII PLY: 4.5 GB, measured), and a packed file can expand to a thousand times its size.
const MOST_UNPACKED: u64 = 256 << 20;
/// The maximum size of a suite: in memory it takes about thirty times as much.
const MOST_SUITE: u64 = 256 << 20;

/// The reason why a file is not read.
#[derive(Debug)]
enum Refusal {
    Io(io::Error),
    Folder,
    Irregular,
    TooLarge { most: u64 },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::Io(error) if error.kind() == io::ErrorKind::NotFound => f.write_str("there is no such file"),
            Refusal::Io(error) => write!(f, "{}", error.kind()),
            Refusal::Folder => f.write_str("it is a folder"),
            Refusal::Irregular => f.write_str("it is not a regular file (a pipe or a device)"),
            Refusal::TooLarge { most } => write!(f, "it has more than {most} bytes"),
        }
    }
}

/// The bytes of a regular file of at most `most` bytes. Other files are not opened: opening a pipe would block.
fn regular(path: &Path, most: u64) -> Result<Vec<u8>, Refusal> {
    let check = |about: &std::fs::Metadata| {
        if about.is_dir() {
            Err(Refusal::Folder)
        } else if !about.is_file() {
            Err(Refusal::Irregular)
        } else if about.len() > most {
            Err(Refusal::TooLarge { most })
        } else {
            Ok(())
        }
    };
    check(&std::fs::metadata(path).map_err(Refusal::Io)?)?;
    let file = File::open(path).map_err(Refusal::Io)?;
    check(&file.metadata().map_err(Refusal::Io)?)?;
    bounded(file, most).map_err(Refusal::Io)?.ok_or(Refusal::TooLarge { most })
}

/// All bytes of a stream; `None` if there are more than `most`.
fn bounded(from: impl Read, most: u64) -> io::Result<Option<Vec<u8>>> {
    let mut bytes = Vec::new();
    from.take(most + 1).read_to_end(&mut bytes)?;
    Ok((u64::try_from(bytes.len()).is_ok_and(|length| length <= most)).then_some(bytes))
}

/// The bytes of a data file of any format.
///
/// # Errors
/// [`CorpusError`] if it can't be read, is not a regular file, or is too large.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, CorpusError> {
    regular(path, MOST_DATA).map_err(|why| {
        let cure = match why {
            Refusal::TooLarge { .. } => "divide the data",
            Refusal::Folder | Refusal::Irregular | Refusal::Io(_) => "put the file there or correct `path`",
        };
        CorpusError::file(path.display().to_string(), format!("the data file can't be read: {why}"), cure)
    })
}

/// The text of a suite, or of another file that a user names.
///
/// # Errors
/// [`CorpusError`] if it can't be read, is not a regular file, is too large, or is not UTF-8.
pub fn read_suite(path: &Path) -> Result<String, CorpusError> {
    let file = path.display().to_string();
    let bytes = regular(path, MOST_SUITE).map_err(|why| {
        let cure = match why {
            Refusal::TooLarge { .. } => "put the points into a data file",
            Refusal::Folder | Refusal::Irregular | Refusal::Io(_) => "give a suite's name or a TOML file",
        };
        CorpusError::usage(&file, format!("the suite can't be read: {why}"), cure)
    })?;
    text_of(&file, bytes)
}

/// The text of a suite or a CSV file with every byte, including a byte-order mark, to be written back.
///
/// # Errors
/// [`CorpusError`] if it can't be read, is not a regular file, is too large, or is not UTF-8.
pub fn read_as_it_is(path: &Path) -> Result<String, CorpusError> {
    let file = path.display().to_string();
    let bytes = regular(path, MOST_DATA)
        .map_err(|why| CorpusError::usage(&file, format!("the file can't be read: {why}"), "name a readable file"))?;
    marked_text(&file, bytes)
}

/// The bytes of a file in the cache; `None` if the file does not exist.
pub(crate) fn read_cached(path: &Path) -> Result<Option<Vec<u8>>, CorpusError> {
    match regular(path, MOST_DATA) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(Refusal::Io(error)) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(why) => {
            let message = format!("the file can't be read: {why}");
            Err(CorpusError::file(path.display().to_string(), message, "make it a readable file, or remove it"))
        }
    }
}

/// The bytes of a file as text, without a byte-order mark.
///
/// # Errors
/// [`CorpusError`] at the line that is not UTF-8.
pub fn text_of(file: &str, bytes: Vec<u8>) -> Result<String, CorpusError> {
    let mut text = marked_text(file, bytes)?;
    if text.starts_with(BOM) {
        text.drain(..BOM.len_utf8());
    }
    Ok(text)
}

fn marked_text(file: &str, bytes: Vec<u8>) -> Result<String, CorpusError> {
    String::from_utf8(bytes).map_err(|why| {
        let valid = &why.as_bytes()[..why.utf8_error().valid_up_to()];
        let line = valid.iter().filter(|&&byte| byte == b'\n').count() + 1;
        CorpusError::file(file, "the file is not text in UTF-8", "write it as such").at_line(line)
    })
}

/// The byte-order mark, which some programs write at the start of texts.
pub(crate) const BOM: char = '\u{feff}';

/// The name without `.gz`, and the unpacked bytes; unchanged if the name does not end in `.gz`.
pub(crate) fn unpacked(file: &str, bytes: Vec<u8>) -> Result<(String, Vec<u8>), CorpusError> {
    unpacked_within(file, bytes, MOST_UNPACKED)
}

fn unpacked_within(file: &str, bytes: Vec<u8>, most: u64) -> Result<(String, Vec<u8>), CorpusError> {
    let lower = file.to_ascii_lowercase();
    let Some(name) = lower.strip_suffix(".gz") else { return Ok((lower, bytes)) };
    let error = |message: String, cure: &str| CorpusError::file(file, message, cure);
    let all = bounded(MultiGzDecoder::new(bytes.as_slice()), most)
        .map_err(|why| error(format!("the file can't be unpacked: {why}"), "compress it with gzip"))?
        .ok_or_else(|| {
            error(format!("unpacked, the file has more than {most} bytes"), "divide the data, or unpack it beforehand")
        })?;
    Ok((name.to_owned(), all))
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::{Compression, read::GzEncoder};

    #[test]
    fn only_regular_files_of_a_bounded_size_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        std::fs::write(&path, "1,2\n").unwrap();
        assert_eq!(regular(&path, 4).unwrap(), b"1,2\n");
        assert!(matches!(regular(&path, 3), Err(Refusal::TooLarge { most: 3 })));
        assert!(matches!(regular(folder.path(), 9), Err(Refusal::Folder)));
        assert!(matches!(regular(&folder.path().join("b"), 9), Err(Refusal::Io(_))));
        // A sparse file, which takes no space on disk.
        let large = std::fs::File::create(folder.path().join("large.csv")).unwrap();
        large.set_len(MOST_DATA + 1).unwrap();
        let error = read_bytes(&folder.path().join("large.csv")).unwrap_err().to_string();
        assert!(
            error.ends_with(
                "large.csv: the data file can't be read: it has more than 2147483648 bytes; divide the data"
            ),
            "{error}"
        );
        let error = read_suite(&folder.path().join("large.csv")).unwrap_err().to_string();
        assert!(error.ends_with("it has more than 268435456 bytes; put the points into a data file"), "{error}");
    }

    #[test]
    fn what_is_unpacked_is_bounded() {
        let mut packed = Vec::new();
        GzEncoder::new([b'0'; 100_000].as_slice(), Compression::best()).read_to_end(&mut packed).unwrap();
        assert!(packed.len() < 300);
        let (name, bytes) = unpacked_within("A.CSV.GZ", packed.clone(), 100_000).unwrap();
        assert_eq!((name.as_str(), bytes.len()), ("a.csv", 100_000));
        let error = unpacked_within("a.csv.gz", packed, 99_999).unwrap_err().to_string();
        assert_eq!(
            error,
            "a.csv.gz: unpacked, the file has more than 99999 bytes; divide the data, or unpack it beforehand"
        );
        let error = unpacked("a.csv.gz", b"1,2".to_vec()).unwrap_err().to_string();
        assert!(error.starts_with("a.csv.gz: the file can't be unpacked: "), "{error}");
    }

    #[test]
    fn a_bomb_is_refused() {
        let zeros = std::io::repeat(b'0').take(MOST_UNPACKED + 1);
        let mut packed = Vec::new();
        GzEncoder::new(zeros, Compression::fast()).read_to_end(&mut packed).unwrap();
        let error = unpacked("a.csv.gz", packed).unwrap_err().to_string();
        assert_eq!(
            error,
            "a.csv.gz: unpacked, the file has more than 268435456 bytes; divide the data, or unpack it beforehand"
        );
    }

    #[test]
    fn text_is_utf8_and_loses_its_mark() {
        assert_eq!(text_of("a", "\u{feff}1,2".into()).unwrap(), "1,2");
        let error = text_of("a.csv", b"1,2\n\xff,1\n".to_vec()).unwrap_err().to_string();
        assert_eq!(error, "a.csv:2: the file is not text in UTF-8; write it as such");
    }
}
