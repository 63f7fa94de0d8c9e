//! Tests of the flaws of two triangles, by hand-made pairs and by clipping in rationals.

use std::sync::Arc;

use predicament_exact::Exact;
use predicament_judge::rational;
use predicament_mesh_intersect::algorithm::limit::limit;
use predicament_mesh_intersect::algorithm::overlay::{Zeros, mesh_overlay};
use predicament_mesh_intersect::algorithm::rounding::flaws::{Flaw, Flaws, flaw, flaws};
use predicament_mesh_intersect::algorithm::rounding::{Counts, Rounded, rounded};
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Backend, Off, Plane, Predicates, Scene, Sign, Vertex};
use predicament_sos::PerMesh;

use crate::common::shapes::{Random, Shape};
use crate::common::touching::{improper, is_proper};

const FIRST: [u32; 3] = [0, 1, 2];

/// The flaw of the triangle of the first three points and another triangle, in either order.
fn found(points: &[[f64; 3]], second: [u32; 3]) -> Option<Flaw> {
    let scene = Scene::from_points3(points).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    let found = flaw(&session, FIRST, second);
    assert_eq!(found, flaw(&session, second, FIRST), "{points:?} {second:?}");
    let [a, b, c] = second;
    assert_eq!(found, flaw(&session, [1, 2, 0], [c, b, a]), "{points:?} {second:?}");
    found
}

/// The triangle (0, 0), (4, 0), (0, 4) of the plane z = 0, and more points.
fn with(more: &[[f64; 3]]) -> Vec<[f64; 3]> {
    [&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]], more].concat()
}

#[test]
fn triangles_with_a_common_edge_fold_in_their_plane_only() {
    let apex = |p: [f64; 3]| found(&with(&[p]), [1, 0, 3]);
    assert_eq!(apex([1.0, -1.0, 0.0]), None, "beside each other");
    assert_eq!(apex([1.0, 1.0, 0.0]), Some(Flaw::Fold), "inside");
    assert_eq!(apex([9.0, 1.0, 0.0]), Some(Flaw::Fold), "beyond, on the same side");
    assert_eq!(apex([1.0, 1.0, 1.0]), None, "over it");
    assert_eq!(apex([1.0, -1.0, 1.0]), None);
    assert_eq!(found(&with(&[]), [2, 1, 0]), Some(Flaw::Fold), "the same corners");
}

#[test]
fn triangles_with_a_common_corner_cross_beyond_it() {
    let others = |p: [f64; 3], q: [f64; 3]| found(&with(&[p, q]), [0, 3, 4]);
    assert_eq!(others([-1.0, -2.0, 0.0], [-2.0, -1.0, 0.0]), None, "in one plane, apart");
    assert_eq!(others([-1.0, 1.0, 0.0], [-1.0, -1.0, 0.0]), None);
    assert_eq!(others([1.0, 2.0, 0.0], [-1.0, 2.0, 0.0]), Some(Flaw::Crossing), "in one plane, an edge goes in");
    assert_eq!(others([9.0, 9.0, 0.0], [9.0, 8.0, 0.0]), Some(Flaw::Crossing), "in one plane, through it");
    assert_eq!(others([-1.0, 9.0, 0.0], [9.0, -1.0, 0.0]), Some(Flaw::Crossing), "in one plane, around it");
    assert_eq!(others([2.0, 0.0, 0.0], [1.0, -3.0, 0.0]), Some(Flaw::Crossing), "in one plane, along an edge");
    assert_eq!(others([2.0, 0.0, 0.0], [1.0, 1.0, 3.0]), Some(Flaw::Crossing), "along an edge");
    assert_eq!(others([1.0, 1.0, 1.0], [1.0, 1.0, -1.0]), Some(Flaw::Crossing), "through it");
    assert_eq!(others([9.0, 9.0, 1.0], [9.0, 9.0, -1.0]), Some(Flaw::Crossing), "through it, and farther");
    assert_eq!(others([1.0, 1.0, 0.0], [1.0, 1.0, 3.0]), Some(Flaw::Crossing), "a corner on it");
    assert_eq!(others([1.0, 1.0, 1.0], [2.0, 1.0, 1.0]), None, "over it");
    assert_eq!(others([-1.0, -1.0, 1.0], [-1.0, -1.0, -1.0]), None, "through the plane, beside it");
}

#[test]
fn triangles_without_a_common_corner_are_apart_or_cross() {
    let others = |p: [f64; 3], q: [f64; 3], r: [f64; 3]| found(&with(&[p, q, r]), [3, 4, 5]);
    assert_eq!(others([1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [9.0, 9.0, 1.0]), Some(Flaw::Crossing), "an edge through it");
    assert_eq!(others([2.0, -1.0, 1.0], [2.0, -1.0, -1.0], [2.0, 9.0, 0.0]), Some(Flaw::Crossing));
    assert_eq!(others([1.0, 1.0, 0.0], [1.0, 2.0, 1.0], [2.0, 1.0, 1.0]), Some(Flaw::Crossing), "a corner on it");
    assert_eq!(others([2.0, 0.0, 0.0], [2.0, -1.0, 1.0], [3.0, -1.0, 1.0]), Some(Flaw::Crossing), "on its edge");
    assert_eq!(others([4.0, 0.0, 0.0], [5.0, 0.0, 1.0], [5.0, 1.0, 1.0]), Some(Flaw::Crossing), "corner on corner");
    assert_eq!(others([1.0, 1.0, 0.0], [2.0, 1.0, 0.0], [1.0, 2.0, 0.0]), Some(Flaw::Crossing), "in it");
    assert_eq!(others([-9.0, -9.0, 0.0], [30.0, -9.0, 0.0], [-9.0, 30.0, 0.0]), Some(Flaw::Crossing), "around it");
    assert_eq!(others([1.0, 1.0, 1.0], [2.0, 1.0, 1.0], [1.0, 2.0, 1.0]), None, "parallel");
    assert_eq!(others([3.0, 3.0, 0.0], [5.0, 5.0, 0.0], [5.0, 4.0, 0.0]), None, "in one plane, apart");
    assert_eq!(others([3.0, 3.0, 1.0], [3.0, 3.0, -1.0], [5.0, 5.0, 0.0]), None, "through the plane, beside it");
}

/// Tests that all pairs of triangles of few small points get the flaws that clipping finds.
#[test]
fn pairs_are_as_clipping_has_them() {
    let mut seen = [0; 2];
    for seed in 0..u64::from(predicament_effort::cases(12_000)) {
        let mut random = Random(seed);
        let flat = random.below(2) == 0;
        let points: Vec<[f64; 3]> =
            [(); 6].map(|()| random.point(2)).map(|[x, y, z]| [x, y, if flat { 0.0 } else { z }]).to_vec();
        let second = [[3, 4, 5], [0, 4, 5], [0, 1, 5]][usize::try_from(seed % 3).unwrap()];
        let corners = |triangle: [u32; 3]| triangle.map(|v| points[v as usize]);
        let exact = |triangle: [u32; 3]| corners(triangle).map(|p| p.map(rational));
        let all = [corners(FIRST), corners(second)].concat();
        let is_flat =
            |triangle: [u32; 3]| crate::common::volumes::area(&exact(triangle)).iter().all(|x| x.cmp0().is_eq());
        // Corners at one position must be one vertex; otherwise the case is another one.
        let places: std::collections::BTreeSet<[u64; 3]> = all.iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
        let names: std::collections::BTreeSet<u32> = [FIRST, second].concat().into_iter().collect();
        if is_flat(FIRST) || is_flat(second) || places.len() != names.len() {
            continue;
        }
        let is_right = is_proper(&exact(FIRST), &exact(second));
        assert_eq!(found(&points, second).is_none(), is_right, "{seed}: {points:?} {second:?}");
        seen[usize::from(is_right)] += 1;
    }
    assert!(seen[0] > 20 && seen[1] > 20, "{seen:?}");
}

#[test]
fn flaws_are_counted_by_kind() {
    let points = with(&[[1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [3.0, 3.0, 1.0]]);
    let scene = Scene::from_points3(&points).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    let counted = |triangles: &[[u32; 3]], moved: u32| {
        let triangles: Vec<([u32; 3], u32)> = triangles.iter().copied().zip(0..).collect();
        let turns: Vec<_> = triangles
            .iter()
            .map(|(triangle, _)| triangle.contains(&moved).then_some((Plane::Xy, Sign::Positive)))
            .collect();
        flaws(&session as &dyn Predicates, &triangles, &|v| v == moved, &turns)
    };
    let of = |turned: usize, folded: usize, crossing: usize, vertices: &[u32]| Flaws {
        turned,
        folded,
        crossing,
        vertices: vertices.to_vec(),
    };
    assert_eq!(counted(&[FIRST, [1, 0, 3]], 3), of(1, 1, 0, &[0, 1, 2, 3]), "a fold that has turned");
    assert_eq!(counted(&[FIRST, [0, 1, 3]], 3), of(0, 1, 0, &[0, 1, 2, 3]));
    assert_eq!(counted(&[FIRST, [4, 5, 6]], 6), of(0, 0, 1, &[0, 1, 2, 4, 5, 6]));
    assert_eq!(counted(&[FIRST, [4, 5, 6]], 2), of(0, 0, 1, &[0, 1, 2, 4, 5, 6]), "the other one has moved");
    assert_eq!(counted(&[FIRST, [4, 5, 6]], 3), of(0, 0, 0, &[]), "nothing has moved");
    assert_eq!(counted(&[[0, 2, 1]], 2), of(1, 0, 0, &[0, 1, 2]));
}

/// The union of a sphere and a copy with points an ulp beside its own, in doubles.
fn united(seed: u64) -> Rounded {
    let mut random = Random(seed);
    let mut sphere = Shape::sphere(1e9, 1);
    let scale = 3e9 + random.whole(1 << 20);
    sphere.points.as_flattened_mut().iter_mut().for_each(|x| *x /= scale);
    let mut other = sphere.clone();
    other.points.as_flattened_mut().iter_mut().for_each(|x| {
        *x = [x.next_down(), *x, x.next_up()][usize::try_from(random.below(3)).unwrap()];
    });
    let both = sphere.clone().and(&other);
    let (first, all) = (sphere.points.len(), both.points.len());
    let scene = Scene::from_points3(&both.points).unwrap().with_second_mesh((first..all).map(Vertex::input));
    let meshes = [Arc::new(sphere.mesh(0, all)), Arc::new(other.mesh(first, all))];
    let mut session = PerMesh.prepare(&scene, Off).unwrap();
    let overlay = mesh_overlay(&mut session, meshes, Zeros::Zero).unwrap();
    let perturbed = session.scene().clone();
    let mut exact = Exact.prepare(&perturbed, Off).unwrap();
    let limit = limit(&mut exact, &overlay, overlay.solid(Operation::Union)).unwrap();
    rounded(&Exact, &exact, &limit).unwrap()
}

/// True if a mesh crosses itself, by all pairs in rationals.
fn crosses(rounded: &Rounded) -> bool {
    let mesh = &rounded.closed;
    let corners = |triangle: &[u32; 3]| triangle.map(|v| mesh.points[v as usize].map(rational));
    !improper(&mesh.triangles.iter().map(corners).collect::<Vec<_>>()).is_empty()
}

#[test]
fn flaws_are_left_where_the_mesh_crosses_itself() {
    let mut flawed = 0;
    for seed in 1..=u64::from(predicament_effort::cases(160)) {
        let rounded = united(seed);
        // A triangle that has only turned over crosses nothing.
        assert!(rounded.counts.left > 0 || !crosses(&rounded), "{seed}: {:?}", rounded.counts);
        let Counts { turned, folded, crossing, .. } = rounded.counts;
        flawed += usize::from(turned + folded + crossing > 0);
    }
    assert!(flawed > 0, "nothing has to be mended");
}
