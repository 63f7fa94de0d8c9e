//! Constructed vertices computed in doubles, once, and taken for input vertices from
//! then on, as most programs do.
//!
//! Every operation rounds, nothing bounds by how much, and what is asked later
//! is asked about another point than the one that lines and planes define.
//! Where they are parallel in floating point, the vertex is infinite or NaN.

use predicament_predicates::{Construction, Scene, Vertex};

/// The vertices of the scene's constructions, coordinate after coordinate.
#[must_use]
pub fn constructed(scene: &Scene) -> Vec<f64> {
    let mut coordinates = Vec::with_capacity(scene.constructions().len() * scene.dimension().count());
    for construction in scene.constructions() {
        match *construction {
            Construction::Ssi(lines) => coordinates.extend(segments(lines.map(|line| line.map(|v| point(scene, v))))),
            Construction::Lpi { line, plane } => {
                coordinates.extend(line_plane(line.map(|v| scene.point3(v)), plane.map(|v| scene.point3(v))));
            }
            Construction::Tpi(planes) => {
                coordinates.extend(three_planes(planes.map(|plane| plane.map(|v| scene.point3(v)))));
            }
        }
    }
    coordinates
}

fn point(scene: &Scene, v: Vertex) -> [f64; 2] {
    let point = scene.point(v);
    [point[0], point[1]]
}

/// a + t(b − a) with t = (c − a) × (d − c) / (b − a) × (d − c).
fn segments([[a, b], [c, d]]: [[[f64; 2]; 2]; 2]) -> [f64; 2] {
    let [u, v, way] = [minus(b, a), minus(d, c), minus(c, a)];
    let t = (way[0] * v[1] - way[1] * v[0]) / (u[0] * v[1] - u[1] * v[0]);
    [0, 1].map(|i| a[i] + t * u[i])
}

/// p + t(q − p) with t = N·(r − p) / N·(q − p), N the plane's normal.
fn line_plane([p, q]: [[f64; 3]; 2], plane: [[f64; 3]; 3]) -> [f64; 3] {
    let (u, normal) = (minus(q, p), normal(plane));
    let t = dot(normal, minus(plane[0], p)) / dot(normal, u);
    [0, 1, 2].map(|i| p[i] + t * u[i])
}

/// Cramer's rule for the planes L·x = l, M·x = m, N·x = n:
/// (l M × N + m N × L + n L × M) / L·(M × N).
fn three_planes(planes: [[[f64; 3]; 3]; 3]) -> [f64; 3] {
    let [l, m, n] = planes.map(normal);
    let [mn, nl, lm] = [cross(m, n), cross(n, l), cross(l, m)];
    let [on_l, on_m, on_n] = [dot(l, planes[0][0]), dot(m, planes[1][0]), dot(n, planes[2][0])];
    let weight = dot(l, mn);
    [0, 1, 2].map(|i| (on_l * mn[i] + on_m * nl[i] + on_n * lm[i]) / weight)
}

fn normal([r, s, t]: [[f64; 3]; 3]) -> [f64; 3] {
    cross(minus(s, r), minus(t, r))
}

fn minus<const D: usize>(p: [f64; D], q: [f64; D]) -> [f64; D] {
    std::array::from_fn(|i| p[i] - q[i])
}

fn cross(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

fn dot(p: [f64; 3], q: [f64; 3]) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}
