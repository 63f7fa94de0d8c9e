//! Factors about input vertices alone.
//!
//! Most factors are turns and sides of input vertices. Their signs are those of points, and their ties have a list of
//! terms, which are signs of points again.

use predicament_exact::{orient2d, orient3d};
use predicament_predicates::{Axis, Question, Scene, Sign, Vertex};

use super::Value;
use crate::Scheme;
use crate::ties::{Sorted, columns};

/// The sign of a turn or side of input vertices and the degree of its deciding monomial; `None` if a vertex occurs
/// twice.
pub(super) fn decide<const N: usize>(scene: &Scene, question: Question, args: [Vertex; N]) -> Value {
    let Sorted { vertices, parity } = Sorted::new(args)?;
    let (axes, orientation) = columns(question);
    let sign = minor(scene, axes, &vertices);
    let (sign, degree) = if sign.is_zero() {
        let terms = Scheme::PerCoordinate.terms(question.kind());
        terms.iter().find_map(|term| {
            let rows: [Vertex; N] = std::array::from_fn(|at| vertices[usize::from(*term.rows.get(at).unwrap_or(&0))]);
            let axes: [Axis; 3] = std::array::from_fn(|at| axes[usize::from(*term.columns.get(at).unwrap_or(&0))]);
            let sign = minor(scene, &axes[..term.columns.len()], &rows[..term.rows.len()]);
            (!sign.is_zero()).then_some((sign * term.sign, N - term.rows.len()))
        })?
    } else {
        (sign, 0)
    };
    Some((sign * orientation * parity, degree))
}

/// The sign of the determinant of some coordinates and ones.
pub(in crate::constructed) fn minor(scene: &Scene, axes: &[Axis], vertices: &[Vertex]) -> Sign {
    let at = |axis: Axis, v: Vertex| scene.coordinate(axis, v);
    match (axes, vertices) {
        ([], [_]) => Sign::Positive,
        (&[x], &[a, b]) => Sign::from(at(x, a).partial_cmp(&at(x, b)).expect("scenes are finite")),
        (&[x, y], &[a, b, c]) => {
            let [a, b, c] = [a, b, c].map(|v| [at(x, v), at(y, v)]);
            orient2d(a, b, c)
        }
        (&[x, y, z], &[a, b, c, d]) => {
            let [a, b, c, d] = [a, b, c, d].map(|v| [at(x, v), at(y, v), at(z, v)]);
            orient3d(a, b, c, d)
        }
        _ => unreachable!("a minor has one row more than it has columns"),
    }
}

#[cfg(test)]
mod tests {
    use predicament_exact::Exact;
    use predicament_predicates::{Backend, Off, Plane};

    use super::*;
    use crate::constructed::testing::{Random, search_all};

    #[test]
    fn factors_of_input_vertices_are_those_of_the_search() {
        let (mut random, mut degrees) = (Random(3), [0; 4]);
        for _ in 0..400 {
            let points: Vec<[f64; 3]> =
                (0..5).map(|_| std::array::from_fn(|_| [0.0, -0.0, 0.5][random.below(3)])).collect();
            let scene = Scene::from_points3(&points).unwrap();
            let session = Exact.prepare(&scene, Off).unwrap();
            let plane = [Plane::Xy, Plane::Yz, Plane::Zx][random.below(3)];
            let (turn, side): ([Vertex; 3], [Vertex; 4]) = (random.different(5), random.different(5));
            for (question, args, found) in [
                (Question::Orient2d(plane), &turn[..], decide(&scene, Question::Orient2d(plane), turn)),
                (Question::Orient3d, &side[..], decide(&scene, Question::Orient3d, side)),
            ] {
                let unmoved = question.ask(&session, args);
                let expected = if unmoved.is_zero() { search_all(&scene, question, args) } else { Some((unmoved, 0)) };
                assert_eq!(found, expected, "{question:?} of {args:?} in {scene:?}");
                degrees[found.map_or(0, |(_, degree)| degree)] += 1;
            }
        }
        assert!(degrees[..3].iter().all(|count| *count > 10), "{degrees:?}");
        assert_eq!(decide(&Scene::from_points2(&[]).unwrap(), Question::Orient3d, [Vertex::input(0); 4]), None);
    }
}
