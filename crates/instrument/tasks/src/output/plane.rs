//! Polygons in the plane as SVG and GeoJSON.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use predicament_judge::{Points, nearest, rational};
use predicament_predicates::{Scene, Vertex};
use serde_json::{Value, json};

use super::{exactly, rounded};

/// The longer side of a picture, in pixels.
const SIDE: f64 = 960.0;
/// The margin around the picture, in pixels.
const MARGIN: f64 = 20.0;
/// The maximum number of vertices for which a picture has dots on them.
const DOTTED: usize = 500;

/// Writes `NAME.svg` and `NAME.geojson`: a feature for each polygon, its first ring the outer one. A constructed vertex
/// is rounded to the nearest doubles in the file, but not in the picture: it shows a crossing between two neighbouring
/// doubles at its true position. The picture has y upwards, and fills polygons by the even-odd rule.
///
/// # Errors
/// The error of the file system.
pub fn plane(scene: &Scene, polygons: &[Vec<Vec<Vertex>>], folder: &Path, name: &str) -> std::io::Result<Vec<PathBuf>> {
    let points = Points::of(scene);
    let placed = each(polygons, |v| rounded(&points, v).map(|point| [point[0], point[1]]))?;
    let bounds = Bounds::of(&placed);
    let offsets = each(polygons, |v| bounds.offset(&points, v))?;
    let [svg, geojson] = [".svg", ".geojson"].map(|extension| folder.join(format!("{name}{extension}")));
    std::fs::write(&svg, picture(&bounds, &offsets))?;
    std::fs::write(&geojson, features(polygons, &placed))?;
    Ok(vec![svg, geojson])
}

/// The rings of a polygon.
type Polygon = Vec<Vec<[f64; 2]>>;

/// The polygons with a value for each vertex.
fn each(
    polygons: &[Vec<Vec<Vertex>>],
    place: impl Fn(Vertex) -> std::io::Result<[f64; 2]>,
) -> std::io::Result<Vec<Polygon>> {
    let ring = |ring: &Vec<Vertex>| ring.iter().map(|&v| place(v)).collect::<std::io::Result<Vec<[f64; 2]>>>();
    polygons.iter().map(|rings| rings.iter().map(ring).collect()).collect()
}

/// The bounding box of all rounded points.
struct Bounds {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl Bounds {
    fn of(placed: &[Polygon]) -> Bounds {
        let bound = |axis: usize| {
            let along = placed.iter().flatten().flatten().map(|point| point[axis]);
            along.fold(None, |bound, x| {
                let [low, high] = bound.unwrap_or([x, x]);
                Some([x.min(low), x.max(high)])
            })
        };
        let [[left, right], [bottom, top]] = [0, 1].map(|axis| bound(axis).unwrap_or([0.0, 1.0]));
        Bounds { left, top, width: right - left, height: top - bottom }
    }

    /// The distances of a vertex from the left side and from the top, rounded once.
    fn offset(&self, points: &Points, v: Vertex) -> std::io::Result<[f64; 2]> {
        if v.construction().is_none() {
            let point = points.scene().point(v);
            return Ok([point[0] - self.left, self.top - point[1]]);
        }
        let point = exactly(points, v)?;
        Ok([nearest(&(rational(-self.left) + &point[0])), nearest(&(rational(self.top) - &point[1]))])
    }
}

fn features(polygons: &[Vec<Vec<Vertex>>], placed: &[Polygon]) -> String {
    let closed = |ring: &Vec<[f64; 2]>| ring.iter().chain(ring.first()).copied().collect::<Vec<_>>();
    let ids = |rings: &Vec<Vec<Vertex>>| -> Vec<Vec<String>> {
        rings.iter().map(|ring| ring.iter().map(ToString::to_string).collect()).collect()
    };
    let feature = |(rings, placed): (&Vec<Vec<Vertex>>, &Polygon)| -> Value {
        json!({
            "type": "Feature",
            "geometry": { "type": "Polygon", "coordinates": placed.iter().map(closed).collect::<Vec<_>>() },
            "properties": { "vertices": ids(rings) },
        })
    };
    let features: Vec<Value> = polygons.iter().zip(placed).map(feature).collect();
    format!("{}\n", json!({ "type": "FeatureCollection", "features": features }))
}

fn picture(bounds: &Bounds, polygons: &[Polygon]) -> String {
    let all = || polygons.iter().flatten().flatten();
    let extent = bounds.width.max(bounds.height);
    // A crossing can be outside the box by less than a rounding error. A box without an extent, or with an extent
    // beyond all doubles, is drawn as a dot.
    let scale = |x: f64| if extent > 0.0 && extent.is_finite() { (x / extent).clamp(0.0, 1.0) * SIDE } else { 0.0 };
    let pixel = |[x, y]: [f64; 2]| [MARGIN + scale(x), MARGIN + scale(y)];
    let [width, height] = [bounds.width, bounds.height].map(|side| scale(side).max(1.0));
    let [width, height] = [width, height].map(|side| side + 2.0 * MARGIN);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.2} {height:.2}\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         <g fill=\"#9ecae1\" fill-opacity=\"0.5\" fill-rule=\"evenodd\" stroke=\"#08519c\" stroke-width=\"1\" \
         stroke-linejoin=\"round\">\n"
    );
    // Writing to a string does not fail.
    for rings in polygons {
        svg.push_str("<path d=\"");
        for ring in rings {
            for (at, &point) in ring.iter().enumerate() {
                let [x, y] = pixel(point);
                let _ = write!(svg, "{}{x:.2} {y:.2}", if at == 0 { 'M' } else { 'L' });
            }
            svg.push('Z');
        }
        svg.push_str("\"/>\n");
    }
    svg.push_str("</g>\n");
    let mut dots: Vec<[f64; 2]> = all().copied().collect();
    dots.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    dots.dedup();
    if dots.len() <= DOTTED {
        for point in dots {
            let [x, y] = pixel(point);
            let _ = writeln!(svg, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"3\" fill=\"#08306b\"/>");
        }
    }
    svg.push_str("</svg>\n");
    svg
}
