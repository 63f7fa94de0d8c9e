//! The session's statements about itself, and the scenes that the backend declines.

use predicament_predicates::{
    Axis, Backend, Construction, Contract, Counts, Declined, Off, Plane, PredicateKind, Predicates, Question, Scene,
    Sign, Vertex, ZeroMeaning,
};
use predicament_tolerance::circles::{incircle_band, insphere_band};
use predicament_tolerance::{Tolerance, Tolerances2d, Tolerances3d};

fn v<const N: usize>() -> [Vertex; N] {
    std::array::from_fn(Vertex::input)
}

fn declined(scene: &Scene) -> Option<Declined> {
    Tolerance.prepare(scene, Off).map(|_| ()).err()
}

#[test]
fn signs_follow_the_convention() {
    let scene = Scene::from_points2(&[[0., 0.], [1., 0.], [0., 1.]]).unwrap();
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let [a, b, c] = v();
    assert_eq!(session.orient2d(Plane::Xy, a, b, c), Sign::Positive);
    assert_eq!(session.orient2d(Plane::Xy, b, a, c), Sign::Negative);
    assert_eq!(session.orient2d(Plane::Xy, b, a, a), Sign::Zero);
    assert_eq!(session.compare(Axis::X, b, a), Sign::Positive);
    assert_eq!(session.estimate(Question::Orient2d(Plane::Xy), &[a, b, c]), Some(1.0));

    let scene = Scene::from_points2(&[[0., 0.], [1., 0.], [0., 1.], [1., 1.], [0.75, 0.75], [1., 1.5]]).unwrap();
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let [a, b, c, on, inside, outside] = v();
    assert_eq!(session.incircle(a, b, c, on), Sign::Zero);
    assert_eq!(session.incircle(a, b, c, inside), Sign::Positive);
    assert_eq!(session.incircle(a, c, b, inside), Sign::Negative);
    assert_eq!(session.incircle(a, b, c, outside), Sign::Negative);
    assert_eq!(session.estimate(Question::Incircle, &[a, b, c, inside]), Some(0.375));

    let points = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., -1.], [0.5, 0.5, -0.5], [1., 1., 1.]];
    let scene = Scene::from_points3(&points).unwrap();
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let [a, b, c, d, inside, outside] = v();
    assert_eq!(session.insphere(a, b, c, d, inside), Sign::Positive);
    assert_eq!(session.insphere(b, a, c, d, inside), Sign::Negative);
    assert_eq!(session.insphere(a, b, c, d, outside), Sign::Negative);
    assert_eq!(session.estimate(Question::Insphere, &[a, b, c, d, inside]), Some(0.75));
    assert_eq!(session.orient3d(a, b, c, d), Sign::Positive, "below is positive");
    assert_eq!(session.orient2d(Plane::Xy, a, b, c), Sign::Positive);
    assert_eq!(session.orient2d(Plane::Yz, a, c, d), Sign::Negative);
    assert_eq!(session.orient2d(Plane::Zx, a, d, b), Sign::Negative);
    assert_eq!(session.orient2d(Plane::Yz, a, b, c), Sign::Zero);
}

#[test]
fn length_is_the_largest_edge_of_the_box() {
    let scene = Scene::from_points2(&[[0., 0.], [3., 1.], [1., -1.]]).unwrap();
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let tolerances = Tolerances2d::from_length(3.0);
    assert_eq!(session.tolerances2d(Plane::Xy), Ok(&tolerances));
    assert_eq!(session.band(Question::Orient2d(Plane::Xy)), Some(tolerances.kappa));
    assert_eq!(session.band(Question::Incircle), Some(incircle_band(3.0)));
    assert_eq!(session.band(Question::Insphere), None);
    assert_eq!(session.reach(), tolerances.sigma.upper);

    let scene = Scene::from_points3(&[[0., 0., 0.], [2., 3., 5.]]).unwrap();
    let session = Tolerance.prepare(&scene, Off).unwrap();
    assert_eq!(session.band(Question::Orient3d), Some(Tolerances3d::from_length(5.0).xi));
    assert_eq!(session.band(Question::Insphere), Some(insphere_band(5.0)));
    assert_eq!(session.band(Question::Incircle), None);
    let [xy, yz, zx] = [Plane::Xy, Plane::Yz, Plane::Zx].map(|plane| session.tolerances2d(plane).unwrap().length);
    assert_eq!([xy, yz, zx], [3.0, 5.0, 5.0], "projections are scenes of their own");
    for (plane, length) in [(Plane::Xy, 3.0), (Plane::Yz, 5.0), (Plane::Zx, 5.0)] {
        assert_eq!(session.band(Question::Orient2d(plane)), Some(Tolerances2d::from_length(length).kappa));
    }
}

#[test]
fn each_dimension_has_its_predicates() {
    let flat = Scene::from_points2(&[[0., 0.], [1., 1.]]).unwrap();
    let session = Tolerance.prepare(&flat, Off).unwrap();
    let answers = PredicateKind::ALL.map(|kind| session.supports(kind).is_ok());
    assert_eq!(answers, [true, true, false, true, false]);
    assert!(session.tolerances2d(Plane::Yz).is_err());

    let deep = Scene::from_points3(&[[0., 0., 0.], [1., 1., 1.]]).unwrap();
    let session = Tolerance.prepare(&deep, Off).unwrap();
    let answers = PredicateKind::ALL.map(|kind| session.supports(kind).is_ok());
    assert_eq!(answers, [true, true, true, false, true]);
    assert!(session.supports(PredicateKind::Incircle).unwrap_err().reason.contains("2D scene"));
    for kind in PredicateKind::ALL {
        let zero = if kind == PredicateKind::Compare { ZeroMeaning::Exact } else { ZeroMeaning::Band };
        assert_eq!(Tolerance.contract(kind), Contract { zero, proved: true });
    }
}

#[test]
fn scenes_that_underflow_or_overflow_are_declined() {
    let wide = |x: f64| Scene::from_points2(&[[-x, 0.0], [x, x]]).unwrap();
    let deep = |x: f64| Scene::from_points3(&[[-x, 0.0, 0.0], [x, x, x]]).unwrap();
    for x in [f64::MAX, 1e155, 1e-150, 5e-324] {
        let reason = declined(&wide(x)).unwrap_or_else(|| panic!("{x:e} is out of range")).reason;
        assert!(reason.contains("L = "), "{reason}");
    }
    for x in [f64::MAX, 1e103, 1e-100, 5e-324] {
        assert!(declined(&deep(x)).is_some(), "{x:e} is out of range");
    }
    for x in [1e150, 1.0, 1e-140] {
        assert_eq!(declined(&wide(x)), None, "{x:e}");
    }
    for x in [1e100, 1.0, 1e-90] {
        assert_eq!(declined(&deep(x)), None, "{x:e}");
    }
    // the powers of L in incircle and insphere are higher, and only they are declined
    for (scene, kind, linear) in [
        (wide(1e80), PredicateKind::Incircle, PredicateKind::Orient2d),
        (wide(1e-80), PredicateKind::Incircle, PredicateKind::Orient2d),
        (deep(1e63), PredicateKind::Insphere, PredicateKind::Orient3d),
        (deep(1e-63), PredicateKind::Insphere, PredicateKind::Orient3d),
    ] {
        let session = Tolerance.prepare(&scene, Off).unwrap();
        assert!(session.supports(kind).unwrap_err().reason.contains("L = "), "{kind}");
        assert_eq!((session.supports(linear), session.band(Question::Incircle)), (Ok(()), None));
    }
    // two axes are too short for κ, and only orient2d is declined
    let needle = Scene::from_points3(&[[0., 0., 0.], [1e-200, 1e-200, 1.]]).unwrap();
    let session = Tolerance.prepare(&needle, Off).unwrap();
    assert!(session.supports(PredicateKind::Orient2d).is_err());
    assert_eq!(session.supports(PredicateKind::Orient3d), Ok(()));
}

#[test]
fn where_all_points_coincide_everything_is_degenerate() {
    let scene = Scene::from_points2(&[[7.5, -3.0]; 3]).unwrap();
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let [a, b, c] = v();
    assert_eq!(session.orient2d(Plane::Xy, a, b, c), Sign::Zero);
    assert_eq!(session.incircle(a, b, c, a), Sign::Zero);
    assert_eq!(session.reach(), 0.0);
    let empty = Scene::from_points3(&[]).unwrap();
    assert_eq!(declined(&empty), None);
}

#[test]
fn queries_are_counted() {
    let scene = Scene::from_points2(&[[0., 0.], [1., 0.], [0., 1.]]).unwrap();
    let counts = Counts::new();
    let session = Tolerance.prepare(&scene, &counts).unwrap();
    let [a, b, c] = v();
    session.orient2d(Plane::Xy, a, b, c);
    session.compare(Axis::Y, a, c);
    session.compare(Axis::Y, a, b);
    assert_eq!(Tolerance.stages(), ["float"]);
    assert_eq!(counts.get(PredicateKind::Orient2d, 0), 1);
    assert_eq!(counts.get(PredicateKind::Compare, 0), 2);
}

#[test]
fn scenes_with_constructed_vertices_are_declined() {
    let mut scene = Scene::from_points2(&[[0., 0.], [1., 1.], [0., 1.], [1., 0.]]).unwrap();
    assert_eq!(declined(&scene), None);
    let [a, b, c, d] = v();
    scene.construct(Construction::Ssi([[a, b], [c, d]])).unwrap();
    let declined = declined(&scene).expect("a constructed vertex has no coordinates to compute with");
    assert!(declined.predicate.is_none() && declined.reason.contains("constructed"), "{declined}");
}

#[test]
#[should_panic(expected = "needs a 2D scene")]
fn circles_of_space_are_not_answered() {
    let scene = Scene::from_points3(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 1.0]]).unwrap();
    let [a, b, c, d] = v();
    let _ = Tolerance.prepare(&scene, Off).unwrap().incircle(a, b, c, d);
}

#[test]
#[should_panic(expected = "needs a 3D scene")]
fn spheres_of_the_plane_are_not_answered() {
    let scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [0.5, 0.5]]).unwrap();
    let [a, b, c, d, e] = v();
    let _ = Tolerance.prepare(&scene, Off).unwrap().insphere(a, b, c, d, e);
}
