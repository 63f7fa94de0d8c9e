//! Ties between two meshes with coordinates of any magnitude.
//!
//! Derivatives by a filter and by rationals, and points of lines and planes in integers, are compared with whole
//! polynomials.

use crate::common::{Random, ask_antisymmetric, questions};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Construction, Off, Predicates, Question, Scene, Sign, Vertex};
use predicament_sos::{PerMesh, infinitesimal::judge_per_mesh};

fn moving(points: &[[f64; 3]], from: usize) -> Scene {
    let scene = Scene::from_points3(points).unwrap();
    scene.with_second_mesh((from..points.len()).map(Vertex::input))
}

/// Asks in all orders; returns the answer, if it is that of the polynomial.
fn agreed(session: &impl Predicates, question: Question, args: &[Vertex]) -> Sign {
    let scene = session.scene();
    let answer = ask_antisymmetric(session, question, args);
    assert_eq!(answer, judge_per_mesh(scene, question, args), "{question:?} of {args:?} in {scene:?}");
    answer
}

/// Two edges in one plane, with directions that differ by one in the product of 53 bits each.
///
/// The derivative of their side by the axis across is 1 of 10^31, or zero.
#[test]
fn edges_that_are_nearly_parallel() {
    let mut numbers = vec![1.0, 1.0];
    while numbers[numbers.len() - 1] < 2f64.powi(52) {
        numbers.push(numbers[numbers.len() - 2] + numbers[numbers.len() - 1]);
    }
    let mut seen = [0; 3];
    for scale in [0, -960, -1022, 700, 970].map(|power| 2f64.powi(power)) {
        for at in [3, 4, 24, 25, 60, numbers.len() - 4, numbers.len() - 3] {
            let [a, b, c] = [0, 1, 2].map(|i: usize| numbers[at + i] * scale);
            for (along, expected) in [([b, c], true), ([a, b], false), ([-a, -b], false), ([0.0, c], true)] {
                for turn in 0..3 {
                    let place = |[x, y]: [f64; 2]| {
                        let mut p = [0.0; 3];
                        p[turn] = x;
                        p[(turn + 1) % 3] = y;
                        p
                    };
                    let scene = moving(&[place([0.0; 2]), place([a, b]), place([0.0; 2]), place(along)], 2);
                    let session = PerMesh.prepare(&scene, Off).unwrap();
                    let answer = agreed(&session, Question::Orient3d, &[0, 1, 2, 3].map(Vertex::input));
                    assert_eq!(!answer.is_zero(), expected, "{scene:?}");
                    seen[usize::from(answer != Sign::Zero) + usize::from(answer == Sign::Positive)] += 1;
                }
            }
        }
    }
    assert!(seen.iter().all(|&count| count > 40), "{seen:?}");
}

/// Two edges in the plane z = 0 that differ by rounding only.
///
/// In doubles the order of the products is sometimes wrong.
#[test]
fn edges_that_rounding_makes_parallel() {
    let (mut random, mut seen) = (Random(33), [0; 2]);
    let mut fraction = || f64::from(u32::try_from(random.below(1 << 32)).unwrap()) / 3.0;
    for scale in [1.0, 2f64.powi(-400), 2f64.powi(450)] {
        for _ in 0..predicament_effort::scaled(6_000) {
            let [p, q, u] = [0.25, 1.0, 0.25].map(|by| [fraction() * by * scale, fraction() * by * scale, 0.0]);
            let v = [0, 1, 2].map(|i: usize| u[i] + (q[i] - p[i]));
            let scene = moving(&[p, q, u, v], 2);
            let session = PerMesh.prepare(&scene, Off).unwrap();
            let answer = agreed(&session, Question::Orient3d, &[0, 1, 2, 3].map(Vertex::input));
            let [left, right] = [(q[0] - p[0]) * (v[1] - u[1]), (q[1] - p[1]) * (v[0] - u[0])];
            if left != right {
                seen[usize::from((left > right) == (answer == Sign::Positive))] += 1;
            }
        }
    }
    let [some, most] = [seen[0].min(seen[1]), seen[0].max(seen[1])];
    assert!(some > 3 && most > 10 * some, "{seen:?}");
}

/// Two products about 2^-1075: the larger one is rounded to zero, and the other one is not.
///
/// Factors are rounded, one up and two down.
#[test]
fn products_that_underflow_to_the_wrong_order() {
    let power = |power: i32| 2f64.powi(power);
    let p = [-(power(-590) + power(-640)), -(power(-590) - power(-640)), 0.0];
    let q = [power(-537), power(-537), 0.0];
    let u = [-(power(-591) - power(-641)), 0.0, 0.0];
    let v = [power(-538), power(-538), 0.0];
    let by_doubles = [(q[0] - p[0]) * (v[1] - u[1]), (q[1] - p[1]) * (v[0] - u[0])];
    assert!(by_doubles[0] > by_doubles[1]);
    let scene = moving(&[p, q, u, v], 2);
    let session = PerMesh.prepare(&scene, Off).unwrap();
    let answer = agreed(&session, Question::Orient3d, &[0, 1, 2, 3].map(Vertex::input));
    // With the doubles' order this would be the opposite.
    let scene = moving(&[p, [q[0] * 2.0, q[1], 0.0], u, v], 2);
    let opposite = agreed(&PerMesh.prepare(&scene, Off).unwrap(), Question::Orient3d, &[0, 1, 2, 3].map(Vertex::input));
    assert_eq!(answer, -opposite);
}

const MAGNITUDES: [f64; 14] =
    [0.0, 5e-324, 1e-323, 1e-300, 1e-160, 1e-154, 1.0, 1.0 + f64::EPSILON, 3.0, 1e154, 1e300, -1.0, -5e-324, f64::MAX];

fn points(random: &mut Random, count: usize) -> Vec<[f64; 3]> {
    // Few magnitudes at a time, so that there are ties.
    let some: Vec<f64> = (0..3).map(|_| MAGNITUDES[random.below(MAGNITUDES.len())]).chain([0.0]).collect();
    (0..count).map(|_| [(); 3].map(|()| some[random.below(some.len())] * [1.0, -1.0][random.below(2)])).collect()
}

#[test]
fn ties_of_vertices_of_any_magnitude() {
    let (mut random, mut ties) = (Random(31), 0);
    for _ in 0..predicament_effort::some_or_all(120, 6_000) {
        let scene = moving(&points(&mut random, 6), 3);
        let (exact, session) = (Exact.prepare(&scene, Off).unwrap(), PerMesh.prepare(&scene, Off).unwrap());
        for question in questions(3) {
            let mut left: Vec<Vertex> = scene.vertices().collect();
            let args: Vec<Vertex> =
                (0..question.kind().arity()).map(|_| left.swap_remove(random.below(left.len()))).collect();
            let answer = agreed(&session, question, &args);
            ties += usize::from(question.ask(&exact, &args).is_zero() && !answer.is_zero());
        }
    }
    assert!(ties > 30, "{ties}");
}

#[test]
fn ties_of_points_of_lines_and_planes_of_any_magnitude() {
    let (mut random, mut ties, mut zeros) = (Random(32), 0, 0);
    for _ in 0..predicament_effort::scaled(6_000) {
        let scene = moving(&points(&mut random, 14), 7);
        let [a, b, c, d, e, f, g, s, t, u, v, w, x, y] = std::array::from_fn(Vertex::input);
        let mut session = PerMesh.prepare(&scene, Off).unwrap();
        let definitions = [
            Construction::Lpi { line: [a, b], plane: [s, t, u] },
            Construction::Lpi { line: [v, w], plane: [a, c, d] },
            Construction::Lpi { line: [v, x], plane: [a, c, d] },
            Construction::Lpi { line: [e, f], plane: [a, c, g] },
            Construction::Tpi([[a, b, c], [d, e, f], [s, u, y]]),
        ];
        let made = definitions.iter().filter_map(|&of| session.construct(&[of]).ok()).flatten();
        let mut all: Vec<Vertex> = made.collect();
        all.extend([a, d, s, v]);
        all.sort_unstable();
        all.dedup();
        for question in questions(3) {
            if question == Question::Insphere {
                continue;
            }
            let mut left = all.clone();
            let args: Vec<Vertex> =
                (0..question.kind().arity()).map(|_| left.swap_remove(random.below(left.len()))).collect();
            let answer = agreed(&session, question, &args);
            ties += usize::from(!answer.is_zero() && unmoved(&session, question, &args).is_zero());
            zeros += usize::from(answer.is_zero());
        }
    }
    assert!(ties > 20 && zeros > 30, "{ties} {zeros}");
}

/// The sign without any move.
fn unmoved(session: &impl Predicates, question: Question, args: &[Vertex]) -> Sign {
    let scene = session.scene().clone();
    question.ask(&Exact.prepare(&scene, Off).unwrap(), args)
}
