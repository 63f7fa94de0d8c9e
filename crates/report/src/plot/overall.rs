//! The plot of the first screen: what backends cost beside a reference against what they get wrong, over all tasks together.
//!
//! Only backends that did the same are in it, so that it compares like with like. Zero has no logarithm: what is never wrong stands on a
//! shelf at the bottom, with the interval of its rate above it.

use plotters::prelude::*;
use predicament_records::format::significant;
use predicament_records::wilson;

use super::labels::{Label, names};
use super::{COLOURS, Decades, Drawn, INK, Recording, failed, frontier, power_of_ten, quiet};
use crate::figures::{Price, all_prices};
use crate::groups::{REFERENCE, backends};
use crate::{Error, Picture, RunDir};

const SIZE: (u32, u32) = (640, 340);

/// Times over the reference's against wrong answers per million with Wilson's interval at 95 %, as a picture; none where
/// fewer than two backends are compared.
///
/// # Errors
/// If the picture can't be drawn.
pub fn overall(runs: &[RunDir]) -> Result<Option<Picture>, Error> {
    beside(runs, &[])
}

/// [`overall`] with the marks of earlier runs as rings, each with a line to where its backend is now; none if these have no marks.
///
/// # Errors
/// If the picture can't be drawn.
pub fn beside(runs: &[RunDir], earlier: &[RunDir]) -> Result<Option<Picture>, Error> {
    let (now, before) = (all_prices(runs), all_prices(earlier));
    let [marks, ghosts] = [now.as_ref(), before.as_ref()].map(|prices| -> Vec<Mark> {
        let prices = prices.into_iter().flat_map(|of| &of.prices);
        prices.filter(|price| !price.is_partial).filter_map(Mark::of).collect()
    });
    if marks.len() < 2 || ghosts.is_empty() && !earlier.is_empty() {
        return Ok(None);
    }
    let mut recording = Recording::default();
    draw(&mut recording, &marks, &ghosts, &backends(runs)).map_err(failed)?;
    Ok(Some(recording.picture()?))
}

/// Logarithms of a backend's time and of its rate of wrong answers.
struct Mark<'r> {
    backend: &'r str,
    time: f64,
    /// None on the shelf.
    rate: Option<f64>,
    /// From where to where the rate may be; from none on the shelf.
    interval: (Option<f64>, f64),
}

impl<'r> Mark<'r> {
    fn of(price: &Price<'r>) -> Option<Mark<'r>> {
        let (wrong, queries) = (price.errors.wrong.min(price.errors.queries), price.errors.queries);
        let [low, high] = wilson(wrong, queries).map(|share| (1e6 * share).log10());
        #[allow(clippy::cast_precision_loss)] // a share, for a picture
        let rate = (wrong > 0).then(|| (1e6 * wrong as f64 / queries as f64).log10());
        let interval = (rate.is_some().then_some(low), high);
        (queries > 0 && price.ratio > 0.0).then(|| Mark {
            backend: price.backend,
            time: price.ratio.log10(),
            rate,
            interval,
        })
    }
}

fn draw(recording: &mut Recording, marks: &[Mark], ghosts: &[Mark], order: &[&str]) -> Drawn {
    let fold = |values: &mut dyn Iterator<Item = f64>| {
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    };
    let both = || marks.iter().chain(ghosts);
    let (fastest, slowest) = fold(&mut both().map(|mark| mark.time));
    let (least, most) = fold(&mut both().flat_map(|mark| mark.interval.0.into_iter().chain([mark.interval.1])));
    let shelf = least.floor() - 1.0;
    let (left, right) = (fastest.min(0.0) - 0.15, slowest.max(0.0) + 0.15);
    let (bottom, top) = (shelf - 0.5, (most + 0.1).ceil());
    let root = recording.area(SIZE);
    let mut chart = ChartBuilder::on(&root)
        .margin(10)
        .margin_right(180)
        .x_label_area_size(40)
        .y_label_area_size(60)
        .build_cartesian_2d(Decades::finely(left..right), Decades::from(bottom..top))?;
    let mut mesh = chart.configure_mesh();
    quiet(&mut mesh, 12);
    let label = |y: &f64| if *y <= shelf { "0".to_owned() } else { power_of_ten(*y) };
    mesh.x_label_formatter(&|x| format!("{}×", significant(10_f64.powf(*x), 1)))
        .y_label_formatter(&label)
        .x_desc(format!("time of a query over {REFERENCE}'s"))
        .y_desc("wrong answers per million")
        .draw()?;
    chart.draw_series([Rectangle::new([(left, bottom), (right, shelf + 0.5)], INK.mix(0.05).filled())])?;
    let places = marks.iter().map(|mark| (mark.time, mark.rate.unwrap_or(shelf)));
    frontier(&mut chart, places.collect(), (right, top))?;
    let mut labels = Vec::new();
    for mark in marks {
        let colour = COLOURS[order.iter().position(|b| *b == mark.backend).unwrap_or(0) % COLOURS.len()];
        let place = (mark.time, mark.rate.unwrap_or(shelf));
        let low = (mark.time, mark.interval.0.unwrap_or(shelf));
        chart.draw_series([PathElement::new(
            vec![low, (mark.time, mark.interval.1)],
            colour.mix(0.5).stroke_width(2),
        )])?;
        if let Some(ghost) = ghosts.iter().find(|ghost| ghost.backend == mark.backend) {
            let before = (ghost.time, ghost.rate.unwrap_or(shelf));
            chart.draw_series([PathElement::new(vec![before, place], colour.stroke_width(1))])?;
            chart.draw_series([Circle::new(before, 7, colour.stroke_width(1))])?;
        }
        chart.draw_series([Circle::new(place, 5, colour.filled())])?;
        labels.push(Label::new(mark.backend.to_owned(), chart.backend_coord(&place), colour));
    }
    let (x_range, y_range) = chart.plotting_area().get_pixel_range();
    names(&root, labels, x_range.end, y_range)?;
    root.present()
}
