//! Everything that turns a run into something to read.
//!
//! A run leaves a folder of CSV and JSON files behind; they are the
//! interchange format, and every number that this crate prints can be traced
//! to their rows. The crate knows no geometry and no backend: a backend is a
//! name in a column, a truth is a symbol in a cell.
//!
//! * [`RunWriter`] makes a run folder and appends to it, so that a run that was
//!   killed explains itself and can be resumed; [`RunDir`] reads one.
//! * [`SummaryRow`], [`FindingRow`], [`ThroughputRow`], [`StageRow`], [`LocateRow`],
//!   [`ContactRow`], [`MassRow`] and [`PrecisionRow`] are the rows of its tables; [`Plan`] and [`Env`] say what
//!   was to be done, and where.
//! * [`markdown`], [`html`], [`junit`] and [`scatter`] are what people and
//!   machines read; [`write_pages`] writes all of the first kind into a folder.
//! * [`PixelMap`] shows the signs of a predicate over a raster.
//!
//! The same folder gives the same bytes: rows are sorted before they are
//! printed, and nothing asks for the time.

mod env;
mod error;
mod format;
mod groups;
mod junit;
mod page;
mod pixel_map;
mod plan;
mod plot;
mod rows;
mod run_dir;
mod rungs;
mod sections;
mod stats;
mod table;

pub use env::Env;
pub use error::Error;
pub use junit::junit;
pub use page::{html, markdown, write_pages};
pub use pixel_map::{PixelMap, PixelMapError, data_uri, side_by_side};
pub use plan::{FORMAT, Level, NotSelected, Plan, PlannedScene, Shard};
pub use plot::{Bar, Bars, Curve, Curves, curves, histogram, ranges, scatter};
pub use predicament_predicates::{Class, Status};
pub use rows::{ContactRow, FindingRow, LocateRow, MassRow, PrecisionRow, Row, StageRow, SummaryRow, ThroughputRow};
pub use run_dir::{NotRun, Outcome, RunDir, RunWriter};
pub use stats::Spread;
