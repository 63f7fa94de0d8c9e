//! The keys of the task: `mesh`, or `points` and `faces`; `planes`; `closed`.

use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Items, Level, List, Origin, Parts, PointSource, Source as SceneSource, Spelled,
    spelled_points,
};
use predicament_formats::{Cache, CorpusError, Decimals, Entry, Field, Fields, ImportNotes, Places, TableKind, mesh};
use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::IndexedFaces;
use predicament_predicates::{Dimension, Question, Scene, Sign, Vertex};

use super::faces::{Wrong, faces_of};
use crate::checks::given::{self, Fault};

static MESH: TableKind = TableKind::new("reference to a mesh", &["path", "fetch"]);

/// A mesh and the planes that split it.
#[derive(Clone, PartialEq, Debug)]
pub struct Solid {
    /// The faces, over the first vertices of the scene, counterclockwise as seen from outside.
    pub faces: IndexedFaces,
    /// The number of vertices of the mesh.
    pub vertices: usize,
    /// For each face, three of its vertices that turn as it does.
    pub supports: Vec<[Vertex; 3]>,
    /// The planes in their order, as three vertices each.
    pub planes: Vec<[Vertex; 3]>,
    /// True if the mesh has no boundary.
    pub is_closed: bool,
}

impl Solid {
    /// The mesh to split.
    ///
    /// # Panics
    /// If the faces do not make a mesh; readers of scenes exclude that.
    #[must_use]
    pub fn mesh(&self) -> HalfEdgeMesh {
        let vertices = (0..self.vertices).map(Vertex::input).collect();
        HalfEdgeMesh::new(vertices, &self.faces).unwrap_or_else(|why| panic!("a scene without a valid mesh: {why}"))
    }
}

impl Solid {
    /// The reason why the faces are not a mesh to slice.
    pub(super) fn fault(&self, scene: &Scene) -> Option<Fault> {
        let face = |face: &[u32]| face.iter().map(|&corner| Vertex::input(corner as usize)).collect();
        given::fault(scene, &self.faces.iter().map(face).collect::<Vec<_>>(), self.is_closed)
    }
}

impl Content for Solid {
    fn count(&self) -> usize {
        self.faces.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("slice");
        for face in self.faces.iter() {
            canon.count(face.len());
            face.iter().for_each(|&corner| canon.count(corner as usize));
        }
        canon.vertices(self.planes.as_flattened());
    }

    /// Writes vertices that only planes have as ordinary points. The output does not say if the mesh must be closed.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let face = |face: &[u32]| face.iter().map(|&corner| Vertex::input(corner as usize)).collect();
        let lists = vec![
            List::required("faces", Items::Loops(self.faces.iter().map(face).collect())),
            List::required("planes", Items::tuples(&self.planes)),
        ];
        Some(Spelled { lists, ..spelled_points(scene) })
    }
}

/// A point of the three that span a plane.
#[derive(Clone, Copy, Debug)]
enum PlanePoint {
    Index(Vertex),
    Coordinates([f64; 3]),
}

/// A plane, with its line.
type WrittenPlane = (usize, [PlanePoint; 3]);

/// The faces, and the source of the points.
enum Where {
    /// Faces with their lines.
    Written {
        points: PointSource,
        faces: Vec<(usize, Vec<u32>)>,
    },
    File {
        origin: Origin,
        round: bool,
    },
}

struct Written {
    file: String,
    line: usize,
    mesh: Where,
    /// Optional; the default is three planes through the middle.
    planes: Option<Vec<WrittenPlane>>,
    needs_closed: bool,
    /// True if the scene is marked as invalid input.
    is_invalid: bool,
}

/// Reads a scene.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<SceneSource, CorpusError> {
    let mesh = match fields.get("mesh") {
        Some(field) => {
            let table = field.fields(&MESH)?;
            let origin = match table.get("fetch") {
                Some(key) => Origin::fetched(context, &key)?,
                None => Origin::path(context, &table.required("path")?)?,
            };
            table.finish()?;
            Where::File { origin, round: context.round() }
        }
        None => {
            let points = fields
                .required("points")
                .map_err(|missing| fields.lacking("`mesh`, or `points` and `faces`", missing))?;
            let points = PointSource::read(context, &points, fields.file())?;
            Where::Written { points, faces: written_faces(&fields.required("faces")?)? }
        }
    };
    let planes = fields.get("planes").map(|field| written_planes(&field)).transpose()?;
    let needs_closed = fields.bool_or("closed", false)?;
    let (file, line, is_invalid) = (fields.file().to_owned(), fields.line(), context.is_invalid());
    let written = Written { file, line, mesh, planes, needs_closed, is_invalid };
    if matches!(&written.mesh, Where::Written { points, .. } if points.is_written()) {
        // No cache is read: all coordinates are in the suite.
        return Ok(SceneSource::Written(written.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(SceneSource::elsewhere(written))
}

fn written_faces(field: &Field<'_, '_>) -> Result<Vec<(usize, Vec<u32>)>, CorpusError> {
    let faces = field.items("arrays with the indices of points")?;
    let face = |item: Field<'_, '_>| {
        let corners = item.items("the indices of the corners of a face")?;
        let corner = |corner: Field<'_, '_>| {
            let v = corner.point()?;
            u32::try_from(v.index()).map_err(|_| corner.error("no such point", "indices count from 0"))
        };
        Ok((item.line(), corners.map(corner).collect::<Result<_, _>>()?))
    };
    faces.map(face).collect()
}

fn written_planes(field: &Field<'_, '_>) -> Result<Vec<WrittenPlane>, CorpusError> {
    const CURE: &str = "write three points for each plane, as indices or as arrays of three coordinates";
    let planes = field.items("arrays of three points")?;
    let plane = |item: Field<'_, '_>| {
        let points = item.items("three points, as indices or as arrays of three coordinates")?;
        let point = |point: Field<'_, '_>| {
            if !point.is_array() {
                return point.point().map(PlanePoint::Index);
            }
            let coordinates = point.items("three coordinates")?.map(|x| x.coordinate());
            let coordinates: Vec<f64> = coordinates.collect::<Result<_, _>>()?;
            let count = coordinates.len();
            let coordinates = <[f64; 3]>::try_from(coordinates);
            coordinates
                .map(PlanePoint::Coordinates)
                .map_err(|_| point.error(format!("a point with {count} coordinates"), CURE))
        };
        let points: Vec<PlanePoint> = points.map(point).collect::<Result<_, _>>()?;
        let count = points.len();
        let points = <[PlanePoint; 3]>::try_from(points);
        Ok((item.line(), points.map_err(|_| item.error(format!("a plane with {count} points"), CURE))?))
    };
    planes.map(plane).collect()
}

impl Elsewhere for Written {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (file, mut coordinates, faces, places, notes) = self.mesh.load(cache)?;
        let count = coordinates.len() / 3;
        // Points after the last corner of a face are for planes.
        let last = faces.iter().flatten().max();
        let vertices = last.map_or(count, |&last| count.min(last as usize + 1));
        // A mesh in a separate file has no line in the suite.
        let line = matches!(self.mesh, Where::Written { .. }).then_some(self.line);
        let error = |message: String, cure: &str, line| CorpusError::file(&self.file, message, cure).at_line(line);
        let mut planes = Vec::new();
        for (line, points) in self.planes(&coordinates) {
            let place = |point: PlanePoint| match point {
                PlanePoint::Index(v) if v.index() < count => Ok(v),
                PlanePoint::Index(v) => {
                    let message = format!("index {v} is out of range: the mesh has {count} points");
                    Err(error(message, "indices count from 0", line))
                }
                PlanePoint::Coordinates(point) => {
                    coordinates.extend(point);
                    Ok(Vertex::input(coordinates.len() / 3 - 1))
                }
            };
            let [a, b, c] = points.map(place);
            planes.push((line, [a?, b?, c?]));
        }
        if coordinates.iter().any(|x| !x.is_finite()) {
            let message = "the planes through the middle of the mesh exceed the range of doubles".to_owned();
            return Err(error(message, "write `planes`, or scale the mesh", self.line));
        }
        let scene = Scene::new(Dimension::Three, coordinates)
            .map_err(|why| CorpusError::file(&self.file, why.to_string(), "correct the points").at_line(self.line))?;
        for &(line, plane) in &planes {
            if is_line(&scene, plane) {
                let [a, b, c] = plane;
                let message = format!("points {a}, {b} and {c} of a plane are on a line");
                return Err(error(message, "name three points that are not on a line", line));
            }
        }
        let planes = planes.into_iter().map(|(_, plane)| plane).collect();
        let solid = solid(&scene, vertices, faces, planes).map_err(|wrong| wrong.error(&file, &places, line))?;
        if self.needs_closed
            && let Some(wrong) = open_edge(&solid)
        {
            return Err(wrong.error(&file, &places, line));
        }
        if let Some(fault) = solid.fault(&scene).filter(|_| !self.is_invalid) {
            return Err(Wrong::Fault(fault).error(&file, &places, line));
        }
        Ok(Parts { notes, ..Parts::new(scene, solid) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        match &self.mesh {
            Where::File { origin, .. } => origin.entry(),
            Where::Written { points, .. } => points.entry(),
        }
    }
}

/// A file's name, its coordinates, its faces, their places in the file, and the changes made by reading.
type Loaded = (String, Vec<f64>, IndexedFaces, Places, ImportNotes);

impl Where {
    fn load(&self, cache: &Cache) -> Result<Loaded, CorpusError> {
        match self {
            Where::File { origin, round } => {
                let decimals = Decimals::new(*round);
                let (file, bytes) = origin.bytes(cache)?;
                let mesh = mesh::read(&file, bytes, &decimals)?;
                let mut notes = mesh.notes;
                notes.rounded += decimals.rounded();
                Ok((file, mesh.points.as_flattened().to_vec(), mesh.faces, mesh.places, notes))
            }
            Where::Written { points, faces } => {
                let (dimension, coordinates, notes) = points.coordinates(cache)?;
                if dimension != Dimension::Three {
                    return Err(
                        points.error("slice takes points with 3 coordinates, not 2", "give every point 3 coordinates")
                    );
                }
                let places = Places::of_lines(faces.iter().map(|(line, _)| *line));
                let faces = faces.iter().map(|(_, corners)| corners.iter().copied()).collect();
                let file = points.error("", "").file;
                Ok((file, coordinates, faces, places, notes))
            }
        }
    }
}

impl Written {
    /// The planes as written, or three planes through the middle of the box, one across each axis.
    fn planes(&self, coordinates: &[f64]) -> Vec<WrittenPlane> {
        if let Some(planes) = &self.planes {
            return planes.clone();
        }
        let points: &[[f64; 3]] = coordinates.as_chunks().0;
        let along = |axis: usize| points.iter().map(move |p| p[axis]);
        let low = [0, 1, 2].map(|axis| along(axis).fold(f64::INFINITY, f64::min));
        let high = [0, 1, 2].map(|axis| along(axis).fold(f64::NEG_INFINITY, f64::max));
        let middle = [0, 1, 2].map(|axis| low[axis] + 0.5 * (high[axis] - low[axis]));
        let size = [0, 1, 2].map(|axis| high[axis] - low[axis]).into_iter().fold(0.0, f64::max);
        let moved = |axis: usize| {
            let mut point = middle;
            point[axis] += size;
            PlanePoint::Coordinates(point)
        };
        let plane = |axis: usize| [PlanePoint::Coordinates(middle), moved((axis + 1) % 3), moved((axis + 2) % 3)];
        if points.is_empty() { Vec::new() } else { [0, 1, 2].map(|axis| (self.line, plane(axis))).to_vec() }
    }
}

/// The mesh of the faces with planes, or the reason why a face is invalid.
pub(super) fn solid(
    scene: &Scene,
    vertices: usize,
    faces: IndexedFaces,
    planes: Vec<[Vertex; 3]>,
) -> Result<Solid, Wrong> {
    let (supports, is_closed) = faces_of(scene, vertices, &faces)?;
    Ok(Solid { faces, vertices, supports, planes, is_closed })
}

pub(super) fn is_line(scene: &Scene, [a, b, c]: [Vertex; 3]) -> bool {
    use predicament_predicates::Plane::{Xy, Yz, Zx};
    let turns = |plane| predicament_judge::sign(scene, Question::Orient2d(plane), &[a, b, c]);
    a == b || b == c || a == c || [Xy, Yz, Zx].into_iter().all(|plane| turns(plane) == Sign::Zero)
}

/// An edge with a face on one side only, if any.
fn open_edge(solid: &Solid) -> Option<Wrong> {
    if solid.is_closed {
        return None;
    }
    let mesh = solid.mesh();
    let open = mesh.half_edges().find(|&h| mesh.is_boundary(mesh.opposite(h)) && !mesh.is_boundary(h))?;
    let edge = [mesh.start(open), mesh.end(open)].map(|v| mesh.scene_vertex(v));
    mesh.face(open).map(|face| Wrong::Open { face: face.index(), edge })
}
