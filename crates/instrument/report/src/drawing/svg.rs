//! Drawings as SVG: areas by the even-odd rule, lines, points and their names, a legend and a scale bar.
//!
//! In space areas are drawn from the farthest to the nearest (the painter's algorithm of Newell, Newell and Sancha) and
//! shaded by their angle to the view direction. If areas intersect, one is drawn over the other.

use std::fmt::Write as _;

use predicament_records::format::significant;

use super::projection::{dot, normal};
use super::{Drawing, Layer, Look, Offset, Role, Shape, Window};
use crate::plot::page;

/// The sides of the picture, in pixels.
const SIZE: [f64; 2] = [760.0, 560.0];
/// The margin around the drawing, in pixels.
const MARGIN: f64 = 28.0;
/// The maximum number of points that are drawn as large circles.
const FEW_POINTS: usize = 500;
/// The maximum number of layers with names in the picture.
const MOST_NAMES: usize = 12;
/// The height of a line of names, in pixels.
const LINE: f64 = 16.0;
/// The brightness of an area that is edge-on to the eye.
const AMBIENT: f64 = 0.45;

/// An item to draw.
struct Item {
    /// The depth: larger is nearer to the eye.
    depth: f64,
    text: String,
}

/// The map from offsets to pixels.
struct View {
    middle: Offset,
    axes: [Offset; 3],
    /// The scale in pixels per [`View::unit`].
    scale: f64,
    /// Half of the longest side. Offsets are divided by it first, to avoid overflow and underflow.
    unit: f64,
    /// The middle of the drawing, in pixels.
    centre: [f64; 2],
}

impl View {
    fn of(drawing: &Drawing, look: Look, window: Window, top: f64) -> View {
        let (middle, unit) = drawing.extent(window);
        let flat = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let axes = if drawing.is_space { look.axes() } else { flat };
        let mut view = View { middle, axes, scale: 1.0, unit, centre: [SIZE[0] / 2.0, f64::midpoint(top, SIZE[1])] };
        let reach = |axis: usize, room: f64| {
            let most = match window {
                Window::Around(_) => 1.0,
                Window::Whole => drawing.points().map(|&point| view.turned(point)[axis].abs()).fold(0.0, f64::max),
            };
            if most > 0.0 { (room / 2.0 - MARGIN) / most } else { f64::INFINITY }
        };
        let scale = reach(0, SIZE[0]).min(reach(1, SIZE[1] - top));
        view.scale = if scale.is_finite() { scale } else { 1.0 };
        view
    }

    /// The point's components to the right, up and towards the eye, in units.
    fn turned(&self, point: Offset) -> Offset {
        let from_middle = [0, 1, 2].map(|axis: usize| point[axis] / self.unit - self.middle[axis] / self.unit);
        self.axes.map(|axis| dot(axis, from_middle))
    }

    /// The point's components to the right and down, in pixels; a point far outside of the picture stays outside.
    fn place(&self, point: Offset) -> [f64; 2] {
        let [right, up, _] = self.turned(point);
        let far = 1e6;
        [self.centre[0] + right * self.scale, self.centre[1] - up * self.scale].map(|x| x.clamp(-far, far))
    }

    fn path(&self, paths: &[Vec<Offset>], is_closed: bool) -> String {
        let mut text = String::new();
        for path in paths {
            for (at, &point) in path.iter().enumerate() {
                let [x, y] = self.place(point);
                // Writing to a String does not fail.
                let _ = write!(text, "{}{x:.1} {y:.1}", if at == 0 { 'M' } else { 'L' });
            }
            text.push_str(if is_closed { "Z" } else { "" });
        }
        text
    }

    fn depth(&self, paths: &[Vec<Offset>]) -> f64 {
        let all = || paths.iter().flatten();
        let sum: f64 = all().map(|&point| self.turned(point)[2]).sum();
        #[allow(clippy::cast_precision_loss)] // a mean
        let count = all().count().max(1) as f64;
        sum / count
    }
}

impl Drawing {
    /// The drawing as an SVG picture; a drawing in space is seen from the direction `look`.
    #[must_use]
    pub fn svg(&self, look: Look, window: Window) -> String {
        let (names, top) = legend(self.shown());
        let view = View::of(self, look, window, top);
        let mut text = String::new();
        let mut items: Vec<Item> = Vec::new();
        for (at, layer) in self.shown().enumerate() {
            for (part, paths) in layer.parts.iter().enumerate() {
                let drawn = part_svg(&view, self.is_space, layer, part, paths);
                // In the plane, layers lie over each other. In space, lines lie on the areas that they bound, so they
                // are put slightly nearer.
                #[allow(clippy::cast_precision_loss)] // a few layers
                let depth = match (self.is_space, layer.shape) {
                    (false, _) => at as f64,
                    (true, Shape::Areas) => view.depth(paths),
                    (true, Shape::Lines) => view.depth(paths) + 0.01,
                    (true, Shape::Points) => view.depth(paths) + 0.02,
                };
                items.push(Item { depth, text: drawn });
            }
        }
        items.sort_by(|a, b| a.depth.total_cmp(&b.depth));
        items.iter().for_each(|item| text.push_str(&item.text));
        text.push_str(&names);
        text.push_str(&bar(&view));
        let [width, height] = SIZE;
        page(&format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             fill-rule=\"evenodd\" stroke-linejoin=\"round\" stroke-linecap=\"round\" font-family=\"sans-serif\" font-size=\"12\">\n{text}</svg>\n"
        ))
    }
}

fn part_svg(view: &View, is_space: bool, layer: &Layer, part: usize, paths: &[Vec<Offset>]) -> String {
    let colour = hex(layer.role.colour());
    let mut text = String::new();
    match layer.shape {
        Shape::Areas => {
            let (fill, opacity) = match paths.first().filter(|_| is_space) {
                Some(ring) => (hex(shaded(view, layer.role, ring)), if layer.role == Role::Faint { 0.15 } else { 0.9 }),
                None => (colour.clone(), if layer.role == Role::Faint { 0.1 } else { 0.3 }),
            };
            let path = view.path(paths, true);
            let _ = writeln!(
                text,
                "<path d=\"{path}\" fill=\"{fill}\" fill-opacity=\"{opacity}\" stroke=\"{colour}\" stroke-width=\"0.8\"/>"
            );
        }
        Shape::Lines => {
            let path = view.path(paths, false);
            let width = if layer.role == Role::Faint { 0.8 } else { 1.6 };
            let _ = writeln!(text, "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>");
        }
        Shape::Points => {
            let radius = if layer.parts.len() <= FEW_POINTS { 3.5 } else { 1.2 };
            for &point in paths.iter().flatten() {
                let [x, y] = view.place(point);
                let _ = writeln!(text, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{colour}\"/>");
            }
        }
    }
    if let Some((label, &point)) = layer.labels.get(part).zip(paths.iter().flatten().next()) {
        let [x, y] = view.place(point);
        let _ = writeln!(
            text,
            "<text x=\"{:.1}\" y=\"{:.1}\" fill=\"{colour}\">{}</text>",
            x + 6.0,
            y - 6.0,
            escaped(label)
        );
    }
    text
}

/// The colour of an area by its angle to the view direction.
fn shaded(view: &View, role: Role, ring: &[Offset]) -> [u8; 3] {
    let facing = match ring {
        [a, b, c, ..] => {
            normal([*a, *b, *c].map(|p| p.map(|x| x / view.unit))).map_or(1.0, |n| dot(n, view.axes[2]).abs())
        }
        _ => 1.0,
    };
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a part of a byte
    let shade = |x: u8| (f64::from(x) * (AMBIENT + (1.0 - AMBIENT) * facing)).round().clamp(0.0, 255.0) as u8;
    role.colour().map(shade)
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// The legend: the names of the layers and their numbers of parts, in lines above the drawing, and the height of these
/// lines.
fn legend<'l>(layers: impl Iterator<Item = &'l Layer>) -> (String, f64) {
    let named: Vec<&Layer> = layers.filter(|layer| !layer.parts.is_empty()).collect();
    let (mut text, mut x, mut y) = (String::new(), 10.0, 18.0);
    for (at, layer) in named.iter().enumerate() {
        let is_last = at + 1 == MOST_NAMES && named.len() > MOST_NAMES;
        let name = if is_last {
            format!("and {} more", named.len() - at)
        } else {
            format!("{} ({})", layer.name, layer.parts.len())
        };
        #[allow(clippy::cast_precision_loss)] // letters
        let width = 34.0 + 6.5 * name.chars().count() as f64;
        if x > 10.0 && x + width > SIZE[0] {
            (x, y) = (10.0, y + LINE);
        }
        let (colour, name) = (if is_last { "none".to_owned() } else { hex(layer.role.colour()) }, escaped(&name));
        let _ = writeln!(
            text,
            "<rect x=\"{x:.0}\" y=\"{:.0}\" width=\"10\" height=\"10\" fill=\"{colour}\"/><text x=\"{:.0}\" y=\"{y:.0}\" fill=\"currentColor\">{name}</text>",
            y - 9.0,
            x + 15.0
        );
        x += width;
        if is_last {
            break;
        }
    }
    (text, y)
}

/// A scale bar in the lower left corner; its length is a digit times a power of ten.
fn bar(view: &View) -> String {
    let most = 160.0 / view.scale * view.unit;
    let power = 10_f64.powf(most.log10().floor());
    let length = [5.0, 2.0, 1.0].into_iter().map(|digit| digit * power).find(|&length| length <= most).unwrap_or(power);
    let pixels = length / view.unit * view.scale;
    if !pixels.is_finite() || pixels < 1.0 {
        return String::new();
    }
    let name = if (1e-3..1e6).contains(&length) { significant(length, 1) } else { format!("{length:.0e}") };
    let y = SIZE[1] - 12.0;
    format!(
        "<path d=\"M12 {y}h{pixels:.1}\" stroke=\"currentColor\" stroke-width=\"2\"/><text x=\"{:.1}\" y=\"{:.0}\" fill=\"currentColor\">{name}</text>\n",
        18.0 + pixels,
        y + 4.0
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer(name: &str, shape: Shape, parts: Vec<super::super::Part>) -> Layer {
        Layer { name: name.to_owned(), role: Role::Given, shape, parts, labels: Vec::new(), is_shown: true }
    }

    fn square(z: f64) -> super::super::Part {
        vec![vec![[0.0, 0.0, z], [1.0, 0.0, z], [1.0, 1.0, z], [0.0, 1.0, z]]]
    }

    #[test]
    fn what_is_nearer_is_drawn_later() {
        let above = Look { azimuth: 0.0, elevation: 90.0 };
        for z in [[0.0, 1.0], [1.0, 0.0]] {
            let layers = vec![
                Layer { role: Role::Second, ..layer("far", Shape::Areas, vec![square(z[0])]) },
                layer("near", Shape::Areas, vec![square(z[1])]),
            ];
            let svg = Drawing { is_space: true, layers }.svg(above, Window::Whole);
            let [first, second] = [Role::Second, Role::Given]
                .map(|role| svg.find(&format!("stroke=\"{}\"", hex(role.colour()))).unwrap());
            assert_eq!(first < second, z[0] < z[1], "{svg}");
        }
    }

    #[test]
    fn y_is_up_and_the_bar_is_as_long_as_it_says() {
        let layers = vec![Layer {
            labels: vec!["low".into(), "high<".into()],
            ..layer("points", Shape::Points, vec![vec![vec![[0.0; 3]]], vec![vec![[0.0, 1000.0, 0.0]]]])
        }];
        let svg = Drawing { is_space: false, layers }.svg(Look::default(), Window::Whole);
        let y: Vec<f64> =
            svg.split("cy=\"").skip(1).map(|rest| rest.split('"').next().unwrap().parse().unwrap()).collect();
        assert!(y[0] > y[1], "{svg}");
        assert!(svg.contains("high&lt;") && svg.contains("points (2)"), "{svg}");
        let bar: f64 = svg.split("h").find_map(|rest| rest.split('"').next()?.parse().ok()).unwrap();
        let per_unit = (y[0] - y[1]) / 1000.0;
        assert!(svg.contains(&format!(">{}<", significant(bar / per_unit, 1))), "{bar} at {per_unit}: {svg}");
    }

    #[test]
    fn a_window_magnifies_what_is_around_the_origin() {
        let part = |x: f64| vec![vec![[x, 0.0, 0.0]]];
        let layers = vec![layer("points", Shape::Points, vec![part(0.0), part(1e-17), part(1.0)])];
        let drawing = Drawing { is_space: false, layers };
        let x = |window| -> Vec<f64> {
            let svg = drawing.svg(Look::default(), window);
            svg.split("cx=\"").skip(1).map(|rest| rest.split('"').next().unwrap().parse().unwrap()).collect()
        };
        let whole = x(Window::Whole);
        assert!(whole[0] == whole[1] && whole[2] > whole[0] + 100.0, "{whole:?}");
        let near = x(Window::Around(2e-17));
        assert!(near[1] > near[0] + 50.0 && near[2] > 1000.0, "{near:?}");
    }

    #[test]
    fn nothing_and_one_place_and_the_largest_doubles_are_drawn_too() {
        for x in [0.0, f64::MAX, f64::MIN_POSITIVE] {
            let layers = vec![layer("a", Shape::Lines, vec![vec![vec![[-x; 3], [x; 3]]]])];
            let svg = Drawing { is_space: true, layers }.svg(Look::default(), Window::Whole);
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        }
        assert!(Drawing { is_space: false, layers: vec![] }.svg(Look::default(), Window::Whole).contains("</svg>"));
    }
}
