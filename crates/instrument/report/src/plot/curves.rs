//! Plots of one quantity over another, on logarithmic axes, with a line for each series.

use std::ops::Range;

use plotters::prelude::*;
use serde_json::{Value, json};

use super::palette::{colours, hex};
use super::{Decades, Drawn, Recording, failed, power_of_ten, quiet, small};
use crate::{Error, Picture};

const SIZE: (u32, u32) = (760, 380);

/// The size of letters.
const FONT: u32 = 12;
/// The sizes of the legend: left margin, line sample, maximum letter width, gap between names, and row height.
const LEFT: u32 = 74;
const SAMPLE: u32 = 24;
const LETTER: u32 = 7;
const GAP: u32 = 16;
const ROW: u32 = 17;

/// A line of a plot.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Curve {
    /// The line's name.
    pub name: String,
    /// The points; a point without logarithms is left out. A line without points appears only by its name, which says
    /// that it has no data.
    pub points: Vec<(f64, f64)>,
    /// True if the line is the upper end of a band, and all below it is shaded.
    pub is_band: bool,
    /// Vertical bars through points, each as position, lower end and upper end.
    pub bars: Vec<(f64, f64, f64)>,
}

impl Curve {
    /// A line with this name and these points.
    pub fn new(name: impl Into<String>, points: impl Into<Vec<(f64, f64)>>) -> Curve {
        Curve { name: name.into(), points: points.into(), ..Curve::default() }
    }

    /// The line as the upper end of a band.
    #[must_use]
    pub fn band(self) -> Curve {
        Curve { is_band: true, ..self }
    }

    /// The line with vertical bars through its points, each as position, lower end and upper end.
    #[must_use]
    pub fn bars(self, bars: impl IntoIterator<Item = (f64, f64, f64)>) -> Curve {
        Curve { bars: bars.into_iter().collect(), ..self }
    }
}

/// Lines with the titles of their axes.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Curves {
    /// The title of the horizontal axis.
    pub x: String,
    /// The title of the vertical axis.
    pub y: String,
    /// The lines.
    pub curves: Vec<Curve>,
    /// The scale of the horizontal axis.
    pub spread: XAxis,
}

/// The scale of a horizontal axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum XAxis {
    /// A logarithmic scale: equal factors have equal distances.
    #[default]
    Logarithmic,
    /// A linear scale: equal differences have equal distances; for exponents and for negative positions.
    Linear,
}

impl XAxis {
    /// The position of a number on the scale, if it has one: its decimal logarithm, or the number itself.
    fn place(self, x: f64) -> Option<f64> {
        let place = match self {
            XAxis::Logarithmic => x.log10(),
            XAxis::Linear => x,
        };
        place.is_finite().then_some(place)
    }
}

/// Draws lines as a picture; `None` if no point has a logarithm.
///
/// # Errors
/// If the picture can't be drawn.
pub fn curves(curves: &Curves) -> Result<Option<Picture>, Error> {
    let points = || curves.curves.iter().flat_map(|curve| curves.places(curve).chain(curves.bars(curve).flatten()));
    if points().next().is_none() {
        return Ok(None);
    }
    let span = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        low.floor()..high.ceil().max(low.floor() + 1.0)
    };
    let y = span(&mut points().map(|p| p.1));
    let x = match curves.spread {
        XAxis::Logarithmic => span(&mut points().map(|p| p.0)),
        XAxis::Linear => {
            let all = || points().map(|p| p.0);
            let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
            low..if high > low { high } else { low + 1.0 }
        }
    };
    let mut recording = Recording::default();
    draw(&mut recording, curves, (axis(curves.spread, x), Decades::from(y))).map_err(failed)?;
    let mut picture = recording.picture()?;
    carry(&mut picture.svg, curves);
    Ok(Some(picture))
}

/// Adds the numbers of the lines to the picture, as its metadata: a page makes an interactive plot of them.
fn carry(svg: &mut String, curves: &Curves) {
    let colours = colours(curves.curves.iter().map(|curve| curve.name.as_str()));
    let line = |(curve, colour): (&Curve, RGBColor)| {
        let points: Vec<[f64; 2]> =
            curve.points.iter().filter(|&point| curves.place(point).is_some()).map(|&(x, y)| [x, y]).collect();
        json!({ "name": curve.name, "points": points, "band": curve.is_band, "colour": hex(colour) })
    };
    let lines: Vec<Value> = curves.curves.iter().zip(colours).map(line).collect();
    let data =
        json!({ "x": curves.x, "y": curves.y, "linear": curves.spread == XAxis::Linear, "curves": lines }).to_string();
    // Escape JSON as text of XML.
    let data = data.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    if let Some(end) = svg.find('>') {
        svg.insert_str(end + 1, &format!("<metadata>{data}</metadata>"));
    }
}

impl Curves {
    /// The position of a point in the plot; `None` if a coordinate has no logarithm.
    fn place(&self, &(x, y): &(f64, f64)) -> Option<(f64, f64)> {
        Some((self.spread.place(x)?, XAxis::Logarithmic.place(y)?))
    }

    fn places<'c>(&'c self, curve: &'c Curve) -> impl Iterator<Item = (f64, f64)> + 'c {
        curve.points.iter().filter_map(|point| self.place(point))
    }

    /// The two ends of each bar.
    fn bars<'c>(&'c self, curve: &'c Curve) -> impl Iterator<Item = [(f64, f64); 2]> + 'c {
        curve.bars.iter().filter_map(|&(x, low, high)| Some([self.place(&(x, low))?, self.place(&(x, high))?]))
    }
}

fn axis(spread: XAxis, range: Range<f64>) -> Decades {
    match spread {
        XAxis::Logarithmic => Decades::from(range),
        XAxis::Linear => Decades::linear(range),
    }
}

/// The names of lines in rows, as they fit side by side below the picture: the index of each line, and its start.
fn rows_of(curves: &[Curve]) -> Vec<Vec<(usize, u32)>> {
    let mut rows: Vec<Vec<(usize, u32)>> = vec![Vec::new()];
    let mut next = 0;
    for (at, curve) in curves.iter().enumerate() {
        let wide = SAMPLE + LETTER * u32::try_from(curve.name.chars().count()).unwrap_or(u32::MAX / LETTER / 2) + GAP;
        if next > 0 && next + wide > SIZE.0 - LEFT {
            rows.push(Vec::new());
            next = 0;
        }
        if let Some(row) = rows.last_mut() {
            row.push((at, next));
        }
        next += wide;
    }
    rows
}

fn draw(recording: &mut Recording, curves: &Curves, (x, y): (Decades, Decades)) -> Drawn {
    let floor = y.range.start;
    let rows = rows_of(&curves.curves);
    let below = ROW * u32::try_from(rows.len()).unwrap_or(0) + 6;
    let root = recording.area((SIZE.0, SIZE.1 + below));
    let (above, names) = root.split_vertically(SIZE.1);
    let mut chart =
        ChartBuilder::on(&above).margin(14).x_label_area_size(40).y_label_area_size(60).build_cartesian_2d(x, y)?;
    let mut mesh = chart.configure_mesh();
    quiet(&mut mesh, FONT);
    mesh.x_label_formatter(&|x| match curves.spread {
        XAxis::Logarithmic => power_of_ten(*x),
        XAxis::Linear => format!("{x}"),
    })
    .y_label_formatter(&|y| power_of_ten(*y))
    .x_desc(&curves.x)
    .y_desc(&curves.y)
    .draw()?;
    let palette = colours(curves.curves.iter().map(|curve| curve.name.as_str()));
    let colour = |at: usize| palette[at];
    for (at, curve) in curves.curves.iter().enumerate() {
        let points: Vec<_> = curves.places(curve).collect();
        if curve.is_band {
            chart.draw_series(AreaSeries::new(points.iter().copied(), floor, colour(at).mix(0.15)))?;
        }
        for bar in curves.bars(curve) {
            chart.draw_series(std::iter::once(PathElement::new(bar, colour(at).mix(0.5))))?;
        }
        // A line of one point is invisible without a mark.
        chart.draw_series(points.iter().map(|&point| Circle::new(point, 3, colour(at).filled())))?;
        chart.draw_series(LineSeries::new(points, colour(at).stroke_width(2)))?;
    }
    let pixel = |x: u32| i32::try_from(x).unwrap_or(i32::MAX);
    for (row, entries) in (0..).zip(&rows) {
        for &(at, start) in entries {
            let (x, y, curve) = (pixel(LEFT + start), row * pixel(ROW) + 8, &curves.curves[at]);
            if !curve.points.is_empty() {
                let sample = [(x, y), (x + 18, y)];
                names.draw(&PathElement::new(sample, colour(at).stroke_width(if curve.is_band { 7 } else { 2 })))?;
            }
            names.draw(&Text::new(curve.name.clone(), (x + pixel(SAMPLE), y - 5), small(FONT)))?;
        }
    }
    root.present()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Any number of names of any length are below all marks, within the picture, and apart from each other.
    #[test]
    fn names_overlap_nothing() {
        let name = |at: usize| format!("backend {at} {}", "x".repeat(at * 7 % 60));
        let lines: Vec<Curve> = (0..9).map(|at| Curve::new(name(at), [(1.0, 1.0), (1e4, 10.0)])).collect();
        let svg = curves(&Curves { curves: lines, ..Curves::default() }).unwrap().unwrap().svg;
        let at =
            |text: &str, key: &str| text.split(key).nth(1).unwrap().split('"').nth(1).unwrap().parse::<u32>().unwrap();
        let height = at(&svg, "height=");
        let texts: Vec<[u32; 3]> = (0..9)
            .map(|line| {
                let text =
                    svg.split("<text ").find(|text| text.contains(&format!("\n{}\n", name(line)))).expect("its name");
                let long = u32::try_from(name(line).len()).unwrap() * LETTER;
                [at(text, "x="), at(text, "x=") + long, at(text, "y=")]
            })
            .collect();
        assert!(texts.iter().all(|[_, end, y]| *end <= SIZE.0 && *y > SIZE.1 && *y < height), "{texts:?} in {height}");
        let apart = |a: &[u32; 3], b: &[u32; 3]| a[2].abs_diff(b[2]) >= FONT || a[1] <= b[0] || b[1] <= a[0];
        for (at, a) in texts.iter().enumerate() {
            assert!(texts[..at].iter().all(|b| apart(a, b)), "{texts:?}");
        }
    }

    #[test]
    fn lines_are_named_and_what_has_no_logarithm_is_left_out() {
        let curve = |name: &str, points: &[(f64, f64)]| Curve::new(name, points);
        let lines = Curves {
            x: "angle".into(),
            y: "error".into(),
            curves: vec![
                curve("one", &[(1e-3, 0.0), (1e-2, 1e-5), (0.1, 1e-4)]),
                curve("two", &[(1e-2, 0.5), (1.0, 0.1)]),
            ],
            ..Curves::default()
        };
        let svg = curves(&lines).unwrap().unwrap().svg;
        assert!(["one", "two", "angle", "error"].iter().all(|text| svg.contains(text)));
        let points =
            svg.lines().filter(|line| line.contains("<polyline") && line.contains("stroke-width=\"2\"")).count();
        assert!(points >= 2, "two lines: {svg}");
        assert_eq!(svg.matches("<circle").count(), 4, "a mark for each point: {svg}");
        let data = svg.split("<metadata>").nth(1).and_then(|rest| rest.split("</metadata>").next()).unwrap();
        let data: Value = serde_json::from_str(data).unwrap();
        let carried = json!([[1e-2, 1e-5], [0.1, 1e-4]]);
        assert_eq!((&data["curves"][0]["points"], &data["x"]), (&carried, &json!("angle")), "zero has no logarithm");
        let nothing = Curves { curves: vec![curve("one", &[(0.0, 1.0)])], ..lines };
        assert_eq!(curves(&nothing), Ok(None));
    }

    #[test]
    fn bars_are_drawn_whole() {
        let line = Curve::new("one", [(1.0, 10.0)]);
        let of = |line| curves(&Curves { curves: vec![line], ..Curves::default() }).unwrap().unwrap().svg;
        let count = |svg: &str| svg.matches("<line").count() + svg.matches("<polyline").count();
        let (bare, barred) = (of(line.clone()), of(line.bars([(1.0, 2.0, 300.0), (1.0, 0.0, 1.0)])));
        assert!(count(&barred) > count(&bare), "{barred}");
        // The axis reaches to the end of the bar, above its point.
        let highest = |svg: &str| svg.matches("\n1k\n").count();
        assert_eq!((highest(&bare), highest(&barred)), (0, 1), "{barred}");
    }

    #[test]
    fn exponents_are_spread_evenly() {
        let points = [(-50.0, 1.0), (0.0, 10.0), (50.0, 100.0)];
        let line = Curve::new("one", points);
        let lines = Curves { x: "log2".into(), y: "ns".into(), curves: vec![line], spread: XAxis::Linear };
        let svg = curves(&lines).unwrap().unwrap().svg;
        let x: Vec<f64> =
            svg.split("cx=\"").skip(1).map(|rest| rest.split('"').next().unwrap().parse().unwrap()).collect();
        assert!((x[1] - x[0] - (x[2] - x[1])).abs() <= 1.0, "{x:?}");
        assert!(svg.contains("\n-20\n") && svg.contains("\"linear\":true"), "{svg}");
    }
}
