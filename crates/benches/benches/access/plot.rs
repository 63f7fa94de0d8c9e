//! Times over sizes of scenes, as a picture.

use std::path::PathBuf;

use plotters::prelude::*;

/// Nanoseconds a query over the number of vertices.
pub struct Line {
    pub predicate: &'static str,
    pub family: &'static str,
    pub engine: &'static str,
    pub points: Vec<(f64, f64)>,
}

/// Draws a panel for each predicate and family into `target/exact-access-sizes.svg`, and says where that is.
pub fn draw(lines: &[Line]) {
    let mut panels: Vec<(&str, &str)> = Vec::new();
    for line in lines {
        if !panels.contains(&(line.predicate, line.family)) {
            panels.push((line.predicate, line.family));
        }
    }
    if panels.is_empty() {
        return;
    }
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../target/exact-access-sizes.svg");
    let root =
        SVGBackend::new(&path, (960, 260 * u32::try_from(panels.len().div_ceil(2)).expect("few"))).into_drawing_area();
    root.fill(&WHITE).expect("drawn");
    for (area, (predicate, family)) in root.split_evenly((panels.len().div_ceil(2), 2)).iter().zip(panels) {
        let here: Vec<&Line> = lines.iter().filter(|l| (l.predicate, l.family) == (predicate, family)).collect();
        let all = || here.iter().flat_map(|line| &line.points);
        let most = all().fold(0.0, |most: f64, p| most.max(p.1));
        let least = all().fold(f64::INFINITY, |least: f64, p| least.min(p.1));
        let mut chart = ChartBuilder::on(area)
            .caption(format!("{predicate}, {family}: ns a query over vertices"), ("sans-serif", 15))
            .margin(8)
            .x_label_area_size(24)
            .y_label_area_size(44)
            .build_cartesian_2d((10.0..1e7).log_scale(), (least * 0.7..most * 1.5).log_scale())
            .expect("drawn");
        chart.configure_mesh().disable_mesh().x_labels(7).draw().expect("drawn");
        for line in here {
            let place = ["robust", "fpg", "single", "batch", "raw"].iter().position(|name| *name == line.engine);
            // Okabe and Ito's colours.
            let colour = [
                RGBColor(0, 0, 0),
                RGBColor(230, 159, 0),
                RGBColor(0, 114, 178),
                RGBColor(0, 158, 115),
                RGBColor(204, 121, 167),
            ][place.expect("an engine")];
            let drawn =
                chart.draw_series(LineSeries::new(line.points.iter().copied(), colour.stroke_width(2))).expect("drawn");
            drawn
                .label(line.engine)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], colour.stroke_width(2)));
        }
        let place = SeriesLabelPosition::UpperLeft;
        chart.configure_series_labels().position(place).background_style(WHITE.mix(0.8)).draw().expect("drawn");
    }
    root.present().expect("written");
    println!("sizes: {}", path.display());
}
