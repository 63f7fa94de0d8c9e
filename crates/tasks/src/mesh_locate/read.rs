//! `mesh`, or `points` with `triangles` and `regions`, or with `tetrahedra`; `probes`, and how to choose more.

use predicament_corpus::{Context, Elsewhere, Level, Origin, Parts, PointSource, Source};
use predicament_formats::{Cache, CorpusError, Decimals, Entry, Field, Fields, ImportNotes, Places, TableKind, mesh};
use predicament_judge::sign;
use predicament_mesh::{MaterialError, MaterialMesh, OUTSIDE};
use predicament_predicates::{Dimension, Question, Scene, Sign, Vertex};

use super::probes::{Probing, Surface, with_probes};

static MESH: TableKind = TableKind::new("reference to a mesh", &["path", "fetch"]);

/// More regions than this are a slip of the pen.
const MOST_REGIONS: u64 = 1 << 31;

/// Simplices with their lines.
type Simplices<const N: usize> = Vec<(usize, [Vertex; N])>;

enum Where {
    Triangles { points: PointSource, triangles: Simplices<3>, regions: Option<Vec<[u32; 2]>> },
    Tetrahedra { points: PointSource, tetrahedra: Simplices<4> },
    File { origin: Origin, round: bool },
}

struct Written {
    file: String,
    line: usize,
    mesh: Where,
    probing: Probing,
}

/// Reads a scene.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let mut probing = Probing::read(fields)?;
    if let Some(field) = fields.get("probes") {
        probing.given = given(&field)?;
    }
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
        None => written(context, fields)?,
    };
    let written = Written { file: fields.file().to_owned(), line: fields.line(), mesh, probing };
    Ok(Source::elsewhere(written))
}

fn written(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Where, CorpusError> {
    const NEEDED: &str = "`mesh`, or `points` with `triangles` or `tetrahedra`";
    let points = fields.required("points").map_err(|missing| fields.lacking(NEEDED, missing))?;
    let points = PointSource::read(context, &points, fields.file())?;
    match (fields.get("triangles"), fields.get("tetrahedra")) {
        (Some(triangles), None) => {
            let triangles: Simplices<3> = simplices(&triangles, "a triangle")?;
            let regions = fields.get("regions").map(|field| regions(&field, triangles.len())).transpose()?;
            Ok(Where::Triangles { points, triangles, regions })
        }
        (None, Some(tetrahedra)) => {
            Ok(Where::Tetrahedra { points, tetrahedra: simplices(&tetrahedra, "a tetrahedron")? })
        }
        (Some(_), Some(second)) => {
            Err(second.error("both `triangles` and `tetrahedra`", "keep one: the triangles of tetrahedra are found"))
        }
        (None, None) => Err(fields.error("a mesh without `triangles` or `tetrahedra`", format!("write {NEEDED}"))),
    }
}

fn simplices<const N: usize>(field: &Field<'_, '_>, what: &str) -> Result<Simplices<N>, CorpusError> {
    let items = field.items("arrays of the indices of points")?;
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

fn regions(field: &Field<'_, '_>, triangles: usize) -> Result<Vec<[u32; 2]>, CorpusError> {
    const CURE: &str = "write for each triangle the region in front of it and the one behind, 0 for outside";
    let pair = |item: Field<'_, '_>| {
        let pair: Vec<u64> = item
            .items("two numbers of regions")?
            .map(|region| region.integer(0..=MOST_REGIONS))
            .collect::<Result<_, _>>()?;
        let [front, behind] = pair[..] else {
            return Err(item.error(format!("{} regions of a triangle", pair.len()), CURE));
        };
        Ok([front, behind].map(|region| u32::try_from(region).expect("in range")))
    };
    let pairs: Vec<[u32; 2]> = field.items("pairs of numbers of regions")?.map(pair).collect::<Result<_, _>>()?;
    if pairs.len() != triangles {
        return Err(field.error(format!("{} pairs of regions for {triangles} triangles", pairs.len()), CURE));
    }
    Ok(pairs)
}

fn given(field: &Field<'_, '_>) -> Result<Vec<[f64; 3]>, CorpusError> {
    let point = |item: Field<'_, '_>| {
        let point: Vec<f64> = item.items("three coordinates")?.map(|x| x.coordinate()).collect::<Result<_, _>>()?;
        let count = point.len();
        <[f64; 3]>::try_from(point).map_err(|_| item.error(format!("a probe of {count} coordinates"), "give it three"))
    };
    field.items("points of three coordinates")?.map(point).collect()
}

impl Elsewhere for Written {
    fn load(&self, level: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (surface, notes) = match &self.mesh {
            Where::Triangles { points, triangles, regions } => {
                let (points, notes) = self.points(points, cache)?;
                let places = Places::of_lines(triangles.iter().map(|(line, _)| *line));
                let corners: Vec<[Vertex; 3]> = triangles.iter().map(|(_, corners)| *corners).collect();
                let sides = regions.clone().unwrap_or_else(|| vec![[OUTSIDE, 1]; corners.len()]);
                let mesh = MaterialMesh::new(points.len(), corners, sides)
                    .map_err(|why| wrong(&self.file, Some(self.line), &places, &why, |triangle| triangle))?;
                (Surface { points, mesh, tetrahedra: Vec::new() }, notes)
            }
            Where::Tetrahedra { points, tetrahedra } => {
                let (points, notes) = self.points(points, cache)?;
                (self.tetrahedra(points, tetrahedra)?, notes)
            }
            Where::File { origin, round } => {
                let decimals = Decimals::new(*round);
                let (file, bytes) = origin.bytes(cache)?;
                let read = mesh::read(&file, bytes, &decimals)?;
                // Which face each triangle is of.
                let faces: Vec<usize> = read
                    .faces
                    .iter()
                    .enumerate()
                    .flat_map(|(face, corners)| std::iter::repeat_n(face, corners.len() - 2))
                    .collect();
                let mesh = MaterialMesh::of_closed(read.points.len(), read.triangles)
                    .map_err(|why| wrong(&file, None, &read.places, &why, |triangle| faces[triangle]))?;
                let mut notes = read.notes;
                notes.rounded += decimals.rounded();
                (Surface { points: read.points, mesh, tetrahedra: Vec::new() }, notes)
            }
        };
        Ok(Parts { notes, ..with_probes(surface, &self.probing, level) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        match &self.mesh {
            Where::File { origin, .. } => origin.entry(),
            Where::Triangles { points, .. } | Where::Tetrahedra { points, .. } => points.entry(),
        }
    }
}

impl Written {
    fn points(&self, points: &PointSource, cache: &Cache) -> Result<(Vec<[f64; 3]>, ImportNotes), CorpusError> {
        let (dimension, coordinates, notes) = points.coordinates(cache)?;
        if dimension != Dimension::Three {
            let message = "mesh-locate takes points of 3 coordinates, not of 2";
            return Err(points.error(message, "give every point 3 coordinates"));
        }
        let coordinates: Vec<[f64; 3]> = coordinates.as_chunks().0.to_vec();
        if coordinates.as_flattened().iter().any(|x| !x.is_finite()) {
            return Err(points.error("a coordinate that is not finite", "correct the points"));
        }
        Ok((coordinates, notes))
    }

    /// Tetrahedra, each turned so that its sign is positive.
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
            .map_err(|why| wrong(&self.file, Some(self.line), &places, &why, |_| usize::MAX))?;
        Ok(Surface { points, mesh, tetrahedra })
    }
}

/// The error at the first bad element.
fn wrong(
    file: &str,
    line: Option<usize>,
    places: &Places,
    why: &MaterialError,
    face: impl Fn(usize) -> usize,
) -> CorpusError {
    let name = |triangle: usize| places.face_name(face(triangle));
    let (message, cure) = match why {
        MaterialError::Open { edge: [a, b], region, triangle, triangles } => {
            let [a, b] = [a, b].map(|v| places.point_name(v.index()));
            let message = format!(
                "region {region} is not closed at the edge of vertices {a} and {b}: of the {triangles} triangle(s) there, {} among them, more go \
                 one way around it than the other",
                name(*triangle)
            );
            (message, "close the mesh, turn the triangle over, or correct the regions beside it")
        }
        MaterialError::NoSuchVertex { triangle, vertex } => (
            format!("triangle {} has vertex {vertex}, and the mesh has no such point", name(*triangle)),
            "indices count from 0",
        ),
        MaterialError::Repeated { triangle, vertex } => {
            (format!("triangle {} has vertex {vertex} twice", name(*triangle)), "remove it, and join its neighbours")
        }
        MaterialError::Overlap { tetrahedra: [s, t], .. } => {
            let message = format!("{why} ({} and {})", places.face_name(*s), places.face_name(*t));
            return CorpusError::file(file, message, "remove one of them")
                .at(places.face(*t).or(line.map(predicament_formats::Position::Line)));
        }
        MaterialError::Empty => ("a mesh without triangles".to_owned(), "give it some"),
        MaterialError::TooMany => (why.to_string(), "divide the mesh"),
    };
    let position = why.triangle().and_then(|triangle| places.face(face(triangle)));
    CorpusError::file(file, message, cure).at(position.or(line.map(predicament_formats::Position::Line)))
}
