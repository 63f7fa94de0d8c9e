//! Vertices in a coordinate plane, as integers.

use predicament_predicates::{Plane, Scene, Vertex};
use rug::{Integer, Rational};

/// Some vertices of a scene in a plane, seen so that outer loops are counterclockwise.
#[derive(Clone, Debug)]
pub struct Points {
    vertices: Vec<Vertex>,
    exact: Vec<[Integer; 2]>,
    raw: Vec<[f64; 2]>,
    /// Coordinates are multiples of 2^−`shift`.
    shift: u32,
}

impl Points {
    /// These input vertices of a scene.
    pub(super) fn new(scene: &Scene, plane: Plane, reversed: bool, vertices: impl Iterator<Item = Vertex>) -> Points {
        let mut vertices: Vec<Vertex> = vertices.collect();
        vertices.sort_unstable();
        vertices.dedup();
        let seen = |&v: &Vertex| {
            let [x, y] = scene.point2(plane, v);
            if reversed { [y, x] } else { [x, y] }
        };
        let raw: Vec<[f64; 2]> = vertices.iter().map(seen).collect();
        let rational = |x: &f64| Rational::from_f64(*x).unwrap_or_default();
        // The denominator of a double is a power of two.
        let bits = |x: &Rational| x.denom().significant_bits() - 1;
        let shift = raw.as_flattened().iter().map(|x| bits(&rational(x))).max().unwrap_or(0);
        let exact = raw.iter().map(|p| {
            p.map(|x| {
                let x = rational(&x);
                let own = bits(&x);
                x.into_numer_denom().0 << (shift - own)
            })
        });
        Points { exact: exact.collect(), vertices, raw, shift }
    }

    /// The place of a vertex among these.
    pub(super) fn place(&self, v: Vertex) -> Option<usize> {
        self.vertices.binary_search(&v).ok()
    }

    pub(super) fn vertex(&self, place: usize) -> Vertex {
        self.vertices[place]
    }

    pub(super) fn len(&self) -> usize {
        self.vertices.len()
    }

    pub(super) fn raw(&self, place: usize) -> [f64; 2] {
        self.raw[place]
    }

    pub(super) fn is_same_place(&self, a: usize, b: usize) -> bool {
        self.exact[a] == self.exact[b]
    }

    pub(super) fn order(&self, a: usize, b: usize) -> std::cmp::Ordering {
        self.exact[a].cmp(&self.exact[b])
    }

    pub(super) fn order_x(&self, a: usize, b: usize) -> std::cmp::Ordering {
        self.exact[a][0].cmp(&self.exact[b][0])
    }

    /// Twice the area of a triangle, positive where it is counterclockwise, in units of 4^−shift.
    pub(super) fn turn(&self, a: usize, b: usize, c: usize) -> Integer {
        let [a, b, c] = [a, b, c].map(|place| &self.exact[place]);
        let across = Integer::from(&b[0] - &a[0]) * Integer::from(&c[1] - &a[1]);
        across - Integer::from(&b[1] - &a[1]) * Integer::from(&c[0] - &a[0])
    }

    /// The sign of [`turn`](Points::turn).
    pub(super) fn side(&self, a: usize, b: usize, c: usize) -> std::cmp::Ordering {
        self.turn(a, b, c).cmp0()
    }

    /// The scalar product of the directions from a to b and from a to c.
    pub(super) fn along(&self, a: usize, b: usize, c: usize) -> Integer {
        let [a, b, c] = [a, b, c].map(|place| &self.exact[place]);
        let x = Integer::from(&b[0] - &a[0]) * Integer::from(&c[0] - &a[0]);
        x + Integer::from(&b[1] - &a[1]) * Integer::from(&c[1] - &a[1])
    }

    /// Whether c is on the closed segment from a to b.
    pub(super) fn is_on(&self, a: usize, b: usize, c: usize) -> bool {
        // On the line, and not beyond either end.
        self.side(a, b, c).is_eq() && self.along(c, a, b).cmp0().is_le()
    }

    /// Twice the area of a loop.
    pub(super) fn area(&self, corners: &[usize]) -> Integer {
        let mut area = Integer::new();
        for pair in corners.get(1..).unwrap_or_default().windows(2) {
            area += self.turn(corners[0], pair[0], pair[1]);
        }
        area
    }

    /// An area in the scene's units.
    pub(super) fn in_scene_units(&self, doubled: &Integer) -> Rational {
        Rational::from(doubled) >> (2 * self.shift + 1)
    }
}
