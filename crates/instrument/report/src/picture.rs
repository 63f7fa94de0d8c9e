//! Pictures of a finding: its points to scale, and once more with nearly coincident points pulled apart.
//!
//! Near a degeneracy a picture to scale shows only three points on a line. The second picture has a separate scale
//! across the line, or across the circle, so that the side of each point is visible. Bars show both scales.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::Error;
use crate::plot::{Area, Drawn, INK, Recording, failed};
use predicament_records::format::significant;

const SIZE: (u32, u32) = (360, 240);
/// The margin around a picture, in pixels.
const ROOM: f64 = 34.0;
/// The length of a scale bar, in pixels.
const BAR: i32 = 60;

/// The colours of points: of the last point, which is the query's, and of the others.
const LAST: RGBColor = RGBColor(213, 94, 0);
const OTHERS: RGBColor = RGBColor(46, 134, 204);

/// A point with its name.
#[derive(Clone, PartialEq, Debug)]
pub struct Named {
    /// The name.
    pub name: String,
    /// The place of the point.
    pub at: [f64; 2],
}

/// Draws points to scale, in the order of the query, with a circle by its centre and its radius, if there is one.
///
/// # Errors
/// If the picture can't be drawn.
pub fn to_scale(points: &[Named], circle: Option<([f64; 2], f64)>) -> Result<String, Error> {
    let mut all: Vec<[f64; 2]> = points.iter().map(|point| point.at).collect();
    if let Some((centre, radius)) = circle {
        all.extend([-1.0, 1.0].map(|sign| centre.map(|x| x + sign * radius)));
    }
    let view = View::of(&all, true);
    draw(|root| {
        if let Some((centre, radius)) = circle {
            let round = |step: u32| {
                let angle = std::f64::consts::TAU * f64::from(step) / 96.0;
                view.place([centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()])
            };
            root.draw(&PathElement::new((0..=96).map(round).collect::<Vec<_>>(), INK.mix(0.4)))?;
        } else {
            root.draw(&PathElement::new(points.iter().map(|p| view.place(p.at)).collect::<Vec<_>>(), INK.mix(0.4)))?;
        }
        view.bar(root, 0, "")?;
        marks(root, &view, points)
    })
}

/// Draws points by their positions along a line or a circle and across it, each with a separate scale; a point at zero
/// across is on it.
///
/// # Errors
/// If the picture can't be drawn.
pub fn pulled_apart(points: &[Named], on: &str) -> Result<String, Error> {
    let mut all: Vec<[f64; 2]> = points.iter().map(|point| point.at).collect();
    let low = all.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
    all.push([low, 0.0]);
    let view = View::of(&all, false);
    draw(|root| {
        let (_, zero) = view.place([low, 0.0]);
        let right = i32::try_from(SIZE.0).unwrap_or(i32::MAX);
        root.draw(&PathElement::new(vec![(0, zero), (right, zero)], INK.mix(0.4)))?;
        let style = ("sans-serif", 11).into_font().color(&INK).pos(Pos::new(HPos::Right, VPos::Bottom));
        root.draw(&Text::new(
            format!("horizontal: {on}"),
            (right - 4, i32::try_from(SIZE.1).unwrap_or(i32::MAX) - 3),
            style,
        ))?;
        view.bar(root, 0, " along")?;
        view.bar(root, 1, " across")?;
        marks(root, &view, points)
    })
}

fn draw(content: impl FnOnce(&Area) -> Drawn) -> Result<String, Error> {
    let mut recording = Recording::default();
    content(&recording.area(SIZE)).map_err(failed)?;
    recording.svg()
}

fn marks(root: &Area, view: &View, points: &[Named]) -> Drawn {
    let mut taken: Vec<(i32, i32)> = Vec::new();
    for (at, point) in points.iter().enumerate() {
        // The last point, which is the query's, is highlighted.
        let colour = if at + 1 == points.len() { LAST } else { OTHERS };
        let place = view.place(point.at);
        root.draw(&Circle::new(place, 4, colour.filled()))?;
        // Names of points at one place are put below each other; names at the right edge go to the left of their
        // points.
        let is_left = place.0 + 60 > i32::try_from(SIZE.0).unwrap_or(i32::MAX);
        let mut name = (if is_left { place.0 - 7 } else { place.0 + 7 }, place.1 - 7);
        while taken.iter().any(|other| (other.0 - name.0).abs() < 60 && (other.1 - name.1).abs() < 13) {
            name.1 += 13;
        }
        taken.push(name);
        let side = if is_left { HPos::Right } else { HPos::Left };
        let style = ("sans-serif", 12).into_font().color(&colour).pos(Pos::new(side, VPos::Center));
        root.draw(&Text::new(point.name.clone(), name, style))?;
    }
    Ok(())
}

/// The map from coordinates to pixels.
struct View {
    middle: [f64; 2],
    /// The scale in pixels per unit.
    scale: [f64; 2],
}

impl View {
    fn of(points: &[[f64; 2]], is_square: bool) -> View {
        let ends = [0, 1].map(|axis: usize| {
            let all = || points.iter().map(|p| p[axis]);
            [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)]
        });
        let room = [f64::from(SIZE.0) - 2.0 * ROOM, f64::from(SIZE.1) - 2.0 * ROOM];
        let scale = [0, 1].map(|axis: usize| {
            let extent = ends[axis][1] - ends[axis][0];
            if extent > 0.0 { room[axis] / extent } else { f64::INFINITY }
        });
        let least = scale[0].min(scale[1]);
        let scale = scale.map(|own| if is_square || !own.is_finite() { least } else { own });
        let scale = scale.map(|own| if own.is_finite() { own } else { 1.0 });
        View { middle: ends.map(|[low, high]| f64::midpoint(low, high)), scale }
    }

    fn place(&self, p: [f64; 2]) -> (i32, i32) {
        #[allow(clippy::cast_possible_truncation)] // pixels
        let pixel = |x: f64| x.round().clamp(-10_000.0, 10_000.0) as i32;
        let along = |axis: usize| (p[axis] - self.middle[axis]) * self.scale[axis];
        (pixel(f64::from(SIZE.0) / 2.0 + along(0)), pixel(f64::from(SIZE.1) / 2.0 - along(1)))
    }

    /// Draws a scale bar and its length along an axis.
    fn bar(&self, root: &Area, axis: usize, what: &str) -> Drawn {
        let bottom = i32::try_from(SIZE.1).unwrap_or(i32::MAX) - 8;
        let text = format!("{}{what}", length(f64::from(BAR) / self.scale[axis]));
        let (ends, at) = if axis == 0 {
            (vec![(20, bottom), (20 + BAR, bottom)], (26 + BAR, bottom))
        } else {
            (vec![(8, bottom - BAR), (8, bottom)], (14, bottom - BAR + 4))
        };
        root.draw(&PathElement::new(ends, INK.stroke_width(2)))?;
        let style = ("sans-serif", 11).into_font().color(&INK).pos(Pos::new(HPos::Left, VPos::Center));
        root.draw(&Text::new(text, at, style))
    }
}

/// A length with two significant digits.
fn length(x: f64) -> String {
    if (1e-3..1e6).contains(&x) { significant(x, 2) } else { format!("{x:.1e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str, at: [f64; 2]) -> Named {
        Named { name: name.to_owned(), at }
    }

    #[test]
    fn what_is_nearly_on_a_line_is_seen_beside_it() {
        let points = [named("a", [0.0, 0.0]), named("b", [1.0, 0.0]), named("c", [0.5, 1e-17])];
        let all: Vec<[f64; 2]> = points.iter().map(|p| p.at).collect();
        let [flat, apart] = [true, false].map(|is_square| {
            let view = View::of(&all, is_square);
            view.place(points[0].at).1 - view.place(points[2].at).1
        });
        assert_eq!(flat, 0);
        assert!(apart > 100, "{apart}");
        let svg = pulled_apart(&points, "line a b").unwrap();
        assert!(svg.contains("line a b") && svg.contains("across") && svg.contains("\nc\n"), "{svg}");
        assert!(to_scale(&points, None).unwrap().contains("\na\n"));
    }

    #[test]
    fn one_place_and_no_extent_are_drawn_too() {
        let points = [named("a", [3.0, 3.0]), named("b", [3.0, 3.0])];
        assert!(to_scale(&points, None).unwrap().contains("\nb\n"));
        assert!(to_scale(&points, Some(([3.0, 3.0], 0.0))).is_ok());
    }
}
