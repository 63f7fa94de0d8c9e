//! A multi-material mesh, and points to locate in it.

use std::any::Any;
use std::sync::{Arc, OnceLock};

use predicament_corpus::{Canon, Content, Items, List, Spelled, unnumbered};
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_predicates::{Scene, Vertex};

use super::mesh_file::MeshFile;

/// A mesh with points to locate in it.
///
/// Every probe is a separate vertex, even if its coordinates are those of a vertex of the mesh. Probes are numbered
/// alternately before and after all vertices of the mesh, the first one before. So Simulation of Simplicity moves half
/// of them further than the mesh and half of them less far. For perturbations that move a mesh as a whole, the probes
/// are the second mesh.
#[derive(Debug)]
pub struct ProbedMesh {
    /// The mesh.
    pub mesh: Arc<MaterialMesh>,
    /// The tetrahedra that make the mesh, or empty: the first is region 1. Their `orient3d` is positive.
    pub tetrahedra: Vec<[Vertex; 4]>,
    /// The points to locate.
    pub probes: Vec<Probe>,
    /// The file from which the mesh was read, if any.
    file: Option<MeshFile>,
    /// Data that an algorithm makes of the content once, for all backends; its type is the algorithm's.
    made: OnceLock<Box<dyn Any + Send + Sync>>,
}

impl ProbedMesh {
    /// Combines a mesh and its probes.
    #[must_use]
    pub fn new(mesh: MaterialMesh, tetrahedra: Vec<[Vertex; 4]>, probes: Vec<Probe>) -> ProbedMesh {
        ProbedMesh { mesh: Arc::new(mesh), tetrahedra, probes, file: None, made: OnceLock::new() }
    }

    /// Sets the file from which the mesh was read.
    #[must_use]
    pub(super) fn of_file(self, file: Option<MeshFile>) -> ProbedMesh {
        ProbedMesh { file, ..self }
    }

    /// The file from which the mesh was read.
    pub(super) fn file(&self) -> Option<&MeshFile> {
        self.file.as_ref()
    }

    /// The data that `make` makes, once. The truth reads this type too, so the type does not name an algorithm.
    ///
    /// # Panics
    /// If it was made as another type.
    pub(super) fn made<T: Any + Send + Sync>(&self, make: impl FnOnce() -> T) -> &T {
        self.made.get_or_init(|| Box::new(make())).downcast_ref().expect("one type of data for each content")
    }

    /// The vertices of the probes.
    #[must_use]
    pub fn vertices(&self) -> Vec<Vertex> {
        self.probes.iter().map(|probe| probe.vertex).collect()
    }
}

impl Content for ProbedMesh {
    fn count(&self) -> usize {
        self.probes.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("mesh-locate");
        canon.count(self.mesh.triangles().len());
        for (triangle, sides) in self.mesh.triangles().iter().zip(self.mesh.sides()) {
            canon.vertices(triangle);
            sides.iter().for_each(|&region| canon.count(region as usize));
        }
        canon.count(self.probes.len());
        for probe in &self.probes {
            canon.text(probe.kind.name());
            canon.count(probe.vertex.index());
        }
    }

    /// Writes all probes as [`Given`](ProbeKind::Given), since a probe's position does not show how it was chosen. The
    /// id changes for scenes with chosen probes, because it includes the choice.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let apart = unnumbered(scene, &self.vertices());
        let mesh = if self.tetrahedra.is_empty() {
            spelled_mesh(&self.mesh, ["triangles", "regions"], |v| apart.vertex(v))
        } else {
            let tetrahedra: Vec<[Vertex; 4]> =
                self.tetrahedra.iter().map(|corners| corners.map(|v| apart.vertex(v))).collect();
            List::required("tetrahedra", Items::tuples(&tetrahedra))
        };
        let lists = vec![mesh, List::new("probes", Items::Rows(apart.places))];
        let words = vec![("quick_stride", "0".to_owned())];
        Some(Spelled { points: apart.points, words, lists, ..Spelled::default() })
    }

    /// The index of the moved scene is new.
    fn moved(&self, scene: Scene) -> (Scene, Option<Arc<dyn Content>>) {
        let (mesh, tetrahedra, probes) = (self.mesh.clone(), self.tetrahedra.clone(), self.probes.clone());
        (scene, Some(Arc::new(ProbedMesh { mesh, tetrahedra, probes, file: None, made: OnceLock::new() })))
    }
}

/// Writes the triangles of a mesh under the first key. Writes their regions under the second key, if these are not
/// outside and 1.
pub fn spelled_mesh(mesh: &MaterialMesh, [key, regions]: [&'static str; 2], vertex: impl Fn(Vertex) -> Vertex) -> List {
    let tuples = mesh.triangles().iter().map(|corners| corners.iter().map(|&v| vertex(v)).collect()).collect();
    if mesh.sides().iter().all(|&sides| sides == [OUTSIDE, 1]) {
        return List::required(key, Items::Tuples(tuples));
    }
    let rows = mesh.sides().iter().map(|sides| sides.to_vec()).collect();
    List::required(key, Items::Labelled { tuples, key: regions, rows })
}

/// A point to locate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Probe {
    /// Its vertex in the scene.
    pub vertex: Vertex,
    /// The rule by which it was chosen.
    pub kind: ProbeKind,
}

/// The rule by which a probe was chosen.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum ProbeKind {
    /// Written in the scene.
    Given,
    /// On a vertex of the mesh.
    Vertex,
    /// At the middle of an edge, rounded.
    Midpoint,
    /// At the centroid of a triangle, rounded.
    Centroid,
    /// A point one double beside the centroid of a triangle, along an axis.
    Ulp,
    /// On a line through a vertex along an axis.
    Line,
    /// On a line through the middle of an edge along an axis.
    EdgeLine,
    /// A point with the coordinates of three vertices, one of each.
    Lattice,
    /// Outside the bounding box, on a line through a vertex along an axis.
    Far,
    /// Anywhere in the bounding box.
    Random,
}

impl ProbeKind {
    /// All kinds.
    pub const ALL: [ProbeKind; 10] = [
        ProbeKind::Given,
        ProbeKind::Vertex,
        ProbeKind::Midpoint,
        ProbeKind::Centroid,
        ProbeKind::Ulp,
        ProbeKind::Line,
        ProbeKind::EdgeLine,
        ProbeKind::Lattice,
        ProbeKind::Far,
        ProbeKind::Random,
    ];

    /// The name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            ProbeKind::Given => "given",
            ProbeKind::Vertex => "vertex",
            ProbeKind::Midpoint => "midpoint",
            ProbeKind::Centroid => "centroid",
            ProbeKind::Ulp => "ulp",
            ProbeKind::Line => "line",
            ProbeKind::EdgeLine => "edge-line",
            ProbeKind::Lattice => "lattice",
            ProbeKind::Far => "far",
            ProbeKind::Random => "random",
        }
    }
}
