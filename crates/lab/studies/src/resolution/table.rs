//! The smallest features that survive, and the worst crossings, as Markdown.

use std::fmt::Write as _;

use super::{Feature, Location, Resolved};

/// The page with both tables.
pub(super) fn page(measured: &Resolved) -> String {
    // Writing to a String cannot fail.
    let mut page = String::new();
    page += "| | feature | size | tolerance | backend | never survives up to | always survives from |\n";
    page += "|---|---|---|---|---|---|---|\n";
    let size = |size: Option<f64>| size.map_or_else(|| "-".to_owned(), |size| format!("{size:.2e}"));
    for (feature, backend, survey) in &measured.features {
        let Feature { name, size: what, tolerance, dimension, .. } = feature;
        let (dimension, lost, safe) = (dimension.count(), size(survey.lost()), size(survey.safe()));
        let _ = writeln!(page, "| {dimension}D | {name} | {what} | {tolerance} | {backend} | {lost} | {safe} |");
    }
    page += "\n| backend | largest error / L | at the angle | 19 of 20 registered as crossings from |\n";
    page += "|---|---|---|---|\n";
    for (backend, locations) in &measured.crossings {
        let Some(worst) = locations.iter().max_by(|a, b| a.worst.total_cmp(&b.worst)) else { continue };
        let most = |at: &&Location| u64::from(at.crossings) * 20 >= u64::from(at.crossed) * 19;
        let steep = locations.iter().rev().take_while(most).last().map(|at| at.angle);
        let _ = writeln!(page, "| {backend} | {:.3} | {:.2e} | {} |", worst.worst, worst.angle, size(steep));
    }
    page
}
