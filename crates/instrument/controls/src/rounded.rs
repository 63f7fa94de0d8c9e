//! Constructed vertices, computed once in doubles and treated as input vertices from then on, as in most programs.
//!
//! Every operation rounds, without an error bound. Later queries use another point than the one that the lines and
//! planes define. If they are parallel in floating point, the vertex is infinite or NaN. Lines and planes through
//! constructed vertices use the rounded vertices.

use predicament_predicates::{Construction, Dimension, Scene, Share, Vertex};

/// The coordinates of the scene's constructed vertices, one after the other.
#[must_use]
pub fn constructed(scene: &Scene) -> Vec<f64> {
    all(scene).split_off(scene.coordinates().len())
}

/// The coordinates of all vertices: first the input vertices, then the constructed vertices.
pub(crate) fn all(scene: &Scene) -> Vec<f64> {
    let constructed = scene.constructions().len() * scene.dimension().count();
    let mut all = Vec::with_capacity(scene.coordinates().len() + constructed);
    all.extend_from_slice(scene.coordinates());
    scene.constructions().iter().for_each(|construction| push(&mut all, scene, construction));
    all
}

/// Computes the next vertex from the input vertices and from the vertices constructed before, and appends it.
pub(crate) fn push(all: &mut Vec<f64>, scene: &Scene, construction: &Construction) {
    let (inputs, dimension) = (scene.len(), scene.dimension());
    match *construction {
        Construction::Ssi(lines) => {
            let point = segments(lines.map(|line| line.map(|v| point(all, inputs, v))));
            all.extend(point);
        }
        Construction::Lpi { line, plane } => {
            let point = line_plane(line.map(|v| point(all, inputs, v)), plane.map(|v| point(all, inputs, v)));
            all.extend(point);
        }
        Construction::Tpi(planes) => {
            let point = three_planes(planes.map(|plane| plane.map(|v| point(all, inputs, v))));
            all.extend(point);
        }
        Construction::Ratio { ends, share } => match dimension {
            Dimension::Two => {
                let point: [f64; 2] = shared(ends.map(|v| point(all, inputs, v)), share);
                all.extend(point);
            }
            Dimension::Three => {
                let point: [f64; 3] = shared(ends.map(|v| point(all, inputs, v)), share);
                all.extend(point);
            }
        },
    }
}

fn point<const D: usize>(all: &[f64], inputs: usize, v: Vertex) -> [f64; D] {
    all.as_chunks().0[v.construction().map_or(v.index(), |index| inputs + index)]
}

/// The intersection a + t(b − a) with t = (c − a) × (d − c) / (b − a) × (d − c).
fn segments([[a, b], [c, d]]: [[[f64; 2]; 2]; 2]) -> [f64; 2] {
    let [u, v, way] = [minus(b, a), minus(d, c), minus(c, a)];
    let t = (way[0] * v[1] - way[1] * v[0]) / (u[0] * v[1] - u[1] * v[0]);
    [0, 1].map(|i| a[i] + t * u[i])
}

/// The intersection p + t(q − p) with t = N·(r − p) / N·(q − p), N the plane's normal.
fn line_plane([p, q]: [[f64; 3]; 2], plane: [[f64; 3]; 3]) -> [f64; 3] {
    let (u, normal) = (minus(q, p), normal(plane));
    let t = dot(normal, minus(plane[0], p)) / dot(normal, u);
    [0, 1, 2].map(|i| p[i] + t * u[i])
}

/// The intersection of the planes L·x = l, M·x = m, N·x = n by Cramer's rule: (l M × N + m N × L + n L × M) / L·(M ×
/// N).
fn three_planes(planes: [[[f64; 3]; 3]; 3]) -> [f64; 3] {
    let [l, m, n] = planes.map(normal);
    let [mn, nl, lm] = [cross(m, n), cross(n, l), cross(l, m)];
    let [on_l, on_m, on_n] = [dot(l, planes[0][0]), dot(m, planes[1][0]), dot(n, planes[2][0])];
    let weight = dot(l, mn);
    [0, 1, 2].map(|i| (on_l * mn[i] + on_m * nl[i] + on_n * lm[i]) / weight)
}

/// The point c + α(a − c).
fn shared<const D: usize>([a, c]: [[f64; D]; 2], share: Share) -> [f64; D] {
    let (u, t) = (minus(a, c), share.nearest());
    std::array::from_fn(|i| c[i] + t * u[i])
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
