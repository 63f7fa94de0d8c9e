//! The keys `a` and `b`: two complexes in one scene, and the query for their contacts.

use std::ops::Range;
use std::sync::Arc;

use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Items, Level, List, Origin, Parts, PointSource, Source as SceneSource, Spelled,
    spelled_points,
};
use predicament_formats::{
    Cache, CorpusError, Decimals, Entry, Field, Fields, ImportNotes, ImportedMap, TableKind, geometry, mesh,
    read_polygons, topojson,
};
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Dimension, Scene, Vertex};

use super::sigma::{direction, sigma};

static COMPLEX: TableKind = TableKind::new(
    "complex",
    &[
        "vertices",
        "edges",
        "triangles",
        "tetrahedra",
        "closed",
        "path",
        "topojson",
        "fetch",
        "object",
        "polygons",
        "shifted",
    ],
);

/// The keys of simplices of each rank in the first complex.
const KEYS_OF_A: [&str; 4] = ["a.vertices", "a.edges", "a.triangles", "a.tetrahedra"];
/// The keys of simplices of each rank in the second complex.
const KEYS_OF_B: [&str; 4] = ["b.vertices", "b.edges", "b.triangles", "b.tetrahedra"];

/// Two complexes without common vertices.
#[derive(Clone, PartialEq, Debug)]
pub struct Complexes {
    /// The first complex.
    pub a: Complex,
    /// The second complex.
    pub b: Complex,
}

impl Complexes {
    /// Both complexes.
    #[must_use]
    pub fn both(&self) -> [&Complex; 2] {
        [&self.a, &self.b]
    }

    /// The scene and its content. The scene gets the size of the primitives and the list of the second complex'
    /// vertices.
    #[must_use]
    pub fn in_scene(self, scene: Scene) -> (Scene, Complexes) {
        let lengths = self.both().map(|complex| complex.primitive_length(&scene));
        let second: Vec<Vertex> = self.b.vertices().to_vec();
        (scene.with_primitive_lengths(lengths).with_second_mesh(second), self)
    }
}

impl Content for Complexes {
    /// The number of simplices of both complexes.
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

    /// A moved scene has other lengths of primitives.
    fn moved(&self, scene: Scene) -> (Scene, Option<Arc<dyn Content>>) {
        let (scene, complexes) = self.clone().in_scene(scene);
        (scene, Some(Arc::new(complexes)))
    }

    /// Spells only the maximal simplices: their faces give all others.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let mut spelled = spelled_points(scene);
        for (complex, name, keys) in [(&self.a, "a", KEYS_OF_A), (&self.b, "b", KEYS_OF_B)] {
            if complex.is_empty() {
                spelled.words.push((name, "{}".to_owned()));
            }
            let mut of_rank: [Vec<Vec<Vertex>>; 4] = Default::default();
            for &simplex in complex.maximal() {
                of_rank[usize::from(simplex.rank)].push(complex.vertices_of(simplex).to_vec());
            }
            let lists = keys.into_iter().zip(of_rank).filter(|(_, simplices)| !simplices.is_empty());
            spelled.lists.extend(lists.map(|(key, simplices)| {
                let is_point = simplices[0].len() == 1;
                List::new(key, if is_point { Items::Vertices(simplices.concat()) } else { Items::Tuples(simplices) })
            }));
        }
        Some(spelled)
    }
}

/// The `points`, `a` and `b` of a scene.
#[derive(Clone, Debug)]
pub(super) struct Written {
    file: String,
    points: PointSource,
    a: Side,
    b: Side,
    dimension: Dimension,
    round: bool,
}

/// A complex in a suite, with its line there.
#[derive(Clone, Debug)]
struct Side {
    line: usize,
    source: Source,
}

#[derive(Clone, Debug)]
enum Source {
    /// Simplices of the scene's points, each with its line.
    Written(Vec<(usize, Vec<Vertex>)>),
    /// An OFF, OBJ, PLY or STL file.
    Mesh(Origin),
    /// The points, lines and borders of a GeoJSON or WKT file.
    Geometry(Origin),
    /// The borders of an object of a TopoJSON file.
    Topology { origin: Origin, object: String },
    /// The borders of polygons in the suite.
    Polygons(ImportedMap),
    /// A copy of the first complex, moved by this many σ.
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
            Some(field) if !is_empty(&field) => {
                let points = PointSource::read(context, &field, fields.file())?;
                if points.is_written() {
                    of_dimension(&points, dimension, &Cache::new(""))?;
                }
                points
            }
            _ => PointSource::none(dimension),
        };
        let a = Side::read(context, &fields.required("a")?, dimension, false)?;
        let b = Side::read(context, &fields.required("b")?, dimension, true)?;
        Ok(Written { file: fields.file().to_owned(), points, a, b, dimension, round: context.round() })
    }

    /// True if everything is written out in the suite.
    fn is_inline(&self) -> bool {
        let written =
            |side: &Side| matches!(side.source, Source::Written(_) | Source::Polygons(_) | Source::Shifted(_));
        self.points.is_written() && written(&self.a) && written(&self.b)
    }

    /// The source of a scene with these complexes.
    pub(super) fn source(self) -> Result<SceneSource, CorpusError> {
        if !self.is_inline() {
            return Ok(SceneSource::elsewhere(self));
        }
        // Nothing comes from the cache: everything is written out.
        Ok(SceneSource::Written(self.assemble(&Cache::new(""))?))
    }

    /// Reads the other files and puts both complexes into one scene: the points first, then those of `a`, then those of
    /// `b`.
    fn assemble(&self, cache: &Cache) -> Result<Parts, CorpusError> {
        let file = self.file.as_str();
        let decimals = Decimals::new(self.round);
        let (mut coordinates, mut notes) = of_dimension(&self.points, self.dimension, cache)?;
        let points = coordinates.len() / self.dimension.count();
        let mut sides = Vec::with_capacity(2);
        for side in [&self.a, &self.b] {
            let start = coordinates.len() / self.dimension.count();
            let given = match &side.source {
                Source::Written(simplices) => from_points(file, simplices, points)?,
                Source::Mesh(origin) => {
                    let (name, bytes) = origin.bytes(cache)?;
                    let mesh = mesh::read(&name, bytes, &decimals)?;
                    coordinates.extend(mesh.points.as_flattened());
                    notes.add(&mesh.notes);
                    let given = Simplices { edges: mesh.edges, triangles: mesh.triangles, ..Simplices::default() };
                    shifted(&given, |v| Vertex::input(v.index() + start))
                }
                Source::Geometry(origin) => {
                    let (name, bytes) = origin.bytes(cache)?;
                    let found = geometry::read(&name, bytes, &decimals)?.edges();
                    coordinates.extend(found.points.as_flattened());
                    notes.add(&found.notes);
                    let given = Simplices { vertices: found.vertices, edges: found.edges, ..Simplices::default() };
                    shifted(&given, |v| Vertex::input(v.index() + start))
                }
                Source::Topology { origin, object } => {
                    let (name, text) = origin.text(cache)?;
                    let map = topojson::read(&name, &text, object, &decimals)?;
                    borders(&map, start, &mut coordinates, &mut notes)
                }
                Source::Polygons(map) => borders(map, start, &mut coordinates, &mut notes),
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
            let cure = "give each complex its own points; they may have equal coordinates";
            return Err(CorpusError::file(file, message, cure).at_line(self.b.line));
        }
        notes.rounded += decimals.rounded();
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
        let of_sides = [&self.a, &self.b].into_iter().find_map(|side| match &side.source {
            Source::Topology { origin, .. } | Source::Geometry(origin) | Source::Mesh(origin) => origin.entry(),
            Source::Written(_) | Source::Polygons(_) | Source::Shifted(_) => None,
        });
        of_sides.or_else(|| self.points.entry())
    }
}

/// The points of these vertices, moved.
pub(super) fn moved<'s>(scene: &'s Scene, vertices: &'s [Vertex], by: f64) -> impl Iterator<Item = f64> + 's {
    let along = direction(scene.dimension());
    vertices.iter().flat_map(move |&v| scene.point(v).iter().zip(along).map(move |(x, along)| x + by * along))
}

fn is_empty(field: &Field<'_, '_>) -> bool {
    field.is_array() && field.items("an array of points").is_ok_and(|points| points.len() == 0)
}

/// The coordinates of the scene's points, which must have the task's dimension, and the changes made in reading them.
fn of_dimension(
    points: &PointSource,
    dimension: Dimension,
    cache: &Cache,
) -> Result<(Vec<f64>, ImportNotes), CorpusError> {
    let (found, coordinates, notes) = points.coordinates(cache)?;
    if found != dimension {
        let message =
            format!("contacts{0}d takes points with {0} coordinates, not {1}", dimension.count(), found.count());
        return Err(points.error(message, format!("give every point {} coordinates", dimension.count())));
    }
    Ok((coordinates, notes))
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
        let polygons = table.get("polygons");
        let copied = if is_second { table.get("shifted") } else { None };
        let flat = |this: &Field<'_, '_>| match dimension {
            Dimension::Two => Ok(()),
            Dimension::Three => Err(this.error("a map has points of two coordinates", "use maps for contacts2d")),
        };
        let object = || table.required("object")?.string();
        let source = match (path, map, fetch, polygons, copied) {
            (Some(path), None, None, None, None) => {
                let origin = Origin::path(context, &path)?;
                if dimension == Dimension::Two { Source::Geometry(origin) } else { Source::Mesh(origin) }
            }
            (None, Some(path), None, None, None) => {
                flat(&path)?;
                Source::Topology { origin: Origin::path(context, &path)?, object: object()? }
            }
            (None, None, Some(key), None, None) => {
                let origin = Origin::fetched(context, &key)?;
                match (dimension, table.get("object")) {
                    (Dimension::Two, Some(object)) => Source::Topology { origin, object: object.string()? },
                    (Dimension::Two, None) => Source::Geometry(origin),
                    (Dimension::Three, _) => Source::Mesh(origin),
                }
            }
            (None, None, None, Some(polygons), None) => {
                flat(&polygons)?;
                Source::Polygons(read_polygons(&polygons)?)
            }
            (None, None, None, None, Some(by)) => Source::Shifted(by.positive()?),
            (None, None, None, None, None) => Source::Written(simplices(&table, dimension)?),
            _ => {
                let cure = "keep one of `path`, `topojson`, `fetch`, `polygons` and `shifted`";
                return Err(field.error("a complex with more than one source", cure));
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
            return error(format!("a simplex has point {twice} twice"), "name different points");
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

/// Every border of a map, once. Its points are appended to the coordinates.
fn borders(imported: &ImportedMap, start: usize, coordinates: &mut Vec<f64>, notes: &mut ImportNotes) -> Simplices {
    coordinates.extend(imported.points.as_flattened());
    notes.add(&imported.notes);
    let edges = imported.map.edges().map(|(_, edge)| edge.map(|v| Vertex::input(v.index() + start))).collect();
    Simplices { edges, ..Simplices::default() }
}

/// The same simplices with other vertices.
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
