//! Comparison of determinants with a limit: integers over one power of two, against rationals.

use predicament_judge::{is_within, rational, verdict};
use predicament_predicates::{Axis, Dimension, Plane, Question, Scene, Vertex};

use crate::random::{Random, effort};

/// All questions about scenes of this dimension.
fn questions(dimension: Dimension) -> Vec<Question> {
    match dimension {
        Dimension::Two => {
            vec![
                Question::Compare(Axis::X),
                Question::Compare(Axis::Y),
                Question::Orient2d(Plane::Xy),
                Question::Incircle,
            ]
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

#[test]
fn the_determinant_itself_is_the_least_limit() {
    let mut random = Random::new(17);
    let mut seen = [0; 2];
    for round in 0..40 * effort() {
        // Small integers times a power of two: determinants are doubles, over powers of two of all degrees.
        let unit = [1.0, 0.125, 32.0, f64::from_bits((1023 - 40) << 52)][round % 4];
        for dimension in [Dimension::Two, Dimension::Three] {
            // Five points.
            let count = if dimension == Dimension::Two { 10 } else { 15 };
            let scene = Scene::new(dimension, (0..count).map(|_| random.whole(7) * unit).collect()).unwrap();
            for question in questions(dimension) {
                let args: Vec<Vertex> = (0..question.kind().arity()).map(Vertex::input).collect();
                let size = verdict(&scene, question, &args).determinant.abs();
                let limit = size.to_f64();
                assert_eq!(rational(limit), size, "the test's own: a determinant that is a double");
                assert!(is_within(&scene, question, &args, limit), "{question:?} of {scene:?}");
                if limit > 0.0 {
                    assert!(!is_within(&scene, question, &args, limit.next_down()), "{question:?} of {scene:?}");
                    assert!(!is_within(&scene, question, &args, 0.0));
                }
                assert!(!is_within(&scene, question, &args, -1.0), "nothing is below zero");
                assert!(is_within(&scene, question, &args, f64::MAX));
                seen[usize::from(limit > 0.0)] += 1;
            }
        }
    }
    assert!(seen[0] > 10 && seen[1] > 200, "{seen:?}");
}
