//! The error of a collapse, in doubles: the sum of squared distances from planes (Garland and Heckbert 1997).
//!
//! Each vertex has a quadric: the sum over the planes of its triangles, weighted by area, and over planes through its
//! boundary edges, across the triangle. A collapse adds the quadrics of both ends. Coordinates are first moved to the
//! middle of the scene and divided by its size, so that squares neither overflow nor vanish.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::HalfEdge;
use predicament_predicates::{Scene, Vertex};

/// A factor for the squared length of an edge, which is added to its error: it orders the edges of flat regions.
const SHORT_FIRST: f64 = 1.0 / 1_073_741_824.0;

/// A symmetric matrix with four rows, as its upper half: the sum of outer products of planes.
#[derive(Clone, Default, Debug)]
pub(super) struct Quadric([f64; 10]);

impl Quadric {
    /// The quadric of a plane with this unit normal through a point.
    fn plane([x, y, z]: [f64; 3], through: [f64; 3], weight: f64) -> Quadric {
        let w = -dot([x, y, z], through);
        let products = [x * x, x * y, x * z, x * w, y * y, y * z, y * w, z * z, z * w, w * w];
        Quadric(products.map(|product| product * weight))
    }

    /// Adds another quadric.
    pub(super) fn add(&mut self, other: &Quadric) {
        self.0.iter_mut().zip(other.0).for_each(|(sum, term)| *sum += term);
    }

    /// The value at a point.
    fn at(&self, [x, y, z]: [f64; 3]) -> f64 {
        let [xx, xy, xz, xw, yy, yz, yw, zz, zw, ww] = self.0;
        let quadratic = xx * x * x + yy * y * y + zz * z * z + 2.0 * (xy * x * y + xz * x * z + yz * y * z);
        quadratic + 2.0 * (xw * x + yw * y + zw * z) + ww
    }
}

/// The places of a scene's vertices, scaled, and the errors of edges.
pub(super) struct Errors {
    places: Vec<[f64; 3]>,
}

impl Errors {
    pub(super) fn new(scene: &Scene) -> Errors {
        // A quarter of each coordinate: neither differences nor sums overflow.
        let quarters: Vec<[f64; 3]> = scene.vertices().map(|v| scene.point3(v).map(|x| 0.25 * x)).collect();
        let along = |axis: usize| quarters.iter().map(move |point| point[axis]);
        let low = [0, 1, 2].map(|axis| along(axis).fold(f64::INFINITY, f64::min));
        let high = [0, 1, 2].map(|axis| along(axis).fold(f64::NEG_INFINITY, f64::max));
        let size = [0, 1, 2].map(|axis| high[axis] - low[axis]).into_iter().fold(0.0, f64::max);
        let size = if size > 0.0 { size } else { 1.0 };
        let scaled = |point: &[f64; 3]| [0, 1, 2].map(|axis| (point[axis] - 0.5 * (low[axis] + high[axis])) / size);
        Errors { places: quarters.iter().map(scaled).collect() }
    }

    /// The quadrics of the vertices of a mesh.
    pub(super) fn quadrics(&self, mesh: &HalfEdgeMesh) -> Vec<Quadric> {
        let count = mesh.vertices().last().map_or(0, |v| v.index() + 1);
        let mut quadrics = vec![Quadric::default(); count];
        for face in mesh.faces() {
            let first = mesh.half_edge_of_face(face);
            let around: Vec<HalfEdge> = mesh.loop_of(first).collect();
            let [a, b, c] = [0, 1, 2].map(|at| self.places[mesh.scene_vertex(mesh.end(around[at])).index()]);
            let normal = cross(minus(b, a), minus(c, a));
            let twice = dot(normal, normal).sqrt();
            if twice <= 0.0 || twice.is_nan() {
                continue;
            }
            let unit = normal.map(|x| x / twice);
            let mut add = |ends: &[HalfEdge], plane: &Quadric| {
                ends.iter().for_each(|&h| quadrics[mesh.end(h).index()].add(plane));
            };
            add(&around, &Quadric::plane(unit, a, twice));
            for &h in &around {
                if mesh.is_boundary(mesh.opposite(h)) {
                    let [from, to] = [mesh.start(h), mesh.end(h)].map(|v| self.places[mesh.scene_vertex(v).index()]);
                    let across = cross(minus(to, from), unit);
                    let length = dot(across, across).sqrt();
                    if length > 0.0 {
                        let plane = Quadric::plane(across.map(|x| x / length), from, length * length);
                        add(&[h, mesh.opposite(h)], &plane);
                    }
                }
            }
        }
        quadrics
    }

    /// The error of moving the first vertex into the second one.
    pub(super) fn of(&self, quadrics: [&Quadric; 2], [gone, kept]: [Vertex; 2]) -> f64 {
        let [from, to] = [gone, kept].map(|v| self.places[v.index()]);
        let way = minus(to, from);
        quadrics[0].at(to) + quadrics[1].at(to) + SHORT_FIRST * dot(way, way)
    }
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
