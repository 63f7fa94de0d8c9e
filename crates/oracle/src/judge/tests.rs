//! The judge against a second computation, and against what is known.

use super::*;
use predicament_corpus::homogeneous;
use predicament_predicates::{Construction, Dimension, Plane};
use proptest::prelude::*;
use rug::Integer;

/// A second computation that has nothing in common with the first:
/// homogeneous coordinates (a column of ones, no differences), all scaled
/// to integers, eliminated without fractions (Bareiss). Constructed
/// vertices come with a positive weight instead of the one, by joins and
/// meets of integer vectors.
fn second(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    let axes = match question {
        Question::Compare(axis) => vec![axis],
        Question::Orient2d(plane) => plane.axes().to_vec(),
        _ => [Axis::X, Axis::Y, Axis::Z][..scene.dimension().count()].to_vec(),
    };
    // 2^1074 makes every double an integer.
    let scale = Integer::from(1) << 1074;
    let mut matrix: Vec<Vec<Integer>> = args
        .iter()
        .map(|&v| {
            if v.is_constructed() {
                let row = homogeneous(scene, v).expect("a point");
                let entries = axes.iter().map(|axis| Integer::from(&row[axis.index()] * &scale));
                return entries.chain(row.last().cloned()).collect();
            }
            let exact = axes.iter().map(|&axis| rational(scene.coordinate(axis, v)));
            let mut row: Vec<Integer> = exact.map(|x| Integer::from(x.numer() * &scale) / x.denom()).collect();
            if matches!(question, Question::Incircle | Question::Insphere) {
                row.push(row.iter().map(|x| Integer::from(x.square_ref())).sum());
            }
            row.push(Integer::from(1));
            row
        })
        .collect();
    let n = matrix.len();
    let mut sign = 1;
    let mut before = Integer::from(1);
    for k in 0..n - 1 {
        let Some(pivot) = (k..n).find(|&row| matrix[row][k].cmp0().is_ne()) else { return Sign::Zero };
        if pivot != k {
            matrix.swap(pivot, k);
            sign = -sign;
        }
        for i in k + 1..n {
            for j in k + 1..n {
                let value = Integer::from(&matrix[i][j] * &matrix[k][k]) - Integer::from(&matrix[i][k] * &matrix[k][j]);
                matrix[i][j] = value.div_exact(&before);
            }
        }
        before = matrix[k][k].clone();
    }
    let det: Sign = matrix[n - 1][n - 1].cmp0().into();
    if sign < 0 { -det } else { det }
}

fn questions(dimension: Dimension) -> Vec<Question> {
    match dimension {
        Dimension::Two => {
            vec![Question::Compare(Axis::X), Question::Orient2d(Plane::Xy), Question::Incircle]
        }
        Dimension::Three => vec![
            Question::Compare(Axis::Z),
            Question::Orient2d(Plane::Yz),
            Question::Orient2d(Plane::Zx),
            Question::Orient3d,
            Question::Insphere,
        ],
    }
}

fn agree(scene: &Scene) -> Result<(), TestCaseError> {
    for question in questions(scene.dimension()) {
        let args: Vec<Vertex> = scene.vertices().take(question.kind().arity()).collect();
        let first = sign(scene, question, &args);
        prop_assert_eq!(first, second(scene, question, &args), "{:?} of {:?}", question, scene);
        let full = verdict(scene, question, &args);
        prop_assert_eq!(first, full.sign());
        prop_assert!(Rational::from(full.determinant.abs_ref()) <= full.permanent);
    }
    Ok(())
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

fn small() -> impl Strategy<Value = f64> {
    (-3i8..=3).prop_map(f64::from)
}

/// Constructions by these ids, those that are points.
fn construct(scene: &mut Scene, ids: &[usize]) {
    let v = |i: usize| Vertex::input(ids[i]);
    let candidates: Vec<Construction> = match scene.dimension() {
        Dimension::Two => {
            (0..10).map(|i| 4 * i).map(|i| Construction::Ssi([[v(i), v(i + 1)], [v(i + 2), v(i + 3)]])).collect()
        }
        Dimension::Three => {
            let triple = |i| [v(i), v(i + 1), v(i + 2)];
            let lpi = (0..4).map(|i| 5 * i).map(|i| Construction::Lpi { line: [v(i), v(i + 1)], plane: triple(i + 2) });
            let tpi = [20, 30].map(|i| Construction::Tpi([triple(i), triple(i + 3), triple(i + 6)]));
            lpi.chain(tpi).collect()
        }
    };
    for candidate in candidates {
        let mut trial = scene.clone();
        if let Ok(vertex) = trial.construct(candidate) {
            let found = point(&trial, vertex).is_some();
            assert_eq!(found, homogeneous(&trial, vertex).is_some(), "{candidate} {scene:?}");
            if found {
                *scene = trial;
            }
        }
    }
}

/// Lines and planes that are laid through a known point, in all directions of a small grid:
/// they meet there, and nowhere else, where the directions are independent.
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

proptest! {
    #[test]
    fn two_computations_agree_on_small_integers(points in prop::collection::vec(-3i8..=3, 15)) {
        let coordinates: Vec<f64> = points.iter().map(|&x| f64::from(x)).collect();
        agree(&Scene::new(Dimension::Three, coordinates.clone()).unwrap())?;
        agree(&Scene::new(Dimension::Two, coordinates[..8].to_vec()).unwrap())?;
    }

    #[test]
    fn two_computations_agree_on_constructed_vertices(
        coordinates in prop_oneof![prop::collection::vec(finite(), 36), prop::collection::vec(small(), 36)],
        ids in prop::collection::vec(0_usize..12, 40),
        places in prop::collection::vec(any::<prop::sample::Index>(), 4),
    ) {
        for dimension in [Dimension::Two, Dimension::Three] {
            let mut scene = Scene::new(dimension, coordinates[..12 * dimension.count()].to_vec()).unwrap();
            construct(&mut scene, &ids);
            let all: Vec<Vertex> =
                scene.vertices().chain((0..scene.constructions().len()).map(Vertex::constructed)).collect();
            let args: Vec<Vertex> = places.iter().map(|place| *place.get(&all)).collect();
            for question in questions(dimension) {
                if matches!(question, Question::Incircle | Question::Insphere) {
                    continue;
                }
                let args = &args[..question.kind().arity()];
                prop_assert_eq!(
                    sign(&scene, question, args), second(&scene, question, args), "{:?} {:?} {:?}", question, args, scene
                );
            }
        }
    }

    #[test]
    fn constructed_vertices_lie_on_what_defines_them(
        coordinates in prop::collection::vec(finite(), 36),
        ids in prop::collection::vec(0_usize..12, 40),
    ) {
        for dimension in [Dimension::Two, Dimension::Three] {
            let mut scene = Scene::new(dimension, coordinates[..12 * dimension.count()].to_vec()).unwrap();
            construct(&mut scene, &ids);
            for (index, construction) in scene.constructions().iter().enumerate() {
                for flat in construction.flats() {
                    let args = [flat, &[Vertex::constructed(index)]].concat();
                    let planes: &[Plane] =
                        if dimension == Dimension::Two { &[Plane::Xy] } else { &[Plane::Xy, Plane::Yz, Plane::Zx] };
                    if flat.len() == 3 {
                        prop_assert_eq!(sign(&scene, Question::Orient3d, &args), Sign::Zero);
                    } else {
                        for &plane in planes {
                            prop_assert_eq!(sign(&scene, Question::Orient2d(plane), &args), Sign::Zero);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn two_computations_agree_on_any_doubles(coordinates in prop::collection::vec(finite(), 15)) {
        agree(&Scene::new(Dimension::Three, coordinates.clone()).unwrap())?;
        agree(&Scene::new(Dimension::Two, coordinates[..8].to_vec()).unwrap())?;
    }
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
