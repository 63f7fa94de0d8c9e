//! The exact locations of merged points, and turns between them.

use crate::answer::Weights;
use crate::answer::{Arrangement, MergedPoint, Seat, Side, Stand};
use predicament_judge::boxes::{Extent, extent};
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Plane, Scene, Sign, Vertex};
use rug::{Integer, Rational};

type Place = [Rational; 2];

/// The merged points of the plane, as integers over one common denominator.
pub(super) struct Seated {
    /// The points; `None` for points without a vertex: at crossings, edges do not bend.
    points: Vec<Option<[Integer; 2]>>,
    /// The rounded points; rounding is monotone, so boxes that meet still meet.
    about: Vec<Option<[f64; 2]>>,
}

impl Seated {
    pub(super) fn new(scene: &Scene, complexes: [&Complex; 2], arrangement: &Arrangement, seat: Seat) -> Seated {
        let rule = Rule { scene, complexes, arrangement };
        let points = arrangement.points().iter();
        let places: Vec<Option<Place>> =
            points.map(|point| (!point.is_new()).then(|| rule.place(point, seat))).collect();
        let about = places.iter().map(|place| place.as_ref().map(|place| place.each_ref().map(truncated))).collect();
        // Every denominator is a power of two, so the largest is a multiple of all.
        let coordinates = || places.iter().flatten().flatten();
        let denominator = coordinates().map(Rational::denom).max().cloned().unwrap_or_else(|| Integer::from(1));
        let integer = |x: &Rational| Integer::from(x.numer() * &denominator) / x.denom();
        let points = places.iter().map(|place| place.as_ref().map(|[x, y]| [integer(x), integer(y)])).collect();
        Seated { points, about }
    }

    fn at(&self, point: usize) -> &[Integer; 2] {
        self.points[point].as_ref().expect("pieces end at points with vertices")
    }

    /// The bounding box of a piece; pieces that meet have boxes that meet.
    pub(super) fn bounds(&self, piece: [usize; 2]) -> Extent<2> {
        extent(piece.map(|point| self.about[point].expect("pieces end at points with vertices")))
    }

    /// True if two points are in one place.
    pub(super) fn coincide(&self, [p, q]: [usize; 2]) -> bool {
        self.at(p) == self.at(q)
    }

    /// True if two pieces cross, the second one moved by (δ, δ²).
    pub(super) fn crosses(&self, [p, q]: [usize; 2], [r, s]: [usize; 2]) -> bool {
        let ([p, q], [r, s]) = ([p, q].map(|at| self.at(at)), [r, s].map(|at| self.at(at)));
        if (0..2).any(|axis| apart([&p[axis], &q[axis]], [&r[axis], &s[axis]])) {
            return false;
        }
        let moved_ends = [r, s].map(|moved| turn([p, q], moved, -1));
        let ends = [p, q].map(|fixed| turn([r, s], fixed, 1));
        [moved_ends, ends].iter().all(|&[one, other]| one != Sign::Zero && one == -other)
    }
}

/// The nearest finite double towards zero.
fn truncated(x: &Rational) -> f64 {
    x.to_f64().clamp(f64::MIN, f64::MAX)
}

/// True if two closed intervals are disjoint.
fn apart([a, b]: [&Integer; 2], [c, d]: [&Integer; 2]) -> bool {
    a.max(b) < c.min(d) || c.max(d) < a.min(b)
}

/// The turn from a to b to the point, where the point is moved by (δ, δ²) (`by` = −1) or a and b both are (`by` = 1).
/// Zero only if a and b coincide.
///
/// Let u = b − a. Then u × (p + (δ, δ²) − a) = u × (p − a) + δ²·u.x − δ·u.y.
fn turn([a, b]: [&[Integer; 2]; 2], p: &[Integer; 2], by: i32) -> Sign {
    let difference = |p: &[Integer; 2]| [Integer::from(&p[0] - &a[0]), Integer::from(&p[1] - &a[1])];
    let (u, w) = (difference(b), difference(p));
    let area = Integer::from(&u[0] * &w[1]) - Integer::from(&u[1] * &w[0]);
    let broken = || u[1].cmp0().then_with(|| u[0].cmp0().reverse());
    let order = area.cmp0().then_with(|| if by < 0 { broken().reverse() } else { broken() });
    order.into()
}

struct Rule<'a> {
    scene: &'a Scene,
    complexes: [&'a Complex; 2],
    arrangement: &'a Arrangement,
}

impl Rule<'_> {
    fn place(&self, point: &MergedPoint, seat: Seat) -> Place {
        let on = |side| self.on(point, side);
        let place = match seat {
            Seat::A => on(Side::A).or_else(|| on(Side::B)),
            Seat::B => on(Side::B).or_else(|| on(Side::A)),
            Seat::Middle => match [on(Side::A), on(Side::B)] {
                [Some(a), Some(b)] => Some(middle(a, b)),
                [a, b] => a.or(b),
            },
        };
        place.expect("a point with vertices stands at one")
    }

    /// The place of the point on one complex.
    fn on(&self, point: &MergedPoint, side: Side) -> Option<Place> {
        match point.stand(side)? {
            Stand::Vertex(vertex) => Some(self.of(vertex)),
            // A vertex in a triangle of the plane is inside of it and keeps its place.
            Stand::Inside(simplex, _) if simplex.rank > 1 => None,
            Stand::Inside(edge, weights) => {
                let from = point.vertices[side.other() as usize].first().map(|&vertex| self.of(vertex));
                Some(self.along(side, edge, weights, &from.expect("a point with vertices")))
            }
        }
    }

    /// The point of an edge with these weights. A point exactly on the edge's line keeps its place: weights are
    /// rounded, coordinates are not.
    fn along(&self, side: Side, edge: Simplex, weights: Weights, from: &Place) -> Place {
        let complex = self.complexes[side as usize];
        let ends = [0, 1].map(|end| {
            let vertex = complex.vertices_of(edge)[end];
            let index = complex.find(&[vertex]).expect("an edge's ends are in its complex").index;
            let merged = &self.arrangement.points()[self.arrangement.of_vertex(side, index)];
            self.of(merged.vertices[side as usize][0])
        });
        let [a, b] = &ends;
        let u = [0, 1].map(|axis| Rational::from(&b[axis] - &a[axis]));
        let w = [0, 1].map(|axis| Rational::from(&from[axis] - &a[axis]));
        if Rational::from(&u[0] * &w[1]) == Rational::from(&u[1] * &w[0]) {
            return from.clone();
        }
        let fraction = Rational::from_f64(weights[1]).expect("weights are finite");
        [0, 1].map(|axis| Rational::from(&u[axis] * &fraction) + &a[axis])
    }

    fn of(&self, vertex: Vertex) -> Place {
        self.scene.point2(Plane::Xy, vertex).map(|x| Rational::from_f64(x).expect("coordinates are finite"))
    }
}

fn middle([ax, ay]: Place, [bx, by]: Place) -> Place {
    [(ax + bx) / 2, (ay + by) / 2]
}

#[cfg(test)]
mod places;

#[cfg(test)]
mod tests {
    use predicament_judge::boxes::are_near;

    use super::*;

    fn at(points: &[[i32; 2]]) -> Seated {
        let about = points.iter().map(|p| Some(p.map(f64::from))).collect();
        Seated { points: points.iter().map(|p| Some(p.map(Integer::from))).collect(), about }
    }

    /// Values between doubles, beyond the largest double, and at the ends of the range.
    #[test]
    fn truncation_keeps_the_order() {
        let third = Rational::from((1, 3));
        let huge = Rational::from_f64(f64::MAX).unwrap() * 2_u32;
        let tiny = Rational::from_f64(f64::from_bits(1)).unwrap() / 3_u32;
        let mut numbers =
            vec![Rational::new(), huge.clone(), -huge, tiny.clone(), -tiny, third.clone(), -third.clone()];
        for step in 0..200_i64 {
            numbers.push(third.clone() + Rational::from((step - 100, 1_u64 << 56)));
            numbers.push(Rational::from_f64(f64::from_bits(step.unsigned_abs())).unwrap() * &third);
        }
        numbers.sort();
        assert!(numbers.iter().map(truncated).is_sorted());
        assert!(numbers.iter().map(truncated).all(f64::is_finite));
        assert!(numbers.windows(2).filter(|two| truncated(&two[0]) == truncated(&two[1])).count() > 20, "rounded");
    }

    #[test]
    fn boxes_of_pieces_that_cross_meet() {
        let grid: Vec<[i32; 2]> = (0..16).map(|i| [i / 4, i % 4]).collect();
        let seated = at(&grid);
        let (mut crossing, mut excluded) = (0, 0);
        for code in 0..16_usize.pow(4) {
            let [p, q, r, s] = [0, 1, 2, 3].map(|digit| code / 16_usize.pow(digit) % 16);
            let near = are_near(&seated.bounds([p, q]), &seated.bounds([r, s]), 0.0);
            let crosses = seated.crosses([p, q], [r, s]);
            assert!(near || !crosses, "{p} {q} {r} {s}");
            crossing += usize::from(crosses);
            excluded += usize::from(!near);
        }
        assert!(crossing > 500 && excluded > 500, "{crossing} {excluded}");
    }

    /// A number replaces the infinitesimal: far smaller than any distance here, and positive.
    #[test]
    fn an_infinitesimal_move_is_a_small_move() {
        let scale = 1 << 12;
        let grid: Vec<[i32; 2]> = (0..9).map(|i| [i / 3, i % 3]).collect();
        let infinitesimal = at(&grid);
        let moved: Vec<[i32; 2]> =
            grid.iter().map(|&[x, y]| [x * scale * scale + scale, y * scale * scale + 1]).collect();
        let fixed: Vec<[i32; 2]> = grid.iter().map(|p| p.map(|x| x * scale * scale)).collect();
        let small = at(&[fixed, moved].concat());
        let mut crossing = 0;
        for code in 0..9_usize.pow(4) {
            let [p, q, r, s] = [0, 1, 2, 3].map(|digit| code / 9_usize.pow(digit) % 9);
            // The second move of `small` is negligible compared with the first.
            let expected = small.crosses([p, q], [r + 9, s + 9]);
            assert_eq!(infinitesimal.crosses([p, q], [r, s]), expected, "{p} {q} {r} {s}");
            crossing += usize::from(expected);
        }
        assert!(crossing > 500, "{crossing}");
    }
}
