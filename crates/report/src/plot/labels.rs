//! Names beside marks, none of which covers another.

use plotters::prelude::RGBColor;

/// The height of a label, and so the least distance between two.
pub const LINE: i32 = 14;

/// The name beside a mark.
pub struct Label {
    pub text: String,
    /// Where the mark is, in pixels.
    pub at: (i32, i32),
    /// Where the name goes.
    pub y: i32,
    pub colour: RGBColor,
}

impl Label {
    /// A name where its mark is.
    pub fn new(text: String, at: (i32, i32), colour: RGBColor) -> Label {
        Label { text, at, y: at.1, colour }
    }
}

/// Moves labels of one column, in their order, up and down until none covers another: from the top each is pushed below the one
/// before it, then what stuck out at the bottom is pushed back up.
pub fn stack(labels: &mut [Label], (top, bottom): (i32, i32)) {
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
