//! An independent method of point location: winding numbers over rationals, every edge for every query, a ray to the
//! *right*. It shares nothing with the crate.

use predicament_mesh::PolygonMap;
use predicament_predicates::{Scene, Vertex};
use rug::Rational;

/// The brute-force answer for one region.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Truth {
    /// An odd winding number.
    Inside,
    /// An even one.
    Outside,
    /// On an edge.
    Boundary,
}

/// A point in the plane.
pub type Point = [Rational; 2];

/// The coordinates of a vertex.
pub fn point(scene: &Scene, v: Vertex) -> Point {
    let p = scene.point(v);
    [0, 1].map(|axis| Rational::from_f64(p[axis]).expect("finite"))
}

/// The value (v − u) × (p − u).
fn turn(u: &Point, v: &Point, p: &Point) -> Rational {
    let [ux, uy] = u;
    let run = Rational::from(&v[0] - ux) * Rational::from(&p[1] - uy);
    run - Rational::from(&v[1] - uy) * Rational::from(&p[0] - ux)
}

fn is_between(a: &Rational, b: &Rational, x: &Rational) -> bool {
    (a <= x && x <= b) || (b <= x && x <= a)
}

/// The location of `q`, for every region.
pub fn brute_force(map: &PolygonMap, scene: &Scene, q: Vertex) -> Vec<Truth> {
    winding_numbers(map, &|v| point(scene, v), &point(scene, q))
}

/// The location of `q`, for every region, with vertex positions given by a function.
pub fn winding_numbers(map: &PolygonMap, at: &dyn Fn(Vertex) -> Point, q: &Point) -> Vec<Truth> {
    let region = |region: &predicament_mesh::Region| {
        let mut winding = 0_i32;
        let edges: Vec<[Vertex; 2]> = region.rings.iter().flat_map(|ring| ring.edges()).collect();
        for &[u, v] in &edges {
            // to and fro along one edge bounds nothing
            let uses = edges.iter().filter(|edge| **edge == [u, v] || **edge == [v, u]).count();
            let (u, v) = (at(u), at(v));
            let turn = turn(&u, &v, q);
            if uses % 2 == 1 && turn.cmp0().is_eq() && (0..2).all(|axis| is_between(&u[axis], &v[axis], &q[axis])) {
                return Truth::Boundary;
            }
            if u[1] <= q[1] && v[1] > q[1] && turn.cmp0().is_gt() {
                winding += 1;
            } else if v[1] <= q[1] && u[1] > q[1] && turn.cmp0().is_lt() {
                winding -= 1;
            }
        }
        if winding % 2 == 0 { Truth::Outside } else { Truth::Inside }
    };
    map.regions().iter().map(region).collect()
}

/// The regions with this truth, ascending.
pub fn with(truths: &[Truth], wanted: Truth) -> Vec<u32> {
    (0..).zip(truths).filter(|(_, truth)| **truth == wanted).map(|(at, _)| at).collect()
}
