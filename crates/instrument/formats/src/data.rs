//! Data files beside suites: their formats by extension, and their contents.

use crate::csv::{self, Recognised, Wanted};
use crate::file::{text_of, unpacked};
use crate::rows::{RowKind, Rows};
use crate::{CorpusError, Decimals};

/// The format of a data file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Format {
    Csv,
    GeoJson,
    Wkt,
    Off,
    Obj,
    Ply,
    Stl,
}

/// The file extensions with their formats.
const EXTENSIONS: [(&str, Format); 9] = [
    (".csv", Format::Csv),
    (".txt", Format::Csv),
    (".geojson", Format::GeoJson),
    (".json", Format::GeoJson),
    (".wkt", Format::Wkt),
    (".off", Format::Off),
    (".obj", Format::Obj),
    (".ply", Format::Ply),
    (".stl", Format::Stl),
];

/// The contents of a data file, unpacked.
pub(crate) struct DataFile {
    /// The name of the file in errors.
    pub(crate) file: String,
    pub(crate) format: Format,
    pub(crate) bytes: Vec<u8>,
}

impl DataFile {
    /// Opens a data file from its name and bytes. The extension determines the format; gzip is unpacked if the name
    /// ends in `.gz`.
    pub(crate) fn open(file: &str, bytes: Vec<u8>) -> Result<DataFile, CorpusError> {
        let (name, bytes) = unpacked(file, bytes)?;
        let format = EXTENSIONS.iter().find(|(extension, _)| name.ends_with(extension)).map(|&(_, format)| format);
        let format = format.ok_or_else(|| {
            let known = EXTENSIONS.map(|(extension, _)| extension).join(", ");
            let cure = format!("name a file with one of {known}, perhaps packed as .gz");
            CorpusError::file(file, "the file name does not show its format", cure)
        })?;
        Ok(DataFile { file: file.to_owned(), format, bytes })
    }

    /// The contents as text.
    pub(crate) fn text(self) -> Result<String, CorpusError> {
        text_of(&self.file, self.bytes)
    }
}

/// Reads a CSV file of rows of numbers: `.csv` or `.txt`, optionally followed by `.gz`.
///
/// # Errors
/// [`CorpusError`] at the line that is wrong.
pub fn read_csv_rows(file: &str, bytes: Vec<u8>, kind: &RowKind, decimals: &Decimals) -> Result<Rows, CorpusError> {
    let data = DataFile::open(file, bytes)?;
    if data.format != Format::Csv {
        let message = format!("{}s are rows of numbers", kind.name);
        return Err(CorpusError::file(file, message, "name a .csv or .txt file"));
    }
    csv::read(file, &data.text()?, kind, Wanted::All, decimals)
}

/// The coordinate columns that the header of a CSV file names unambiguously, besides other columns or in another order.
/// `None` if the file can be read without named columns, is not CSV, or has ambiguous names.
///
/// # Errors
/// [`CorpusError`] if the file can't be unpacked, is not UTF-8, or has a name that does not show its format.
pub fn recognised_columns(file: &str, bytes: Vec<u8>) -> Result<Option<Recognised>, CorpusError> {
    let data = DataFile::open(file, bytes)?;
    if data.format != Format::Csv {
        return Ok(None);
    }
    Ok(csv::recognised(&data.text()?))
}
