//! One quantity over another, on logarithmic axes, a line for each of several.

use plotters::prelude::*;

use super::{COLOURS, Decades, Drawn, INK, failed, page, power_of_ten, quiet, small};
use crate::Error;

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

/// Lines as an SVG picture; none where no point has logarithms.
///
/// # Errors
/// If the picture can't be drawn.
pub fn curves(curves: &Curves) -> Result<Option<String>, Error> {
    let points = || curves.curves.iter().flat_map(|curve| curve.points.iter().filter_map(logarithms));
    if points().next().is_none() {
        return Ok(None);
    }
    let span = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        low.floor()..high.ceil().max(low.floor() + 1.0)
    };
    let (x, y) = (span(&mut points().map(|p| p.0)), span(&mut points().map(|p| p.1)));
    let mut svg = String::new();
    draw(&mut svg, curves, (Decades(x), Decades(y))).map_err(failed)?;
    Ok(Some(page(&svg)))
}

fn logarithms(&(x, y): &(f64, f64)) -> Option<(f64, f64)> {
    let point = (x.log10(), y.log10());
    (point.0.is_finite() && point.1.is_finite()).then_some(point)
}

fn draw(svg: &mut String, curves: &Curves, (x, y): (Decades, Decades)) -> Drawn {
    let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
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
        chart
            .draw_series(LineSeries::new(points, colour.stroke_width(2)))?
            .label(&curve.name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
    }
    chart.configure_series_labels().label_font(small(FONT)).border_style(INK.mix(0.2)).draw()?;
    root.present()
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let svg = curves(&lines).unwrap().unwrap();
        assert!(["one", "two", "angle", "error"].iter().all(|text| svg.contains(text)));
        let points =
            svg.lines().filter(|line| line.contains("<polyline") && line.contains("stroke-width=\"2\"")).count();
        assert!(points >= 2, "two lines: {svg}");
        let nothing = Curves { curves: vec![curve("one", &[(0.0, 1.0)])], ..lines };
        assert_eq!(curves(&nothing), Ok(None));
    }
}
