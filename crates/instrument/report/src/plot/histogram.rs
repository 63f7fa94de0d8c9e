//! Histograms: counts as bars side by side, on a logarithmic axis.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::palette::colours;
use super::{Decades, Drawn, Recording, failed, power_of_ten, quiet, small};
use crate::{Error, Picture};

const SIZE: (u32, u32) = (760, 300);
/// The size of letters.
const FONT: u32 = 12;
/// The share of a place's width that its bars take.
const FILLED: f64 = 0.8;

/// The counts of several series by place.
#[derive(Clone, PartialEq, Debug)]
pub struct Bars {
    /// The title of the horizontal axis.
    pub x: String,
    /// The title of the vertical axis.
    pub y: String,
    /// The names of the places.
    pub places: Vec<String>,
    /// The series: a name, and a count for each place; zeros get no bar.
    pub series: Vec<(String, Vec<f64>)>,
}

/// Draws a histogram; `None` if all counts are zero.
///
/// # Errors
/// If the picture can't be drawn.
pub fn histogram(bars: &Bars) -> Result<Option<Picture>, Error> {
    let highest = bars.series.iter().flat_map(|(_, counts)| counts).fold(0.0_f64, |a, &b| a.max(b));
    if highest < 1.0 {
        return Ok(None);
    }
    let mut recording = Recording::default();
    draw(&mut recording, bars, highest.log10().floor() + 1.0).map_err(failed)?;
    Ok(Some(recording.picture()?))
}

fn draw(recording: &mut Recording, bars: &Bars, top: f64) -> Drawn {
    let number = |n: usize| f64::from(u32::try_from(n).unwrap_or(u32::MAX));
    // A count of 1 is drawn a little above the ground.
    let ground = -0.3;
    let root = recording.area(SIZE);
    let mut chart = ChartBuilder::on(&root)
        .margin(14)
        .x_label_area_size(40)
        .y_label_area_size(60)
        .build_cartesian_2d(0.0..number(bars.places.len()), Decades::from(ground..top))?;
    let mut mesh = chart.configure_mesh();
    quiet(&mut mesh, FONT);
    mesh.disable_x_mesh()
        .x_label_formatter(&|_| String::new())
        .y_label_formatter(&|y| power_of_ten(*y))
        .x_desc(&bars.x)
        .y_desc(&bars.y)
        .draw()?;
    let width = FILLED / number(bars.series.len().max(1));
    let palette = colours(bars.series.iter().map(|(name, _)| name.as_str()));
    for (at, ((name, counts), colour)) in bars.series.iter().zip(palette).enumerate() {
        let left = (1.0 - FILLED) / 2.0 + width * number(at);
        let bar = |(place, &count): (usize, &f64)| {
            let from = number(place) + left;
            (count >= 1.0).then(|| Rectangle::new([(from, ground), (from + width, count.log10())], colour.filled()))
        };
        chart
            .draw_series(counts.iter().enumerate().filter_map(bar))?
            .label(name)
            .legend(move |(x, y)| Rectangle::new([(x, y - 4), (x + 14, y + 4)], colour.filled()));
    }
    for (place, name) in bars.places.iter().enumerate() {
        let (x, y) = chart.backend_coord(&(number(place) + 0.5, ground));
        root.draw(&Text::new(name.clone(), (x, y + 6), small(FONT).pos(Pos::new(HPos::Center, VPos::Top))))?;
    }
    chart.configure_series_labels().position(SeriesLabelPosition::UpperRight).label_font(small(FONT)).draw()?;
    root.present()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_for_each_count_that_is_not_zero() {
        let bars = Bars {
            x: "place".into(),
            y: "count".into(),
            places: vec!["first".into(), "second".into()],
            series: vec![("one".into(), vec![10.0, 0.0]), ("two".into(), vec![1.0, 200.0])],
        };
        let svg = histogram(&bars).unwrap().unwrap().svg;
        for text in ["place", "count", "first", "second", "one", "two", "100"] {
            assert!(svg.contains(text), "{text}");
        }
        let filled = |RGBColor(r, g, b): RGBColor| svg.matches(&format!("#{r:02X}{g:02X}{b:02X}")).count();
        // Each has one more in the legend.
        assert_eq!(["one", "two"].map(super::super::colour_of).map(filled), [2, 3], "{svg}");
        let nothing = Bars { series: vec![("one".into(), vec![0.0, 0.0])], ..bars };
        assert_eq!(histogram(&nothing), Ok(None));
    }
}
