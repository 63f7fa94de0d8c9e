//! Constructed vertices against the judge: ordinary, degenerate and extreme.

mod cascades;
mod faults;
mod judge;
mod near;
mod scenes;
mod tight;

use crate::common::{Random, nudge};
use judge::Judge;
use predicament_exact::constructed::Constructed;
use predicament_predicates::{Axis, Construction, Dimension, Plane, Scene, Sign, Vertex};
use proptest::prelude::*;
use scenes::{Seen, check, check_one, construct, scene};

const DIMENSIONS: [Dimension; 2] = [Dimension::Two, Dimension::Three];

/// Magnitudes from the least subnormal to the largest double, with long and short significands.
const WILD: [f64; 12] =
    [5e-324, 3.0e-310, f64::MIN_POSITIVE, -1.1e-308, 1e-200, -1.0, 0.1, 3e15, -1e102, 1.7e154, -1e308, f64::MAX];

fn v(index: usize) -> Vertex {
    Vertex::input(index)
}

#[test]
fn uniform_questions_are_the_filters() {
    let mut random = Random(1);
    for dimension in DIMENSIONS {
        for _ in 0..20 {
            let mut scene = scene(&mut random, dimension, 12, Random::unit);
            construct(&mut random, &mut scene, 12);
            let seen = check(&mut random, &scene, 100);
            let Seen { signs: [negative, zero, positive], filtered } = seen;
            assert!(negative.min(positive) > seen.all() / 4);
            // A vertex that occurs twice, or is on its own plane.
            assert!(negative + positive - filtered < 20, "{dimension:?}: {zero} {negative} {positive} {filtered}");
        }
    }
}

#[test]
fn grids_are_full_of_ties() {
    let mut random = Random(2);
    for dimension in DIMENSIONS {
        for stretch in [1.0, 0.1, 1.0 + f64::EPSILON, 1e-320, 1e300] {
            for _ in 0..8 {
                #[allow(clippy::cast_precision_loss)] // below 4
                let mut scene = scene(&mut random, dimension, 16, |random| random.below(4) as f64 * stretch);
                construct(&mut random, &mut scene, 30);
                let seen = check(&mut random, &scene, 60);
                assert!(seen.signs.iter().all(|&count| count > seen.all() / 20), "{seen:?}");
            }
        }
    }
}

#[test]
fn every_exponent_with_every_other() {
    let mut random = Random(3);
    for dimension in DIMENSIONS {
        for _ in 0..predicament_effort::some_or_all(8, 60) {
            let mut scene = scene(&mut random, dimension, 10, |random| *random.pick(&WILD));
            construct(&mut random, &mut scene, 6);
            if !scene.constructions().is_empty() {
                check(&mut random, &scene, 6);
            }
        }
    }
}

/// Coordinates of growing length, bit by bit: every length of rows and every capacity in turn.
#[test]
fn every_length_of_coordinates() {
    let mut random = Random(8);
    for dimension in DIMENSIONS {
        let mut signs = [0; 3];
        for bits in (1..2098).step_by(predicament_effort::some_or_all(31, 11)) {
            let place = i32::try_from(random.below(2098 - bits)).expect("an exponent") - 1074;
            // Of numbers below 2^(place + bits) the largest doubles, and the lowest bit.
            let power = |k: i32| if k < -1022 { f64::from_bits(1 << (k + 1074)) } else { 2f64.powi(k) };
            let top = i32::try_from(bits).expect("2098 at most") - 1;
            let (one, half) = (power(place), power(place + top));
            let full = if top < 52 { 2.0 * (half - one / 2.0) } else { half * (2.0 - f64::EPSILON) };
            let values = [one, -one, half, -half, full, -full, 0.0].map(|x| x.clamp(-f64::MAX, f64::MAX));
            let mut scene = scene(&mut random, dimension, 12, |random| *random.pick(&values));
            construct(&mut random, &mut scene, 6);
            if !scene.constructions().is_empty() {
                let seen = check(&mut random, &scene, 4);
                signs = std::array::from_fn(|i| signs[i] + seen.signs[i]);
            }
        }
        assert!(signs.iter().all(|&count| count > predicament_effort::some_or_all(35, 100)), "{dimension:?} {signs:?}");
    }
}

/// The longest possible numbers: as many planes as possible, of the largest and the least doubles.
#[test]
fn from_the_largest_to_the_least() {
    let mut random = Random(7);
    let extreme = [f64::MAX, -f64::MAX.next_down(), 5e-324, -1.5e-323, 1.0 + f64::EPSILON];
    let mut signs = [0; 3];
    let rounds = predicament_effort::some_or_all(4, 200);
    for _ in 0..rounds {
        let mut scene = scene(&mut random, Dimension::Three, 16, |random| *random.pick(&extreme));
        let judge = Judge::new(&scene);
        for _ in 0..8 {
            let planes = [0; 3].map(|_| scenes::distinct(&mut random, 16));
            if judge.meet(&Construction::Tpi(planes)).is_some() {
                scene.construct(Construction::Tpi(planes)).unwrap();
            }
        }
        let (count, judge, ours) = (scene.constructions().len(), Judge::new(&scene), Constructed::new(&scene).unwrap());
        for _ in 0..10 {
            let mut any = || Vertex::constructed(random.below(count));
            let mut seen = Seen::default();
            check_one(&judge, &ours, &scene, [any(), any(), any(), any()], &mut seen);
            signs = std::array::from_fn(|i| signs[i] + seen.signs[i]);
        }
    }
    assert!(signs.iter().all(|&count| count > 2 * rounds), "{signs:?}");
}

/// Input vertices a few ulps off constructed ones, and lines and planes almost through them.
#[test]
fn nearly_degenerate_at_every_scale() {
    let mut random = Random(4);
    let mut seen = [Seen::default(); 2];
    for round in 0..400_i32 {
        let dimension = DIMENSIONS[random.below(2)];
        let scale = 2f64.powi((round - 200) * 5) * if round % 2 == 0 { 1.0 } else { 0.75 };
        let shift = [0.0, 0.0, 1.0, 1000.0][random.below(4)];
        let mut first = scene(&mut random, dimension, 9, |random| (random.unit() + shift) * scale / 1024.0);
        construct(&mut random, &mut first, 4);
        let judge = Judge::new(&first);
        // Around each constructed vertex, and on the way from it to an input vertex.
        let mut coordinates = first.coordinates().to_vec();
        for index in 0..first.constructions().len() {
            let center: Vec<f64> = judge.point(Vertex::constructed(index)).iter().map(rug::Rational::to_f64).collect();
            for _ in 0..3 {
                let far = first.point(v(random.below(9)));
                let along = *random.pick(&[0.0, 0.5, -1.0]);
                for (center, far) in center.iter().zip(far) {
                    let x = center + along * (far - center);
                    coordinates.push(nudge(x, i64::try_from(random.below(5)).unwrap() - 2));
                }
            }
        }
        if coordinates.iter().any(|x| !x.is_finite()) {
            continue;
        }
        let mut scene = Scene::new(dimension, coordinates).expect("finite");
        for construction in first.constructions() {
            scene.construct(*construction).expect("the same vertices");
        }
        construct(&mut random, &mut scene, 4);
        let judge = Judge::new(&scene);
        let ours = Constructed::new(&scene).expect("points");
        scenes::check_approximations(&scene, &judge, &ours);
        for _ in 0..20 {
            let index = random.below(first.constructions().len().max(1));
            let around = v(9 + 3 * index + random.below(3));
            let mut asked =
                [Vertex::constructed(index), around, v(random.below(scene.len())), v(random.below(scene.len()))];
            let (i, j) = (random.below(4), random.below(4));
            asked.swap(i, j);
            check_one(&judge, &ours, &scene, asked, &mut seen[dimension.count() - 2]);
        }
    }
    for seen in seen {
        assert!(seen.filtered > seen.all() / 10 && seen.filtered < seen.all() * 9 / 10, "both rungs: {seen:?}");
    }
}

/// The lines and planes that define a point contain it, and the same point by other ids is equal.
#[test]
fn ties_by_construction() {
    let mut random = Random(5);
    for _ in 0..200 {
        let mut flat = scene(&mut random, Dimension::Two, 4, Random::unit);
        let x = flat.construct(Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])).unwrap();
        let ours = Constructed::new(&flat).unwrap();
        for [p, q] in [[0, 1], [3, 2]] {
            assert_eq!(ours.orient2d(Plane::Xy, v(p), x, v(q)).0, Sign::Zero);
        }

        let mut solid = scene(&mut random, Dimension::Three, 9, Random::unit);
        let [l, m, n] = [[v(0), v(1), v(2)], [v(3), v(4), v(5)], [v(6), v(7), v(8)]];
        let x = solid.construct(Construction::Lpi { line: [v(0), v(1)], plane: m }).unwrap();
        let y = solid.construct(Construction::Tpi([l, m, n])).unwrap();
        let ours = Constructed::new(&solid).unwrap();
        for plane in judge::PLANES {
            assert_eq!(ours.orient2d(plane, v(0), v(1), x).0, Sign::Zero);
        }
        for (point, [a, b, c]) in [(x, l), (x, m), (y, l), (y, m), (y, n)] {
            assert_eq!(ours.orient3d(a, point, b, c).0, Sign::Zero);
        }
        assert_ne!(ours.orient3d(n[0], x, n[1], n[2]).0, Sign::Zero);
    }
}

/// Lines and planes through one point in thirds, which is not a double.
///
/// As many vertices are at one place as there are ways to define it.
#[test]
fn one_point_by_many_ids() {
    let mut random = Random(6);
    for bits in [2, 20, 45] {
        for dimension in DIMENSIONS {
            // 1 modulo 3, like the directions: center + 2 direction and center − direction are 0.
            let mut one = |_| 3 * (i64::try_from(random.below(1 << bits)).unwrap() - (1 << (bits - 1))) + 1;
            let center: [i64; 3] = std::array::from_fn(&mut one);
            let directions: [[i64; 3]; 6] = std::array::from_fn(|_| std::array::from_fn(&mut one));
            #[allow(clippy::cast_precision_loss)] // below 2^51
            let point = |direction: [i64; 3], times: i64| -> Vec<f64> {
                (0..dimension.count()).map(|i| ((center[i] + times * direction[i]) / 3) as f64).collect()
            };
            let coordinates = directions.iter().flat_map(|&d| [point(d, 2), point(d, -1)]).flatten().collect();
            let mut scene = Scene::new(dimension, coordinates).unwrap();
            let line = |i: usize| [v(2 * i), v(2 * i + 1)];
            let plane = |i: usize, j: usize| [v(2 * i), v(2 * i + 1), v(2 * j)];
            let candidates = match dimension {
                Dimension::Two => vec![[0, 1], [2, 3], [0, 4], [5, 1]]
                    .into_iter()
                    .map(|[i, j]| Construction::Ssi([line(i), line(j)]))
                    .collect::<Vec<_>>(),
                Dimension::Three => vec![
                    Construction::Lpi { line: line(0), plane: plane(1, 2) },
                    Construction::Lpi { line: line(3), plane: plane(5, 4) },
                    Construction::Tpi([plane(0, 1), plane(2, 3), plane(4, 5)]),
                    Construction::Tpi([plane(0, 3), plane(5, 1), plane(2, 4)]),
                ],
            };
            let judge = Judge::new(&scene);
            let same: Vec<Vertex> = candidates
                .into_iter()
                .filter(|candidate| judge.meet(candidate).is_some())
                .map(|candidate| scene.construct(candidate).unwrap())
                .collect();
            assert!(same.len() > 1, "{dimension:?} {bits}");
            let (judge, ours) = (Judge::new(&scene), Constructed::new(&scene).unwrap());
            let mut seen = Seen::default();
            for _ in 0..50 {
                let [a, b] = [*random.pick(&same), *random.pick(&same)];
                assert_eq!(ours.compare(Axis::Y, a, b).0, Sign::Zero);
                let mut asked = [a, b, v(random.below(12)), v(random.below(12))];
                let (i, j) = (random.below(4), random.below(4));
                asked.swap(i, j);
                check_one(&judge, &ours, &scene, asked, &mut seen);
            }
            assert!(seen.signs[1] > seen.all() / 4, "{seen:?}");
        }
    }
}

/// A definition without a point is named, with the reason.
#[test]
fn what_does_not_meet_is_declined() {
    let declined = |scene: &Scene| Constructed::new(scene).expect_err("no point").to_string();
    let mut flat =
        Scene::from_points2(&[[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 2.0], [1.0, 0.0], [1.0, 0.0]]).unwrap();
    let fine = Construction::Ssi([[v(0), v(3)], [v(1), v(2)]]);
    flat.construct(fine).unwrap();
    for (lines, reason) in [
        ([[v(0), v(1)], [v(2), v(3)]], "c1, constructed as SSI(0 1, 2 3), is not a point: the lines are parallel"),
        ([[v(0), v(1)], [v(1), v(0)]], "the lines are parallel"),
        ([[v(0), v(1)], [v(4), v(5)]], "the ends of a segment coincide"),
    ] {
        let mut scene = flat.clone();
        scene.construct(Construction::Ssi(lines)).unwrap();
        assert!(declined(&scene).ends_with(reason), "{}", declined(&scene));
    }
    let grid: Vec<[f64; 3]> = (0..27_i32).map(|i| [i % 3, i / 3 % 3, i / 9].map(f64::from)).chain([[0.0; 3]]).collect();
    let solid = Scene::from_points3(&grid).unwrap();
    let (floor, wall, diagonal) = ([v(0), v(1), v(3)], [v(0), v(1), v(9)], [v(1), v(10), v(4)]);
    for (construction, reason) in [
        (Construction::Lpi { line: [v(10), v(12)], plane: floor }, "the line is parallel to the plane"),
        (Construction::Lpi { line: [v(0), v(1)], plane: floor }, "the line is parallel to the plane"),
        (Construction::Lpi { line: [v(0), v(27)], plane: floor }, "the two vertices of the line coincide"),
        (Construction::Lpi { line: [v(0), v(13)], plane: [v(9), v(13), v(17)] }, "vertices of a plane are collinear"),
        (Construction::Tpi([floor, wall, [v(0), v(27), v(5)]]), "vertices of a plane are collinear"),
        (Construction::Tpi([floor, wall, [v(9), v(10), v(12)]]), "the planes share no point, or more than one"),
        (Construction::Tpi([floor, wall, [v(0), v(1), v(12)]]), "the planes share no point, or more than one"),
    ] {
        let mut scene = solid.clone();
        scene.construct(construction).unwrap();
        assert!(Judge::new(&solid).meet(&construction).is_none());
        assert!(declined(&scene).ends_with(reason), "{}", declined(&scene));
    }
    let mut scene = solid.clone();
    let corner = scene.construct(Construction::Tpi([floor, wall, diagonal])).unwrap();
    assert_eq!(Constructed::new(&scene).unwrap().compare(Axis::X, corner, v(1)).0, Sign::Zero);
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(100, 300)))]

    #[test]
    fn arbitrary_doubles(
        solid in any::<bool>(),
        coordinates in proptest::collection::vec(prop_oneof![finite(), -1.0..1.0f64, Just(0.0)], 30),
        seed in any::<u64>(),
    ) {
        let mut random = Random(seed);
        let mut scene = Scene::new(DIMENSIONS[usize::from(solid)], coordinates).unwrap();
        construct(&mut random, &mut scene, 4);
        if !scene.constructions().is_empty() {
            check(&mut random, &scene, 4);
        }
    }
}
