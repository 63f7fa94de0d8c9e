//! Shorter coordinates: fewer digits, small integers in the same order, no offset.

use std::sync::Arc;

use super::read::short;
use super::sketch::{Sketch, cost};

/// The rows of all points that items name, by file and index.
pub(super) fn places(files: &[Sketch]) -> Vec<(usize, usize)> {
    let of =
        |(file, sketch): (usize, &Sketch)| sketch.places().into_iter().map(move |at| (file, at)).collect::<Vec<_>>();
    files.iter().enumerate().flat_map(of).collect()
}

/// The numbers of a column, or of all columns; cells that are not numbers are left out.
fn numbers(files: &[Sketch], column: Option<usize>) -> Vec<f64> {
    let mut all = Vec::new();
    for (file, at) in places(files) {
        let cells =
            files[file].points[at].iter().enumerate().filter(|(at, _)| column.is_none_or(|column| column == *at));
        all.extend(cells.filter_map(|(_, cell)| cell.parse::<f64>().ok()).filter(|x| x.is_finite()));
    }
    all
}

/// The number of columns.
pub(super) fn columns(files: &[Sketch]) -> usize {
    places(files).into_iter().map(|(file, at)| files[file].points[at].len()).max().unwrap_or(0)
}

/// The files with the numbers of a column, or of all columns, replaced.
fn mapped(files: &[Sketch], column: Option<usize>, with: impl Fn(f64) -> f64) -> Vec<Sketch> {
    let places = places(files);
    let mut files = files.to_vec();
    for (file, at) in places {
        for (place, cell) in Arc::make_mut(&mut files[file].points)[at].iter_mut().enumerate() {
            let is_one = column.is_none_or(|column| column == place);
            if let Some(x) = cell.parse::<f64>().ok().filter(|x| is_one && x.is_finite()) {
                let text = short(with(x));
                if text.len() < cell.len() || text.parse() != Ok(x) {
                    *cell = text;
                }
            }
        }
    }
    files
}

/// A number with this many significant digits.
fn rounded(x: f64, digits: usize) -> f64 {
    format!("{x:.*e}", digits - 1).parse().unwrap_or(x)
}

/// The files with all numbers of a column, or of all columns, made shorter, the shortest first.
pub(super) fn shorter(files: &[Sketch], column: Option<usize>) -> impl Iterator<Item = Vec<Sketch>> {
    let mut sorted = numbers(files, column);
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    let least = sorted.first().copied().unwrap_or(0.0);
    let rank = move |x: f64| {
        let rank = sorted.partition_point(|&other| other < x);
        f64::from(u32::try_from(rank).unwrap_or(u32::MAX))
    };
    let mut all: Vec<Box<dyn Fn(f64) -> f64>> = vec![Box::new(|_| 0.0), Box::new(rank), Box::new(move |x| x - least)];
    all.extend(
        (0..=12).map(|places| -> Box<dyn Fn(f64) -> f64> {
            Box::new(move |x| format!("{x:.places$}").parse().unwrap_or(x))
        }),
    );
    all.extend((1..=16).map(|digits| -> Box<dyn Fn(f64) -> f64> { Box::new(move |x| rounded(x, digits)) }));
    let files = files.to_vec();
    all.into_iter().map(move |with| mapped(&files, column, with))
}

/// The files with one number replaced by each shorter number, the shortest first.
pub(super) fn one_shorter(files: &[Sketch], (file, at): (usize, usize), column: usize) -> Vec<Vec<Sketch>> {
    let Some(cell) = files[file].points[at].get(column) else { return Vec::new() };
    let Ok(x) = cell.parse::<f64>() else { return Vec::new() };
    let mut all: Vec<String> = ["0", "1", "2", "3", "-1", "0.5"].map(str::to_owned).into();
    all.extend([x.round(), x.trunc()].into_iter().chain((1..=16).map(|digits| rounded(x, digits))).map(short));
    all.retain(|text| cost(text) < cost(cell));
    all.sort_by_key(|text| cost(text));
    all.dedup();
    let with = |text: String| {
        let mut files = files.to_vec();
        Arc::make_mut(&mut files[file].points)[at][column] = text;
        files
    };
    all.into_iter().map(with).collect()
}
