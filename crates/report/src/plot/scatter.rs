//! The scatter plot of time per query against wrong answers, a panel for each task.
//!
//! One panel for each task, on common logarithmic axes, because a task's times
//! are comparable with each other only. Zero has no logarithm: backends
//! without a wrong answer stand in a column of their own at the left. A panel
//! compares what all its backends did; marks of backends that did less are hollow.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::figures::{Mark, Panel, panels};
use crate::groups::backends;
use crate::{Error, RunDir};
use predicament_records::format::per_million;

use super::labels::{LINE, Label, spread, width};
use super::{Area, COLOURS, Chart, Decades, Drawn, INK, failed, page, power_of_ten, quiet};

const PANEL: (u32, u32) = (380, 320);
const PANELS_IN_A_ROW: usize = 3;

/// Nanoseconds per query against wrong answers per million, as an SVG
/// picture; none where no backend was both checked and timed on any family.
///
/// # Errors
/// If the picture can't be drawn.
pub fn scatter(runs: &[RunDir]) -> Result<Option<String>, Error> {
    let panels = panels(runs);
    if panels.is_empty() {
        return Ok(None);
    }
    let mut svg = String::new();
    draw(&mut svg, runs, &panels).map_err(failed)?;
    Ok(Some(page(&svg)))
}

fn draw(svg: &mut String, runs: &[RunDir], panels: &[Panel]) -> Drawn {
    let columns = panels.len().min(PANELS_IN_A_ROW);
    let rows = panels.len().div_ceil(columns);
    let scale = Scale::of(panels);
    let order = backends(runs);
    let timed_runs = panels.iter().any(|panel| panel.run != panels[0].run);

    // At most a few panels: the products are small.
    let size = |n: usize, each: u32| u32::try_from(n).unwrap_or(u32::MAX).saturating_mul(each);
    let root = SVGBackend::with_string(svg, (size(columns, PANEL.0), size(rows, PANEL.1))).into_drawing_area();
    for (area, panel) in root.split_evenly((rows, columns)).iter().zip(panels) {
        let mut title = format!("{}, {} of {} families", panel.task, panel.families, panel.of);
        if timed_runs {
            title = format!("{title}, run {}", panel.run + 1);
        }
        draw_panel(area, &panel.marks, &title, scale, &order)?;
    }
    root.present()
}

/// The powers of ten that the axes span.
#[derive(Clone, Copy)]
struct Scale {
    /// Where zero wrong answers stand: a decade below the smallest rate.
    zero: i32,
    most_wrong: i32,
    fastest: i32,
    slowest: i32,
}

impl Scale {
    fn of(panels: &[Panel]) -> Scale {
        let marks = || panels.iter().flat_map(|panel| &panel.marks);
        let decades = |values: &[f64]| {
            let low = values.iter().fold(f64::INFINITY, |a, &b| a.min(b));
            let high = values.iter().fold(f64::NEG_INFINITY, |a, &b| a.max(b));
            // Logarithms of doubles lie between -324 and 309.
            #[allow(clippy::cast_possible_truncation)]
            low.is_finite().then(|| (low.log10().floor() as i32, high.log10().ceil() as i32))
        };
        let rates: Vec<f64> = marks().filter_map(rate).filter(|&rate| rate > 0.0).collect();
        let times: Vec<f64> = marks().map(|mark| mark.ns).collect();
        let (least_wrong, most_wrong) = decades(&rates).unwrap_or((1, 2));
        let (fastest, slowest) = decades(&times).unwrap_or((0, 1));
        let zero = least_wrong - 1;
        Scale { zero, most_wrong: most_wrong.max(zero + 2), fastest, slowest: slowest.max(fastest + 1) }
    }

    /// The place of a mark: logarithms, with zero at its own place.
    fn place(self, mark: &Mark) -> (f64, f64) {
        let x = rate(mark).filter(|&rate| rate > 0.0).map_or(f64::from(self.zero), f64::log10);
        (x, mark.ns.log10())
    }
}

fn rate(mark: &Mark) -> Option<f64> {
    per_million(mark.errors.wrong, mark.errors.queries)
}

fn draw_panel(area: &Area, marks: &[Mark], title: &str, scale: Scale, order: &[&str]) -> Drawn {
    let (left, right) = (f64::from(scale.zero) - 0.5, f64::from(scale.most_wrong) + 0.2);
    let (bottom, top) = (f64::from(scale.fastest), f64::from(scale.slowest));
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 15).into_font().style(FontStyle::Bold).color(&INK))
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(52)
        .build_cartesian_2d(Decades::from(left..right), Decades::from(bottom..top))?;
    let mut mesh = chart.configure_mesh();
    quiet(&mut mesh, 11);
    mesh.x_label_formatter(&|x| if *x <= f64::from(scale.zero) { "0".to_owned() } else { power_of_ten(*x) })
        .y_label_formatter(&|y| power_of_ten(*y))
        .x_desc("wrong answers per million queries")
        .y_desc("ns per query")
        .draw()?;
    let edge = f64::from(scale.zero) + 0.5;
    chart.draw_series([Rectangle::new([(left, bottom), (edge, top)], INK.mix(0.05).filled())])?;
    draw_frontier(&mut chart, marks, scale)?;
    draw_marks(area, &mut chart, marks, scale, order)
}

/// A staircase: what is above and to the right of it is beaten.
fn draw_frontier(chart: &mut Chart, marks: &[Mark], scale: Scale) -> Drawn {
    let mut corners: Vec<(f64, f64)> = marks.iter().filter(|m| m.on_frontier).map(|m| scale.place(m)).collect();
    corners.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut stairs = Vec::new();
    let mut height = f64::from(scale.slowest);
    for (x, y) in corners {
        stairs.extend([(x, height), (x, y)]);
        height = y;
    }
    stairs.push((f64::from(scale.most_wrong) + 0.2, height));
    chart.draw_series(DashedLineSeries::new(stairs, 5, 4, INK.mix(0.5).stroke_width(1)))?;
    Ok(())
}

fn draw_marks(area: &Area, chart: &mut Chart, marks: &[Mark], scale: Scale, order: &[&str]) -> Drawn {
    let (x_range, y_range) = chart.plotting_area().get_pixel_range();
    let origin = area.get_pixel_range();
    let (dx, dy) = (origin.0.start, origin.1.start);
    let mut labels: Vec<Label> = Vec::new();
    for mark in marks {
        let colour = COLOURS[order.iter().position(|b| *b == mark.backend).unwrap_or(0) % COLOURS.len()];
        let place = scale.place(mark);
        let style = if mark.is_partial { colour.stroke_width(1) } else { colour.filled() };
        chart.draw_series([Circle::new(place, 4, style)])?;
        let at = chart.backend_coord(&place);
        let text = match mark.families {
            families if mark.is_partial => format!("{} ({families})", mark.backend),
            _ => mark.backend.to_owned(),
        };
        labels.push(Label::new(text, (at.0 - dx, at.1 - dy), colour));
    }
    spread(&mut labels, (y_range.start - dy + LINE / 2, y_range.end - dy - LINE / 2));
    let edge = x_range.end - dx;
    for label in &labels {
        let on_the_left = width(&label.text) > edge - label.at.0;
        let (offset, side) = if on_the_left { (-9, HPos::Right) } else { (9, HPos::Left) };
        let x = label.at.0 + offset;
        if (label.y - label.at.1).abs() > LINE / 2 {
            area.draw(&PathElement::new(vec![label.at, (x, label.y)], label.colour.mix(0.6)))?;
        }
        let style = ("sans-serif", 12).into_font().color(&label.colour).pos(Pos::new(side, VPos::Center));
        area.draw(&Text::new(label.text.clone(), (x, label.y), style))?;
    }
    Ok(())
}
