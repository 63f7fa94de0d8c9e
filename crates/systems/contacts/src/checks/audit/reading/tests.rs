//! Tests of the values that each algorithm compares, and of the outcomes at the limits of a tolerance.

use predicament_error_calculus::Enclosure;
use predicament_predicates::Dimension::{Three, Two};

use super::*;

const CORNER: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];

/// The tolerances for ε = 1/16 and this L.
fn published(dimension: Dimension, length: Rational) -> Published {
    Published::new(dimension, 4, &Enclosure::exact(length))
}

/// The squares that are compared with a tolerance. Coordinates are quarters, so that a lost or doubled power of two is
/// noticed.
fn compared<const D: usize>(first: &[[f64; D]], second: &[[f64; D]]) -> Vec<(Symbol, f64)> {
    let dimension = if D == 2 { Two } else { Three };
    let read = Readings::of(&published(dimension, 1.into()), &Pair::new(first, second));
    read.compared.iter().map(|(symbol, square)| (*symbol, square.value().to_f64())).collect()
}

fn all(symbol: Symbol, values: &[f64]) -> Vec<(Symbol, f64)> {
    values.iter().map(|value| (symbol, value * value)).collect()
}

#[test]
fn distances_and_lengths_are_compared_in_scene_units() {
    assert_eq!(compared(&[[0.25, 0.0]], &[[1.0, 1.0]]), all(Symbol::Sigma, &[1.25]));
    let edge = [all(Symbol::SigmaHat, &[4.0]), all(Symbol::Tau, &[0.25])].concat();
    assert_eq!(compared(&[[0.0, 0.0], [4.0, 0.0]], &[[1.0, 0.25]]), edge);
    assert_eq!(compared(&CORNER[..2], &[[1.0, 0.0, 0.25]]), edge);
    assert_eq!(compared(&[[1.0, 0.25]; 2], &[[1.0, 0.0]]), all(Symbol::SigmaHat, &[0.0]), "no division by it");
}

#[test]
fn areas_and_volumes_are_compared_in_scene_units() {
    let edges = compared(&[[0.0, 0.0], [4.0, 0.0]], &[[1.0, -0.25], [1.0, 1.75]]);
    assert_eq!(edges, all(Symbol::Kappa, &[2.0, 6.0, 1.0, 7.0]));
    let triangle = compared(&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]], &[[1.0, 1.25]]);
    assert_eq!(triangle, all(Symbol::Kappa, &[7.0, 4.0, 5.0]));
    let edge = compared(&CORNER[..3], &[[1.0, 2.5, -0.25], [1.0, 2.5, 1.75]]);
    assert_eq!(edge, [all(Symbol::Mu, &[4.0, 8.0, 20.0]), all(Symbol::Xi, &[4.0, 28.0])].concat());
    assert_eq!(compared(&CORNER, &[[1.0, 1.25, 1.25]]), all(Symbol::Rho, &[8.0, 16.0, 20.0, 20.0]));
}

#[test]
fn squared_areas_heights_and_weights_are_compared_in_scene_units() {
    let edges = compared(&CORNER[..2], &[[1.0, -1.5, 0.25], [1.0, 2.5, 0.25]]);
    let parts = all(Symbol::Phi, &[64.0, 96.0, 192.0, 160.0]);
    assert_eq!(edges, [all(Symbol::Lambda, &[256.0]), all(Symbol::Gamma, &[0.25]), parts].concat());
    let triangle = compared(&CORNER[..3], &[[1.0, 2.5, 0.25]]);
    let parts = all(Symbol::Zeta, &[32.0, 64.0, 160.0]);
    assert_eq!(triangle, [all(Symbol::Nu, &[256.0]), all(Symbol::Delta, &[0.25]), parts].concat());
    // Parallel edges and a triangle without area have no height; their weights are not positive.
    let parallel =
        Readings::of(&published(Three, 1.into()), &Pair::new(&CORNER[..2], &[[0.0, 1.0, 0.25], [1.0, 1.0, 0.25]]));
    assert_eq!(parallel.compared.iter().map(|(symbol, _)| *symbol).collect::<Vec<_>>(), [Symbol::Lambda]);
    assert_eq!(parallel.outcomes, [Outcome::Fails; 5]);
}

/// Outcomes of a value compared with σ, from 1.5 to 1.75, for tests that pass up to σ and beyond it.
#[test]
fn a_test_has_a_choice_between_the_limits_only() {
    let published = published(Two, 1.into());
    let outcome = |quarters: u32| {
        let mut all = Readings::default();
        let square = || Quantity { denominator: 16.into(), ..Quantity::integer(Integer::from(quarters * quarters), 0) };
        all.within(&published, Symbol::Sigma, square());
        all.beyond(&published, Symbol::Sigma, square());
        [all.outcomes[0], all.outcomes[1]]
    };
    assert_eq!(outcome(5), [Outcome::Passes, Outcome::Fails]);
    assert_eq!(outcome(6), [Outcome::Passes, Outcome::Fails]);
    assert_eq!(outcome(7), [Outcome::Either; 2]);
    assert_eq!(outcome(8), [Outcome::Fails, Outcome::Passes]);
    // Beyond, and positive: φ for ε = 1/16 and L = 1 is from 150/16 to 760.5/16, so 9.375 to 47.53.
    let published = self::published(Three, 1.into());
    let positive = |value: i32| {
        let mut all = Readings::default();
        all.positive(&published, Symbol::Phi, &value.into(), 2);
        (all.outcomes, all.compared.len())
    };
    assert_eq!(positive(2), (vec![Outcome::Fails], 1));
    assert_eq!(positive(3), (vec![Outcome::Either], 1), "12");
    assert_eq!(positive(12), (vec![Outcome::Passes], 1), "48");
    assert_eq!([positive(0), positive(-12)], [(vec![Outcome::Fails], 0), (vec![Outcome::Fails], 0)]);
}

#[test]
fn one_test_that_fails_decides_and_one_with_a_choice_leaves_it() {
    use Outcome::{Either, Fails, Passes};
    let expected = |outcomes: &[Outcome]| Readings { outcomes: outcomes.to_vec(), compared: vec![] }.expected();
    assert_eq!(expected(&[Passes, Passes]), Some(true));
    assert_eq!(expected(&[Passes, Either]), None);
    assert_eq!(expected(&[Either, Passes, Fails]), Some(false));
    assert_eq!(expected(&[Fails]), Some(false));
}

/// A vertex far along an edge, and beside its ends by 19 and 26 times εL in the plane, 31 and 42 times in space.
#[test]
fn the_sign_of_a_foot_is_certain_beyond_its_error_only() {
    // ε = 2^-40 and L = 2^11; the edge is so long that only a foot near an end is in doubt.
    let (halvings, length) = (40, Rational::from(1_u32 << 11));
    let unit = 2.0_f64.powi(11 - 40);
    for (dimension, errors) in [(Two, [19.0, 26.0]), (Three, [31.0, 42.0])] {
        let published = Published::new(dimension, halvings, &Enclosure::exact(length.clone()));
        let long = 1024.0 * published.rounded(Symbol::SigmaHat)[2];
        let long = 2.0_f64.powf(long.log2().ceil());
        let at = |along: f64| {
            let pair = match dimension {
                Two => Pair::new(&[[0.0, 0.0], [long, 0.0]], &[[along, 0.0]]),
                Three => Pair::new(&[[0.0; 3], [long, 0.0, 0.0]], &[[along, 0.0, 0.0]]),
            };
            Readings::of(&published, &pair).expected()
        };
        assert_eq!(at(long / 2.0), Some(true));
        let [from_start, from_end] = errors.map(|error| error * unit);
        assert_eq!([1.0, 0.5, -0.5, -1.0].map(|part| at(part * from_start)), [None; 4]);
        assert_eq!([1.0, 0.5, -0.5, -1.0].map(|part| at(long + part * from_end)), [None; 4]);
        let more = 1.0 + 1.0 / 1024.0;
        assert_eq!([more, -more].map(|part| at(part * from_start)), [Some(true), Some(false)]);
        assert_eq!([-more, more].map(|part| at(long + part * from_end)), [Some(true), Some(false)]);
    }
}

#[test]
fn signs_have_to_fit_whatever_the_sizes_are() {
    let published = published(Two, Rational::from((1, 64)));
    let crossing = |from: f64, to: f64| {
        Readings::of(&published, &Pair::new(&[[0.0, 0.0], [4.0, 0.0]], &[[1.0, from], [1.0, to]])).expected()
    };
    assert_eq!([crossing(-1.0, 1.0), crossing(1.0, -1.0)], [Some(true); 2]);
    assert_eq!([crossing(0.5, 1.0), crossing(-1.0, -0.5)], [Some(false); 2]);
    let inside = |x: f64, y: f64| {
        Readings::of(&published, &Pair::new(&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]], &[[x, y]])).expected()
    };
    assert_eq!([inside(1.0, 1.0), inside(-1.0, 1.0), inside(3.0, 3.0)], [Some(true), Some(false), Some(false)]);
    let signs = [(1, 1), (1, -1), (-1, 1), (-1, -1)].map(|(a, b)| (Integer::from(a), Integer::from(b)));
    assert_eq!(signs.each_ref().map(|(a, b)| same(a, b)), [true, false, false, true]);
    assert_eq!(signs.each_ref().map(|(a, b)| opposite(a, b)), [false, true, true, false]);
}

#[test]
fn a_hit_is_near_a_limit_and_says_on_which_side() {
    // σ is 1.5, 1.625 and 1.75: the middle value is 1/12 of the first and 1/14 of the last away from them.
    let published = published(Two, 1.into());
    let hits = |distance: f64, near: f64| {
        let read = Readings::of(&published, &Pair::new(&[[0.0, 0.0]], &[[distance, 0.0]]));
        read.hits(&published, near).map(|hit| (hit.symbol, hit.limit, hit.beyond)).collect::<Vec<_>>()
    };
    let [low, mid, high] = [(0, true), (1, false), (2, false)].map(|(limit, beyond)| (Symbol::Sigma, limit, beyond));
    assert_eq!(hits(1.625, 0.0), [mid]);
    assert_eq!(hits(1.625, 0.075), [mid, high]);
    assert_eq!(hits(1.625, 0.09), [low, mid, high]);
    assert_eq!(hits(3.0, 1.0), [(Symbol::Sigma, 0, true), (Symbol::Sigma, 1, true), (Symbol::Sigma, 2, true)]);
    assert_eq!(hits(3.0, 0.84), [(Symbol::Sigma, 2, true)]);
    assert_eq!(hits(9.0, 1.0), []);
}
