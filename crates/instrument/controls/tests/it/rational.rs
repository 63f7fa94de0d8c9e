//! The rational backend: signs by hand, constructed vertices, formulas, and its refusals.

use predicament_controls::ExactRational;
use predicament_predicates::{
    Axis, Backend, Construction, Counts, Derived, NoPoint, Off, Plane, PredicateKind, Predicates, Question, Refused,
    Scene, Sign, Vertex, ZeroMeaning,
};

fn v(index: usize) -> Vertex {
    Vertex::input(index)
}

/// The signs of a question about a scene's first vertices: as they are, with the first two exchanged, and after all
/// coordinates have been scaled by powers of two to both ends of the range of doubles.
fn signs(question: Question, scene: &Scene) -> [Sign; 4] {
    let ask = |scene: &Scene, args: &[Vertex]| question.ask(&ExactRational.prepare(scene, Off).unwrap(), args);
    let mut args: Vec<Vertex> = (0..question.kind().arity()).map(v).collect();
    let [plain, tiny, huge] = [0, -1060, 1000].map(|exponent| {
        let scaled =
            scene.coordinates().iter().map(|x| x * 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2));
        ask(&Scene::new(scene.dimension(), scaled.collect()).unwrap(), &args)
    });
    args.swap(0, 1);
    [plain, ask(scene, &args), tiny, huge]
}

/// Small integers whose determinants are computed by hand, as for the controls in doubles.
#[test]
fn signs_by_hand_hold_in_every_order_of_magnitude() {
    let plane = |points: &[[f64; 2]]| Scene::from_points2(points).unwrap();
    let space = |points: &[[f64; 3]]| Scene::from_points3(points).unwrap();
    let below = [[0.0, 0.0, 0.0], [3.0, 0.0, 1.0], [0.0, 2.0, 1.0], [1.0, 1.0, -4.0]];
    let sphere = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, -4.0], [1.0, 1.0, -1.0]];
    for (question, scene) in [
        (Question::Compare(Axis::Y), plane(&[[0.0, 3.0], [2.0, 1.0]])),
        (Question::Orient2d(Plane::Xy), plane(&[[0.0, 0.0], [2.0, 1.0], [1.0, 3.0]])),
        (Question::Orient2d(Plane::Yz), space(&[[9.0, 0.0, 0.0], [8.0, 2.0, 1.0], [7.0, 1.0, 3.0]])),
        (Question::Orient2d(Plane::Zx), space(&[[0.0, 9.0, 0.0], [1.0, 8.0, 2.0], [3.0, 7.0, 1.0]])),
        (Question::Orient3d, space(&below)),
        (Question::Incircle, plane(&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0]])),
        (Question::Insphere, space(&sphere)),
    ] {
        let expected = [Sign::Positive, Sign::Negative, Sign::Positive, Sign::Positive];
        assert_eq!(signs(question, &scene), expected, "{question:?}");
    }
    let touching = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [4.0, 4.0]];
    assert_eq!(signs(Question::Incircle, &plane(&touching)), [Sign::Zero; 4]);
}

#[test]
fn it_introduces_itself_and_promises_what_exact_promises() {
    assert_eq!(ExactRational.name(), "exact:rational");
    assert_eq!(ExactRational.stages(), ["rational"]);
    let scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
    for kind in PredicateKind::ALL {
        let contract = ExactRational.contract(kind);
        assert!(contract.proved && contract.zero == ZeroMeaning::Exact);
    }
    let counts = Counts::new();
    let session = ExactRational.prepare(&scene, &counts).unwrap();
    assert_eq!(session.orient2d(Plane::Xy, v(0), v(1), v(2)), Sign::Positive);
    assert_eq!(counts.get(PredicateKind::Orient2d, 0), 1);
    assert!(session.supports(PredicateKind::Orient3d).is_err());
    assert!(session.unperturbed().is_some());
}

/// A third is not a double: only a kept point is on both of its lines, at every level.
#[test]
fn constructed_points_are_kept_at_every_level() {
    let points = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.0], [2.0, 0.0], [2.0, 5.0]];
    let scene = Scene::from_points2(&points).unwrap();
    let mut session = ExactRational.prepare(&scene, Off).unwrap();
    let third = session.construct(&[Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])]).unwrap()[0];
    let next = session.construct(&[Construction::Ssi([[third, v(2)], [v(1), v(4)]])]).unwrap()[0];
    for [a, b] in [[v(0), v(1)], [v(2), v(3)]] {
        assert_eq!(session.orient2d(Plane::Xy, a, b, third), Sign::Zero);
    }
    for [a, b] in [[third, v(2)], [v(1), v(4)]] {
        assert_eq!(session.orient2d(Plane::Xy, a, b, next), Sign::Zero);
    }
    // On a circle through itself, and inside the circle over the diagonal from (0, 0) to (2, 5).
    assert_eq!(session.incircle(v(0), third, v(1), third), Sign::Zero);
    assert_eq!(session.incircle(v(0), v(4), v(5), third), Sign::Positive);
    let before = session.scene().clone();
    let refused = session.construct(&[Construction::Ssi([[v(0), v(5)], [v(1), v(3)]]), parallel([[0, 2], [4, 5]])]);
    let Err(Refused::Definition { index: 1, reason, .. }) = refused else { panic!("{refused:?}") };
    assert_eq!(reason, NoPoint::ParallelLines.into());
    assert_eq!(*session.scene(), before, "all or nothing");
    let mut parallels = scene;
    parallels.construct(parallel([[0, 2], [4, 5]])).unwrap();
    let declined = ExactRational.prepare(&parallels, Off).err().unwrap().to_string();
    assert!(declined.contains("c0") && declined.contains("parallel"), "{declined}");
}

fn parallel(lines: [[usize; 2]; 2]) -> Construction {
    Construction::Ssi(lines.map(|line| line.map(v)))
}

/// Every shipped formula has the sign that the exact arithmetic of its program finds, weights included.
#[test]
fn formulas_are_evaluated_operation_by_operation() {
    let (mut seen, mut state) = ([0; 3], 0x9e37_79b9_7f4a_7c15_u64);
    for &derived in Derived::shipped() {
        for _ in 0..40 {
            let mut number = || {
                state ^= state << 13;
                state ^= state >> 7;
                state ^= state << 17;
                // Few values, so that zeros occur.
                f64::from(u32::try_from(state >> 20 & 3).unwrap()) * 0.1
            };
            let count = derived.arity() * derived.dimension().count();
            let scene = Scene::new(derived.dimension(), (0..count).map(|_| number()).collect()).unwrap();
            let scene = scene.with_weights((0..derived.arity()).map(|_| number()).collect()).unwrap();
            let args: Vec<Vertex> = (0..derived.arity()).map(v).collect();
            let expected: Sign =
                derived.with_points(&scene, &args, |points| derived.formula().unfiltered(points).0).into();
            let session = ExactRational.prepare(&scene, Off).unwrap();
            session.supports(PredicateKind::Derived(derived)).unwrap();
            assert_eq!(session.sign(derived, &args), expected, "{} in {scene:?}", derived.name());
            seen[usize::try_from(expected as i8 + 1).unwrap()] += 1;
        }
    }
    assert!(seen.iter().all(|&count| count > 20), "{seen:?}");
}
