//! Points computed in floating point: the size of their errors, and cases that must not be accepted as points.

use predicament_exact::constructed::Constructed;
use predicament_exact::{Exact, Session};
use predicament_predicates::{Axis, Backend, Construction, Dimension, Off, Plane, Predicates, Scene, Sign, Vertex};
use rug::Rational;

use super::judge::Judge;
use super::scenes::{check_approximations, scene};
use super::{DIMENSIONS, WILD};
use crate::common::Random;

fn v(index: usize) -> Vertex {
    Vertex::input(index)
}

fn power(exponent: i32) -> f64 {
    if exponent < -1022 { f64::from_bits(1 << (exponent + 1074).max(0)) } else { 2f64.powi(exponent) }
}

/// One definition of each kind, with separate vertices.
fn kinds(dimension: Dimension) -> Vec<Construction> {
    let planes = [[v(0), v(1), v(2)], [v(3), v(4), v(5)], [v(6), v(7), v(8)]];
    match dimension {
        Dimension::Two => vec![Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])],
        Dimension::Three => {
            vec![Construction::Lpi { line: [v(0), v(1)], plane: planes[1] }, Construction::Tpi(planes)]
        }
    }
}

/// The constructed vertex of the scene, judged; `None` if it has no point.
fn with(inputs: &Scene, construction: Construction) -> Option<(Constructed, Judge)> {
    let mut scene = inputs.clone();
    scene.construct(construction).expect("input vertices");
    let (ours, is_point) = (Constructed::new(&scene), Judge::new(inputs).meet(&construction).is_some());
    assert_eq!(ours.is_ok(), is_point, "{construction} of {inputs:?}");
    let (ours, judge) = (ours.ok()?, Judge::new(&scene));
    check_approximations(&scene, &judge, &ours);
    Some((ours, judge))
}

/// Returns true if floating point could not prove that there is a point.
///
/// Then the slack is that of rounded coordinates.
fn was_exact(ours: &Constructed) -> bool {
    let (point, slack) = ours.near(Vertex::constructed(0));
    slack == 65.0 / 64.0 * point.iter().fold(0.0, |most: f64, x| most.max(x.abs())) + 2f64.powi(-280)
}

/// Lines and planes that differ by 2^-k of their size, for every k: all have points, and no slack is too small.
#[test]
fn every_angle() {
    let mut random = Random(201);
    for dimension in DIMENSIONS {
        let mut exactly = [0; 60];
        for (k, exactly) in exactly.iter_mut().enumerate() {
            let angle = power(-i32::try_from(k).expect("below 60"));
            for construction in kinds(dimension) {
                for _ in 0..predicament_effort::scaled(200) {
                    let flat: Vec<f64> = (0..3 * dimension.count()).map(|_| random.unit()).collect();
                    let away = [0.0, 0.25, 0.5].map(|_| random.unit());
                    let coordinates = (0..9).flat_map(|vertex| {
                        let (flat, random) = (&flat, &mut random);
                        // The vertices of every line or plane, a step away from those of the first.
                        let corner = vertex % (dimension.count());
                        let point = (0..dimension.count()).map(|axis| {
                            let step = away[vertex / dimension.count() % 3] * angle;
                            flat[corner * dimension.count() + axis] + step + angle * random.unit()
                        });
                        point.collect::<Vec<_>>()
                    });
                    let scene = Scene::new(dimension, coordinates.collect()).expect("finite");
                    if let Some((ours, _)) = with(&scene, construction) {
                        *exactly += usize::from(was_exact(&ours));
                    }
                }
            }
        }
        let [plain, sharp] = [&exactly[..10], &exactly[42..52]].map(|part| part.iter().sum::<usize>());
        assert!(sharp > 50 && plain < sharp / 10, "{dimension:?}: {exactly:?}");
    }
}

/// Parallel lines and planes whose differences are rounded: doubles see an angle, which must not be trusted.
#[test]
fn what_rounding_has_turned_is_refused() {
    let mut random = Random(202);
    let (mut believed, rounds) = (0, predicament_effort::scaled(2000));
    for _ in 0..rounds {
        // 50 bits at any of some exponents: three times that is a double.
        let mut short = || (random.unit() * power(50)).round() * power(-[50, 53, 60, 71][random.below(4)]);
        let points: [[f64; 3]; 3] = std::array::from_fn(|_| std::array::from_fn(|_| short()));
        let times = |factor: f64| points.map(|p| p.map(|x| factor * x));
        let [[a, b, _], [c, d, _]] = [1.0, 3.0].map(|factor| times(factor).map(|[x, y, _]| [x, y]));
        believed += usize::from((b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]) != 0.0);
        let scene = Scene::from_points2(&[a, b, c, d]).expect("finite");
        assert!(with(&scene, kinds(Dimension::Two)[0]).is_none());

        let scene = Scene::from_points3(&[times(1.0), times(3.0), times(-5.0)].concat()).expect("finite");
        assert!(with(&scene, kinds(Dimension::Three)[1]).is_none());
        let line = Construction::Lpi { line: [v(0), v(1)], plane: [v(3), v(4), v(5)] };
        assert!(with(&scene, line).is_none());
    }
    assert!(believed > rounds / 4, "{believed} of {rounds}");
}

/// Magnitudes around the ends of the proved range, and far beyond, in one definition.
#[test]
fn the_ends_of_the_range() {
    let mut random = Random(203);
    let rounds = predicament_effort::some_or_all(80_usize, 4000);
    for dimension in DIMENSIONS {
        for construction in kinds(dimension) {
            let mut seen = [0; 2];
            for round in 0..rounds {
                // Factors of w at 2^-350 together, differences at 2^60.
                let low =
                    -[175, 116, 58][dimension.count() - 2 + usize::from(matches!(construction, Construction::Tpi(_)))];
                let exponents = [
                    low + 20 - i32::try_from(round % 40).expect("below 40"),
                    50 + i32::try_from(round % 13).expect("below 13"),
                ];
                let mut coordinate = |random: &mut Random| match random.below(8) {
                    0 => *random.pick(&WILD[..5]),
                    1 if round % 3 == 0 => random.unit() * power(exponents[1]),
                    _ => random.unit() * power(exponents[usize::from(round % 3 == 1)]),
                };
                let scene = scene(&mut random, dimension, 9, &mut coordinate);
                if let Some((ours, _)) = with(&scene, construction) {
                    seen[usize::from(was_exact(&ours))] += 1;
                }
            }
            assert!(seen.iter().all(|&count| count > rounds / 10), "{construction}: {seen:?} of {rounds}");
        }
    }
}

/// A point of the largest doubles, or nearly at infinity, has a valid error bound.
#[test]
fn overflow_is_seen() {
    let mut random = Random(204);
    for dimension in DIMENSIONS {
        for construction in kinds(dimension) {
            for _ in 0..predicament_effort::scaled(500) {
                let huge = [f64::MAX, -f64::MAX, 1e308, 1e154, -1e103, 1e60, 1.0, 0.0];
                let scene = scene(&mut random, dimension, 9, |random| *random.pick(&huge));
                with(&scene, construction);
            }
        }
    }
}

/// The largest error relative to the slack, of nearly parallel lines, with differences where doubles are coarsest.
#[test]
fn half_the_slack_is_caught() {
    let mut random = Random(205);
    let mut worst = [0.0_f64; 3];
    for _ in 0..predicament_effort::some_or_all(1_500, 100_000) {
        for (kind, worst) in worst.iter_mut().enumerate() {
            let dimension = DIMENSIONS[usize::from(kind > 0)];
            let construction = kinds(dimension)[kind.saturating_sub(1)];
            let mut coordinate = |random: &mut Random| {
                let x =
                    if random.below(2) == 0 { 1.0 + random.unit() * 0.02 } else { -random.unit().abs() * power(-40) };
                if random.below(4) == 0 { -x } else { x }
            };
            let mut scene = scene(&mut random, dimension, 9, &mut coordinate);
            let x = scene.construct(construction).expect("input vertices");
            let Ok(ours) = Constructed::new(&scene) else { continue };
            if was_exact(&ours) {
                continue;
            }
            let ((point, slack), exact) = (ours.near(x), Judge::new(&scene));
            for (&near, truth) in point.iter().zip(exact.point(x)) {
                let error = (Rational::from_f64(near).expect("finite") - truth).to_f64().abs();
                *worst = worst.max(error / (slack * power(-53)));
            }
        }
    }
    println!("{worst:?}");
    assert!(worst[0] > 0.5 && worst.iter().all(|&share| share <= 1.0), "{worst:?}");
}

/// The order of queries changes neither signs nor stages, on any thread.
#[test]
fn order_does_not_matter() {
    let mut random = Random(206);
    for dimension in DIMENSIONS {
        let base =
            scene(&mut random, dimension, 12, |random| f64::from(u32::try_from(random.below(5)).expect("below 5")));
        let cascade = |session: &mut Session<'_, Off>| {
            let mut random = Random(207);
            while session.scene().constructions().len() < 40 {
                let count = session.scene().constructions().len();
                let mut any = || match random.below(3) {
                    0 if count > 0 => Vertex::constructed(random.below(count)),
                    _ => v(random.below(12)),
                };
                let definition = match dimension {
                    Dimension::Two => Construction::Ssi([[any(), any()], [any(), any()]]),
                    Dimension::Three => Construction::Lpi { line: [any(), any()], plane: [any(), any(), any()] },
                };
                let _ = session.construct(&[definition]);
            }
        };
        let prepared = || {
            let mut session = Exact.prepare(&base, Off).expect("prepared");
            cascade(&mut session);
            session
        };
        let queries: Vec<[Vertex; 4]> = (0..400)
            .map(|_| {
                std::array::from_fn(|_| match random.below(4) {
                    0 => v(random.below(12)),
                    _ => Vertex::constructed(random.below(40)),
                })
            })
            .collect();
        let ask = |session: &Session<'_, Off>, [a, b, c, d]: [Vertex; 4]| {
            let turn = session.decide_orient2d(Plane::Xy, a, b, c);
            let side = (dimension == Dimension::Three).then(|| session.decide_orient3d(a, b, c, d));
            (session.decide_compare(Axis::X, a, b), turn, side)
        };
        let expected: Vec<_> = queries.iter().map(|&query| ask(&prepared(), query)).collect();
        assert!(expected.iter().any(|(_, (sign, _), _)| *sign == Sign::Zero));
        let session = prepared();
        std::thread::scope(|scope| {
            for thread in 0..4 {
                let (session, queries, expected, ask) = (&session, &queries, &expected, &ask);
                scope.spawn(move || {
                    for i in 0..queries.len() {
                        let at = if thread % 2 == 0 { i * 7 % queries.len() } else { queries.len() - 1 - i };
                        assert_eq!(ask(session, queries[at]), expected[at]);
                    }
                });
            }
        });
    }
}
