//! Volumes of meshes and of their intersections, in rationals, without an overlay.
//!
//! A closed surface is a sum of tetrahedra with one apex: one over each triangle, positive if its front looks away from
//! the apex. So the volume of the intersection of two surfaces is a sum over all pairs of triangles: the product of
//! both signs and the intersection volume of two tetrahedra with the same apex. That intersection is, as seen from the
//! apex, the nearer triangles, cut by cones over the others.

use rug::Rational;

/// A point in space.
pub type Point = [Rational; 3];
/// A surface as triangles, counterclockwise as seen from outside.
pub type Surface = Vec<[Point; 3]>;

pub fn minus(a: &Point, b: &Point) -> Point {
    [0, 1, 2].map(|i: usize| Rational::from(&a[i] - &b[i]))
}

pub fn dot(a: &Point, b: &Point) -> Rational {
    (0..3).map(|i| Rational::from(&a[i] * &b[i])).sum()
}

pub fn cross(a: &Point, b: &Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j): (usize, usize)| Rational::from(&a[i] * &b[j]) - Rational::from(&a[j] * &b[i]))
}

/// Twice the area of a triangle along its normal.
pub fn area([a, b, c]: &[Point; 3]) -> Point {
    cross(&minus(b, a), &minus(c, a))
}

/// The volume that a surface encloses.
pub fn volume(surface: &[[Point; 3]]) -> Rational {
    surface.iter().map(|[a, b, c]| dot(a, &cross(b, c))).sum::<Rational>() / 6
}

/// A tetrahedron over a triangle, with the origin as its apex.
struct Wedge {
    corners: [Point; 3],
    is_outward: bool,
    /// Planes through the apex: points within are not below any of them.
    sides: [Point; 3],
    /// The normal of the base away from the apex, and the height of the base along it.
    base: (Point, Rational),
    /// Approximate unit vectors of corners and sides.
    about: [[[f64; 3]; 3]; 2],
}

impl Wedge {
    /// The wedge over a triangle; `None` if it is flat.
    fn new(corners: [Point; 3]) -> Option<Wedge> {
        let [a, b, c] = &corners;
        let height = dot(a, &cross(b, c));
        let turn = |p: Point| if height.cmp0().is_lt() { p.map(|x| -x) } else { p };
        let sides = [cross(a, b), cross(b, c), cross(c, a)].map(turn);
        let unit = |p: &Point| {
            let p = [0, 1, 2].map(|i: usize| p[i].to_f64());
            let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
            p.map(|x| x / length)
        };
        let about = [&corners, &sides].map(|three| [0, 1, 2].map(|i: usize| unit(&three[i])));
        let is_outward = height.cmp0().is_gt();
        let base = (turn(area(&corners)), height.clone().abs());
        height.cmp0().is_ne().then_some(Wedge { corners, is_outward, sides, base, about })
    }

    /// True unless a side of this wedge clearly separates it from the other.
    fn may_reach(&self, other: &Wedge) -> bool {
        let beyond = |side: &[f64; 3], p: &[f64; 3]| (0..3).map(|i| side[i] * p[i]).sum::<f64>() < -1e-9;
        !self.about[1].iter().any(|side| other.about[0].iter().all(|p| beyond(side, p)))
    }

    /// The volume over the part of the base that is in the other wedge.
    fn under(&self, other: &Wedge) -> Rational {
        let mut polygon = self.corners.to_vec();
        for side in &other.sides {
            polygon = kept(&polygon, |p| dot(side, p));
        }
        polygon = kept(&polygon, |p| &other.base.1 - dot(&other.base.0, p));
        let fan = polygon.windows(2).skip(1);
        fan.map(|pair| dot(&polygon[0], &cross(&pair[0], &pair[1])).abs()).sum::<Rational>() / 6
    }

    fn common(&self, other: &Wedge) -> Rational {
        if !self.may_reach(other) || !other.may_reach(self) {
            return Rational::new();
        }
        let is_coplanar = other.corners.iter().all(|p| dot(&self.base.0, p) == self.base.1);
        let common = self.under(other) + if is_coplanar { Rational::new() } else { other.under(self) };
        if self.is_outward == other.is_outward { common } else { -common }
    }
}

/// The part of a polygon where the height is not negative.
fn kept(polygon: &[Point], height: impl Fn(&Point) -> Rational) -> Vec<Point> {
    let heights: Vec<Rational> = polygon.iter().map(height).collect();
    let mut kept = Vec::new();
    for at in 0..polygon.len() {
        let next = (at + 1) % polygon.len();
        if heights[at].cmp0().is_ge() {
            kept.push(polygon[at].clone());
        }
        if heights[at].cmp0() != heights[next].cmp0() && heights[at].cmp0() == heights[next].cmp0().reverse() {
            let fraction = &heights[at] / Rational::from(&heights[at] - &heights[next]);
            kept.push(
                [0, 1, 2]
                    .map(|i: usize| &polygon[at][i] + Rational::from(&polygon[next][i] - &polygon[at][i]) * &fraction),
            );
        }
    }
    kept
}

/// The volume of the intersection of both surfaces.
pub fn common(a: &[[Point; 3]], b: &[[Point; 3]], apex: &Point) -> Rational {
    let wedges = |surface: &[[Point; 3]]| -> Vec<Wedge> {
        surface.iter().filter_map(|corners| Wedge::new(corners.each_ref().map(|p| minus(p, apex)))).collect()
    };
    let [a, b] = [wedges(a), wedges(b)];
    a.iter().flat_map(|a| b.iter().map(|b| a.common(b))).sum()
}
