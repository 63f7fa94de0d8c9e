//! Random numbers and small random scenes.

use predicament_mesh::{Complex, PolygonMap, Simplices};
use predicament_predicates::{Dimension, Scene, Vertex};

/// The factor by which the number of random scenes exceeds the default.
pub fn effort() -> usize {
    if predicament_effort::whole() { 10 } else { 1 }
}

/// The random number generator SplitMix64.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A random number less than `end`.
    pub fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.next() % u64::try_from(end).unwrap()).unwrap()
    }

    /// A random integer from 0 to before `end`, as a double.
    pub fn whole(&mut self, end: usize) -> f64 {
        f64::from(u32::try_from(self.below(end)).unwrap())
    }

    /// `count` different random numbers below `end`, ascending.
    fn distinct(&mut self, count: usize, end: usize) -> Vec<usize> {
        let mut all: Vec<usize> = (0..end).collect();
        for at in 0..count {
            let other = at + self.below(end - at);
            all.swap(at, other);
        }
        all.truncate(count);
        all
    }
}

/// The spacing of random coordinates.
#[derive(Clone, Copy, Debug)]
pub enum Grid {
    /// Small integers.
    Whole,
    /// Doubles next to one, a few units in the last place apart.
    Fine,
    /// Small integers times powers of two that are far apart.
    Wide,
}

impl Grid {
    fn coordinate(self, random: &mut Random, end: usize) -> f64 {
        let whole = random.whole(end);
        match self {
            Grid::Whole => whole,
            Grid::Fine => 1.0 + whole * f64::EPSILON,
            Grid::Wide => whole * [1e-200, 1.0, 1e200, f64::from_bits(1)][random.below(4)],
        }
    }

    /// `count` random coordinates.
    pub fn coordinates(self, random: &mut Random, count: usize, end: usize) -> Vec<f64> {
        (0..count).map(|_| self.coordinate(random, end)).collect()
    }
}

/// Two complexes of a few random simplices over the vertices of one scene.
pub fn complexes(random: &mut Random, dimension: Dimension, grid: Grid) -> (Scene, [Complex; 2]) {
    let points = 6 + random.below(4);
    let end = 2 + random.below(4);
    let coordinates = grid.coordinates(random, points * dimension.count(), end);
    let scene = Scene::new(dimension, coordinates).unwrap();
    let mut complex = || {
        let mut given = Simplices::default();
        for _ in 0..1 + random.below(3) {
            let count = 1 + random.below(dimension.count() + 1);
            let of = random.distinct(count, points);
            match *of.into_iter().map(Vertex::input).collect::<Vec<_>>() {
                [a] => given.vertices.push(a),
                [a, b] => given.edges.push([a, b]),
                [a, b, c] => given.triangles.push([a, b, c]),
                [a, b, c, d] => given.tetrahedra.push([a, b, c, d]),
                _ => unreachable!(),
            }
        }
        Complex::new(&scene, &given).unwrap()
    };
    let both = [complex(), complex()];
    (scene, both)
}

/// All simplices of a complex, as their vertices, in the complex' order.
pub fn simplices(complex: &Complex) -> Vec<Vec<Vertex>> {
    let vertices = complex.vertices().iter().map(|&v| vec![v]);
    let edges = complex.edges().iter().map(|edge| edge.to_vec());
    let triangles = complex.triangles().iter().map(|triangle| triangle.to_vec());
    vertices.chain(edges).chain(triangles).chain(complex.tetrahedra().iter().map(|t| t.to_vec())).collect()
}

/// The regions of a map.
pub type Regions = Vec<Vec<Vec<Vertex>>>;

/// Regions with random rings over the first vertices of a scene. All vertices are probes; some coincide.
pub fn map(random: &mut Random, grid: Grid) -> (Scene, Regions, PolygonMap) {
    let of_map = 3 + random.below(8);
    let probes = 12;
    let end = 2 + random.below(5);
    let scene = Scene::new(Dimension::Two, grid.coordinates(random, 2 * (of_map + probes), end)).unwrap();
    let mut ring = || -> Vec<Vertex> {
        let mut vertices: Vec<usize> = Vec::new();
        let length = 3 + random.below(6);
        while vertices.len() < length || vertices.first() == vertices.last() {
            let next = random.below(of_map);
            if vertices.last() != Some(&next) {
                vertices.push(next);
            }
        }
        vertices.into_iter().map(Vertex::input).collect()
    };
    let mut regions: Regions = vec![vec![ring(), ring()], vec![ring()], vec![ring()]];
    // A border that two regions share.
    let common = regions[0][0].iter().rev().copied().collect();
    regions[2].push(common);
    let map = polygon_map(&regions);
    (scene, regions, map)
}

/// The regions as a [`PolygonMap`].
pub fn polygon_map(regions: &Regions) -> PolygonMap {
    let mut map = PolygonMap::new();
    for (at, rings) in regions.iter().enumerate() {
        map.push(format!("region {at}"), rings.clone()).unwrap();
    }
    map
}

/// Random cubes on a small grid as a scene: lower corners below `end`, and the unit of all lengths.
pub fn cubes(random: &mut Random, count: usize, end: usize, edge: f64, unit: f64) -> Scene {
    let mut coordinates = Vec::new();
    for _ in 0..count {
        let lower = [(); 3].map(|()| random.whole(end));
        coordinates.extend(lower.map(|c| c * unit));
        coordinates.extend(lower.map(|c| (c + edge) * unit));
    }
    Scene::new(Dimension::Three, coordinates).unwrap()
}
