//! Readers: TOML with line numbers, lossless coordinates, data files, meshes, maps, downloads; and writers of meshes.
//!
//! Every reader is lossless or fails with the file, the line and the fix. This crate knows only the syntax of files,
//! not their use: the crate `corpus` handles suites and their scenes, and a task's folder in the crate `tasks` defines
//! the task's keys.
//!
//! * [`Document`], [`Field`] and [`Fields`]: a TOML file with line numbers.
//! * [`read_coordinate`], [`Decimals`], [`hexfloat`], [`bits`]: doubles as text and as bits.
//! * [`Written`]: the coordinates of a scene as decimals.
//! * [`read_rows`], [`read_csv_rows`], [`fmt_csv`]: rows of numbers in suites and CSV files.
//! * [`Columns`], [`recognised_columns`]: the columns of the coordinates in a CSV file.
//! * [`points`], [`geometry`], [`mesh`], [`topojson`], [`read_polygons`]: importers.
//! * [`write_mesh`]: meshes as OFF, OBJ, PLY and STL.
//! * [`read_bytes`], [`read_suite`]: files, within bounds.
//! * [`Manifest`], [`Cache`], [`fetch`]: real data from package registries.

mod cache;
mod coordinate;
mod csv;
mod data;
mod decimals;
mod document;
mod error;
mod export;
mod fetch;
mod file;
pub mod hexfloat;
mod import;
mod lines;
mod manifest;
mod nearest;
mod rows;
mod tables;
mod written;

pub use cache::Cache;
pub use coordinate::{CoordinateError, is_exact, read as read_coordinate};
pub use csv::{Column, Columns, Recognised, fmt_csv, skipped};
pub use data::{read_csv_rows, recognised_columns};
pub use decimals::{Decimals, MOST_COORDINATES, Place, explain, shown};
pub use document::{Document, Field, Fields};
pub use error::{CorpusError, ErrorKind, Position};
pub use export::{ExportError, MeshFormat, write_mesh};
pub use fetch::fetch;
pub use file::{read_as_it_is, read_bytes, read_suite, text_of};
pub use import::{ImportNotes, ImportedMap, Keeps, Places, geometry, mesh, points, read_polygons, topojson};
pub use lines::Lines;
pub use manifest::{Entry, Manager, Manifest};
pub use nearest::{nearest, use_one_of};
pub use predicament_families::bits;
pub use rows::{POINT, RowKind, Rows, read_points, read_rows};
pub use tables::{POINTS, TableKind};
pub use written::{Kept, NotWritten, Written};

/// A digest as lower-case hex digits.
#[must_use]
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
