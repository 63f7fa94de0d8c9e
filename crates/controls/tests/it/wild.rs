//! The conventions of other crates, in ours: on points without ties nobody can tell them from exact.
#![cfg(feature = "peers")]

use predicament_controls::Shewchuk;
use predicament_controls::wild::{Delaunay, Geogram, Library, Rgeometry, Simplicity, Wild};
use predicament_predicates::{
    Axis, Backend, Dimension, Off, Plane, PredicateKind, Predicates, Question, Scene, Vertex,
};

/// Twelve points whose coordinates are all different, small integers.
fn scene(dimension: Dimension) -> Scene {
    let d = dimension.count();
    let coordinates = (0..12 * d).map(|i| f64::from(u32::try_from(i * i * 37 % 509).unwrap()) - 250.0).collect();
    Scene::new(dimension, coordinates).unwrap()
}

fn agrees<L: Library>(library: L, dimension: Dimension, asked: &mut Vec<PredicateKind>) {
    let scene = scene(dimension);
    let backend = Wild(library);
    let session = backend.prepare(&scene, Off).unwrap();
    let truth = Shewchuk.prepare(&scene, Off).unwrap();
    let questions: &[Question] = match dimension {
        Dimension::Two => &[Question::Compare(Axis::Y), Question::Orient2d(Plane::Xy), Question::Incircle],
        Dimension::Three => &[
            Question::Compare(Axis::Z),
            Question::Orient2d(Plane::Yz),
            Question::Orient2d(Plane::Zx),
            Question::Orient3d,
            Question::Insphere,
        ],
    };
    for &question in questions.iter().filter(|question| session.supports(question.kind()).is_ok()) {
        asked.push(question.kind());
        for start in 0..12_usize {
            for step in [1, 5, 7, 11] {
                let args: Vec<Vertex> =
                    (0..question.kind().arity()).map(|at| Vertex::input((start + at * step) % 12)).collect();
                let expected = question.ask(&truth, &args);
                assert!(!expected.is_zero(), "no tie: {}", question.query(&args));
                assert_eq!(question.ask(&session, &args), expected, "{} {}", library.name(), question.query(&args));
            }
        }
    }
}

fn asked<L: Library>(library: L) -> Vec<PredicateKind> {
    let mut asked = Vec::new();
    [Dimension::Two, Dimension::Three].into_iter().for_each(|dimension| agrees(library, dimension, &mut asked));
    asked.sort_unstable();
    asked.dedup();
    asked
}

#[test]
fn signs_are_in_our_orientation_where_nothing_is_degenerate() {
    assert_eq!(asked(Simplicity), PredicateKind::ALL);
    assert_eq!(asked(Geogram), PredicateKind::ALL[1..]);
    assert_eq!(asked(Rgeometry), [PredicateKind::Orient2d]);
    for sorted in [false, true] {
        assert_eq!(asked(Delaunay { sorted }), PredicateKind::ALL[1..]);
    }
}

#[test]
fn a_vertex_twice_is_a_zero_and_no_panic() {
    fn all_zero<L: Library>(library: L) {
        let scene = scene(Dimension::Two);
        let backend = Wild(library);
        let session = backend.prepare(&scene, Off).unwrap();
        for question in [Question::Orient2d(Plane::Xy), Question::Incircle] {
            let args: Vec<Vertex> = [0, 3, 0, 5][..question.kind().arity()].iter().map(|&v| Vertex::input(v)).collect();
            if session.supports(question.kind()).is_ok() {
                assert!(question.ask(&session, &args).is_zero(), "{} {question:?}", library.name());
            }
        }
    }
    all_zero(Simplicity);
    all_zero(Geogram);
    all_zero(Rgeometry);
    all_zero(Delaunay { sorted: false });
    all_zero(Delaunay { sorted: true });
}
