//! Names beside marks, none of which covers another.

use plotters::prelude::RGBColor;

/// The height of a label, and so the least distance between two.
pub const LINE: i32 = 14;
/// About the width of a letter in a label.
const LETTER: i32 = 7;
/// Marks nearer than this in x can have labels that touch.
const LABEL_WIDTH: i32 = 100;

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

/// About how wide a text is.
pub fn width(text: &str) -> i32 {
    i32::try_from(text.chars().count()).unwrap_or(i32::MAX).saturating_mul(LETTER)
}

/// Moves labels up and down until none covers another: from the top each is
/// pushed below those that it would touch, then what stuck out at the bottom
/// is pushed back up.
pub fn spread(labels: &mut [Label], (top, bottom): (i32, i32)) {
    labels.sort_by_key(|label| (label.at.1, label.at.0));
    for i in 0..labels.len() {
        let others = labels[..i].iter().filter(|other| touch(other, &labels[i]));
        labels[i].y = others.fold(labels[i].y.max(top), |y, other| y.max(other.y + LINE));
    }
    for i in (0..labels.len()).rev() {
        let others = labels[i + 1..].iter().filter(|other| touch(other, &labels[i]));
        labels[i].y = others.fold(labels[i].y.min(bottom), |y, other| y.min(other.y - LINE));
    }
}

/// Moves labels of one column, in their order, up and down until none covers another, as [`spread`] does.
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

fn touch(a: &Label, b: &Label) -> bool {
    (a.at.0 - b.at.0).abs() < LABEL_WIDTH.max(width(&a.text)).max(width(&b.text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_don_t_cover_each_other() {
        let label = |x, y| Label::new(String::new(), (x, y), RGBColor(0, 0, 0));
        let mut labels =
            [label(10, 100), label(12, 101), label(300, 101), label(11, 99), label(10, 196), label(9, 197)];
        spread(&mut labels, (0, 200));
        for (i, a) in labels.iter().enumerate() {
            assert!((0..=200).contains(&a.y), "label {i} is at {}", a.y);
            for b in &labels[..i] {
                assert!(!touch(a, b) || (a.y - b.y).abs() >= LINE, "{} and {}", a.y, b.y);
            }
        }
        assert_eq!(labels.iter().find(|label| label.at.0 == 300).unwrap().y, 101);
        stack(&mut labels, (0, 200));
        assert!(labels.windows(2).all(|pair| pair[1].y - pair[0].y >= LINE));
        assert!(labels.iter().all(|label| (0..=200).contains(&label.y)));
    }
}
