//! A test of the judge by a computation that is independent of its own two.
//!
//! [`judge::sign`] and [`judge::verdict`] both take differences to the last vertex and expand. The third computation
//! takes homogeneous coordinates (a column of ones, lifts of coordinates and not of differences) and eliminates without
//! fractions (Bareiss).

use predicament_corpus::homogeneous;
use predicament_judge as judge;
use predicament_predicates::{Axis, Construction, Derived, Dimension, Plane, Question, Scene, Sign, Vertex};
use predicament_tasks::signs::{SignQueries, Signs};
use proptest::prelude::*;
use rug::{Integer, Rational};

use crate::common::{definitions, loaded};

/// The maximum number of queries per scene.
fn most() -> usize {
    predicament_effort::some_or_all(60, 3000)
}

/// The sign of the homogeneous determinant. Constructed vertices have a positive weight instead of the one, by joins
/// and meets of integer vectors.
fn third(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    if let Question::Derived(derived) = question {
        return expanded(scene, derived, args);
    }
    let axes = match question {
        Question::Compare(axis) => vec![axis],
        Question::Orient2d(plane) => plane.axes().to_vec(),
        _ => [Axis::X, Axis::Y, Axis::Z][..scene.dimension().count()].to_vec(),
    };
    let exact = |v: Vertex| -> Vec<Rational> {
        if v.is_constructed() {
            let mut point = homogeneous(scene, v).expect("a point");
            let weight = point.pop().expect("a weight");
            let mut row: Vec<Rational> = axes.iter().map(|axis| Rational::from(&point[axis.index()])).collect();
            row.push(weight.into());
            return row;
        }
        let mut row: Vec<Rational> = axes.iter().map(|&axis| judge::rational(scene.coordinate(axis, v))).collect();
        if matches!(question, Question::Incircle | Question::Insphere) {
            row.push(row.iter().map(|x| Rational::from(x.square_ref())).sum());
        }
        row.push(Rational::from(1));
        row
    };
    let rows: Vec<Vec<Rational>> = args.iter().map(|&v| exact(v)).collect();
    // Denominators are powers of two: multiplying by the largest makes all entries integers, with one factor for all
    // columns.
    let scale = rows.iter().flatten().map(Rational::denom).max().expect("coordinates").clone();
    let whole = |row: &Vec<Rational>| row.iter().map(|x| Integer::from(x.numer() * &scale) / x.denom()).collect();
    bareiss(rows.iter().map(whole).collect())
}

/// The sign of a formula's expanded polynomial, monomial by monomial.
fn expanded(scene: &Scene, derived: Derived, args: &[Vertex]) -> Sign {
    let coordinates: Vec<Rational> = derived.with_points(scene, args, |points| {
        points.iter().flat_map(|point| point.iter().map(|&x| judge::rational(x))).collect()
    });
    let mut sum = Rational::new();
    for (exponents, coefficient) in derived.formula().polynomial().terms() {
        let mut product = Rational::from(coefficient);
        for (x, &exponent) in coordinates.iter().zip(exponents) {
            (0..exponent).for_each(|_| product *= x);
        }
        sum += product;
    }
    Sign::from(sum.cmp0())
}

fn bareiss(mut matrix: Vec<Vec<Integer>>) -> Sign {
    let n = matrix.len();
    let mut sign = Sign::Positive;
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
    sign * Sign::from(matrix[n - 1][n - 1].cmp0())
}

/// The sign by all three computations, which must agree; a determinant is never larger than its permanent.
fn agreed(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    let (sign, verdict) = (judge::sign(scene, question, args), judge::verdict(scene, question, args));
    let third = third(scene, question, args);
    assert_eq!([sign, verdict.sign()], [third; 2], "{} of {scene:?}", question.query(args));
    let size = Rational::from(verdict.determinant.abs_ref());
    assert!(size <= verdict.permanent);
    let near = size.to_f64();
    for limit in [0.0, near.next_down(), near, near.next_up(), 2.0 * near, -1.0].into_iter().filter(|x| x.is_finite()) {
        let is_within = judge::is_within(scene, question, args, limit);
        assert_eq!(is_within, size <= judge::rational(limit), "{} of {scene:?} and {limit:e}", question.query(args));
    }
    sign
}

/// Evenly spaced queries from every embedded scene of signs, and so from every family. The same queries detect
/// arithmetic that rounds, so they are hard enough to distinguish a right judge from a wrong one.
#[test]
fn three_computations_agree_on_every_family() {
    let (mut scenes, mut zeros, mut rounded) = (0, 0, 0);
    let naive = predicament_bundle::backend("naive").unwrap();
    for definition in definitions() {
        let loaded = loaded(&definition);
        let Some(content) = loaded.content::<SignQueries>() else { continue };
        let queries = &content.queries;
        let naive = naive.answer(&Signs::of(queries.kind()), &loaded.scene, content).unwrap().0;
        scenes += 1;
        for query in (0..queries.len()).step_by(queries.len().div_ceil(most()).max(1)) {
            let truth = agreed(&loaded.scene, queries.question(), queries.args(query));
            zeros += usize::from(truth.is_zero());
            rounded += usize::from(naive[query] != truth);
        }
    }
    println!("{scenes} scenes, {zeros} ties, {rounded} that floating point gets wrong");
    assert!(
        scenes >= 80 && zeros > 10 * most() && rounded > 5 * most(),
        "{scenes} scenes, {zeros} ties, {rounded} rounded"
    );
}

fn questions(dimension: Dimension) -> Vec<Question> {
    match dimension {
        Dimension::Two => vec![Question::Compare(Axis::X), Question::Orient2d(Plane::Xy), Question::Incircle],
        Dimension::Three => vec![
            Question::Compare(Axis::Z),
            Question::Orient2d(Plane::Yz),
            Question::Orient2d(Plane::Zx),
            Question::Orient3d,
            Question::Insphere,
        ],
    }
}

fn agree_on(coordinates: &[f64]) {
    for (dimension, count) in [(Dimension::Two, 8), (Dimension::Three, 15)] {
        let scene = Scene::new(dimension, coordinates[..count].to_vec()).unwrap();
        for question in questions(dimension) {
            let args: Vec<Vertex> = scene.vertices().take(question.kind().arity()).collect();
            agreed(&scene, question, &args);
        }
    }
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

fn small() -> impl Strategy<Value = f64> {
    (-3i8..=3).prop_map(f64::from)
}

/// Adds the constructions with these ids that give points.
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
            let found = judge::point(&trial, vertex).is_some();
            assert_eq!(found, homogeneous(&trial, vertex).is_some(), "{candidate} {scene:?}");
            if found {
                *scene = trial;
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(64, 256)))]

    #[test]
    fn three_computations_agree_on_small_integers(points in prop::collection::vec(-3i8..=3, 15)) {
        agree_on(&points.iter().map(|&x| f64::from(x)).collect::<Vec<_>>());
    }

    #[test]
    fn three_computations_agree_on_any_doubles(
        coordinates in prop::collection::vec(any::<f64>().prop_filter("finite", |x| x.is_finite()), 15),
        bits in prop::collection::vec(any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()), 15),
    ) {
        agree_on(&coordinates);
        agree_on(&bits);
    }

    #[test]
    fn three_computations_agree_on_constructed_vertices(
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
                agreed(&scene, question, args);
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
                        prop_assert_eq!(judge::sign(&scene, Question::Orient3d, &args), Sign::Zero);
                    } else {
                        for &plane in planes {
                            prop_assert_eq!(judge::sign(&scene, Question::Orient2d(plane), &args), Sign::Zero);
                        }
                    }
                }
            }
        }
    }
}
