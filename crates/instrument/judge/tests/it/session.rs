//! Sessions of the judge: their signs equal those of its functions, and only zeros are passed to the tie rule.

use std::sync::{Arc, Mutex};

use predicament_judge::{Judged, TieJudge, sign};
use predicament_predicates::{Plane, Predicates, Question, Scene, Sign, Vertex};

use crate::random::{Grid, Random, effort};

/// All queries of four vertices of the plane in some orders.
fn queries(random: &mut Random) -> Vec<(Question, Vec<Vertex>)> {
    let mut order: Vec<usize> = (0..4).collect();
    let mut found = Vec::new();
    for _ in 0..4 {
        let (i, j) = (random.below(4), random.below(4));
        order.swap(i, j);
        let all: Vec<Vertex> = order.iter().map(|&v| Vertex::input(v)).collect();
        found.push((Question::Orient2d(Plane::Xy), all[..3].to_vec()));
        found.push((Question::Incircle, all));
    }
    found
}

fn asked(session: &impl Predicates, question: Question, args: &[Vertex]) -> Sign {
    match (question, args) {
        (Question::Orient2d(plane), &[a, b, c]) => session.orient2d(plane, a, b, c),
        (Question::Incircle, &[a, b, c, d]) => session.incircle(a, b, c, d),
        _ => unreachable!("{question:?}"),
    }
}

#[test]
fn sessions_answer_as_the_judge_does() {
    let mut random = Random::new(31);
    let mut of_signs = [0_usize; 3];
    for _ in 0..50 * effort() {
        let coordinates = Grid::Whole.coordinates(&mut random, 8, 3);
        let points: &[[f64; 2]] = coordinates.as_chunks().0;
        let scene = Scene::from_points2(points).unwrap();
        let zeros = Arc::new(Mutex::new(Vec::new()));
        let of_ties = Arc::clone(&zeros);
        // Not the sign of any perturbation, so that it is recognizable.
        let ties = move |scene: &Scene, question: Question, args: &[Vertex]| {
            assert_eq!(scene.len(), 4);
            of_ties.lock().unwrap().push((question, args.to_vec()));
            Sign::Negative
        };
        let ties: &TieJudge = &ties;
        let mut expected_zeros = Vec::new();
        for (question, args) in queries(&mut random) {
            let expected = sign(&scene, question, &args);
            of_signs[usize::from(expected != Sign::Zero) + usize::from(expected == Sign::Positive)] += 1;
            assert_eq!(asked(&Judged::exact(&scene), question, &args), expected);
            assert_eq!(asked(&Judged::again(&scene), question, &args), expected);
            let broken = if expected == Sign::Zero { Sign::Negative } else { expected };
            assert_eq!(asked(&Judged::perturbed(&scene, ties), question, &args), broken);
            if expected == Sign::Zero {
                expected_zeros.push((question, args));
            }
        }
        assert_eq!(*zeros.lock().unwrap(), expected_zeros);
    }
    assert!(of_signs.iter().all(|&count| count > 50), "{of_signs:?}");
}
