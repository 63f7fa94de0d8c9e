//! The counterexamples of `docs/LAWS.md`, asked one by one and multiplied out by hand, so that
//! what is said about other people's crates does not rest on our laws alone.
#![cfg(feature = "peers")]

use predicament_controls::wild::{Axiolid, Delaunay, Geogram, Library, Rgeometry, Simplicity, Wild};
use predicament_predicates::{Backend, Dimension, Off, Plane, Predicates, Question, Scene, Sign, Vertex};
use rug::Rational;

/// Ten vertices in the plane, at the origin where nothing else is said.
fn scene(points: &[(usize, [f64; 2])]) -> Scene {
    let mut coordinates = [[0.0; 2]; 10];
    for &(at, point) in points {
        coordinates[at] = point;
    }
    Scene::new(Dimension::Two, coordinates.as_flattened().to_vec()).unwrap()
}

/// The sign of orient2d for three vertices and incircle for four.
fn ask<L: Library>(library: L, scene: &Scene, vertices: &[usize]) -> Sign {
    let question = if vertices.len() == 3 { Question::Orient2d(Plane::Xy) } else { Question::Incircle };
    let args: Vec<Vertex> = vertices.iter().map(|&v| Vertex::input(v)).collect();
    let backend = Wild(library);
    let session = backend.prepare(scene, Off).unwrap();
    assert!(session.supports(question.kind()).is_ok());
    question.ask(&session, &args)
}

/// The determinant of the rows (x, y, 1) or (x, y, x² + y², 1).
fn determinant(scene: &Scene, vertices: &[usize]) -> Rational {
    let point = |v: usize| -> Vec<Rational> {
        scene.point(Vertex::input(v)).iter().map(|&x| Rational::from_f64(x).unwrap()).collect()
    };
    let last = point(*vertices.last().unwrap());
    let row = |v: &usize| -> [Rational; 3] {
        let [x, y] = point(*v).try_into().unwrap();
        let [x, y] = [x - &last[0], y - &last[1]];
        let lift = Rational::from(x.square_ref()) + Rational::from(y.square_ref());
        [x, y, lift]
    };
    let rows: Vec<[Rational; 3]> = vertices[..vertices.len() - 1].iter().map(row).collect();
    let minor = |i: usize, j: usize| -> Rational {
        Rational::from(&rows[i][0] * &rows[j][1]) - Rational::from(&rows[j][0] * &rows[i][1])
    };
    match rows.len() {
        2 => minor(0, 1),
        // Along the column of lifts, which is the third of three.
        _ => minor(1, 2) * &rows[0][2] - minor(0, 2) * &rows[1][2] + minor(0, 1) * &rows[2][2],
    }
}

/// Three products that add up to zero for any points.
type Relation = [[&'static [usize]; 2]; 3];

/// Four turns at vertex 8.
const TURNS: Relation = [[&[8, 0, 1], &[8, 2, 9]], [&[8, 2, 0], &[8, 1, 9]], [&[8, 0, 9], &[8, 1, 2]]];

/// Turns and circles at 1 and 7.
const CIRCLES: Relation = [[&[1, 7, 3], &[1, 7, 5, 9]], [&[1, 5, 7], &[1, 7, 3, 9]], [&[1, 7, 9], &[1, 7, 3, 5]]];

#[test]
fn the_relations_hold_for_points_that_are_somewhere() {
    for seed in 1..50_usize {
        let coordinate = |i: usize| f64::from(u32::try_from((seed * 7919 + i * i * 104_729) % 97).unwrap());
        let points: Vec<(usize, [f64; 2])> = (0..10).map(|v| (v, [coordinate(2 * v), coordinate(2 * v + 1)])).collect();
        let scene = scene(&points);
        for relation in [TURNS, CIRCLES] {
            let products = relation.map(|[f, g]| determinant(&scene, f) * determinant(&scene, g));
            assert!(products.iter().any(|product| !product.is_zero()));
            assert_eq!(products.into_iter().sum::<Rational>(), 0);
        }
    }
}

#[test]
fn simplicity_circles_contradict_turns() {
    let scene = scene(&[(1, [-1., 0.]), (3, [0., -1.]), (5, [0., 1.]), (7, [1., 0.]), (9, [1., 0.])]);
    let products = CIRCLES.map(|[f, g]| ask(Simplicity, &scene, f) * ask(Simplicity, &scene, g));
    assert_eq!(products, [Sign::Positive; 3]);
}

#[test]
fn rgeometry_turns_contradict_each_other() {
    let scene = scene(&[(0, [-1., -1.]), (8, [-1., -1.]), (1, [0., -1.]), (2, [1., 1.])]);
    let products = TURNS.map(|[f, g]| ask(Rgeometry, &scene, f) * ask(Rgeometry, &scene, g));
    assert_eq!(products, [Sign::Negative; 3]);
}

#[test]
fn delaunay_takes_places_for_vertices() {
    let line = scene(&[(0, [-1., -1.]), (1, [-1., 0.]), (2, [-1., 1.])]);
    let turns = |sorted| [[0, 1, 2], [0, 2, 1]].map(|turn| ask(Delaunay { sorted }, &line, &turn));
    assert_eq!(turns(false), [Sign::Negative; 2]);
    let [turn, swapped] = turns(true);
    assert_eq!(turn, -swapped);
    // Its callers sort the simplex, and have the query last.
    let square = scene(&[(0, [-1., -1.]), (1, [-1., 0.]), (3, [0., -1.]), (4, [0., 0.])]);
    let circles = [[0, 1, 3, 4], [0, 1, 4, 3]].map(|circle| ask(Delaunay { sorted: true }, &square, &circle));
    assert_eq!(circles, [Sign::Positive; 2]);
}

#[test]
fn geogram_circles_are_wrong_for_mixed_exponents() {
    let small = -(2f64.powi(-14));
    let large = 2f64.powi(27);
    let scene = scene(&[(0, [small, 0.]), (2, [0., small]), (5, [0., large]), (8, [large, small])]);
    assert!(determinant(&scene, &[5, 0, 2, 8]) < 0);
    assert_eq!(ask(Geogram, &scene, &[5, 0, 2, 8]), Sign::Positive);
}

#[test]
fn axiolid_turns_of_decimals_are_wrong() {
    use Sign::{Negative, Positive, Zero};
    let cases = [
        ([[0.3, 0.4], [0.8, 0.9], [1.8, 1.9]], Zero, Negative),
        ([[-0.29, -0.187], [-0.079, 0.109], [-1.134, -1.371]], Negative, Zero),
        ([[0.248, 0.052], [1.186, 1.928], [0.114, -0.216]], Negative, Positive),
    ];
    for (points, said, exact) in cases {
        let [a, b, c] = points;
        let scene = scene(&[(0, a), (1, b), (2, c)]);
        assert_eq!(Sign::from(determinant(&scene, &[0, 1, 2]).cmp0()), exact);
        assert_eq!(ask(Axiolid, &scene, &[0, 1, 2]), said);
    }
}
