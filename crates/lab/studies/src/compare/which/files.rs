//! The files that the parts are made of.

use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;

use crate::compare::section::{FILE, PROMISES};
use crate::compare::{Conditioned, Measure, Promise};
use crate::folder::{FolderError, rows_of};
use crate::stress::{BreakPoint, Violations};

/// The folder of a run.
pub(super) struct Files {
    folder: PathBuf,
}

impl Files {
    pub fn of(folder: &Path) -> Files {
        Files { folder: folder.to_owned() }
    }

    fn rows<T: DeserializeOwned>(&self, study: &str, file: &str, command: &str) -> Result<Vec<T>, FolderError> {
        let path = self.folder.join(study).join(file);
        let rows = rows_of(&path, command)?;
        if rows.is_empty() { Err(FolderError::NoRows { path }) } else { Ok(rows) }
    }

    /// The comparison.
    pub fn measures(&self) -> Result<Vec<Measure>, FolderError> {
        self.rows("compare", FILE, "compare")
    }

    /// What its backends promise.
    pub fn promises(&self) -> Result<Vec<Promise>, FolderError> {
        self.rows("compare", PROMISES, "compare")
    }

    /// Its answers by how degenerate queries are.
    pub fn conditioning(&self) -> Result<Vec<Conditioned>, FolderError> {
        self.rows("compare", "conditioning.csv", "compare")
    }

    /// The comparison of backends that differ in one parameter.
    pub fn curves(&self) -> Result<Vec<Measure>, FolderError> {
        self.rows("curves", FILE, "compare")
    }

    /// Where backends break.
    pub fn breaks(&self) -> Result<Vec<BreakPoint>, FolderError> {
        self.rows("stress", "breaks.csv", "stress")
    }

    /// Violations of metamorphic laws.
    pub fn violations(&self) -> Result<Vec<Violations>, FolderError> {
        self.rows("stress", "stress-laws.csv", "stress")
    }

    /// Cuts of tetrahedra: columns of the file.
    pub fn cuts<T: DeserializeOwned>(&self) -> Result<Vec<T>, FolderError> {
        self.rows("cut", "cut.csv", "cut")
    }

    /// Closed curves: columns of the file.
    pub fn parity<T: DeserializeOwned>(&self) -> Result<Vec<T>, FolderError> {
        self.rows("parity", "parity.csv", "parity")
    }

    /// Closed surfaces: columns of the file.
    pub fn parity_space<T: DeserializeOwned>(&self) -> Result<Vec<T>, FolderError> {
        self.rows("parity-space", "parity-space.csv", "parity --dimension 3")
    }
}
