//! The JSON files of a run folder, each with the digest of itself.
//!
//! `state.json` has the digests of all that must not change. It can't have its own digest. It does not have the digest
//! of `env.json` either, as equal runs leave the same `state.json` on every machine. So each JSON file begins with the
//! line `"seal"`, the SHA-256 of the file without that line: `grep -v '^  "seal"' state.json | sha256sum`. Folders of
//! versions without seals have none.

use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;

use super::hashed::digest;
use super::regular::read_regular;
use crate::{Error, replace};

/// The beginning and the end of the line with the seal.
const LINE: [&str; 2] = ["  \"seal\": \"", "\",\n"];
/// The first line of the file, before the line with the seal.
const FIRST: &str = "{\n";

/// Writes a JSON file with its seal; the file is complete or absent.
pub(super) fn write_json(path: &Path, value: &impl Serialize) -> Result<(), Error> {
    let json = serde_json::to_string_pretty(value).map_err(Error::json(path))? + "\n";
    let rest = json.strip_prefix(FIRST).unwrap_or_default();
    let [before, after] = LINE;
    replace(path, format!("{FIRST}{before}{}{after}{rest}", digest(json.as_bytes())).as_bytes())
}

pub(super) fn read_json<T: DeserializeOwned>(path: &Path) -> Result<T, Error> {
    of_json(path, &read_regular(path)?)
}

/// The value in a file with these bytes. A file without a seal is accepted as it is.
pub(super) fn of_json<T: DeserializeOwned>(path: &Path, bytes: &[u8]) -> Result<T, Error> {
    const CURE: &str = "restore the file from a copy, or start a new run";
    let unsealed = match sealed(bytes) {
        Some((seal, json)) if digest(&json).as_bytes() == seal => Some(json),
        // A seal elsewhere in the file was not written by a run.
        None if !has_seal(bytes) => None,
        _ => {
            return Err(Error::new(
                path,
                format!("its content differs from what the run wrote, according to its seal; {CURE}"),
            ));
        }
    };
    serde_json::from_slice(unsealed.as_deref().unwrap_or(bytes)).map_err(|error| {
        let Error { path, line, message } = Error::json(path)(error);
        let line = line.map(|line| line + u64::from(unsealed.is_some()));
        Error { path, line, message: format!("{message}; {CURE}") }
    })
}

/// True if a JSON object has a member `seal`, at any place.
fn has_seal(bytes: &[u8]) -> bool {
    #[derive(serde::Deserialize)]
    struct Object {
        seal: Option<serde::de::IgnoredAny>,
    }
    serde_json::from_slice::<Object>(bytes).is_ok_and(|object| object.seal.is_some())
}

/// The seal of a file, and the file without the seal's line, if it has one.
fn sealed(bytes: &[u8]) -> Option<(&[u8], Vec<u8>)> {
    let [before, after] = LINE.map(str::as_bytes);
    let rest = bytes.strip_prefix(FIRST.as_bytes())?.strip_prefix(before)?;
    let end = rest.windows(after.len()).position(|window| window == after)?;
    Some((&rest[..end], [FIRST.as_bytes(), &rest[end + after.len()..]].concat()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bit_that_flips_is_seen_wherever_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("env.json");
        let env = crate::Env::collect("0.1.0");
        write_json(&path, &env).unwrap();
        let written = std::fs::read(&path).unwrap();
        assert_eq!(read_json::<crate::Env>(&path).unwrap(), env);
        for place in 0..written.len() {
            for bit in 0..8 {
                let mut changed = written.clone();
                changed[place] ^= 1 << bit;
                let error = of_json::<crate::Env>(&path, &changed).expect_err("the bit counts").to_string();
                assert!(error.contains("env.json") && error.ends_with("or start a new run"), "{error}");
            }
        }
        // Other line ends, and a seal in another place.
        let text = String::from_utf8(written.clone()).unwrap();
        for moved in [text.replace('\n', "\r\n"), text.replacen("{\n", "{ ", 1)] {
            let error = of_json::<serde_json::Value>(&path, moved.as_bytes()).expect_err("it is not as it was written");
            assert!(error.to_string().contains("its seal"), "{error}");
        }
        // The seal is the digest of the file without the seal's line. The file without that line is as valid as before
        // seals existed.
        let (seal, json) = sealed(&written).unwrap();
        assert_eq!(seal, digest(&json).as_bytes());
        assert_eq!(of_json::<crate::Env>(&path, &json).unwrap(), env);
    }
}
