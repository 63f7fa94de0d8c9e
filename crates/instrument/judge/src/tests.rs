//! Tests of the judge against known results. (The tests of the oracle check it against another computation.)

use crate::determinant::log2;
use crate::*;
use predicament_predicates::{Construction, Plane, Predicates, Question, Scene, Sign, Vertex};

/// Lines and planes through a known point, in all directions of a small grid: they meet there, and nowhere else, if the
/// directions are independent.
#[test]
fn constructed_vertices_are_where_they_are_known_to_be() {
    const KNOWN: [f64; 3] = [5.0, -3.0, 0.5];
    let to = |j: f64, u: [f64; 3], k: f64, v: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|i| KNOWN[i] + j * u[i] + k * v[i])
    };
    let triple = |first: usize| [first, first + 1, first + 2].map(Vertex::input);
    let pair = |first: usize| [first, first + 1].map(Vertex::input);
    let minor = |u: [f64; 3], v: [f64; 3], i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
    let directions: Vec<[f64; 3]> =
        (0..27).map(|i: i32| [i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1].map(f64::from)).collect();
    let mut found = 0;
    for (&u, &v) in directions.iter().flat_map(|u| directions.iter().map(move |v| (u, v))) {
        let flat = [to(-1.0, u, 0.0, u), to(2.0, u, 0.0, u), to(1.0, v, 0.0, v), to(3.0, v, 0.0, v)];
        let mut plane = Scene::from_points2(&flat.map(|[x, y, _]| [x, y])).unwrap();
        let ssi = plane.construct(Construction::Ssi([pair(0), pair(2)])).unwrap();
        let expected = (minor(u, v, 0, 1) != 0.0).then(|| KNOWN[..2].iter().map(|&x| rational(x)).collect());
        assert_eq!(point(&plane, ssi), expected, "{plane:?}");
        for &w in directions.iter().step_by(5) {
            let mut space = Scene::from_points3(&[
                to(-1.0, u, 0.0, u),
                to(2.0, u, 0.0, u),
                to(1.0, v, 0.0, w),
                to(1.0, v, 1.0, w),
                to(-2.0, v, 1.0, w),
                to(3.0, u, -1.0, v),
                to(0.0, u, 2.0, v),
                to(1.0, u, 2.0, v),
                to(1.0, u, -1.0, w),
                to(2.0, u, 2.0, w),
                to(3.0, u, 1.0, w),
            ])
            .unwrap();
            let independent = u[0] * minor(v, w, 1, 2) + u[1] * minor(v, w, 2, 0) + u[2] * minor(v, w, 0, 1) != 0.0;
            let expected = independent.then(|| KNOWN.map(rational).to_vec());
            let lpi = Construction::Lpi { line: pair(0), plane: triple(2) };
            for construction in [lpi, Construction::Tpi([triple(2), triple(5), triple(8)])] {
                let vertex = space.construct(construction).unwrap();
                assert_eq!(point(&space, vertex), expected, "{construction} {space:?}");
            }
            found += usize::from(independent);
        }
    }
    assert!((1000..27 * 27 * 6).contains(&found), "{found} points");
}

/// Constructions on several levels: a vertex lies on the lines through constructed vertices that define it, and a
/// definition that gives no point is refused.
#[test]
fn cascades_lie_on_what_defines_them() {
    let mut scene =
        Scene::from_points2(&[[0.0, 0.0], [7.0, 1.0], [1.0, 5.0], [6.0, 4.0], [3.0, -2.0], [-1.0, 2.0]]).unwrap();
    let (v, c) = (Vertex::input, Vertex::constructed);
    for lines in [
        [[v(0), v(3)], [v(1), v(2)]],
        [[v(0), v(1)], [v(4), v(2)]],
        [[c(0), c(1)], [v(5), v(4)]],
        [[c(2), v(0)], [c(1), v(3)]],
        [[c(3), c(0)], [c(2), v(1)]],
    ] {
        let x = scene.construct(Construction::Ssi(lines)).unwrap();
        let found = point(&scene, x).expect("general position");
        assert!(found.iter().any(|x| *x.denom() != 1), "{found:?}");
        for [p, q] in lines {
            assert_eq!(sign(&scene, Question::Orient2d(Plane::Xy), &[p, x, q]), Sign::Zero);
            assert_ne!(point(&scene, p), point(&scene, q));
        }
    }
    let parallel = scene.construct(Construction::Ssi([[v(0), c(1)], [v(1), v(0)]])).unwrap();
    let beyond = scene.construct(Construction::Ssi([[parallel, v(2)], [v(3), v(4)]])).unwrap();
    assert_eq!([point(&scene, parallel), point(&scene, beyond)], [None, None]);

    let mut session = Judged::exact(&scene);
    let definitions = [[[c(0), c(4)], [v(5), v(1)]], [[v(0), v(1)], [c(1), v(1)]]].map(Construction::Ssi);
    assert_eq!(session.construct(&definitions).unwrap_err().index(), Some(1));
    assert_eq!(session.scene(), &scene);
    let x = session.construct(&definitions[..1]).unwrap()[0];
    assert_eq!(session.orient2d(Plane::Xy, v(5), x, v(1)), Sign::Zero);
}

#[test]
fn the_convention_is_the_one_stated() {
    let v = Vertex::input;
    let plane = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.5]]).unwrap();
    let ask = |question, args: &[usize]| sign(&plane, question, &args.iter().map(|&i| v(i)).collect::<Vec<_>>());
    assert_eq!(ask(Question::Orient2d(Plane::Xy), &[0, 1, 2]), Sign::Positive);
    assert_eq!(ask(Question::Incircle, &[0, 1, 2, 3]), Sign::Positive);
    let space =
        Scene::from_points3(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [0.1, 0.1, -0.1]])
            .unwrap();
    let all: Vec<Vertex> = space.vertices().collect();
    assert_eq!(sign(&space, Question::Orient3d, &all[..4]), Sign::Positive, "d is below");
    assert_eq!(sign(&space, Question::Insphere, &all), Sign::Positive, "e is inside");
}

#[test]
fn degeneracy_is_measured_far_outside_the_range_of_doubles() {
    let tiny = f64::from_bits(1);
    let scene = Scene::from_points2(&[[tiny, 0.0], [0.0, tiny], [0.0, 0.0]]).unwrap();
    let args: Vec<Vertex> = scene.vertices().collect();
    let found = verdict(&scene, Question::Orient2d(Plane::Xy), &args);
    assert_eq!(log2(&found.determinant), -2148.0);
    assert_eq!(log2_relative(&found), Some(0.0));
    let origin = Scene::from_points2(&[[0.0, 0.0]; 3]).unwrap();
    let found = verdict(&origin, Question::Orient2d(Plane::Xy), &args);
    assert_eq!(log2_relative(&found), None, "neither determinant nor permanent");
}
