//! Importers of geometry files, GeoJSON and WKT, which return a [`Geometry`].
//!
//! A feature of GeoJSON and a geometry of WKT is one region of a map. Positions may have a height (Z), which points in
//! space keep; flat tasks drop and count heights. Measures (M) and further numbers are also dropped and counted.

pub use super::features::{Feature, Geometry, ImportedEdges, Position, Shape};
use super::{Keeps, geojson, wkt};
use crate::data::{DataFile, Format};
use crate::{CorpusError, Decimals};

/// Reads a `.geojson`, `.json` or `.wkt` file, optionally with `.gz` appended.
///
/// # Errors
/// [`CorpusError`] at the line that is wrong.
pub fn read(file: &str, bytes: Vec<u8>, decimals: &Decimals) -> Result<Geometry, CorpusError> {
    read_part(file, bytes, decimals, None, &mut |_, _| true)
}

/// Reads a part of such a file: the selected features; of a JSON object, the named member, an array of rings.
///
/// # Errors
/// As [`read`], and if the member does not exist.
pub fn read_part(
    file: &str,
    bytes: Vec<u8>,
    decimals: &Decimals,
    member: Option<&str>,
    keeps: &mut Keeps<'_>,
) -> Result<Geometry, CorpusError> {
    let data = DataFile::open(file, bytes)?;
    match (data.format, member) {
        (Format::GeoJson, Some(member)) => geojson::read_member(file, &data.text()?, member, decimals, keeps),
        (_, Some(_)) => Err(CorpusError::file(file, "only JSON has members", "leave out `member`")),
        (Format::GeoJson, None) => geojson::read(file, &data.text()?, decimals, keeps),
        (Format::Wkt, None) => wkt::read(file, &data.text()?, decimals, keeps),
        _ => Err(CorpusError::file(file, "the file is not a map", "name a .geojson, .json or .wkt file")),
    }
}
