//! Plots of ranges: bars from the size at which features are lost to the size from which on all survive, on a
//! logarithmic axis.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::palette::colours;
use super::{Decades, Drawn, Recording, failed, power_of_ten, quiet, small};
use crate::{Error, Picture};

const WIDTH: u32 = 760;
const ROW: u32 = 16;
/// The width of the names at the left.
const NAMES: u32 = 250;
/// The height of the axis and the legend.
const FRAME: u32 = 80;

/// The size of letters.
const FONT: u32 = 12;

/// A bar of a plot of ranges.
#[derive(Clone, PartialEq, Debug)]
pub struct Bar {
    /// The bar's subject; consecutive bars with one name form a group.
    pub name: String,
    /// The backend, which gives the colour.
    pub backend: String,
    /// The start of the bar; the left edge if `None`.
    pub from: Option<f64>,
    /// The end of the bar; the right edge if `None`.
    pub to: Option<f64>,
}

/// Draws bars over `x`, from 10^`low` to 10^`high`.
///
/// # Errors
/// If the picture can't be drawn.
pub fn ranges(bars: &[Bar], x: &str, [low, high]: [i32; 2]) -> Result<Picture, Error> {
    let mut recording = Recording::default();
    draw(&mut recording, bars, x, [low, high].map(f64::from)).map_err(failed)?;
    recording.picture()
}

fn draw(recording: &mut Recording, bars: &[Bar], x: &str, [low, high]: [f64; 2]) -> Drawn {
    let groups: Vec<&[Bar]> = bars.chunk_by(|a, b| a.name == b.name).collect();
    let mut backends: Vec<&str> = Vec::new();
    for bar in bars {
        if !backends.contains(&bar.backend.as_str()) {
            backends.push(&bar.backend);
        }
    }
    let rows = u32::try_from(bars.len() + groups.len()).unwrap_or(u32::MAX);
    let size = (WIDTH, rows.saturating_mul(ROW).saturating_add(FRAME));
    let root = recording.area(size);
    let mut chart = ChartBuilder::on(&root)
        .margin(10)
        .margin_top(30)
        .x_label_area_size(40)
        .y_label_area_size(NAMES)
        .build_cartesian_2d(Decades::from(low..high), f64::from(rows)..0.0)?;
    let mut mesh = chart.configure_mesh();
    quiet(&mut mesh, FONT);
    mesh.disable_y_mesh().disable_y_axis().x_label_formatter(&|x| power_of_ten(*x)).x_desc(x).draw()?;
    let palette = colours(backends.iter().copied());
    let colour = |backend: &str| palette[backends.iter().position(|b| *b == backend).unwrap_or(0)];
    let place = |x: Option<f64>, edge: f64| x.map_or(edge, |x| x.log10().clamp(low, high));
    let mut row = 0.5;
    for group in groups {
        // The middle of the bar's group: there are few rows, so nothing is rounded.
        #[allow(clippy::cast_precision_loss)]
        let middle = row + group.len() as f64 / 2.0;
        let at = chart.backend_coord(&(low, middle));
        let style = small(FONT).pos(Pos::new(HPos::Right, VPos::Center));
        root.draw(&Text::new(group[0].name.clone(), (at.0 - 8, at.1), style))?;
        for bar in group {
            let (from, to) = (place(bar.from, low), place(bar.to, high));
            let fill = colour(&bar.backend).filled();
            chart.draw_series([Rectangle::new([(from, row + 0.15), (to.max(from + 0.02), row + 0.85)], fill)])?;
            row += 1.0;
        }
        row += 1.0;
    }
    let mut left = i32::try_from(NAMES).unwrap_or(0);
    for backend in &backends {
        let style = ("sans-serif", 12).into_font().color(&colour(backend));
        root.draw(&Text::new((*backend).to_owned(), (left, 10), style))?;
        left += 12 + 8 * i32::try_from(backend.chars().count()).unwrap_or(0);
    }
    root.present()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_bar_is_drawn_and_named() {
        let bar = |name: &str, backend: &str, from, to| Bar { name: name.into(), backend: backend.into(), from, to };
        let bars = [
            bar("a gap", "one", Some(1e-8), Some(1e-6)),
            bar("a gap", "two", None, None),
            bar("a tip", "one", None, Some(1e-3)),
        ];
        let svg = ranges(&bars, "size", [-9, 0]).unwrap().svg;
        for text in ["a gap", "a tip", "one", "two", "size"] {
            assert!(svg.contains(text), "{text}");
        }
        let colours =
            ["one", "two"].map(super::super::colour_of).map(|RGBColor(r, g, b)| format!("#{r:02X}{g:02X}{b:02X}"));
        let filled = |colour: &str| svg.matches("<rect").count().min(svg.matches(colour).count());
        assert_eq!(filled(&colours[0]), 3, "two bars and a name: {svg}");
        assert_eq!(filled(&colours[1]), 2, "a bar and a name");
    }
}
