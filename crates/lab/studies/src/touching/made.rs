//! The union of two solids by one backend.

use std::sync::Arc;
use std::time::{Duration, Instant};

use predicament_judge::rational;
use predicament_mesh::MaterialMesh;
use predicament_mesh_intersect::algorithm::cascade::Closed;
use predicament_mesh_intersect::algorithm::limit::{self, limit};
use predicament_mesh_intersect::algorithm::overlay::{MeshOverlay, Registered, Undone, mesh_overlay_as_answered};
use predicament_mesh_intersect::truth::constructed;
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{PredicateKind, Predicates, Scene, SceneError, Vertex, ZeroMeaning};
use predicament_tasks::Contestant;
use rug::Rational;

/// The volumes of results.
#[derive(Clone, PartialEq, Debug)]
pub struct Volume {
    /// The volume of the union.
    pub union: Rational,
    /// The volume of the intersection.
    pub intersection: Rational,
    /// The volumes of both solids together.
    pub both: Rational,
}

/// Where the solids touch without a common inside.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Touched {
    /// Single points.
    pub points: usize,
    /// Segments.
    pub segments: usize,
    /// The length of the segments, rounded.
    pub length: f64,
    /// Pairs of triangles that share an area.
    pub faces: usize,
    /// The area of the faces, rounded.
    pub area: f64,
}

/// The union of two solids, and what a backend returns beside it.
#[derive(Clone, PartialEq, Debug)]
pub struct Made {
    /// The number of constructed vertices.
    pub constructed: usize,
    /// The number of constructed vertices that are not points of the given solids, but only of perturbed ones.
    pub undefined: usize,
    /// The bits of the longest numerator or denominator among their coordinates, as reduced fractions.
    pub bits: u32,
    /// The number of triangles of the union.
    pub triangles: usize,
    /// The number of triangles of its limit and the limit's statistics; an error if there is none; `None` if the
    /// backend rounds.
    pub limit: Option<Result<(usize, limit::Counts), String>>,
    /// The volumes, of the limit if there is one; `None` if a vertex is not a point of the given solids.
    pub volume: Option<Volume>,
    /// The contacts, if zeros are exact.
    pub touched: Option<Touched>,
}

/// Two solids in one scene, the second as the mesh that a perturbation may move.
pub(super) struct Solids {
    scene: Scene,
    meshes: [Arc<MaterialMesh>; 2],
    both: Rational,
}

impl Solids {
    pub fn new(solids: &[Closed; 2]) -> Result<Solids, SceneError> {
        let points = [&solids[0].points[..], &solids[1].points].concat();
        let first = solids[0].points.len();
        let scene = Scene::from_points3(&points)?.with_second_mesh((first..points.len()).map(Vertex::input));
        let mesh = |at: usize| {
            let vertex = |v: u32| Vertex::input(v as usize + at * first);
            let triangles = solids[at].triangles.iter().map(|triangle| triangle.map(vertex)).collect();
            Arc::new(MaterialMesh::of_closed(points.len(), triangles).expect("closed"))
        };
        let meshes = [mesh(0), mesh(1)];
        let lengths = meshes.each_ref().map(|mesh| mesh.primitive_length(&scene));
        let scene = scene.with_primitive_lengths(lengths);
        let at = Places { given: points.len(), points: points.iter().map(|point| point.map(rational)).collect() };
        let both = meshes.iter().map(|mesh| volume(&at, mesh.triangles())).sum();
        Ok(Solids { scene, meshes, both })
    }

    /// The number of triangles of both solids.
    pub fn triangles(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.triangles().len()).sum()
    }

    /// The time of the overlay and its union, and of the limit.
    pub fn times(&self, backend: &dyn Contestant) -> Result<[Duration; 2], String> {
        let mut times = Err("the backend asked for no session".to_owned());
        let mut ask = |session: &mut dyn Predicates| times = self.time(session);
        backend.with_session(&self.scene, &mut ask).map_err(|why| why.to_string())?;
        times
    }

    fn time(&self, session: &mut dyn Predicates) -> Result<[Duration; 2], String> {
        let clock = Instant::now();
        let (overlay, _) =
            mesh_overlay_as_answered(session, self.meshes.clone(), &mut |_| {}).map_err(|why| why.to_string())?;
        let union = overlay.solid(Operation::Union);
        let overlaying = clock.elapsed();
        let Some(exact) = session.unperturbed() else { return Ok([overlaying, Duration::ZERO]) };
        let clock = Instant::now();
        let mut union = Some(union);
        let mut take = |session: &mut dyn Predicates| {
            let _ = std::hint::black_box(union.take().map(|union| limit(session, &overlay, union)));
        };
        exact.with_session(&session.scene().clone(), &mut take).map_err(|why| why.to_string())?;
        Ok([overlaying, clock.elapsed()])
    }

    /// The union by a backend, measured.
    pub fn made(&self, backend: &dyn Contestant) -> Result<Made, String> {
        let mut made = Err("the backend asked for no session".to_owned());
        let lists = backend.contract(PredicateKind::Orient3d).zero == ZeroMeaning::Exact;
        let mut ask = |session: &mut dyn Predicates| {
            made = mesh_overlay_as_answered(session, self.meshes.clone(), &mut |_| {})
                .map(|(overlay, registered)| self.measured(session, &overlay, registered.as_ref(), lists))
                .map_err(|why| why.to_string());
        };
        backend.with_session(&self.scene, &mut ask).map_err(|why| why.to_string())?;
        made
    }

    fn measured(
        &self,
        session: &dyn Predicates,
        overlay: &MeshOverlay,
        registered: Option<&Registered>,
        lists: bool,
    ) -> Made {
        let [union, intersection] = [Operation::Union, Operation::Intersection].map(|what| overlay.solid(what));
        let (triangles, constructed_by) = (union.triangles.len(), overlay.constructions().len());
        let mut results = [union.triangles.clone(), intersection.triangles.clone()];
        let mut constructions = overlay.constructions().to_vec();
        let mut limited = None;
        if let Some(exact) = session.unperturbed() {
            let mut limits = Ok(Vec::new());
            let mut take = |session: &mut dyn Predicates| {
                let solids = [union.clone(), intersection.clone()].into_iter();
                limits = solids.map(|solid| limit(session, overlay, solid)).collect::<Result<Vec<_>, Undone>>();
                constructions = session.scene().constructions().to_vec();
            };
            let asked = exact.with_session(&session.scene().clone(), &mut take).map_err(|why| why.to_string());
            let limits = asked.and_then(|()| limits.map_err(|why| why.to_string()));
            limited = Some(limits.map(|limits| {
                let of_union = (limits[0].solid.triangles.len(), limits[0].counts);
                results.iter_mut().zip(limits).for_each(|(result, limit)| *result = limit.solid.triangles);
                of_union
            }));
        }
        let points: Vec<Option<[Rational; 3]>> = match registered {
            Some(places) => {
                (0..constructions.len()).map(Vertex::constructed).map(|v| Some(places.place(v).map(rational))).collect()
            }
            None => constructions
                .iter()
                .map(|one| constructed(&self.scene, std::slice::from_ref(one)).ok()?.pop())
                .collect(),
        };
        let undefined = points[..constructed_by].iter().filter(|point| point.is_none()).count();
        let bits = |x: &Rational| x.numer().significant_bits().max(x.denom().significant_bits());
        let bits = points[..constructed_by].iter().flatten().flatten().map(bits).max().unwrap_or(0);
        let all: Option<Vec<[Rational; 3]>> =
            self.scene.vertices().map(|v| Some(self.scene.point3(v).map(rational))).chain(points).collect();
        let all = all.map(|points| Places { given: self.scene.len(), points });
        let touched = all.as_ref().filter(|_| lists && limited.is_some()).map(|at| touched(overlay, at));
        let volume = all.map(|at| {
            let [union, intersection] = results.map(|triangles| volume(&at, &triangles));
            Volume { union, intersection, both: self.both.clone() }
        });
        Made { constructed: constructed_by, undefined, bits, triangles, limit: limited, volume, touched }
    }
}

/// The points of a scene, then the constructed ones.
struct Places {
    given: usize,
    points: Vec<[Rational; 3]>,
}

impl Places {
    fn of(&self, v: Vertex) -> &[Rational; 3] {
        &self.points[v.construction().map_or(v.index(), |at| self.given + at)]
    }
}

fn minus(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    [0, 1, 2].map(|axis: usize| Rational::from(&a[axis] - &b[axis]))
}

fn cross(u: &[Rational; 3], v: &[Rational; 3]) -> [Rational; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| Rational::from(&u[i] * &v[j]) - Rational::from(&u[j] * &v[i]))
}

fn dot(u: &[Rational; 3], v: &[Rational; 3]) -> Rational {
    u.iter().zip(v).map(|(x, y)| Rational::from(x * y)).sum()
}

fn volume(at: &Places, triangles: &[[Vertex; 3]]) -> Rational {
    let six: Rational = triangles
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|v| at.of(v));
            dot(a, &cross(b, c))
        })
        .sum();
    six / 6
}

/// The contacts, measured.
fn touched(overlay: &MeshOverlay, at: &Places) -> Touched {
    let contacts = overlay.contacts();
    let length = |ends: &[Vertex; 2]| {
        let along = minus(at.of(ends[0]), at.of(ends[1]));
        dot(&along, &along).to_f64().sqrt()
    };
    let area = |triangle: &[Vertex; 3]| {
        let [a, b, c] = triangle.map(|v| at.of(v));
        let normal = cross(&minus(b, a), &minus(c, a));
        dot(&normal, &normal).to_f64().sqrt() / 2.0
    };
    Touched {
        points: contacts.points.len(),
        segments: contacts.segments.len(),
        length: contacts.segments.iter().map(length).sum(),
        faces: contacts.faces.len(),
        area: contacts.faces.iter().flat_map(|face| &face.triangles).map(area).sum(),
    }
}
