//! `a` and `b`: two complexes in one scene, whose contacts are asked for.

use std::ops::Range;
use std::path::PathBuf;

use predicament_corpus::{Canon, Content, Context, Elsewhere, Level, Parts, Source as SceneSource};
use predicament_formats::{
    Cache, CorpusError, Entry, Field, Fields, ImportNotes, POINTS, TableKind, mesh, read_csv, read_points, topojson,
};
use predicament_mesh::{Complex, PolygonMap, Simplices};
use predicament_predicates::{Dimension, Scene, Vertex};

use super::sigma::{direction, sigma};
use crate::polygon_locate::content::Origin;

static COMPLEX: TableKind = TableKind::new(
    "complex",
    &["vertices", "edges", "triangles", "tetrahedra", "closed", "path", "topojson", "fetch", "object", "shifted"],
);

/// Two complexes, which have no vertex in common.
#[derive(Clone, PartialEq, Debug)]
pub struct Complexes {
    /// The first complex.
    pub a: Complex,
    /// The second complex.
    pub b: Complex,
}

impl Complexes {
    /// Both.
    #[must_use]
    pub fn both(&self) -> [&Complex; 2] {
        [&self.a, &self.b]
    }

    /// The scene and its content: the scene learns how large the primitives are
    /// and which vertices are of the second complex.
    #[must_use]
    pub fn in_scene(self, scene: Scene) -> (Scene, Complexes) {
        let lengths = self.both().map(|complex| complex.primitive_length(&scene));
        let second: Vec<Vertex> = self.b.vertices().to_vec();
        (scene.with_primitive_lengths(lengths).with_second_mesh(second), self)
    }
}

impl Content for Complexes {
    /// The simplices of both.
    fn count(&self) -> usize {
        self.a.len() + self.b.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("contacts");
        for complex in self.both() {
            canon.vertices(complex.vertices());
            canon.vertices(complex.edges().as_flattened());
            canon.vertices(complex.triangles().as_flattened());
            canon.vertices(complex.tetrahedra().as_flattened());
        }
    }
}

/// The `points`, `a` and `b` of a scene.
#[derive(Clone, Debug)]
pub(super) struct Written {
    file: String,
    points: Points,
    a: Side,
    b: Side,
    dimension: Dimension,
}

#[derive(Clone, Debug)]
enum Points {
    Written(Vec<f64>),
    Csv { path: PathBuf, line: usize },
}

/// One complex, and where the file speaks of it.
#[derive(Clone, Debug)]
struct Side {
    line: usize,
    source: Source,
}

#[derive(Clone, Debug)]
enum Source {
    /// Simplices of the scene's points, each with its line.
    Written(Vec<(usize, Vec<Vertex>)>),
    /// An OFF, OBJ or PLY file.
    Mesh(Origin),
    /// The borders of a map.
    Map { origin: Origin, object: String },
    /// A copy of the first complex, moved by so many σ.
    Shifted(f64),
}

impl Written {
    /// Reads `points`, `a` and `b`.
    pub(super) fn read(
        context: &Context<'_>,
        fields: &Fields<'_, '_>,
        dimension: Dimension,
    ) -> Result<Written, CorpusError> {
        let points = match fields.get("points") {
            None => Points::Written(Vec::new()),
            Some(field) if field.is_array() => Points::Written(written(&field, dimension)?),
            Some(field) => {
                let table = field.fields(&POINTS)?;
                let path = context.path(&table.required("path")?)?;
                table.finish()?;
                Points::Csv { path, line: field.line() }
            }
        };
        let a = Side::read(context, &fields.required("a")?, dimension, false)?;
        let b = Side::read(context, &fields.required("b")?, dimension, true)?;
        Ok(Written { file: fields.file().to_owned(), points, a, b, dimension })
    }

    /// Whether everything is written out in the suite.
    fn is_inline(&self) -> bool {
        matches!(
            (&self.points, &self.a.source, &self.b.source),
            (Points::Written(_), Source::Written(_), Source::Written(_) | Source::Shifted(_))
        )
    }

    /// As the source of a scene.
    pub(super) fn source(self) -> Result<SceneSource, CorpusError> {
        if !self.is_inline() {
            return Ok(SceneSource::elsewhere(self));
        }
        // Nothing is read from a cache: everything is written out.
        Ok(SceneSource::Written(self.assemble(&Cache::new(""))?))
    }

    /// Reads what is in other files and puts both complexes into one scene:
    /// the points first, then those of `a`, then those of `b`.
    fn assemble(&self, cache: &Cache) -> Result<Parts, CorpusError> {
        let file = self.file.as_str();
        let mut coordinates = match &self.points {
            Points::Written(coordinates) => coordinates.clone(),
            Points::Csv { path, line } => {
                let (found, coordinates) = read_csv(path)?;
                if found != self.dimension {
                    let message = format!("the points have {} coordinates", found.count());
                    let cure = format!("give them {}", self.dimension.count());
                    return Err(CorpusError::file(file, message, cure).at_line(*line));
                }
                coordinates
            }
        };
        let points = coordinates.len() / self.dimension.count();
        let mut notes = ImportNotes::default();
        let mut sides = Vec::with_capacity(2);
        for side in [&self.a, &self.b] {
            let start = coordinates.len() / self.dimension.count();
            let given = match &side.source {
                Source::Written(simplices) => from_points(file, simplices, points)?,
                Source::Mesh(origin) => {
                    let (name, bytes) = origin.bytes(cache)?;
                    let mesh = mesh::read(&name, &bytes)?;
                    coordinates.extend(mesh.points.as_flattened());
                    let given = Simplices { edges: mesh.edges, triangles: mesh.triangles, ..Simplices::default() };
                    shifted(&given, |v| Vertex::input(v.index() + start))
                }
                Source::Map { origin, object } => {
                    let (name, text) = origin.read(cache)?;
                    let map = topojson::read(&name, &text, object)?;
                    coordinates.extend(map.points.as_flattened());
                    notes.add(&map.notes);
                    borders(&map.map, start)
                }
                Source::Shifted(by) => {
                    let scene = self.scene(file, side.line, coordinates.clone())?;
                    let original = complex(file, &self.a, &scene, &sides[0])?;
                    let length = original.primitive_length(&scene);
                    coordinates.extend(moved(&scene, original.vertices(), *by * sigma(self.dimension, [length; 2])));
                    let place = |v| original.vertices().binary_search(&v).expect("a vertex of the original");
                    shifted(&sides[0], |v| Vertex::input(start + place(v)))
                }
            };
            sides.push(given);
        }
        let scene = self.scene(file, self.b.line, coordinates)?;
        let a = complex(file, &self.a, &scene, &sides[0])?;
        let b = complex(file, &self.b, &scene, &sides[1])?;
        if let Some(vertex) = b.vertices().iter().find(|vertex| a.vertices().binary_search(vertex).is_ok()) {
            let message = format!("point {vertex} is in both complexes");
            let cure = "give each complex points of its own, at the same place if need be";
            return Err(CorpusError::file(file, message, cure).at_line(self.b.line));
        }
        let (scene, complexes) = Complexes { a, b }.in_scene(scene);
        Ok(Parts { notes, ..Parts::new(scene, complexes) })
    }

    fn scene(&self, file: &str, line: usize, coordinates: Vec<f64>) -> Result<Scene, CorpusError> {
        Scene::new(self.dimension, coordinates)
            .map_err(|error| CorpusError::file(file, error.to_string(), "correct the points").at_line(line))
    }
}

impl Elsewhere for Written {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        self.assemble(cache)
    }

    /// The fetched file that is needed first, if any.
    fn fetch_entry(&self) -> Option<&Entry> {
        [&self.a, &self.b].into_iter().find_map(|side| match &side.source {
            Source::Map { origin, .. } | Source::Mesh(origin) => origin.entry(),
            Source::Written(_) | Source::Shifted(_) => None,
        })
    }
}

/// These vertices' points, moved.
pub(super) fn moved<'s>(scene: &'s Scene, vertices: &'s [Vertex], by: f64) -> impl Iterator<Item = f64> + 's {
    let along = direction(scene.dimension());
    vertices.iter().flat_map(move |&v| scene.point(v).iter().zip(along).map(move |(x, along)| x + by * along))
}

fn written(field: &Field<'_, '_>, dimension: Dimension) -> Result<Vec<f64>, CorpusError> {
    if field.items("an array of points")?.len() == 0 {
        return Ok(Vec::new());
    }
    let (found, coordinates) = read_points(field)?;
    if found != dimension {
        let message =
            format!("contacts{0}d takes points of {0} coordinates, not of {1}", dimension.count(), found.count());
        return Err(field.error(message, format!("give every point {} coordinates", dimension.count())));
    }
    Ok(coordinates)
}

impl Side {
    fn read(
        context: &Context<'_>,
        field: &Field<'_, '_>,
        dimension: Dimension,
        is_second: bool,
    ) -> Result<Side, CorpusError> {
        let table = field.fields(&COMPLEX)?;
        let (path, map, fetch) = (table.get("path"), table.get("topojson"), table.get("fetch"));
        let copied = if is_second { table.get("shifted") } else { None };
        let only = |this: &Field<'_, '_>, wanted: Dimension| {
            let cure = "use maps for contacts2d, meshes for contacts3d";
            if wanted == dimension { Ok(()) } else { Err(this.error("the file has points of another dimension", cure)) }
        };
        let object = || table.required("object")?.string();
        let source = match (path, map, fetch, copied) {
            (Some(path), None, None, None) => {
                only(&path, Dimension::Three)?;
                Source::Mesh(Origin::Path(context.path(&path)?))
            }
            (None, Some(path), None, None) => {
                only(&path, Dimension::Two)?;
                Source::Map { origin: Origin::Path(context.path(&path)?), object: object()? }
            }
            (None, None, Some(key), None) => {
                let origin = Origin::Fetched(context.fetched(&key)?);
                match dimension {
                    Dimension::Two => Source::Map { origin, object: object()? },
                    Dimension::Three => Source::Mesh(origin),
                }
            }
            (None, None, None, Some(by)) => Source::Shifted(by.positive()?),
            (None, None, None, None) => Source::Written(simplices(&table, dimension)?),
            _ => {
                let cure = "keep one of `path`, `topojson`, `fetch` and `shifted`";
                return Err(field.error("a complex from more than one place", cure));
            }
        };
        table.finish()?;
        Ok(Side { line: field.line(), source })
    }
}

/// The simplices that are written out; closed polygons become edges.
fn simplices(table: &Fields<'_, '_>, dimension: Dimension) -> Result<Vec<(usize, Vec<Vertex>)>, CorpusError> {
    let mut all = Vec::new();
    if let Some(vertices) = table.get("vertices") {
        for vertex in vertices.items("an array of indices")? {
            all.push((vertex.line(), vec![vertex.point()?]));
        }
    }
    let tuples = |key: &'static str, one: &str, corners: Range<usize>| -> Result<_, CorpusError> {
        let mut found = Vec::new();
        let Some(field) = table.get(key) else { return Ok(found) };
        for item in field.items("arrays of indices")? {
            let indices: Vec<Vertex> =
                item.items("an array of indices")?.map(|index| index.point()).collect::<Result<_, _>>()?;
            if !corners.contains(&indices.len()) {
                let wanted = if corners.len() == 1 { corners.start.to_string() } else { "at least 3".to_owned() };
                let message = format!("{one} of {} indices", indices.len());
                return Err(item.error(message, format!("write {wanted} indices")));
            }
            found.push((item.line(), indices));
        }
        Ok(found)
    };
    all.extend(tuples("edges", "an edge", 2..3)?);
    all.extend(tuples("triangles", "a triangle", 3..4)?);
    if dimension == Dimension::Three {
        all.extend(tuples("tetrahedra", "a tetrahedron", 4..5)?);
    }
    for (line, ring) in tuples("closed", "a closed polygon", 3..usize::MAX)? {
        let next = ring.iter().cycle().skip(1);
        all.extend(ring.iter().zip(next).map(|(&a, &b)| (line, vec![a, b])));
    }
    Ok(all)
}

/// Simplices of the written points, checked one by one, so that an error has a line.
fn from_points(file: &str, simplices: &[(usize, Vec<Vertex>)], points: usize) -> Result<Simplices, CorpusError> {
    let mut given = Simplices::default();
    for (line, simplex) in simplices {
        let error = |message: String, cure: &str| Err(CorpusError::file(file, message, cure).at_line(*line));
        if let Some(vertex) = simplex.iter().find(|vertex| vertex.index() >= points) {
            let message = format!("index {vertex} is out of range: the scene has {points} points");
            return error(message, "indices count from 0");
        }
        if let Some(twice) = simplex.iter().enumerate().find_map(|(at, v)| simplex[..at].contains(v).then_some(v)) {
            return error(format!("point {twice} is twice in one simplex"), "name different points");
        }
        match **simplex {
            [a] => given.vertices.push(a),
            [a, b] => given.edges.push([a, b]),
            [a, b, c] => given.triangles.push([a, b, c]),
            [a, b, c, d] => given.tetrahedra.push([a, b, c, d]),
            _ => unreachable!("a simplex has one to four vertices"),
        }
    }
    Ok(given)
}

/// Every border of a map, once.
fn borders(map: &PolygonMap, start: usize) -> Simplices {
    let edges = map.edges().map(|(_, edge)| edge.map(|v| Vertex::input(v.index() + start))).collect();
    Simplices { edges, ..Simplices::default() }
}

/// The same simplices of other vertices.
pub(super) fn shifted(given: &Simplices, vertex: impl Fn(Vertex) -> Vertex) -> Simplices {
    Simplices {
        vertices: given.vertices.iter().map(|&v| vertex(v)).collect(),
        edges: given.edges.iter().map(|edge| edge.map(&vertex)).collect(),
        triangles: given.triangles.iter().map(|triangle| triangle.map(&vertex)).collect(),
        tetrahedra: given.tetrahedra.iter().map(|tetrahedron| tetrahedron.map(&vertex)).collect(),
    }
}

fn complex(file: &str, side: &Side, scene: &Scene, given: &Simplices) -> Result<Complex, CorpusError> {
    Complex::new(scene, given)
        .map_err(|error| CorpusError::file(file, error.to_string(), "correct the simplices").at_line(side.line))
}
