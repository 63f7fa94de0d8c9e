//! The columns of points in CSV files that a command line names: of the option `--columns`, or of a header that leaves
//! no doubt.

use std::path::Path;

use predicament_formats::{Columns, read_bytes, recognised_columns};

/// The value of `--columns`.
pub fn parse(text: &str) -> Result<Columns, String> {
    Columns::parse(text)
        .map_err(|why| format!("{why}; write two or three names or numbers from 1, such as lon,lat or 3,2"))
}

/// The columns of a file: those of the option, else those that the file's header names without doubt, with a note that
/// says so. None where the file is read without them. What is wrong with the file shows when it is read.
pub fn of_file(file: &Path, option: Option<&Columns>) -> Option<Columns> {
    match option {
        Some(columns) => Some(columns.clone()),
        None => {
            let name = file.display().to_string();
            of_bytes(&name, &name, read_bytes(file).ok()?)
        }
    }
}

/// The columns that the header of a file names without doubt, with a note; `shown` is the file in the note.
pub fn of_bytes(file: &str, shown: &str, bytes: Vec<u8>) -> Option<Columns> {
    let found = recognised_columns(file, bytes).ok()??;
    note!("{shown}: {found}; --columns chooses others");
    Some(found.columns)
}

/// The value of `points` in a suite: a file, and its columns.
pub fn table(path: &str, columns: Option<&Columns>) -> String {
    let path = toml::Value::String(path.to_owned());
    columns.map_or_else(
        || format!("{{ path = {path} }}"),
        |columns| format!("{{ path = {path}, columns = {} }}", columns.toml()),
    )
}
