//! Closed meshes as arrays, for benches: files, volumes, and pairs in one scene.

use predicament_predicates::{Construction, Scene, Vertex};

/// A closed mesh.
#[derive(Clone, Default)]
pub struct Closed {
    pub points: Vec<[f64; 3]>,
    pub triangles: Vec<[u32; 3]>,
}

impl Closed {
    pub fn moved(&self, by: [f64; 3]) -> Closed {
        let points = self.points.iter().map(|p| [0, 1, 2].map(|i: usize| p[i] + by[i])).collect();
        Closed { points, triangles: self.triangles.clone() }
    }

    pub fn volume(&self) -> f64 {
        self.triangles.iter().map(|triangle| sixth(triangle.map(|at| self.points[at as usize]))).sum()
    }

    /// The file that programs of other libraries read: two 64-bit counts, of points and of triangles, then coordinates
    /// as doubles, and 32-bit indices; all little-endian.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = [self.points.len(), self.triangles.len()].map(|count| (count as u64).to_le_bytes()).concat();
        bytes.extend(self.points.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend(self.triangles.as_flattened().iter().flat_map(|at| at.to_le_bytes()));
        bytes
    }
}

/// Both meshes in one scene, and their triangles there.
pub fn scene(closed: [&Closed; 2]) -> (Scene, [Vec<[Vertex; 3]>; 2]) {
    let points = [&closed[0].points[..], &closed[1].points].concat();
    let first = closed[0].points.len();
    let scene = Scene::from_points3(&points).expect("finite");
    let scene = scene.with_second_mesh((first..points.len()).map(Vertex::input));
    let from = |mesh: usize| {
        let vertex = |at: u32| Vertex::input(at as usize + mesh * first);
        closed[mesh].triangles.iter().map(|triangle| triangle.map(vertex)).collect()
    };
    (scene, [from(0), from(1)])
}

pub fn index(place: usize) -> u32 {
    u32::try_from(place).expect("fewer than 2^32 points")
}

pub fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i: usize| a[i] - b[i])
}

fn determinant([a, b, c]: [[f64; 3]; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// The volume between a triangle and the origin.
pub fn sixth(triangle: [[f64; 3]; 3]) -> f64 {
    determinant(triangle) / 6.0
}

/// The approximate position of a vertex.
pub fn place(scene: &Scene, v: Vertex) -> [f64; 3] {
    match scene.construction(v) {
        Some(Construction::Lpi { line, plane }) => {
            let [p, q] = line.map(|v| scene.point3(v));
            let [a, b, c] = plane.map(|v| scene.point3(v));
            let height = |x: [f64; 3]| determinant([minus(b, a), minus(c, a), minus(x, a)]);
            let fraction = height(p) / (height(p) - height(q));
            [0, 1, 2].map(|i: usize| p[i] + fraction * (q[i] - p[i]))
        }
        Some(_) => unreachable!("an overlay of meshes constructs points of lines and planes"),
        None => scene.point3(v),
    }
}
