//! Pages, plots and pixel maps of runs.
//!
//! Everything here is made from run folders (the crate `records`), so every
//! number can be traced to a row. The crate knows no geometry, no backend and
//! no task: a task hands in a [`Section`] of its own (the crate `tasks`).
//!
//! * [`markdown`], [`html`] and [`write_pages`] make the report.
//! * [`Section`], [`Table`], [`Block`] and [`Cell`] are a page as data;
//!   [`layout`] has what sections about runs share.
//! * [`tradeoff`], [`curves`], [`histogram`] and [`ranges`] are plots as SVG and PDF, a [`Picture`] each.
//! * [`picture`] draws the points of a finding; [`Detail`] is what a page says about one.
//! * [`drawing`]: scenes and results as pictures, in the plane and in space.
//! * [`PixelMap`] shows the signs of a predicate over a raster.
//!
//! Runs are read together by [`RunDir::open_all`](predicament_records::RunDir::open_all), so that each scene on each
//! backend counts once. A figure about a backend depends on that backend and the scenes alone: the module `comparison` has
//! the rule.
//!
//! The same folder gives the same bytes: rows are sorted before they are
//! printed, and nothing asks for the time.

mod columns;
mod comparison;
pub mod drawing;
mod figures;
mod groups;
mod latex;
pub mod layout;
mod licences;
mod origin;
mod page;
pub mod picture;
mod pixel_map;
mod pixel_sheet;
mod plot;
mod rungs;
mod sections;
mod splice;
mod table;
pub mod text;
mod web;

pub use origin::Origin;
pub use page::{html, markdown, section_markdown, write_pages};
pub use pixel_map::{PixelMap, PixelMapError, Standing, data_uri, side_by_side};
pub use pixel_sheet::{Column, sheet};
pub use plot::{
    Bar, Bars, Curve, Curves, Picture, Point, Tradeoff, XAxis, colour_of, curves, histogram, ranges, tradeoff,
};
pub use sections::against;
pub use splice::{Part, splice};
pub use table::{Block, Cell, Headline, Section, Table, Tone};
pub use web::{Detail, Strip};

use predicament_records::{Class, Env, Error, FindingRow, Outcome, PrecisionRow, RunDir, Spread, Status, SummaryRow};
