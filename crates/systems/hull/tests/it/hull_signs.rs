//! Convex hulls by contradictory signs: bounded steps, no panic.

use predicament_exact::Exact;
use predicament_hull::algorithm::{PlaneMethod, SpaceMethod, hull2d, hull3d};
use predicament_predicates::{Backend, Dimension, Off, Predicates, Scene};
use proptest::prelude::*;

use crate::common::liar::{Liar, Slip};

/// True if any method found a broken invariant.
fn is_seen(session: &dyn Predicates) -> bool {
    let n = session.scene().len();
    match session.scene().dimension() {
        Dimension::Two => [PlaneMethod::Chain, PlaneMethod::Divide].into_iter().any(|method| {
            let hull = hull2d(session, method);
            assert!(hull.vertices.len() <= 2 * n);
            hull.broken.is_some()
        }),
        Dimension::Three => [SpaceMethod::Incremental, SpaceMethod::Divide].into_iter().any(|method| {
            let hull = hull3d(session, method);
            assert!(hull.vertices.len() <= n && hull.faces.len() <= 2 * n);
            hull.broken.is_some()
        }),
    }
}

fn random(dimension: Dimension, n: usize, seed: u64) -> Scene {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u16::try_from(state >> 48).expect("16 bits"))
    };
    Scene::new(dimension, (0..n * dimension.count()).map(|_| next()).collect()).unwrap()
}

#[test]
fn broken_invariants_are_seen() {
    let scene = random(Dimension::Three, 200, 1);
    let seen = (0..40).filter(|&seed| is_seen(&Liar { scene: &scene, seed, zeros: 1 << 40 })).count();
    assert!(seen > 20, "{seen} of 40");
    let scene = random(Dimension::Two, 200, 1);
    let seen = (0..40).filter(|&seed| is_seen(&Liar { scene: &scene, seed, zeros: 1 << 40 })).count();
    assert!(seen > 5, "{seen} of 40");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(4000)))]

    #[test]
    fn any_signs_end(n in 0_usize..300, seed: u64, zeros in 1_u64..50, space: bool) {
        let scene = random(if space { Dimension::Three } else { Dimension::Two }, n, seed);
        is_seen(&Liar { scene: &scene, seed, zeros });
    }

    #[test]
    fn a_few_wrong_signs_end(n in 4_usize..300, seed: u64, odds in 10_u64..1000, space: bool) {
        let scene = random(if space { Dimension::Three } else { Dimension::Two }, n, seed);
        let honest = Exact.prepare(&scene, Off).unwrap();
        is_seen(&Slip { honest: &honest, liar: Liar { scene: &scene, seed, zeros: 5 }, odds });
    }
}
