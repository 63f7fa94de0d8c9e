//! The file from which a mesh is read.

use predicament_corpus::Origin;
use predicament_formats::{Cache, CorpusError, Decimals, mesh};

/// The file of a mesh, which can be read again.
#[derive(Clone, Debug)]
pub(super) struct MeshFile {
    pub(super) origin: Origin,
    pub(super) round: bool,
    pub(super) cache: Cache,
}

impl MeshFile {
    /// Reads the file: its name, its contents, and the number of rounded decimals.
    pub(super) fn read(&self) -> Result<(String, mesh::ImportedMesh, usize), CorpusError> {
        let decimals = Decimals::new(self.round);
        let (file, bytes) = self.origin.bytes(&self.cache)?;
        let read = mesh::read(&file, bytes, &decimals)?;
        Ok((file, read, decimals.rounded()))
    }
}
