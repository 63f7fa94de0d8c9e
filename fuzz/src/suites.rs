//! Handwritten files: suites, expectations, the manifest of downloads. Any bytes are read or refused with a one-line
//! error.
//!
//! The first byte chooses the kind of file.

use std::path::Path;

use predicament_corpus::{Suite, fmt};
use predicament_formats::Manifest;
use predicament_oracle::expect::Expectations;

/// The number of kinds of files.
pub const KINDS: u8 = 3;

/// Runs one fuzz case.
///
/// # Panics
/// If an error is not a single line that names the file and a line of it, or if a losslessly rewritten suite is refused
/// or rewritten again.
pub fn check(bytes: &[u8]) {
    let Some((&kind, bytes)) = bytes.split_first() else { return };
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match kind % KINDS {
        0 => {
            let parse = |text: &str| {
                Suite::parse(predicament_bundle::vocabulary(), "fuzzed.toml", text, None, &Manifest::default())
            };
            let suite = one_line(parse(text), text);
            if let Some(tidy) = one_line(fmt(predicament_bundle::vocabulary(), "fuzzed.toml", text), text) {
                assert_eq!(
                    fmt(predicament_bundle::vocabulary(), "fuzzed.toml", &tidy).as_ref(),
                    Ok(&tidy),
                    "rewritten twice"
                );
                if suite.is_some() {
                    assert!(parse(&tidy).is_ok(), "rewritten, it is refused: {:?}", parse(&tidy).err());
                }
            }
        }
        1 => drop(one_line(Expectations::parse(Path::new("fuzzed.toml"), text), text)),
        _ => drop(one_line(Manifest::parse("fuzzed.toml", text), text)),
    }
}

/// The value that was read, if any; an error must be one line about an existing line.
fn one_line<T, E: ToString>(read: Result<T, E>, text: &str) -> Option<T> {
    match read {
        Ok(read) => Some(read),
        Err(error) => {
            let said = error.to_string();
            assert!(!said.contains(['\n', '\r']), "{said:?}");
            let place =
                said.strip_prefix("fuzzed.toml:").and_then(|rest| rest.split(':').next()?.parse::<usize>().ok());
            assert!(
                said.starts_with("fuzzed.toml") && place.is_none_or(|line| line <= text.lines().count() + 1),
                "{said:?}"
            );
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::bytes;

    #[test]
    fn random_bytes_and_changed_files_are_refused_in_one_line() {
        for run in 0..2000 {
            check(&bytes(run));
        }
        for (name, seed) in crate::seeds::suites() {
            check(&seed);
            let text = String::from_utf8(seed[1..].to_vec()).unwrap();
            for run in 0..3 {
                check(&[&seed[..1], crate::mutate::mutated(&text, run).as_bytes()].concat());
            }
            assert!(seed[0] < KINDS, "{name}");
        }
    }
}
