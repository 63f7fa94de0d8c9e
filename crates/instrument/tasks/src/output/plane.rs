//! Polygons in the plane as SVG, GeoJSON and WKT.

use std::cell::LazyCell;
use std::io::{Result as IoResult, Write};

use predicament_judge::{Points, nearest, rational};
use predicament_predicates::{Scene, Vertex};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use super::choice::When;
use super::{Error, Files, exactly, rounded};

/// The longer side of a picture, in pixels.
const SIDE: f64 = 960.0;
/// The margin around the picture, in pixels.
const MARGIN: f64 = 20.0;
/// The maximum number of vertices for which a picture has dots on them.
const DOTTED: usize = 500;
/// The maximum number of polygons in a picture that is drawn by default: viewers of SVG are slow with more.
const DRAWN: usize = 10_000;

/// Offers `NAME.svg` and `NAME.geojson`, and by its format `NAME.wkt`: a feature for each polygon, its first ring the
/// outer one. A ring of two vertices is a line, a ring of one vertex a point. A constructed vertex is rounded to the
/// nearest doubles in the file, but not in the picture: it shows a crossing between two neighbouring doubles at its
/// true position. The picture has y upwards, and fills polygons by the even-odd rule. A picture of more than 10,000
/// polygons is drawn only by its format.
///
/// # Errors
/// [`Error`] if a vertex is not a point; otherwise as [`Files::write`].
pub fn plane<P>(files: &mut Files, scene: &Scene, name: &str, polygons: P) -> Result<(), Error>
where
    P: ExactSizeIterator<Item = Vec<Vec<Vertex>>> + Clone,
{
    let [svg, geojson, wkt] = ["svg", "geojson", "wkt"].map(|extension| format!("{name}.{extension}"));
    let (when, note) = match polygons.len() {
        0..=DRAWN => (When::Always, None),
        count => {
            let why = format!("{svg} would have {count} parts, more than {DRAWN}");
            (When::Format, Some(format!("{why}, and is not drawn; --format svg draws it")))
        }
    };
    let points = LazyCell::new(|| Points::of(scene));
    files.offer(&svg, when, note, |out| picture(out, &points, polygons.clone()))?;
    files.write(&geojson, |out| collection(out, polygons.clone().map(|rings| Feature::of(&points, rings))))?;
    files.by_format(&wkt, |out| {
        polygons.clone().try_for_each(|rings| writeln!(out, "{}", Placed::of(&points, &rings)?.wkt()))
    })
}

/// Offers `NAME.csv` by its format: the ids of each triangle's corners, one triangle a line.
///
/// # Errors
/// As [`Files::write`].
pub fn table(files: &mut Files, name: &str, triangles: &[[Vertex; 3]]) -> Result<(), Error> {
    files.by_format(&format!("{name}.csv"), |out| {
        writeln!(out, "a,b,c")?;
        triangles.iter().try_for_each(|[a, b, c]| writeln!(out, "{a},{b},{c}"))
    })
}

/// Writes a GeoJSON file with these features.
///
/// # Errors
/// The error of a feature or of the file system.
pub fn collection<F: Serialize>(out: &mut dyn Write, features: impl IntoIterator<Item = IoResult<F>>) -> IoResult<()> {
    write!(out, "{{\"features\":[")?;
    let mut text = Vec::new();
    for feature in features {
        serde_json::to_writer(&mut text, &feature?)?;
        out.write_all(&text)?;
        text.clear();
        text.push(b',');
    }
    writeln!(out, "],\"type\":\"FeatureCollection\"}}")
}

/// A polygon as GeoJSON has it, with the ids of its vertices. Keys are in the order of the alphabet.
#[derive(Serialize)]
struct Feature {
    geometry: Placed,
    properties: Properties,
    r#type: &'static str,
}

#[derive(Serialize)]
struct Properties {
    vertices: Vec<Ids>,
}

/// The ids of a ring's vertices, as texts.
struct Ids(Vec<Vertex>);

impl Serialize for Ids {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().map(|v| format!("{v}")))
    }
}

impl Feature {
    fn of(points: &Points, rings: Vec<Vec<Vertex>>) -> IoResult<Feature> {
        let geometry = Placed::of(points, &rings)?;
        Ok(Feature {
            geometry,
            properties: Properties { vertices: rings.into_iter().map(Ids).collect() },
            r#type: "Feature",
        })
    }
}

/// The rings of a polygon in doubles, or what a degenerate polygon is: the geometry of a feature.
enum Placed {
    Point([f64; 2]),
    Line(Vec<[f64; 2]>),
    /// Closed rings.
    Polygon(Vec<Vec<[f64; 2]>>),
}

impl Serialize for Placed {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut geometry = serializer.serialize_struct("geometry", 2)?;
        let kind = match self {
            Placed::Point(point) => geometry.serialize_field("coordinates", point).map(|()| "Point"),
            Placed::Line(line) => geometry.serialize_field("coordinates", line).map(|()| "LineString"),
            Placed::Polygon(rings) => geometry.serialize_field("coordinates", rings).map(|()| "Polygon"),
        }?;
        geometry.serialize_field("type", kind)?;
        geometry.end()
    }
}

impl Placed {
    fn of(points: &Points, rings: &[Vec<Vertex>]) -> IoResult<Placed> {
        let place = |&v: &Vertex| rounded(points, v).map(|point| [point[0], point[1]]);
        let ring = |ring: &Vec<Vertex>| ring.iter().map(place).collect::<IoResult<Vec<[f64; 2]>>>();
        let mut placed: Vec<Vec<[f64; 2]>> = rings.iter().map(ring).collect::<IoResult<_>>()?;
        Ok(match placed.as_mut_slice() {
            [ring] if ring.len() == 1 => Placed::Point(ring[0]),
            [ring] if ring.len() == 2 => Placed::Line(std::mem::take(ring)),
            _ => {
                placed.iter_mut().for_each(|ring| ring.extend(ring.first().copied()));
                Placed::Polygon(placed)
            }
        })
    }

    fn wkt(&self) -> String {
        let place = |[x, y]: &[f64; 2]| format!("{x:?} {y:?}");
        let path = |path: &Vec<[f64; 2]>| format!("({})", path.iter().map(place).collect::<Vec<_>>().join(", "));
        match self {
            Placed::Point(point) => format!("POINT ({})", place(point)),
            Placed::Line(line) => format!("LINESTRING {}", path(line)),
            Placed::Polygon(rings) if rings.is_empty() => "POLYGON EMPTY".to_owned(),
            Placed::Polygon(rings) => {
                format!("POLYGON ({})", rings.iter().map(path).collect::<Vec<_>>().join(", "))
            }
        }
    }
}

/// The bounding box of all rounded points.
struct Bounds {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl Bounds {
    fn of(points: &Points, vertices: impl Iterator<Item = Vertex>) -> IoResult<Bounds> {
        let mut bound: Option<[[f64; 2]; 2]> = None;
        for v in vertices {
            let point = rounded(points, v)?;
            let place = [point[0], point[1]];
            let [low, high] = bound.unwrap_or([place; 2]);
            let least = [0, 1].map(|axis: usize| low[axis].min(place[axis]));
            bound = Some([least, [0, 1].map(|axis: usize| high[axis].max(place[axis]))]);
        }
        let [[left, bottom], [right, top]] = bound.unwrap_or([[0.0; 2], [1.0; 2]]);
        Ok(Bounds { left, top, width: right - left, height: top - bottom })
    }

    /// The distances of a vertex from the left side and from the top, rounded once.
    fn offset(&self, points: &Points, v: Vertex) -> IoResult<[f64; 2]> {
        if v.construction().is_none() {
            let point = points.scene().point(v);
            return Ok([point[0] - self.left, self.top - point[1]]);
        }
        let point = exactly(points, v)?;
        Ok([nearest(&(rational(-self.left) + &point[0])), nearest(&(rational(self.top) - &point[1]))])
    }
}

fn picture(
    out: &mut dyn Write,
    points: &Points,
    polygons: impl Iterator<Item = Vec<Vec<Vertex>>> + Clone,
) -> IoResult<()> {
    let bounds = Bounds::of(points, polygons.clone().flatten().flatten())?;
    let extent = bounds.width.max(bounds.height);
    // A crossing can be outside the box by less than a rounding error. A box without an extent, or with an extent
    // beyond all doubles, is drawn as a dot.
    let scale = |x: f64| if extent > 0.0 && extent.is_finite() { (x / extent).clamp(0.0, 1.0) * SIDE } else { 0.0 };
    let pixel = |[x, y]: [f64; 2]| [MARGIN + scale(x), MARGIN + scale(y)];
    let [width, height] = [bounds.width, bounds.height].map(|side| scale(side).max(1.0));
    let [width, height] = [width, height].map(|side| side + 2.0 * MARGIN);
    write!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.2} {height:.2}\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         <g fill=\"#9ecae1\" fill-opacity=\"0.5\" fill-rule=\"evenodd\" stroke=\"#08519c\" stroke-width=\"1\" \
         stroke-linejoin=\"round\">\n"
    )?;
    let mut dots: Vec<[f64; 2]> = Vec::new();
    for rings in polygons {
        write!(out, "<path d=\"")?;
        for ring in rings {
            for (at, v) in ring.into_iter().enumerate() {
                let offset = bounds.offset(points, v)?;
                let [x, y] = pixel(offset);
                write!(out, "{}{x:.2} {y:.2}", if at == 0 { 'M' } else { 'L' })?;
                dots.push(offset);
            }
            write!(out, "Z")?;
        }
        writeln!(out, "\"/>")?;
    }
    writeln!(out, "</g>")?;
    dots.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    dots.dedup();
    if dots.len() <= DOTTED {
        for point in dots {
            let [x, y] = pixel(point);
            writeln!(out, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"3\" fill=\"#08306b\"/>")?;
        }
    }
    writeln!(out, "</svg>")
}
