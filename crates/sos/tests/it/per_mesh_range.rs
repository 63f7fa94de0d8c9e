//! Ties between two meshes where coordinates have any magnitude: derivatives by a filter and by rationals, and points of
//! lines and planes in integers, against whole polynomials.

use crate::common::{Random, ask_antisymmetric, questions};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Construction, Off, Predicates, Question, Scene, Sign, Vertex};
use predicament_sos::{PerMesh, infinitesimal::judge_per_mesh};

fn moving(points: &[[f64; 3]], from: usize) -> Scene {
    let scene = Scene::from_points3(points).unwrap();
    scene.with_second_mesh((from..points.len()).map(Vertex::input))
}

/// Asks in all orders; the answer, if it is that of the polynomial.
fn agreed(session: &impl Predicates, question: Question, args: &[Vertex]) -> Sign {
    let scene = session.scene();
    let answer = ask_antisymmetric(session, question, args);
    assert_eq!(answer, judge_per_mesh(scene, question, args), "{question:?} of {args:?} in {scene:?}");
    answer
}

/// Two edges in one plane, of which the directions differ by one in the product of 53 bits each: the derivative of their side
/// by the axis across is 1 of 10^31, or zero.
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
    for _ in 0..predicament_effort::scaled(6_000) {
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
    assert!(ties > 50, "{ties}");
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
    assert!(ties > 30 && zeros > 50, "{ties} {zeros}");
}

/// The sign without any move.
fn unmoved(session: &impl Predicates, question: Question, args: &[Vertex]) -> Sign {
    let scene = session.scene().clone();
    question.ask(&Exact.prepare(&scene, Off).unwrap(), args)
}
