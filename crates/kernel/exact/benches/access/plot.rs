//! A plot of times over sizes of scenes.

use std::path::PathBuf;

use plotters::prelude::*;

/// The time of an engine in nanoseconds per query, over the number of vertices.
pub struct Line {
    pub predicate: &'static str,
    pub family: &'static str,
    pub engine: &'static str,
    pub points: Vec<(f64, f64)>,
}

/// The engines, in Okabe and Ito's colours.
const ENGINES: [(&str, RGBColor); 5] = [
    ("robust", RGBColor(0, 0, 0)),
    ("fpg", RGBColor(230, 159, 0)),
    ("single", RGBColor(0, 114, 178)),
    ("batch", RGBColor(0, 158, 115)),
    ("raw", RGBColor(204, 121, 167)),
];

/// Draws a panel for each predicate and family into `target/exact-access-sizes.svg`, and prints the path.
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
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../target/exact-access-sizes.svg");
    let rows = panels.len().div_ceil(2);
    let root = SVGBackend::new(&path, (960, 30 + 260 * u32::try_from(rows).expect("few"))).into_drawing_area();
    root.fill(&WHITE).expect("drawn");
    let (legend, plots) = root.split_vertically(30);
    for ((name, colour), at) in ENGINES.iter().zip(0..) {
        let x = 60 + 120 * at;
        legend.draw(&PathElement::new([(x, 16), (x + 24, 16)], colour.stroke_width(3))).expect("drawn");
        legend.draw(&Text::new(*name, (x + 30, 9), ("sans-serif", 15))).expect("drawn");
    }
    for (area, (predicate, family)) in plots.split_evenly((rows, 2)).iter().zip(panels) {
        let here: Vec<&Line> = lines.iter().filter(|l| (l.predicate, l.family) == (predicate, family)).collect();
        let all = || here.iter().flat_map(|line| &line.points);
        let most = all().fold(0.0, |most: f64, p| most.max(p.1));
        let least = all().fold(f64::INFINITY, |least: f64, p| least.min(p.1));
        let mut chart = ChartBuilder::on(area)
            .caption(format!("{predicate}, {family}: ns a query over vertices"), ("sans-serif", 15))
            .margin(8)
            .margin_right(28)
            .x_label_area_size(24)
            .y_label_area_size(44)
            .build_cartesian_2d((10.0..1e7).log_scale(), (least * 0.7..most * 1.5).log_scale())
            .expect("drawn");
        chart
            .configure_mesh()
            .disable_mesh()
            .x_labels(7)
            .y_labels(5)
            .x_label_formatter(&|x: &f64| format!("10^{:.0}", x.log10()))
            .y_label_formatter(&|y: &f64| format!("{y:.0}"))
            .draw()
            .expect("drawn");
        for line in here {
            let (_, colour) = ENGINES.iter().find(|(name, _)| *name == line.engine).expect("an engine");
            chart.draw_series(LineSeries::new(line.points.iter().copied(), colour.stroke_width(2))).expect("drawn");
        }
    }
    root.present().expect("written");
    println!("sizes: {}", path.display());
}
