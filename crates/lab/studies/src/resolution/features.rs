//! The features whose smallest surviving size is measured.
//!
//! A gap survives if nothing is registered across it. A part of a shape survives if its contacts are registered
//! correctly, at the last level of the hierarchy and with nothing more degenerate beside them.

use predicament_contacts::algorithm::pairs::Contacts;
use predicament_mesh::Simplices;
use predicament_predicates::{Dimension, Vertex};

/// A feature with one size.
#[derive(Clone, Copy, Debug)]
pub struct Feature {
    /// The feature's name in tables.
    pub name: &'static str,
    /// The dimension of its scene.
    pub dimension: Dimension,
    /// The length that is the feature's size.
    pub size: &'static str,
    /// The paper's tolerance that limits the feature first.
    pub tolerance: &'static str,
    /// The largest size at which no primitive exceeds its length in any rotation, in units of L.
    pub(super) most: f64,
    /// The ranks of the contacts that must be registered, and no others.
    pub(super) contacts: &'static [[u8; 2]],
    pub(super) shape: fn(f64) -> Shape,
}

/// Points, and the two complexes over them.
pub(super) struct Shape {
    pub(super) points: Vec<[f64; 3]>,
    pub(super) a: Simplices,
    pub(super) b: Simplices,
}

impl Feature {
    /// Returns true if exactly the contacts of the feature are registered.
    #[must_use]
    pub fn survives(&self, contacts: &Contacts) -> bool {
        contacts.registered.iter().map(|contact| [contact.a.rank, contact.b.rank]).eq(self.contacts.iter().copied())
    }
}

/// All features; the features of the plane come first.
pub const FEATURES: &[Feature] = &[
    Feature {
        name: "vertices apart",
        dimension: Dimension::Two,
        size: "their distance",
        tolerance: "σ",
        most: 0.4,
        contacts: &[],
        shape: |h| Shape { points: vec![[0.0; 3], [h, 0.0, 0.0]], a: vertex(0), b: vertex(1) },
    },
    Feature {
        name: "vertex beside edge",
        dimension: Dimension::Two,
        size: "their distance",
        tolerance: "τ",
        most: 0.4,
        contacts: &[],
        shape: |h| Shape { points: vec![LEFT, RIGHT, [0.03, h, 0.0]], a: edges(&[[0, 1]]), b: vertex(2) },
    },
    Feature {
        name: "tooth through edge",
        dimension: Dimension::Two,
        size: "how far the tip sticks out",
        tolerance: "τ",
        most: 0.3,
        contacts: &[[1, 1], [1, 1]],
        shape: |h| Shape {
            points: vec![LEFT, RIGHT, [0.03, h, 0.0], [-0.07, -0.1, 0.0], [0.13, -0.1, 0.0]],
            a: edges(&[[0, 1]]),
            b: edges(&[[2, 3], [3, 4], [2, 4]]),
        },
    },
    Feature {
        name: "triangle around vertex",
        dimension: Dimension::Two,
        size: "its inradius",
        tolerance: "τ",
        most: 0.11,
        contacts: &[[2, 0]],
        shape: |h| Shape { points: [&around(h)[..], &[[0.0; 3]]].concat(), a: triangle(), b: vertex(3) },
    },
    Feature {
        name: "vertices apart",
        dimension: Dimension::Three,
        size: "their distance",
        tolerance: "σ",
        most: 0.4,
        contacts: &[],
        shape: |h| Shape { points: vec![[0.0; 3], [h, 0.0, 0.0]], a: vertex(0), b: vertex(1) },
    },
    Feature {
        name: "vertex beside edge",
        dimension: Dimension::Three,
        size: "their distance",
        tolerance: "τ",
        most: 0.4,
        contacts: &[],
        shape: |h| Shape { points: vec![LEFT, RIGHT, [0.03, h, 0.0]], a: edges(&[[0, 1]]), b: vertex(2) },
    },
    Feature {
        name: "edges passing",
        dimension: Dimension::Three,
        size: "their distance",
        tolerance: "γ",
        most: 0.4,
        contacts: &[],
        shape: |h| Shape {
            points: vec![LEFT, RIGHT, [0.05, -0.2, h], [-0.02, 0.2, h]],
            a: edges(&[[0, 1]]),
            b: edges(&[[2, 3]]),
        },
    },
    Feature {
        name: "vertex beside triangle",
        dimension: Dimension::Three,
        size: "their distance",
        tolerance: "δ",
        most: 0.4,
        contacts: &[],
        shape: |h| Shape { points: [&around(WIDE)[..], &[[0.0, 0.0, h]]].concat(), a: triangle(), b: vertex(3) },
    },
    Feature {
        name: "tip through triangle",
        dimension: Dimension::Three,
        size: "how far the edge's end sticks out",
        tolerance: "δ",
        most: 0.2,
        contacts: &[[2, 1]],
        shape: |h| Shape {
            points: [&around(WIDE)[..], &[[0.0, 0.0, h], [0.0, 0.0, -0.2]]].concat(),
            a: triangle(),
            b: edges(&[[3, 4]]),
        },
    },
    Feature {
        name: "edge through triangle",
        dimension: Dimension::Three,
        size: "the triangle's inradius",
        tolerance: "γ",
        most: 0.11,
        contacts: &[[2, 1]],
        shape: |h| Shape {
            points: [&around(h)[..], &[[0.0, 0.0, 0.2], [0.0, 0.0, -0.2]]].concat(),
            a: triangle(),
            b: edges(&[[3, 4]]),
        },
    },
    Feature {
        name: "tetrahedron around vertex",
        dimension: Dimension::Three,
        size: "its inradius",
        tolerance: "τ",
        most: 0.07,
        contacts: &[[3, 0]],
        shape: |h| Shape {
            points: [
                &[[h, h, h], [h, -h, -h], [-h, h, -h], [-h, -h, h]].map(|p| p.map(|c| c * 3.0_f64.sqrt()))[..],
                &[[0.0; 3]],
            ]
            .concat(),
            a: Simplices { tetrahedra: vec![[0, 1, 2, 3].map(Vertex::input)], ..Simplices::default() },
            b: vertex(4),
        },
    },
];

const LEFT: [f64; 3] = [-0.2, 0.0, 0.0];
const RIGHT: [f64; 3] = [0.2, 0.0, 0.0];
/// The inradius of a large triangle.
const WIDE: f64 = 0.1;

/// An equilateral triangle around the origin, by its inradius.
fn around(inradius: f64) -> [[f64; 3]; 3] {
    let half_side = 3.0_f64.sqrt() * inradius;
    [[-half_side, -inradius, 0.0], [half_side, -inradius, 0.0], [0.0, 2.0 * inradius, 0.0]]
}

fn vertex(index: usize) -> Simplices {
    Simplices { vertices: vec![Vertex::input(index)], ..Simplices::default() }
}

fn edges(edges: &[[usize; 2]]) -> Simplices {
    Simplices { edges: edges.iter().map(|edge| edge.map(Vertex::input)).collect(), ..Simplices::default() }
}

fn triangle() -> Simplices {
    Simplices { triangles: vec![[0, 1, 2].map(Vertex::input)], ..Simplices::default() }
}
