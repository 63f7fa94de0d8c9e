//! The keys of the task: `first` and `second`, as triangles of `points`, or meshes in files; `first_regions` and
//! `second_regions`, `moved` and `check`.

use predicament_corpus::{Context, Elsewhere, Level, Parts, PointSource, Source};
use predicament_formats::{Cache, CorpusError, Entry, Field, Fields, ImportNotes, Places};
use predicament_judge::sign;
use predicament_mesh::MaterialMesh;
use predicament_predicates::Plane::{Xy, Yz, Zx};
use predicament_predicates::{Dimension, Question, Scene, Vertex};

use super::content::with_meshes;
use super::flaw::{CHECKED, Flaw, flaw};
use predicament_mesh_locate::task::read::{MeshSource, Place, Simplices, simplices};
use predicament_mesh_locate::task::regions::Regions;

/// An operand: one of the two meshes, as the suite gives it.
enum Operand {
    Triangles { triangles: Simplices<3>, regions: Option<Regions> },
    File(MeshSource),
}

struct Written {
    file: String,
    line: usize,
    /// The points of triangles in the suite; `None` if both meshes are in files.
    points: Option<PointSource>,
    operands: [Operand; 2],
    /// The vector added to the points of the second mesh.
    moved: Option<[f64; 3]>,
    /// True if meshes are checked; by default only small ones are.
    check: Option<bool>,
    /// True if the scene is marked as invalid input.
    is_invalid: bool,
}

/// Reads a scene.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let operand = |key: &'static str, regions: &'static str| {
        let field = fields.required(key)?;
        let regions = fields.get(regions).map(|field| Regions::read(context, &field)).transpose()?;
        if field.is_table() {
            return MeshSource::read(context, &field, regions).map(Operand::File);
        }
        Ok(Operand::Triangles { triangles: simplices(&field, "a triangle")?, regions })
    };
    let operands = [operand("first", "first_regions")?, operand("second", "second_regions")?];
    let points = match fields.get("points") {
        None if operands.iter().any(|operand| matches!(operand, Operand::Triangles { .. })) => {
            return Err(fields.error("triangles without `points`", "give the `points` of the mesh"));
        }
        points => points.map(|field| PointSource::read(context, &field, fields.file())).transpose()?,
    };
    let moved = fields.get("moved").map(|field| moved(&field, &operands[1])).transpose()?;
    let check = fields.get("check").map(|field| field.bool()).transpose()?;
    let (file, line) = (fields.file().to_owned(), fields.line());
    let is_invalid = context.is_invalid();
    Ok(Source::elsewhere(Written { file, line, points, operands, moved, check, is_invalid }))
}

/// The vector by which the second mesh is moved.
fn moved(field: &Field<'_, '_>, second: &Operand) -> Result<[f64; 3], CorpusError> {
    if !matches!(second, Operand::File(_)) {
        return Err(field.error("`moved` is for a second mesh in a file", "write the moved points themselves"));
    }
    let by: Vec<f64> = field.items("three coordinates")?.map(|x| x.coordinate()).collect::<Result<_, _>>()?;
    let count = by.len();
    <[f64; 3]>::try_from(by).map_err(|_| field.error(format!("a move with {count} coordinates"), "give it three"))
}

impl Elsewhere for Written {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let mut notes = ImportNotes::default();
        let mut coordinates: Vec<[f64; 3]> = Vec::new();
        if let Some(points) = &self.points {
            let (dimension, read, of_points) = points.coordinates(cache)?;
            if dimension != Dimension::Three {
                let message = "`points` have 2 coordinates each; meshes need 3";
                return Err(points.error(message, "give every point 3 coordinates"));
            }
            coordinates = read.as_chunks().0.to_vec();
            notes.add(&of_points);
        }
        let written = coordinates.clone();
        let mut meshes = Vec::with_capacity(2);
        for operand in &self.operands {
            meshes.push(match operand {
                Operand::Triangles { triangles, regions } => {
                    let places = Places::of_lines(triangles.iter().map(|(line, _)| *line));
                    let corners: Vec<[Vertex; 3]> = triangles.iter().map(|(_, corners)| *corners).collect();
                    let faces: Vec<usize> = (0..corners.len()).collect();
                    let place = Place { file: &self.file, line: Some(self.line), places: &places };
                    place.surface(written.clone(), corners, &faces, regions.as_ref(), cache)?.mesh
                }
                Operand::File(of) => {
                    let (mut surface, of_file) = of.load(cache)?;
                    if let (1, Some(by)) = (meshes.len(), self.moved) {
                        for point in &mut surface.points {
                            point.iter_mut().zip(by).for_each(|(x, by)| *x += by);
                        }
                    }
                    notes.add(&of_file);
                    let first = coordinates.len();
                    coordinates.extend(surface.points);
                    surface.mesh.shifted(first)
                }
            });
        }
        let scene =
            Scene::from_points3(&coordinates).map_err(|why| self.error(why.to_string(), "correct the points"))?;
        let [first, second] = <[MaterialMesh; 2]>::try_from(meshes).expect("two operands");
        self.check(&scene, [&first, &second], cache)?;
        let is_as_it_is = self.check == Some(false) && !self.is_invalid;
        Ok(Parts { notes, ..with_meshes(scene, [first, second], is_as_it_is) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        let files = self.operands.iter().find_map(|operand| match operand {
            Operand::File(of) => of.origin.entry(),
            Operand::Triangles { .. } => None,
        });
        files.or(self.points.as_ref().and_then(PointSource::entry))
    }
}

impl Written {
    fn error(&self, message: impl Into<String>, cure: &str) -> CorpusError {
        CorpusError::file(&self.file, message.into(), cure).at_line(self.line)
    }

    /// Checks that each vertex is of one mesh, and each triangle has an area.
    fn check(&self, scene: &Scene, meshes: [&MaterialMesh; 2], cache: &Cache) -> Result<(), CorpusError> {
        let mut of_first = vec![false; scene.len()];
        meshes[0].triangles().as_flattened().iter().for_each(|v| of_first[v.index()] = true);
        if let Some(v) = meshes[1].triangles().as_flattened().iter().find(|v| of_first[v.index()]) {
            return Err(self.error(format!("both meshes use point {v}"), "give each mesh its own points"));
        }
        for (mesh, name) in meshes.into_iter().zip(["first", "second"]) {
            let is_flat = |&[a, b, c]: &[Vertex; 3]| {
                [Xy, Yz, Zx].into_iter().all(|plane| sign(scene, Question::Orient2d(plane), &[a, b, c]).is_zero())
            };
            if let Some(at) = mesh.triangles().iter().position(is_flat) {
                let message = format!("triangle {at} of the {name} mesh has no area");
                return Err(self.error(message, "remove it, and join its neighbours"));
            }
        }
        let count: usize = meshes.iter().map(|mesh| mesh.triangles().len()).sum();
        if !self.is_invalid && self.check.unwrap_or(count <= CHECKED) {
            for ((mesh, name), operand) in meshes.into_iter().zip(["first", "second"]).zip(&self.operands) {
                flaw(scene, mesh).map_or(Ok(()), |flaw| Err(self.flawed(&flaw, name, operand, cache)?))?;
            }
        }
        Ok(())
    }

    /// The error about a flaw: of a mesh in a file, in that file.
    fn flawed(&self, flaw: &Flaw, name: &str, operand: &Operand, cache: &Cache) -> Result<CorpusError, CorpusError> {
        let cure = flaw.cure();
        let Operand::File(of) = operand else {
            return Ok(self.error(flaw.told(&format!("the {name} mesh"), |triangle| triangle.to_string()), cure));
        };
        let (file, places, faces) = of.places(cache)?;
        let named = |triangle: usize| match places.face(faces[triangle]) {
            Some(position) => format!("{triangle} ({position})"),
            None => triangle.to_string(),
        };
        Ok(CorpusError::file(file, flaw.told("the mesh", named), cure).at(places.face(faces[flaw.triangle()])))
    }
}
