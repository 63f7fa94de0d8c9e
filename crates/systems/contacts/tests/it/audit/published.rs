//! The published tolerances, compared with the numbers in the figures.

use predicament_contacts::checks::audit::{Published, Symbol};
use predicament_error_calculus::Enclosure;
use predicament_exact::Exact;
use predicament_laws::published::band;
use predicament_predicates::{Axis, Backend, Band, Dimension, Off, Plane, Predicates, Question, Scene, forward_to};
use rug::Rational;

use Dimension::{Three, Two};

/// A tolerance c ε^e L^p: its symbol, c of T₋, T and T₊, true if the last c is over √3, 4e, and p.
type Row = (Symbol, [f64; 3], bool, u32, u32);

const PLANE: [Row; 4] = [
    (Symbol::Sigma, [6.0, 6.5, 7.0], false, 2, 1),
    (Symbol::Tau, [4.0, 4.5, 5.0], false, 2, 1),
    (Symbol::SigmaHat, [5.0, 5.5, 6.0], false, 2, 1),
    (Symbol::Kappa, [10.0, 21.0, 32.0], false, 4, 2),
];

const SPACE: [Row; 12] = [
    (Symbol::Sigma, [6.0, 6.5, 7.0], false, 1, 1),
    (Symbol::Tau, [4.0, 4.5, 5.0], false, 1, 1),
    (Symbol::Delta, [2.0, 2.25, 2.5], false, 1, 1),
    (Symbol::Gamma, [2.0, 2.25, 2.5], false, 1, 1),
    (Symbol::SigmaHat, [5.0, 5.5, 6.0], false, 1, 1),
    (Symbol::Lambda, [910.0, 1215.0, 1521.0], false, 4, 4),
    (Symbol::Phi, [150.0, 470.0, 760.5], false, 4, 4),
    (Symbol::Nu, [3422.25, 6844.5, 10266.75], false, 4, 4),
    (Symbol::Zeta, [658.0, 1317.0, 1140.75], true, 4, 4),
    (Symbol::Mu, [16.0, 24.0, 32.0], false, 3, 3),
    (Symbol::Xi, [28.0, 56.0, 48.0], true, 3, 3),
    (Symbol::Rho, [28.0, 56.0, 48.0], true, 3, 3),
];

fn assert_close(found: f64, known: f64) {
    assert!((found / known - 1.0).abs() < 1e-12, "{found} for {known}");
}

#[test]
fn tolerances_are_those_of_the_figures() {
    for (dimension, rows) in [(Two, &PLANE[..]), (Three, &SPACE[..])] {
        // ε = 1/16, whose fourth root is 1/2, and L = 3.
        let published = Published::new(dimension, 4, &Enclosure::exact(3.into()));
        assert_eq!(published.dimension(), dimension);
        for &(symbol, numbers, is_root, quarters, power) in rows {
            let unit = Rational::from((9_u32.pow(power), 4_u32.pow(quarters)));
            let [lower, width, mut upper] = numbers.map(|c| Rational::from_f64(c).unwrap().square() * &unit);
            if is_root {
                upper *= 3;
            }
            let expected = [lower, width, upper];
            assert_eq!(*published.limits(symbol), expected, "{symbol:?}");
            let rounded = published.rounded(symbol);
            (0..3).for_each(|limit| assert_close(rounded[limit], expected[limit].to_f64().sqrt()));
        }
    }
}

#[test]
#[should_panic(expected = "δ is no tolerance of Two")]
fn the_plane_has_no_distance_from_triangles() {
    let _ = Published::new(Two, 4, &Enclosure::exact(3.into())).limits(Symbol::Delta);
}

#[test]
fn distances_have_tolerances_by_the_ranks() {
    let of = |dimension: Dimension| {
        let published = Published::new(dimension, 4, &Enclosure::exact(3.into()));
        [[0, 0], [1, 0], [1, 1], [2, 0], [2, 1], [3, 0]].map(|ranks| published.distance(ranks))
    };
    let [sigma, tau] = [Some(Symbol::Sigma), Some(Symbol::Tau)];
    assert_eq!(of(Two), [sigma, tau, None, None, None, None]);
    assert_eq!(of(Three), [sigma, tau, Some(Symbol::Gamma), Some(Symbol::Delta), None, None]);
}

#[test]
fn the_length_is_that_of_the_algorithms() {
    // ε = 2^-16: (1 + 5ε) / (1 − 7√ε) · 3 and (1 + 5ε) / (1 − 7ε^¼) · 3
    let sigma = |dimension| Published::for_lengths(dimension, [1.0, 2.0], 16).rounded(Symbol::Sigma)[0];
    assert_close(sigma(Two), 6.0 / 256.0 * (65_541.0 / 65_536.0) * (256.0 / 249.0) * 3.0);
    assert_close(sigma(Three), 6.0 / 16.0 * (65_541.0 / 65_536.0) * (16.0 / 9.0) * 3.0);
}

/// A session with exact answers that claims these bands.
struct Claiming<P> {
    inner: P,
    band: Option<Band>,
    contact: Option<Band>,
}

impl<P: Predicates> Predicates for Claiming<P> {
    forward_to!(inner: scene, compare, orient2d, orient3d, incircle, insphere);

    fn band(&self, _: Question) -> Option<Band> {
        self.band
    }

    fn contact_band(&self, _: [u8; 2]) -> Option<Band> {
        self.contact
    }
}

fn up_to(upper: f64) -> Option<Band> {
    Some(Band { lower: 0.0, width: 0.0, upper })
}

#[test]
fn contacts_are_held_to_the_precision_whose_claim_is_nearer() {
    let scene = |lengths: bool| {
        let scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0]]).unwrap();
        if lengths { scene.with_primitive_lengths([1.0, 2.0]) } else { scene }
    };
    let of = |scene: &Scene, contact: Option<Band>| {
        let inner = Exact.prepare(scene, Off).unwrap();
        Published::of(&Claiming { inner, band: None, contact }).map(|published| published.limits(Symbol::Tau).clone())
    };
    let [double, single] = [52, 23].map(|halvings| Published::for_lengths(Two, [1.0, 2.0], halvings));
    for (published, claims) in [(&double, [0.01, 0.7, 1.0, 50.0]), (&single, [0.05, 0.7, 1.0, 1e6])] {
        for claim in claims {
            let found = of(&scene(true), up_to(claim * published.rounded(Symbol::Sigma)[2]));
            assert_eq!(found.as_ref(), Some(published.limits(Symbol::Tau)), "{claim}");
        }
    }
    assert_eq!(of(&scene(true), None), None);
    assert_eq!(of(&scene(false), up_to(1.0)), None);
}

#[test]
fn signs_are_held_to_bands_of_their_own_extent() {
    // The lengths are 1 along x, 4 along y and 2 along z.
    let scene = Scene::from_points3(&[[-1.0, 3.0, 0.5], [0.0, -1.0, 2.5], [-0.5, 0.0, 1.0]]).unwrap();
    for (halvings, epsilon) in [(52, 2.0_f64.powi(-52)), (23, 2.0_f64.powi(-23))] {
        let three_quarters = epsilon.powf(0.75);
        let known = [
            (Question::Orient2d(Plane::Xy), [10.0, 21.0, 32.0], epsilon * 16.0),
            (Question::Orient2d(Plane::Yz), [10.0, 21.0, 32.0], epsilon * 16.0),
            (Question::Orient2d(Plane::Zx), [10.0, 21.0, 32.0], epsilon * 4.0),
            (Question::Orient3d, [28.0, 56.0, 48.0 * 3.0_f64.sqrt()], three_quarters * 64.0),
            (Question::Incircle, [130.0, 260.0, 390.0], epsilon * 256.0),
            (Question::Insphere, [1130.0, 2260.0, 3390.0], epsilon * 1024.0),
        ];
        for (question, numbers, unit) in known {
            for part in [0.5, 1.0, 2.0] {
                let inner = Exact.prepare(&scene, Off).unwrap();
                let session = Claiming { inner, band: up_to(part * numbers[2] * unit), contact: None };
                let found = band(&session, question).unwrap();
                let limits = [found.lower, found.width, found.upper];
                println!("2^-{halvings}, {question:?}");
                (0..3).for_each(|limit| assert_close(limits[limit], numbers[limit] * unit));
            }
        }
    }
    let silent = Claiming { inner: Exact.prepare(&scene, Off).unwrap(), band: None, contact: None };
    assert_eq!(band(&silent, Question::Orient3d), None);
    let session = Claiming { band: up_to(3.0), ..silent };
    assert_eq!(band(&session, Question::Compare(Axis::X)), up_to(3.0), "an order is held to what it claims");
}
