//! A plot of time against errors, with a mark for each backend, and bars for the share that a backend left undone.
//!
//! Time is on the one axis, the rate of errors on the other. Zero has no logarithm: backends without errors are on a
//! shelf at the bottom, with the upper end of their interval above it. A backend that left queries undone looks better
//! than it is, so a bar shows their share. The picture is 400 pixels wide, so that it is readable on a phone.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use predicament_records::format::{length, percent, significant};
use predicament_records::wilson;

use super::labels::{Label, names};
use super::{Area, Chart, Decades, Drawn, INK, Recording, colour_of, failed, power_of_ten, quiet, small};
use crate::{Error, Picture};

const SIZE: (u32, u32) = (400, 270);
/// The height of a bar's row.
const ROW: u32 = 15;
/// The width of the names: of a mark at the right, of a bar at the left.
const NAMES: u32 = 150;
/// The size of letters.
const FONT: u32 = 11;

/// The data of a plot of times and errors.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Tradeoff {
    /// The title above the plot.
    pub title: String,
    /// The title of the horizontal axis, such as `time over naive's`.
    pub x: String,
    /// The title of the vertical axis, such as `wrong answers per million`.
    pub y: String,
    /// The denominator of the error rate: a million, or a thousand.
    pub per: f64,
    /// The backends.
    pub points: Vec<Point>,
}

/// A backend on a plot.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Point {
    /// The backend's name, which gives its colour.
    pub backend: String,
    /// The time relative to the reference's; `None` if it was not timed: then it has at most a bar.
    pub time: Option<f64>,
    /// The number of wrong answers or scenes, and their total.
    pub errors: [u64; 2],
    /// The number of undone answers or scenes, and their total.
    pub not_done: [u64; 2],
    /// True if the backend breaks a law that the vertical axis does not count: its mark is crossed out.
    pub is_marked: bool,
    /// The curve of the point: the points of one backend with different parameters, in their order.
    pub curve: Option<String>,
    /// The time and errors in an earlier run.
    pub before: Option<(f64, [u64; 2])>,
}

/// The position of a point, in logarithms.
#[derive(Clone, Copy)]
struct Place {
    time: f64,
    /// The rate; `None` on the shelf.
    rate: Option<f64>,
    /// The interval of the rate; its lower end is `None` on the shelf.
    interval: (Option<f64>, f64),
}

impl Tradeoff {
    fn place(&self, time: Option<f64>, [wrong, of]: [u64; 2]) -> Option<Place> {
        let time = time.filter(|time| *time > 0.0 && of > 0)?;
        let wrong = wrong.min(of);
        let [low, high] = wilson(wrong, of).map(|share| (self.per * share).log10());
        #[allow(clippy::cast_precision_loss)] // a share, for a picture
        let rate = (wrong > 0).then(|| (self.per * wrong as f64 / of as f64).log10());
        Some(Place { time: time.log10(), rate, interval: (rate.is_some().then_some(low), high) })
    }

    /// The positions of the timed points.
    fn places(&self) -> impl Iterator<Item = (&Point, Place)> {
        self.points.iter().filter_map(|point| Some((point, self.place(point.time, point.errors)?)))
    }

    fn ghosts(&self) -> impl Iterator<Item = (&Point, Place)> {
        let ghosts = self.points.iter().filter_map(|point| Some((point, point.before?)));
        ghosts.filter_map(|(point, (time, errors))| Some((point, self.place(Some(time), errors)?)))
    }
}

/// Draws the plot; `None` if no backend was timed and asked.
///
/// # Errors
/// If the picture can't be drawn.
pub fn tradeoff(of: &Tradeoff) -> Result<Option<Picture>, Error> {
    if of.places().next().is_none() {
        return Ok(None);
    }
    let mut recording = Recording::default();
    draw(&mut recording, of).map_err(failed)?;
    Ok(Some(recording.picture()?))
}

fn draw(recording: &mut Recording, of: &Tradeoff) -> Drawn {
    let undone: Vec<&Point> = of.points.iter().filter(|point| point.not_done[0] > 0).collect();
    let rows = u32::try_from(length(undone.len())).unwrap_or(0);
    let below = if rows == 0 { 0 } else { (rows + 2) * ROW };
    let root = recording.area((SIZE.0, SIZE.1 + below));
    let (above, bars) = root.split_vertically(SIZE.1);
    marks(&above, of)?;
    if rows > 0 {
        bars_of(&bars, &undone)?;
    }
    root.present()
}

fn marks(area: &Area, of: &Tradeoff) -> Drawn {
    let fold = |values: &mut dyn Iterator<Item = f64>| {
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    };
    let all = || of.places().chain(of.ghosts()).map(|(_, place)| place);
    let (fastest, slowest) = fold(&mut all().map(|place| place.time));
    let (least, most) = fold(&mut all().flat_map(|place| place.interval.0.into_iter().chain([place.interval.1])));
    let shelf = least.floor() - 1.0;
    let (left, right) = (fastest.min(0.0) - 0.15, slowest.max(0.0) + 0.15);
    let (bottom, top) = (shelf - 0.5, (most + 0.1).ceil().max(shelf + 2.0));
    let mut chart = ChartBuilder::on(area)
        .caption(&of.title, ("sans-serif", 13).into_font().style(FontStyle::Bold).color(&INK))
        .margin(6)
        .margin_right(NAMES)
        .x_label_area_size(34)
        .y_label_area_size(46)
        .build_cartesian_2d(Decades::finely(left..right), Decades::from(bottom..top))?;
    let mut mesh = chart.configure_mesh();
    quiet(&mut mesh, FONT);
    let label = |y: &f64| if *y <= shelf { "0".to_owned() } else { power_of_ten(*y) };
    mesh.x_label_formatter(&|x| format!("{}×", significant(10_f64.powf(*x), 1)))
        .y_label_formatter(&label)
        .x_desc(&of.x)
        .y_desc(&of.y)
        .draw()?;
    chart.draw_series([Rectangle::new([(left, bottom), (right, shelf + 0.5)], INK.mix(0.06).filled())])?;
    let at = |place: Place| (place.time, place.rate.unwrap_or(shelf));
    curves(&mut chart, of, at)?;
    let mut labels = Vec::new();
    for (point, place) in of.places() {
        let colour = colour_of(&point.backend);
        let low = (place.time, place.interval.0.unwrap_or(shelf));
        let ends = vec![low, (place.time, place.interval.1)];
        chart.draw_series([PathElement::new(ends, colour.mix(0.6).stroke_width(2))])?;
        if let Some((_, ghost)) = of.ghosts().find(|(other, _)| other.backend == point.backend) {
            chart.draw_series([PathElement::new(vec![at(ghost), at(place)], colour.stroke_width(1))])?;
            chart.draw_series([Circle::new(at(ghost), 7, colour.stroke_width(1))])?;
        }
        chart.draw_series([Circle::new(at(place), 4, colour.filled())])?;
        if point.is_marked {
            chart.draw_series([Cross::new(at(place), 6, INK.stroke_width(2))])?;
        }
        labels.push(Label::new(point.backend.clone(), chart.backend_coord(&at(place)), colour));
    }
    let (x_range, y_range) = chart.plotting_area().get_pixel_range();
    names(area, labels, x_range.end, y_range)
}

/// Draws the curves of backends with several parameters, each as a line through its points.
fn curves(chart: &mut Chart, of: &Tradeoff, at: impl Fn(Place) -> (f64, f64)) -> Drawn {
    let mut drawn: Vec<&str> = Vec::new();
    for name in of.points.iter().filter_map(|point| point.curve.as_deref()) {
        if drawn.contains(&name) {
            continue;
        }
        drawn.push(name);
        let line = of.places().filter(|(point, _)| point.curve.as_deref() == Some(name)).map(|(_, place)| at(place));
        chart.draw_series(LineSeries::new(line, colour_of(name).mix(0.7).stroke_width(1)))?;
    }
    Ok(())
}

/// Draws a bar for each backend that left something undone.
fn bars_of(area: &Area, undone: &[&Point]) -> Drawn {
    let pixel = |x: u32| i32::try_from(x).unwrap_or(i32::MAX);
    let (left, wide) = (pixel(NAMES), SIZE.0 - NAMES - 60);
    area.draw(&Text::new("not done", (left, 2), small(FONT)))?;
    for (row, point) in (1_u32..).zip(undone) {
        let middle = pixel(row * ROW + ROW / 2 + 4);
        let colour = colour_of(&point.backend);
        let style = ("sans-serif", FONT).into_font().color(&colour).pos(Pos::new(HPos::Right, VPos::Center));
        area.draw(&Text::new(point.backend.clone(), (left - 6, middle), style))?;
        let [count, of] = point.not_done;
        // The result is at most 184 pixels.
        let long = u32::try_from(u128::from(count.min(of)) * u128::from(wide) / u128::from(of.max(1))).unwrap_or(wide);
        let frame = [(left, middle - 5), (left + pixel(wide), middle + 5)];
        area.draw(&Rectangle::new(frame, INK.mix(0.08).filled()))?;
        let filled = [(left, middle - 5), (left + pixel(long.max(1)), middle + 5)];
        area.draw(&Rectangle::new(filled, colour.filled()))?;
        let style = small(FONT).pos(Pos::new(HPos::Left, VPos::Center));
        area.draw(&Text::new(percent(count, of), (left + pixel(wide) + 6, middle), style))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(backend: &str, time: f64, wrong: u64) -> Point {
        Point {
            backend: backend.into(),
            time: Some(time),
            errors: [wrong, 1_000_000],
            not_done: [0, 1_000_000],
            ..Point::default()
        }
    }

    fn drawn(points: Vec<Point>) -> String {
        let of = Tradeoff { per: 1e6, y: "wrong".into(), x: "time".into(), points, ..Tradeoff::default() };
        tradeoff(&of).unwrap().unwrap().svg
    }

    #[test]
    fn a_backend_that_left_things_undone_has_a_bar() {
        let svg = drawn(vec![point("exact", 1.5, 0), point("naive", 1.0, 20)]);
        assert!(!svg.contains("not done"));
        let lazy = Point { not_done: [250_000, 1_000_000], ..point("tolerance", 1.2, 0) };
        let svg = drawn(vec![point("exact", 1.5, 0), lazy.clone()]);
        assert!(svg.contains("not done") && svg.contains("25.0 %"), "{svg}");
        // Without a time the backend has no mark, but the bar stays.
        let svg = drawn(vec![point("exact", 1.5, 0), Point { time: None, ..lazy }]);
        assert_eq!((svg.matches("<circle").count(), svg.contains("25.0 %")), (1, true), "{svg}");
    }

    #[test]
    fn colours_go_by_name_whoever_else_is_there() {
        let colour = |svg: &str, name: &str| {
            let text = svg.split("<text ").find(|text| text.contains(&format!("\n{name}\n"))).expect("its label");
            text.split("fill=\"").nth(1).unwrap()[..7].to_owned()
        };
        let alone = drawn(vec![point("shewchuk", 1.5, 3)]);
        let last = drawn(vec![point("exact", 1.5, 0), point("naive", 1.0, 20), point("shewchuk", 1.5, 3)]);
        assert_eq!(colour(&alone, "shewchuk"), colour(&last, "shewchuk"));
        assert_ne!(colour(&last, "exact"), colour(&last, "shewchuk"));
    }

    #[test]
    fn only_a_curve_joins_points() {
        let knob = |time, wrong| Point { curve: Some("epsilon".into()), ..point("epsilon:1e-10", time, wrong) };
        let lines = |svg: &str| svg.matches("<polyline").count();
        let apart = drawn(vec![point("tolerance", 1.0, 5), point("tolerance:f32", 0.8, 9)]);
        let joined = drawn(vec![knob(1.0, 5), knob(0.8, 9)]);
        assert_eq!(lines(&joined), lines(&apart) + 1);
    }

    #[test]
    fn a_broken_law_crosses_the_mark_and_what_was_never_timed_has_no_plot() {
        let plain = drawn(vec![point("sos", 1.0, 0)]);
        let marked = drawn(vec![Point { is_marked: true, ..point("sos", 1.0, 0) }]);
        assert_ne!(plain, marked);
        let untimed =
            Tradeoff { per: 1e6, points: vec![Point { time: None, ..point("sos", 1.0, 0) }], ..Tradeoff::default() };
        assert_eq!(tradeoff(&untimed), Ok(None));
    }
}
