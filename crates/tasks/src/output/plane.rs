//! Polygons of the plane as SVG and GeoJSON.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use predicament_judge::Points;
use predicament_predicates::{Scene, Vertex};
use serde_json::{Value, json};

use super::rounded;

/// The longer side of a picture, in pixels.
const SIDE: f64 = 960.0;
/// The margin around it.
const MARGIN: f64 = 20.0;
/// Pictures of up to so many vertices have dots on them.
const DOTTED: usize = 500;

/// Writes `NAME.svg` and `NAME.geojson`: a polygon a feature, its first ring the outer one. A constructed vertex is at
/// the nearest doubles. The picture has y upwards; its polygons are filled by even and odd.
///
/// # Errors
/// That of the file system.
pub fn plane(scene: &Scene, polygons: &[Vec<Vec<Vertex>>], folder: &Path, name: &str) -> std::io::Result<Vec<PathBuf>> {
    let points = Points::of(scene);
    let place = |&v: &Vertex| rounded(&points, v).map(|point| [point[0], point[1]]);
    let ring = |ring: &Vec<Vertex>| ring.iter().map(place).collect::<std::io::Result<Vec<[f64; 2]>>>();
    let placed: Vec<Polygon> =
        polygons.iter().map(|rings| rings.iter().map(ring).collect()).collect::<std::io::Result<_>>()?;
    let [svg, geojson] = [".svg", ".geojson"].map(|extension| folder.join(format!("{name}{extension}")));
    std::fs::write(&svg, picture(&placed))?;
    std::fs::write(&geojson, features(polygons, &placed))?;
    Ok(vec![svg, geojson])
}

/// The rings of a polygon.
type Polygon = Vec<Vec<[f64; 2]>>;

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

fn picture(polygons: &[Polygon]) -> String {
    let all = || polygons.iter().flatten().flatten();
    let bound = |axis: usize| {
        all().fold([f64::MAX, f64::MIN], |[low, high], point| [low.min(point[axis]), high.max(point[axis])])
    };
    let [[left, right], [bottom, top]] = [bound(0), bound(1)];
    // Halves, so that no difference of finite numbers overflows.
    let extent = (0.5 * right - 0.5 * left).max(0.5 * top - 0.5 * bottom);
    let scale = |x: f64| if extent > 0.0 { (0.5 * x / extent).clamp(0.0, 1.0) * SIDE } else { 0.5 * SIDE };
    let pixel = |[x, y]: [f64; 2]| [MARGIN + scale(x - left), MARGIN + scale(top - y)];
    let [width, height] = if polygons.iter().all(Vec::is_empty) {
        [SIDE; 2]
    } else {
        [scale(right - left), scale(top - bottom)].map(|side| side.max(1.0))
    };
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
