//! The scatter plot of time per query against wrong answers, a panel for each task.
//!
//! One panel for each task, on common logarithmic axes, because a task's times
//! are comparable with each other only. Zero has no logarithm: backends
//! without a wrong answer stand on a shelf of their own at the bottom. A mark has the range of its samples and Wilson's interval of its
//! rate. A panel compares what all its backends did; marks of backends that did less are hollow.

use plotters::prelude::*;

use crate::figures::{Mark, Panel, panels};
use crate::groups::backends;
use crate::{Error, Picture, RunDir};
use predicament_records::format::{per_million, significant};
use predicament_records::wilson;

use super::labels::{Label, names};
use super::{Area, COLOURS, Chart, Decades, Drawn, INK, Recording, failed, frontier, power_of_ten, quiet};

const PANEL: (u32, u32) = (460, 300);
const PANELS_IN_A_ROW: usize = 3;

/// Wrong answers per million against nanoseconds per query, as a
/// picture; none where no backend was both checked and timed on any family.
///
/// # Errors
/// If the picture can't be drawn.
pub fn scatter(runs: &[RunDir]) -> Result<Option<Picture>, Error> {
    let panels = panels(runs);
    if panels.is_empty() {
        return Ok(None);
    }
    let mut recording = Recording::default();
    draw(&mut recording, runs, &panels).map_err(failed)?;
    Ok(Some(recording.picture()?))
}

fn draw(recording: &mut Recording, runs: &[RunDir], panels: &[Panel]) -> Drawn {
    let columns = panels.len().min(PANELS_IN_A_ROW);
    let rows = panels.len().div_ceil(columns);
    let scale = Scale::of(panels);
    let order = backends(runs);
    let timed_runs = panels.iter().any(|panel| panel.run != panels[0].run);

    // At most a few panels: the products are small.
    let size = |n: usize, each: u32| u32::try_from(n).unwrap_or(u32::MAX).saturating_mul(each);
    let root = recording.area((size(columns, PANEL.0), size(rows, PANEL.1)));
    for (area, panel) in root.split_evenly((rows, columns)).iter().zip(panels) {
        let mut title = format!("{}, {} of {} families", panel.task, panel.families, panel.of);
        if timed_runs {
            title = format!("{title}, run {}", panel.run + 1);
        }
        // Times of different tasks say nothing about each other.
        draw_panel(area, &panel.marks, &title, scale.with_times_of(&panel.marks), &order)?;
    }
    root.present()
}

/// The powers of ten that the axes span.
#[derive(Clone, Copy)]
struct Scale {
    /// Where zero wrong answers stand: a decade below the smallest rate that there is or may be.
    zero: i32,
    most_wrong: i32,
    /// Logarithms, not whole ones.
    fastest: f64,
    slowest: f64,
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
        let rates: Vec<f64> = marks().flat_map(|mark| rate(mark).into_iter().chain(interval(mark))).collect();
        let rates: Vec<f64> = rates.into_iter().filter(|&rate| rate > 0.0).collect();
        let (least_wrong, most_wrong) = decades(&rates).unwrap_or((1, 2));
        let zero = least_wrong - 1;
        Scale { zero, most_wrong: most_wrong.max(zero + 2), fastest: 0.0, slowest: 1.0 }
    }

    /// The times of one panel.
    fn with_times_of(self, marks: &[Mark]) -> Scale {
        let times = || marks.iter().flat_map(|mark| mark.range).map(f64::log10);
        let (fastest, slowest) = (times().fold(f64::INFINITY, f64::min), times().fold(f64::NEG_INFINITY, f64::max));
        // A decade at least, so that there are ticks, and noise does not look like more.
        let room = (0.08 * (slowest - fastest)).max((1.0 - (slowest - fastest)) / 2.0);
        Scale { fastest: fastest - room, slowest: slowest + room, ..self }
    }

    /// The place of a mark: logarithms, with zero at its own place.
    fn place(self, mark: &Mark) -> (f64, f64) {
        (mark.ns.log10(), self.height(rate(mark).unwrap_or(0.0)))
    }

    fn height(self, rate: f64) -> f64 {
        if rate > 0.0 { rate.log10() } else { f64::from(self.zero) }
    }
}

fn rate(mark: &Mark) -> Option<f64> {
    per_million(mark.errors.wrong, mark.errors.queries)
}

/// Wilson's interval at 95 % of the rate, from zero where there is no wrong answer.
fn interval(mark: &Mark) -> [f64; 2] {
    let wrong = mark.errors.wrong.min(mark.errors.queries);
    let [low, high] = wilson(wrong, mark.errors.queries).map(|share| 1e6 * share);
    [if wrong == 0 { 0.0 } else { low }, high]
}

fn draw_panel(area: &Area, marks: &[Mark], title: &str, scale: Scale, order: &[&str]) -> Drawn {
    let (left, right) = (scale.fastest, scale.slowest);
    let (bottom, top) = (f64::from(scale.zero) - 0.5, f64::from(scale.most_wrong) + 0.2);
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 15).into_font().style(FontStyle::Bold).color(&INK))
        .margin(10)
        .margin_right(150)
        .x_label_area_size(40)
        .y_label_area_size(52)
        .build_cartesian_2d(Decades::finely(left..right), Decades::from(bottom..top))?;
    let mut mesh = chart.configure_mesh();
    quiet(&mut mesh, 11);
    mesh.x_label_formatter(&|x| {
        if x.fract().abs() < 1e-9 { power_of_ten(*x) } else { significant(10_f64.powf(*x), 1) }
    })
    .y_label_formatter(&|y| if *y <= f64::from(scale.zero) { "0".to_owned() } else { power_of_ten(*y) })
    .x_desc("ns per query")
    .y_desc("wrong answers per million queries")
    .draw()?;
    let edge = f64::from(scale.zero) + 0.5;
    chart.draw_series([Rectangle::new([(left, bottom), (right, edge)], INK.mix(0.05).filled())])?;
    let places = marks.iter().filter(|mark| mark.on_frontier).map(|mark| scale.place(mark));
    frontier(&mut chart, places.collect(), (right, top))?;
    draw_marks(area, &mut chart, marks, scale, order)
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
        let [low, high] = interval(mark).map(|rate| scale.height(rate));
        let [from, to] = mark.range.map(f64::log10);
        for ends in [vec![(place.0, low), (place.0, high)], vec![(from, place.1), (to, place.1)]] {
            chart.draw_series([PathElement::new(ends, colour.mix(0.4).stroke_width(2))])?;
        }
        chart.draw_series([Circle::new(place, 4, style)])?;
        let at = chart.backend_coord(&place);
        let text = match mark.families {
            families if mark.is_partial => format!("{} ({families})", mark.backend),
            _ => mark.backend.to_owned(),
        };
        labels.push(Label::new(text, (at.0 - dx, at.1 - dy), colour));
    }
    names(area, labels, x_range.end - dx, y_range.start - dy..y_range.end - dy)
}
