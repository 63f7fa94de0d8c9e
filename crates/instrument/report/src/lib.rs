//! Pages, plots and pixel maps of runs.
//!
//! Everything here is made from run folders (the crate `records`), so every number can be traced to a row. The crate
//! does not depend on geometry, backends or tasks: a task provides its own [`Section`] (the crate `tasks`).
//!
//! * [`markdown`], [`html`] and [`write_pages`] make the report.
//! * [`Section`], [`Table`], [`Block`] and [`Cell`] are a page as data; [`layout`] has the shared parts of sections
//!   about runs.
//! * [`tradeoff`], [`curves`], [`histogram`] and [`ranges`] make plots as SVG and PDF, each a [`Picture`].
//! * [`picture`] draws the points of a finding; [`Detail`] is the text and pictures of a page about one finding.
//! * [`drawing`] makes pictures of scenes and results, in the plane and in space.
//! * [`PixelMap`] shows the signs of a predicate over a raster.
//!
//! [`RunDir::open_all`](predicament_records::RunDir::open_all) reads several runs together, so that each scene on each
//! backend counts once. A figure about a backend depends only on that backend and the scenes: the module `comparison`
//! has the rule.
//!
//! The same folder gives the same bytes: rows are sorted before they are printed, and the code does not use the current
//! time.

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
pub use page::{html, markdown, plain_html, section_markdown, write_pages};
pub use pixel_map::{PixelMap, PixelMapError, Standing, data_uri, side_by_side};
pub use pixel_sheet::{Column, sheet};
pub use plot::{
    Bar, Bars, Curve, Curves, Picture, Point, Tradeoff, XAxis, colour_of, curves, histogram, ranges, tradeoff,
};
pub use sections::{Source, against, ranking, sources};
pub use splice::{Part, splice};
pub use table::{Block, Cell, Headline, Section, Table, Tone};
pub use web::{Detail, Strip};

use predicament_records::{Class, Env, Error, FindingRow, Outcome, PrecisionRow, RunDir, Spread, Status, SummaryRow};
