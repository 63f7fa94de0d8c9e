//! Names beside marks, placed without overlaps.

use std::cmp::Reverse;
use std::ops::Range;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{Area, Drawn};

/// The height of a label, and so the minimum distance between two.
const LINE: i32 = 14;

/// A name beside a mark.
pub struct Label {
    pub text: String,
    /// The place of the mark, in pixels.
    pub at: (i32, i32),
    /// The height of the name, in pixels.
    pub y: i32,
    pub colour: RGBColor,
}

impl Label {
    /// A name at the height of its mark.
    pub fn new(text: String, at: (i32, i32), colour: RGBColor) -> Label {
        Label { text, at, y: at.1, colour }
    }
}

/// Draws all names in one column beside a plot with this right edge and height, each with a line from its mark.
pub fn names(area: &Area, mut labels: Vec<Label>, edge: i32, height: Range<i32>) -> Drawn {
    labels.sort_by_key(|label| (label.at.1, Reverse(label.at.0)));
    stack(&mut labels, (height.start, height.end - LINE / 2));
    let edge = edge + 8;
    for label in labels {
        area.draw(&PathElement::new(vec![label.at, (edge, label.y)], label.colour.mix(0.5)))?;
        let style = ("sans-serif", 12).into_font().color(&label.colour).pos(Pos::new(HPos::Left, VPos::Center));
        area.draw(&Text::new(label.text, (edge + 4, label.y), style))?;
    }
    Ok(())
}

/// Moves the labels of a column, in their order, until they do not overlap. From the top, each label is pushed below
/// the previous one. Then labels beyond the bottom are pushed back up.
fn stack(labels: &mut [Label], (top, bottom): (i32, i32)) {
    let mut least = top;
    for label in labels.iter_mut() {
        label.y = label.y.max(least);
        least = label.y + LINE;
    }
    let mut most = bottom;
    for label in labels.iter_mut().rev() {
        label.y = label.y.min(most);
        most = label.y - LINE;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_don_t_cover_each_other() {
        let mut labels: Vec<Label> =
            [10, 99, 100, 101, 101, 196, 197].map(|y| Label::new(String::new(), (0, y), RGBColor(0, 0, 0))).into();
        stack(&mut labels, (0, 200));
        assert!(labels.windows(2).all(|pair| pair[1].y - pair[0].y >= LINE));
        assert!(labels.iter().all(|label| (0..=200).contains(&label.y)));
        assert_eq!(labels[0].y, 10);
    }
}
