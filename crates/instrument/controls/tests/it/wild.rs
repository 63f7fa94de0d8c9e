//! The conventions of other crates, in ours: on points without ties nobody can tell them from exact.
#![cfg(feature = "peers")]

use predicament_controls::Shewchuk;
use predicament_controls::wild::{Axiolid, Delaunay, Geogram, Hyperlimit, Library, Point, Rgeometry, Simplicity, Wild};
use predicament_predicates::{
    Axis, Backend, Broken, Class, Dimension, Off, Plane, PredicateKind, Predicates, Question, Scene, Sign, Vertex,
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
    assert_eq!(asked(Axiolid), PredicateKind::ALL[1..]);
    assert_eq!(asked(Hyperlimit), PredicateKind::ALL);
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
    all_zero(Axiolid);
    all_zero(Hyperlimit);
    all_zero(Delaunay { sorted: false });
    all_zero(Delaunay { sorted: true });
}

#[test]
fn certified_zeros_are_those_of_degenerate_integers() {
    fn zeros<L: Library>(library: L) {
        let point = |x, y| Point { at: [x, y], key: 0 };
        let space = |x, y, z| Point { at: [x, y, z], key: 0 };
        let name = library.name();
        let square = [point(1., 0.), point(0., 1.), point(-1., 0.), point(0., -1.)];
        assert!(library.orient2d([point(0., 0.), point(1., 1.), point(3., 3.)]).is_zero(), "{name}");
        assert!(library.incircle(square).is_zero(), "{name}");
        let flat = [space(0., 0., 1.), space(5., 0., 1.), space(0., 7., 1.), space(3., 2., 1.)];
        assert!(library.orient3d(flat).is_zero(), "{name}");
        let [a, b, c, d] = square.map(|it| space(it.at[0], it.at[1], 0.));
        assert!(library.insphere([a, b, c, space(0., 0., -1.), d]).is_zero(), "{name}");
        assert_eq!(library.insphere([a, b, c, space(0., 0., -1.), space(0., 0., 0.)]), Sign::Positive, "{name}");
    }
    zeros(Axiolid);
    zeros(Hyperlimit);
}

/// What has no certificate is thrown as an answer that was declined. Scenes are finite, so
/// only a point from outside of any scene shows it.
#[test]
fn an_answer_without_a_certificate_is_declined_and_no_sign() {
    fn thrown(ask: impl FnOnce() -> Sign + std::panic::UnwindSafe) -> (Class, &'static str) {
        let payload = std::panic::catch_unwind(ask).expect_err("no sign");
        let broken = payload.downcast::<Broken>().expect("what sessions throw");
        (broken.class, broken.check)
    }
    let space = [0., 1., 2., f64::NAN].map(|x| Point { at: [x, x * x, 1.], key: 0 });
    assert_eq!(thrown(|| Axiolid.orient3d(space)), (Class::Declined, "certificate"));
    assert_eq!(thrown(|| Hyperlimit.orient3d(space)), (Class::Declined, "coordinates"));
    let line = [1., f64::INFINITY].map(|x| Point { at: [x], key: 0 });
    assert_eq!(thrown(|| Hyperlimit.compare(line)), (Class::Declined, "coordinates"));
}
