//! The triangulation by `sos`, held to a judge in rationals; plain doubles fail.

use std::collections::BTreeMap;

use predicament_controls::Naive;
use predicament_exact::Exact;
use predicament_judge as judge;
use predicament_predicates::{Backend, Derived, Off, Plane, Question, Scene, Sign, Vertex};
use predicament_sos::Sos;
use regular::triangles;

/// A small generator for reproducible scenes.
fn numbers(seed: u64) -> impl FnMut(u32) -> f64 {
    let mut state = seed;
    move |bound| {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        f64::from(u32::try_from(state >> 33).unwrap_or(0) % bound)
    }
}

/// Points on a grid with small whole weights: most power tests are close, and many are ties.
fn grid(seed: u64) -> Scene {
    let mut next = numbers(seed);
    let mut points: Vec<[f64; 2]> = (0..60).map(|_| [next(9), next(9)]).collect();
    points.sort_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
    points.dedup();
    let weights = points.iter().map(|_| next(5)).collect();
    Scene::from_points2(&points).unwrap().with_weights(weights).unwrap()
}

/// Points a few units in the last place apart, and two far ones on nearly one line with them: doubles turn the wrong
/// way (Kettner et al. 2008).
fn near(seed: u64) -> Scene {
    let mut next = numbers(seed);
    let mut coordinate = || 0.5 + next(24) * f64::EPSILON / 2.0;
    let mut points: Vec<[f64; 2]> = (0..24).map(|_| [coordinate(), coordinate()]).collect();
    points.sort_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
    points.dedup();
    points.extend([[12.0, 12.0], [24.0, 24.0]]);
    let weights = points.iter().map(|_| next(9) / 1024.0).collect();
    Scene::from_points2(&points).unwrap().with_weights(weights).unwrap()
}

/// The problems of a triangulation, by exact signs: turned triangles, conflicts, edges that do not match, holes.
fn problems(scene: &Scene, triangles: &[[Vertex; 3]]) -> Vec<String> {
    let power = Question::Derived(Derived::named("side_of_power_circle").unwrap());
    let mut problems = Vec::new();
    let mut edges: BTreeMap<[Vertex; 2], i32> = BTreeMap::new();
    for &[a, b, c] in triangles {
        if judge::sign(scene, Question::Orient2d(Plane::Xy), &[a, b, c]) == Sign::Negative {
            problems.push(format!("{a} {b} {c} turns right"));
        }
        let conflicts =
            |&d: &Vertex| ![a, b, c].contains(&d) && judge::sign(scene, power, &[a, b, c, d]) == Sign::Positive;
        problems.extend(scene.vertices().find(conflicts).map(|d| format!("{d} conflicts with {a} {b} {c}")));
        for [from, to] in [[a, b], [b, c], [c, a]] {
            *edges.entry([from, to]).or_default() += 1;
        }
    }
    problems.extend(edges.iter().filter(|(_, count)| **count > 1).map(|([a, b], _)| format!("{a} {b} is there twice")));
    // Edges without a partner are those of the hull: every vertex is left of them, or on them.
    for &[a, b] in edges.keys().filter(|[a, b]| !edges.contains_key(&[*b, *a])) {
        let is_right = |&d: &Vertex| judge::sign(scene, Question::Orient2d(Plane::Xy), &[a, b, d]) == Sign::Negative;
        problems.extend(scene.vertices().find(is_right).map(|d| format!("{d} is outside of {a} {b}")));
    }
    if triangles.is_empty() {
        problems.push("there is no triangle".to_owned());
    }
    problems
}

#[test]
fn sos_finds_the_weighted_delaunay_triangulation() {
    let mut hidden = 0;
    for seed in 0..12 {
        for scene in [grid(seed), near(seed)] {
            let sos = Sos::default();
            let found = triangles(&sos.prepare(&scene, Off).unwrap()).unwrap();
            assert_eq!(problems(&scene, &found), [""; 0], "{scene:?}");
            let used: std::collections::BTreeSet<Vertex> = found.iter().flatten().copied().collect();
            hidden += scene.len() - used.len();
        }
    }
    assert!(hidden > 20, "weights hide vertices: {hidden}");
}

/// Without weights it is a Delaunay triangulation, by the circle test as well.
#[test]
fn equal_weights_give_a_delaunay_triangulation() {
    let scene = grid(3);
    let scene =
        Scene::from_points2(scene.coordinates().as_chunks().0).unwrap().with_weights(vec![2.0; scene.len()]).unwrap();
    let found = triangles(&Sos::default().prepare(&scene, Off).unwrap()).unwrap();
    for &[a, b, c] in &found {
        let inside = |&d: &Vertex| judge::sign(&scene, Question::Incircle, &[a, b, c, d]) == Sign::Positive;
        assert_eq!(scene.vertices().find(|d| ![a, b, c].contains(d) && inside(d)), None);
    }
}

/// The checks can fail: rounded signs, and exact zeros, do not give a triangulation on these scenes.
#[test]
fn other_signs_are_not_enough() {
    let wrong = |scene: &Scene, found: Result<Vec<[Vertex; 3]>, regular::Undone>| {
        found.map_or(true, |found| !problems(scene, &found).is_empty())
    };
    let naive = (0..12).filter(|&seed| {
        let scene = near(seed);
        wrong(&scene, triangles(&Naive::default().prepare(&scene, Off).unwrap()))
    });
    assert!(naive.count() > 0, "plain doubles");
    let exact = (0..12).filter(|&seed| {
        let scene = grid(seed);
        wrong(&scene, triangles(&Exact.prepare(&scene, Off).unwrap()))
    });
    assert!(exact.count() > 0, "ties that stay");
}
