//! The study of devices: what does each device of `exact` save?
//!
//! A device that saves nothing should not be there. Each variant lacks one device and gives the same answers. It takes
//! turns with the whole on the scenes of every task, and the ratio of their times is the worth of the device. Ratios
//! are of neighbouring samples, so a disturbance that lasts longer than a sample is in both of its times.
//!
//! * [`Ablation`]: the study. [`Row`]: a row of its file.
//! * [`section`]: the section of a report. [`saved`]: the table for the page "which backend for what".

mod plots;
mod row;
mod section;
mod study;
mod survey;
mod table;

pub use row::Row;
pub use section::section;
pub use study::Ablation;
pub use table::saved;

/// The file of rows.
pub const FILE: &str = "ablation.csv";
