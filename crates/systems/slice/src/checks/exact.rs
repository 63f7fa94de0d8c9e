//! Determinants of rational points.

use std::cmp::Ordering;

use rug::Rational;

/// A point in space.
pub type Point = [Rational; 3];

pub(super) fn minus(p: &Point, q: &Point) -> Point {
    [0, 1, 2].map(|i| Rational::from(&p[i] - &q[i]))
}

/// Component `i` of the cross product.
fn component(u: &Point, v: &Point, i: usize) -> Rational {
    let [j, k] = [(i + 1) % 3, (i + 2) % 3];
    Rational::from(&u[j] * &v[k]) - Rational::from(&u[k] * &v[j])
}

/// Twice the area vector of a triangle.
pub(super) fn normal([a, b, c]: [&Point; 3]) -> Point {
    let [u, v] = [minus(b, a), minus(c, a)];
    [0, 1, 2].map(|i| component(&u, &v, i))
}

pub(super) fn dot(u: &Point, v: &Point) -> Rational {
    u.iter().zip(v).map(|(x, y)| Rational::from(x * y)).sum()
}

/// Six times the volume of the tetrahedron with the origin: a·(b × c).
pub(super) fn volume([a, b, c]: [&Point; 3]) -> Rational {
    dot(a, &[0, 1, 2].map(|i| component(b, c, i)))
}

/// A plane by a point and a normal.
pub(super) struct Plane {
    pub(super) normal: Point,
    at: Point,
}

impl Plane {
    pub(super) fn of(points: [&Point; 3]) -> Plane {
        Plane { normal: normal(points), at: points[0].clone() }
    }

    /// A point of the plane.
    pub(super) fn point(&self) -> &Point {
        &self.at
    }

    /// The product of the normal and the vector from the plane to p.
    pub(super) fn height(&self, p: &Point) -> Rational {
        dot(&self.normal, &minus(p, &self.at))
    }

    /// The side of p: `Greater` in the direction of the normal.
    pub(super) fn side(&self, p: &Point) -> Ordering {
        self.height(p).cmp0()
    }

    /// The distance of p from the plane, rounded only at the end; zero if the normal is zero.
    pub(super) fn distance(&self, p: &Point) -> f64 {
        let lengths = self.normal.iter().map(|x| x.clone().abs());
        let Some(longest) = lengths.max().filter(|longest| !longest.is_zero()) else { return 0.0 };
        let square: Rational = self.normal.iter().map(|x| Rational::from(x / &longest).square()).sum();
        (self.height(p).abs() / longest).to_f64() / square.to_f64().sqrt()
    }
}
