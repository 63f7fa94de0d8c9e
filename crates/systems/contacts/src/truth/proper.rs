//! Pairs of simplices that meet however little both are moved.
//!
//! Two convex sets S and T meet if and only if the origin is in S − T, the set of all differences. They still meet
//! after every small movement if and only if it is in the interior of S − T. Otherwise, a movement in the direction
//! away from S − T parts them: the sets only touch.
//!
//! S − T is a polytope. If it is not flat, the origin is in its interior if and only if it is on the inner side of each
//! facet. The plane of a facet is parallel to two edges of S or T (in the plane: to one edge). So the directions across
//! all pairs of edges are enough.

use predicament_judge::rational;
use predicament_predicates::{Scene, Vertex};
use rug::Rational;

type Vector = Vec<Rational>;

/// True if two simplices meet, and still do however little they are moved.
pub(crate) fn is_proper(scene: &Scene, s: &[Vertex], t: &[Vertex]) -> bool {
    let place = |v: &Vertex| -> Vector { scene.point(*v).iter().map(|&x| rational(x)).collect() };
    let [s, t] = [s, t].map(|simplex| simplex.iter().map(place).collect::<Vec<Vector>>());
    let edges: Vec<Vector> = [&s, &t].into_iter().flat_map(|corners| edges(corners)).collect();
    let mut is_flat = true;
    for normal in normals(&edges, scene.dimension().count()) {
        is_flat &= edges.iter().all(|edge| dot(&normal, edge).is_zero());
        let [[low, high], [other_low, other_high]] = [&s, &t].map(|corners| range(&normal, corners));
        if high <= other_low || other_high <= low {
            return false;
        }
    }
    !is_flat
}

fn edges(corners: &[Vector]) -> Vec<Vector> {
    let pairs = corners.iter().enumerate().flat_map(|(at, p)| corners[..at].iter().map(move |q| [p, q]));
    pairs.map(|[p, q]| p.iter().zip(q).map(|(p, q)| Rational::from(p - q)).collect()).collect()
}

/// The directions across an edge in the plane, or across two edges in space, without zeros.
fn normals(edges: &[Vector], dimension: usize) -> impl Iterator<Item = Vector> {
    let across = |u: &Vector, v: &Vector| -> Vector {
        let minor = |i: usize, j: usize| Rational::from(&u[i] * &v[j]) - Rational::from(&u[j] * &v[i]);
        vec![minor(1, 2), minor(2, 0), minor(0, 1)]
    };
    let all = edges.iter().enumerate().flat_map(move |(at, u)| match dimension {
        2 => vec![vec![-u[1].clone(), u[0].clone()]],
        _ => edges[..at].iter().map(|v| across(u, v)).collect(),
    });
    all.filter(|normal| normal.iter().any(|x| !x.is_zero()))
}

fn dot(u: &[Rational], v: &[Rational]) -> Rational {
    u.iter().zip(v).map(|(u, v)| Rational::from(u * v)).sum()
}

/// The least and the largest coordinate of corners along a direction.
fn range(normal: &[Rational], corners: &[Vector]) -> [Rational; 2] {
    let along = |corner: &Vector| dot(normal, corner);
    let [mut low, mut high] = [along(&corners[0]), along(&corners[0])];
    for x in corners[1..].iter().map(along) {
        if x < low {
            low = x;
        } else if x > high {
            high = x;
        }
    }
    [low, high]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn proper2(points: &[[f64; 2]], first: usize) -> bool {
        let scene = Scene::from_points2(points).unwrap();
        let all: Vec<Vertex> = scene.vertices().collect();
        is_proper(&scene, &all[..first], &all[first..])
    }

    fn proper3(points: &[[f64; 3]], first: usize) -> bool {
        let scene = Scene::from_points3(points).unwrap();
        let all: Vec<Vertex> = scene.vertices().collect();
        is_proper(&scene, &all[..first], &all[first..])
    }

    #[test]
    fn simplices_of_the_plane_cross_or_touch() {
        let cross = [[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0]];
        assert!(proper2(&cross, 2));
        assert!(!proper2(&[[0.0, 0.0], [2.0, 2.0], [1.0, 1.0], [2.0, 0.0]], 2), "an end on an edge");
        assert!(!proper2(&[[0.0, 0.0], [2.0, 2.0], [1.0, 1.0], [3.0, 3.0]], 2), "a common part");
        assert!(!proper2(&[[0.0, 0.0], [2.0, 2.0], [3.0, 0.0], [4.0, 0.0]], 2), "apart");
        let corner = [0.25, 0.25];
        assert!(proper2(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], corner], 3), "a point in a triangle");
        assert!(!proper2(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.5]], 3), "a point on its side");
    }

    #[test]
    fn triangles_in_space_cross_or_touch() {
        let flat = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        let with = |other: [[f64; 3]; 3]| proper3(&[flat, other].concat(), 3);
        assert!(with([[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [5.0, 5.0, 0.5]]));
        assert!(with([[1.0, 1.0, 0.0], [1.0, 2.0, 1.0], [2.0, 1.0, -1.0]]), "a corner in it, on both sides");
        assert!(!with([[1.0, 1.0, 0.0], [1.0, 2.0, 1.0], [2.0, 1.0, 1.0]]), "a corner in it, on one side");
        assert!(!with([[1.0, 1.0, 0.0], [5.0, 1.0, 0.0], [1.0, 5.0, 0.0]]), "in one plane");
        assert!(!with([[1.0, 1.0, 1.0], [5.0, 1.0, 1.0], [1.0, 5.0, 2.0]]), "apart");
    }
}
