//! Reading: TOML with lines, lossless coordinates, data files, meshes, maps, downloads.
//!
//! Every reader is lossless or fails with the file, the line and the cure. This
//! crate knows how files look, never what is asked about them: suites and their
//! scenes are the crate `corpus`, what a task's keys mean is its folder in the
//! crate `tasks`.
//!
//! * [`Document`], [`Field`] and [`Fields`]: a TOML file that knows its lines.
//! * [`exact_coordinate`], [`hexfloat`], [`bits`]: doubles as text and as bits.
//! * [`read_rows`], [`read_csv_rows`]: rows of numbers in suites and CSV files.
//! * [`mesh`], [`topojson`]: importers.
//! * [`Manifest`], [`Cache`], [`fetch`]: real data from package registries.

pub mod bits;
mod cache;
mod coordinate;
mod document;
mod error;
mod fetch;
pub mod hexfloat;
mod import;
mod manifest;
mod rows;
mod tables;

pub use cache::Cache;
pub use coordinate::{CoordinateError, exact as exact_coordinate, nearest as nearest_coordinate};
pub use document::{Document, Field, Fields, explain};
pub use error::{CorpusError, ErrorKind};
pub use fetch::fetch;
pub use import::{ImportNotes, mesh, topojson};
pub use manifest::{Entry, Manager, Manifest};
pub use rows::{POINT, RowKind, Rows, read_bytes, read_csv, read_csv_rows, read_points, read_rows, read_text, skipped};
pub use tables::{POINTS, TableKind};

/// A digest as lower-case hex digits.
#[must_use]
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
