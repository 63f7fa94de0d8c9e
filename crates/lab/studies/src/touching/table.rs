//! Unions of solids that touch, as CSV and Markdown.

use predicament_records::format::significant;
use predicament_report::text::{in_order, markdown};
use serde::Serialize;

use super::{Made, Measured, Row, Touching};
use crate::{Error, File};

#[derive(Serialize)]
struct Line<'a> {
    pair: &'static str,
    backend: &'a str,
    triangles: usize,
    declined: &'a str,
    constructed: Option<usize>,
    undefined: Option<usize>,
    bits: Option<u32>,
    union_triangles: Option<usize>,
    limit_triangles: Option<usize>,
    no_limit: &'a str,
    merged: Option<usize>,
    flat: Option<usize>,
    cancelled: Option<usize>,
    covered: Option<usize>,
    divided: Option<usize>,
    volume: Option<f64>,
    counted_volume: Option<f64>,
    is_balanced: Option<bool>,
    contact_points: Option<usize>,
    contact_segments: Option<usize>,
    contact_length: Option<f64>,
    contact_faces: Option<usize>,
    contact_area: Option<f64>,
    counted_points: Option<usize>,
    counted_length: Option<f64>,
    counted_area: Option<f64>,
}

#[derive(Serialize)]
struct Time<'a> {
    pair: &'static str,
    backend: &'a str,
    round: usize,
    overlay_seconds: f64,
    limit_seconds: f64,
}

fn line<'a>(study: &Touching, row: &'a Row) -> Line<'a> {
    let made = row.made.as_ref().ok();
    let limit = made.and_then(|made| made.limit.as_ref());
    let counts = limit.and_then(|limit| limit.as_ref().ok());
    let volume = made.and_then(|made| made.volume.as_ref());
    let touched = made.and_then(|made| made.touched);
    let known = row.pair.known(study.side);
    Line {
        pair: row.pair.name(),
        backend: &row.backend,
        triangles: row.triangles,
        declined: row.made.as_ref().err().map_or("", String::as_str),
        constructed: made.map(|made| made.constructed),
        undefined: made.map(|made| made.undefined),
        bits: made.map(|made| made.bits),
        union_triangles: made.map(|made| made.triangles),
        limit_triangles: counts.map(|(triangles, _)| *triangles),
        no_limit: limit.and_then(|limit| limit.as_ref().err()).map_or("", String::as_str),
        merged: counts.map(|(_, counts)| counts.merged),
        flat: counts.map(|(_, counts)| counts.flat),
        cancelled: counts.map(|(_, counts)| counts.cancelled),
        covered: counts.map(|(_, counts)| counts.covered),
        divided: counts.map(|(_, counts)| counts.divided),
        volume: volume.map(|volume| volume.union.to_f64()),
        counted_volume: known.map(|known| known.union),
        is_balanced: volume.map(|volume| rug::Rational::from(&volume.union + &volume.intersection) == volume.both),
        contact_points: touched.map(|touched| touched.points),
        contact_segments: touched.map(|touched| touched.segments),
        contact_length: touched.map(|touched| touched.length),
        contact_faces: touched.map(|touched| touched.faces),
        contact_area: touched.map(|touched| touched.area),
        counted_points: known.map(|known| known.points),
        counted_length: known.map(|known| known.length),
        counted_area: known.map(|known| known.area),
    }
}

/// The results that are the same in every run, and the times.
pub(super) fn csv(study: &Touching, measured: &Measured) -> Result<Vec<File>, Error> {
    let times = measured.rows.iter().flat_map(|row| {
        row.overlay.iter().zip(&row.limit).enumerate().map(|(round, (&overlay_seconds, &limit_seconds))| Time {
            pair: row.pair.name(),
            backend: &row.backend,
            round,
            overlay_seconds,
            limit_seconds,
        })
    });
    let lines = measured.rows.iter().map(|row| line(study, row));
    Ok(vec![File::csv("touching.csv", lines)?, File::csv("touching-times.csv", times)?])
}

/// A table for each pair.
pub(super) fn page(study: &Touching, measured: &Measured) -> String {
    let mut page = format!(
        "Stacks and blocks of {} cubes along each axis, spheres of 8 · 4^{} triangles; medians of {} rounds in turns, \
         in milliseconds. Volumes are compared in rationals; a volume in brackets is off.\n",
        study.side, study.levels, study.rounds
    );
    for pair in in_order(measured.rows.iter().map(|row| row.pair)) {
        let heads = [
            "backend",
            "overlay",
            "limit",
            "constructed",
            "undefined",
            "bits",
            "triangles",
            "in the limit",
            "flat",
            "cancelled",
            "covered",
            "divided",
            "volume",
            "contacts",
        ];
        let of_pair: Vec<&Row> = measured.rows.iter().filter(|row| row.pair == pair).collect();
        let rows = of_pair.iter().map(|row| cells(study, row)).collect();
        let title = format!("{}: {} triangles", pair.name(), of_pair.first().map_or(0, |row| row.triangles));
        markdown(&mut page, &title, 1, heads.map(ToOwned::to_owned).to_vec(), rows);
        for row in of_pair {
            let why = match &row.made {
                Err(why) => Some(format!("no result: {why}")),
                Ok(Made { limit: Some(Err(why)), .. }) => Some(format!("no limit: {why}")),
                Ok(_) => None,
            };
            page.extend(why.map(|why| format!("\n* {}: {why}\n", row.backend)));
        }
    }
    page
}

fn cells(study: &Touching, row: &Row) -> Vec<String> {
    let Ok(made) = &row.made else {
        return std::iter::once(row.backend.clone()).chain(std::iter::repeat_n("-".to_owned(), 13)).collect();
    };
    let counts = made.limit.as_ref().and_then(|limit| limit.as_ref().ok());
    let count = |get: fn(&(usize, predicament_mesh_intersect::algorithm::limit::Counts)) -> usize| {
        counts.map_or_else(|| "-".to_owned(), |counts| get(counts).to_string())
    };
    let volume = made.volume.as_ref().map_or_else(
        || "-".to_owned(),
        |volume| {
            let text = significant(volume.union.to_f64(), 6);
            let is_balanced = rug::Rational::from(&volume.union + &volume.intersection) == volume.both;
            let is_counted = row.pair.known(study.side).is_none_or(|known| volume.union == known.union);
            if is_balanced && is_counted { text } else { format!("({text})") }
        },
    );
    let contacts = made.touched.map_or_else(
        || "-".to_owned(),
        |touched| {
            format!(
                "{} points, {} segments of {}, {} faces of {}",
                touched.points,
                touched.segments,
                significant(touched.length, 4),
                touched.faces,
                significant(touched.area, 4)
            )
        },
    );
    vec![
        row.backend.clone(),
        milliseconds(&row.overlay),
        if made.limit.is_some() && made.touched.is_none() { milliseconds(&row.limit) } else { "-".to_owned() },
        made.constructed.to_string(),
        made.undefined.to_string(),
        made.bits.to_string(),
        made.triangles.to_string(),
        count(|(triangles, _)| *triangles),
        count(|(_, counts)| counts.flat),
        count(|(_, counts)| counts.cancelled),
        count(|(_, counts)| counts.covered),
        count(|(_, counts)| counts.divided),
        volume,
        contacts,
    ]
}

/// The median of some times.
fn milliseconds(seconds: &[f64]) -> String {
    let mut sorted = seconds.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).map_or_else(|| "-".to_owned(), |seconds| significant(seconds * 1e3, 3))
}
