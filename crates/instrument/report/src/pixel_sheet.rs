//! Pixel maps of several backends on one sheet: answers, differences from the truth, names and counts, as SVG.

use std::fmt::Write as _;

use crate::pixel_map::{PixelMap, PixelMapError, data_uri};
use crate::plot::page;

/// The column of one backend on a sheet.
pub struct Column {
    /// The backend's name.
    pub name: String,
    /// The backend's answers.
    pub answers: PixelMap,
    /// The differences between the backend's answers and the truth.
    pub difference: PixelMap,
    /// The backend's counts, in short lines.
    pub lines: Vec<String>,
}

/// The maximum number of columns side by side.
const ACROSS: usize = 6;
/// The height of a line of text, in pixels.
const LINE: usize = 15;
/// The gap between columns, in pixels.
const GAP: usize = 14;
/// The minimum width of a column, in pixels.
const LEAST: usize = 100;
/// The width of a letter, in pixels.
const LETTER: usize = 7;

/// A sheet of columns under a title.
///
/// # Errors
/// If the pictures are too large.
pub fn sheet(title: &str, columns: &[Column], zoom: usize) -> Result<String, PixelMapError> {
    let size = |n: usize| n.checked_mul(zoom).filter(|&n| n > 0).ok_or(PixelMapError::BadSize);
    let extent = columns.iter().map(|column| column.answers.extent()).max().unwrap_or_default();
    let (map_width, map_height) = (size(extent.0)?, size(extent.1)?);
    let lines = columns.iter().map(|column| column.lines.len()).max().unwrap_or(0);
    let longest = columns
        .iter()
        .flat_map(|column| column.lines.iter().chain([&column.name]))
        .map(|text| text.chars().count())
        .max();
    let width = map_width.max(longest.unwrap_or(0) * LETTER).max(LEAST) + GAP;
    let height = 2 * (map_height + GAP) + (lines + 2) * LINE;
    let mut text = String::new();
    // Writing to a String does not fail.
    let words = |text: &mut String, x: usize, y: usize, weight: &str, words: &str| {
        let words = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        let _ =
            writeln!(text, "<text x=\"{x}\" y=\"{y}\" font-weight=\"{weight}\" fill=\"currentColor\">{words}</text>");
    };
    words(&mut text, GAP, LINE + 3, "600", title);
    for (at, column) in columns.iter().enumerate() {
        let (x, mut y) = (GAP + at % ACROSS * width, 2 * LINE + at / ACROSS * height + LINE);
        words(&mut text, x, y, "600", &column.name);
        y += 6;
        for (map, what) in [(&column.answers, "answers"), (&column.difference, "differences")] {
            let uri = data_uri(&map.to_png(1)?);
            let alt =
                format!("{what} of {}", column.name).replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
            let _ = writeln!(
                text,
                "<image x=\"{x}\" y=\"{y}\" width=\"{map_width}\" height=\"{map_height}\" style=\"image-rendering:pixelated\" \
                 href=\"{uri}\"><title>{alt}</title></image>"
            );
            y += map_height + GAP / 2;
        }
        for line in &column.lines {
            y += LINE;
            words(&mut text, x, y - 4, "400", line);
        }
    }
    let [across, down] = [columns.len().min(ACROSS), columns.len().div_ceil(ACROSS)];
    let (width, height) = (GAP + across * width, 3 * LINE + down * height);
    Ok(page(&format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"sans-serif\" font-size=\"12\">\n{text}</svg>\n"
    )))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pixel_map::Standing;

    #[test]
    fn every_column_has_its_name_its_counts_and_two_pictures() {
        let column = |name: &str| Column {
            name: name.to_owned(),
            answers: PixelMap::new(1, 1, &[1], &[false]).unwrap(),
            difference: PixelMap::difference(1, 1, &[Standing::Wrong]).unwrap(),
            lines: vec!["1 wrong".to_owned()],
        };
        let columns: Vec<Column> = ["a", "b<", "c", "d", "e", "f", "g"].map(column).into();
        let svg = sheet("what & where", &columns, 3).unwrap();
        assert_eq!((svg.matches("<image").count(), svg.matches("1 wrong").count()), (14, 7));
        assert!(svg.contains("b&lt;") && svg.contains("what &amp; where"));
        assert!(sheet("none", &columns, 0).is_err());
    }
}
