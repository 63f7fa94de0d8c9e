//! Tests of distances: the algorithm against the truth, and the truth against certificates of another kind.

use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

use predicament_distance::algorithm::nearest;
use predicament_distance::answer::{Feature, Kind, Nearest, Pair, describe};
use predicament_distance::task::TwoObjects;
use predicament_distance::truth::{Truth, measured};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Dimension, Off, Scene, Vertex};
use predicament_sos::Sos;
use predicament_tasks::Watch;
use predicament_tolerance::Tolerance;
use proptest::prelude::*;
use rug::Rational;

type Parts = Vec<Vec<usize>>;

fn scene(points: &[Vec<f64>], parts: [&Parts; 2]) -> (Scene, TwoObjects) {
    let dimension = if points[0].len() == 2 { Dimension::Two } else { Dimension::Three };
    let vertices = |parts: &Parts| {
        parts.iter().map(|part| part.iter().map(|&v| Vertex::input(v)).collect()).collect::<Vec<Vec<Vertex>>>()
    };
    (Scene::new(dimension, points.concat()).unwrap(), TwoObjects::new(dimension, parts.map(vertices)))
}

fn exactly(scene: &Scene, content: &TwoObjects) -> Nearest {
    nearest(&Exact.prepare(scene, Off).unwrap(), content.indexed(scene)).unwrap()
}

fn truth(scene: &Scene, content: &TwoObjects) -> Truth {
    Truth::new(scene, content.objects(), &Watch::new(&AtomicBool::new(false), None, &|_| {})).unwrap()
}

/// Two cubes of side 4, the second with its least corner at a place.
fn cubes(at: [f64; 3]) -> (Scene, TwoObjects) {
    let corner = |place: [f64; 3]| {
        move |v: usize| {
            (0..3).map(|axis| place[axis] + if v >> axis & 1 == 0 { 0.0 } else { 4.0 }).collect::<Vec<f64>>()
        }
    };
    let points: Vec<Vec<f64>> = (0..8).map(corner([0.0; 3])).chain((0..8).map(corner(at))).collect();
    let squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = |first: usize| {
        squares
            .iter()
            .flat_map(move |[a, b, c, d]| [[a, b, c], [a, c, d]].map(|t| t.map(|v| v + first).to_vec()))
            .collect()
    };
    scene(&points, [&triangles(0), &triangles(8)])
}

#[test]
fn cubes_are_apart_touch_cross_or_contain() {
    let told = |at: [f64; 3]| {
        let (scene, content) = cubes(at);
        let (found, known) = (exactly(&scene, &content), truth(&scene, &content));
        assert_eq!(found.kind, known.kind, "{at:?}");
        assert_eq!(found.pairs, known.pairs.into_iter().collect::<Vec<_>>(), "{at:?}");
        let sos = Sos::default();
        assert_eq!(nearest(&sos.prepare(&scene, Off).unwrap(), content.indexed(&scene)), Ok(found.clone()), "{at:?}");
        (found.kind, found.pairs.len())
    };
    // The diagonals of the facing squares are parallel.
    assert_eq!(told([5.0, 0.0, 0.0]), (Kind::Apart, 4));
    // Corners before a square, and an edge before an edge or a diagonal.
    assert_eq!(told([5.0, 1.0, 2.0]).0, Kind::Apart);
    assert_eq!(told([5.0, 6.0, 0.0]), (Kind::Apart, 2));
    assert_eq!(told([5.0, 6.0, 7.0]), (Kind::Apart, 1));
    assert_eq!(told([4.0, 4.0, 4.0]), (Kind::Touching, 1));
    assert_eq!(told([4.0, 4.0, 1.0]), (Kind::Touching, 2));
    assert_eq!(told([4.0, 0.0, 0.0]).0, Kind::Touching);
    assert_eq!(told([1.0, 2.0, 3.0]), (Kind::Crossing, 0));
    // The doubles before and after a contact.
    assert_eq!(told([4.0_f64.next_up(), 1.0, 1.0]).0, Kind::Apart);
    assert_eq!(told([4.0_f64.next_down(), 1.0, 1.0]).0, Kind::Crossing);
}

#[test]
fn a_tolerance_ties_what_is_near() {
    let (scene, content) = cubes([5.0, 6.0, 1e-13]);
    let tolerance = Tolerance::<f64>::default();
    let near = nearest(&tolerance.prepare(&scene, Off).unwrap(), content.indexed(&scene)).unwrap();
    let exact = exactly(&scene, &content);
    assert_eq!((exact.kind, exact.pairs.len()), (Kind::Apart, 2), "{}", describe(&exact.pairs));
    assert_ne!(near.pairs, exact.pairs, "the ends of the edges are within the band");
}

/// The least squared distance of two parts, and the pairs that attain it, each with a certificate.
///
/// All corners of the one part are behind the plane through its nearest point, across the difference of the points. All
/// corners of the other part are in front of the plane through the other point. Convex sets that a slab separates are
/// not nearer than the slab is wide.
fn certified(scene: &Scene, [one, other]: [&[Vertex]; 2]) -> Option<(Rational, BTreeSet<Pair>)> {
    let point = |v: Vertex| scene.point(v).iter().map(|&x| Rational::from_f64(x).unwrap()).collect::<Vec<_>>();
    let along = |p: &[Rational], q: &[Rational], way: &[Rational]| -> Rational {
        p.iter().zip(q).zip(way).map(|((x, y), way)| Rational::from(x - y) * way).sum()
    };
    let (mut least, mut pairs) = (None, BTreeSet::new());
    for first in Feature::closure(one) {
        for second in Feature::closure(other) {
            let Some(solved) = measured(scene, &[first, second]) else { continue };
            if first.rank() + second.rank() >= scene.dimension().count() {
                continue;
            }
            let [p, q] = &solved.points;
            let way: Vec<Rational> = q.iter().zip(p).map(|(x, y)| Rational::from(x - y)).collect();
            let is_apart = one.iter().all(|&v| along(&point(v), p, &way) <= 0)
                && other.iter().all(|&v| along(&point(v), q, &way) >= 0);
            if is_apart {
                assert!(least.as_ref().is_none_or(|least| *least == solved.squared), "two distances have certificates");
                least = Some(solved.squared);
                pairs.insert([first, second]);
            }
        }
    }
    least.map(|least| (least, pairs))
}

/// Compares algorithm and truth, and the truth with certificates where the boundaries do not cross.
fn agrees(scene: &Scene, content: &TwoObjects) {
    let (found, known) = (exactly(scene, content), truth(scene, content));
    assert_eq!(found.kind, known.kind, "{scene:?}");
    assert_eq!(describe(&found.pairs), describe(&known.pairs.iter().copied().collect::<Vec<_>>()), "{scene:?}");
    if matches!(known.kind, Kind::Crossing | Kind::Contained) {
        return;
    }
    let [first, second] = content.objects();
    let all = first.parts().flat_map(|one| second.parts().map(move |other| [one, other]));
    let certified: Vec<_> = all.map(|parts| certified(scene, parts).expect("a certificate")).collect();
    let least = certified.iter().map(|(squared, _)| squared).min().unwrap();
    assert_eq!(*least, known.squared);
    let pairs: BTreeSet<Pair> =
        certified.iter().filter(|(squared, _)| squared == least).flat_map(|(_, pairs)| pairs).copied().collect();
    assert_eq!(pairs, known.pairs);
}

#[test]
fn formulas_hold_at_all_scales() {
    for scale in [f64::from_bits(1 << 10), 2.0_f64.powi(-500), 1.0, 2.0_f64.powi(500), 2.0_f64.powi(1000)] {
        let points = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [1, 1, 2], [2, 5, 2], [5, 2, 3]];
        let points: Vec<Vec<f64>> = points.iter().map(|p| p.iter().map(|&x| f64::from(x) * scale).collect()).collect();
        let (scene, content) = scene(&points, [&vec![vec![0, 1, 2]], &vec![vec![3, 4, 5]]]);
        agrees(&scene, &content);
    }
}

/// Triangles with small coordinates as corners of their own, so that ties are common.
fn triangles(points: &[[i8; 3]], first: usize) -> Parts {
    let place = |p: &[i8; 3]| points.iter().position(|q| q == p).unwrap();
    let parts = points.chunks_exact(3).map(|t| t.iter().map(|p| first + place(p)).collect::<Vec<usize>>());
    parts.filter(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(2_000)))]

    #[test]
    fn pairs_in_space_are_those_of_the_truth(
        one in proptest::collection::vec([-2_i8..=2, -2_i8..=2, -2_i8..=2], 3..10),
        other in proptest::collection::vec([-2_i8..=2, -2_i8..=2, -2_i8..=2], 3..10),
        by in 0_i8..=6,
    ) {
        let moved: Vec<[i8; 3]> = other.iter().map(|&[x, y, z]| [x + by, y, z]).collect();
        let parts = [triangles(&one, 0), triangles(&moved, one.len())];
        if parts.iter().all(|parts| !parts.is_empty()) {
            let points: Vec<Vec<f64>> =
                one.iter().chain(&moved).map(|p| p.iter().map(|&x| f64::from(x)).collect()).collect();
            let (scene, content) = scene(&points, [&parts[0], &parts[1]]);
            agrees(&scene, &content);
        }
    }

    #[test]
    fn pairs_in_the_plane_are_those_of_the_truth(
        one in proptest::collection::vec([-3_i8..=3, -3_i8..=3], 3..7),
        other in proptest::collection::vec([-3_i8..=3, -3_i8..=3], 3..7),
        by in 0_i8..=7,
    ) {
        let points: Vec<Vec<f64>> = one
            .iter()
            .copied()
            .chain(other.iter().map(|&[x, y]| [x + by, y]))
            .map(|p| p.iter().map(|&x| f64::from(x)).collect())
            .collect();
        let rings = [(0..one.len()).collect::<Vec<_>>(), (one.len()..points.len()).collect()];
        let (scene, content) = scene(&points, [&vec![rings[0].clone()], &vec![rings[1].clone()]]);
        agrees(&scene, &content);
    }
}
