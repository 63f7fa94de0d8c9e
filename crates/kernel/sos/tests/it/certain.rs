//! Ties about constructed vertices whose coefficients look like zero and are not, or are zero for reasons that the
//! definitions do not show.

use crate::common::{ask_antisymmetric, ids};
use predicament_predicates::{Axis, Backend, Construction, Off, Plane, Question, Scene, Sign, Vertex};
use predicament_sos::{Scheme, Sos, infinitesimal::judge};

/// Two lines through the origin, with directions whose determinant is (2^61 − 1) · (2^31 − 1).
///
/// Each coefficient that has the weight for a factor is zero modulo the prime of the guess, at any place.
#[test]
fn a_weight_that_the_prime_divides_is_not_zero() {
    let (large, prime) = (2_f64.powi(61), 2_f64.powi(31) - 1.0);
    let points = [[0.0, 0.0], [0.0, 0.0], [large, prime], [0.0, 0.0], [1.0, prime], [3.0, 5.0]];
    let mut scene = Scene::from_points2(&points).unwrap();
    let crossing = scene.construct(Construction::Ssi([ids([1, 2]), ids([3, 4])])).unwrap();
    let sos = Sos::default();
    let session = sos.prepare(&scene, Off).unwrap();
    let [first, last] = ids([0, 5]);
    for axis in [Axis::X, Axis::Y] {
        let question = Question::Compare(axis);
        // The smallest index moves furthest.
        assert_eq!(ask_antisymmetric(&session, question, &[first, crossing]), Sign::Positive, "{axis:?}");
        assert_eq!(judge(Scheme::PerCoordinate, &scene, question, &[first, crossing]), Sign::Positive);
    }
    let (question, args) = (Question::Orient2d(Plane::Xy), [first, crossing, last]);
    let expected = judge(Scheme::PerCoordinate, &scene, question, &args);
    assert_eq!(ask_antisymmetric(&session, question, &args), expected);
}

/// Edges of one mesh through a flat face of another that is made of triangles without a common vertex.
///
/// Four points are in one plane, as long as only the edges move.
#[test]
fn edges_through_a_flat_face() {
    for shared in [false, true] {
        let mut points = Vec::new();
        // A strip of edges, or separate edges.
        let edges: Vec<[usize; 2]> = (0..4).map(|i| if shared { [i, i + 1] } else { [2 * i, 2 * i + 1] }).collect();
        let ends = if shared { 5 } else { 8 };
        points.extend(
            (0..ends).map(|i: u32| {
                [f64::from(i * i % 7), f64::from(3 * i % 5), if i.is_multiple_of(2) { -1.0 } else { 2.0 }]
            }),
        );
        for triangle in 0..4 {
            let x = 8.0 * f64::from(triangle);
            points.extend([[x, 0.0, 0.0], [x + 4.0, 1.0, 0.0], [x, 7.0, 0.0]]);
        }
        let mut scene = Scene::from_points3(&points).unwrap();
        let pierce = |(number, edge): (usize, &[usize; 2])| {
            let plane = [0, 1, 2].map(|corner| Vertex::input(ends as usize + 3 * number + corner));
            scene.construct(Construction::Lpi { line: ids(*edge), plane }).unwrap()
        };
        let args: Vec<Vertex> = edges.iter().enumerate().map(pierce).collect();
        let sos = Sos::default();
        let session = sos.prepare(&scene, Off).unwrap();
        let question = Question::Orient3d;
        let expected = judge(Scheme::PerCoordinate, &scene, question, &args);
        assert!(!expected.is_zero());
        assert_eq!(ask_antisymmetric(&session, question, &args), expected, "shared: {shared}");
    }
}

/// On an unnamed line: each plane meets the line of the other's vertices there.
#[test]
fn three_points_on_the_line_of_two_planes() {
    let points = [[0.0, 0.0, 0.0], [7.0, 1.0, 2.0], [1.0, 5.0, 3.0], [2.0, 2.0, 9.0], [4.0, 3.0, 1.0]];
    let mut scene = Scene::from_points3(&points).unwrap();
    let lpi = |line, plane| Construction::Lpi { line: ids(line), plane: ids(plane) };
    let p = scene.construct(lpi([0, 3], [1, 2, 4])).unwrap();
    let q = scene.construct(lpi([1, 4], [0, 2, 3])).unwrap();
    let sos = Sos::default();
    let session = sos.prepare(&scene, Off).unwrap();
    let [two, one] = ids([2, 1]);
    for plane in [Plane::Xy, Plane::Yz, Plane::Zx] {
        assert_eq!(ask_antisymmetric(&session, Question::Orient2d(plane), &[p, two, q]), Sign::Zero);
    }
    assert_eq!(ask_antisymmetric(&session, Question::Orient3d, &[p, one, q, two]), Sign::Zero);
}
