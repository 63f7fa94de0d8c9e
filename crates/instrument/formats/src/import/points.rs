//! Importer of points from a data file of any format.

use predicament_predicates::Dimension;

use super::{ImportNotes, Places, geojson, geometry, mesh, wkt};
use crate::csv::{self, Columns, Wanted};
use crate::data::{DataFile, Format};
use crate::rows::POINT;
use crate::{CorpusError, Decimals};

/// Points of two or of three coordinates.
#[derive(Clone, PartialEq, Debug)]
pub struct ImportedPoints {
    /// The number of coordinates of each point.
    pub dimension: Dimension,
    /// The coordinates, point after point.
    pub coordinates: Vec<f64>,
    /// The positions of the points in the file.
    pub places: Places,
    /// Counts of what the reader left out or changed.
    pub notes: ImportNotes,
}

/// Reads points by the extension of a file: rows of CSV, all positions of GeoJSON or WKT in their order (without the
/// positions that close rings), or the vertices of a mesh.
///
/// # Errors
/// [`CorpusError`] at the line that is wrong.
pub fn read(file: &str, bytes: Vec<u8>, decimals: &Decimals) -> Result<ImportedPoints, CorpusError> {
    read_columns(file, bytes, None, decimals)
}

/// Reads points like [`read`], with the coordinate columns of a CSV file named.
///
/// # Errors
/// [`CorpusError`] as [`read`]; also if columns are named for a file that is not CSV, or that does not have them.
pub fn read_columns(
    file: &str,
    bytes: Vec<u8>,
    columns: Option<&Columns>,
    decimals: &Decimals,
) -> Result<ImportedPoints, CorpusError> {
    let points = read_any(file, bytes, columns, decimals)?;
    if points.coordinates.is_empty() {
        return Err(CorpusError::file(file, "the file has no points", "write at least one point"));
    }
    Ok(points)
}

fn read_any(
    file: &str,
    bytes: Vec<u8>,
    columns: Option<&Columns>,
    decimals: &Decimals,
) -> Result<ImportedPoints, CorpusError> {
    let data = DataFile::open(file, bytes)?;
    if columns.is_some() && data.format != Format::Csv {
        let cure = "leave the columns out, or convert the data to CSV";
        return Err(CorpusError::file(file, "only CSV files have columns", cure));
    }
    let of_geometry = |geometry: geometry::Geometry| {
        let (dimension, coordinates) = geometry.points()?;
        let places = Places::of_points(geometry.positions().map(|position| position.line));
        Ok(ImportedPoints { dimension, coordinates, places, notes: geometry.notes })
    };
    match data.format {
        Format::Csv => {
            let rows = csv::read(file, &data.text()?, &POINT, columns.map_or(Wanted::Points, Wanted::Some), decimals)?;
            let places = Places::of_points(rows.lines.iter().copied());
            let (dimension, coordinates) = rows.points();
            Ok(ImportedPoints { dimension, coordinates, places, notes: ImportNotes::default() })
        }
        Format::GeoJson => of_geometry(geojson::read(file, &data.text()?, decimals, &mut |_, _| true)?),
        Format::Wkt => of_geometry(wkt::read(file, &data.text()?, decimals, &mut |_, _| true)?),
        Format::Off | Format::Obj | Format::Ply | Format::Stl => {
            let mesh = mesh::read_data(data, decimals)?;
            let coordinates = mesh.points.into_flattened();
            Ok(ImportedPoints { dimension: Dimension::Three, coordinates, places: mesh.places, notes: mesh.notes })
        }
    }
}
