//! Plots for pages, as SVG, and for papers, as PDF.
//!
//! Each plot draws into a [`Recording`], from which both formats are made.
//!
//! * [`tradeoff`]: speed against error.
//! * [`ranges`]: the ranges from the size of the first loss to the size that is safe.
//! * [`curves`]: one quantity over another, on logarithmic axes.
//! * [`histogram`]: counts by place.

mod curves;
mod files;
mod helvetica;
mod histogram;
mod labels;
mod palette;
mod pdf;
mod ranges;
mod recording;
mod tradeoff;

use std::convert::Infallible;
use std::fmt::Display;
use std::ops::Range;

use plotters::chart::{ChartContext, MeshStyle};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint};
use plotters::prelude::*;

use crate::Error;
pub use curves::{Curve, Curves, XAxis, curves};
pub use histogram::{Bars, histogram};
pub use palette::colour_of;
pub use ranges::{Bar, ranges};
pub(crate) use recording::{Recorder, Recording};
pub use tradeoff::{Point, Tradeoff, tradeoff};

/// A placeholder for the colour of the text around the picture: a fixed colour can't be readable on both light and dark
/// pages.
pub(crate) const INK: RGBColor = RGBColor(1, 2, 3);
const INK_IN_SVG: &str = "#010203";

/// A plot for pages and files.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Picture {
    /// The plot as SVG, for pages and the web.
    pub svg: String,
    /// The plot as PDF, for papers, if there is one.
    pub pdf: Option<Vec<u8>>,
}

/// A picture with only SVG.
impl From<String> for Picture {
    fn from(svg: String) -> Picture {
        Picture { svg, pdf: None }
    }
}

pub(crate) type Area<'a> = DrawingArea<Recorder<'a>, Shift>;
type Chart<'c, 'a> = ChartContext<'c, Recorder<'a>, Cartesian2d<Decades, Decades>>;
pub(crate) type Drawn = Result<(), DrawingAreaErrorKind<Infallible>>;

pub(crate) fn failed(error: impl Display) -> Error {
    Error::new("plot".as_ref(), error.to_string())
}

/// A text style of this size in pixels.
fn small(size: u32) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&INK)
}

/// Sets thin lines at the ticks only, and small letters.
fn quiet<X: Ranged, Y: Ranged, B: DrawingBackend>(mesh: &mut MeshStyle<'_, '_, X, Y, B>, size: u32) {
    mesh.axis_style(INK.mix(0.5))
        .bold_line_style(INK.mix(0.12))
        .light_line_style(TRANSPARENT)
        .label_style(small(size))
        .axis_desc_style(small(size));
}

/// The picture with the colours of the page around it or, in a separate file, of the system's colour scheme.
pub(crate) fn page(svg: &str) -> String {
    let svg = svg.replace(INK_IN_SVG, "currentColor");
    // As a separate file, the picture has to find out the background itself.
    let style = "<style>.scatter{color:#222;max-width:100%;height:auto}\
                 @media(prefers-color-scheme:dark){.scatter{color:#ddd}}\
                 .scatter text{font-variant-numeric:tabular-nums}</style>";
    let open = svg.find('>').map_or(0, |end| end + 1);
    let (head, body) = svg.split_at(open);
    let head = head.replacen("<svg", "<svg class=\"scatter\"", 1);
    format!("{head}{style}{body}")
}

/// An axis of common logarithms, with a tick at each power of ten.
struct Decades {
    range: Range<f64>,
    ticks: Ticks,
}

/// The ticks of an axis.
enum Ticks {
    /// At each power of ten.
    Powers,
    /// At 2 and 5 times each power of ten as well.
    Fine,
    /// At multiples of a round number: the axis is linear.
    Multiples(f64),
}

impl Decades {
    /// An axis with more ticks if it spans less than two decades.
    fn finely(range: Range<f64>) -> Decades {
        let ticks = if range.end - range.start < 2.0 { Ticks::Fine } else { Ticks::Powers };
        Decades { range, ticks }
    }
}

impl Decades {
    /// A linear axis, with about ten ticks.
    fn linear(range: Range<f64>) -> Decades {
        let least = (range.end - range.start) / 10.0;
        let power = 10_f64.powf(least.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|digit| digit * power).find(|&step| step >= least);
        Decades { range, ticks: Ticks::Multiples(step.unwrap_or(power)) }
    }
}

impl From<Range<f64>> for Decades {
    fn from(range: Range<f64>) -> Decades {
        Decades { range, ticks: Ticks::Powers }
    }
}

impl Ranged for Decades {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let share = (value - self.range.start) / (self.range.end - self.range.start);
        // The result is a pixel near the given ones.
        #[allow(clippy::cast_possible_truncation)]
        let offset = (share * f64::from(to - from)).round() as i32;
        from + offset
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() {
            return Vec::new();
        }
        let factors: &[f64] = match self.ticks {
            Ticks::Powers => &[1.0],
            Ticks::Fine => &[1.0, 2.0, 5.0],
            Ticks::Multiples(step) => {
                let first = (self.range.start / step).ceil();
                let multiples = std::iter::successors(Some(first), |n| Some(n + 1.0)).map(|n| n * step);
                return multiples.take_while(|&tick| tick <= self.range.end).collect();
            }
        };
        let next = |tick: &f64| Some(tick + 1.0);
        let powers =
            std::iter::successors(Some(self.range.start.floor()), next).take_while(|&tick| tick <= self.range.end);
        let ticks = powers.flat_map(|power| factors.iter().map(move |factor| power + factor.log10()));
        ticks.filter(|tick| self.range.contains(tick) || *tick == self.range.end).collect()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

fn power_of_ten(exponent: f64) -> String {
    // Key points are whole numbers between -324 and 309.
    #[allow(clippy::cast_possible_truncation)]
    let exponent = exponent.round() as i32;
    match exponent {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        2 => "100".to_owned(),
        3 => "1k".to_owned(),
        4 => "10k".to_owned(),
        5 => "100k".to_owned(),
        6 => "1M".to_owned(),
        -3..0 => format!("{:.*}", usize::try_from(-exponent).unwrap_or(0), 10_f64.powi(exponent)),
        _ => format!("1e{exponent}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks() {
        let ticks: Vec<String> = [-4, -2, -1, 0, 3, 6, 9].map(|e| power_of_ten(f64::from(e))).into();
        assert_eq!(ticks, ["1e-4", "0.01", "0.1", "1", "1k", "1M", "1e9"]);
    }
}
