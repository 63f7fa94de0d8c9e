//! The cache of fetched files, each under its key.

use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use crate::file::read_cached;
use crate::{CorpusError, Entry, hex};

/// A folder of fetched files. Every read checks the file against the manifest's hash.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cache {
    folder: PathBuf,
}

impl Cache {
    /// The cache in this folder, which need not exist yet.
    #[must_use]
    pub fn new(folder: impl Into<PathBuf>) -> Cache {
        Cache { folder: folder.into() }
    }

    /// The cache in `$PREDICAMENT_CACHE`, else in `predicament` in `$XDG_CACHE_HOME` or `~/.cache`.
    ///
    /// # Errors
    /// [`CorpusError`] if the variables are not set.
    pub fn default_dir() -> Result<Cache, CorpusError> {
        Cache::from_variables(|name| std::env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from))
    }

    fn from_variables(variable: impl Fn(&str) -> Option<PathBuf>) -> Result<Cache, CorpusError> {
        if let Some(folder) = variable("PREDICAMENT_CACHE") {
            return Ok(Cache::new(folder));
        }
        let caches = variable("XDG_CACHE_HOME").or_else(|| variable("HOME").map(|home| home.join(".cache")));
        caches.map(|caches| Cache::new(caches.join("predicament"))).ok_or_else(|| {
            CorpusError::usage("cache", "neither HOME nor XDG_CACHE_HOME is set", "set PREDICAMENT_CACHE to a folder")
        })
    }

    /// The folder.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The path of an entry's file, whether or not the file exists.
    #[must_use]
    pub fn path(&self, entry: &Entry) -> PathBuf {
        let name = entry.file.rsplit('/').next().unwrap_or(&entry.file);
        self.folder.join(&entry.key).join(name)
    }

    /// True if the file exists and has the right hash.
    #[must_use]
    pub fn has(&self, entry: &Entry) -> bool {
        read_cached(&self.path(entry)).is_ok_and(|bytes| bytes.is_some_and(|bytes| sha256(&bytes) == entry.sha256))
    }

    /// The bytes of a fetched file.
    ///
    /// # Errors
    /// [`CorpusError`] if the file was not fetched, or has another hash.
    pub fn bytes(&self, entry: &Entry) -> Result<Vec<u8>, CorpusError> {
        const CURE: &str = "run `predicament corpus fetch`";
        let path = self.path(entry);
        let file = path.display().to_string();
        let bytes = read_cached(&path)?
            .ok_or_else(|| CorpusError::file(&file, format!("`{}` has not been fetched", entry.key), CURE))?;
        let found = sha256(&bytes);
        if found != entry.sha256 {
            let message = format!("SHA-256 is {found}, the manifest says {}", entry.sha256);
            return Err(CorpusError::file(file, message, CURE));
        }
        Ok(bytes)
    }
}

/// A SHA-256 in lower-case hex.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_folder_follows_the_variables_in_their_order() {
        let with = |set: &[(&str, &str)]| {
            let set: Vec<(String, PathBuf)> = set.iter().map(|(k, v)| ((*k).to_owned(), PathBuf::from(v))).collect();
            Cache::from_variables(|name| set.iter().find(|(k, _)| k == name).map(|(_, v)| v.clone()))
        };
        let all = [("PREDICAMENT_CACHE", "/p"), ("XDG_CACHE_HOME", "/x"), ("HOME", "/h")];
        assert_eq!(with(&all), Ok(Cache::new("/p")));
        assert_eq!(with(&all[1..]), Ok(Cache::new("/x/predicament")));
        assert_eq!(with(&all[2..]), Ok(Cache::new("/h/.cache/predicament")));
        assert!(with(&[]).unwrap_err().cure.contains("PREDICAMENT_CACHE"));
    }

    #[test]
    fn a_known_hash() {
        assert_eq!(sha256(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }
}
