//! The area of the convex hull, computed from the points alone.

use predicament_predicates::{Plane, Scene};
use rug::{Integer, Rational};

/// Points as integers in a common unit.
pub(super) struct Exactly {
    points: Vec<[Integer; 2]>,
}

impl Exactly {
    /// The input vertices of a scene, as integers.
    pub fn new(scene: &Scene) -> Exactly {
        let exact = |x: f64| Rational::from_f64(x).unwrap_or_default();
        // The denominator of a double is a power of two.
        let bits = |x: &Rational| x.denom().significant_bits() - 1;
        let shift = scene.coordinates().iter().map(|&x| bits(&exact(x))).max().unwrap_or(0);
        let integer = |x: f64| {
            let x = exact(x);
            let own = bits(&x);
            x.into_numer_denom().0 << (shift - own)
        };
        Exactly { points: scene.vertices().map(|v| scene.point2(Plane::Xy, v).map(integer)).collect() }
    }

    /// Twice the area of a triangle, positive if it is counterclockwise.
    pub fn area(&self, corners: [usize; 3]) -> Integer {
        turn(corners.map(|corner| &self.points[corner]))
    }

    /// Twice the area of the convex hull of all points: two chains from left to right.
    pub fn hull(&self) -> Integer {
        let mut sorted: Vec<&[Integer; 2]> = self.points.iter().collect();
        sorted.sort_unstable();
        let mut area = Integer::new();
        for upper in [false, true] {
            let mut chain: Vec<&[Integer; 2]> = Vec::new();
            for &point in &sorted {
                while let [.., a, b] = chain[..] {
                    let side = turn([a, b, point]).cmp0();
                    if if upper { side.is_lt() } else { side.is_gt() } {
                        break;
                    }
                    chain.pop();
                }
                chain.push(point);
            }
            for pair in chain.get(1..).unwrap_or_default().windows(2) {
                let part = turn([chain[0], pair[0], pair[1]]);
                area += part.abs();
            }
        }
        area
    }
}

fn turn([a, b, c]: [&[Integer; 2]; 3]) -> Integer {
    let across = Integer::from(&b[0] - &a[0]) * Integer::from(&c[1] - &a[1]);
    across - Integer::from(&b[1] - &a[1]) * Integer::from(&c[0] - &a[0])
}
