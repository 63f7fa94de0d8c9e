//! The files from which the parts are made.

use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;

use crate::ablation;
use crate::compare::section::{FILE, PROMISES};
use crate::compare::{Conditioned, Measure, Promise};
use crate::decimals::Answered;
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

    /// The measures of the comparison.
    pub fn measures(&self) -> Result<Vec<Measure>, FolderError> {
        self.rows("compare", FILE, "compare")
    }

    /// The promises of the compared backends.
    pub fn promises(&self) -> Result<Vec<Promise>, FolderError> {
        self.rows("compare", PROMISES, "compare")
    }

    /// The answers by degeneracy of queries.
    pub fn conditioning(&self) -> Result<Vec<Conditioned>, FolderError> {
        self.rows("compare", "conditioning.csv", "compare")
    }

    /// The measures of the comparison of backends that differ in one parameter.
    pub fn curves(&self) -> Result<Vec<Measure>, FolderError> {
        self.rows("curves", FILE, "compare")
    }

    /// The break points of backends.
    pub fn breaks(&self) -> Result<Vec<BreakPoint>, FolderError> {
        self.rows("stress", "breaks.csv", "stress")
    }

    /// The violations of metamorphic laws.
    pub fn violations(&self) -> Result<Vec<Violations>, FolderError> {
        self.rows("stress", "stress-laws.csv", "stress")
    }

    /// The rows of the cuts of tetrahedra.
    pub fn cuts<T: DeserializeOwned>(&self) -> Result<Vec<T>, FolderError> {
        self.rows("cut", "cut.csv", "cut")
    }

    /// The rows of closed curves.
    pub fn parity<T: DeserializeOwned>(&self) -> Result<Vec<T>, FolderError> {
        self.rows("parity", "parity.csv", "parity")
    }

    /// The answers about decimals.
    pub fn decimals(&self) -> Result<Vec<Answered>, FolderError> {
        self.rows("decimals", crate::decimals::FILE, "decimals")
    }

    /// The times of variants without a device.
    pub fn ablation(&self) -> Result<Vec<ablation::Row>, FolderError> {
        self.rows("ablation", ablation::FILE, "ablation")
    }

    /// The rows of closed surfaces.
    pub fn parity_space<T: DeserializeOwned>(&self) -> Result<Vec<T>, FolderError> {
        self.rows("parity-space", "parity-space.csv", "parity --dimension 3")
    }
}
