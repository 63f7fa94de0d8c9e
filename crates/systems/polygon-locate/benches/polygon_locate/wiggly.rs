//! A big map with realistic borders: cells of uneven size, with wiggly borders that share vertices.

use predicament_mesh::PolygonMap;
use predicament_predicates::{Scene, Vertex};

/// The random number generator SplitMix64: it is short, and gives the same map forever.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }

    /// A uniform number in [0, 1).
    #[allow(clippy::cast_precision_loss)] // 53 bits fit
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 * 2.0_f64.powi(-53)
    }
}

/// A map of n × n regions on [0, n]², with `pieces` edges between two corners of a border, and `queries` uniform
/// points, which are the last vertices of the scene.
pub fn map(n: usize, pieces: usize, queries: usize) -> (PolygonMap, Scene, Vec<Vertex>) {
    let mut random = Random::new(2026);
    let mut points: Vec<[f64; 2]> = Vec::new();
    for y in 0..=n {
        for x in 0..=n {
            points.push([float(x) + 0.3 * (random.unit() - 0.5), float(y) + 0.3 * (random.unit() - 0.5)]);
        }
    }
    let corner = |x: usize, y: usize| x + y * (n + 1);
    let mut border = |from: usize, to: usize| -> Vec<usize> {
        let mut chain = vec![from];
        for at in wiggle(&mut random, [points[from], points[to]], pieces) {
            chain.push(points.len());
            points.push(at);
        }
        chain.push(to);
        chain
    };
    let mut across: Vec<Vec<usize>> = Vec::new();
    let mut up: Vec<Vec<usize>> = Vec::new();
    for y in 0..=n {
        for x in 0..=n {
            across.push(if x < n { border(corner(x, y), corner(x + 1, y)) } else { Vec::new() });
            up.push(if y < n { border(corner(x, y), corner(x, y + 1)) } else { Vec::new() });
        }
    }
    let mut map = PolygonMap::new();
    for y in 0..n {
        for x in 0..n {
            let forth = across[corner(x, y)].iter().chain(&up[corner(x + 1, y)]);
            let back = across[corner(x, y + 1)].iter().rev().chain(up[corner(x, y)].iter().rev());
            let mut ring: Vec<Vertex> = forth.chain(back).map(|&v| Vertex::input(v)).collect();
            ring.dedup();
            map.push(format!("{x} {y}"), vec![ring]).expect("a ring");
        }
    }
    let first = points.len();
    points.extend((0..queries).map(|_| [random.unit() * float(n), random.unit() * float(n)]));
    let queries = (first..points.len()).map(Vertex::input).collect();
    (map, Scene::from_points2(&points).expect("finite"), queries)
}

/// The inner points of a chain from a to b: waves of random phase across it, flat at both ends, so that no two chains
/// cross.
fn wiggle(random: &mut Random, [a, b]: [[f64; 2]; 2], pieces: usize) -> impl Iterator<Item = [f64; 2]> + use<> {
    let waves: Vec<[f64; 2]> = (1..8).map(|k| [0.12 / f64::from(k), std::f64::consts::TAU * random.unit()]).collect();
    let along = [b[0] - a[0], b[1] - a[1]];
    (1..pieces).map(move |at| {
        let t = float(at) / float(pieces);
        let wave = |(k, [height, phase]): (usize, &[f64; 2])| height * (float(6 * k * k + 3) * t + phase).sin();
        let off = t * (1.0 - t) * waves.iter().enumerate().map(wave).sum::<f64>();
        [a[0] + t * along[0] - off * along[1], a[1] + t * along[1] + off * along[0]]
    })
}

#[allow(clippy::cast_precision_loss)] // sizes are small
fn float(x: usize) -> f64 {
    x as f64
}
