//! The choice of probes for a mesh: where rays meet vertices, edges and faces, and next to them.
//!
//! Random points almost never meet a degeneracy. Points of the mesh, and points on lines along the axes through its
//! vertices and edges, always do, whichever axis a ray follows.

use predicament_corpus::{Level, Parts, Random, numbered};
use predicament_formats::{CorpusError, Fields};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Dimension, Scene, Vertex};

use super::content::{Probe, ProbeKind, ProbedMesh};
use super::mesh_file::MeshFile;

const MOST_RANDOM: u64 = 100_000_000;
const MOST_STRIDE: u64 = 1_000_000;

/// A mesh with its own points.
pub struct Surface {
    /// The points.
    pub points: Vec<[f64; 3]>,
    /// The triangles, each with the regions on its two sides.
    pub mesh: MaterialMesh,
    /// The tetrahedra that make the mesh; the first is region 1.
    pub tetrahedra: Vec<[Vertex; 4]>,
}

/// The rules for the probes of a mesh.
#[derive(Clone, Debug)]
pub(super) struct Probing {
    /// The number of random probes, at levels quick and full.
    random: [usize; 2],
    seed: u64,
    /// Every n-th vertex, edge and triangle is probed, at levels quick and full; 0 means never.
    stride: [usize; 2],
    /// The probes that the scene itself lists.
    pub(super) given: Vec<[f64; 3]>,
}

impl Probing {
    /// Reads `random`, `random_full`, `seed`, `quick_stride` and `full_stride`.
    pub(super) fn read(fields: &Fields<'_, '_>) -> Result<Probing, CorpusError> {
        let number = |key, default, range| fields.integer_or(key, default, range);
        let quick = number("random", 0, 0..=MOST_RANDOM)?;
        let random = [quick, number("random_full", quick, 0..=MOST_RANDOM)?];
        let stride = number("quick_stride", 1, 0..=MOST_STRIDE)?;
        let stride = [stride, number("full_stride", stride, 0..=MOST_STRIDE)?];
        let counts = |numbers: [u64; 2]| numbers.map(|number| usize::try_from(number).unwrap_or(usize::MAX));
        let seed = number("seed", 0, 0..=u64::MAX)?;
        Ok(Probing { random: counts(random), seed, stride: counts(stride), given: Vec::new() })
    }

    /// The approximate number of probes for a number of triangles, at the larger level.
    pub(super) fn count(&self, triangles: u64) -> u64 {
        let at = |level: Level| {
            let stride = level.of(self.stride) as u64;
            // There is half a vertex for each triangle, and three edges, each shared.
            let of_mesh = triangles.checked_div(stride).map_or(0, |each| 12 * (each + 1));
            of_mesh.saturating_add(level.of(self.random) as u64)
        };
        at(Level::Quick).max(at(Level::Full))
    }

    /// The number of probes at a level for numbers of points and triangles, including probes beyond the largest double.
    pub(super) fn exactly(&self, points: usize, triangles: usize, level: Level) -> usize {
        let of_mesh = match level.of(self.stride) {
            0 => 0,
            stride => 4 * (points.div_ceil(stride) + triangles.div_ceil(stride)),
        };
        self.given.len() + of_mesh + level.of(self.random)
    }
}

/// The scene of a mesh, possibly from a file: the probes of even index (the first has index 0), the mesh's vertices,
/// the probes of odd index.
pub(super) fn with_probes(surface: Surface, file: Option<MeshFile>, probing: &Probing, level: Level) -> Parts {
    let Surface { points, mesh, tetrahedra } = surface;
    let mut places: Vec<([f64; 3], ProbeKind)> = probing.given.iter().map(|&point| (point, ProbeKind::Given)).collect();
    let mut rng = Random::new("probes", "mesh-locate", probing.seed);
    let stride = level.of(probing.stride);
    let [low, high] = bounds(&points);
    if stride > 0 {
        of_mesh(&points, &mesh, stride, [low, high], &mut rng, &mut places);
    }
    for _ in 0..level.of(probing.random) {
        let point = [0, 1, 2].map(|axis: usize| rng.between(low[axis], high[axis]).clamp(low[axis], high[axis]));
        places.push((point, ProbeKind::Random));
    }
    // Next to the largest double there is no finite neighbour to probe.
    places.retain(|(place, _)| place.iter().all(|x| x.is_finite()));
    let (all, numbers) = numbered(points, &places.iter().map(|&(place, _)| place).collect::<Vec<_>>());
    let probes: Vec<Probe> = numbers.iter().zip(&places).map(|(&vertex, &(_, kind))| Probe { vertex, kind }).collect();
    let scene = Scene::new(Dimension::Three, all.into_flattened()).expect("finite points");
    let scene = scene.with_second_mesh(numbers);
    let leading = places.len().div_ceil(2);
    let shifted = |v: Vertex| Vertex::input(v.index() + leading);
    let tetrahedra = tetrahedra.into_iter().map(|corners| corners.map(shifted)).collect();
    Parts::new(scene, ProbedMesh::new(mesh.shifted(leading), tetrahedra, probes).of_file(file))
}

/// Probes at every n-th vertex, edge and triangle.
fn of_mesh(
    points: &[[f64; 3]],
    mesh: &MaterialMesh,
    stride: usize,
    [low, high]: [[f64; 3]; 2],
    rng: &mut Random,
    places: &mut Vec<([f64; 3], ProbeKind)>,
) {
    let last = i64::try_from(points.len()).expect("scenes are smaller than memory") - 1;
    let along = |mut point: [f64; 3], at: usize, rng: &mut Random| {
        let axis = at % 3;
        point[axis] = rng.between(low[axis], high[axis]);
        point
    };
    for (at, &point) in points.iter().enumerate().step_by(stride) {
        places.push((point, ProbeKind::Vertex));
        // The axes take turns, whatever the stride is.
        let turn = at / stride;
        places.push((along(point, turn, rng), ProbeKind::Line));
        let mut far = point;
        let size = high[turn % 3] - low[turn % 3];
        far[turn % 3] = if turn.is_multiple_of(2) { high[turn % 3] + size } else { low[turn % 3] - size };
        places.push((far, ProbeKind::Far));
        let [a, b] = [(); 2].map(|()| usize::try_from(rng.integer(0, last)).expect("not negative"));
        places.push(([point[0], points[a][1], points[b][2]], ProbeKind::Lattice));
    }
    let half = |a: f64, b: f64| a / 2.0 + b / 2.0;
    for (at, corners) in mesh.triangles().iter().enumerate().step_by(stride) {
        let [a, b, c] = corners.map(|v| points[v.index()]);
        let turn = at / stride;
        let middle = [0, 1, 2].map(|axis: usize| half(a[axis], b[axis]));
        places.push((middle, ProbeKind::Midpoint));
        places.push((along(middle, turn, rng), ProbeKind::EdgeLine));
        let centroid = [0, 1, 2].map(|axis: usize| a[axis] / 3.0 + b[axis] / 3.0 + c[axis] / 3.0);
        places.push((centroid, ProbeKind::Centroid));
        let mut beside = centroid;
        let x = beside[turn % 3];
        beside[turn % 3] = if turn.is_multiple_of(2) { x.next_up() } else { x.next_down() };
        places.push((beside, ProbeKind::Ulp));
    }
}

fn bounds(points: &[[f64; 3]]) -> [[f64; 3]; 2] {
    let along = |axis: usize| points.iter().map(move |p| p[axis]);
    [
        [0, 1, 2].map(|axis| along(axis).fold(f64::INFINITY, f64::min)),
        [0, 1, 2].map(|axis| along(axis).fold(f64::NEG_INFINITY, f64::max)),
    ]
}
