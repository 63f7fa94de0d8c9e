//! Every check of Delaunay triangulations finds what it is for.

use predicament_checks::delaunay::{Found, flaws};
use predicament_checks::hull::Signs;
use predicament_judge::Judged;
use predicament_predicates::{Backend, Off};
use predicament_predicates::{Predicates, Scene, Vertex};
use predicament_sos::Sos;

fn ids<const N: usize>(indices: &[[usize; N]]) -> Vec<[Vertex; N]> {
    indices.iter().map(|list| list.map(Vertex::input)).collect()
}

/// The names of the checks that fail.
fn failing(
    points: &[[f64; 2]],
    triangles: &[[usize; 3]],
    chain: &[usize],
    copies: &[[usize; 2]],
    breaks_ties: bool,
) -> Vec<&'static str> {
    let scene = Scene::from_points2(points).unwrap();
    let exact = Judged::exact(&scene);
    let sos = Sos::default();
    let perturbed = sos.prepare(&scene, Off).unwrap();
    let perturbed = breaks_ties.then_some(&perturbed as &dyn Predicates);
    let signs = Signs { exact: &exact, perturbed, ties: 1000, pairs: 100_000 };
    let (triangles, copies) = (ids(triangles), ids(copies));
    let chain: Vec<Vertex> = chain.iter().map(|&index| Vertex::input(index)).collect();
    let found = Found { triangles: &triangles, chain: &chain, copies: &copies };
    flaws(signs, found).iter().map(|flaw| flaw.check).collect()
}

/// A square with its centre and, on the right, a triangle more.
const POINTS: [[f64; 2]; 6] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 2.0], [9.0, 2.0]];
const RIGHT: [[usize; 3]; 5] = [[0, 1, 4], [1, 2, 4], [1, 5, 2], [2, 3, 4], [0, 4, 3]];

#[test]
fn each_check_of_triangles_finds_what_it_is_for() {
    let of = |triangles: &[[usize; 3]]| failing(&POINTS, triangles, &[], &[], false);
    assert_eq!(of(&RIGHT), [""; 0]);
    let with = |at: usize, triangle: [usize; 3]| {
        let mut triangles = RIGHT;
        triangles[at] = triangle;
        triangles
    };
    assert_eq!(of(&with(0, [0, 1, 6])), ["vertices"]);
    assert_eq!(of(&with(0, [0, 1, 1])), ["vertices"]);
    assert_eq!(of(&RIGHT[..4]), ["convex", "wound once", "area"]);
    assert_eq!(of(&[&RIGHT[..2], &RIGHT[3..]].concat()), ["copies", "area"], "a vertex that is nowhere");
    assert!(of(&with(0, [0, 4, 1])).starts_with(&["positive", "edges"]));
    assert_eq!(of(&[&RIGHT[..], &RIGHT[..1]].concat())[0], "edges");
    // Two triangles that share no edge.
    assert_eq!(failing(&POINTS[..5], &[[0, 1, 4], [2, 3, 4]], &[], &[], false), ["hull", "area"]);
    // The edge from 4 to 5 in place of that from 1 to 2.
    let flipped = [[0, 1, 4], [1, 5, 4], [2, 4, 5], [2, 3, 4], [0, 4, 3]];
    assert_eq!(of(&flipped), ["empty circle"]);
}

#[test]
fn faces_on_a_circle_are_fans_from_the_smallest_index() {
    let square = &POINTS[..4];
    assert_eq!(failing(square, &[[0, 1, 2], [0, 2, 3]], &[], &[], false), [""; 0]);
    assert_eq!(failing(square, &[[0, 1, 3], [1, 2, 3]], &[], &[], false), ["fan"]);
    // One of the two is that of the perturbed scene.
    let perturbed = [[[0, 1, 2], [0, 2, 3]], [[0, 1, 3], [1, 2, 3]]].map(|two| failing(square, &two, &[], &[], true));
    assert!(perturbed.contains(&vec![]) && perturbed.contains(&vec!["empty circle", "empty"]), "{perturbed:?}");
}

#[test]
fn flat_triangles_are_found() {
    let line = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 3.0]];
    assert_eq!(failing(&line, &[[0, 1, 3], [1, 2, 3]], &[], &[], false), [""; 0]);
    assert_eq!(failing(&line, &[[0, 2, 3], [0, 1, 2]], &[], &[], false)[0], "positive");
}

#[test]
fn copies_and_chains_are_held_to_the_points() {
    let points = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [2.0, 0.0]];
    let of = |triangles: &[[usize; 3]], copies: &[[usize; 2]]| failing(&points, triangles, &[], copies, false);
    assert_eq!(of(&[[0, 1, 2]], &[[3, 1]]), [""; 0]);
    for copies in [&[][..], &[[3, 2]], &[[3, 1], [3, 1]], &[[3, 1], [1, 3]]] {
        assert_eq!(of(&[[0, 1, 2]], copies), ["copies"], "{copies:?}");
    }
    assert_eq!(of(&[[0, 3, 2]], &[[1, 3]]), ["copies"], "not the smallest");
    let line = [[0.0, 0.0], [4.0, 2.0], [2.0, 1.0], [6.0, 4.0]];
    let of = |n: usize, chain: &[usize]| failing(&line[..n], &[], chain, &[], false);
    assert_eq!(of(3, &[0, 2, 1]), [""; 0]);
    assert_eq!(of(3, &[0, 1, 2])[0], "chain");
    assert_eq!(of(4, &[0, 2, 1, 3]), ["chain"], "not in one line");
    assert_eq!(of(3, &[0, 1]), ["copies"], "one is missing");
    assert_eq!(failing(&line[..3], &[], &[0, 2, 1], &[], true), ["chain"], "a perturbation leaves no line");
    let beside = failing(&line, &[[0, 3, 2], [1, 2, 3]], &[0], &[], false);
    assert!(beside.contains(&"chain"), "{beside:?}");
}
