//! How far vertices have moved, in rationals.

use predicament_judge::rational;
use predicament_predicates::{Scene, Vertex};
use rug::Rational;

/// The vertex that each vertex has become, step after step.
#[derive(Clone, Debug)]
pub struct Reached {
    became: Vec<Option<Vertex>>,
}

impl Reached {
    /// Vertices that have not moved.
    #[must_use]
    pub fn new(vertices: usize) -> Reached {
        Reached { became: vec![None; vertices] }
    }

    /// Moves a vertex into another one. It has not moved before.
    pub fn join(&mut self, gone: Vertex, kept: Vertex) {
        self.became[gone.index()] = Some(kept);
    }

    /// The vertex that a vertex has become.
    #[must_use]
    pub fn of(&self, v: Vertex) -> Vertex {
        let mut at = v;
        while let Some(next) = self.became[at.index()] {
            at = next;
        }
        at
    }

    /// The largest squared distance between a vertex and the vertex that it has become.
    #[must_use]
    pub fn farthest(&self, scene: &Scene) -> Rational {
        let all = scene.vertices().map(|v| squared(scene, v, self.of(v)));
        all.max().unwrap_or_default()
    }
}

/// The squared distance of two vertices.
pub(super) fn squared(scene: &Scene, a: Vertex, b: Vertex) -> Rational {
    if a == b {
        return Rational::new();
    }
    let [a, b] = [a, b].map(|v| scene.point3(v).map(rational));
    let sides = a.into_iter().zip(b).map(|(x, y)| (x - y).square());
    sides.fold(Rational::new(), |sum, square| sum + square)
}

/// How far vertices may have moved, by the lengths of the steps: in doubles, and too large.
#[derive(Clone, Debug)]
pub struct Chains {
    bounds: Vec<f64>,
}

impl Chains {
    /// Vertices that have not moved.
    #[must_use]
    pub fn new(vertices: usize) -> Chains {
        Chains { bounds: vec![0.0; vertices] }
    }

    /// Moves a vertex into another one.
    pub fn join(&mut self, scene: &Scene, gone: Vertex, kept: Vertex) {
        let [a, b] = [gone, kept].map(|v| scene.point3(v));
        // A length is at most √3 times its longest side.
        let longest = [0, 1, 2].map(|axis| (a[axis] - b[axis]).abs()).into_iter().fold(0.0, f64::max);
        let through = self.bounds[gone.index()] + 1.75 * longest;
        let bound = &mut self.bounds[kept.index()];
        *bound = bound.max(through);
    }

    /// The largest bound, with room for roundings.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.bounds.iter().fold(f64::MIN_POSITIVE, |largest, &bound| largest.max(bound))
    }
}
