//! The borders as a suite: two scenes for each, which differ in the last bit of one coordinate.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use predicament_predicates::{Dimension, Question};

use super::study::Found;
use crate::File;
use crate::coordinate::coordinate;

/// The suite.
pub(super) fn of(found: &[Found]) -> File {
    let mut text =
        "title = \"Borders\"\ndescription = \"Pairs of neighbouring doubles: a backend is right at one and wrong at \
                    the other.\"\n"
            .to_owned();
    // Two backends may have the same border, and scenes of one suite differ.
    let mut seen = BTreeSet::new();
    for (at, found) in found.iter().enumerate() {
        for (side, value) in [("right", found.border.right), ("wrong", found.border.wrong)] {
            let mut points = found.input.clone();
            points[found.border.coordinate] = value;
            let bits: Vec<u64> = points.iter().map(|&x| (x + 0.0).to_bits()).collect();
            if seen.insert((found.question.kind().name(), bits)) {
                write(&mut text, at, side, found, &points);
            }
        }
    }
    File::new("border.toml", text)
}

/// Writes one scene. Writing to a String cannot fail.
fn write(text: &mut String, at: usize, side: &str, found: &Found, points: &[f64]) {
    let Found { backend, question, family, .. } = found;
    let dimension = match question {
        Question::Orient3d | Question::Insphere => Dimension::Three,
        _ => Dimension::Two,
    };
    let row = |point: &[f64]| {
        let cells: Vec<String> = point.iter().map(|&x| coordinate(x).to_string()).collect();
        format!("[{}]", cells.join(", "))
    };
    let points: Vec<String> = points.chunks(dimension.count()).map(row).collect();
    let _ = write!(
        text,
        "\n[[scene]]\nname = \"border-{at}-{side}\"\ntask = \"{}\"\npoints = [{}]\ntags = [\"border\"]\n\
         source = \"predicament study border, family {family}\"\nanalysis = \"{backend} is {side} here.\"\n",
        question.kind(),
        points.join(", ")
    );
}
