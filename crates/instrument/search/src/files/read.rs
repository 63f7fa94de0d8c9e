//! Readers of files as pieces. Anything that has a syntax is read, valid or not: the command judges it.

use std::sync::Arc;

use predicament_formats::{CorpusError, Decimals, geometry, mesh, text_of};

use super::sketch::{Encoding, Form, Kind, Outer, Shape, Sketch};

/// The shortest decimal that denotes a double.
pub(super) fn short(x: f64) -> String {
    let [plain, scientific] = [format!("{x}"), format!("{x:e}")];
    if plain.len() <= scientific.len() { plain } else { scientific }
}

impl Sketch {
    /// Reads a mesh (OFF, OBJ, PLY, STL), a map (GeoJSON, WKT) or rows of points (CSV), by the extension of the name.
    /// Decimals that no double is printed as are rounded.
    ///
    /// # Errors
    /// [`CorpusError`] at the line or byte that is wrong.
    pub fn read(file: &str, bytes: Vec<u8>) -> Result<Sketch, CorpusError> {
        let name = file.to_ascii_lowercase();
        let is = |extensions: &[&str]| extensions.iter().any(|extension| name.ends_with(extension));
        let sketch = if is(&[".csv", ".txt"]) {
            rows(file, &text_of(file, bytes)?)?
        } else if is(&[".geojson", ".json", ".wkt"]) {
            map(file, bytes, is(&[".wkt"]))?
        } else if is(&[".off", ".obj", ".ply", ".stl"]) {
            faces(file, bytes, &name)?
        } else {
            let message = if is(&[".gz"]) { "the file is packed" } else { "the file name does not show its format" };
            let cure = "unpack it, or name a .off, .obj, .ply, .stl, .geojson, .json, .wkt, .csv or .txt file";
            return Err(CorpusError::usage(file, message, cure));
        };
        if sketch.items.is_empty() {
            return Err(CorpusError::file(file, "the file has no points", "name a file with at least one"));
        }
        Ok(sketch)
    }
}

fn faces(file: &str, bytes: Vec<u8>, name: &str) -> Result<Sketch, CorpusError> {
    let head = &bytes[..bytes.len().min(200)];
    let says = |text: &str| head.windows(text.len()).any(|words| words == text.as_bytes());
    let form = match &name[name.len() - 4..] {
        ".off" => Form::Off,
        ".obj" => Form::Obj,
        ".ply" if says("format ascii") => Form::Ply(Encoding::Text),
        ".ply" if says("format binary_big_endian") => Form::Ply(Encoding::Big),
        ".ply" => Form::Ply(Encoding::Little),
        // As its reader decides.
        _ if bytes.contains(&0) => Form::Stl(Encoding::Little),
        _ => Form::Stl(Encoding::Text),
    };
    let mesh = mesh::read_degenerate(file, bytes, &Decimals::new(true))?;
    let item = |kind, corners: Vec<usize>| Arc::new(vec![Shape { kind, loops: vec![corners] }]);
    let mut items: Vec<_> =
        mesh.edges.iter().map(|edge| item(Kind::Line, edge.map(|corner| corner.index()).to_vec())).collect();
    items.extend(mesh.faces.iter().map(|face| item(Kind::Area, face.iter().map(|&corner| corner as usize).collect())));
    let points = mesh.points.iter().map(|point| point.map(|x| number(x, &form)).to_vec()).collect();
    let mut sketch = Sketch { form, points: Arc::new(points), items };
    // A point without a face is an item.
    let alone = sketch.used().into_iter().enumerate().filter(|(_, used)| !used);
    let mut all: Vec<_> = alone.map(|(at, _)| item(Kind::Point, vec![at])).collect();
    all.append(&mut sketch.items);
    sketch.items = all;
    Ok(sketch)
}

/// A coordinate of a mesh as text; binary STL stores singles, which have shorter decimals.
fn number(x: f64, form: &Form) -> String {
    #[allow(clippy::cast_possible_truncation)] // it is a single
    let single = x as f32;
    if *form == Form::Stl(Encoding::Little) { format!("{single}") } else { short(x) }
}

fn map(file: &str, bytes: Vec<u8>, is_wkt: bool) -> Result<Sketch, CorpusError> {
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let form = match text.trim_start() {
        _ if is_wkt => Form::Wkt,
        rings if rings.starts_with('[') => Form::GeoJson(Outer::Rings),
        text if text.contains("\"FeatureCollection\"") => Form::GeoJson(Outer::Collection),
        text if text.contains("\"Feature\"") => Form::GeoJson(Outer::Feature),
        _ => Form::GeoJson(Outer::Geometry),
    };
    let read = geometry::read(file, bytes, &Decimals::new(true))?;
    let mut points = Vec::new();
    let mut point = |position: &geometry::Position| {
        points.push(position.at.into_iter().chain(position.height).map(short).collect());
        points.len() - 1
    };
    let mut shape = |shape: &geometry::Shape| {
        let (kind, loops): (Kind, Vec<&[_]>) = match shape {
            geometry::Shape::Point(position) => (Kind::Point, vec![std::slice::from_ref(position)]),
            geometry::Shape::Line(line) => (Kind::Line, vec![line]),
            geometry::Shape::Polygon(rings) => (Kind::Area, rings.iter().map(Vec::as_slice).collect()),
        };
        Shape { kind, loops: loops.into_iter().map(|one| one.iter().map(&mut point).collect()).collect() }
    };
    let items = read.features.iter().map(|feature| Arc::new(feature.shapes.iter().map(&mut shape).collect()));
    let items = items.collect();
    Ok(Sketch { form, points: Arc::new(points), items })
}

/// Rows of cells, with columns of text kept. Comments and blank lines are left out.
fn rows(file: &str, text: &str) -> Result<Sketch, CorpusError> {
    let lines = text.lines().enumerate().map(|(at, line)| (at + 1, line.trim()));
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#')).peekable();
    let first = lines.peek().map_or("", |(_, line)| line);
    let separator = [";", ",", "\t"].into_iter().find(|separator| first.contains(separator)).unwrap_or(" ");
    let cells = |line: &str| -> Vec<String> {
        let cells = line.split(separator).map(|cell| cell.trim().to_owned());
        cells.filter(|cell| separator != " " || !cell.is_empty()).collect()
    };
    let has_number = |cells: &[String]| cells.iter().any(|cell| cell.parse::<f64>().is_ok());
    let head = lines.next_if(|(_, line)| !has_number(&cells(line))).map_or("", |(_, line)| line).to_owned();
    let mut points = Vec::new();
    for (at, line) in lines {
        let cells = cells(line);
        if !has_number(&cells) {
            return Err(CorpusError::file(file, "a row without a number", "write coordinates").at_line(at));
        }
        points.push(cells);
    }
    let item = |at| Arc::new(vec![Shape { kind: Kind::Point, loops: vec![vec![at]] }]);
    let items = (0..points.len()).map(item).collect();
    Ok(Sketch { form: Form::Csv(head, separator), points: Arc::new(points), items })
}
