//! The keys of the task: `mesh`, or `points` with `triangles`, each optionally with `regions`; or `points` with
//! `tetrahedra`; `probes`, and rules for more.

use predicament_corpus::{Context, Elsewhere, Level, Origin, Parts, PointSource, Source};
use predicament_formats::mesh::ImportedMesh;
use predicament_formats::{
    Cache, CorpusError, Entry, Field, Fields, ImportNotes, MOST_COORDINATES, Places, Position, TableKind,
};
use predicament_judge::sign;
use predicament_mesh::{MaterialError, MaterialMesh, OUTSIDE};
use predicament_predicates::{Dimension, Question, Scene, Sign, Vertex};

use super::mesh_file::MeshFile;
use super::probes::{Probing, Surface, with_probes};
use super::regions::{Pairs, Regions};

static MESH: TableKind = TableKind::new("reference to a mesh", &["path", "fetch"]);

/// Simplices with their lines.
pub type Simplices<const N: usize> = Vec<(usize, [Vertex; N])>;

enum Where {
    Triangles { points: PointSource, triangles: Simplices<3>, regions: Option<Regions> },
    Tetrahedra { points: PointSource, tetrahedra: Simplices<4> },
    File(MeshSource),
}

/// A mesh in a file, with its regions there or in another file.
pub struct MeshSource {
    /// The file.
    pub origin: Origin,
    /// True if decimals that are not doubles are rounded.
    pub round: bool,
    /// The regions, if they are not in the mesh file.
    pub regions: Option<Regions>,
}

struct Written {
    file: String,
    line: usize,
    mesh: Where,
    probing: Probing,
    /// The probes, if they are in a file.
    probes: Option<PointSource>,
}

/// Reads a scene.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let mut probing = Probing::read(fields)?;
    let mut probes = None;
    if let Some(field) = fields.get("probes") {
        if field.is_table() {
            probes = Some(PointSource::read(context, &field, fields.file())?);
        } else {
            probing.given = given(&field)?;
        }
    }
    let mesh = match fields.get("mesh") {
        Some(field) => {
            for key in ["points", "triangles", "tetrahedra"] {
                if let Some(other) = fields.get(key) {
                    return Err(other.error(format!("both `mesh` and `{key}`"), "remove this one: the file has them"));
                }
            }
            let regions = fields.get("regions").map(|field| Regions::read(context, &field)).transpose()?;
            Where::File(MeshSource::read(context, &field, regions)?)
        }
        None => written(context, fields)?,
    };
    let written = Written { file: fields.file().to_owned(), line: fields.line(), mesh, probing, probes };
    Ok(Source::elsewhere(written))
}

fn written(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Where, CorpusError> {
    const NEEDED: &str = "`mesh`, or `points` with `triangles` or `tetrahedra`";
    let points = fields.required("points").map_err(|missing| fields.lacking(NEEDED, missing))?;
    let points = PointSource::read(context, &points, fields.file())?;
    match (fields.get("triangles"), fields.get("tetrahedra")) {
        (Some(triangles), None) => {
            let triangles: Simplices<3> = simplices(&triangles, "a triangle")?;
            let regions = fields.get("regions").map(|field| Regions::read(context, &field)).transpose()?;
            Ok(Where::Triangles { points, triangles, regions })
        }
        (None, Some(tetrahedra)) => {
            if let Some(regions) = fields.get("regions") {
                return Err(regions.error(
                    "`regions` beside `tetrahedra`",
                    "remove it: each tetrahedron is a region, the first is 1",
                ));
            }
            Ok(Where::Tetrahedra { points, tetrahedra: simplices(&tetrahedra, "a tetrahedron")? })
        }
        (Some(_), Some(second)) => {
            Err(second
                .error("both `triangles` and `tetrahedra`", "keep one: the tool finds the triangles of tetrahedra"))
        }
        (None, None) => Err(fields.error("a mesh without `triangles` or `tetrahedra`", format!("write {NEEDED}"))),
    }
}

/// Reads arrays of N point indices each, with their lines.
///
/// # Errors
/// The first line that is not such an array.
pub fn simplices<const N: usize>(field: &Field<'_, '_>, what: &str) -> Result<Simplices<N>, CorpusError> {
    let items = field.items("arrays with the indices of points")?;
    let simplex = |item: Field<'_, '_>| {
        let corners = item.items("the indices of the corners")?.map(|corner| corner.point());
        let corners: Vec<Vertex> = corners.collect::<Result<_, _>>()?;
        let count = corners.len();
        let corners = <[Vertex; N]>::try_from(corners);
        let corners = corners.map_err(|_| item.error(format!("{what} of {count} corners"), format!("give it {N}")))?;
        Ok((item.line(), corners))
    };
    items.map(simplex).collect()
}

fn given(field: &Field<'_, '_>) -> Result<Vec<[f64; 3]>, CorpusError> {
    let point = |item: Field<'_, '_>| {
        let point: Vec<f64> = item.items("three coordinates")?.map(|x| x.coordinate()).collect::<Result<_, _>>()?;
        let count = point.len();
        <[f64; 3]>::try_from(point)
            .map_err(|_| item.error(format!("a probe with {count} coordinates"), "give it three"))
    };
    field.items("points with three coordinates")?.map(point).collect()
}

impl MeshSource {
    /// Reads a table with `path` or `fetch`.
    pub fn read(
        context: &Context<'_>,
        field: &Field<'_, '_>,
        regions: Option<Regions>,
    ) -> Result<MeshSource, CorpusError> {
        let table = field.fields(&MESH)?;
        let origin = match table.get("fetch") {
            Some(key) => Origin::fetched(context, &key)?,
            None => Origin::path(context, &table.required("path")?)?,
        };
        table.finish()?;
        Ok(MeshSource { origin, round: context.round(), regions })
    }

    /// The file, which can be read again.
    fn file(&self, cache: &Cache) -> MeshFile {
        MeshFile { origin: self.origin.clone(), round: self.round, cache: cache.clone() }
    }

    /// The file's name, the positions of its faces, and the face of each triangle. The file is read again.
    ///
    /// # Errors
    /// As [`load`](MeshSource::load).
    pub fn places(&self, cache: &Cache) -> Result<(String, Places, Vec<usize>), CorpusError> {
        let (file, read, _) = self.file(cache).read()?;
        let faces = faces_of(&read);
        Ok((file, read.places, faces))
    }

    /// The mesh, and the changes made by reading.
    pub fn load(&self, cache: &Cache) -> Result<(Surface, ImportNotes), CorpusError> {
        let (file, read, rounded) = self.file(cache).read()?;
        let faces = faces_of(&read);
        let place = Place { file: &file, line: None, places: &read.places };
        let surface = place.surface(read.points, read.triangles, &faces, self.regions.as_ref(), cache)?;
        let mut notes = read.notes;
        notes.rounded += rounded;
        Ok((surface, notes))
    }
}

/// The face of each triangle.
fn faces_of(read: &ImportedMesh) -> Vec<usize> {
    let triangles = |(face, corners): (usize, &[u32])| std::iter::repeat_n(face, corners.len() - 2);
    read.faces.iter().enumerate().flat_map(triangles).collect()
}

impl Elsewhere for Written {
    fn load(&self, level: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let mut own = None;
        let (surface, mut notes) = match &self.mesh {
            Where::Triangles { points, triangles, regions } => {
                let (points, notes) = self.points("points", points, cache)?;
                let places = Places::of_lines(triangles.iter().map(|(line, _)| *line));
                let corners: Vec<[Vertex; 3]> = triangles.iter().map(|(_, corners)| *corners).collect();
                let faces: Vec<usize> = (0..corners.len()).collect();
                let place = Place { file: &self.file, line: Some(self.line), places: &places };
                (place.surface(points, corners, &faces, regions.as_ref(), cache)?, notes)
            }
            Where::Tetrahedra { points, tetrahedra } => {
                let (points, notes) = self.points("points", points, cache)?;
                (self.tetrahedra(points, tetrahedra)?, notes)
            }
            Where::File(of) => {
                own = Some(of.file(cache));
                of.load(cache)?
            }
        };
        let mut probing = self.probing.clone();
        if let Some(probes) = &self.probes {
            let (points, of_probes) = self.points("probes", probes, cache)?;
            notes.add(&of_probes);
            probing.given = points;
        }
        let probes = probing.exactly(surface.points.len(), surface.mesh.triangles().len(), level);
        if 3 * (surface.points.len() + probes) > MOST_COORDINATES {
            let message =
                format!("a mesh with {probes} probes has too many coordinates: a scene has at most {MOST_COORDINATES}");
            let cure = "choose fewer by `random` and `quick_stride` or `full_stride`";
            return Err(CorpusError::file(&self.file, message, cure).at_line(self.line));
        }
        Ok(Parts { notes, ..with_probes(surface, own, &probing, level) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        match &self.mesh {
            Where::File(of) => of.origin.entry(),
            Where::Triangles { points, .. } | Where::Tetrahedra { points, .. } => points.entry(),
        }
        .or(self.probes.as_ref().and_then(PointSource::entry))
    }
}

impl Written {
    fn points(
        &self,
        key: &str,
        points: &PointSource,
        cache: &Cache,
    ) -> Result<(Vec<[f64; 3]>, ImportNotes), CorpusError> {
        let (dimension, coordinates, notes) = points.coordinates(cache)?;
        if dimension != Dimension::Three {
            let message = format!("`{key}` have 2 coordinates each; meshes need 3");
            return Err(points.error(message, "give every point 3 coordinates"));
        }
        let coordinates: Vec<[f64; 3]> = coordinates.as_chunks().0.to_vec();
        if coordinates.as_flattened().iter().any(|x| !x.is_finite()) {
            return Err(points.error("a coordinate that is not finite", "correct the points"));
        }
        Ok((coordinates, notes))
    }

    /// Builds the mesh of tetrahedra, each turned so that its sign is positive.
    fn tetrahedra(&self, points: Vec<[f64; 3]>, tetrahedra: &Simplices<4>) -> Result<Surface, CorpusError> {
        let places = Places::of_lines(tetrahedra.iter().map(|(line, _)| *line));
        let error = |message: String, cure: &str, line| CorpusError::file(&self.file, message, cure).at_line(line);
        let scene =
            Scene::from_points3(&points).map_err(|why| error(why.to_string(), "correct the points", self.line))?;
        let turned = |&(line, [a, b, c, d]): &(usize, [Vertex; 4])| {
            if let Some(v) = [a, b, c, d].into_iter().find(|v| v.index() >= points.len()) {
                return Err(error(
                    format!("index {v} is out of range: the mesh has {} points", points.len()),
                    "indices count from 0",
                    line,
                ));
            }
            match sign(&scene, Question::Orient3d, &[a, b, c, d]) {
                Sign::Positive => Ok([a, b, c, d]),
                Sign::Negative => Ok([b, a, c, d]),
                Sign::Zero => {
                    let message = format!("the tetrahedron of {a}, {b}, {c} and {d} has no volume");
                    Err(error(message, "remove it, and join its neighbours", line))
                }
            }
        };
        let tetrahedra: Vec<[Vertex; 4]> = tetrahedra.iter().map(turned).collect::<Result<_, _>>()?;
        let mesh = MaterialMesh::of_tetrahedra(points.len(), &tetrahedra)
            .map_err(|why| Place { file: &self.file, line: Some(self.line), places: &places }.wrong(&why, &[], None))?;
        Ok(Surface { points, mesh, tetrahedra })
    }
}

/// The place where the faces of a mesh are written.
pub struct Place<'p> {
    /// The file's name.
    pub file: &'p str,
    /// The line of the scene, if the mesh is in a suite.
    pub line: Option<usize>,
    /// The line of each face.
    pub places: &'p Places,
}

impl Place<'_> {
    /// Builds a mesh of triangles; `faces` has the face of each. Without `regions`, region 1 is behind all triangles.
    pub fn surface(
        &self,
        points: Vec<[f64; 3]>,
        corners: Vec<[Vertex; 3]>,
        faces: &[usize],
        regions: Option<&Regions>,
        cache: &Cache,
    ) -> Result<Surface, CorpusError> {
        let count = faces.last().map_or(0, |last| last + 1);
        let pairs = regions.map(|regions| regions.load(cache, count)).transpose()?;
        let side = |&face: &usize| pairs.as_ref().map_or([OUTSIDE, 1], |pairs| pairs.of(face));
        let mesh = MaterialMesh::new(points.len(), corners, faces.iter().map(side).collect())
            .map_err(|why| self.wrong(&why, faces, pairs.as_ref()))?;
        Ok(Surface { points, mesh, tetrahedra: Vec::new() })
    }

    /// The error at the first bad element.
    fn wrong(&self, why: &MaterialError, faces: &[usize], regions: Option<&Pairs>) -> CorpusError {
        let Place { file, line, places } = *self;
        let line = line.map(Position::Line);
        let name = |triangle: usize| places.face_name(faces[triangle]);
        let (message, cure) = match why {
            MaterialError::Open { edge: [a, b], region, triangle, triangles } => {
                let [a, b] = [a, b].map(|v| places.point_name(v.index()));
                let message = format!(
                    "region {region} is not closed at the edge of vertices {a} and {b}: its {triangles} triangle(s) \
                     there, such as {}, do not use the edge equally often in both directions",
                    name(*triangle)
                );
                let beside = match regions {
                    Some(regions) => format!("correct its regions at {}", regions.place(faces[*triangle])),
                    None => "give each face its `regions`".to_owned(),
                };
                (message, format!("close the mesh, turn the triangle over, or {beside}"))
            }
            MaterialError::NoSuchVertex { triangle, vertex } => (
                format!("triangle {} has vertex {vertex}, but the mesh has no such point", name(*triangle)),
                "indices count from 0".to_owned(),
            ),
            MaterialError::Repeated { triangle, vertex } => (
                format!("triangle {} has vertex {vertex} twice", name(*triangle)),
                "remove it, and join its neighbours".to_owned(),
            ),
            MaterialError::Overlap { tetrahedra: [s, t], face: [a, b, c] } => {
                let [first, second] = [s, t].map(|tetrahedron| places.face_name(*tetrahedron));
                let message = format!(
                    "tetrahedra {first} and {second} are on the same side of the face of vertices {a}, {b} and {c}"
                );
                return CorpusError::file(file, message, "remove one of them").at(places.face(*t).or(line));
            }
            MaterialError::Empty => ("a mesh without triangles".to_owned(), "give it some".to_owned()),
            MaterialError::TooMany => (why.to_string(), "divide the mesh".to_owned()),
        };
        let position = why.triangle().and_then(|triangle| places.face(faces[triangle]));
        CorpusError::file(file, message, cure).at(position.or(line))
    }
}
