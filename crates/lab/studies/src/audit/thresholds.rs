//! Pairs of simplices at the edges of a tolerance scheme's thresholds.
//!
//! Random pairs are either far apart or cross: no distance is ever near a tolerance of some 10⁻⁸ of their size. Here
//! each pair is built around the thresholds of the hierarchy of Wang, Jiang, Schroeder and Teran. Its own distance is
//! at T₋, T or T₊. Its feet are near the ends of the simplices, where the sub-pairs' thresholds are. Edges are nearly
//! parallel and triangles thin enough for the guarded quantities to be near their bounds. One in four is a few σ in
//! size, with faces that nearly touch. This module does not know the exact distances of a pair; exact arithmetic
//! determines them.
//!
//! It is deterministic as all generators: ChaCha8, and + − · / √ only.

use predicament_formats::bits::power_of_two;

use predicament_corpus::Random;

/// The thresholds T₋, T and T₊ of each distance.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Thresholds {
    /// L: an upper bound of all coordinate differences within a pair.
    pub length: f64,
    /// σ, vertex-vertex.
    pub sigma: [f64; 3],
    /// τ, edge-vertex.
    pub tau: [f64; 3],
    /// δ, triangle-vertex in space.
    pub delta: [f64; 3],
    /// γ, edge-edge in space.
    pub gamma: [f64; 3],
}

/// A stream of random pairs at the thresholds.
pub struct ThresholdPairs {
    random: Random,
    thresholds: Thresholds,
    round: fn(f64) -> f64,
}

type Simplices<const D: usize> = [Vec<[f64; D]>; 2];

impl ThresholdPairs {
    /// A new stream.
    ///
    /// `round` rounds coordinates to numbers of the precision under test.
    #[must_use]
    pub fn new(seed: u64, thresholds: Thresholds, round: fn(f64) -> f64) -> ThresholdPairs {
        ThresholdPairs { random: Random::new("thresholds", "contacts", seed), thresholds, round }
    }

    /// A pair of the plane with these ranks, the higher first.
    ///
    /// # Panics
    /// If the hierarchy of the plane has no such pair.
    pub fn plane(&mut self, ranks: [u8; 2]) -> Simplices<2> {
        loop {
            let pair = match ranks {
                [0, 0] => self.vertex_vertex(),
                _ if self.random.one_in(4) => Some(self.touching(ranks)),
                [1, 0] => self.edge_vertex(),
                [1, 1] => self.edge_edge2d(),
                [2, 0] => self.triangle_vertex2d(),
                _ => panic!("no pair of the plane has ranks {ranks:?}"),
            };
            if let Some(pair) = pair.and_then(|pair| self.place(pair)) {
                return pair;
            }
        }
    }

    /// A pair of space with these ranks, the higher first.
    ///
    /// # Panics
    /// If the hierarchy of space has no such pair.
    pub fn space(&mut self, ranks: [u8; 2]) -> Simplices<3> {
        loop {
            let pair = match ranks {
                [0, 0] => self.vertex_vertex(),
                _ if self.random.one_in(4) => Some(self.touching(ranks)),
                [1, 0] => self.edge_vertex(),
                [1, 1] => self.edge_edge3d(),
                [2, 0] => self.triangle_vertex3d(),
                [2, 1] => self.triangle_edge(),
                [3, 0] => self.tetrahedron_vertex(),
                _ => panic!("no pair of space has ranks {ranks:?}"),
            };
            if let Some(pair) = pair.and_then(|pair| self.place(pair)) {
                return pair;
            }
        }
    }

    fn vertex_vertex<const D: usize>(&mut self) -> Option<Simplices<D>> {
        let distance = self.aim(self.thresholds.sigma);
        Some([vec![[0.0; D]], vec![times(self.direction(), distance)]])
    }

    /// Two simplices a few σ in size, where a point of a face of one is next to a point of a face of the other.
    ///
    /// A contact that is not registered there is missed at the higher levels.
    fn touching<const D: usize>(&mut self, ranks: [u8; 2]) -> Simplices<D> {
        let side = self.thresholds.sigma[1] * self.random.between(2.0, 8.0);
        let [first, second]: Simplices<D> = ranks
            .map(|rank| (0..=rank).map(|_| std::array::from_fn(|_| side * self.random.between(-0.5, 0.5))).collect());
        let off = self.thresholds.tau[0] * power_of_two(-self.random.integer(0, 5));
        let off = times(self.direction(), off * self.random.unit());
        let target = plus(self.on_a_face(&first), off);
        let by = plus(target, times(self.on_a_face(&second), -1.0));
        [first, second.into_iter().map(|vertex| plus(vertex, by)).collect()]
    }

    /// A point of a random face; all faces are equally likely.
    fn on_a_face<const D: usize>(&mut self, simplex: &[[f64; D]]) -> [f64; D] {
        let all = (1_i64 << simplex.len()) - 1;
        let chosen = self.random.integer(1, all);
        let weights: Vec<f64> = (0..simplex.len())
            .map(|i| if chosen >> i & 1 == 1 { self.random.between(0.125, 1.0) } else { 0.0 })
            .collect();
        let sum: f64 = weights.iter().sum();
        let parts = simplex.iter().zip(&weights).map(|(vertex, weight)| times(*vertex, weight / sum));
        parts.fold([0.0; D], plus)
    }

    /// An edge and a vertex whose foot is on the edge, near its ends, or beyond them.
    fn edge_vertex<const D: usize>(&mut self) -> Option<Simplices<D>> {
        let u = self.direction();
        let n = self.across(u)?;
        let m = self.size();
        let distance = self.aim(self.thresholds.tau);
        let near_end = self.beside(self.thresholds.sigma, distance);
        let along = match self.random.integer(0, 5) {
            0 | 1 => near_end,
            2 | 3 => m - near_end,
            4 => m * self.random.unit(),
            _ if self.random.one_in(2) => -near_end,
            _ => m + near_end,
        };
        Some([vec![[0.0; D], times(u, m)], vec![plus(times(u, along), times(n, distance))]])
    }

    fn edge_edge2d(&mut self) -> Option<Simplices<2>> {
        let (u, v, sine) = self.two_directions()?;
        let ends = [(); 4].map(|()| self.end(self.thresholds.tau, 0.0, sine));
        Some(arms(u, v, [0.0; 2], ends))
    }

    fn edge_edge3d(&mut self) -> Option<Simplices<3>> {
        let (u, v, sine) = self.two_directions()?;
        let distance = self.aim(self.thresholds.gamma);
        let lift = times(normalized(cross(u, v))?, distance);
        let ends = [(); 4].map(|()| self.end(self.thresholds.tau, distance, sine));
        Some(arms(u, v, lift, ends))
    }

    /// A triangle around the origin: three lines at chosen distances from it.
    fn triangle_vertex2d(&mut self) -> Option<Simplices<2>> {
        let triangle = self.triangle(self.thresholds.tau, 0.0)?;
        Some([triangle.to_vec(), vec![[0.0; 2]]])
    }

    fn triangle_vertex3d(&mut self) -> Option<Simplices<3>> {
        let distance = self.aim(self.thresholds.delta);
        let ([e, f], n) = self.frame()?;
        let triangle = self.triangle(self.thresholds.tau, distance)?;
        Some([triangle.map(|[x, y]| plus(times(e, x), times(f, y))).to_vec(), vec![times(n, distance)]])
    }

    /// An edge through a point inside the triangle, its ends at chosen heights.
    fn triangle_edge(&mut self) -> Option<Simplices<3>> {
        let ([e, f], n) = self.frame()?;
        let triangle = self.triangle(self.thresholds.gamma, 0.0)?;
        let tilt = self.random.unit() * power_of_two(self.random.integer(-6, 2));
        let direction = plus(n, times(e, tilt));
        let ends = [(); 2].map(|()| self.end(self.thresholds.delta, 0.0, 1.0));
        let triangle = triangle.map(|[x, y]| plus(times(e, x), times(f, y)));
        Some([triangle.to_vec(), vec![times(direction, ends[0]), times(direction, -ends[1])]])
    }

    /// A tetrahedron around the origin: four planes at chosen distances from it.
    fn tetrahedron_vertex(&mut self) -> Option<Simplices<3>> {
        let [a, b, c]: [[f64; 3]; 3] = [(); 3].map(|()| self.direction());
        let weights = [(); 3].map(|()| self.random.between(0.1, 1.0));
        let d = plus(plus(times(a, weights[0]), times(b, weights[1])), times(c, weights[2]));
        let normals = [a, b, c, normalized(times(d, -1.0))?];
        let heights = [(); 4].map(|()| self.end(self.thresholds.delta, 0.0, 1.0));
        let corner = |skip: usize| {
            let rest: Vec<usize> = (0..4).filter(|&i| i != skip).collect();
            let [i, j, k] = [rest[0], rest[1], rest[2]];
            let [u, v, w] = [normals[i], normals[j], normals[k]];
            let determinant = dot(cross(u, v), w);
            let sum = plus(
                plus(times(cross(v, w), heights[i]), times(cross(w, u), heights[j])),
                times(cross(u, v), heights[k]),
            );
            (determinant != 0.0).then(|| times(sum, 1.0 / determinant))
        };
        Some([vec![corner(0)?, corner(1)?, corner(2)?, corner(3)?], vec![[0.0; 3]]])
    }

    /// A triangle around the origin with lines at chosen distances.
    ///
    /// A point `lift` above the origin is then near the thresholds of its edges.
    fn triangle(&mut self, band: [f64; 3], lift: f64) -> Option<[[f64; 2]; 3]> {
        let [a, b]: [[f64; 2]; 2] = [self.direction(), self.direction()];
        let weights = [(); 2].map(|()| self.random.between(0.1, 1.0));
        let c = normalized(times(plus(times(a, weights[0]), times(b, weights[1])), -1.0))?;
        let heights = [(); 3].map(|()| self.end(band, lift, 1.0));
        let corner = |(u, h): ([f64; 2], f64), (v, k): ([f64; 2], f64)| {
            let determinant = u[0] * v[1] - u[1] * v[0];
            let point = [(h * v[1] - k * u[1]) / determinant, (k * u[0] - h * v[0]) / determinant];
            (determinant != 0.0).then_some(point)
        };
        let lines = [(a, heights[0]), (b, heights[1]), (c, heights[2])];
        Some([corner(lines[1], lines[2])?, corner(lines[2], lines[0])?, corner(lines[0], lines[1])?])
    }

    /// The distance to an end of an edge that is crossed at an angle.
    ///
    /// It has any size, or puts the end at a threshold of the other edge, before or behind it.
    fn end(&mut self, band: [f64; 3], distance: f64, sine: f64) -> f64 {
        match self.random.integer(0, 15) {
            0..=6 => self.size(),
            15 => -self.beside(band, distance) / sine,
            _ => self.beside(band, distance) / sine,
        }
    }

    /// The other leg of a right triangle with its hypotenuse at a threshold; zero if there is none.
    fn beside(&mut self, band: [f64; 3], leg: f64) -> f64 {
        let hypotenuse = self.aim(band);
        (hypotenuse * hypotenuse - leg * leg).max(0.0).sqrt()
    }

    /// A target T₋, T or T₊, off by up to a half of it or down to 2⁻³⁰ of that.
    fn aim(&mut self, [lower, width, upper]: [f64; 3]) -> f64 {
        let target = match self.random.integer(0, 2) {
            0 => lower,
            1 => width,
            _ => upper,
        };
        target * (1.0 + self.random.between(-0.5, 0.5) * power_of_two(-self.random.integer(0, 30)))
    }

    /// A random size from L down to about σ; all powers of two are equally likely.
    fn size(&mut self) -> f64 {
        let halvings = (0..64).take_while(|&k| self.thresholds.length * power_of_two(-k) > self.thresholds.sigma[0]);
        let last = halvings.last().unwrap_or(0);
        self.thresholds.length * power_of_two(-self.random.integer(0, last)) * self.random.between(0.5, 1.0)
    }

    /// Two unit vectors and the sine of the angle between them.
    ///
    /// The angle is from a right angle to nearly zero.
    fn two_directions<const D: usize>(&mut self) -> Option<([f64; D], [f64; D], f64)> {
        let u = self.direction();
        let n = self.across(u)?;
        let halvings = self.random.integer(0, 12);
        let sine = self.random.between(0.5, 1.0) * power_of_two(-self.random.integer(0, halvings));
        let cosine = (1.0 - sine * sine).sqrt() * if self.random.one_in(2) { 1.0 } else { -1.0 };
        Some((u, plus(times(u, cosine), times(n, sine)), sine))
    }

    fn frame(&mut self) -> Option<([[f64; 3]; 2], [f64; 3])> {
        let n = self.direction();
        let e = self.across(n)?;
        Some(([e, cross(n, e)], n))
    }

    fn direction<const D: usize>(&mut self) -> [f64; D] {
        loop {
            let candidate: [f64; D] = std::array::from_fn(|_| self.random.between(-1.0, 1.0));
            if let Some(direction) = normalized(candidate).filter(|_| dot(candidate, candidate) <= 1.0) {
                return direction;
            }
        }
    }

    /// A unit vector at a right angle to another.
    fn across<const D: usize>(&mut self, u: [f64; D]) -> Option<[f64; D]> {
        let candidate: [f64; D] = self.direction();
        normalized(plus(candidate, times(u, -dot(candidate, u))))
    }

    /// The pair moved to a random place within L of the origin, in the precision under test.
    ///
    /// `None` if the pair is larger than L.
    fn place<const D: usize>(&mut self, pair: Simplices<D>) -> Option<Simplices<D>> {
        let origin: [f64; D] = if self.random.one_in(4) {
            [0.0; D]
        } else {
            std::array::from_fn(|_| self.thresholds.length * self.random.between(-0.5, 0.5))
        };
        let pair = pair.map(|simplex| -> Vec<[f64; D]> {
            simplex.into_iter().map(|point| plus(point, origin).map(self.round)).collect()
        });
        let fits = (0..D).all(|axis| {
            let coordinates = || pair.iter().flatten().map(|point| point[axis]);
            let low = coordinates().fold(f64::INFINITY, f64::min);
            let high = coordinates().fold(f64::NEG_INFINITY, f64::max);
            high - low < self.thresholds.length
        });
        fits.then_some(pair)
    }
}

/// Two edges through a point and its lifted copy.
fn arms<const D: usize>(u: [f64; D], v: [f64; D], lift: [f64; D], ends: [f64; 4]) -> Simplices<D> {
    let first = vec![times(u, -ends[0]), times(u, ends[1])];
    let second = vec![plus(lift, times(v, -ends[2])), plus(lift, times(v, ends[3]))];
    [first, second]
}

fn plus<const D: usize>(a: [f64; D], b: [f64; D]) -> [f64; D] {
    std::array::from_fn(|i| a[i] + b[i])
}

fn times<const D: usize>(a: [f64; D], factor: f64) -> [f64; D] {
    a.map(|x| x * factor)
}

fn dot<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn normalized<const D: usize>(a: [f64; D]) -> Option<[f64; D]> {
    let length = dot(a, a).sqrt();
    (length > 1e-3).then(|| times(a, 1.0 / length))
}
