//! Every check of Delaunay triangulations finds its fault.

use predicament_delaunay::algorithm::{Contradiction, Delaunay2, constrained_delaunay2d};
use predicament_delaunay::checks::{Cut, Found, flaws};
use predicament_exact::Exact;
use predicament_hull::checks::Signs;
use predicament_judge::Judged;
use predicament_predicates::{Backend, Counts, Off, PredicateKind, Predicates, Scene, Vertex};
use predicament_sos::Sos;
use proptest::prelude::*;

fn ids<const N: usize>(indices: &[[usize; N]]) -> Vec<[Vertex; N]> {
    indices.iter().map(|list| list.map(Vertex::input)).collect()
}

/// The names of the failed checks.
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
    let found = Found { triangles: &triangles, chain: &chain, copies: &copies, constraints: &[], cut: Cut::Fan };
    flaws(signs, found).iter().map(|flaw| flaw.check).collect()
}

/// A square with its centre and another triangle on the right.
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
    // The edge from 4 to 5 replaces the edge from 1 to 2.
    let flipped = [[0, 1, 4], [1, 5, 4], [2, 4, 5], [2, 3, 4], [0, 4, 3]];
    assert_eq!(of(&flipped), ["empty circle"]);
}

#[test]
fn faces_on_a_circle_are_fans_from_the_smallest_index() {
    let square = &POINTS[..4];
    assert_eq!(failing(square, &[[0, 1, 2], [0, 2, 3]], &[], &[], false), [""; 0]);
    assert_eq!(failing(square, &[[0, 1, 3], [1, 2, 3]], &[], &[], false), ["fan"]);
    // One of the two is the triangulation of the perturbed scene.
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

/// The first of several places is described, and all are counted.
#[test]
fn flaws_are_counted_and_the_first_is_told() {
    let points: Vec<[f64; 2]> = [0.0, 5.0, 1.0, 4.0, 2.0, 6.0].map(|x| [x, 0.0]).into();
    let scene = Scene::from_points2(&points).unwrap();
    let exact = Judged::exact(&scene);
    let signs = Signs { exact: &exact, perturbed: None, ties: 1000, pairs: 100_000 };
    let chain: Vec<Vertex> = (0..6).map(Vertex::input).collect();
    let found = Found { triangles: &[], chain: &chain, copies: &[], constraints: &[], cut: Cut::Fan };
    let flaws = flaws(signs, found);
    assert_eq!(flaws.len(), 1);
    // 5 before 1, and 4 before 2.
    assert_eq!((flaws[0].places, &flaws[0].vertices[..]), (2, &chain[1..3]));
}

/// The number of incircle queries for a limit on pairs.
#[test]
fn no_more_pairs_are_looked_at_than_may_be() {
    let scene = Scene::from_points2(&POINTS).unwrap();
    let triangles = ids(&RIGHT);
    let asked = |pairs: usize| {
        let counts = Counts::new();
        let exact = Exact.prepare(&scene, &counts).unwrap();
        let signs = Signs { exact: &exact, perturbed: None, ties: 1000, pairs };
        let found = Found { triangles: &triangles, chain: &[], copies: &[], constraints: &[], cut: Cut::Fan };
        assert_eq!(flaws(signs, found), []);
        (0..Exact.stages().len()).map(|stage| counts.get(PredicateKind::Incircle, stage)).sum::<u64>()
    };
    // Five edges between triangles twice, for circles and for fans; and five triangles with three other vertices each.
    assert_eq!(asked(100_000), 5 + 5 + 5 * 3);
    assert_eq!(asked(30), asked(100_000), "five triangles by six vertices");
    // Then not all ten edges are checked.
    assert_eq!(asked(29), 5 + 5);
    assert_eq!([asked(10), asked(9)].map(|asked| asked > 6), [true, false]);
}

#[test]
fn constraints_are_chains_of_edges() {
    // A square and its centre; one diagonal goes through it.
    let scene = Scene::from_points2(&POINTS[..5]).unwrap();
    let exact = Judged::exact(&scene);
    let signs = Signs { exact: &exact, perturbed: None, ties: 1000, pairs: 100_000 };
    let triangles = ids(&[[0, 1, 4], [1, 2, 4], [2, 3, 4], [0, 4, 3]]);
    let with = |constraints: &[[usize; 2]], triangles: &[[Vertex; 3]]| {
        let constraints = ids(constraints);
        let found = Found { triangles, chain: &[], copies: &[], constraints: &constraints, cut: Cut::Fan };
        flaws(signs, found).iter().map(|flaw| flaw.check).collect::<Vec<_>>()
    };
    assert_eq!(with(&[[0, 2], [4, 1], [3, 0], [2, 2]], &triangles), [""; 0]);
    // Without the centre, the other diagonal is not an edge.
    let scene = Scene::from_points2(&POINTS[..4]).unwrap();
    let exact = Judged::exact(&scene);
    let signs = Signs { exact: &exact, perturbed: None, ties: 1000, pairs: 100_000 };
    let of = |constraints: &[[usize; 2]], triangles: &[[usize; 3]]| {
        let (constraints, triangles) = (ids(constraints), ids(triangles));
        let found = Found { triangles: &triangles, chain: &[], copies: &[], constraints: &constraints, cut: Cut::Fan };
        flaws(signs, found).iter().map(|flaw| flaw.check).collect::<Vec<_>>()
    };
    assert_eq!(of(&[[1, 3]], &[[0, 1, 2], [0, 2, 3]]), ["constraint"]);
    assert_eq!(of(&[[1, 3]], &[[0, 1, 3], [1, 2, 3]]), [""; 0], "the rule does not flip it");
    assert_eq!(of(&[], &[[0, 1, 3], [1, 2, 3]]), ["fan"]);
}

/// The failed checks of the algorithm's answer for these points and constraints; `None` if crossings are refused.
fn laid(points: &[[i64; 2]], constraints: &[[usize; 2]], breaks_ties: bool) -> Option<(Vec<&'static str>, Delaunay2)> {
    #[allow(clippy::cast_precision_loss)] // small integers
    let points: Vec<[f64; 2]> = points.iter().map(|point| point.map(|x| x as f64)).collect();
    let scene = Scene::from_points2(&points).unwrap();
    let constraints = ids(constraints);
    let sos = Sos::default();
    let found = if breaks_ties {
        let mut session = sos.prepare(&scene, Off).unwrap();
        constrained_delaunay2d(&mut session, &constraints).ok()?.answer()
    } else {
        let mut session = Exact.prepare(&scene, Off).unwrap();
        constrained_delaunay2d(&mut session, &constraints).expect("exact constructs").answer()
    };
    let mut whole = scene.clone();
    for &definition in &found.crossings {
        whole.construct(definition).unwrap();
    }
    let exact = Judged::exact(&whole);
    let perturbed = breaks_ties.then(|| sos.prepare(&scene, Off).unwrap());
    let perturbed = perturbed.as_ref().map(|session| session as &dyn Predicates);
    let signs = Signs { exact: &exact, perturbed, ties: 1000, pairs: 100_000 };
    let (triangles, chain, copies) = (&found.triangles, &found.chain, &found.copies);
    let asked = Found { triangles, chain, copies, constraints: &constraints, cut: Cut::Fan };
    let mut failing: Vec<&str> =
        if triangles.is_empty() { Vec::new() } else { flaws(signs, asked).iter().map(|flaw| flaw.check).collect() };
    failing.extend(found.broken.map(Contradiction::rule));
    Some((failing, found))
}

#[test]
fn crossings_are_constructed_and_shared() {
    // Three lines through one point, a fourth beside it.
    let points = [[0, 0], [6, 6], [0, 6], [6, 0], [3, 0], [3, 7], [0, 2], [6, 1]];
    let (failing, found) = laid(&points, &[[0, 1], [2, 3], [4, 5], [6, 7]], false).unwrap();
    assert_eq!(failing, [""; 0]);
    // The centre once, and three on the fourth line.
    assert_eq!(found.crossings.len(), 4, "{found}");
    assert!(laid(&points, &[[0, 1], [2, 3]], true).is_none(), "sos declines circles of crossings");
    // Constraints that pass through points, overlap and repeat; one has no length.
    let line = [[0, 0], [2, 0], [4, 0], [6, 0], [3, 5], [3, -5], [0, 0]];
    let (failing, found) = laid(&line, &[[0, 2], [1, 3], [3, 0], [0, 6], [2, 1], [4, 5]], false).unwrap();
    assert_eq!((failing, found.crossings.len()), (vec![], 1));
    // A constraint that decides between the diagonals.
    let square = [[0, 0], [4, 0], [4, 4], [0, 4]];
    for breaks_ties in [false, true] {
        let (failing, found) = laid(&square, &[[1, 3]], breaks_ties).unwrap();
        assert_eq!(failing, [""; 0]);
        assert_eq!(found.triangles, ids(&[[0, 1, 3], [1, 2, 3]]));
        assert_eq!(found.constrained, ids(&[[1, 3]]));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(2000)))]

    #[test]
    fn random_constraints_are_laid(
        points in (2_i64..12).prop_flat_map(|side| prop::collection::vec([0..=side, 0..=side], 3..25)),
        ends in prop::collection::vec(any::<[prop::sample::Index; 2]>(), 1..8),
        breaks_ties: bool,
    ) {
        let constraints: Vec<[usize; 2]> =
            ends.iter().map(|pair| pair.map(|end| end.index(points.len()))).filter(|[a, b]| a != b).collect();
        let Some((failing, found)) = laid(&points, &constraints, breaks_ties) else { return Ok(()) };
        prop_assert_eq!(failing, Vec::<&str>::new(), "{:?} {:?}", points, constraints);
        let back: Vec<[usize; 2]> = constraints.iter().rev().map(|&[a, b]| [b, a]).collect();
        if let Some((failing, again)) = laid(&points, &back, breaks_ties) {
            prop_assert_eq!(failing, Vec::<&str>::new(), "{:?} {:?}", points, back);
            prop_assert_eq!(again.triangles.len(), found.triangles.len());
            if found.crossings.is_empty() {
                prop_assert_eq!(again, found, "the order of constraints does not matter");
            }
        }
    }
}
