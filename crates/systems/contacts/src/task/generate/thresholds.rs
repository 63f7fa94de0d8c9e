//! Pairs at a threshold of one test, far from the thresholds of all other tests of their algorithm.
//!
//! A pair of the hierarchy whose sub-pairs are apart is far from most thresholds: that is the purpose of the hierarchy.
//! The generator therefore makes these pairs for the test, with any sub-pairs: a shape of fixed proportions, in which
//! one value is small compared to the others. Its size is chosen so that the value is T₋, T or T₊, up or down by a
//! fraction from an eighth to 2⁻²⁴.

use crate::checks::audit::{PairKind, Published, Symbol};
use predicament_corpus::Random;
use predicament_formats::bits::{integer, power_of_two};
use predicament_mesh::Simplices;
use predicament_predicates::{Dimension, Vertex};

use super::Shape;

/// A point; in the plane, z is 0.
pub type Point = [f64; 3];

/// The tolerances that the algorithm for such a pair compares with.
#[must_use]
pub fn reads(kind: PairKind, dimension: Dimension) -> &'static [Symbol] {
    match (kind, dimension) {
        (PairKind::VertexVertex, _) => &[Symbol::Sigma],
        (PairKind::EdgeVertex, _) => &[Symbol::SigmaHat, Symbol::Tau],
        (PairKind::EdgeEdge | PairKind::TriangleVertex, Dimension::Two) => &[Symbol::Kappa],
        (PairKind::EdgeEdge, Dimension::Three) => &[Symbol::Lambda, Symbol::Gamma, Symbol::Phi],
        (PairKind::TriangleVertex, Dimension::Three) => &[Symbol::Nu, Symbol::Delta, Symbol::Zeta],
        (PairKind::TriangleEdge, _) => &[Symbol::Mu, Symbol::Xi],
        (PairKind::TetrahedronVertex, _) => &[Symbol::Rho],
    }
}

/// All algorithms of a dimension with all tolerances that they compare with.
pub fn all(dimension: Dimension) -> impl Iterator<Item = (PairKind, Symbol)> {
    let fits = move |kind: &PairKind| kind.ranks().map(usize::from).iter().sum::<usize>() <= dimension.count();
    let kinds = PairKind::ALL.into_iter().filter(fits);
    kinds.flat_map(move |kind| reads(kind, dimension).iter().map(move |&symbol| (kind, symbol)))
}

/// A pair around the origin with a value at a threshold of this tolerance, not rounded.
///
/// # Panics
/// If the algorithm for the pair does not compare with it.
pub fn pair(random: &mut Random, published: &Published, kind: PairKind, symbol: Symbol) -> [Vec<Point>; 2] {
    let dimension = published.dimension();
    assert!(reads(kind, dimension).contains(&symbol), "{} does not read {}", kind.name(), symbol.name());
    let target = aim(random, published.rounded(symbol));
    let mut making = Making { random, published, symbol, target };
    let local = match (kind, dimension) {
        (PairKind::VertexVertex, _) => [vec![[0.0; 3]], vec![[target, 0.0, 0.0]]],
        (PairKind::EdgeVertex, _) => making.edge_vertex(),
        (PairKind::EdgeEdge, _) => making.edge_edge(dimension),
        (PairKind::TriangleVertex, _) => making.triangle_vertex(dimension),
        (PairKind::TriangleEdge, _) => making.triangle_edge(),
        (PairKind::TetrahedronVertex, _) => making.tetrahedron_vertex(),
    };
    let frame = frame(random, dimension);
    let turn = |p: Point| -> Point { std::array::from_fn(|i| (0..3).map(|j| frame[j][i] * p[j]).sum()) };
    local.map(|simplex| simplex.into_iter().map(turn).collect())
}

fn aim(random: &mut Random, limits: [f64; 3]) -> f64 {
    let target = limits[usize::try_from(random.integer(0, 2)).expect("small")];
    let off = random.between(0.5, 1.0) * power_of_two(-random.integer(2, 24));
    target * if random.one_in(2) { 1.0 + off } else { 1.0 - off }
}

struct Making<'a> {
    random: &'a mut Random,
    published: &'a Published,
    symbol: Symbol,
    target: f64,
}

impl Making<'_> {
    /// The size at which a value of this degree equals the target.
    fn size(&self, value: f64, degree: u32) -> f64 {
        let quotient = self.target / value;
        match degree {
            2 => quotient.sqrt(),
            3 => cube_root(quotient),
            _ => quotient.sqrt().sqrt(),
        }
    }

    fn part(&mut self, low: f64, high: f64) -> f64 {
        self.random.between(low, high)
    }

    fn choice<const N: usize>(&mut self) -> usize {
        usize::try_from(self.random.integer(0, i64::try_from(N).expect("few") - 1)).expect("not negative")
    }

    /// Weights with sum 1: one weight is from `least` to 1.4 times `least`, the others are similar.
    fn weights<const N: usize>(&mut self, least: f64) -> ([f64; N], usize) {
        let chosen = self.choice::<N>();
        let small = least * self.part(1.0, 1.4);
        let mut weights: [f64; N] = std::array::from_fn(|_| self.random.between(1.0, 1.2));
        let others: f64 = (0..N).filter(|&i| i != chosen).map(|i| weights[i]).sum();
        weights.iter_mut().for_each(|weight| *weight *= (1.0 - small) / others);
        weights[chosen] = small;
        (weights, chosen)
    }

    fn edge_vertex(&mut self) -> [Vec<Point>; 2] {
        let [sigma, tau] = [Symbol::Sigma, Symbol::Tau].map(|symbol| self.published.rounded(symbol));
        let (m, distance) = match self.symbol {
            Symbol::SigmaHat => (self.target, tau[0] * self.part(0.0, 0.5)),
            _ => (sigma[2] * self.part(2.0, 4.0), self.target),
        };
        let along = m * self.part(0.3, 0.7);
        [vec![[0.0; 3], [m, 0.0, 0.0]], vec![[along, distance, 0.0]]]
    }

    /// Two edges through the origin, or above each other there.
    fn edge_edge(&mut self, dimension: Dimension) -> [Vec<Point>; 2] {
        let sine: f64 = self.part(0.6, 1.0);
        let cosine = (1.0 - sine * sine).sqrt();
        let mut ends: [f64; 4] = std::array::from_fn(|_| self.random.between(0.9, 1.1));
        let at = self.choice::<4>();
        let unit = self.published.rounded(Symbol::Tau)[0] / 4.0;
        let of = |ends: &[f64; 4]| [ends[0] + ends[1], ends[2] + ends[3]];
        let (size, lift) = match (self.symbol, dimension) {
            (Symbol::Gamma, _) => (10.0 * unit, self.target),
            (Symbol::Lambda, _) => {
                ends = [1.0; 4];
                (self.size((4.0 * sine) * (4.0 * sine), 4), unit * self.part(0.0, 0.5))
            }
            (symbol, _) => {
                ends[at] *= 0.2;
                let [u, v] = of(&ends);
                let area = u * v * sine;
                if symbol == Symbol::Kappa {
                    let other = if at < 2 { v } else { u };
                    (self.size(ends[at] * other * sine, 2), 0.0)
                } else {
                    let weight = ends[at] / if at < 2 { u } else { v };
                    (self.size(weight * (area * area), 4), unit * self.part(0.0, 0.5))
                }
            }
        };
        let [a, b, p, q] = ends.map(|end| end * size);
        let first = vec![[-a, 0.0, 0.0], [b, 0.0, 0.0]];
        [first, vec![[-p * cosine, -p * sine, lift], [q * cosine, q * sine, lift]]]
    }

    /// An approximately equilateral triangle, and twice its area.
    fn triangle(&mut self) -> ([[f64; 2]; 3], f64) {
        let corners = [[1.0, 0.0], [-0.5, 0.866], [-0.5, -0.866]];
        let corners = corners.map(|corner| corner.map(|x: f64| x + self.random.between(-0.05, 0.05)));
        let [a, b, c] = corners;
        (corners, (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    }

    fn triangle_vertex(&mut self, dimension: Dimension) -> [Vec<Point>; 2] {
        let (corners, area) = self.triangle();
        let least = if matches!(self.symbol, Symbol::Kappa | Symbol::Zeta) { 0.08 } else { 0.28 };
        let (weights, chosen) = self.weights::<3>(least);
        let small = weights[chosen];
        let unit = self.published.rounded(Symbol::Tau)[0] / 4.0;
        let (size, lift) = match (self.symbol, dimension) {
            (Symbol::Kappa, _) => (self.size(small * area, 2), 0.0),
            (Symbol::Delta, _) => (10.0 * unit, self.target),
            (Symbol::Nu, _) => (self.size(area * area, 4), unit * self.part(0.0, 0.5)),
            _ => (self.size(small * (area * area), 4), unit * self.part(0.0, 0.5)),
        };
        let [x, y] = within(&corners, &weights);
        [corners.map(|[x, y]| [x * size, y * size, 0.0]).to_vec(), vec![[x * size, y * size, lift]]]
    }

    /// An edge through a point of the triangle.
    fn triangle_edge(&mut self) -> [Vec<Point>; 2] {
        let (corners, area) = self.triangle();
        let is_mu = self.symbol == Symbol::Mu;
        let (weights, chosen) = self.weights::<3>(if is_mu { 0.07 } else { 0.28 });
        let short = if is_mu { self.part(0.45, 0.55) } else { self.part(0.15, 0.2) };
        let heights = if self.random.one_in(2) { [short, short - 1.0] } else { [1.0 - short, -short] };
        let size = self.size(area * if is_mu { weights[chosen] } else { short }, 3);
        let tilt = self.part(-0.5, 0.5);
        let [x, y] = within(&corners, &weights);
        let edge = heights.map(|height| [(x + tilt * height) * size, y * size, height * size]);
        [corners.map(|[x, y]| [x * size, y * size, 0.0]).to_vec(), edge.to_vec()]
    }

    fn tetrahedron_vertex(&mut self) -> [Vec<Point>; 2] {
        let corners: [Point; 4] = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        let corners = corners.map(|corner| corner.map(|x| x + self.random.between(-0.05, 0.05)));
        let [u, v, w] = [1, 2, 3].map(|i: usize| -> Point { std::array::from_fn(|j| corners[i][j] - corners[0][j]) });
        let volume = (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]))
            + u[2] * (v[0] * w[1] - v[1] * w[0]);
        let (weights, chosen) = self.weights::<4>(0.09);
        let size = self.size(weights[chosen] * volume.abs(), 3);
        let vertex: Point = within(&corners, &weights);
        [corners.map(|corner| corner.map(|x| x * size)).to_vec(), vec![vertex.map(|x| x * size)]]
    }
}

fn within<const N: usize, const D: usize>(corners: &[[f64; D]; N], weights: &[f64; N]) -> [f64; D] {
    std::array::from_fn(|i| corners.iter().zip(weights).map(|(corner, weight)| corner[i] * weight).sum())
}

/// The cube root, by Newton's iteration from the nearest power of eight: equal on every platform.
fn cube_root(x: f64) -> f64 {
    let mut root = 1.0;
    while root * root * root < x {
        root *= 2.0;
    }
    while root * root * root > 8.0 * x {
        root *= 0.5;
    }
    for _ in 0..8 {
        root = (2.0 * root + x / (root * root)) / 3.0;
    }
    root
}

/// Three orthogonal unit vectors; in the plane, the last one is that of z.
fn frame(random: &mut Random, dimension: Dimension) -> [Point; 3] {
    let mut direction = |axes: usize| -> Point {
        loop {
            let p: Point = std::array::from_fn(|i| if i < axes { random.between(-1.0, 1.0) } else { 0.0 });
            let square: f64 = p.iter().map(|x| x * x).sum();
            if (0.05..=1.0).contains(&square) {
                return p.map(|x| x / square.sqrt());
            }
        }
    };
    let e = direction(dimension.count());
    if dimension == Dimension::Two {
        return [e, [-e[1], e[0], 0.0], [0.0, 0.0, 1.0]];
    }
    loop {
        let other = direction(3);
        let along: f64 = e.iter().zip(other).map(|(a, b)| a * b).sum();
        let across: Point = std::array::from_fn(|i| other[i] - along * e[i]);
        let square: f64 = across.iter().map(|x| x * x).sum();
        if square > 0.05 {
            let f = across.map(|x| x / square.sqrt());
            return [e, f, [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]]];
        }
    }
}

/// Two complexes of such pairs, `n` of them and at least one for each test. The pairs are on a grid, not near each
/// other. An edge of length 1 in each complex determines L.
pub(super) fn shapes(dimension: Dimension, n: usize, random: &mut Random) -> [Shape; 2] {
    const PITCH: f64 = 0.25;
    let tests: Vec<_> = all(dimension).collect();
    let count = n.max(tests.len());
    let published = Published::for_lengths(dimension, [1.0, 1.0], 52);
    let mut side = 1;
    while side * side < count {
        side += 1;
    }
    let mut shapes = [0.0, 1.0].map(|y| {
        let mut shape = Shape { coordinates: Vec::new(), simplices: Simplices::default() };
        push(&mut shape, dimension, &[[0.0, -8.0 - 8.0 * y, 0.0], [1.0, -8.0 - 8.0 * y, 0.0]]);
        shape
    });
    for at in 0..count {
        let (kind, symbol) = tests[at % tests.len()];
        let place = [at % side, at / side].map(|k| PITCH * integer(i64::try_from(k).expect("a grid in memory")));
        let placed = |[x, y, z]: Point| [x + place[0], y + place[1], z];
        let mut pair = pair(random, &published, kind, symbol).map(|s| s.into_iter().map(placed).collect::<Vec<_>>());
        // The simplex of higher rank belongs to either complex.
        if random.one_in(2) {
            pair.swap(0, 1);
        }
        shapes.iter_mut().zip(pair).for_each(|(shape, simplex)| push(shape, dimension, &simplex));
    }
    shapes
}

fn push(shape: &mut Shape, dimension: Dimension, simplex: &[Point]) {
    let first = shape.coordinates.len() / dimension.count();
    shape.coordinates.extend(simplex.iter().flat_map(|point| point[..dimension.count()].iter().copied()));
    let v = |i: usize| Vertex::input(first + i);
    match simplex.len() {
        1 => shape.simplices.vertices.push(v(0)),
        2 => shape.simplices.edges.push([v(0), v(1)]),
        3 => shape.simplices.triangles.push([v(0), v(1), v(2)]),
        _ => shape.simplices.tetrahedra.push([v(0), v(1), v(2), v(3)]),
    }
}
