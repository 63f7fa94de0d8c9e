//! The winding number of a closed surface around an inner point.
//!
//! The point is the mean of four vertices that are not coplanar. If a surface is convex at every edge, the point is
//! strictly below every face. Seen from there, each face covers a cone of directions. The direction to the middle of
//! the first face must not be in the cone of another face: then the surface covers each direction once.

use predicament_predicates::{Scene, Vertex};
use rug::Rational;

use super::tally::Tally;

type Vector = [Rational; 3];

fn exact(scene: &Scene, v: Vertex) -> Vector {
    scene.point3(v).map(|x| Rational::from_f64(x).expect("scenes are finite"))
}

fn minus(u: &Vector, v: &Vector) -> Vector {
    [0, 1, 2].map(|axis: usize| Rational::from(&u[axis] - &v[axis]))
}

/// The sign of det(u, v, w).
fn side([u, v, w]: [&Vector; 3]) -> std::cmp::Ordering {
    let minor = |i: usize, j: usize| Rational::from(&u[i] * &v[j]) - Rational::from(&u[j] * &v[i]);
    let sum = minor(1, 2) * &w[0] + minor(2, 0) * &w[1] + minor(0, 1) * &w[2];
    sum.cmp0()
}

fn mean(points: &[Vector]) -> Vector {
    let sum = |axis: usize| points.iter().map(|point| &point[axis]).sum::<Rational>();
    [0, 1, 2].map(|axis: usize| sum(axis) / u32::try_from(points.len()).expect("a few"))
}

/// Checks `wound once`: the surface of these faces goes once around the mean of four vertices that are not coplanar,
/// which is below all faces.
pub(super) fn wound_once(tally: &mut Tally<'_>, inner: [Vertex; 4], faces: &[&[Vertex]]) {
    let scene = tally.scene();
    let at = |v: &Vertex| exact(scene, *v);
    let centre = mean(&inner.each_ref().map(at));
    let from_centre = |v: &Vertex| minus(&at(v), &centre);
    let Some(first) = faces.first() else { return };
    // A point inside the first triangle of the first face.
    let direction = mean(&first[..3].iter().map(from_centre).collect::<Vec<_>>());
    for (number, face) in faces.iter().enumerate() {
        let corners: Vec<Vector> = face.iter().map(from_centre).collect();
        for (k, pair) in corners[1..].windows(2).enumerate() {
            let [a, b, c] = [&corners[0], &pair[0], &pair[1]];
            if side([a, b, c]).is_le() {
                let triangle = [face[0], face[k + 1], face[k + 2]];
                tally.flaw("wound once", &triangle, || format!("the mean of {inner:?} is not below face {number}"));
            }
            let is_here = [[a, b], [b, c], [c, a]].into_iter().all(|[u, v]| side([u, v, &direction]).is_ge());
            if is_here && (number, k) != (0, 0) {
                tally.flaw("wound once", face, || format!("face {number} is in front of or behind face 0"));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use predicament_judge::Judged;

    use super::super::tally::Signs;
    use super::*;

    #[test]
    fn what_covers_a_direction_twice_or_is_seen_from_behind_is_named() {
        let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0], [2.0, 2.0, 3.0]];
        let scene = Scene::from_points3(&corners).unwrap();
        let exact = Judged::exact(&scene);
        let found = |faces: &[&[usize]]| {
            let ids = |list: &&[usize]| list.iter().map(|&at| Vertex::input(at)).collect::<Vec<_>>();
            let faces: Vec<Vec<Vertex>> = faces.iter().map(ids).collect();
            let mut tally = Tally::new(Signs { exact: &exact, perturbed: None, ties: 9, pairs: 9 });
            let inner = [0, 1, 2, 4].map(Vertex::input);
            wound_once(&mut tally, inner, &faces.iter().map(Vec::as_slice).collect::<Vec<_>>());
            let flaw = |flaw: super::super::Flaw| {
                (flaw.places, flaw.vertices.iter().map(|v| v.index()).collect::<Vec<_>>(), flaw.what)
            };
            tally.finish().into_iter().map(flaw).collect::<Vec<_>>()
        };
        // A pyramid over a square.
        let right: [&[usize]; 5] = [&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]];
        assert_eq!(found(&right), []);
        assert_eq!(found(&[]), []);
        // The bottom as seen from behind: both of its triangles.
        let below = "the mean of [Vertex(0), Vertex(1), Vertex(2), Vertex(4)] is not below face 0".to_owned();
        let [bottom, sides @ ..] = right;
        let mirrored = [&[&[0, 1, 2, 3][..]][..], &sides[..]].concat();
        assert_eq!(found(&mirrored), [(2, vec![0, 1, 2], below)]);
        let again = "face 5 is in front of or behind face 0".to_owned();
        assert_eq!(found(&[&right[..], &[bottom]].concat()), [(1, vec![0, 3, 2, 1], again)]);
    }
}
