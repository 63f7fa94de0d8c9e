//! Vertices in a coordinate plane, as integers.

use std::cmp::Ordering;

use predicament_predicates::{Plane, Scene, Vertex};
use rug::{Integer, Rational};

/// Some vertices of a scene in a plane, seen so that outer loops are counterclockwise.
#[derive(Clone, Debug)]
pub struct Points {
    vertices: Vec<Vertex>,
    exact: Vec<[Integer; 2]>,
    raw: Vec<[f64; 2]>,
    /// The exponent of the unit: coordinates are multiples of 2^−`shift`.
    shift: u32,
}

impl Points {
    /// Converts input vertices of a scene to integers.
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

    /// The index of a vertex among the points.
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

    /// For each point, the first of those at its place.
    pub(super) fn first_at_each_place(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.len()).collect();
        order.sort_by(|&a, &b| self.order(a, b).then(a.cmp(&b)));
        let mut first = vec![0; self.len()];
        for same in order.chunk_by(|&a, &b| self.is_same_place(a, b)) {
            same.iter().for_each(|&at| first[at] = same[0]);
        }
        first
    }

    pub(super) fn order(&self, a: usize, b: usize) -> Ordering {
        self.exact[a].cmp(&self.exact[b])
    }

    pub(super) fn order_x(&self, a: usize, b: usize) -> Ordering {
        self.exact[a][0].cmp(&self.exact[b][0])
    }

    /// Twice the area of a triangle, positive where it is counterclockwise, in units of 4^−shift.
    pub(super) fn turn(&self, a: usize, b: usize, c: usize) -> Integer {
        let [a, b, c] = [a, b, c].map(|place| &self.exact[place]);
        let across = Integer::from(&b[0] - &a[0]) * Integer::from(&c[1] - &a[1]);
        across - Integer::from(&b[1] - &a[1]) * Integer::from(&c[0] - &a[0])
    }

    /// The sign of [`turn`](Points::turn); most are certain in doubles.
    pub(super) fn side(&self, a: usize, b: usize, c: usize) -> Ordering {
        let [a_raw, b_raw, c_raw] = [a, b, c].map(|place| self.raw[place]);
        certain(a_raw, b_raw, c_raw).unwrap_or_else(|| self.turn(a, b, c).cmp0())
    }

    /// The scalar product of the directions from a to b and from a to c.
    pub(super) fn along(&self, a: usize, b: usize, c: usize) -> Integer {
        let [a, b, c] = [a, b, c].map(|place| &self.exact[place]);
        let x = Integer::from(&b[0] - &a[0]) * Integer::from(&c[0] - &a[0]);
        x + Integer::from(&b[1] - &a[1]) * Integer::from(&c[1] - &a[1])
    }

    /// True if c is on the closed segment from a to b.
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

/// The side of c on the line from a to b in doubles; `None` if rounding may have changed it.
///
/// Each product is of two differences, so it goes through three roundings, and their difference through a fourth one.
/// The error is about 2^-51 times the sum of their magnitudes; the bound is twice that. A product that underflows is
/// off by 2^-1074 more, which is far less than a bound above 2^-900. If a bound is less or not a number, integers
/// decide.
fn certain(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<Ordering> {
    const LEAST: f64 = f64::from_bits((1023 - 900) << 52);
    let [left, right] = [(b[0] - a[0]) * (c[1] - a[1]), (b[1] - a[1]) * (c[0] - a[0])];
    let (turn, bound) = (left - right, 4.0 * f64::EPSILON * (left.abs() + right.abs()));
    (bound > LEAST && turn.abs() > bound).then(|| turn.total_cmp(&0.0))
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering::{Equal, Greater, Less};

    use predicament_predicates::Dimension;

    use super::*;

    /// A triangle with legs 2 and 1.5, a point on its longest side, a point beyond that side, and the first corner
    /// again.
    fn points(reversed: bool) -> Points {
        let places = vec![0.25, 0.5, 2.25, 0.5, 0.25, 2.0, 1.25, 1.25, 4.25, -1.0, 0.25, 0.5];
        let scene = Scene::new(Dimension::Two, places).unwrap();
        // Unsorted, some vertices twice.
        let vertices = [3, 1, 0, 2, 5, 4, 1, 3].map(Vertex::input);
        Points::new(&scene, Plane::Xy, reversed, vertices.into_iter())
    }

    #[test]
    fn turns_areas_and_products_are_those_by_hand() {
        let points = points(false);
        assert_eq!((points.len(), points.shift), (6, 2));
        // Twice the area is 3: 48 sixteenths.
        assert_eq!([points.turn(0, 1, 2), points.turn(1, 0, 2)], [48, -48].map(Integer::from));
        assert_eq!([points.side(0, 1, 2), points.side(0, 2, 1), points.side(1, 2, 3)], [Greater, Less, Equal]);
        // (2, 0) · (1, 3/4) and (2, 0) · (0, 3/2); (-1, -3/4) · (1, -3/4).
        let products = [points.along(0, 1, 3), points.along(0, 1, 2), points.along(3, 0, 1)];
        assert_eq!(products, [32, 0, -7].map(Integer::from));
        assert_eq!(points.area(&[0, 1, 2]), 48);
        assert_eq!(points.area(&[2, 1, 0]), -48);
        // 4, 1, 2 and 3 are on a line.
        assert_eq!(points.area(&[0, 4, 1, 2]), points.turn(0, 4, 2));
        assert_eq!([&[][..], &[1], &[1, 2]].map(|corners| points.area(corners)), [0, 0, 0].map(Integer::from));
        assert_eq!(points.in_scene_units(&points.area(&[0, 1, 2])), Rational::from((3, 2)));
        assert_eq!(points.in_scene_units(&Integer::from(1)), Rational::from((1, 32)));
    }

    /// Points on a line up to a few last places, and points at the ends of the range of doubles.
    #[test]
    fn certain_sides_are_those_of_integers() {
        let (a, b) = ([0.1, 0.3], [1.7, 2.9]);
        let mut counts = [0; 2];
        for at in 0..400_u32 {
            let share = f64::from(at) / 300.0;
            let x = 0.1 + share * 1.6;
            let y = 0.3 + share * 2.6 + f64::from(at % 9).mul_add(f64::EPSILON, -4.0 * f64::EPSILON);
            let far = if at % 2 == 0 { y } else { y + share };
            for unit in [1.0, 2.0_f64.powi(-520), 2.0_f64.powi(600)] {
                let [a, b, c] = [a, b, [x, far]].map(|p| p.map(|x| x * unit));
                let scene = Scene::new(Dimension::Two, [a, b, c].concat()).unwrap();
                let points = Points::new(&scene, Plane::Xy, false, scene.vertices());
                let found = certain(a, b, c);
                assert!(found.is_none_or(|side| side == points.turn(0, 1, 2).cmp0()), "{a:?} {b:?} {c:?}");
                assert!(found.is_none() || unit == 1.0, "out of range");
                assert_eq!(points.side(0, 1, 2), points.turn(0, 1, 2).cmp0());
                counts[usize::from(found.is_some())] += usize::from(unit == 1.0);
            }
        }
        assert!(counts.iter().all(|&count| count > 100), "{counts:?}");
    }

    #[test]
    fn the_other_side_of_the_plane_turns_the_other_way() {
        let points = points(true);
        assert_eq!(points.turn(0, 1, 2), -48);
        assert_eq!(points.raw(1), [0.5, 2.25]);
        assert_eq!(points.in_scene_units(&points.area(&[2, 1, 0])), Rational::from((3, 2)));
    }

    #[test]
    fn closed_segments_have_their_ends_and_what_is_between() {
        let points = points(false);
        for (a, b, c, is_on) in [
            (1, 2, 3, true),
            (2, 1, 3, true),
            (1, 2, 1, true),
            (1, 2, 2, true),
            (1, 2, 4, false),
            (2, 4, 1, true),
            (1, 2, 0, false),
            (1, 3, 2, false),
            (0, 0, 5, true),
        ] {
            assert_eq!(points.is_on(a, b, c), is_on, "{c} on {a} to {b}");
        }
    }

    #[test]
    fn vertices_have_places_and_places_an_order() {
        let points = points(false);
        assert_eq!(points.place(Vertex::input(4)), Some(4));
        assert_eq!(points.place(Vertex::input(6)), None);
        assert_eq!(points.vertex(3), Vertex::input(3));
        assert!(points.is_same_place(0, 5) && !points.is_same_place(0, 1));
        assert_eq!([points.order(0, 5), points.order(0, 2), points.order(2, 3)], [Equal, Less, Less]);
        assert_eq!([points.order_x(0, 2), points.order_x(3, 2), points.order_x(1, 4)], [Equal, Greater, Less]);
    }
}
