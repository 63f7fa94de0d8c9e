//! One quantity over another, on logarithmic axes, a line for each of several.

use std::ops::Range;

use plotters::prelude::*;

use super::{COLOURS, Decades, Drawing, Drawn, INK, failed, power_of_ten, quiet, small};
use crate::{Error, Picture};

const SIZE: (u32, u32) = (760, 380);

/// Of letters.
const FONT: u32 = 12;

/// A line.
#[derive(Clone, PartialEq, Debug)]
pub struct Curve {
    /// Its name.
    pub name: String,
    /// Its points; those with a coordinate that has no logarithm are left out.
    pub points: Vec<(f64, f64)>,
}

/// Lines with what their axes mean.
#[derive(Clone, PartialEq, Debug)]
pub struct Curves {
    /// The horizontal axis.
    pub x: String,
    /// The vertical axis.
    pub y: String,
    /// The lines.
    pub curves: Vec<Curve>,
}

/// Lines as a picture; none where no point has logarithms.
///
/// # Errors
/// If the picture can't be drawn.
pub fn curves(curves: &Curves) -> Result<Option<Picture>, Error> {
    let points = || curves.curves.iter().flat_map(|curve| curve.points.iter().filter_map(logarithms));
    if points().next().is_none() {
        return Ok(None);
    }
    let span = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        low.floor()..high.ceil().max(low.floor() + 1.0)
    };
    let (x, y) = (span(&mut points().map(|p| p.0)), span(&mut points().map(|p| p.1)));
    let mut drawing = Drawing::default();
    let corner = free_corner(curves, [&x, &y]);
    draw(&mut drawing, curves, (Decades::from(x), Decades::from(y)), corner).map_err(failed)?;
    Ok(Some(drawing.picture()?))
}

fn logarithms(&(x, y): &(f64, f64)) -> Option<(f64, f64)> {
    let point = (x.log10(), y.log10());
    (point.0.is_finite() && point.1.is_finite()).then_some(point)
}

/// The corner that the lines pass the least, for their names.
fn free_corner(curves: &Curves, [x, y]: [&Range<f64>; 2]) -> SeriesLabelPosition {
    const STEPS: u32 = 16;
    // For each corner, the parts of lines in the quarter of the picture there.
    let mut passed = [0_u32; 4];
    let place = |range: &Range<f64>, at: f64| usize::from(at > f64::midpoint(range.start, range.end));
    for curve in &curves.curves {
        let mut points: Vec<(f64, f64)> = curve.points.iter().filter_map(logarithms).collect();
        if let [only] = points[..] {
            points.push(only);
        }
        for pair in points.windows(2) {
            for step in 0..=STEPS {
                let part = f64::from(step) / f64::from(STEPS);
                let between = |a: f64, b: f64| a + part * (b - a);
                passed[2 * place(y, between(pair[0].1, pair[1].1)) + place(x, between(pair[0].0, pair[1].0))] += 1;
            }
        }
    }
    let corners = [
        (passed[3], SeriesLabelPosition::UpperRight),
        (passed[1], SeriesLabelPosition::LowerRight),
        (passed[2], SeriesLabelPosition::UpperLeft),
        (passed[0], SeriesLabelPosition::LowerLeft),
    ];
    corners.into_iter().min_by_key(|(passed, _)| *passed).map_or(SeriesLabelPosition::UpperRight, |(_, corner)| corner)
}

fn draw(drawing: &mut Drawing, curves: &Curves, (x, y): (Decades, Decades), corner: SeriesLabelPosition) -> Drawn {
    let root = drawing.area(SIZE);
    let mut chart =
        ChartBuilder::on(&root).margin(14).x_label_area_size(40).y_label_area_size(60).build_cartesian_2d(x, y)?;
    let mut mesh = chart.configure_mesh();
    quiet(&mut mesh, FONT);
    mesh.x_label_formatter(&|x| power_of_ten(*x))
        .y_label_formatter(&|y| power_of_ten(*y))
        .x_desc(&curves.x)
        .y_desc(&curves.y)
        .draw()?;
    for (curve, colour) in curves.curves.iter().zip(COLOURS.iter().cycle()) {
        let points: Vec<_> = curve.points.iter().filter_map(logarithms).collect();
        // A line of one point is not to be seen without a mark.
        chart.draw_series(points.iter().map(|&point| Circle::new(point, 3, colour.filled())))?;
        chart
            .draw_series(LineSeries::new(points, colour.stroke_width(2)))?
            .label(&curve.name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
    }
    chart.configure_series_labels().position(corner).label_font(small(FONT)).border_style(INK.mix(0.2)).draw()?;
    root.present()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_where_no_line_is() {
        let line = |points: &[(f64, f64)]| Curves {
            x: "n".into(),
            y: "ns".into(),
            curves: vec![Curve { name: "one".into(), points: points.to_vec() }],
        };
        let place = |points: &[(f64, f64)]| {
            let svg = curves(&line(points)).unwrap().unwrap().svg;
            let name = svg.split("<text ").find(|text| text.contains("\none\n")).expect("its name");
            let at = |key: &str| name.split(key).nth(1).unwrap().split('"').nth(1).unwrap().parse::<u32>().unwrap();
            [at("x=") > SIZE.0 / 2, at("y=") > SIZE.1 / 2]
        };
        assert_eq!(place(&[(1.0, 2.0), (1e4, 3.0)]), [true, false], "the line is low");
        assert_eq!(place(&[(1.0, 2.0), (10.0, 90.0), (1e4, 99.0)]), [true, true], "it is high");
        assert_eq!(place(&[(1e3, 1.0), (1e3, 99.0), (1.0, 1.0)]), [false, false], "it is on the right");
    }

    #[test]
    fn lines_are_named_and_what_has_no_logarithm_is_left_out() {
        let curve = |name: &str, points: &[(f64, f64)]| Curve { name: name.into(), points: points.to_vec() };
        let lines = Curves {
            x: "angle".into(),
            y: "error".into(),
            curves: vec![
                curve("one", &[(1e-3, 0.0), (1e-2, 1e-5), (0.1, 1e-4)]),
                curve("two", &[(1e-2, 0.5), (1.0, 0.1)]),
            ],
        };
        let svg = curves(&lines).unwrap().unwrap().svg;
        assert!(["one", "two", "angle", "error"].iter().all(|text| svg.contains(text)));
        let points =
            svg.lines().filter(|line| line.contains("<polyline") && line.contains("stroke-width=\"2\"")).count();
        assert!(points >= 2, "two lines: {svg}");
        assert_eq!(svg.matches("<circle").count(), 4, "a mark for each point: {svg}");
        let nothing = Curves { curves: vec![curve("one", &[(0.0, 1.0)])], ..lines };
        assert_eq!(curves(&nothing), Ok(None));
    }
}
