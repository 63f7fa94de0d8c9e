//! Delaunay triangulations by contradictory signs: bounded steps, no panic.

use predicament_delaunay::algorithm::{constrained_delaunay2d, delaunay2d, delaunay2d_in_order, delaunay2d_in_strips};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use proptest::prelude::*;

use crate::common::liar::{Liar, Slip};

/// True if an invariant was found broken, by insertion or by removals after it.
fn is_seen(session: &mut dyn Predicates) -> bool {
    let n = session.scene().len();
    let scene = session.scene().clone();
    let found = delaunay2d(&*session).answer();
    assert!(found.triangles.len() <= 2 * scene.len() && found.chain.len() <= scene.len());
    let joined = delaunay2d_in_strips(&*session, 3).answer();
    assert!(joined.triangles.len() <= 2 * scene.len());
    let half: Vec<Vertex> = scene.vertices().step_by(2).collect();
    let mut triangulation = delaunay2d_in_order(&*session, &half);
    for v in scene.vertices().step_by(3) {
        // Some vertices are there, some are not, and some cannot be removed.
        let _ = triangulation.remove(&*session, v);
        let _ = triangulation.insert(&*session, v);
    }
    triangulation.cut_faces();
    // Sessions that lie do not construct crossings: constraints that cross are refused.
    let constraints: Vec<[Vertex; 2]> = scene
        .vertices()
        .zip(scene.vertices().skip(scene.len() / 2))
        .map(|(a, b)| [a, b])
        .filter(|[a, b]| a != b)
        .take(9)
        .collect();
    let laid = constrained_delaunay2d(session, &constraints);
    assert!(laid.is_err() || laid.is_ok_and(|laid| laid.count() <= 2 * n));
    found.broken.is_some() || triangulation.answer().broken.is_some()
}

fn random(n: usize, seed: u64) -> Scene {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u16::try_from(state >> 48).expect("16 bits"))
    };
    Scene::from_points2(&(0..n).map(|_| [next(), next()]).collect::<Vec<_>>()).unwrap()
}

#[test]
fn broken_invariants_are_seen() {
    let scene = random(200, 1);
    let seen = (0..40).filter(|&seed| is_seen(&mut Liar { scene: &scene, seed, zeros: 1 << 40 })).count();
    assert!(seen > 20, "{seen} of 40");
}

#[test]
fn the_infinite_vertex_is_never_asked_about() {
    // Removals after wrong signs, when the hull is two cycles.
    let (n, seed, odds) = (11, 1_144_129_034_227_626_238, 98);
    let scene = random(n, seed);
    let honest = Exact.prepare(&scene, Off).unwrap();
    // It ends, and its assertions hold.
    is_seen(&mut Slip { honest: &honest, liar: Liar { scene: &scene, seed, zeros: 5 }, odds });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(3000)))]

    #[test]
    fn any_signs_end(n in 0_usize..200, seed: u64, zeros in 1_u64..50) {
        let scene = random(n, seed);
        is_seen(&mut Liar { scene: &scene, seed, zeros });
    }

    #[test]
    fn a_few_wrong_signs_end(n in 4_usize..200, seed: u64, odds in 10_u64..1000) {
        let scene = random(n, seed);
        let honest = Exact.prepare(&scene, Off).unwrap();
        is_seen(&mut Slip { honest: &honest, liar: Liar { scene: &scene, seed, zeros: 5 }, odds });
    }
}
