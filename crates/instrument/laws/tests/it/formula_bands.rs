//! Bands of formulas: by hand, by the backend's own derivation, and whatever a session claims.

use predicament_laws::published::{band, units};
use predicament_predicates::formula::{Definition, Formula};
use predicament_predicates::{
    Backend, Band, Derived, Off, PredicateKind, Predicates, Question, Scene, Sign, Vertex, forward_to,
};
use predicament_tolerance::{Tolerance, derived::error_bound};

fn derived(text: &str) -> Derived {
    Derived::new(Formula::new(Definition::anonymous(text)).unwrap_or_else(|error| panic!("{}", error.shown(text))))
        .unwrap()
}

/// A session of tolerances whose claimed bands are `factor` times as wide.
struct Claiming<P>(P, f64);

impl<P: Predicates> Predicates for Claiming<P> {
    forward_to!(0: scene, compare, orient2d, orient3d, incircle, insphere, sign);

    fn band(&self, question: Question) -> Option<Band> {
        let Band { lower, width, upper } = self.0.band(question)?;
        Some(Band { lower: self.1 * lower, width: self.1 * width, upper: self.1 * upper })
    }
}

/// The error of a difference is 1 ε and c is 1, of a square 3 and 1, of a sum of two squares 4 and 2.
#[test]
fn units_are_those_by_hand() {
    for (text, by_hand) in [
        // 4 (4 + 1), plus what is of second order, rounded up; and one step more.
        ("sq(a - p) - sq(b - p)", 22),
        // c = 1 and 1 + 1 + 1 for the product, 2 (3 + 1) for the difference of two.
        ("det(a - c, b - c)", 10),
        // The product of 1 by 2 is off by 1 + 2 + 1, so the sum of two is off by 4 (4 + 1).
        ("dot(b - a, (p - a) + (p - b))", 22),
        // Powers of two multiply without rounding.
        ("4 * det(a - c, b - c)", 34),
    ] {
        assert_eq!(units(derived(text)), Some(by_hand.into()), "{text}");
    }
}

#[test]
fn the_backend_derives_the_same_units() {
    let shipped = Derived::shipped().iter().copied();
    let others = [
        "det(a - d, b - d, c - d)",
        "det([a - d, sq(a - d)], [b - d, sq(b - d)], [c - d, sq(c - d)])",
        "det([a - e, sq(a - e)], [b - e, sq(b - e)], [c - e, sq(c - e)], [d - e, sq(d - e)])",
        "3 * sq(a - b)^3 - 5 * dot(a - c, b - c)^3",
        "sq(a - b) * (a.x - b.x) + 7 * (a.y - b.y) * sq(a - c)",
        "det(a, b)",
        "a.x + b.x - 2 * c.x",
        "sq(a - b) - (a.x - b.x)",
        "sq(a - b) - a.w + b.w",
    ];
    let mut by_calculus = 0;
    for derived in shipped.chain(others.map(derived)) {
        let backend = error_bound(derived).map(|(factor, _)| (factor + 1_u32).into());
        assert_eq!(units(derived), backend, "{}", derived.formula().text());
        by_calculus += usize::from(backend.is_some());
    }
    assert_eq!(by_calculus, 12, "the calculus is about differences of coordinates only");
}

/// A scene far from the origin, with weights.
fn far() -> Scene {
    let points = [[1e6, 2e6], [1e6 + 1.0, 2e6 + 0.25], [1e6 + 0.5, 2e6 - 1.0], [1e6 - 2.0, 2e6]];
    Scene::from_points2(&points).unwrap().with_weights(vec![0.5, 0.25, 0.125, 8.0]).unwrap()
}

#[test]
fn a_claim_does_not_move_the_band() {
    let scene = far();
    let formulas = Derived::shipped()
        .iter()
        .copied()
        .filter(|&derived| scene.has_dimension_for(PredicateKind::Derived(derived)).is_ok());
    for derived in formulas.chain([derived("det(a, b)")]) {
        let question = Question::Derived(derived);
        let of = |factor| band(&Claiming(Tolerance.prepare(&scene, Off).unwrap(), factor), question).unwrap();
        let (honest, claimed) = (of(1.0), Tolerance.prepare(&scene, Off).unwrap().band(question).unwrap());
        assert!(honest.lower <= claimed.lower * (1.0 + 1e-12), "{honest:?} {claimed:?}");
        assert!((1.0 - 1e-12..1.05).contains(&(honest.upper / claimed.upper)), "{honest:?} {claimed:?}");
        for factor in [1e-3, 2.5, 1e6, 2.0_f64.powi(32), 1e300] {
            assert_eq!(of(factor), honest, "{} claimed {factor} times as wide", derived.formula().name());
        }
        // A backend of single precision claims 2^29 times as much.
        let single = of(2.0_f64.powi(29));
        assert!((single.upper / honest.upper / 2.0_f64.powi(29) - 1.0).abs() < 1e-9);
    }
}

/// Signs beyond the band are right, far from the origin too, where L is small and products of coordinates are large.
#[test]
fn signs_outside_of_bands_are_right_far_from_the_origin() {
    let scene = far();
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let derived = derived("det(a, b)");
    session.supports(PredicateKind::Derived(derived)).unwrap();
    let limits = session.band(Question::Derived(derived)).unwrap();
    // The rounding of one product alone.
    assert!(limits.lower > 2e12 * f64::EPSILON / 2.0, "{limits:?}");
    let [a, b] = [0, 1].map(Vertex::input);
    assert_eq!(session.sign(derived, &[a, b]), Sign::Negative, "1e6 (2e6 + 1/4) − 2e6 (1e6 + 1) = −1.75e6");
}

/// A weight that single precision rounds is declined: the difference of two large weights would be wrong.
#[test]
fn weights_are_numbers_of_the_format() {
    let power = PredicateKind::Derived(Derived::named("side_of_power_circle").unwrap());
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    for (weight, is_single) in [(16_777_216.0, true), (16_777_217.0, false)] {
        let scene = Scene::from_points2(&points).unwrap().with_weights(vec![weight; 4]).unwrap();
        assert!(Tolerance.prepare(&scene, Off).unwrap().supports(power).is_ok());
        let single = Tolerance::<f32>::default();
        assert_eq!(single.prepare(&scene, Off).unwrap().supports(power).is_ok(), is_single, "{weight}");
    }
}
